"""The session of a gateway: which requests to execute, and the answers to all others (docs/protocol.md, "The gateway").

1. Without a session no request with an ID is executed: error 0A. `K i s` begins a session; i is the first expected ID.
2. A request with the expected ID is executed, and the expected ID advances, also if the request ends in an error.
3. A later ID means that a request was lost: answer ``n`` with the expected ID, once for each gap.
4. An earlier ID is a repetition: repeat the answer. Only reads are executed again; the outcomes of the last half of the
   sequence space and the words of destructive reads are stored for that.
5. In a session that a checked `K` began, only requests with an ID in checked form may change anything: error 0B.

The simulated gateway and `unity-link serve` use this module and execute the returned requests, `Q` and `K` included, in
their own ways. It makes the checks 1 to 6 of docs/protocol.md, "Errors"; they make the others.
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
    """The answer to a request that is not executed."""

    body: bytes
    """Body of the answer; empty if the gateway sends none."""
    number: int | None = None
    """ID of the request if it is a repetition, None otherwise."""


SILENCE: Final = Answer(b"")
"""Send no answer."""
PENDING: Final = Answer(b"\n")
"""The request repeats one whose execution is not finished. Only a server has such requests; it sends an empty line."""


class SessionState:
    """The state of one session, or of the time without one.

    Args:
        number: number of the session, `NO_SESSION` without one.
        for_program: True if a checked `K` began it, so that requests without its IDs may not change anything.
        compact: True if the host requested the compact form.
        id_count: number of IDs.
        outcomes: outcomes of earlier requests, shared with `Sequence`.
        kept: stored words of destructive reads. Neither a reset nor a new session clears them, as in the gateware.
    """

    __slots__ = ("awaited", "compact", "failed", "for_program", "kept", "number", "outcomes", "seeds")

    def __init__(
        self, number: int, *, for_program: bool, compact: bool, id_count: int, outcomes: bytearray, kept: list[int]
    ) -> None:
        self.number = number
        self.compact = compact
        self.seeds = seed_of(number, from_gateway=False), seed_of(number, from_gateway=True)
        """Seeds of the host's frames, and of the gateway's frames."""
        self.for_program = for_program
        self.failed = 0
        """Number of posted writes that failed, modulo the number of IDs."""
        self.awaited = bytearray(id_count)
        """Flags by ID: 1 if its request is being executed. A gateway that answers at once sets none."""
        self.outcomes = outcomes
        self.kept = kept

    def fail(self, number: int, code: ErrorCode, *, posted: bool) -> None:
        """Record that a request ended in error 04, 05 or 06."""
        self.outcomes[number % len(self.outcomes)] = code
        if posted:
            self.failed = self.failed + 1 & len(self.awaited) - 1

    def keep(self, number: int, words: Words[int]) -> None:
        """Store the words of a destructive read."""
        for place, word in enumerate(words, number):
            self.kept[place % MOST_KEPT_WORDS] = word

    def end(self) -> None:
        """Detach this state from later sessions: requests that are still being executed must not change those."""
        self.outcomes, self.kept = bytearray(self.outcomes), list(self.kept)


class GatewaySession:
    """The sessions of a gateway, one after the other; none at first.

    Args:
        codec: message codec of the gateway.
    """

    def __init__(self, codec: Codec) -> None:
        self.sequence = Sequence(codec.id_count)
        self.ended = NO_SESSION
        """Number of the session that the last `K` has ended, with the bit of the compact form."""
        self._codec = codec
        self.state = self._state(NO_SESSION, self.sequence.outcomes, [0] * MOST_KEPT_WORDS)
        self.reception = Reception(codec)
        self.most_kept = self.reception.longest + len(codec.framing.prefix) + 1
        """Characters of a line without an end, after which it is too long."""
        self.reset()

    @property
    def begun(self) -> bool:
        """True if a session has begun since the reset."""
        return self.state.number != NO_SESSION

    def reset(self) -> None:
        """End the session: no request with an ID is executed until the next `K i s`."""
        self.sequence.reset()
        self._begin(NO_SESSION, for_program=False)

    def begin(self, number: int, first: int, *, for_program: bool = True, compact: bool = False) -> None:
        """Begin a session.

        Args:
            number: number of the session.
            first: the first expected ID.
            for_program: True if a checked `K` began it, so that requests without its IDs may not change anything.
            compact: True if frames are sent in compact form.
        """
        self.sequence.start(first)
        self._begin(number, for_program=for_program, compact=compact)

    @property
    def asked(self) -> int:
        """Number of the current session as in its `K i s`, with the bit of the compact form."""
        return self.state.number | self.state.compact * self._codec.info.asks_compact

    def _begin(self, number: int, *, for_program: bool, compact: bool = False) -> None:
        before = self.state
        self.ended = self.asked
        self.state = self._state(number, before.outcomes, before.kept, for_program=for_program, compact=compact)
        before.end()

    def _state(
        self, number: int, outcomes: bytearray, kept: list[int], *, for_program: bool = False, compact: bool = False
    ) -> SessionState:
        id_count = self._codec.id_count
        return SessionState(
            number, for_program=for_program, compact=compact, id_count=id_count, outcomes=outcomes, kept=kept
        )

    def take(
        self, line: bytes, *, plain: bool, prefix: bytes = b"", bytes_lost: bool = False
    ) -> DecodedRequest | Answer:
        """Take one received line.

        Args:
            line: the line without its end and without the prefix of an addressed frame.
            plain: True if the line ended in CR, so that it has no CRC.
            prefix: prefix of an addressed frame, which the CRC covers.
            bytes_lost: True if the receive FIFO has lost bytes of the line.

        Returns:
            The request to execute, or the answer if there is none to execute. If it is `K i s`, the session has begun.
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
        """Return a request with an ID if it is to be executed, otherwise its answer."""
        place = self.sequence.place(number)
        if place is SequencePlace.NEXT:
            return request
        if place is SequencePlace.REPETITION:
            return self._repeat(request, number)
        if place is SequencePlace.NO_SESSION:
            return Answer(self._codec.no_session(number, request.residue))
        is_reported = place is SequencePlace.AHEAD
        return SILENCE if is_reported else Answer(self._codec.out_of_sequence(self.sequence.expected))

    def _open(self, request: DecodedRequest, *, for_program: bool) -> DecodedRequest | Answer:
        """Begin the session of a `K i s`, or return the error that refuses it."""
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
        """Return a repetition if it is to be executed again, otherwise its answer."""
        if self.state.awaited[number]:
            return PENDING
        outcome = self.sequence.outcome(number)
        if outcome:
            return Answer(self._codec.error(ErrorCode(outcome), number), number)
        repetition = COMMANDS[request.command].repetition
        if repetition is Repeat.READ_AGAIN:
            return request._replace(repeated=True)
        if repetition is Repeat.SILENCE:
            return SILENCE
        if repetition is Repeat.KEPT and not self._fits(request):
            return Answer(self._codec.error(ErrorCode.OUT_OF_RANGE, number), number)
        return Answer(self._codec.response(request, self._once_more(request, number)), number)

    def _fits(self, request: DecodedRequest) -> bool:
        """Return whether the address and the count or words of a destructive read are in this gateway's ranges."""
        info = self._codec.info
        address: int = request.values[0]
        words: tuple[int, ...] = request.values[1:]
        if request.command == "RQ":
            return address < 1 << info.address_bits and 1 <= words[0] <= info.block_words
        return address < 1 << info.address_bits and max(words) < 1 << info.data_bits

    def _once_more(self, request: DecodedRequest, number: int) -> int | list[int] | None:
        """Return the fields of the answer to a repetition after its ID; None if it has none."""
        if request.command == "H":
            return self.state.failed
        kept = self.state.kept
        if request.command == "WK":
            return kept[number % MOST_KEPT_WORDS]
        if request.command == "RQ":
            return [kept[place % MOST_KEPT_WORDS] for place in range(number, number + request.values[1])]
        return None
