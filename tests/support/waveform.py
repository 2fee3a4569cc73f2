"""Reads a waveform (VCD) as far as tests need it: signals by their paths, their values at each rising clock edge."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

_CHANGE = re.compile(r"([01])(\S+)|b([01]+) (\S+)")


class Waveform:
    """A waveform file.

    Args:
        path: of the file.
    """

    def __init__(self, path: Path) -> None:
        head, _, self._body = path.read_text().partition("$enddefinitions $end\n")
        self.timescale = re.findall(r"\$timescale (.*?) \$end", head)
        self.signals: dict[str, tuple[str, int]] = {}
        """Identifier and width in bits of each signal, by its path."""
        scope: list[str] = []
        for kind, text in re.findall(r"\$(scope|upscope|var) ?(.*?) ?\$end", head):
            words = text.split()
            if kind == "scope":
                scope.append(words[1])
            elif kind == "upscope":
                scope.pop()
            else:
                self.signals[".".join((*scope, words[3]))] = words[2], int(words[1])
        assert scope == []
        assert len({identifier for identifier, _ in self.signals.values()}) == len(self.signals)

    def cycles(self, *names: str) -> Iterator[tuple[int, list[int]]]:
        """Yield the time and the values of signals at each rising edge of the clock."""
        clock = self.signals["unity_link_fifo.clk"][0]
        wanted = [self.signals[f"unity_link_fifo.{name}"][0] for name in names]
        values: dict[str, int] = {}
        last = -1
        for block in re.split(r"^#", self._body, flags=re.MULTILINE)[1:]:
            time, *lines = block.splitlines()
            assert int(time) >= last, "time goes back"
            last = int(time)
            for line in lines:
                if match := _CHANGE.fullmatch(line):
                    values[match[2] or match[4]] = int(match[1] or match[3], 2)
                else:
                    assert line in ("$dumpvars", "$end")
            if f"1{clock}" in lines:
                yield last, [values[identifier] for identifier in wanted]


class Taken(NamedTuple):
    """A byte that passed the pins, with its time in units of the timescale."""

    time: int
    byte: int


def bytes_at_pins(waveform: Waveform, way: str) -> list[Taken]:
    """Return the bytes that passed in one direction, ``in`` or ``out``."""
    return [
        Taken(time, data)
        for time, (valid, ready, data) in waveform.cycles(f"{way}_valid", f"{way}_ready", f"{way}_data")
        if valid and ready
    ]
