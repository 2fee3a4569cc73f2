"""The compiled register bank and the registers of `sim:` behave alike for a program, and for a robot model.

Two robots of one spec, one in each, get the same requests and the same actions of a model, in any order. Each answer
must be the same, byte for byte, and both models must read the same values.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import pytest
from hypothesis import HealthCheck, Phase, example, given, settings
from hypothesis import strategies as st

from support.searching import examples
from support.spec_examples import specs
from unity_link.spec import Signal, compile_text
from unity_link.spec.printer import print_file
from unity_link.virtual.build import simulated
from unity_link.virtual.rtl.spec_gateway import SpecGateway
from unity_link.virtual.rtl.specs import configuration_of, made
from unity_link.virtual.simulated import SimulatedRobot
from unity_link.virtual.simulating import SimulatedGateway, make_robot

if TYPE_CHECKING:
    from unity_link.protocol.wire.configuration import GatewayInfo
    from unity_link.spec import Interface, ModuleSpec
    from unity_link.spec.syntax import File
    from unity_link.virtual.registers import Cell
    from unity_link.virtual.rtl.configurations import Configuration

pytestmark = [pytest.mark.rtl, pytest.mark.slow]

SPEC = """
/// Something of everything that a register bank has.
public everything() {
  GATEWAY(ADDRESS_BITS=12, DATA_BITS=16);
  @wide = 0x00: signed 40 READWRITE(SCALE=0.5);
  @silent = 0x04: unsigned 33 WRITE();
  @counter = 0x08: unsigned 48 READ();
  @mode = 0x10[1:0]: mode READWRITE();
  @level = 0x10[9:4]: unsigned 6 WRITE();
  @top = 0x10[15]: bool READWRITE();
  @flag = 0x11[0]: bool READ();
  @state = 0x11[9:2]: mode READ();
  @number = 0x13: float 16 READWRITE();
  @class = 0x14: READWRITE();
  @fixed = 0x15: fixed 4.8 READ();
  @both = 0x16: READWRITE(FIFO(3));
  @events = 0x17: unsigned 8 READ(FIFO(2));
  @orders = 0x18: unsigned 9 WRITE(FIFO(2));
  @seen = 0x19[7:0]: READ(EFFECT=CLEAR_ON_READ);
  @alarms[2] = 0x1A[i]: bool READWRITE(EFFECT=WRITE_1_TO_CLEAR, RESET=true);
  @fire = 0x1A[8]: bool WRITE(EFFECT=PULSE);
  @gain = 0x1B[3:0]: READWRITE();
  @tick = 0x1B[4]: bool READWRITE(EFFECT=PULSE);
  joints[2]: joint() @(0x20 + 4 * i);
  ram: MEMORY(BASE=0x100, SIZE=16);
  tube: FIFO(BASE=0x200, WORDS=2);
}
joint(): @(base) {
  @position = base: signed 24 READ();
  @target = base + 2: signed 12 READWRITE();
}
enum mode { off, slow, fast }
"""


class Listening(SimulatedRobot):
    """Records the written values."""

    def start(self) -> None:
        self.told: list[tuple[str, Any]] = []

    def written(self, path: str, value: Any) -> None:
        cell = self.cells[path]
        self.told.append((path, value if cell.queue is not None else cell.signal.kind.encode(cell.written)))


class Both(NamedTuple):
    """A robot in each kind of registers."""

    interface: Interface
    sim: SimulatedGateway
    rtl: SimulatedGateway

    def ask(self, now: float, *requests: str) -> bytes:
        """Send plain frames to both; return the last answer."""
        answer = b""
        for request in requests:
            frame = f"{request}\r".encode()
            answer, other = (gateway.receive(frame, now) for gateway in (self.sim, self.rtl))
            assert answer == other, request
            assert answer or request.startswith("WS")
        return answer

    def act(self, path: str, what: str, raw: int) -> None:
        """Apply an action on a signal to both models."""
        results: list[Any] = []
        for gateway in (self.sim, self.rtl):
            cell = gateway.robot.cells[path]
            value = cell.signal.kind.decode(raw)
            if cell.queue is None:
                cell.set(value)
                results.append(None)
            else:
                results.append(cell.queue.put(value) if what == "put" else cell.queue.take())
        assert results[0] == results[1], path

    def compare(self) -> None:
        """Compare the values that both models read."""
        seen = [
            {path: _seen(cell) for path, cell in gateway.robot.cells.items()} | {"": list(gateway.robot.told)}
            for gateway in (self.sim, self.rtl)
        ]
        assert seen[0] == seen[1]


def _seen(cell: Cell) -> Any:
    if cell.signal.has_events:
        # The model sets events, and the register stores them.
        return None
    if cell.queue is None:
        return cell.raw
    return list(cell.queue.to_program), list(cell.queue.from_program)


def both_of(interface: Interface, build: Configuration) -> Both:
    compiled = SimulatedGateway(SpecGateway(build, interface), make_robot(interface, Listening))
    return Both(interface, simulated(interface, Listening), compiled)


def raws(signal: Signal) -> st.SearchStrategy[int]:
    """Return the raw words of hardware: for an enumeration named values, for a float numbers that are not NaN."""
    kind = signal.kind
    if kind.enumeration is not None:
        return st.sampled_from([value.value for value in kind.enumeration.values])
    numbers = st.integers(0, (1 << kind.width) - 1)
    return numbers.filter(lambda raw: kind.decode(raw) == kind.decode(raw)) if kind.is_float else numbers


class Story:
    """Draws sequences of events for a robot."""

    def __init__(self, interface: Interface, info: GatewayInfo) -> None:
        self._data_bits = info.data_bits
        self._address, self._word = info.address_digits, info.data_digits
        self._last = (1 << info.address_bits) - 1
        self._subjects: list[Signal | ModuleSpec] = [*interface.signals.values(), *interface.modules]
        moving = {address for one in interface.signals.values() if one.access_moves for address in one.addresses}
        self._moving = moving | {module.base for module in interface.modules if module.type == "FIFO"}

    @property
    def all_steps(self) -> st.SearchStrategy[list[tuple[Any, ...]]]:
        """Return sequences about few signals each, so that events are related."""
        some = st.lists(st.sampled_from(self._subjects), min_size=1, max_size=2)
        return some.flatmap(lambda subjects: st.lists(self._steps(subjects), max_size=30))

    def _steps(self, subjects: list[Signal | ModuleSpec]) -> st.SearchStrategy[tuple[Any, ...]]:
        """Return the possible next events."""
        words = st.integers(0, (1 << self._data_bits) - 1)
        signals = [one for one in subjects if isinstance(one, Signal)]
        within = {address for one in signals for address in one.addresses}
        within |= {one.base for one in subjects if not isinstance(one, Signal)}
        near = {address + step for address in within for step in (-1, 1)}
        places = st.one_of(
            st.sampled_from(sorted(within)),
            st.sampled_from(sorted(address for address in near if 0 <= address <= self._last)),
        )
        given = [one for one in signals if one.is_given or one.fifo]
        reads = st.one_of(
            st.tuples(st.just("R"), places),
            st.tuples(st.just("RM"), places, st.integers(1, 6)),
            st.tuples(st.just("RQ"), places, st.integers(1, 4)),
            st.tuples(st.just("GP"), st.lists(places, min_size=1, max_size=8)),
        )
        writes = st.one_of(
            st.tuples(st.just("W"), places, words),
            st.tuples(st.just("WM"), places, st.lists(words, min_size=1, max_size=4)),
            st.tuples(st.just("WQ"), places, st.lists(words, min_size=1, max_size=4)),
            st.tuples(st.just("WK"), places, words, words),
            st.tuples(st.just("WS"), places, words),
        )
        acts = [st.tuples(st.sampled_from(["put", "take"]), st.just(signal), raws(signal)) for signal in given]
        return st.one_of(reads, writes, *([st.one_of(acts)] if acts else []))

    def tell(self, both: Both, now: float, what: str, *rest: Any) -> bool:
        """Apply a step to both; return true if both must be equal afterwards.

        Words after the one at which a block or a sample failed may have been read or not (docs/protocol.md, "Bus").
        """
        if what in ("put", "take"):
            signal, raw = rest
            both.act(signal.path, what, raw)
            return True
        if what == "GP":
            listed = "".join(self._at(address) for address in rest[0])
            failed = b"@" not in both.ask(now, f"GS03000001{len(rest[0]):02X}{listed}", "GP03")
            return not (failed and self._moving & set(rest[0][1:]))
        address, *values = rest
        text = self._at(address)
        for value in values:
            if what in ("RM", "RQ"):
                text += f"{value:02X}"
            else:
                text += "".join(f"{word:0{self._word}X}" for word in (value if isinstance(value, list) else [value]))
        if what in ("WM", "WQ"):
            text = f"{self._at(address)}{len(values[0]):02X}{text[self._address :]}"
        failed = both.ask(now, what + text).startswith(b"X")
        return not (failed and what == "RM" and self._moving & set(range(address + 1, address + values[0])))

    def _at(self, address: int) -> str:
        return f"{address:0{self._address}X}"


class Meeting:
    """Robots of a spec in both kinds of registers, which process the same sequences of events."""

    def __init__(self, interface: Interface) -> None:
        self._interface = interface
        self._build = made(configuration_of(interface, {}, None))
        self.story = Story(interface, self._build.info)

    def tell(self, steps: list[tuple[Any, ...]]) -> None:
        """Compare both after each step, as long as they must be equal."""
        both = both_of(self._interface, self._build)
        for number, step in enumerate(steps, 1):
            if not self.story.tell(both, number / 1000, *step):
                return
            both.compare()


def test_a_bank_with_all_features_equals_the_simulated_registers() -> None:
    interface = compile_text(SPEC).interface()
    meeting, counter, events = Meeting(interface), interface.signals["counter"], interface.signals["events"]

    @settings(max_examples=examples(200), deadline=None, suppress_health_check=list(HealthCheck))
    @given(steps=meeting.story.all_steps)
    # A value of several words, read in two transactions, each at its own instant.
    @example(steps=[("put", counter, 0x111122223333), ("R", 8), ("put", counter, 0x444455556666), ("RM", 9, 2)])
    # A queue after the word at which a block or a sample fails.
    @example(steps=[("put", events, 0), ("RM", 22, 2)])
    @example(steps=[("put", events, 0), ("GP", [22, 23])])
    def tell(steps: list[tuple[Any, ...]]) -> None:
        meeting.tell(steps)

    tell()


@pytest.mark.campaign
@settings(max_examples=10, deadline=None, phases=[Phase.generate], suppress_health_check=list(HealthCheck))
@given(file=specs(), data=st.data())
def test_the_bank_of_any_spec_equals_the_simulated_registers(file: File, data: st.DataObject) -> None:
    meeting = Meeting(compile_text(print_file(file)).interface())
    for _ in range(50):
        meeting.tell(data.draw(meeting.story.all_steps))
