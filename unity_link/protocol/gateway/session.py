"""The gateway's side of a session: which requests are to be executed, and the answers to all that are not.

Shared by all that answer hosts: the virtual gateway, and the server that lets several programs share one link. They
differ in what executing means, `Q` and `K` included. Steps 1 to 6 of the checks in docs/protocol.md, "Errors", are made
here; those who execute requests make the others.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from unity_link.protocol.gateway.reception import Reception, Sequence, SequencePlace
from unity_link.protocol.window.constants import MOST_KEPT_WORDS
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.crc import NO_SESSION, seed_of
from unity_link.protocol.wire.messages import COMMANDS, LOOKING, Codec, DecodedRequest, ErrorCode, Repeat, RequestError

if TYPE_CHECKING:
    from collections.abc import Sequence as Words
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


class SessionState:
    """One session, or the time without one.

    Args:
        number: of the session.
        for_program: True if a checked `K` began it, so that what is not in its order is shut out.
        compact: whether it asked for the compact form.
        ring: number of IDs.
        fates: of `Sequence`.
        kept: words of destructive reads, which as in the gateware neither a reset nor a session changes.
    """

    __slots__ = ("awaited", "compact", "failed", "fates", "for_program", "kept", "number", "seeds")

    def __init__(
        self, number: int, *, for_program: bool, compact: bool, ring: int, fates: bytearray, kept: list[int]
    ) -> None:
        self.number = number
        self.compact = compact
        self.seeds = seed_of(number, from_gateway=False), seed_of(number, from_gateway=True)
        """Seeds of what the host sends, and of what the gateway sends."""
        self.for_program = for_program
        self.failed = 0
        """Number of stateless writes that failed, modulo the ring."""
        self.awaited = bytearray(ring)
        """Flags by ID: 1 if its request is under way. A gateway that answers at once has none."""
        self.fates = fates
        self.kept = kept

    def fail(self, number: int, code: ErrorCode, *, posted: bool) -> None:
        """Note that a request ended in error 04, 05 or 06."""
        self.fates[number % len(self.fates)] = code
        if posted:
            self.failed = self.failed + 1 & len(self.awaited) - 1

    def keep(self, number: int, words: Words[int]) -> None:
        """Keep what a destructive read gave."""
        for place, word in enumerate(words, number):
            self.kept[place % MOST_KEPT_WORDS] = word

    def end(self) -> None:
        """Let what is still under way change nothing of the sessions behind this one."""
        self.fates, self.kept = bytearray(self.fates), list(self.kept)


class GatewaySession:
    """The sessions of one host, one after the other, none at first.

    Args:
        codec: the messages of the gateway.
    """

    def __init__(self, codec: Codec) -> None:
        self.sequence = Sequence(codec.id_count)
        self.ended = NO_SESSION
        """Number of the session that the last `K` has ended, as that was asked for."""
        self._codec = codec
        self.state = self._state(NO_SESSION, self.sequence.fates, [0] * MOST_KEPT_WORDS)
        self.reception = Reception(codec)
        self.most_kept = self.reception.longest + len(codec.framing.prefix) + 1
        """Characters of an endless line by which it is known to be too long."""
        self.reset()

    @property
    def begun(self) -> bool:
        """Return whether there is a session: a `K` has come since the reset."""
        return self.state.number != NO_SESSION

    def reset(self) -> None:
        """End the session: nothing with an ID is executed until the next `K`."""
        self.sequence.reset()
        self._begin(NO_SESSION, for_program=False)

    def begin(self, number: int, first: int, *, for_program: bool = True, compact: bool = False) -> None:
        """Begin a session.

        Args:
            number: of the session.
            first: the next ID expected.
            for_program: whether what is not in its order is shut out.
            compact: whether frames are sent in compact form.
        """
        self.sequence.start(first)
        self._begin(number, for_program=for_program, compact=compact)

    @property
    def asked(self) -> int:
        """Number of the session under way as it was asked for, with the bit of the compact form."""
        return self.state.number | self.state.compact * self._codec.info.asks_compact

    def _begin(self, number: int, *, for_program: bool, compact: bool = False) -> None:
        before = self.state
        self.ended = self.asked
        self.state = self._state(number, before.fates, before.kept, for_program=for_program, compact=compact)
        before.end()

    def _state(
        self, number: int, fates: bytearray, kept: list[int], *, for_program: bool = False, compact: bool = False
    ) -> SessionState:
        ring = self._codec.id_count
        return SessionState(number, for_program=for_program, compact=compact, ring=ring, fates=fates, kept=kept)

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
            request = self.reception.read(
                line, plain=plain, prefix=prefix, session=self.state.number, bytes_lost=bytes_lost
            )
        except RequestError as refusal:
            return Answer(self._codec.error(refusal.code))
        if self.state.for_program and (plain if request.id is not None else request.command not in LOOKING):
            return Answer(self._codec.error(ErrorCode.SESSION_UNDER_WAY, request.id))
        if request.id is not None:
            return self._in_order(request, request.id)
        return self._open(request, for_program=not plain) if request.command == "K" and request.values else request

    def _in_order(self, request: DecodedRequest, number: int) -> DecodedRequest | Answer:
        """Return what becomes of a request of a session."""
        place = self.sequence.place(number)
        if place is SequencePlace.NEXT:
            return request
        if place is SequencePlace.REPETITION:
            return self._repeat(request, number)
        if place is SequencePlace.NO_SESSION:
            return Answer(self._codec.no_session(number, request.residue))
        told = place is SequencePlace.AHEAD
        return SILENCE if told else Answer(self._codec.out_of_sequence(self.sequence.expected))

    def _open(self, request: DecodedRequest, *, for_program: bool) -> DecodedRequest | Answer:
        """Begin the session that a `K` asks for, if it may be."""
        first, asked = request.values
        info = self._codec.info
        number = asked & info.last_session
        if self.begun and number == self.state.number:
            return Answer(self._codec.error(ErrorCode.SESSION_UNDER_WAY))
        compact = asked != number
        if not number or (compact and Feature.COMPACT not in info.features):
            return Answer(self._codec.error(ErrorCode.OUT_OF_RANGE))
        self.begin(number, first, for_program=for_program, compact=compact)
        return request

    def _repeat(self, request: DecodedRequest, number: int) -> DecodedRequest | Answer:
        """Return what becomes of a request that was taken before."""
        if self.state.awaited[number]:
            return UNDER_WAY
        fate = self.sequence.fate(number)
        if fate:
            return Answer(self._codec.error(ErrorCode(fate), number), number)
        repetition = COMMANDS[request.command].repetition
        if repetition is Repeat.READ_AGAIN:
            return request._replace(repeated=True)
        if repetition is Repeat.SILENCE:
            return SILENCE
        if repetition is Repeat.KEPT and not self._fits(request):
            return Answer(self._codec.error(ErrorCode.OUT_OF_RANGE, number), number)
        return Answer(self._codec.response(request, self._once_more(request, number)), number)

    def _fits(self, request: DecodedRequest) -> bool:
        """Return whether a destructive read asks for what this gateway has."""
        info = self._codec.info
        address: int = request.values[0]
        words: tuple[int, ...] = request.values[1:]
        if request.command == "RQ":
            return address < 1 << info.address_bits and 1 <= words[0] <= info.block_words
        return address < 1 << info.address_bits and max(words) < 1 << info.data_bits

    def _once_more(self, request: DecodedRequest, number: int) -> int | list[int] | None:
        """Return what the answer to a repetition has beside the ID."""
        if request.command == "H":
            return self.state.failed
        kept = self.state.kept
        if request.command == "WK":
            return kept[number % MOST_KEPT_WORDS]
        if request.command == "RQ":
            return [kept[place % MOST_KEPT_WORDS] for place in range(number, number + request.values[1])]
        return None
