"""Functions that tests of recordings share: they record a moving robot."""

from __future__ import annotations

import asyncio
import subprocess
from concurrent.futures import Executor, Future
from pathlib import Path
from typing import TYPE_CHECKING, Any

import unity_link
from support.bridge_programs import PROGRAM
from unity_link.bridges.recording import Recorder, Recording, recorder

if TYPE_CHECKING:
    from collections.abc import Callable

    import pytest

    from unity_link.spec import Spec

SPEC = Path(__file__).parents[2] / "examples" / "scara.ul"
GATEWAY = "sim:scara?base_frequency_millihertz=20000000"
"""The robot of the paper; its group publishes 200 times a second."""


def record(
    path: Path, enough: Callable[[Recorder], bool], url: str = GATEWAY, spec: Path | Spec = SPEC, **options: Any
) -> Recorder:
    """Record a robot until `enough` returns True; the robot of the paper moves."""

    async def run() -> Recorder:
        async with unity_link.connect(url) as link:
            robot = unity_link.load(spec)(link)
            recorder = Recorder(robot, path, **options)
            if spec is SPEC:
                await robot.j1.pos_sp.set(50)
            running = asyncio.create_task(recorder.run())
            while not enough(recorder) and not running.done():  # noqa: ASYNC110  (a thread writes)
                await asyncio.sleep(0.01)
            running.cancel()
            await asyncio.wait([running])
            return recorder

    return asyncio.run(run())


def run(*arguments: str | Path, **options: Any) -> subprocess.CompletedProcess[str]:
    result = subprocess.run(
        [PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120, check=False, **options
    )
    assert "Traceback" not in result.stderr
    return result


def sequence_in(path: Path) -> list[int]:
    """Return the sequence numbers of the samples in a recording of one group."""
    return [number for samples, _ in Recording(path).samples() for number in samples.sequence.tolist()]


def was_cut(path: Path) -> bool:
    """Return True if a recording is cut."""
    recording = Recording(path)
    for _ in recording.samples():
        pass
    return recording.was_cut


class InPlace(Executor):
    """Runs each task at once in the calling thread, for modelled time."""

    def submit(self, function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        done: Future[Any] = Future()
        done.set_result(function(*args, **kwargs))
        return done


def work_in_place(monkeypatch: pytest.MonkeyPatch) -> None:
    """Make recorders write in the event loop, without pauses."""
    monkeypatch.setattr(recorder, "ThreadPoolExecutor", lambda *_: InPlace())
    monkeypatch.setattr(recorder, "REST", 0.0)
