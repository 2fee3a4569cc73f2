"""One gateway that is the gateware: bytes and the time go in, bytes come out, clock cycles pass in between.

A whole design around a gateway has further ports, which are looked at, driven and watched here (`ports`).

Time. The gateware knows only cycles of its clock, and its `Q` says truthfully how many there are in a second. A machine
simulates about two million of them in a second, so a served gateway is clocked far slower than a board. Cycles in which
nothing can happen, because no periodic group is running and no byte is under way, are skipped: the gateware's clock is
set forward, by whole base ticks. While one runs, each cycle counts: `next_due` asks for `advance` every `SLICE`
seconds, and cycles keep pace with the `now` that it is given. What a slow machine can't make up for in one call
(`MOST_LATE`) is left out: the gateware's time then falls behind, as its timestamps show, but nothing piles up.
"""

from __future__ import annotations

import ctypes
import functools
import time
import weakref
from collections.abc import Iterable, Iterator, Mapping, MutableMapping
from typing import TYPE_CHECKING, NamedTuple

from unity_link.errors import ArgumentError, ConnectError
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual.bus import AccessError, Device, Devices, DevicesEverywhere
from unity_link.virtual.gateway import BareGateway
from unity_link.virtual.rtl.configurations import Configuration, find
from unity_link.virtual.rtl.library import DeviceFunction, EventFunction, load
from unity_link.virtual.rtl.pace import ClockPace
from unity_link.virtual.rtl.ports import Port

if TYPE_CHECKING:
    from collections.abc import Callable

SLICE = 0.001
"""Seconds between two calls of `advance` while groups may be running."""
MOST_LATE = 10 * SLICE
"""Seconds of the gateware's clock that pass in one call at most, while groups are running."""
MOST_AHEAD = 0.005
"""Seconds by which answers to requests that come at once put the gateware's clock ahead at most, while groups run."""
_MOST_TO_QUIET = 50_000_000
MOST_WHILE_TICKING = 256
"""Clock cycles in which it answers at once while groups run: it never rests then, and the rest comes with time."""
_UNLIMITED = ctypes.c_size_t(-1).value
_BEHIND_MEMORY, _BEHIND_DEVICE = 0, 3
_ANSWERS = {ErrorCode.BUS_ERROR: 1, ErrorCode.BUS_TIMEOUT: 2}
_TRIGGER_CYCLES = 8
_NO_PORT = -1


class Passage(NamedTuple):
    """Bytes that passed the pins of a gateway in some clock cycles."""

    cycles: int
    taken: int
    """Bytes of those offered."""
    sent: bytes
    flush: bool
    """True if the gateway asked its medium, at the end, to send at once what it has."""


class RtlMemory(MutableMapping[int, int]):
    """Words behind the gateware by address; what was never written is 0, and 0 counts as not written."""

    def __init__(self, library: ctypes.CDLL, handle: int, info: GatewayInfo) -> None:
        self._library, self._handle = library, handle
        self._address_bits, self._data_bits = info.address_bits, info.data_bits

    def __getitem__(self, address: int) -> int:
        self._check(address)
        return int(self._library.ul_read_memory(self._handle, address))

    def __setitem__(self, address: int, word: int) -> None:
        self._check(address)
        if not 0 <= word < 1 << self._data_bits:
            raise ArgumentError(f"word {word:#x} does not fit in {self._data_bits} bits")
        self._library.ul_write_memory(self._handle, address, word)

    def __delitem__(self, address: int) -> None:
        self[address] = 0

    def __iter__(self) -> Iterator[int]:
        count = len(self)
        used = (ctypes.c_uint64 * count)()
        self._library.ul_used_memory(self._handle, used, count)
        return iter(list(used))

    def __len__(self) -> int:
        return int(self._library.ul_used_memory(self._handle, None, 0))

    def _check(self, address: int) -> None:
        if not 0 <= address < 1 << self._address_bits:
            raise ArgumentError(f"address {address:#x} does not fit in {self._address_bits} bits")


class RtlGateway(BareGateway):
    """The gateware with plain memory at every address.

    Args:
        configuration: which build of it; or its name, one of `configurations()`.

    Raises:
        ArgumentError: for a configuration that there is not.
        ConnectError: where no C++ compiler is installed.
    """

    def __init__(self, configuration: str | Configuration = "default") -> None:
        build = find(configuration) if isinstance(configuration, str) else configuration
        self._library = load(build)
        self._handle = int(self._library.ul_create())
        self._free = weakref.finalize(self, self._library.ul_destroy, self._handle)
        self.wake: Callable[[], None] = _do_nothing
        self._origin: float | None = None
        self._fault: BaseException | None = None
        self._sampled_at = 0.0
        """Instant at which the first word of the last sample was read."""
        # The library keeps the address alone: the function must live as long as the gateway.
        self._device_function = DeviceFunction(_device_of(weakref.ref(self)))
        self._library.ul_set_device(self._handle, self._device_function, None)
        self._event_function = EventFunction(_event_of(weakref.ref(self)))
        self._library.ul_set_event(self._handle, self._event_function, None)
        self._watchers: list[Callable[[], object]] = []
        self._on_alarm: Callable[[], object] = _do_nothing
        self.info = self._ask_for_info(b"" if build.node is None else b"Z%02X" % build.node)
        self._devices = Devices(self.info.address_bits)
        # In cycles; those of a fraction don't come in whole ones.
        self._base_tick = max(1, self.info.clock_hz * 1000 // self.info.base_frequency_millihertz)
        self._memory = RtlMemory(self._library, self._handle, self.info)
        self._pace = ClockPace(build.name, self.info.clock_hz, is_free=build.design is not None)

    @property
    def memory(self) -> MutableMapping[int, int]:
        """The words behind the gateway, by address."""
        return self._memory

    def reset(self) -> None:
        """Go back to the state after power-up. What is behind the bus stays as it is."""
        self._library.ul_reset(self._handle)
        self._origin = None

    # What is behind the bus

    def attach(self, device: Device, addresses: Iterable[int]) -> None:
        """Put a device behind addresses; the first is its offset 0.

        Raises:
            ArgumentError: for an address that does not fit or has a device, or an object that is no device.
        """
        for address in self._devices.attach(device, addresses):
            self._library.ul_set_behind(self._handle, address, _BEHIND_DEVICE)

    def attach_elsewhere(self, device: Device) -> None:
        """Put a device behind every address that has none, in place of memory; its offsets are the addresses.

        Raises:
            ArgumentError: for an object that is no device.
        """
        self._devices = DevicesEverywhere(self._devices, device, self.info.address_bits)
        self._library.ul_set_only_device(self._handle)

    def detach(self, addresses: Iterable[int]) -> None:
        """Take the devices of addresses away again."""
        for address in addresses:
            self._devices.pop(address, None)
            self._library.ul_set_behind(self._handle, address, _BEHIND_MEMORY)

    # Time

    @property
    def cycles(self) -> int:
        """Clock cycles since the last reset."""
        return int(self._library.ul_cycles(self._handle))

    @property
    def time(self) -> float:
        """The gateware's time, in seconds of the caller's clock; 0 while that was never told."""
        return self._time() if self._origin is not None else 0.0

    @property
    def flushes(self) -> int:
        """Number of times the gateware asked its medium to send at once, since the last reset."""
        return int(self._library.ul_flushes(self._handle))

    @property
    def waiting(self) -> int:
        """Bytes that wait for room in the receive FIFO."""
        return int(self._library.ul_waiting(self._handle))

    @property
    def leaves_time_out(self) -> bool:
        """Return whether it leaves out what it is too late for: its clock falls behind then, and no sample is lost."""
        return True

    @property
    def next_due(self) -> float | None:
        """Instant at which `advance` should be called next; None while time makes no difference."""
        if self._origin is None:
            return None
        if self._library.ul_available(self._handle):
            return self._time()
        return self._time() + SLICE if self.ticking or self._is_held_up else None

    def receive(self, data: bytes, now: float) -> bytes:
        """Take bytes at the time `now` (seconds), and return what is sent until the gateway has nothing left to do.

        While it is `ticking` it always has: then that is what it sends in a few cycles, and the rest comes with time.
        """
        self._pass_time(now)
        self._library.ul_push(self._handle, data, len(data))
        ahead = round((self._time() - now) * self.info.clock_hz)
        self._run_until_quiet(min(MOST_WHILE_TICKING, max(0, round(MOST_AHEAD * self.info.clock_hz) - ahead)))
        return self._pull()

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Let time pass up to `now` (seconds), and return what was sent, as far as there is `room`."""
        self._library.ul_set_room(self._handle, _UNLIMITED if room is None else room)
        self._pass_time(now)
        if self._is_held_up:
            self._run_until_quiet()
        self._library.ul_set_room(self._handle, _UNLIMITED)
        return self._pull()

    def overflow(self) -> None:
        """Lose bytes before the next one received: the frame that they belong to is answered by error 09."""
        self._library.ul_lose(self._handle)

    def trigger(self, now: float, group: int | None = None) -> None:
        """Apply a rising edge to the external trigger of a group, or of all; the publish comes out of the next call."""
        self._pass_time(now)
        self._library.ul_choose_trigger(self._handle, -1 if group is None else group)
        for level in (1, 0):
            self._library.ul_set_trigger(self._handle, level)
            self._run(_TRIGGER_CYCLES)
        self._run_until_quiet()
        self.wake()

    def ticks_at(self, now: float) -> int:
        """Return the cycles of the gateway's clock since its reset, at an instant of an access (seconds)."""
        return self.cycles + (0 if self._origin is None else round((now - self._time()) * self.info.clock_hz))

    # The ports of a whole design

    @functools.cached_property
    def ports(self) -> Mapping[str, Port]:
        """Ports of a whole design but for clock, reset, medium and triggers, by name; none of a gateway alone."""
        ports = (
            Port(self, self._library, self._handle, index) for index in range(self._library.ul_ports(self._handle))
        )
        return {port.name: port for port in ports}

    def watch(self, function: Callable[[], object], first: Port, second: Port | None = None) -> None:
        """Call a function in each clock cycle in which the lowest bits of a port, or of two, are '1'.

        It sees all outputs of that cycle; inputs that it sets are seen by the next one.
        """
        self._watchers.append(function)
        self._library.ul_watch(self._handle, first.index, _NO_PORT if second is None else second.index)

    def call_before(self, cycle: int, function: Callable[[], object]) -> None:
        """Call a function before a clock cycle that is worked out, or the first one behind it; the last call counts.

        It sees the inputs that the function sets. Such a call alone is no reason to work out a cycle.
        """
        self._on_alarm = function
        self._library.ul_set_alarm(self._handle, cycle)

    def pulse(self, group: int) -> None:
        """Apply a rising edge to the external trigger of a group in the next clock cycle that is worked out."""
        self._library.ul_pulse(self._handle, group, _TRIGGER_CYCLES)

    def keep_awake(self, *, on: bool) -> None:
        """Make each clock cycle count although no byte is under way, as something moves by itself, or end that."""
        self._library.ul_never_rests(self._handle, on)

    # At the pins

    @property
    def ticking(self) -> bool:
        """Return whether something happens with time although no byte is under way, as periodic groups are running."""
        return bool(self._library.ul_ticking(self._handle))

    def set_pace(self, bytes_per_second: float) -> None:
        """Set the pace of bytes at the medium, in both directions, from now on."""
        self._library.ul_set_pace(self._handle, self.info.clock_hz / bytes_per_second)

    def pass_pins(self, offered: bytes, cycles: int, room: int) -> Passage:
        """Let cycles pass while a medium offers bytes and has room for some: what a FIFO at the pins sees.

        It ends early behind a flush, and when nothing moves any more; not that, though, while `ticking`.

        Args:
            offered: what the medium has for the gateway; what is not taken is to be offered again.
            cycles: at most so many pass.
            room: bytes that the medium takes.
        """
        library, handle = self._library, self._handle
        library.ul_push(handle, offered, len(offered))
        library.ul_set_room(handle, room)
        flushes = self.flushes
        passed = int(library.ul_run_at_pins(handle, cycles, not self.ticking))
        taken = len(offered) - self.waiting
        library.ul_take_back(handle)
        library.ul_set_room(handle, _UNLIMITED)
        self._raise_fault()
        return Passage(passed, taken, self._pull(), self.flushes != flushes)

    def run(self, cycles: int) -> bytes:
        """Let exactly so many clock cycles pass, and return what was sent."""
        self._run(cycles)
        return self._pull()

    # The inside

    def _ask_for_info(self, prefix: bytes) -> GatewayInfo:
        beginning = prefix + b"Q"
        question = beginning + b"\r"
        self._library.ul_push(self._handle, question, len(question))
        self._run_until_quiet()
        answer = self._pull()
        self.reset()
        if not answer.startswith(beginning):
            raise ConnectError(f"the gateware answered {answer!r} to Q: it was not built as it should be")
        return GatewayInfo.from_hex(answer[len(beginning) : -2])

    @property
    def _is_held_up(self) -> bool:
        """Return whether bytes wait for room, on their way in or out."""
        return self.waiting > 0 or bool(self._library.ul_stalled(self._handle))

    def _time(self) -> float:
        """The gateway's time in the caller's seconds."""
        assert self._origin is not None
        return self._origin + self.cycles / self.info.clock_hz

    def _pass_time(self, now: float) -> None:
        """Let cycles pass up to `now`, or skip those in which nothing can happen."""
        if self._origin is None:
            self._origin = now - self.cycles / self.info.clock_hz
        missing = max(0, round((now - self._time()) * self.info.clock_hz))
        if self.ticking or self._is_held_up:
            most = round(MOST_LATE * self.info.clock_hz)
            began, left_out = time.perf_counter(), max(0, missing - most) / self.info.clock_hz
            self._run(min(missing, most))
            self._origin += left_out
            self._pace.add(now, min(missing, most), time.perf_counter() - began, left_out)
        else:
            self._library.ul_skip(self._handle, missing - missing % self._base_tick)

    def _run(self, cycles: int) -> None:
        self._library.ul_run(self._handle, cycles)
        self._raise_fault()

    def _run_until_quiet(self, most_while_ticking: int = MOST_WHILE_TICKING) -> None:
        self._library.ul_run_until_quiet(self._handle, _MOST_TO_QUIET, most_while_ticking)
        self._raise_fault()

    def _pull(self) -> bytes:
        size = int(self._library.ul_available(self._handle))
        if not size:
            return b""
        buffer = ctypes.create_string_buffer(size)
        self._library.ul_pull(self._handle, buffer, size)
        return buffer.raw

    def _access(self, address: int, word: int | None) -> int:
        """Let a device answer one access; return the word read."""
        now = self._instant()
        if word is None:
            return self._devices.read(address, now) & (1 << self.info.data_bits) - 1
        self._devices.write(address, word, now)
        return 0

    def _instant(self) -> float:
        """Return the time of an access; all words of a sample are of the instant of its first."""
        now = self.time
        word_of_sample = int(self._library.ul_sample_word(self._handle))
        if word_of_sample < 0:
            return now
        if word_of_sample & 0xFF == 0:
            self._sampled_at = now
        return self._sampled_at

    def _raise_fault(self) -> None:
        """Raise what a device raised while cycles passed: no exception gets through the C++ in between."""
        fault, self._fault = self._fault, None
        if fault is not None:
            raise fault

    def _answer_event(self, watch: int) -> None:
        try:
            if watch < 0:
                self._on_alarm()
            else:
                self._watchers[watch]()
        except BaseException as fault:  # noqa: BLE001  (kept, and raised where the call came from)
            self._fault = fault

    def _answer_access(self, address: int, write: int, word: ctypes._Pointer[ctypes.c_uint64]) -> int:
        try:
            read = self._access(address, int(word[0]) if write else None)
        except AccessError as refusal:
            return _ANSWERS[refusal.code]
        except BaseException as fault:  # noqa: BLE001  (kept, and raised where the call came from)
            self._fault = fault
            return _ANSWERS[ErrorCode.BUS_ERROR]
        if not write:
            word[0] = ctypes.c_uint64(read)
        return 0


def _device_of(
    gateway: weakref.ref[RtlGateway],
) -> Callable[[int | None, int, int, ctypes._Pointer[ctypes.c_uint64]], int]:
    """Return the function that the library calls; it holds the gateway weakly, which holds it."""

    def answer(_context: int | None, address: int, write: int, word: ctypes._Pointer[ctypes.c_uint64]) -> int:
        behind = gateway()
        return _ANSWERS[ErrorCode.BUS_TIMEOUT] if behind is None else behind._answer_access(address, write, word)  # noqa: SLF001

    return answer


def _event_of(gateway: weakref.ref[RtlGateway]) -> Callable[[int | None, int], None]:
    """Return the function that the library calls in an event; it holds the gateway weakly, as `_device_of`."""

    def answer(_context: int | None, watch: int) -> None:
        behind = gateway()
        if behind is not None:
            behind._answer_event(watch)  # noqa: SLF001

    return answer


def _do_nothing() -> None:
    """Stand in for `wake` where no clock drives the gateway."""
