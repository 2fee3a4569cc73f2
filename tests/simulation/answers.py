"""The order of the answers on a line on which nothing is lost: that of the requests, as from a gateway alone."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from simulation.oracle import WorldError

if TYPE_CHECKING:
    from collections.abc import Iterable

_NOT_EXPECTED = b"n"


class Answers:
    """The answers on one line.

    Args:
        line: its name.
        digits: of an ID.
    """

    def __init__(self, line: str, digits: int) -> None:
        self._line = line
        # Where there is no session, requests are refused in any order.
        self._answer = re.compile(rb"(?!x[0-9A-F]{%d}0A)([g-z]+)([0-9A-F]{%d})" % (digits, digits))
        self._ring = 16**digits
        self.begin()

    def begin(self) -> None:
        """Begin on a new connection."""
        self._rest = b""
        self._begin_session()

    def _begin_session(self) -> None:
        self._last = -1
        self._told = bytearray(self._ring)
        """Which IDs of the last half of the ring were answered."""

    def take(self, data: bytes) -> None:
        """Take bytes that arrive at the program.

        Raises:
            WorldError: where an answer comes behind one to a later request, and was not given before.
        """
        *lines, self._rest = (self._rest + data).split(b"\n")
        for line in lines:
            if line.startswith(b"K"):
                self._begin_session()
            elif (answer := self._answer.match(line)) is not None and answer[1] != _NOT_EXPECTED:
                self._take_answer(int(answer[2], 16), line)

    def _take_answer(self, number: int, line: bytes) -> None:
        half = self._ring // 2
        ahead = (number - self._last) % self._ring
        if self._last < 0 or 0 < ahead < half:
            self._last = number
        elif not self._told[number]:
            raise WorldError("answers in another order", f"{self._line}: {line!r} comes behind {self._last:#x}")
        self._told[number] = 1
        self._told[(number + half) % self._ring] = 0


def judge_answers(trace: Iterable[tuple[object, ...]], digits: dict[str, int]) -> None:
    """Judge the answers on all lines that have digits of an ID named, by what they have carried."""
    answers = {line: Answers(line, count) for line, count in digits.items()}
    back = {f"{line}<": taker for line, taker in answers.items()}
    for _, name, kind, *what in trace:
        if kind == "carry" and name in back:
            data = what[0]
            assert isinstance(data, bytes)
            back[str(name)].take(data)
        elif kind == "connect" and name in answers:
            answers[str(name)].begin()
