"""A gateway that runs the compiled gateware, cycle by cycle.

The other ports of a whole design can be read, driven and watched (`ports`).

The gateware counts only cycles of its clock, and its answer to `Q` has the clock's frequency. A machine simulates about
two million cycles in a second, so a served gateway has a much slower clock than a board. If no periodic group is
running and no bytes are pending, cycles have no effect and are skipped: the gateware's clock is advanced by whole base
ticks. While a group runs, each cycle is computed: `next_due` requests `advance` every `SLICE` seconds, and the cycles
follow the time `now`. A slow machine skips the time that it cannot compute in one call (`MOST_LATE`). The gateware's
time, and its timestamps, then lag behind, but the delay does not accumulate.
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
"""Largest time in seconds by which one call advances the gateware, while groups are running."""
MOST_AHEAD = 0.005
"""Largest time in seconds by which answering requests at once may put the gateware ahead, while groups are running."""
_MOST_TO_QUIET = 50_000_000
"""Largest number of clock cycles in one call until the gateware is idle."""
MOST_WHILE_TICKING = 256
"""Number of clock cycles for an answer at once while groups are running; the rest of the answer follows with time."""
_UNLIMITED = ctypes.c_size_t(-1).value
_BEHIND_MEMORY, _BEHIND_DEVICE = 0, 3
_ANSWERS = {ErrorCode.BUS_ERROR: 1, ErrorCode.BUS_TIMEOUT: 2}
_TRIGGER_CYCLES = 8
_NO_PORT = -1


class Passage(NamedTuple):
    """Bytes that passed the pins of a gateway in some clock cycles."""

    cycles: int
    taken: int
    """Number of offered bytes that the gateway has received."""
    sent: bytes
    flush: bool
    """True if the cycles ended with a flush, which asks the medium to send all bytes at once."""


class RtlMemory(MutableMapping[int, int]):
    """Words of the gateware's memory by address; initially 0. Iteration skips words that are 0."""

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
    """Compiled gateware with plain memory at all addresses.

    Args:
        configuration: a build of the gateware, or the name of one in `configurations()`.

    Raises:
        ArgumentError: if there is no such build.
        ConnectError: if no C++ compiler is installed.
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
        """Time at which the first word of the last sample was read."""
        # Keep references to the functions: the library stores only their addresses.
        self._device_function = DeviceFunction(_device_of(weakref.ref(self)))
        self._library.ul_set_device(self._handle, self._device_function, None)
        self._event_function = EventFunction(_event_of(weakref.ref(self)))
        self._library.ul_set_event(self._handle, self._event_function, None)
        self._watchers: list[Callable[[], object]] = []
        self._on_alarm: Callable[[], object] = _do_nothing
        self.info = self._ask_for_info(b"" if build.node is None else b"Z%02X" % build.node)
        self._devices = Devices(self.info.address_bits)
        # In cycles, rounded down.
        self._base_tick = max(1, self.info.clock_hz * 1000 // self.info.base_frequency_millihertz)
        self._memory = RtlMemory(self._library, self._handle, self.info)
        self._pace = ClockPace(build.name, self.info.clock_hz, is_free=build.design is not None)

    @property
    def memory(self) -> MutableMapping[int, int]:
        """Words of the gateway's memory, by address."""
        return self._memory

    def reset(self) -> None:
        """Restore the state after power-up; memory and devices keep theirs."""
        self._library.ul_reset(self._handle)
        self._origin = None

    # The bus

    def attach(self, device: Device, addresses: Iterable[int]) -> None:
        """Attach a device to addresses; the first address has offset 0.

        Raises:
            ArgumentError: if an address does not fit or has a device, or the object is not a device.
        """
        for address in self._devices.attach(device, addresses):
            self._library.ul_set_behind(self._handle, address, _BEHIND_DEVICE)

    def attach_elsewhere(self, device: Device) -> None:
        """Attach a device to all addresses without one, in place of memory; its offsets are the addresses.

        Raises:
            ArgumentError: if the object is not a device.
        """
        self._devices = DevicesEverywhere(self._devices, device, self.info.address_bits)
        self._library.ul_set_only_device(self._handle)

    def detach(self, addresses: Iterable[int]) -> None:
        """Detach the devices from addresses."""
        for address in addresses:
            self._devices.pop(address, None)
            self._library.ul_set_behind(self._handle, address, _BEHIND_MEMORY)

    # Time

    @property
    def cycles(self) -> int:
        """Number of clock cycles since the last reset."""
        return int(self._library.ul_cycles(self._handle))

    @property
    def time(self) -> float:
        """The gateware's time in seconds on the caller's clock; 0 before the first call with a time."""
        return self._time() if self._origin is not None else 0.0

    @property
    def flushes(self) -> int:
        """Number of flushes since the last reset."""
        return int(self._library.ul_flushes(self._handle))

    @property
    def waiting(self) -> int:
        """Number of bytes that wait for room in the receive FIFO."""
        return int(self._library.ul_waiting(self._handle))

    @property
    def leaves_time_out(self) -> bool:
        """True: a late gateway skips time, so that its clock lags behind, and loses no samples."""
        return True

    @property
    def next_due(self) -> float | None:
        """Time at which `advance` should be called next; None while time has no effect."""
        if self._origin is None:
            return None
        if self._library.ul_available(self._handle):
            return self._time()
        return self._time() + SLICE if self.ticking or self._is_held_up else None

    def receive(self, data: bytes, now: float) -> bytes:
        """Process bytes received at the time `now` in seconds, and return the bytes sent until the gateway is idle.

        While the gateway is `ticking` it is never idle: the result then has the bytes sent in a few cycles, and further
        bytes follow with time.
        """
        self._pass_time(now)
        self._library.ul_push(self._handle, data, len(data))
        ahead = round((self._time() - now) * self.info.clock_hz)
        self._run_until_quiet(min(MOST_WHILE_TICKING, max(0, round(MOST_AHEAD * self.info.clock_hz) - ahead)))
        return self._pull()

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Advance to the time `now` in seconds, and return the bytes to send, at most `room`."""
        self._library.ul_set_room(self._handle, _UNLIMITED if room is None else room)
        self._pass_time(now)
        if self._is_held_up:
            self._run_until_quiet()
        self._library.ul_set_room(self._handle, _UNLIMITED)
        return self._pull()

    def overflow(self) -> None:
        """Lose bytes before the next received byte: the gateway answers their frame with error 09."""
        self._library.ul_lose(self._handle)

    def trigger(self, now: float, group: int | None = None) -> None:
        """Apply a rising edge to the external trigger of a group, or of all; the next call returns the samples."""
        self._pass_time(now)
        self._library.ul_choose_trigger(self._handle, -1 if group is None else group)
        for level in (1, 0):
            self._library.ul_set_trigger(self._handle, level)
            self._run(_TRIGGER_CYCLES)
        self._run_until_quiet()
        self.wake()

    def ticks_at(self, now: float) -> int:
        """Return the number of clock cycles from the gateway's reset to the time of an access in seconds."""
        return self.cycles + (0 if self._origin is None else round((now - self._time()) * self.info.clock_hz))

    # The ports of a whole design

    @functools.cached_property
    def ports(self) -> Mapping[str, Port]:
        """Ports of a whole design, except clock, reset, medium and triggers, by name; empty for a gateway alone."""
        ports = (
            Port(self, self._library, self._handle, index) for index in range(self._library.ul_ports(self._handle))
        )
        return {port.name: port for port in ports}

    def watch(self, function: Callable[[], object], first: Port, second: Port | None = None) -> None:
        """Call a function in each clock cycle in which the lowest bit of a port, or of both ports, is '1'.

        The function sees the outputs of that cycle; inputs that it sets take effect in the next cycle.
        """
        self._watchers.append(function)
        self._library.ul_watch(self._handle, first.index, _NO_PORT if second is None else second.index)

    def call_before(self, cycle: int, function: Callable[[], object]) -> None:
        """Call a function before a clock cycle, or before the next computed cycle if that cycle is skipped.

        Inputs that the function sets take effect in this cycle. The call does not cause a cycle to be computed. Only
        the last scheduled call is made.
        """
        self._on_alarm = function
        self._library.ul_set_alarm(self._handle, cycle)

    def pulse(self, group: int) -> None:
        """Apply a rising edge to the external trigger of a group in the next computed clock cycle."""
        self._library.ul_pulse(self._handle, group, _TRIGGER_CYCLES)

    def keep_awake(self, *, on: bool) -> None:
        """Compute each clock cycle even if no bytes are pending, because hardware moves by itself; False ends that."""
        self._library.ul_never_rests(self._handle, on)

    # At the pins

    @property
    def ticking(self) -> bool:
        """True if each clock cycle matters even if no bytes are pending, for example because a periodic group runs."""
        return bool(self._library.ul_ticking(self._handle))

    def set_pace(self, bytes_per_second: float) -> None:
        """Set the rate of the medium for both directions from now on."""
        self._library.ul_set_pace(self._handle, self.info.clock_hz / bytes_per_second)

    def pass_pins(self, offered: bytes, cycles: int, room: int) -> Passage:
        """Run clock cycles while a FIFO at the pins offers bytes and has room for bytes.

        The run ends early after a flush, and when no bytes move any more unless the gateway is `ticking`.

        Args:
            offered: bytes for the gateway; offer the bytes that it has not received again.
            cycles: largest number of cycles.
            room: number of bytes that the FIFO accepts.
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
        """Run a number of clock cycles, and return the bytes to send."""
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
        """True if bytes wait for room in either direction."""
        return self.waiting > 0 or bool(self._library.ul_stalled(self._handle))

    def _time(self) -> float:
        """Return the gateware's time in seconds on the caller's clock."""
        assert self._origin is not None
        return self._origin + self.cycles / self.info.clock_hz

    def _pass_time(self, now: float) -> None:
        """Run cycles up to the time `now`, or skip cycles without effect."""
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
        """Pass an access to a device; return the word that was read, or 0 for a write."""
        now = self._instant()
        if word is None:
            return self._devices.read(address, now) & (1 << self.info.data_bits) - 1
        self._devices.write(address, word, now)
        return 0

    def _instant(self) -> float:
        """Return the time of an access; all words of a sample have the time of its first word."""
        now = self.time
        word_of_sample = int(self._library.ul_sample_word(self._handle))
        if word_of_sample < 0:
            return now
        if word_of_sample & 0xFF == 0:
            self._sampled_at = now
        return self._sampled_at

    def _raise_fault(self) -> None:
        """Raise an exception that a callback raised in the library, because exceptions cannot pass through the C++."""
        fault, self._fault = self._fault, None
        if fault is not None:
            raise fault

    def _answer_event(self, watch: int) -> None:
        try:
            if watch < 0:
                self._on_alarm()
            else:
                self._watchers[watch]()
        except BaseException as fault:  # noqa: BLE001  (raised again by `_raise_fault`)
            self._fault = fault

    def _answer_access(self, address: int, write: int, word: ctypes._Pointer[ctypes.c_uint64]) -> int:
        try:
            read = self._access(address, int(word[0]) if write else None)
        except AccessError as refusal:
            return _ANSWERS[refusal.code]
        except BaseException as fault:  # noqa: BLE001  (raised again by `_raise_fault`)
            self._fault = fault
            return _ANSWERS[ErrorCode.BUS_ERROR]
        if not write:
            word[0] = ctypes.c_uint64(read)
        return 0


def _device_of(
    gateway: weakref.ref[RtlGateway],
) -> Callable[[int | None, int, int, ctypes._Pointer[ctypes.c_uint64]], int]:
    """Return the library's callback for accesses; it has a weak reference to the gateway, which refers to it."""

    def answer(_context: int | None, address: int, write: int, word: ctypes._Pointer[ctypes.c_uint64]) -> int:
        behind = gateway()
        return _ANSWERS[ErrorCode.BUS_TIMEOUT] if behind is None else behind._answer_access(address, write, word)  # noqa: SLF001

    return answer


def _event_of(gateway: weakref.ref[RtlGateway]) -> Callable[[int | None, int], None]:
    """Return the library's callback for events, with a weak reference to the gateway as in `_device_of`."""

    def answer(_context: int | None, watch: int) -> None:
        behind = gateway()
        if behind is not None:
            behind._answer_event(watch)  # noqa: SLF001

    return answer


def _do_nothing() -> None:
    """Do nothing; the default of `wake`."""
