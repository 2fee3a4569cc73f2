"""Functions that tests of bridge programs share: they start the programs, and read the gateway directly."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from support.noting_gateway import SPEC as NOTED_SPEC

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

PROGRAM = str(Path(sys.executable).parent / "unity-link")
PATIENCE = 60.0
WRITES_SPEC = """
public all() {
  @word = 0x10: unsigned READWRITE(MAX=1000);
  @scaled = 0x11: signed READWRITE(SCALE=0.5);
  @flag = 0x12[0]: bool READWRITE();
  @mode = 0x12[3:1]: mode READWRITE();
  @wide = 0x14: unsigned 64 READWRITE();
  @number = 0x16: float READWRITE();
  @seen = 0x17: unsigned READ();
}
enum mode { idle = 0, run = 1 }
"""
WRITES_NAMES = ["word", "scaled", "flag", "mode", "wide", "number", "seen", "nothing"]
"""Names of the spec's signals, then a signal that can only be read, and a name that the spec lacks."""
FAST_SPEC = """
group fast(1, 1, TIMESTAMPS);
public bench() {
  GATEWAY(DATA_BITS=64);
  @value = 0x10: float 64 READ(PUBLISH(fast));
  @target = 0x20: float 64 WRITE();
}
"""
FAST_GATEWAY = "sim:?data_bits=64&base_frequency_millihertz=20000000"
"""Gateway with a group of 20,000 samples per second."""


def wait_until(condition: Callable[[], object]) -> None:
    deadline = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < deadline
        # Other processes do the work that this function waits for; polling faster would take processor time from them.
        time.sleep(0.02)


def seen_until_disarmed(robot: Any) -> set[int]:
    """Wait until the lease `drive` of a robot is disarmed; return the set of values that `duty` had until then."""
    seen = set[int]()

    def is_over() -> bool:
        seen.add(robot.duty.get())
        return not robot.drive.armed_.get()

    wait_until(is_over)
    return seen


def wait_for(process: subprocess.Popen[str], words: str) -> str:
    """Return the next line on stderr that contains `words`; after `PATIENCE`, kill the program and fail the test."""
    assert process.stderr is not None
    printed = []
    limit = threading.Timer(PATIENCE, process.kill)
    limit.start()
    try:
        for line in process.stderr:
            printed.append(line)
            assert "Traceback" not in line, line + process.stderr.read()
            if words in line:
                return line
    finally:
        limit.cancel()
    pytest.fail(f"the program ended within {PATIENCE:g} s, or was killed then, without {words!r}:\n{''.join(printed)}")


def line_of(process: subprocess.Popen[str]) -> str:
    """Return the next line on stdout."""
    assert process.stdout is not None
    return process.stdout.readline().strip()


_DOMAINS: list[socket.socket] = []
"""One socket for each domain that this process has claimed, open until the process ends."""


def free_domain() -> int:
    """Return a DDS domain that no other test on this machine uses: tests in one domain receive each other's data.

    Raises:
        RuntimeError: if all domains are in use.
    """
    # The ports of domains from 60 on are above those of most services; 232 is the highest (DDSI-RTPS 2.5, 9.6.2).
    for domain in range(60, 233):
        claim = socket.socket(socket.AF_UNIX)
        try:
            claim.bind(f"\0unity-link-tests-domain-{domain}")
        except OSError:
            claim.close()
            continue
        _DOMAINS.append(claim)
        return domain
    raise RuntimeError("domains 60 to 232 are all taken by tests of this machine")


@contextmanager
def bridge_on_shared(
    kind: str, spec: str, gateway: str, folder: Path, *options: str
) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Run a bridge on a shared gateway; yield the process, and the URL at which the test can reach the gateway too."""
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


class Noted:
    """A gateway in its own process, which tests can kill and restart, with a log of all values ever written to it.

    The values are those of the signal `target` of `noting_gateway.SPEC`.
    """

    def __init__(self, folder: Path) -> None:
        self.url = f"unix:{folder / 'gateway'}"
        self.spec = str(folder / "plain.ul")
        Path(self.spec).write_text(NOTED_SPEC)
        self._place, self._notes = folder / "gateway", folder / "notes"

    @contextmanager
    def running(self) -> Iterator[None]:
        """Run the gateway; kill it at the end of the block."""
        program = str(Path(__file__).with_name("noting_gateway.py"))
        with subprocess.Popen(
            [sys.executable, program, str(self._place), str(self._notes)], stdout=subprocess.PIPE
        ) as process:
            assert process.stdout is not None
            assert process.stdout.readline() == b"ready\n"
            try:
                yield
            finally:
                process.kill()

    @property
    def values(self) -> list[int]:
        return [int(line) for line in self._notes.read_text().split()] if self._notes.exists() else []

    def wait_for_more(self, count: int = 50) -> None:
        """Wait until `count` more values were written."""
        before = len(self.values)
        wait_until(lambda: len(self.values) >= before + count)


@contextmanager
def program(*arguments: str) -> Iterator[subprocess.Popen[str]]:
    """Run `unity-link`; kill it at the end of the block."""
    with subprocess.Popen(
        [PROGRAM, *arguments], stderr=subprocess.PIPE, text=True, env={**os.environ, "PYTHONUNBUFFERED": "1"}
    ) as process:
        try:
            yield process
        finally:
            process.kill()
