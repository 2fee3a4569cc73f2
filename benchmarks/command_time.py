"""How long does a command take? `make bench-beside REVISION=a3abcb1` compares with its time at that revision."""

from __future__ import annotations

from benchmarks.measure import Row, compare
from benchmarks.starting import ASYNCIO, programs

MOST = 3.3
"""About 60 % of the ratio at a3abcb1."""
_COMMAND = ("from unity_link.cli import main; main()", "read", "sim:", "0x10")


async def measure() -> Row:
    """Compare a command that reads a word with a program that imports asyncio."""
    with programs() as program:
        pair = await compare(program(*_COMMAND), program(ASYNCIO))
    return Row(
        "`unity-link read sim: 0x10`, beside `import asyncio` (whole processes)",
        f"{1e3 * pair.ours:.0f} ms",
        f"{1e3 * pair.bare:.0f} ms",
        f"{pair.ratio:.2f}",
        f"ratio at most {MOST}",
        pair.ratio <= MOST,
        pair.processor,
    )
