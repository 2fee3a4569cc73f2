"""Every figure of the paper that is quoted here, in the paper's own terms: all of its Table I, and those of its text.

A. B. Lange, U. P. Schultz, A. S. Soerensen: "Unity-Link: A Software-Gateway Interface for Rapid Prototyping of
Experimental Robot Controllers on FPGAs". It measured on a board: gateware at 50 MHz, an FT232H as asynchronous FT245
with FIFOs of 256 bytes, a PC with two cores at 3 GHz. Tables and pictures use the figures of this module, and
`tests/benchmarks/test_quotes.py` compares the quotes in documents with them.

To read Table I:

- Its latencies are in microseconds, as the text has it; the heads of the table have seconds.
- Every write in it is answered: the paper has no posted writes, and mentions them as future work (VI-D).
- According to the text, throughputs are those of the PC: (i) its input, (o) its output. But in the gateware's rows they
  are those of the gateware: 85.7 to 200.0 is 6 to 14, the bytes of a read's request and answer, and 151.3 to 54.1 is 14
  to 5, the bytes of a write's. So the answers to pipelined reads are the 200.0 Mb/s.
- According to its own figures, a burst of writes takes 9 bytes per write (1.315 us at 56.6 Mb/s), but a checked write
  has 14.
- The latency timer is not given. The 974 us without send-immediate are those of a timer of 1 ms.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

import msgspec

if TYPE_CHECKING:
    from collections.abc import Iterator

Level = Literal["gateware", "ideal link", "low-level", "full stack", "ROS", "design"]
"""The paper's three levels, the row between the first two (for reference), the ROS nodes, and facts about designs."""
Access = Literal["read", "write"]
Mode = Literal["off", "always"]
"""Without and with the paper's send-immediate, SI."""
Unit = Literal[
    "us", "b/s", "Hz", "baud", "bit", "bytes", "requests", "messages", "writes", "lines", "minutes", "groups", "words"
]


class Figure(msgspec.Struct, frozen=True, kw_only=True):
    """One figure."""

    what: str
    """Subject, if the other fields do not identify it."""
    value: float
    unit: Unit
    place: str
    """Table or section of the paper."""
    deviation: float | None = None
    """Standard deviation, if the paper has it."""
    level: Level
    access: Access | None = None
    mode: Mode | None = None
    """None if the figure does not depend on send-immediate."""


LATENCY = "latency, request to response"
EFFECT = "latency, request to effect"
REQUESTS = "requests, pipelined"
ANSWERS = "answers, pipelined"
LINE = "each direction"
SYNCHRONOUS = "requests and answers, one at a time"
BURST_ANSWERS = "answers of a burst"
BURST_REQUESTS = "requests of a burst of 30"
BURST_PERIOD = "from effect to effect in a burst of 30"
TO_ROS, FROM_ROS = "one integer, gateway to ROS, counted by rostopic", "one integer, Python script to gateway"


def _subtable(access: Access, mode: Mode, *rows: tuple[Level, str, float, float | None]) -> Iterator[Figure]:
    place = f"Table I, {access.capitalize()}{':SI' if mode == 'always' else ''}"
    for level, what, value, deviation in rows:
        yield Figure(
            what=what,
            value=value,
            unit="us" if what in (LATENCY, EFFECT, BURST_PERIOD) else "b/s",
            place=place,
            deviation=deviation,
            level=level,
            access=access,
            mode=mode,
        )


_READ_GATEWARE: tuple[tuple[Level, str, float, float | None], ...] = (
    ("gateware", LATENCY, 1.14, None),
    ("gateware", REQUESTS, 85.7e6, None),
    ("gateware", ANSWERS, 200.0e6, None),
    ("ideal link", LATENCY, 3.524, None),
    ("ideal link", LINE, 67.1e6, None),
)
_WRITE_GATEWARE: tuple[tuple[Level, str, float, float | None], ...] = (
    ("gateware", LATENCY, 1.26, None),
    ("gateware", EFFECT, 0.84, None),
    ("gateware", REQUESTS, 151.3e6, None),
    ("gateware", ANSWERS, 54.1e6, None),
    ("ideal link", LINE, 67.1e6, None),
)
TABLE_1: tuple[Figure, ...] = (
    *_subtable(
        "read",
        "off",
        *_READ_GATEWARE,
        ("low-level", LATENCY, 974, 120),
        ("low-level", SYNCHRONOUS, 164.3e3, None),
        ("low-level", BURST_ANSWERS, 889.8e3, None),
        ("full stack", LATENCY, 1072, 17.5),
        ("full stack", SYNCHRONOUS, 149.2e3, None),
    ),
    *_subtable(
        "read",
        "always",
        *_READ_GATEWARE,
        ("low-level", LATENCY, 223.6, 9.06),
        ("low-level", SYNCHRONOUS, 715.6e3, None),
        ("low-level", BURST_ANSWERS, 639.1e3, None),
        ("full stack", LATENCY, 652, 11.7),
        ("full stack", SYNCHRONOUS, 245.6e3, None),
    ),
    *_subtable(
        "write",
        "off",
        *_WRITE_GATEWARE,
        ("low-level", LATENCY, 971, 76.81),
        ("low-level", EFFECT, 19.9, 3.77),
        ("low-level", SYNCHRONOUS, 156.5e3, None),
        ("low-level", BURST_PERIOD, 1.315, None),
        ("low-level", BURST_REQUESTS, 56.6e6, None),
        ("full stack", LATENCY, 1058, 16.64),
        ("full stack", SYNCHRONOUS, 143.7e3, None),
    ),
    *_subtable(
        "write",
        "always",
        *_WRITE_GATEWARE,
        ("low-level", LATENCY, 221.74, 5.89),
        ("low-level", EFFECT, 19.03, 3.07),
        ("low-level", SYNCHRONOUS, 685.5e3, None),
        ("low-level", BURST_PERIOD, 1.159, None),
        ("low-level", BURST_REQUESTS, 62.5e6, None),
        ("full stack", LATENCY, 553, 34.86),
        ("full stack", SYNCHRONOUS, 274.9e3, None),
    ),
)


def _text(
    place: str,
    level: Level,
    what: str,
    value: float,
    unit: Unit,
    access: Access | None = None,
    mode: Mode | None = None,
) -> Figure:
    return Figure(what=what, value=value, unit=unit, place=place, level=level, access=access, mode=mode)


MOST_REQUESTS = "most requests in one transfer"
STAMPED_MEAN = "answers of such a burst, by the gateway's timestamps, on average"
STAMPED_RUN = "the same between two slow-downs"
RUN_LENGTH, RUN_TIME = "from slow-down to slow-down: answers", "from slow-down to slow-down: time"
TEXT: tuple[Figure, ...] = (
    # The setup.
    _text("VI-A", "design", "a word", 32, "bit"),
    _text("VI-A", "design", "an address", 8, "bit"),
    _text("VI-A", "design", "clock", 50e6, "Hz"),
    _text("VI-A", "design", "UART, slow", 1e6, "baud"),
    _text("VI-A", "design", "UART, medium", 6e6, "baud"),
    _text("VI-A", "design", "UART, fast", 12e6, "baud"),
    _text("VI-A", "ideal link", "asynchronous FT245, as a serial port", 64e6, "b/s"),
    _text("VI-A", "design", "small FIFOs", 16, "bytes"),
    _text("VI-A", "design", "large FIFOs", 256, "bytes"),
    _text("III-D", "ideal link", "with D2XX drivers", 320e6, "b/s"),
    # The limits of the gateware's configuration.
    _text("IV-A", "design", "subscription groups", 256, "groups"),
    _text("IV-A", "design", "addresses of a group, words of RM", 255, "words"),
    # Bursts of reads, from low-level Python.
    _text("VI-B", "low-level", MOST_REQUESTS, 200, "requests", "read", "off"),
    _text("VI-B", "low-level", MOST_REQUESTS, 18, "requests", "read", "always"),
    _text("VI-B", "low-level", "answers of that burst", 252, "bytes", "read", "always"),
    _text("VI-B", "gateware", "output FIFO, in its use", 255, "bytes"),
    _text("VI-B", "gateware", "timer of the timestamps", 50e6, "Hz"),
    _text("VI-B", "gateware", STAMPED_MEAN, 35.3e6, "b/s", "read", "off"),
    _text("VI-B", "gateware", STAMPED_RUN, 64.2e6, "b/s", "read", "off"),
    _text("VI-B", "gateware", RUN_LENGTH, 36, "messages", "read", "off"),
    _text("VI-B", "gateware", RUN_TIME, 62.14, "us", "read", "off"),
    _text("VI-B", "gateware", STAMPED_MEAN, 121.8e6, "b/s", "read", "always"),
    # Writes, from low-level Python. Table I has 62.5 for the last.
    _text("VI-B", "low-level", "roughly, to the effect", 20, "us", "write"),
    _text("VI-B", "low-level", "a burst", 30, "writes", "write"),
    _text("VI-B", "low-level", "requests of a burst of 30, in the text", 62.4e6, "b/s", "write", "always"),
    # ROS.
    _text("VI-C", "ROS", TO_ROS, 1.8e3, "Hz"),
    _text("VI-C", "ROS", FROM_ROS, 0.3e3, "Hz"),
    # The 18-DOF walker.
    _text("III-B", "design", "specification", 23, "lines"),
    _text("III-B", "design", "configuration in VHDL", 14, "lines"),
    _text("III-B", "design", "boilerplate in VHDL", 32, "lines"),
    _text("III-B", "design", "communication in C, the other solution", 58, "lines"),
    _text("III-B", "design", "hardware control in C and assembler, the other solution", 82, "lines"),
    _text("III-B", "design", "to design the FPGA, less than", 20, "minutes"),
    _text("III-B", "design", "to write the specification, less than", 10, "minutes"),
)
FIGURES = TABLE_1 + TEXT


def find(what: str, level: Level, access: Access | None = None, mode: Mode | None = None) -> Figure | None:
    """Return a figure, or None if the paper does not have it."""
    wanted = (what, level, access, mode)
    return next((row for row in FIGURES if (row.what, row.level, row.access, row.mode) == wanted), None)


def value(what: str, level: Level, access: Access | None = None, mode: Mode | None = None) -> float:
    """Return the value of a figure, which the paper must have."""
    figure = find(what, level, access, mode)
    assert figure is not None, (what, level, access, mode)
    return figure.value
