"""How long does a program wait for `import unity_link`?"""

from __future__ import annotations

from benchmarks.measure import Row, compare
from benchmarks.starting import ASYNCIO, programs

MOST = 3


async def measure() -> Row:
    """Compare a program that imports the package with one that imports asyncio."""
    with programs() as program:
        pair = await compare(program("import unity_link"), program(ASYNCIO))
    return Row(
        "`import unity_link`, beside `import asyncio` (whole processes)",
        f"{1e3 * pair.ours:.0f} ms",
        f"{1e3 * pair.bare:.0f} ms",
        f"{pair.ratio:.2f}",
        f"ratio at most {MOST}",
        pair.ratio <= MOST,
        pair.processor,
    )
