"""Signals that are ports of queues: a read takes values out, a write appends values."""

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
    """A queue that can be read. If its group is published on a trigger, each sample takes one word out of it."""

    __slots__ = ()

    async def take(self, count: int) -> NDArray[Any]:
        """Take `count` values; shape (count,). Values of an enumeration are numbers.

        Raises:
            BusError: if the queue had fewer values and the gateware reports that; the values that it had are lost.
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
    """A queue of values of type `T` that can be written; its methods accept the type `S`, as those of `Writable`."""

    __slots__ = ()

    async def append(self, values: ArrayLike) -> None:
        """Append values.

        Raises:
            ArgumentError: for a value outside of the limits, or that the kind cannot represent; no value was sent.
            BusError: if the queue had no room for all and the gateware reports that; the first values were added.
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
        # NaN is outside of all limits.
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
