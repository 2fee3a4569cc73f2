"""A server of a shared link between clients and a gateway that both send bytes of an input, on simulated time."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

from unity_link.bridges.serve.door import Door
from unity_link.bridges.serve.shared import SharedLink
from unity_link.errors import ConnectError
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.protocol.wire.frames import in_session
from unity_link.transport.pipe import PipeEnd, connect_pipe
from unity_link.virtual import VirtualGateway
from unity_link.virtual.gateway import Gateway
from unity_link.virtual.modelled_time import ModelledTimeLoop

if TYPE_CHECKING:
    from collections.abc import MutableMapping

    from fuzz.choices import Choices

TOKEN = "secret"
MOST_HEARD = 1 << 20
"""Largest number of bytes that one client may receive for an input."""
OPENING = 5.0
"""Seconds within which a working gateway has a link."""
_CRC = Crc()


class Hostile(Gateway):
    """A gateway that sends bytes of an input, besides the answers of a gateway with memory at all addresses."""

    def __init__(self) -> None:
        self.honest = VirtualGateway()
        self.info, self.wake = self.honest.info, lambda: None
        self.instead = b""
        """Bytes that the host receives next."""
        self.silent = False

    @property
    def memory(self) -> MutableMapping[int, int]:
        return self.honest.memory

    @property
    def next_due(self) -> float | None:
        return 0.0 if self.instead else self.honest.next_due

    @property
    def waiting(self) -> int:
        return self.honest.waiting

    def receive(self, data: bytes, now: float) -> bytes:
        return self._said(self.honest.receive(data, now))

    def advance(self, now: float, room: int | None = None) -> bytes:
        return self._said(self.honest.advance(now, room))

    def say(self, data: bytes) -> None:
        self.instead += data
        self.wake()

    def _said(self, answer: bytes) -> bytes:
        said, self.instead = self.instead, b""
        return said + (b"" if self.silent else answer)


class Listener(asyncio.Protocol):
    """A client that sends bytes of an input."""

    def __init__(self) -> None:
        self.heard = 0
        self.session = 0
        """Number of the session that it opened last."""
        self.gone = False
        self.end: PipeEnd

    def data_received(self, data: bytes) -> None:
        self.heard += len(data)

    def connection_lost(self, exc: Exception | None) -> None:
        self.gone = True


class Scene:
    """The server, its gateway, and its clients."""

    def __init__(self, choices: Choices) -> None:
        self._choices = choices
        self._gateway = Hostile()
        self.shared = SharedLink(self._gateway, lambda _: None)
        self._listeners: list[Listener] = []
        self._steps = (
            self._client_says,
            self._client_says_checked,
            self._client_asks,
            self._gateway_says,
            self._gateway_says_checked,
            self._wait,
            self._come,
            self._leave,
            self._read_or_not,
            self._trouble,
        )

    def step(self) -> None:
        """Perform the action of the next byte."""
        self._steps[self._choices.number() % len(self._steps)]()

    async def play(self) -> None:
        """Perform the actions of the whole input, then end; the end must be quick and leave no task."""
        self.shared.open_when_there()
        while self._choices:
            self.step()
            await asyncio.sleep(0)
        await asyncio.sleep(OPENING)
        assert all(one.heard < MOST_HEARD for one in self._listeners)
        await self.shared.finish()
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        assert not self.shared.clients
        if self.shared.ended.done() and not self.shared.ended.cancelled():
            assert isinstance(self.shared.ended.exception(), ConnectError)

    def _listener(self) -> Listener | None:
        there = [one for one in self._listeners if not one.gone]
        return there[self._choices.number() % len(there)] if there else None

    def _tell(self, data: bytes) -> None:
        listener = self._listener()
        if listener is not None:
            listener.end.write(data)

    def _client_says(self) -> None:
        self._tell(self._choices.take(self._choices.number()))

    def _client_says_checked(self) -> None:
        self._tell_checked(self._choices.take(self._choices.number() % 64))

    def _tell_checked(self, body: bytes) -> None:
        """Send a frame of the client's session to the server; a `K` opens the next session."""
        listener = self._listener()
        if listener is None:
            return
        if body[:1] == b"K":
            listener.session += 1
            body += b"%04X" % listener.session
        listener.end.write(_checked(body, seed_of(listener.session, from_gateway=False)))

    def _client_asks(self) -> None:
        number, address = b"%03X" % self._choices.number(), b"%02X" % self._choices.number()
        asked = (
            b"K" + number,
            b"r" + number + address,
            b"w" + number + address + b"0000002A",
            b"ws" + number + address + b"0000002B",
            b"rm" + number + address + b"04",
            b"gs" + number + address[:1] + b"1" + b"01000102" + address + b"0B",
            b"gn" + number + b"0" + address[:1],
            b"gx" + number + b"0" + address[:1],
            b"h" + number,
            b"Q",
        )
        self._tell_checked(asked[self._choices.number() % len(asked)])

    def _gateway_says(self) -> None:
        self._gateway.say(self._choices.take(self._choices.number()))

    def _gateway_says_checked(self) -> None:
        seed = seed_of(self._gateway.honest.session, from_gateway=True)
        self._gateway.say(_checked(self._choices.take(self._choices.number() % 64), seed))

    def _wait(self) -> None:
        loop = asyncio.get_running_loop()
        assert isinstance(loop, ModelledTimeLoop)
        loop.jump(self._choices.number() / 32)

    def _come(self) -> None:
        listener = Listener()
        door = Door(self.shared, TOKEN if self._choices.number() & 1 else None)
        listener.end = PipeEnd(listener)
        connect_pipe(listener.end, PipeEnd(door))
        self._listeners.append(listener)

    def _leave(self) -> None:
        listener = self._listener()
        if listener is not None:
            listener.end.abort()

    def _read_or_not(self) -> None:
        listener = self._listener()
        if listener is None:
            return
        if listener.end.is_reading():
            listener.end.pause_reading()
        else:
            listener.end.resume_reading()

    def _trouble(self) -> None:
        what = self._choices.number() % 3
        if what == 0:
            self._gateway.honest.reset()
        elif what == 1:
            self._gateway.silent = not self._gateway.silent
        elif self.shared._flow.stream is not None and self.shared._flow.stream._transport is not None:
            self.shared._flow.stream._transport.abort()


def _checked(body: bytes, seed: int) -> bytes:
    return body + _CRC.text(body, seed if body and in_session(body[0]) else 0) + b"\n"


def serve(choices: Choices) -> None:
    """Run an input to its end. Raise the first exception that a callback or a task did not catch."""
    uncaught: list[dict[str, Any]] = []

    async def play() -> None:
        asyncio.get_running_loop().set_exception_handler(lambda _, context: uncaught.append(context))
        await Scene(choices).play()

    with asyncio.Runner(loop_factory=ModelledTimeLoop) as runner:
        runner.run(play())
    for context in uncaught:
        raise AssertionError(context["message"]) from context.get("exception")
