"""Requests that a program makes without waiting, to look at their answers when it comes by again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from unity_link.link.link import Link
    from unity_link.protocol.wire.arrays import Words


async def post_in_session(link: Link, address: int, value: int) -> None:
    """Post a write that ends with the session under way: if it waits for room then, it is never sent."""
    await link._post_for(link._caller(), address, value, of_session=True)  # noqa: SLF001  (the same package)


def most_words(link: Link) -> int:
    """Return the most words of one request: ``gateway.block_words``, or over UDP as many as a datagram holds."""
    return link._flow.block_words  # noqa: SLF001  (the same package)


async def read_blocks(link: Link, blocks: Sequence[range]) -> Words:
    """Read blocks of consecutive addresses, each of at most `most_words` words and in one bus transaction.

    Returns:
        The words of all blocks, shape (words,).

    Raises:
        GatewayError: the first error.
        LinkLostError: if the link has ended.
    """
    return await link._read_blocks(blocks)  # noqa: SLF001  (the same package)


class Asked:
    """A request that is on its way, or waits for room behind those before it; one transaction of the bus.

    Args:
        link: an open link.
        address: of the first of the consecutive words that are read or written.
        count: number of words to read, at most `most_words`.
        write: words to write in place of that, at most as many.
        to_queue: whether all are written to the first address, the port of a queue.

    Raises:
        LinkLostError: where the link has ended.
        UnsupportedError: for the port of a queue, where the gateway was built without queue commands.
    """

    def __init__(
        self, link: Link, address: int, count: int = 0, *, write: Sequence[int] = (), to_queue: bool = False
    ) -> None:
        begin = link._begin_block  # noqa: SLF001  (the same room)
        self._waiter, self._cancel = begin(address, count, write, to_queue=to_queue)

    def done(self) -> bool:
        """Return whether the answer is there."""
        return self._waiter.done()

    async def words(self) -> list[int]:
        """Return the words that were read; waits for the answer where it is not there yet.

        Raises:
            LinkLostError: where the link has ended.
            GatewayError: where the gateway refused the request.
        """
        answer: Any = await self._waiter
        return [] if answer is None else [int(word) for word in answer]

    def give_up(self) -> None:
        """Want the answer no more: what waits for room is not sent."""
        self._cancel()
        if not self._waiter.cancel() and not self._waiter.cancelled():
            # Retrieved, so that the event loop does not log it as never retrieved.
            self._waiter.exception()
