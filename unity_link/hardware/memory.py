"""Plain memory, or registers that have no proxy of their own: MEMORY in a spec.

Every word reads back what was written last. Offsets are words.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from unity_link.errors import ArgumentError
from unity_link.hardware.module import Module

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from unity_link.protocol.arrays import Words


class Memory(Module):
    """Plain memory."""

    def __len__(self) -> int:
        """Return the number of words."""
        return self._known_size()

    def __bool__(self) -> bool:
        """Be true: a memory is no container of the program's."""
        return True

    async def load(self) -> Words:
        """Read all of it; shape (words,)."""
        return await self.read_block(0, self._known_size())

    async def store(self, values: ArrayLike) -> None:
        """Write all of it, or its beginning."""
        await self.write_block(0, values)

    async def fill(self, value: int = 0) -> None:
        """Write the same word everywhere."""
        await self.write_block(0, np.full(self._known_size(), value, np.uint64))

    def _known_size(self) -> int:
        if self.size is None:
            raise ArgumentError(f"{self!r}: its size is not known; give SIZE in the spec, or size=")
        return self.size
