"""Peers of generated clients: `unity-link simulate` as another process, and a line that fails on demand.

    with simulate("tcp", "--robot", "scara") as url, FaultyLine(url, "pty", [lose(r"^r002")]) as line:
        run_client(line.url)
    assert line.count(r"^r002") == 2    # the client retransmitted the lost request

`simulate` is the real command on a real medium. `FaultyLine` is a line between a client and a gateway that is served by
TCP: it carries whole frames, stores all of them, and applies each `Fault` to the frames that its pattern matches. So a
test knows exactly which frame was lost; the noise of `simulate --loss` is random. A session begins with a random ID; in
patterns, and in the stored frames, its IDs count from 000 on.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import re
import selectors
import socket
import subprocess
import sys
import threading
import tty
from pathlib import Path
from typing import TYPE_CHECKING, Literal, Self

import msgspec

from support.recorded_bus import RecordedBus
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import Framing
from unity_link.virtual import VirtualGateway
from unity_link.virtual.serving import serve_tcp

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence
    from types import TracebackType

    from unity_link.virtual import Gateway

PROGRAM = str(Path(sys.executable).parent / "unity-link")
Medium = Literal["pty", "tcp"]
MEDIA: tuple[Medium, ...] = ("pty", "tcp")
_DEFAULT_INFO = GatewayInfo()


@contextlib.contextmanager
def simulate(medium: Literal["pty", "tcp", "unix", "udp"], *arguments: str) -> Iterator[str]:
    """Run `unity-link simulate` with further arguments; yield its URL."""
    where = [f"--{medium}", *{"pty": [], "unix": []}.get(medium, ["0"])]
    command = [PROGRAM, "simulate", *where, *arguments]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            url = process.stdout.readline().strip()
            assert url, "unity-link simulate printed no URL"
            yield url
        finally:
            process.terminate()


@contextlib.contextmanager
def serve(gateway: Gateway) -> Iterator[str]:
    """Serve a gateway of this process by TCP, for features that `simulate` lacks: devices, nodes. Yield its URL."""
    loop = asyncio.new_event_loop()
    served = serve_tcp(gateway)
    thread = threading.Thread(target=loop.run_forever, daemon=True)
    thread.start()
    try:
        yield asyncio.run_coroutine_threadsafe(served.__aenter__(), loop).result()
        asyncio.run_coroutine_threadsafe(served.__aexit__(None, None, None), loop).result()
    finally:
        loop.call_soon_threadsafe(loop.stop)
        thread.join()
        loop.close()


class ObservedGateway(VirtualGateway):
    """A gateway that stores received frames and bus accesses, and can be reset before or after a frame."""

    def __init__(self, info: GatewayInfo = _DEFAULT_INFO) -> None:
        super().__init__(info)
        self.heard: list[str] = []
        self.bus_log = RecordedBus(self)
        self.most_at_once = 0
        """Most requests with an ID that arrived together."""
        self.reset_before: int | None = None
        """Number of frames until the reset; None for no reset."""
        self.reset_after = False
        """True if the gateway is to be reset after the answer to the current frame."""

    def receive(self, data: bytes, now: float) -> bytes:
        """Pass bytes to the gateway frame by frame; return its answers."""
        replies = [super().receive(b"", now)]
        frames = re.findall(rb"[^\r\n]*[\r\n]", data)
        self.most_at_once = max(self.most_at_once, sum(frame[:1].islower() for frame in frames))
        for frame in frames:
            if self.reset_before is not None:
                self.reset_before -= 1
                if self.reset_before < 0:
                    self.reset()
                    self.reset_before = None
            self.heard.append(frame.decode("latin-1").strip())
            replies.append(super().receive(frame, now))
            if self.reset_after:
                self.reset()
                self.reset_after = False
        return b"".join(replies)

    def sessions(self) -> list[str]:
        """Return the first ID of each session that was begun, followed by the number of the session."""
        digits = self.info.id_digits + self.info.session_digits
        return [frame[1 : 1 + digits] for frame in self.heard if frame.startswith("K") and len(frame) > 1 + digits]


class Fault(msgspec.Struct):
    """A fault of the first `times` frames that a pattern matches.

    `change` returns the bytes that arrive instead, from the frame and the CRC seed of its side in the session.
    """

    pattern: re.Pattern[str]
    change: Callable[[bytes, int], bytes]
    times: int = 1


class SessionIds:
    """Translates the IDs of a session, of three digits, into numbers from 0 on; stores the number of the session."""

    _START = re.compile(r"K([0-9A-F]{3})([0-9A-F]{4})(?:[0-9A-F]{4}){1,2}$")
    _NUMBERED = re.compile(r"([g-z]{1,2})([0-9A-F]{3})")

    def __init__(self) -> None:
        self.first = self.number = 0

    def note(self, text: str) -> None:
        """Store the first ID and the number of a session, if the frame begins one."""
        if found := self._START.match(text):
            self.first, self.number = int(found[1], 16), int(found[2], 16)

    def counted(self, text: str) -> str:
        """Return a frame in which the ID is counted from the first ID of the session."""
        return self._NUMBERED.sub(
            lambda found: f"{found[1]}{int(found[2], 16) - self.first & 0xFFF:03X}", text, count=1
        )


def lose(pattern: str, times: int = 1) -> Fault:
    """Return a fault that loses frames with their line ends."""
    return Fault(re.compile(pattern), lambda _, __: b"", times)


def damage(pattern: str, times: int = 1) -> Fault:
    """Return a fault that flips a bit in the last character before the line end, so that the CRC is wrong."""
    return Fault(re.compile(pattern), lambda frame, _: frame[:-2] + bytes([frame[-2] ^ 1]) + frame[-1:], times)


def double(pattern: str, times: int = 1) -> Fault:
    """Return a fault that delivers frames twice."""
    return Fault(re.compile(pattern), lambda frame, _: 2 * frame, times)


def replace(pattern: str, text: bytes, times: int = 1) -> Fault:
    """Return a fault that delivers another text instead of a frame."""
    return Fault(re.compile(pattern), lambda _, __: text, times)


def answer(pattern: str, body: bytes, times: int = 1) -> Fault:
    """Return a fault that delivers a checked frame instead: `body` with the ID of the frame at its `%b`."""
    return Fault(re.compile(pattern), lambda frame, seed: Framing(Crc()).checked(body % frame[1:4], seed), times)


class _Direction:
    """One direction of a line."""

    def __init__(self, source: int, sink: int, faults: list[Fault], ids: SessionIds, side: int) -> None:
        self.frames: list[str] = []
        self.source, self._sink, self._faults, self._ids, self._side = source, sink, faults, ids, side
        self._rest = b""

    def carry(self) -> bool:
        """Carry the received bytes; return False at the end of the stream."""
        try:
            data = os.read(self.source, 65536)
        except OSError:
            return False
        *frames, self._rest = re.split(rb"(?<=[\r\n])", self._rest + data)
        arriving = b"".join(self._after_faults(frame) for frame in frames)
        while arriving:
            arriving = arriving[os.write(self._sink, arriving) :]
        return bool(data)

    def _after_faults(self, frame: bytes) -> bytes:
        text = frame.decode("latin-1").strip("\r\n")
        self._ids.note(text)
        text = self._ids.counted(text)
        if text:
            self.frames.append(text)
        for fault in self._faults:
            if fault.times and fault.pattern.search(text):
                fault.times -= 1
                return fault.change(frame, 2 * self._ids.number + self._side)
        return frame


class FaultyLine:
    """A line between one client, on a pty or TCP, and a gateway that is served by TCP.

    Args:
        gateway: ``tcp://host:port``.
        medium: medium of the client.
        replies: faults of frames from the gateway.
        requests: faults of frames from the client.
    """

    def __init__(
        self, gateway: str, medium: Medium, replies: Sequence[Fault] = (), requests: Sequence[Fault] = ()
    ) -> None:
        host, port = gateway.removeprefix("tcp://").rsplit(":", 1)
        self._stack = contextlib.ExitStack()
        self._gateway = self._stack.enter_context(socket.create_connection((host, int(port))))
        self._listener: socket.socket | None = None
        self._faults = list(replies), list(requests)
        if medium == "tcp":
            self._listener = self._stack.enter_context(socket.create_server(("127.0.0.1", 0)))
            self.url = f"tcp://127.0.0.1:{self._listener.getsockname()[1]}"
        else:
            self._pty, port_side = os.openpty()
            tty.setraw(port_side)
            self._stack.callback(os.close, self._pty)
            self._stack.callback(os.close, port_side)
            self.url = f"serial:{os.ttyname(port_side)}"
        self._waker, self._woken = os.pipe()
        self._stack.callback(os.close, self._waker)
        self._thread = threading.Thread(target=self._run, daemon=True)
        self.requests: list[str] = []
        """Frames that the client has sent, without line ends."""
        self.replies: list[str] = []
        """Frames that the gateway has sent, without line ends."""

    def count(self, pattern: str) -> int:
        """Return the number of frames of the client that a pattern matches."""
        return sum(bool(re.search(pattern, frame)) for frame in self.requests)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        os.close(self._woken)
        self._thread.join()
        self._stack.close()

    def _run(self) -> None:
        with contextlib.ExitStack() as stack:
            client = self._accept(stack)
            if client is None:
                return
            ids = SessionIds()
            back = _Direction(self._gateway.fileno(), client, self._faults[0], ids, 1)
            towards = _Direction(client, self._gateway.fileno(), self._faults[1], ids, 0)
            self.replies, self.requests = back.frames, towards.frames
            selector = stack.enter_context(selectors.DefaultSelector())
            for direction in (back, towards):
                selector.register(direction.source, selectors.EVENT_READ, direction)
            selector.register(self._waker, selectors.EVENT_READ)
            while True:
                for key, _ in selector.select():
                    if key.data is None or not self._carried(key.data):
                        return

    def _carried(self, direction: _Direction) -> bool:
        try:
            return direction.carry()
        except OSError:
            return False

    def _accept(self, stack: contextlib.ExitStack) -> int | None:
        if self._listener is None:
            return self._pty
        with selectors.DefaultSelector() as selector:
            selector.register(self._listener, selectors.EVENT_READ)
            selector.register(self._waker, selectors.EVENT_READ)
            ready = {key.fileobj for key, _ in selector.select()}
        if self._listener not in ready:
            return None
        client, _ = self._listener.accept()
        return stack.enter_context(client).fileno()
