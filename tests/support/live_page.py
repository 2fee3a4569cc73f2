"""Runs `unity-link live`, and replaces the page in a browser by a client of its WebSocket."""

from __future__ import annotations

import json
import shutil
import socket
import struct
import subprocess
import time
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import pytest
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin

from support.bridge_programs import PATIENCE, PROGRAM
from unity_link.bridges.live.outbox import BATCH_HEAD, HEAD

if TYPE_CHECKING:
    from collections.abc import Iterator

SPEC = str(Path(__file__).parents[2] / "examples" / "scara.ul")
FAST = "sim:scara?base_frequency_millihertz=2000000000"
"""A gateway that publishes 20,000 samples a second."""
TOKEN = "a-token"
CHROMIUM = shutil.which("chromium")
needs_chromium = pytest.mark.skipif(CHROMIUM is None, reason="needs Chromium: apt install chromium")
POSITION_SET_POINT = 0x8C
COUNTS_PER_DEGREE = 50 * 4000 / 360


class Live(NamedTuple):
    """A running `unity-link live`."""

    process: subprocess.Popen[str]
    url: str
    """Address of the page, with the token."""

    @property
    def address(self) -> str:
        return self.url.partition("#")[0]

    @property
    def host(self) -> str:
        return self.address.removeprefix("http://").rstrip("/")


@contextmanager
def live(*arguments: str, begins: str = "\0") -> Iterator[Live]:
    """Run `unity-link live`. At the end, fail if stderr has an unread line that does not begin with `begins`."""
    command = [PROGRAM, "live", *arguments]
    if "--browser" not in arguments:
        command.append("--no-browser")
    if "--port" not in arguments:
        command += ["--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        try:
            url = process.stdout.readline().strip()
            assert url, process.stderr.read()
            yield Live(process, url)
        finally:
            process.kill()
        if not process.stderr.closed:
            told = [line for line in process.stderr if not line.startswith(begins)]
            assert told == [], "".join(told)


@contextmanager
def gateway(path: Path, *arguments: str) -> Iterator[str]:
    """Serve a gateway on a Unix socket; kill it at the end of the context."""
    command = [PROGRAM, *arguments, "--unix", str(path)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
        try:
            assert process.stdout is not None
            yield process.stdout.readline().strip()
        finally:
            process.kill()


@contextmanager
def looking(at: Live, *, origin: str | None = "own", token: str | None = None) -> Iterator[ClientConnection]:
    """Open the WebSocket of a page; yield the connection."""
    said = f"http://{at.host}" if origin == "own" else origin
    named = None if said is None else Origin(said)
    with connect(f"ws://{at.host}/samples", origin=named, max_size=None) as connection:
        if token is not None:
            connection.send(json.dumps({"type": "hello", "token": token}))
        yield connection


def hear(connection: ClientConnection, kind: str) -> Any:
    """Return the next message of a kind; skip other messages."""
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        data = connection.recv(timeout=PATIENCE)
        if isinstance(data, str) and (message := json.loads(data))["type"] == kind:
            return message
    raise AssertionError(kind)


class Samples(NamedTuple):
    """A message with samples."""

    sent: float
    """Seconds since 1970 at which the server sent the message."""
    dropped: int
    tables: dict[int, list[np.ndarray[Any, Any]]]


def take(connection: ClientConnection, about: Any) -> Samples:
    """Return the next message with samples."""
    columns = [sum(known["stream"] == number for known in about["signals"]) for number in range(len(about["streams"]))]
    while True:
        data = connection.recv(timeout=PATIENCE)
        if isinstance(data, bytes):
            break
    sent, dropped = HEAD.unpack_from(data)
    place = HEAD.size
    tables: dict[int, list[np.ndarray[Any, Any]]] = {number: [] for number in range(len(columns))}
    while place < len(data):
        stream, count = BATCH_HEAD.unpack_from(data, place)
        place += BATCH_HEAD.size
        numbers = (2 + columns[stream]) * count
        tables[stream].append(np.frombuffer(data, "<f8", numbers, place).reshape(-1, count))
        place += 8 * numbers
    return Samples(sent, dropped, tables)


def write(connection: ClientConnection, path: str, value: object, number: int = 7) -> Any:
    connection.send(json.dumps({"type": "write", "number": number, "signal": path, "value": value}))
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        data = connection.recv(timeout=PATIENCE)
        if isinstance(data, str) and (message := json.loads(data)).get("number") == number:
            return message
    raise AssertionError


class Sleeper:
    """A client that opens the WebSocket, and then reads only when the test asks it to."""

    def __init__(self, running: Live) -> None:
        host, _, port = running.host.partition(":")
        self.socket = socket.socket()
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        self.socket.settimeout(PATIENCE)
        self.socket.connect((host, int(port)))
        self.socket.sendall(handshake(running.host))
        head = b""
        while not head.endswith(b"\r\n\r\n"):
            head += self.receive(1)
        assert head.startswith(b"HTTP/1.1 101")

    def say(self, kind: int, data: bytes, *, last: bool = True) -> None:
        """Send a WebSocket frame with the opcode `kind`."""
        length = bytes([0x80 | len(data)]) if len(data) < 126 else b"\xfe" + struct.pack(">H", len(data))
        # Send a mask of zeros, which leaves the data unchanged.
        self.socket.sendall(bytes([kind | 0x80 * last]) + length + bytes(4) + data)

    def next_dropped(self) -> int:
        """Read up to the next message with samples; return the number of dropped samples that it reports."""
        while True:
            kind, length = self.receive(2)
            if length == 126:
                (length,) = struct.unpack(">H", self.receive(2))
            elif length == 127:
                (length,) = struct.unpack(">Q", self.receive(8))
            data = self.receive(length)
            if kind & 0xF == 2:
                dropped: int = HEAD.unpack_from(data)[1]
                return dropped

    def receive(self, count: int) -> bytes:
        data = b""
        while len(data) < count:
            part = self.socket.recv(count - len(data))
            assert part
            data += part
        return data


def handshake(host: str) -> bytes:
    lines = (
        "GET /samples HTTP/1.1",
        f"Host: {host}",
        f"Origin: http://{host}",
        "Upgrade: websocket",
        "Connection: Upgrade",
        "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==",
        "Sec-WebSocket-Version: 13",
        "",
        "",
    )
    return "\r\n".join(lines).encode()


def memory_of(process: int) -> int:
    """Return the resident memory of a process in bytes."""
    (line,) = (line for line in Path(f"/proc/{process}/status").read_text().splitlines() if line.startswith("VmRSS"))
    return 1024 * int(line.split()[1])


def connections_of(process: int) -> int:
    """Return the number of sockets that a process has open."""
    count = 0
    for file in Path(f"/proc/{process}/fd").iterdir():
        with suppress(FileNotFoundError):
            count += str(file.readlink()).startswith("socket:")
    return count
