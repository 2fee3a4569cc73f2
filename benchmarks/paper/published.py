"""Every figure of the paper that anything here quotes, in the paper's own terms: all of its Table I, and its text's.

A. B. Lange, U. P. Schultz, A. S. Soerensen: "Unity-Link: A Software-Gateway Interface for Rapid Prototyping of
Experimental Robot Controllers on FPGAs". Measured there on a board: gateware at 50 MHz, an FT232H as asynchronous FT245
with FIFOs of 256 bytes, a PC of two cores at 3 GHz. Tables and pictures take their figures from here, and
`tests/benchmarks/test_quotes.py` holds to it what documents quote.

What must be known to read Table I:

- Its latencies are in microseconds, as the text says; the table's heads have seconds.
- Every write of it is answered: the paper has no stateless writes, and wishes for them (VI-D).
- Throughputs are of the PC by the text: (i) what it gets, (o) what it sends. In the gateware's rows they are of the
  gateware, though: 85.7 to 200.0 is 6 to 14, the bytes of a read's request and answer, and 151.3 to 54.1 is 14 to 5,
  those of a write. So the answers to pipelined reads are the 200.0 Mb/s.
- A burst of its writes takes 9 bytes a write, by its own figures (1.315 us at 56.6 Mb/s), where a checked write has 14.
- The latency timer is not told. Without send-immediate, 974 us are those of a timer of 1 ms.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

import msgspec

if TYPE_CHECKING:
    from collections.abc import Iterator

Level = Literal["gateware", "ideal link", "low-level", "full stack", "ROS", "design"]
"""The paper's three levels, and the row between the first two, which it has for reference; the ROS nodes on top; and
what a design is or was made of."""
Access = Literal["read", "write"]
Mode = Literal["off", "always"]
"""Without and with its send-immediate, SI."""
Unit = Literal[
    "us", "b/s", "Hz", "baud", "bit", "bytes", "requests", "messages", "writes", "lines", "minutes", "groups", "words"
]


class Figure(msgspec.Struct, frozen=True, kw_only=True):
    """One figure."""

    what: str
    """Subject, where the rest does not say it."""
    value: float
    unit: Unit
    place: str
    """In the paper: table or section."""
    deviation: float | None = None
    """Standard deviation, where the paper gives it."""
    level: Level
    access: Access | None = None
    mode: Mode | None = None
    """None where send-immediate has no part in it."""


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
    # What the gateware can be built with.
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
    """Return a figure, or None where the paper has none."""
    wanted = (what, level, access, mode)
    return next((row for row in FIGURES if (row.what, row.level, row.access, row.mode) == wanted), None)


def value(what: str, level: Level, access: Access | None = None, mode: Mode | None = None) -> float:
    """Return the value of a figure that the paper has."""
    figure = find(what, level, access, mode)
    assert figure is not None, (what, level, access, mode)
    return figure.value
