"""How fast is a read in Octave, one after the other, beside a bare program in C on the same pseudo-terminal?"""

from __future__ import annotations

from typing import TYPE_CHECKING

from benchmarks.generated_clients import c_program, octave_package, row, seconds_bare, seconds_in_octave
from benchmarks.measure import compare
from benchmarks.responder import responder

if TYPE_CHECKING:
    from benchmarks.measure import Row

READS = 2000
MOST = 1.67
"""Of 0.1 ms to 0.06."""


async def measure() -> Row:
    """Compare the generated client with `write` and `read` of the same bytes, median of the round trips."""
    with responder() as path, c_program() as program, octave_package() as package:
        pair = await compare(
            lambda: seconds_in_octave(package, path, READS),
            lambda: seconds_bare(program, path, READS),
        )
    return row("A read in Octave, one after the other, beside a bare program in C", pair, MOST)
