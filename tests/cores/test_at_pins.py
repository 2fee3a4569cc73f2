"""Pin sides of cores: values that a plant sets become edges, and values that it reads are measured at the pins."""

from __future__ import annotations

import itertools
import textwrap
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.cores.encoder import EncoderAtPins
from unity_link.cores.pwm import PwmAtPins
from unity_link.errors import ArgumentError
from unity_link.spec import compile_file, compile_text
from unity_link.virtual.rtl.wiring import OfCore
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link.spec import Interface

CLOCK = 320_000
STEP = CLOCK // 1000


class Board(dict[str, int]):
    """Pins of one core, with their present levels and their scheduled ones."""

    def __init__(self, *pins: str) -> None:
        super().__init__(dict.fromkeys(pins, 0))
        self.to_come: list[tuple[int, str, int]] = []
        self.duties: dict[str, float | None] = {}
        self.pulses = 0

    def has(self, name: str) -> bool:
        return name in self

    def drive(self, name: str, level: int, cycle: int) -> None:
        self.to_come.append((cycle, name, level))

    def duty(self, name: str) -> float | None:
        return self.duties[name]

    def steps(self, pulse: str, direction: str) -> int:
        assert (pulse, direction) == ("step", "dir")
        return self.pulses

    def pass_cycle(self, cycle: int) -> int:
        """Apply the levels of a cycle; return the number of pins that have changed."""
        due = [one for one in self.to_come if one[0] <= cycle]
        self.to_come = [one for one in self.to_come if one[0] > cycle]
        before = dict(self)
        for _, name, level in due:
            self[name] = level
        return sum(self[name] != before[name] for name in self)


class Turning(SimulatedRobot):
    def step(self, dt: float) -> None:
        """Do nothing: the test moves the robot."""


def joined(interface: Interface, path: str, board: Board) -> tuple[Any, Any]:
    """Return a robot with one core at the pins of a board, and the pin side of that core."""
    robot = Turning(interface)
    robot.prepare()
    robot.cores.take_clock(CLOCK, lambda now: round(now * CLOCK))
    robot.wire_pins({path: board})
    side = robot.cores.at_pins[path]
    for signal in next(part for part in interface.cores if part.path == path).signals:
        robot.cells[signal.path].wire = OfCore(side)
    return robot, side


def encoder(arguments: str, board: Board, scale: str = "1") -> tuple[Any, Any]:
    text = f'public robot() {{ wheel: ENCODER(SCALE={scale}, UNIT="", {arguments}) @(0x20); }}'
    return joined(compile_text(text).interface(), "wheel", board)


def run_step(robot: Any, number: int) -> None:
    robot.cores.step((number + 1) * STEP / CLOCK)
    robot.cores.step((number + 1) * STEP / CLOCK)


LEVELS = [(0, 0), (1, 0), (1, 1), (0, 1)]


@pytest.mark.slow
@given(moves=st.lists(st.integers(-35, 35), min_size=1, max_size=12), samples=st.sampled_from([1, 3, 15]))
def test_a_position_becomes_single_edges_that_pass_the_filter(moves: list[int], samples: int) -> None:
    board = Board("a", "b")
    robot, _ = encoder(f"FILTER={samples}", board)
    assert isinstance(robot.cores.at_pins["wheel"], EncoderAtPins)
    seen = state = position = 0
    # The position does not change after the last move.
    for number, move in enumerate([0, *moves, 0, 0]):
        robot.cores.step((number + 1) * STEP / CLOCK)
        position += move
        robot.wheel.position = position
        robot.cores.step((number + 1) * STEP / CLOCK)
        for cycle in range((number + 1) * STEP, (number + 2) * STEP):
            assert board.pass_cycle(cycle) <= 1
            new = LEVELS.index((board["a"], board["b"]))
            seen += (new - state + 1) % 4 - 1
            state = new
    assert seen == position
    assert robot.wheel.position == position


@pytest.mark.slow
@given(speed=st.floats(0.1, 30), samples=st.sampled_from([1, 15]))
def test_edges_of_an_even_motion_are_evenly_spaced(speed: float, samples: int) -> None:
    board = Board("a", "b")
    robot, _ = encoder(f"FILTER={samples}", board, scale="0.5")
    for number in range(60):
        robot.cores.step((number + 1) * STEP / CLOCK)
        robot.wheel.position = speed * number / 2
        robot.cores.step((number + 1) * STEP / CLOCK)
    edges = sorted(cycle for cycle, _, _ in board.to_come)
    assert len(edges) == pytest.approx(speed * 59, abs=1)
    spacings = [second - first for first, second in itertools.pairwise(edges)]
    assert all(spacing == pytest.approx(STEP / speed, abs=1.01) for spacing in spacings)


def test_a_jump_of_a_position_is_followed_at_full_speed_and_logged(caplog: pytest.LogCaptureFixture) -> None:
    board = Board("a", "b", "z")
    robot, _ = encoder("FILTER=15, COUNTS=100", board)
    run_step(robot, 0)
    run_step(robot, 1)
    robot.wheel.position = 1000
    for number in range(2, 60):
        run_step(robot, number)
    edges = sorted(cycle for cycle, pin, _ in board.to_come if pin != "z")
    assert len(edges) == 1000
    assert min(second - first for first, second in itertools.pairwise(edges)) >= 15
    rises = [cycle for cycle, pin, level in board.to_come if (pin, level) == ("z", 1)]
    assert rises == edges[99::100]
    assert caplog.text.count("wheel turns faster than its pins can") == 1


def test_a_counter_counts_rising_edges_down_while_b_is_high() -> None:
    board = Board("a", "b")
    robot, _ = encoder("FILTER=1, COUNTER=true", board)
    count, position = 0, 0
    for number, move in enumerate([0, 20, -35, 3, 0, 0]):
        robot.cores.step((number + 1) * STEP / CLOCK)
        position += move
        robot.wheel.position = position
        robot.cores.step((number + 1) * STEP / CLOCK)
        for cycle in range((number + 1) * STEP, (number + 2) * STEP):
            before = board["a"]
            board.pass_cycle(cycle)
            if board["a"] and not before:
                count += -1 if board["b"] else 1
    assert count == position == -12


def test_a_reset_continues_from_the_present_levels_of_the_pins() -> None:
    board = Board("a", "b")
    robot, side = encoder("FILTER=1", board)
    run_step(robot, 0)
    robot.wheel.position = 7
    run_step(robot, 1)
    board.pass_cycle(10**6)
    robot.wheel.position = 11
    run_step(robot, 2)
    # The edges that are not yet due are lost.
    board.to_come.clear()
    robot.cores.reset()
    robot.wheel.position = 12
    run_step(robot, 3)
    assert [(pin, level) for _, pin, level in sorted(board.to_come)] == [("b", 0)]
    assert side.takes == {"position"}


@pytest.mark.parametrize(
    ("mode", "pulse", "other", "volts"),
    [("sign", 0.25, 0.0, 3), ("sign", 0.25, 1.0, -3), ("up_down", 0, 0.5, -6), ("offset", 0.75, 0.25, 6)],
)
def test_a_plant_reads_the_voltage_at_the_pins_of_a_pwm(mode: str, pulse: float, other: float, volts: float) -> None:
    board = Board("pwm", "dir")
    text = f'public robot() {{ left: PWM(MODE="{mode}", LIMIT=12, UNIT="V") @(0x10); }}'
    robot, side = joined(compile_text(text).interface(), "left", board)
    assert isinstance(side, PwmAtPins)
    board.duties = {"pwm": None, "dir": None}
    run_step(robot, 0)
    assert robot.left.value == 0
    board.duties = {"pwm": pulse, "dir": other}
    run_step(robot, 1)
    assert robot.left.value == pytest.approx(volts, abs=0.01)
    with pytest.raises(ArgumentError, match=r"left.value is a register of a core, .* has value, or takes sim:"):
        robot.left.value = 3


@pytest.mark.parametrize("reverse", [False, True])
def test_a_plant_reads_the_steps_that_a_step_generator_has_sent(reverse: bool) -> None:
    board = Board("step", "dir")
    text = f"public robot() {{ x: STEPGEN(STEPS=40, REVERSE={str(reverse).lower()}) @(0x10); }}"
    robot, _ = joined(compile_text(text).interface(), "x", board)
    for pulses, position in ((0, 0.0), (100, 2.5), (-3, -0.075), ((1 << 23) + 1, (1 - (1 << 23)) / 40)):
        board.pulses = -pulses if reverse else pulses
        run_step(robot, 0)
        assert robot.x.position == pytest.approx(position)
    with pytest.raises(ArgumentError, match=r"x\.velocity is a register of a core, .* has position, or takes sim:"):
        _ = robot.x.velocity


def test_a_plant_cannot_access_registers_of_a_core_at_pins() -> None:
    robot, _ = encoder("FILTER=1", Board("a"))
    for name in ("position", "velocity"):
        with pytest.raises(ArgumentError, match=f"wheel.{name} is a register of a core"):
            getattr(robot.wheel, name)
    robot, _ = joined(compile_text("public robot() { x: STEPGEN() @(0x10); }").interface(), "x", Board("step"))
    with pytest.raises(ArgumentError, match=r"x\.position is a register of a core"):
        _ = robot.x.position


def test_a_core_of_a_user_has_a_pin_side(tmp_path: Path) -> None:
    folder = tmp_path / "cores" / "blink"
    folder.mkdir(parents=True)
    (folder / "blink.ul").write_text(
        'BLINK(): @(BASE) { ENTITY("blink"); @flashes = BASE: READ(); '
        "@bright = BASE + 1: bool READ(); @light: PIN(OUT); }"
    )
    (folder / "blink.vhd").write_text("-- Not looked at.\n")
    (folder / "blink.py").write_text(
        textwrap.dedent("""\
        from unity_link.cores import AtPins

        class BlinkAtPins(AtPins):
            shows = frozenset({"bright"})

            def step(self, dt):
                self.around.show("bright", bool(self.part.light))
        """)
    )
    spec = tmp_path / "lamps.ul"
    spec.write_text("public lamps() { left: BLINK() @(0x10); }")
    board = Board("light")
    robot, _ = joined(compile_file(spec).interface(), "left", board)
    seen = []
    for level in (0, 1):
        board["light"] = level
        run_step(robot, level)
        seen.append(robot.left.bright)
    assert seen == [False, True]
    with pytest.raises(ArgumentError, match=r"left\.flashes is a register"):
        _ = robot.left.flashes
