"""`unity-link live` running, and what a page says and hears, without a browser."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin

from unity_link.bridges.live.outbox import BATCH_HEAD, HEAD

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator


PROGRAM = str(Path(sys.executable).parent / "unity-link")
SPEC = str(Path(__file__).parents[1] / "examples" / "scara.ul")
FAST = "sim:scara?base_frequency_millihertz=2000000000"
"""A gateway that publishes 20,000 samples a second."""
PATIENCE = 60.0
TOKEN = "a-token"
POSITION_SET_POINT = 0x8C
COUNTS_PER_DEGREE = 50 * 4000 / 360


class Live(NamedTuple):
    """A running `unity-link live`."""

    process: subprocess.Popen[str]
    url: str
    """With the token."""

    @property
    def address(self) -> str:
        return self.url.partition("#")[0]

    @property
    def host(self) -> str:
        return self.address.removeprefix("http://").rstrip("/")


@contextmanager
def live(*arguments: str) -> Iterator[Live]:
    command = [PROGRAM, "live", *arguments]
    if "--browser" not in arguments:
        command.append("--no-browser")
    if "--port" not in arguments:
        command += ["--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            url = process.stdout.readline().strip()
            assert url, process.stderr.read() if process.stderr else ""
            yield Live(process, url)
        finally:
            process.kill()


@contextmanager
def gateway(path: Path, *arguments: str) -> Iterator[str]:
    """Serve a gateway at a Unix socket, until the end of the context; then it is gone at once."""
    command = [PROGRAM, *arguments, "--unix", str(path)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
        try:
            assert process.stdout is not None
            yield process.stdout.readline().strip()
        finally:
            process.kill()


@contextmanager
def looking(at: Live, *, origin: str | None = "own", token: str | None = None) -> Iterator[ClientConnection]:
    """Be a page, without a browser."""
    said = f"http://{at.host}" if origin == "own" else origin
    named = None if said is None else Origin(said)
    with connect(f"ws://{at.host}/samples", origin=named, max_size=None) as connection:
        if token is not None:
            connection.send(json.dumps({"type": "hello", "token": token}))
        yield connection


def hear(connection: ClientConnection, kind: str) -> Any:
    """Wait for a message of a kind."""
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        data = connection.recv(timeout=PATIENCE)
        if isinstance(data, str) and (message := json.loads(data))["type"] == kind:
            return message
    raise AssertionError(kind)


class Samples(NamedTuple):
    """A message of samples."""

    dropped: int
    tables: dict[int, list[np.ndarray[Any, Any]]]


def take(connection: ClientConnection, about: Any) -> Samples:
    """Wait for samples."""
    columns = [sum(known["stream"] == number for known in about["signals"]) for number in range(len(about["streams"]))]
    while True:
        data = connection.recv(timeout=PATIENCE)
        if isinstance(data, bytes):
            break
    _, dropped = HEAD.unpack_from(data)
    place = HEAD.size
    tables: dict[int, list[np.ndarray[Any, Any]]] = {number: [] for number in range(len(columns))}
    while place < len(data):
        stream, count = BATCH_HEAD.unpack_from(data, place)
        place += BATCH_HEAD.size
        numbers = (2 + columns[stream]) * count
        tables[stream].append(np.frombuffer(data, "<f8", numbers, place).reshape(-1, count))
        place += 8 * numbers
    return Samples(dropped, tables)


def write(connection: ClientConnection, path: str, value: object, number: int = 7) -> Any:
    connection.send(json.dumps({"type": "write", "number": number, "signal": path, "value": value}))
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        data = connection.recv(timeout=PATIENCE)
        if isinstance(data, str) and (message := json.loads(data)).get("number") == number:
            return message
    raise AssertionError


def wait_until(condition: Callable[[], bool]) -> None:
    deadline = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.05)
