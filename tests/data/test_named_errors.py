"""Errors of the gateway name the signals of the robot, and the cause in a model that has failed."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from unity_link import ArgumentError, BusError
from unity_link.data import Group
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine
    from pathlib import Path

SPEC = compile_text("""
wheel(): @(base) {
  @duty = base: READWRITE();
  @on = base + 1[0]: bool READWRITE();
  @fast = base + 1[1]: bool READWRITE();
  @queue = base + 2: READWRITE(FIFO);
}
public rover() { left: wheel() @(0x10); right: wheel() @(0x20); }
""")
Rover = unity_link.load(SPEC)


async def posted(robot: Any) -> None:
    await robot.left.duty.post(1)
    await robot.link.fence()


REFUSED: dict[str, tuple[Callable[[Any], Coroutine[Any, Any, Any]], str]] = {
    "get": (lambda robot: robot.left.duty.get(), "read of left.duty at 0x10"),
    "set": (lambda robot: robot.left.duty.set(1), "write of left.duty at 0x10"),
    "field": (lambda robot: robot.left.on.set(True), "masked write of left.on and left.fast at 0x11"),
    "take": (lambda robot: robot.left.queue.take(3), "queue read of left.queue at 0x12"),
    "append": (lambda robot: robot.left.queue.append([1, 2]), "queue write of left.queue at 0x12"),
    "group": (lambda robot: Group(robot.right.duty, robot.left.duty).get(), "read of left.duty at 0x10"),
    "group set": (lambda robot: Group(robot.left.duty).set([1]), "write of left.duty at 0x10"),
    "raw": (lambda robot: robot.link.read(0x10), "read of left.duty at 0x10"),
    "posted": (posted, "posted write of left.duty at 0x10"),
    "no signal": (lambda robot: robot.link.read(0x13), "read at 0x13"),
}


@pytest.mark.parametrize("way", REFUSED)
def test_the_error_for_a_refused_access_has_the_path_of_its_signal(way: str) -> None:
    gateway = VirtualGateway()
    gateway.attach(Failing(ErrorCode.BUS_ERROR), range(0x10, 0x14))
    use, what = REFUSED[way]

    async def run() -> None:
        async with unity_link.connect(gateway) as link:
            with pytest.raises(BusError) as refused:
                await use(Rover(link))
        assert str(refused.value) == f"{what}: the bus refused the access"

    asyncio.run(run())


def test_an_error_after_the_failure_of_a_model_reports_it(tmp_path: Path) -> None:
    spec, model = tmp_path / "rover.ul", tmp_path / "bad.py"
    spec.write_text("public rover() { @duty = 0x10: READWRITE(); }\n")
    model.write_text(
        "from unity_link.virtual.simulated import SimulatedRobot\n"
        "class Bad(SimulatedRobot):\n"
        "    def step(self, dt):\n"
        "        raise ValueError('beyond 8.73 rad/s')\n"
    )

    async def run() -> str:
        async with unity_link.connect(f"sim:{spec}?model={model}:Bad") as link:
            await asyncio.sleep(0.001)
            with pytest.raises(BusError) as refused:
                await unity_link.load(spec)(link).duty.set(1)
        return str(refused.value)

    text = asyncio.run(run())
    assert text.startswith("write of duty at 0x10: the bus refused the access, for the model Bad failed ")
    assert text.endswith(" s after its start: ValueError: beyond 8.73 rad/s")


MISTAKES: dict[str, tuple[Callable[[Any], Any], type[Exception], str]] = {
    "group": (lambda robot: robot.groups.state, AttributeError, r"`groups` has no 'state': write groups\['state'\]"),
    "part": (lambda robot: robot.j1.get, AttributeError, "j1 has no 'get': a signal such as j1.cpos has it"),
    "index": (lambda robot: [0][robot.j1.cpos], ArgumentError, "j1.cpos is a signal and no value"),
    "for": (lambda robot: list(robot.j1.cpos), ArgumentError, "write `async for`"),
    "next": (
        lambda robot: robot.groups["state"].subscribe().next,
        AttributeError,
        r"no 'next': `await anext\(samples\)`",
    ),
    "next of a link": (
        lambda robot: robot.link.subscribe([1], rate_hz=10).next,
        AttributeError,
        r"no 'next': `await anext\(samples\)`",
    ),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_the_error_for_a_common_mistake_shows_the_code(mistake: str) -> None:
    use, kind, text = MISTAKES[mistake]

    async def run() -> None:
        async with unity_link.connect("sim:scara") as link:
            robot = unity_link.load("examples/scara.ul")(link)
            with pytest.raises(kind, match=text):
                use(robot)

    asyncio.run(run())


def test_the_error_for_a_signal_missing_in_a_sample_has_its_path() -> None:
    async def run() -> None:
        async with unity_link.connect("sim:scara") as link:
            robot = unity_link.load("examples/scara.ul")(link)
            async with robot.groups["state"].subscribe() as samples:
                sample: Any = await anext(samples)
            with pytest.raises(AttributeError, match=r"a sample has no 'j1': write sample\['j1.cpos'\]"):
                _ = sample.j1

    asyncio.run(run())
