"""How fast are reads in Octave, one after the other, compared with a bare C program on the same pseudo-terminal?"""

from __future__ import annotations

from benchmarks.generated_clients import c_program, missing_octave, octave_package, seconds_bare, seconds_in_octave
from benchmarks.measure import Row, compare
from benchmarks.responder import responder

READS = 2000
MOST = 40e-6
"""Seconds above the time of a bare program: 0.1 ms if that takes 0.06 ms."""
missing_tools = missing_octave


async def measure() -> Row:
    """Compare the generated client with `write` and `read` of the same bytes, median of the round trips."""
    with responder() as path, c_program() as program, octave_package() as package:
        pair = await compare(
            lambda: seconds_in_octave(package, path, READS),
            lambda: seconds_bare(program, path, READS),
        )
    return Row(
        "A read in Octave, one after the other, beside a bare program in C",
        f"{pair.ours * 1e6:.1f} us",
        f"{pair.bare * 1e6:.1f} us",
        f"{pair.ratio:.2f}",
        f"at most {MOST * 1e6:.0f} us more",
        pair.ours - pair.bare <= MOST,
        pair.processor,
    )
