"""The gateway's side of a session: which requests are to be executed, and the answers to all that are not.

Shared by all that answer hosts: the virtual gateway, and the server that lets several programs share one link. They
differ in what executing means, `Q` and `K` included. Steps 1 to 6 of the checks in docs/protocol.md, "Errors", are made
here; those who execute requests make the others.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from unity_link.protocol.messages import COMMANDS, Codec, DecodedRequest, ErrorCode, Repetition, RequestError
from unity_link.protocol.reception import Reception, Sequence, SequencePlace

if TYPE_CHECKING:
    from typing import Final


class Answer(NamedTuple):
    """An answer for which nothing is executed."""

    body: bytes
    """Empty where the request has none."""
    number: int | None = None
    """ID of the request that was executed before and is answered once more."""


SILENCE: Final = Answer(b"")
UNDER_WAY: Final = Answer(b"\n")
"""Stands for an answer where the request is a repetition of one that is awaited."""


class GatewaySession:
    """The session of one host, none at first.

    Args:
        codec: the messages of the gateway.
    """

    def __init__(self, codec: Codec) -> None:
        self.sequence = Sequence(codec.ring)
        self.awaited: bytearray
        """Flags by ID: 1 if its request is under way. A gateway that answers at once has none."""
        self._codec = codec
        self._reception = Reception(codec)
        self.most_kept = self._reception.longest + len(codec.framing.prefix) + 1
        """Characters of an endless line by which it is known to be too long."""
        self.reset()

    @property
    def begun(self) -> bool:
        """Return whether there is a session: a `K` has come since the reset."""
        return self.sequence.expected >= 0

    def reset(self) -> None:
        """End the session: nothing with an ID is executed until the next `K`."""
        self.sequence.reset()
        self._forget_awaited()

    def take(
        self, line: bytes, *, plain: bool, prefix: bytes = b"", bytes_lost: bool = False
    ) -> DecodedRequest | Answer:
        """Take what stood before a line end.

        Args:
            line: without the prefix of an addressed frame.
            plain: whether the line ended in CR, and so has no CRC.
            prefix: of an addressed frame, which its CRC covers.
            bytes_lost: whether bytes of the line were lost before they could be looked at.

        Returns:
            The request that is to be executed, or the answer where none is. With a `K` the session has begun.
        """
        try:
            request = self._reception.read(line, plain=plain, prefix=prefix, bytes_lost=bytes_lost)
        except RequestError as refusal:
            return Answer(self._codec.error(refusal.code))
        if request.command == "K":
            self.sequence.start(request.values[0])
            self._forget_awaited()
        if request.id is None:
            return request
        place = self.sequence.place(request.id)
        if place is SequencePlace.NEXT:
            return request
        if place is SequencePlace.REPETITION:
            return self._repeat(request, request.id)
        if place is SequencePlace.NO_SESSION:
            return Answer(self._codec.error(ErrorCode.NO_SESSION, request.id))
        told = place is SequencePlace.AHEAD
        return SILENCE if told else Answer(self._codec.out_of_sequence(self.sequence.expected))

    def _repeat(self, request: DecodedRequest, number: int) -> DecodedRequest | Answer:
        """Return what becomes of a request that was taken before."""
        if self.awaited[number]:
            return UNDER_WAY
        repetition = COMMANDS[request.command].repetition
        if repetition is Repetition.READ_AGAIN:
            return request
        if repetition is Repetition.REFUSE:
            return Answer(self._codec.error(ErrorCode.ALREADY_EXECUTED, number), number)
        return SILENCE if repetition is Repetition.SILENCE else Answer(self._codec.response(request), number)

    def _forget_awaited(self) -> None:
        # A new one: what is under way belongs to the session before, and is noted in the old one.
        self.awaited = bytearray(self._codec.ring)
