"""What tests of bridges as programs share: waiting for what they do and say, on a gateway that a test sees as well."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

PROGRAM = str(Path(sys.executable).parent / "unity-link")
PATIENCE = 60.0


def wait_until(condition: Callable[[], object]) -> None:
    deadline = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < deadline
        # What is waited for happens in other processes; looking more often would only take their time.
        time.sleep(0.02)


def wait_for(process: subprocess.Popen[str], words: str) -> str:
    """Wait for a line on stderr."""
    assert process.stderr is not None
    for line in process.stderr:
        assert "Traceback" not in line
        if words in line:
            return line
    pytest.fail(f"the program ended without saying {words!r}")


@contextmanager
def bridge_on_shared(
    kind: str, spec: str, gateway: str, folder: Path, *options: str
) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Run a bridge on a gateway that the test can look at, too; give it, and the URL of that."""
    place = folder / "gateway"
    with subprocess.Popen([PROGRAM, "serve", gateway, "--unix", str(place)], stdout=subprocess.PIPE) as server:
        assert server.stdout is not None
        url = server.stdout.readline().decode().strip()
        with subprocess.Popen(
            [PROGRAM, kind, spec, "--link", url, *options],
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONUNBUFFERED": "1"},
        ) as process:
            try:
                yield process, url
            finally:
                process.kill()
                server.terminate()
