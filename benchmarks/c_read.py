"""How fast are reads by the client in C, one after the other, compared with a bare program on a pseudo-terminal?"""

from __future__ import annotations

from typing import TYPE_CHECKING

from benchmarks.generated_clients import c_program, row, seconds_bare, seconds_in_c
from benchmarks.measure import compare
from benchmarks.responder import responder

if TYPE_CHECKING:
    from benchmarks.measure import Row

READS = 2000
MOST = 1.3


async def measure() -> Row:
    """Compare the generated client with `write` and `read` of the same bytes, median of the round trips."""
    with responder() as path, c_program() as program:
        pair = await compare(
            lambda: seconds_in_c(program, path, READS),
            lambda: seconds_bare(program, path, READS),
        )
    return row("A read by the client in C, one after the other, beside a bare program in C", pair, MOST)
