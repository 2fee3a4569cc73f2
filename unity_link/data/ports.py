"""A signal that is the port of a queue: reads take values from it, writes append some."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic, cast

import numpy as np

from unity_link.data.proxies import Proxy, S, T
from unity_link.data.signals import SampledSignal
from unity_link.errors import ArgumentError
from unity_link.protocol.wire.numbers import whole_number

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


class ReadPort(SampledSignal[T]):
    """A queue that can be read. Where its group is published on a trigger, each sample has a word that it took."""

    __slots__ = ()

    async def take(self, count: int) -> NDArray[Any]:
        """Take `count` values; shape (count,), those of an enumeration as numbers.

        Raises:
            BusError: where the queue had fewer, if the gateware says so; those that it had are gone.
        """
        signal = self.signal
        size = whole_number(count, "a number of words")
        words = (await self.bus.read_queue(signal.address, size * signal.words)).astype(np.uint64)
        raw = np.zeros(size, np.uint64)
        for part in range(signal.words):
            raw |= words[part :: signal.words] << np.uint64(part * signal.word_bits)
        values = signal.kind.decode_array(raw >> np.uint64(signal.lowest_bit) & np.uint64((1 << signal.width) - 1))
        self.see(self.scalars(values[-1:])[0])
        return values

    async def get(self) -> T:
        """Take one value."""
        return self.scalars((await self.take(1))[:1])[0]


class WritePort(Proxy[T], Generic[T, S]):
    """A queue that can be written, of values `T`; it takes `S`, as `Writable`."""

    __slots__ = ()

    async def append(self, values: ArrayLike) -> None:
        """Append values.

        Raises:
            ArgumentError: for a value outside of the limits, or that the kind cannot say. Nothing was sent.
            BusError: where there was no room for all, if the gateware says so; the first ones were appended.
        """
        signal = self.signal
        given = np.atleast_1d(signal.kind.array(values))
        try:
            raw = signal.kind.encode_array(given)
        except ArgumentError as error:
            raise ArgumentError(f"{signal.path}: {error}") from None
        if signal.minimum is not None or signal.maximum is not None:
            self._check_limits(given)
        whole = raw << np.uint64(signal.lowest_bit)
        mask = np.uint64((1 << signal.word_bits) - 1)
        parts = [whole >> np.uint64(part * signal.word_bits) & mask for part in range(signal.words)]
        await self.bus.write_queue(signal.address, np.stack(parts, axis=-1).ravel())
        self.see(self.scalars(signal.kind.decode_array(raw.ravel()[-1:]))[0])

    def _check_limits(self, values: NDArray[Any]) -> None:
        low, high = self.signal.limits
        # NaN lies within no limits.
        outside = ~((values >= low) & (values <= high))
        if outside.any():
            raise self.signal.beyond_limits(values[outside][0])

    async def set(self, value: S) -> None:
        """Append one value."""
        signal = self.signal
        words = signal.encode(cast("Any", value))
        await self.bus.write_queue(signal.address, words)
        self.see(self.scalar(signal.decode(words)))


class Port(ReadPort[T], WritePort[T, S]):
    """A queue that can be read and written."""

    __slots__ = ()
