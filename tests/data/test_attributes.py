"""Unknown attribute names: a read suggests the nearest name; an assignment raises and has no effect."""

from __future__ import annotations

import asyncio
import sys
from types import ModuleType
from typing import Any

import pytest

import unity_link
from unity_link import ArgumentError, blocking
from unity_link.data.blocking import put
from unity_link.generate import generate
from unity_link.modules import Module
from unity_link.spec import compile_text

SPEC = compile_text("""
group state(1, 10);
joint(): @(base) { @pos = base: READWRITE(PUBLISH(state)); @speed = base + 1: READ(PUBLISH(state)); }
public rover() {
  left: joint() @(0x10);
  wheels[2]: joint() @(0x20 + 2 * i);
  pool: MEMORY(BASE=0x40, SIZE=2);
  @port = 0x50: READWRITE();
}
""")


def test_creating_a_robot_does_not_search_for_similar_names(monkeypatch: pytest.MonkeyPatch) -> None:
    """A suggestion takes as long as creating a hundred signals."""

    def fail(*_: object, **__: object) -> None:
        raise AssertionError

    monkeypatch.setattr("difflib.get_close_matches", fail)
    with blocking.connect("sim:") as link:
        assert len(put(unity_link.load(SPEC), link).signals) == 7


FACES = ("loaded", "generated", "blocking")
NEAR = {
    "robot": ("lfet", "'left'"),
    "robot.left": ("psition", None),
    "robot.left.pos": ("valeu", "'value'"),
    "robot.wheels[1].speed": ("vlaue", "'value'"),
    "robot.groups['state']": ("subscirbe", "'subscribe'"),
    "robot.pool": ("lod", "'load'"),
    "link": ("raed_block", "'read_block'"),
    "batch": ("lsot", "'lost'"),
    "batch.table": ("untis", "'units'"),
    "sample": ("vlaues", "'values'"),
    "sample.values": ("itmes", "'items'"),
    "samples": ("receivd", "'received'"),
    "plain": ("sequenc", "'sequence'"),
    "plain_samples": ("recieved", "'received'"),
    "link.statistics": ("round_tirp", "'round_trip'"),
}
"""Objects with a wrong attribute name, and the expected suggestion."""
KNOWN = {
    "robot": "signals",
    "robot.left": "speed",
    "robot.left.pos": "unit",
    "robot.wheels[0].pos": "set",
    "robot.groups['state']": "name",
    "robot.pool": "load",
    "batch": "proxies",
    "batch.table": "units",
    "sample": "lost",
    "samples": "take",
}
"""Objects with an attribute name that they have and that programs must not assign."""
OPEN = {"link", "plain_samples", "plain", "sample.values", "link.statistics"}
"""Python itself refuses these without a suggestion; classes on the path of every request have no check at all."""


def generated_class() -> Any:
    module = ModuleType("generated_rover")
    sys.modules[module.__name__] = module
    (file,) = generate("python", SPEC)
    exec(file.text, vars(module))
    return module.Rover


def names_on(face: str) -> dict[str, Any]:
    if face == "blocking":
        with blocking.connect("sim:") as link:
            robot = put(unity_link.load(SPEC), link)
            with robot.groups["state"].subscribe() as samples:
                batch = samples.take(2)
            with link.subscribe(0x10, rate_hz=1000) as plain_samples:
                (plain,) = plain_samples.take(1)
        return {**locals(), "sample": next(iter(batch))}

    async def take() -> dict[str, Any]:
        robot_type = unity_link.load(SPEC) if face == "loaded" else generated_class()
        async with unity_link.connect("sim:") as link:
            robot = robot_type(link)
            async with robot.groups["state"].subscribe() as samples:
                batch = await samples.take(2)
            async with link.subscribe(0x10, rate_hz=1000) as plain_samples:
                (plain,) = await plain_samples.take(1)
            return {**locals(), "sample": next(iter(batch))}

    return asyncio.run(take())


@pytest.fixture(scope="module", params=FACES)
def names(request: pytest.FixtureRequest) -> dict[str, Any]:
    return names_on(request.param)


@pytest.mark.parametrize("thing", NEAR)
def test_the_error_for_an_unknown_name_suggests_the_nearest(names: dict[str, Any], thing: str) -> None:
    name, near = NEAR[thing]
    found = eval(thing, names)

    with pytest.raises(AttributeError) as error:
        getattr(found, name)

    assert f" {name!r}" in str(error.value)
    assert near is None or f"did you mean {near}" in str(error.value)
    assert "object has no" not in str(error.value)
    assert not hasattr(found, name)


@pytest.mark.parametrize("thing", sorted(NEAR.keys() - OPEN))
def test_an_assignment_to_an_unknown_name_is_refused_in_the_same_way(names: dict[str, Any], thing: str) -> None:
    name, near = NEAR[thing]
    found = eval(thing, names)

    with pytest.raises(ArgumentError) as error:
        setattr(found, name, 1)

    assert f"has no {name!r}" in str(error.value)
    assert near is None or near in str(error.value)
    assert not hasattr(found, name)


@pytest.mark.parametrize("thing", sorted(OPEN - {"link", "plain_samples"}))
def test_an_assignment_that_python_refuses_has_no_effect(names: dict[str, Any], thing: str) -> None:
    found = eval(thing, names)
    with pytest.raises(AttributeError):
        setattr(found, NEAR[thing][0], 1)


@pytest.mark.parametrize("thing", KNOWN)
def test_an_existing_attribute_cannot_be_replaced(names: dict[str, Any], thing: str) -> None:
    found = eval(thing, names)
    before = getattr(found, KNOWN[thing])

    with pytest.raises(ArgumentError, match="cannot be assigned to"):
        setattr(found, KNOWN[thing], 1)

    assert callable(before) or getattr(found, KNOWN[thing]) == before


def test_an_assignment_of_a_value_is_refused_with_the_call_of_set(names: dict[str, Any]) -> None:
    robot = names["robot"]
    with pytest.raises(ArgumentError, match=r"^left\.pos is not assigned to: (await )?left\.pos\.set\(5\) writes it$"):
        robot.left.pos = 5
    with pytest.raises(
        ArgumentError, match=r"left\.pos\.value is the value seen last: .*left\.pos\.set\(5\)` writes it"
    ):
        robot.left.pos.value = 5


def test_a_subclass_of_module_may_set_its_own_attributes() -> None:
    class Lift(Module):
        speed = 1

        def __init__(self, *arguments: Any) -> None:
            super().__init__(*arguments)
            self.goal = 0
            self._height = 0

        @property
        def height(self) -> int:
            return self._height

        @height.setter
        def height(self, height: int) -> None:
            self.goal = self._height = height

    async def use() -> None:
        async with unity_link.connect("sim:") as link:
            lift = Lift(link, 0x10)
            lift.height = 3
            assert (lift.goal, lift.height) == (3, 3)
            lift.goal = 4
            with pytest.raises(ArgumentError, match=r"^Lift at 0x10 has no 'gaol': did you mean 'goal'\?$"):
                lift.gaol = 5  # type: ignore[attr-defined]

    asyncio.run(use())


def test_a_subclass_of_robot_may_set_its_declared_attributes() -> None:
    class Rover(unity_link.load(SPEC)):  # type: ignore[misc]
        goal: float
        limit = 3

    async def use() -> None:
        async with unity_link.connect("sim:") as link:
            rover = Rover(link)
            rover.goal, rover.limit, rover._own = 1.5, 4, 5
            assert (rover.goal, rover.limit, rover._own) == (1.5, 4, 5)

    asyncio.run(use())
