"""The first words on a new connection: what the gateway is, and the start of a session.

`Q` is asked in plain form, because nothing is known yet, and again in the checked form that follows from the answer;
only if both agree is the answer believed. `K` then starts the session: the gateway expects ID 0 and publishes nothing.
A plain answer has no CRC, so whatever is wrong with one may be damage: it is asked for again.
"""

from __future__ import annotations

import asyncio
import contextlib
import math
from typing import TYPE_CHECKING

from unity_link.errors import ConnectError, UnsupportedError
from unity_link.protocol.configuration import GatewayInfo
from unity_link.protocol.crc import Crc
from unity_link.protocol.frames import LF, FrameError, Framing
from unity_link.protocol.messages import Codec

if TYPE_CHECKING:
    from unity_link.transport.stream import Stream

FIRST_TRY = 0.1
"""Seconds until a question is asked again, doubled each time."""
LONGEST_TRY = 1.0
LAST_ANSWER = len("K00CC\n")
"""Bytes of the last answer, at least."""
CHECKED_TRIES = 4
"""How often the checked `Q` is asked before the plain answer is doubted."""
DAMAGE_PAUSE = 0.002
"""Seconds from a line that is no answer to the next question."""
DAMAGE_PATIENCE = 16
"""How many times as long as a line took that was no answer, the next answer is waited for."""
SHORTEST_TRY = 0.005
DAMAGE_COST = 1 / 16
"""What part of a try a question counts that was answered by something else."""
_LONGEST_TEXT = 120
"""Characters of what is not understood that a message quotes."""


class Handshake:
    """One conversation with what is at the other end of a new connection.

    Args:
        stream: the connection.
        node: number of the node on a shared medium, or None.
    """

    def __init__(self, stream: Stream, node: int | None) -> None:
        self._stream = stream
        self._node = node
        self._framing = Framing(Crc(), node)
        self._plain = True
        self._beginning = b""
        self._answer: asyncio.Future[bytes] = asyncio.get_running_loop().create_future()
        self._damage: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        """Done when a line has come that is no answer."""
        self._tries = 0
        self._doubtful = b""
        self._heard = 0
        self._text = ""
        """What was said last that is no frame."""
        stream.receiver = self

    async def run(self) -> tuple[Codec, float]:
        """Learn what the gateway is and start a session; the caller's time out ends it.

        Returns:
            The messages of the gateway, and the round trip of the last question in seconds.

        Raises:
            ConnectError: where the connection ends.
            UnsupportedError: where the gateway is of another protocol version or reports impossible widths.
        """
        codec = await self._learn()
        loop = asyncio.get_running_loop()
        session = b"K" + codec.id_text[0]
        patience = FIRST_TRY
        while True:
            start = loop.time()
            tries = self._tries
            await self._ask(codec.framing.checked(session), session, patience)
            round_trip = loop.time() - start
            if self._tries == tries + 1:
                self._stream.receiver = None
                return codec, round_trip
            # An answer does not say to which question it is: once more, when those to the others have come.
            await asyncio.sleep(round_trip)
            patience = 2 * round_trip

    def describe(self) -> str:
        """Say what was heard, for the message of a time out."""
        if self._doubtful:
            return f"what answers is no gateway: it said {self._doubtful[:80]!r}"
        if self._heard:
            return f"{self._heard} bytes arrived, none of them an answer: check the speed of the port"
        return "nothing arrived: check that the gateway is powered, the port and the wiring"

    async def _learn(self) -> Codec:
        while True:
            # A line end first, for what an earlier program left unfinished; LF, for CR would execute it unchecked.
            self._framing, self._plain = Framing(Crc(), self._node), True
            answer = await self._ask(LF + self._framing.plain_request(b"Q"), b"Q")
            while (info := self._believe(answer)) is not None:
                codec = Codec(info, self._node)
                self._framing, self._plain = codec.framing, False
                checked = await self._ask(codec.framing.checked(b"Q"), b"Q", tries=CHECKED_TRIES)
                if checked == answer:
                    return codec
                self._doubtful, answer = answer, checked

    def _believe(self, plain: bytes) -> GatewayInfo | None:
        """Read a plain answer; what it says twice in the same words is no damage."""
        try:
            return GatewayInfo.from_hex(plain[1:])
        except UnsupportedError:
            if plain == self._doubtful:
                raise
        except ValueError:
            pass
        self._doubtful = plain
        return None

    async def _ask(
        self, question: bytes, beginning: bytes, patience: float = FIRST_TRY, tries: float = math.inf
    ) -> bytes:
        """Ask until the answer comes, and return it; nothing after so many tries.

        A line that is no answer may be a damaged one: then it is asked again soon, and that counts as a part of a try.
        """
        loop = asyncio.get_running_loop()
        self._beginning = beginning
        self._answer = loop.create_future()
        while tries > 0:
            if self._stream.closed:
                raise self._ended(None)
            self._damage = loop.create_future()
            self._tries += 1
            asked = loop.time()
            self._stream.send(question)
            await asyncio.wait((self._answer, self._damage), timeout=patience, return_when=asyncio.FIRST_COMPLETED)
            if self._damage.done():
                # What answers so soon will not take much longer for the next one.
                patience = min(max(DAMAGE_PATIENCE * (loop.time() - asked), SHORTEST_TRY), LONGEST_TRY)
                await asyncio.wait((self._answer,), timeout=DAMAGE_PAUSE)
                tries -= DAMAGE_COST
            else:
                patience = min(2 * patience, LONGEST_TRY)
                tries -= 1
            if self._answer.done():
                return self._answer.result()
        return b""

    # Called by the stream

    def receive(self, data: bytes) -> int:
        """Look for the answer in a read."""
        self._heard += len(data)
        *lines, rest = data.split(LF)
        for line in lines:
            self._receive_line(line)
        return len(data) - len(rest)

    def _receive_line(self, line: bytes) -> None:
        body = b""
        if line.endswith(b"\r") == self._plain:
            with contextlib.suppress(FrameError):
                body = self._framing.open(line)
        if not body.startswith(self._beginning):
            text = line[:_LONGEST_TEXT].decode("ascii", "replace").strip()
            self._text = text if text.isprintable() else ""
            if not self._damage.done():
                self._damage.set_result(None)
        elif not self._answer.done():
            self._answer.set_result(body)

    def disconnected(self, reason: Exception | None) -> None:
        """End the conversation."""
        if not self._answer.done():
            self._answer.set_exception(self._ended(reason))
            # No call may be waiting at this moment.
            self._answer.exception()

    def _ended(self, reason: Exception | None) -> ConnectError:
        """Say what can be known of an end: who hangs up may have said why, in a line of text."""
        why = f'"{self._text}"' if self._text else reason or "does it serve another program, or want a token?"
        return ConnectError(f"the connection ended before the gateway answered: {why}")
