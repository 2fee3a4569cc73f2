"""Quick models and the compiled gateware have equal registers after equal motions of encoders and pins."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any, ClassVar

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import unity_link
from support.searching import examples
from support.simulated_time import run_simulated
from unity_link.errors import GatewayResetError
from unity_link.spec import compile_file
from unity_link.virtual.build import simulate
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from unity_link.virtual.simulated import Part

pytestmark = [pytest.mark.rtl, pytest.mark.slow]

TURN = 6
SPEC = f"""\
public robot() {{
  whole: ENCODER(COUNTS={TURN}, SCALE=1, UNIT="", FILTER=1) @(0x00);
  backwards: ENCODER(COUNTS={TURN}, SCALE=-0.5, UNIT="", FILTER=1) @(0x04);
  no_index: ENCODER(COUNTS={TURN}, SCALE=1, UNIT="", FILTER=1) @(0x08, z=none);
  only_a: ENCODER(COUNTS={TURN}, SCALE=1, UNIT="", FILTER=1) @(0x0C, b=none);
  only_b: ENCODER(COUNTS={TURN}, SCALE=1, UNIT="", FILTER=1) @(0x10, a=none);
  index_alone: ENCODER(COUNTS={TURN}, SCALE=1, UNIT="", FILTER=1) @(0x14, a=none, b=none);
  edges: ENCODER(COUNTS={TURN}, SCALE=1, UNIT="", FILTER=1, COUNTER=true) @(0x18);
  upwards: ENCODER(COUNTS={TURN}, SCALE=1, UNIT="", FILTER=1, COUNTER=true) @(0x1C, b=none);
  no_edges: ENCODER(COUNTS={TURN}, SCALE=1, UNIT="", FILTER=1, COUNTER=true) @(0x20, a=none);
  button: GPIO() @(0x30);
  deaf: GPIO() @(0x32, pin=none);
}}
"""
COUNTERS = ("edges", "upwards", "no_edges")
ENCODERS = ("whole", "backwards", "no_index", "only_a", "only_b", "index_alone", *COUNTERS)
REGISTERS = ("position", "index_position", "index_count", "errors")
LEVELS = ((0, 0), (1, 0), (1, 1), (0, 1))
SPACE = 8
"""Cycles from one count to the next."""


class Turning(SimulatedRobot):
    """Turns as a test requests."""

    step_seconds: ClassVar[float | None] = None

    def step(self, dt: float) -> None:
        """Do nothing: the test moves the robot."""


class Both:
    """The quick and the compiled robot of a spec, which move together."""

    def __init__(self, path: Any) -> None:
        self.robot_class = unity_link.load(compile_file(path))
        self.compiled = simulate(path, rtl=True)
        self.quick = simulate(path, Turning)
        self.count = self.pressed = 0

    def begin(self) -> None:
        """Reset both robots, with all pins low."""
        self.turn(-self.count)
        self.press(self.pressed % 2)
        for gateway in (self.compiled, self.quick):
            gateway.reset()
        self.quick.robot.pass_time(0.0)

    def turn(self, counts: int) -> None:
        """Turn all encoders; the compiled robot gets each count at its pins."""
        bare: Any = self.compiled._gateway
        way = 1 if counts > 0 else -1
        for _ in range(abs(counts)):
            old, self.count = self.count, self.count + way
            cycle = bare.cycles + SPACE
            for name in ENCODERS:
                if name in COUNTERS:
                    levels = [("b", int(way < 0), cycle - SPACE // 2), ("a", 0, cycle - SPACE // 2), ("a", 1, cycle)]
                else:
                    before, after = LEVELS[old % 4], LEVELS[self.count % 4]
                    levels = [(pin, after[place], cycle) for place, pin in enumerate("ab") if before != after]
                for pin, level, at in (*levels, ("z", int(self.count % TURN == 0), cycle)):
                    if (port := self.compiled.ports.get(f"{name}_{pin}")) is not None:
                        port.drive(level, at)
            bare.run(SPACE)
        bare.run(SPACE)
        for name in ENCODERS:
            part: Part = getattr(self.quick.robot, name)
            part.position = self.count * (-0.5 if name == "backwards" else 1)

    def press(self, times: int) -> None:
        """Press and release a button."""
        bare: Any = self.compiled._gateway
        button: Any = self.quick.robot
        for _ in range(times):
            self.pressed += 1
            self.compiled.ports["button_pin_in"].drive(self.pressed % 2)
            bare.run(4)
            button.button.pin = self.pressed % 2

    async def registers(self, compiled: bool) -> dict[str, Any]:
        """Read the registers of one of the robots."""
        async with unity_link.connect(self.compiled if compiled else self.quick) as link:
            robot: Any = self.robot_class(link)
            await asyncio.sleep(0.01)
            paths = [f"{name}.{register}" for name in ENCODERS for register in REGISTERS]
            paths += [f"{name}.{register}" for name in ("button", "deaf") for register in ("level", "edges")]
            group = unity_link.data.Group(*(robot[path] for path in paths))
            try:
                values = await group.get()
            except GatewayResetError:
                values = await group.get()
            return {path: values[path] for path in paths}

    def check(self) -> None:
        """Assert that the registers of both robots are equal."""
        quick, compiled = (run_simulated(self.registers(compiled)) for compiled in (False, True))
        assert quick == compiled


@pytest.fixture(scope="module")
def both(tmp_path_factory: pytest.TempPathFactory) -> Both:
    path = tmp_path_factory.mktemp("robot") / "robot.ul"
    path.write_text(SPEC)
    return Both(path)


@settings(max_examples=examples(15), deadline=None)
@given(legs=st.lists(st.one_of(st.integers(-20, 20), st.sampled_from([TURN, -TURN, 1, -1])), max_size=6))
def test_counts_and_indexes_are_those_of_the_existing_pins(both: Both, legs: list[int]) -> None:
    both.begin()
    for counts in legs:
        both.turn(counts)
        both.check()


def test_counts_of_edges_and_indexes_wrap_at_16_bits(both: Both) -> None:
    both.begin()
    bare: Any = both.compiled._gateway
    number, space = (1 << 16) + 3, 4
    # The robot begins at the index, so clear the index pin.
    both.compiled.ports["index_alone_z"].drive(0)
    bare.run(SPACE)
    for place in range(number):
        at = bare.cycles + space * (place + 1)
        both.compiled.ports["button_pin_in"].drive((place + 1) % 2, at)
        both.compiled.ports["index_alone_z"].drive(1, at)
        both.compiled.ports["index_alone_z"].drive(0, at + space // 2)
    bare.run(space * (number + 2))
    quick: Any = both.quick.robot
    for place in range(number):
        quick.button.pin = (place + 1) % 2
    quick.index_alone.position = TURN * number
    both.pressed += number
    both.check()
    assert quick.button.edges == quick.index_alone.index_count == 3
