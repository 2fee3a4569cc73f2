"""The words of several signals of one gateway, read and decoded together."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from unity_link.data.laps import ColumnLaps
from unity_link.errors import ArgumentError, GatewayError
from unity_link.link.asked import most_words, read_blocks
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

MOST_BLOCKS = 8
"""Most blocks with which a group is read; a group with more runs of addresses is read word by word."""


class _Requests(NamedTuple):
    """The requests that read the words at some addresses."""

    most: int
    """Most words of a block, for which the requests were chosen."""
    single: NDArray[np.uint64]
    """Addresses that are read with one request each."""
    blocks: list[range]
    order: NDArray[np.intp] | None
    """Place of each address among the words of all requests; None if they are in the order of the addresses."""

    @classmethod
    def of(cls, addresses: Sequence[int], parts: Sequence[range], most: int) -> _Requests:
        """Choose the requests.

        Args:
            addresses: addresses of all words.
            parts: addresses of each value. A value of several words is read in one bus transaction; otherwise its
                words could be of different instants.
            most: most words of a block.
        """
        runs: list[range] = []
        for part in sorted(parts, key=lambda one: (one.start, one.stop)):
            if runs and part.start <= runs[-1].stop and part.stop <= runs[-1].start + most:
                runs[-1] = range(runs[-1].start, max(part.stop, runs[-1].stop))
            else:
                runs.append(part)
        # Many short blocks take longer than single words, which are all read in one batch.
        blocks = runs if len(runs) <= MOST_BLOCKS else [part for part in parts if len(part) > 1]
        of_blocks = [address for block in blocks for address in block]
        in_blocks = set(of_blocks)
        single = [address for address in addresses if address not in in_blocks]
        places = {address: place for place, address in enumerate([*single, *of_blocks])}
        order = [places[address] for address in addresses]
        is_sorted = order == [*range(len(order))]
        return cls(most, np.array(single, np.uint64), blocks, None if is_sorted else np.array(order))


class GroupLayout:
    """Signals behind one link, and the words that contain them, each address once."""

    def __init__(self, proxies: Sequence[Proxy[Any]]) -> None:
        """Lay out signals of one link.

        Raises:
            ArgumentError: for a signal that can only be written.
        """
        self.proxies = tuple(proxies)
        self.places = {proxy: place for place, proxy in enumerate(proxies)}
        for proxy in proxies:
            if not proxy.signal.access.reads:
                raise ArgumentError(f"{proxy.path} can only be written")
        signals = [proxy.signal for proxy in proxies]
        self.addresses = tuple(dict.fromkeys(address for signal in signals for address in signal.addresses))
        self._parts = tuple(dict.fromkeys(signal.addresses for signal in signals))
        self._requests: _Requests | None = None
        self._columns = Columns(signals, self.addresses)
        # Look up `_last` here, once: dozens of signals in thousands of batches per second would look it up, and an
        # attribute of a class with `__getattr__` takes longer to find than the rest of `Batch.see` takes.
        self.lasts = [(proxy, proxy._last) for proxy in proxies]  # noqa: SLF001  (private to the package)
        # Signals that other signals follow come first.
        self._wrapping = sorted(
            (proxy for proxy in proxies if proxy.laps is not None), key=lambda proxy: proxy.signal.laps_of != proxy.path
        )
        self._named = [(place, proxy) for place, proxy in enumerate(proxies) if proxy.signal.kind.enumeration]

    def __reduce__(self) -> Any:
        # The last values stay with the proxies of this program.
        return GroupLayout, (self.proxies,)

    @property
    def link(self) -> Link:
        """Link of the signals. Raise an error if they were unpickled, because they have none."""
        return self.proxies[0].link

    def check_registers(self) -> None:
        """Check that all signals can be read repeatedly.

        Raises:
            ArgumentError: for the port of a queue, and for a signal that a read clears.
        """
        self.check_sampled()
        for proxy in self.proxies:
            if proxy.signal.fifo:
                raise ArgumentError(f"{proxy.path} is the port of a queue, from which each read takes a word")

    def check_sampled(self) -> None:
        """Check that reading the signals loses nothing but words of queues.

        Raises:
            ArgumentError: for a signal that a read clears.
        """
        for proxy in self.proxies:
            if proxy.signal.effect is Effect.CLEAR_ON_READ:
                raise ArgumentError(f"{proxy.path} is cleared by each read, and is read by its `get` alone")

    async def read(self) -> Words:
        """Read all words, runs of consecutive addresses by blocks; shape (addresses,).

        Raises:
            ArgumentError: as by `check_registers`.
            GatewayError: the error of the first word that fails.
        """
        self.check_registers()
        link = self.link
        most = most_words(link)
        if self._requests is None or self._requests.most != most:
            self._requests = _Requests.of(self.addresses, self._parts, most)
        single, blocks, order = self._requests[1:]
        reads = [link.read_many(single)] if len(single) else []
        reads += [read_blocks(link, blocks)] if blocks else []
        try:
            words = await reads[0] if len(reads) == 1 else np.concatenate(await gather(*reads))
        except GatewayError:
            # The error of a block does not name the word that failed, so read the words one by one.
            if blocks:
                await link.read_many(self.addresses)
            raise
        return words if order is None else words[order]

    def row(self, words: Words) -> list[Any]:
        """Return the values decoded from words of shape (addresses,), in the order of the proxies."""
        row = self._columns.row(words)
        for place, proxy in self._named:
            row[place] = proxy.scalar(row[place])
        for proxy in self._wrapping:
            place = self.places[proxy]
            row[place] = proxy.counted(row[place])
        return row

    def laps(self) -> ColumnLaps | None:
        """Return counters of rounds for a new stream of samples, starting from the last values; None without WRAPS."""
        if not self._wrapping:
            return None
        bases = [
            proxy if proxy.signal.laps_of in {None, proxy.path} else proxy.robot[proxy.signal.laps_of]
            for proxy in self.proxies
        ]
        known: dict[Hashable, Laps] = {base: base.laps for base in bases if base.laps is not None}
        return ColumnLaps([proxy.signal for proxy in self.proxies], self.addresses, self.proxies, bases, known)

    def columns(self, words: Words) -> dict[Proxy[Any], NDArray[Any]]:
        """Return the values decoded from words of shape (samples, addresses), by proxy, each of shape (samples,)."""
        return dict(zip(self.proxies, self._columns.columns(words), strict=True))
