"""Values from other threads: each is written once and in order, whatever other values there are."""

from __future__ import annotations

import asyncio
import logging
import math
import threading
from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.noting_gateway import SPEC, noting_gateway
from unity_link.bridges.commands import SignalCommands
from unity_link.data import load

if TYPE_CHECKING:
    from collections.abc import AsyncIterator
    from pathlib import Path


@pytest.fixture(scope="module")
def robot_type(tmp_path_factory: pytest.TempPathFactory) -> Any:
    spec = tmp_path_factory.mktemp("spec") / "plain.ul"
    spec.write_text(SPEC)
    return load(spec)


@pytest.fixture
def notes(tmp_path: Path) -> Path:
    return tmp_path / "notes"


def noted(notes: Path) -> list[int]:
    return [int(line) for line in notes.read_text().split()]


@asynccontextmanager
async def commanding(robot_type: Any, notes: Path, told: list[str]) -> AsyncIterator[tuple[Any, SignalCommands]]:
    """Run commands until the end of the block; assert that they end in order."""
    async with unity_link.connect(noting_gateway(str(notes))) as link:
        commands = SignalCommands(link, lambda text, **_: told.append(text))
        running = asyncio.create_task(commands.run())
        # Let the task begin: a task that is cancelled before does nothing at all.
        await asyncio.sleep(0)
        yield robot_type(link), commands
        running.cancel()
        with pytest.raises(asyncio.CancelledError):
            await running


def test_values_of_several_threads_are_written_once_and_in_the_order_of_each(robot_type: Any, notes: Path) -> None:
    told: list[str] = []

    async def write() -> int:
        async with commanding(robot_type, notes, told) as (robot, commands):

            def talk(first: int) -> None:
                for number in range(5000):
                    commands.give((robot.target, first + number))

            await asyncio.gather(*(asyncio.to_thread(talk, 10_000 * thread) for thread in range(4)))
        return commands.written

    written = asyncio.run(write())

    values = noted(notes)
    assert written == len(values) == 20_000
    for thread in range(4):
        own = [value for value in values if value // 10_000 == thread]
        assert own == list(range(10_000 * thread, 10_000 * thread + 5000))
    assert told == []


def test_values_given_before_the_end_are_written_and_later_ones_not(robot_type: Any, notes: Path) -> None:
    async def write() -> None:
        async with commanding(robot_type, notes, []) as (robot, commands):
            giving = threading.Thread(target=lambda: commands.give(*[(robot.target, value) for value in range(10_000)]))
            giving.start()
            giving.join()
        await asyncio.to_thread(commands.give, (robot.target, 77_777))

    asyncio.run(write())

    assert noted(notes) == list(range(10_000))


def test_bad_value_spoils_no_other_and_each_kind_of_fault_is_reported_once(robot_type: Any, notes: Path) -> None:
    told: list[str] = []

    async def write() -> int:
        async with commanding(robot_type, notes, told) as (robot, commands):
            given: list[tuple[Any, float]] = []
            for value in range(100):
                given += [(robot.target, value), (robot.target, 1_000_001 + value), (robot.target, -value - 1)]
                given += [(robot.angle, math.nan), (robot.angle, math.inf), (robot.refused, value)]
            await asyncio.to_thread(commands.give, *given)
        return commands.written

    asyncio.run(write())

    assert noted(notes) == list(range(100))
    assert sorted(told) == [
        "angle: nan is no value of signed 32: a finite number was expected (told once)",
        "posted write of refused at 0x21: the bus refused the access (told once)",
        "target: 1000001 is outside of its limits, 0 to 1000000 (told once)",
    ]


@pytest.mark.parametrize("value", [4e-323, -4e-323, 2.2e-308])
def test_a_subnormal_value_is_refused_with_its_cause(tmp_path: Path, value: float) -> None:
    spec = tmp_path / "number.ul"
    spec.write_text("public bench() { @target = 0x20: float READWRITE(); }")
    told: list[tuple[str, int]] = []

    async def write() -> float:
        async with unity_link.connect("sim:") as link:
            robot: Any = load(spec)(link)
            commands = SignalCommands(link, lambda text, *, level: told.append((text, level)))
            running = asyncio.create_task(commands.run())
            await asyncio.sleep(0)
            for one in (2.5, value, 0.0, value, 1.5):
                await asyncio.to_thread(commands.give, (robot.target, one))
            running.cancel()
            with pytest.raises(asyncio.CancelledError):
                await running
            assert commands.written == 3
            return float(await robot.target.get())

    assert asyncio.run(write()) == 1.5
    ((text, level),) = told
    assert text.startswith(f"target: {value} is subnormal, as rclpy sends an int in the place of a float")
    assert "ROS_PYTHON_CHECK_FIELDS=1" in text
    assert level == logging.ERROR
