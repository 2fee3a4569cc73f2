"""No module needs Linux when it is imported; media that all systems have work without the other media."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Iterator

HERE = Path(__file__).parent
SERVER = HERE / "transport" / "serve.py"
NOT_THERE = {
    # uvicorn imports it on Windows.
    "win32": {"unity_link.bridges.live": "No module named 'msvcrt'"},
    "darwin": {},
}
OF_THE_SYSTEM = "unity_link.bridges.ros1.outlet"
"""Modules that run only in the Python of ROS 1."""


@pytest.fixture(scope="module")
def urls() -> Iterator[list[str]]:
    """Serve one gateway by TCP and one by UDP, in other processes; yield the URLs."""
    found, processes = ["sim:scara"], []
    for medium in ("tcp", "udp"):
        command = [sys.executable, str(SERVER), medium, "", "0"]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        processes.append(process)
        assert process.stdout is not None
        found.append(process.stdout.readline().strip())
    yield found
    for process in processes:
        process.kill()
        process.communicate()


@pytest.mark.slow
@pytest.mark.parametrize("system", ["win32", "darwin"])
def test_all_modules_import_and_sockets_work_without_linux_features(system: str, urls: list[str]) -> None:
    command = [sys.executable, str(HERE / "support" / "other_system.py"), system, *urls]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    assert told["asyncio"] == [7] * len(urls)
    assert told["blocking"] == [8, 8] * len(urls)
    faults = {module: text for module, text in told["faults"].items() if module != OF_THE_SYSTEM}
    assert faults.keys() == NOT_THERE[system].keys()
    assert all(words in faults[module] for module, words in NOT_THERE[system].items())
