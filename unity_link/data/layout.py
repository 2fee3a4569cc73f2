"""The words of some signals of one gateway, read and decoded together."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from unity_link.data.laps import ColumnLaps
from unity_link.errors import ArgumentError
from unity_link.link.runtimes.synchronisation import gather
from unity_link.spec import Effect
from unity_link.spec.columns import Columns

if TYPE_CHECKING:
    from collections.abc import Hashable, Sequence

    from numpy.typing import NDArray

    from unity_link.data.laps import Laps
    from unity_link.data.proxies import Proxy
    from unity_link.link.link import Link
    from unity_link.protocol.wire.arrays import Words


class GroupLayout:
    """Signals behind one link, and the words that they stand in, each address once."""

    def __init__(self, proxies: Sequence[Proxy[Any]]) -> None:
        """Lay out signals of one link.

        Raises:
            ArgumentError: for one that cannot be read like a register.
        """
        self.proxies = tuple(proxies)
        self.places = {proxy: place for place, proxy in enumerate(proxies)}
        for proxy in proxies:
            if not proxy.signal.access.reads:
                raise ArgumentError(f"{proxy.path} can only be written")
        signals = [proxy.signal for proxy in proxies]
        self.addresses = tuple(dict.fromkeys(address for signal in signals for address in signal.addresses))
        self._array = np.array(self.addresses, np.uint64)
        # A value of several words must be read in one bus transaction, or it may be of two instants.
        self._wide = tuple(dict.fromkeys(signal.addresses for signal in signals if signal.words > 1))
        self._columns = Columns(signals, self.addresses)
        # Thousands of batches of dozens of signals may come a second, and to find an attribute of a class that has a
        # `__getattr__` takes longer than all else that `Batch.see` does.
        self.lasts = [(proxy, proxy._last) for proxy in proxies]  # noqa: SLF001  (once; nobody else is to see it)
        # Those that count for others first.
        self._wrapping = sorted(
            (proxy for proxy in proxies if proxy.laps is not None), key=lambda proxy: proxy.signal.laps_of != proxy.path
        )
        self._named = [(place, proxy) for place, proxy in enumerate(proxies) if proxy.signal.kind.enumeration]

    def __reduce__(self) -> Any:
        # What signals have seen last is theirs.
        return GroupLayout, (self.proxies,)

    @property
    def link(self) -> Link:
        """Link that they are behind; raise an error where they come out of a pickle."""
        return self.proxies[0].link

    def check_registers(self) -> None:
        """Check that all can be read again and again.

        Raises:
            ArgumentError: for the port of a queue, and for what a read clears.
        """
        self.check_sampled()
        for proxy in self.proxies:
            if proxy.signal.fifo:
                raise ArgumentError(f"{proxy.path} is the port of a queue, from which each read takes a word")

    def check_sampled(self) -> None:
        """Check that a sample takes nothing for good but words of queues.

        Raises:
            ArgumentError: for what a read clears.
        """
        for proxy in self.proxies:
            if proxy.signal.effect is Effect.CLEAR_ON_READ:
                raise ArgumentError(f"{proxy.path} is cleared by each read, and is read by its `get` alone")

    async def read(self) -> Words:
        """Read all words in one pipelined batch; shape (addresses,).

        Raises:
            ArgumentError: as by `check_registers`.
        """
        self.check_registers()
        if not self._wide:
            return await self.link.read_many(self._array)
        apart = {address for addresses in self._wide for address in addresses}
        single = [address for address in self.addresses if address not in apart]
        parts = [(addresses, self.link.read_block(addresses.start, len(addresses))) for addresses in self._wide]
        many = [(single, self.link.read_many(single))] if single else []
        wanted = [*many, *parts]
        words = await gather(*(reading for _, reading in wanted))
        found = {
            address: int(word)
            for (addresses, _), part in zip(wanted, words, strict=True)
            for address, word in zip(addresses, part, strict=True)
        }
        return np.array([found[address] for address in self.addresses], np.uint64)

    def row(self, words: Words) -> list[Any]:
        """Return the values in words of shape (addresses,), in the order of the proxies."""
        row = self._columns.row(words)
        for place, proxy in self._named:
            row[place] = proxy.scalar(row[place])
        for proxy in self._wrapping:
            place = self.places[proxy]
            row[place] = proxy.counted(row[place])
        return row

    def laps(self) -> ColumnLaps | None:
        """Return the rounds of a stream of samples, from the last values; None without a signal with WRAPS."""
        if not self._wrapping:
            return None
        bases = [
            proxy if proxy.signal.laps_of in {None, proxy.path} else proxy.robot[proxy.signal.laps_of]
            for proxy in self.proxies
        ]
        known: dict[Hashable, Laps] = {base: base.laps for base in bases if base.laps is not None}
        return ColumnLaps([proxy.signal for proxy in self.proxies], self.addresses, self.proxies, bases, known)

    def columns(self, words: Words) -> dict[Proxy[Any], NDArray[Any]]:
        """Return the values in words of shape (samples, addresses), by their proxies, each of shape (samples,)."""
        return dict(zip(self.proxies, self._columns.columns(words), strict=True))
