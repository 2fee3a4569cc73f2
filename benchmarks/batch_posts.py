"""How many writes a second does one `post_many` reach?"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from benchmarks.expected import ADDRESS
from benchmarks.posts import measure_posts

if TYPE_CHECKING:
    from benchmarks.measure import Row
    from unity_link import Link

POSTS = 200_000
LEAST = 1_500_000


async def measure() -> Row:
    """Compare a batch of posted writes and `fence` with as many reads through a bare loop, 128 of them in flight."""
    values = np.arange(POSTS)
    addresses = np.full(POSTS, ADDRESS)

    async def post(link: Link) -> None:
        await link.post_many(addresses, values)

    return await measure_posts("post_many", POSTS, LEAST, post)
