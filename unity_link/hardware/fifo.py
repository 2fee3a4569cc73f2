"""A queue behind one address: FIFO in a spec.

| offset | read | write |
|---|---|---|
| 0 | takes the oldest word | appends a word |

What an empty or a full queue does is the gateware's business: a bus error, which is raised here, or a wait state.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from unity_link.hardware.module import Module

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from unity_link.hardware.bus import Bus
    from unity_link.protocol.arrays import Words


class Fifo(Module):
    """The port of a queue."""

    SIZE = 1

    def __init__(self, bus: Bus, base: int = 0, *, size: int | None = None, words: int | None = None) -> None:
        """Stand on a link.

        Args:
            bus: as for `Module`.
            base: address of the port.
            size: as for `Module`.
            words: depth of the queue, where it is known.
        """
        super().__init__(bus, base, size=size)
        self.words = words

    async def take(self, count: int) -> Words:
        """Take `count` words; shape (count,).

        Raises:
            AnswerLostError: where words were taken from the queue, but lost on the way.
            BusError: where the queue had fewer, if the gateware says so; those that it had are gone.
        """
        return await self.bus.read_queue(self.address(0), count)

    async def append(self, values: ArrayLike) -> None:
        """Append words.

        Raises:
            BusError: where there was no room for all, if the gateware says so; the first ones were appended.
        """
        await self.bus.write_queue(self.address(0), np.atleast_1d(np.asarray(values)))
