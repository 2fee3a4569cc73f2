"""How much of a link's rate remains if eight programs share it, each of which reads in batches?"""

from __future__ import annotations

from typing import TYPE_CHECKING

from benchmarks.shared_link import CLIENTS, compare

if TYPE_CHECKING:
    from benchmarks.measure import Row


async def measure() -> Row:
    """Read by `read_many` in each program."""
    return await compare("batch", f"Reads by {CLIENTS} programs with `read_many`; beside it, by one alone")
