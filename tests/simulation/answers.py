"""The order of answers on a line without losses: that of the requests, as from a gateway with one client."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from simulation.oracle import RuleError
from unity_link.protocol.wire.compact import text_of

if TYPE_CHECKING:
    from collections.abc import Iterable

    from unity_link.protocol.wire.configuration import GatewayInfo

_NOT_EXPECTED = b"n"


class Answers:
    """The answers on one line.

    Args:
        line: name of the line.
        info: configuration of the gateway.
    """

    def __init__(self, line: str, info: GatewayInfo) -> None:
        digits = info.id_digits
        self._line, self._info = line, info
        self._under_way_size = 1 + info.session_digits + info.crc_bits // 4
        """Characters of the answer to a session query."""
        # Requests may be refused in any order while there is no session.
        self._answer = re.compile(rb"(?!x[0-9A-F]{%d}0A)([g-z]+)([0-9A-F]{%d})" % (digits, digits))
        self._question = re.compile(rb"(h|ws)([0-9A-F]{%d})" % digits)
        self._ring = 16**digits
        self.begin()

    def begin(self) -> None:
        """Start on a new connection."""
        self._rest = self._rest_asked = b""
        self._text_of, self._text_asked = (text_of(self._info, from_gateway=side) for side in (True, False))
        self._begin_session()

    def _begin_session(self) -> None:
        self._last = -1
        self._told = bytearray(self._ring)
        """For each ID of the last half of the sequence space, 1 if it was answered or may be answered again."""
        self._posted = bytearray(self._ring)
        """For each of these IDs, 1 if its request is a posted write."""

    def take(self, data: bytes) -> None:
        """Take bytes that arrive at the program.

        Raises:
            RuleError: if an answer that was not given before follows an answer to a later request.
        """
        *lines, self._rest = (self._rest + self._text_of(data)).split(b"\n")
        for line in lines:
            if line.startswith(b"K") and len(line) != self._under_way_size:
                self._begin_session()
            elif (answer := self._answer.match(line)) is not None and answer[1] != _NOT_EXPECTED:
                self._take_answer(int(answer[2], 16), line)

    def take_asked(self, data: bytes) -> None:
        """Take bytes of the program: an `h` may query the outcome of an earlier request.

        A repeated posted write is such a query too, even after requests without an answer.
        """
        *lines, self._rest_asked = (self._rest_asked + self._text_asked(data)).split(b"\n")
        for line in lines:
            question = self._question.match(line)
            if question is None:
                continue
            number, posts = int(question[2], 16), question[1] == b"ws"
            if self._posted[number] if posts else not self._is_ahead(number):
                self._told[number] = 1
            self._posted[number] |= posts

    def _is_ahead(self, number: int) -> bool:
        return self._last < 0 or 0 < (number - self._last) % self._ring < self._ring // 2

    def _take_answer(self, number: int, line: bytes) -> None:
        if self._is_ahead(number):
            self._last = number
        elif not self._told[number]:
            raise RuleError("answers in another order", f"{self._line}: {line!r} comes behind {self._last:#x}")
        self._told[number] = 1
        opposite = (number + self._ring // 2) % self._ring
        self._told[opposite] = self._posted[opposite] = 0


def judge_answers(trace: Iterable[tuple[object, ...]], gateways: dict[str, GatewayInfo]) -> None:
    """Check the answers on all lines for which a gateway is named, from the bytes in the trace."""
    answers = {line: Answers(line, info) for line, info in gateways.items()}
    takers = {f"{line}<": taker.take for line, taker in answers.items()}
    takers |= {f"{line}>": taker.take_asked for line, taker in answers.items()}
    for _, name, kind, *what in trace:
        if kind == "carry" and name in takers:
            data = what[0]
            assert isinstance(data, bytes)
            takers[str(name)](data)
        elif kind == "connect" and name in answers:
            answers[str(name)].begin()
