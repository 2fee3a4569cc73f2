"""Pending reads and writes: a program submits a request, and collects its answer later."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from unity_link.link.link import Link
    from unity_link.protocol.wire.arrays import Words


async def post_in_session(link: Link, address: int, value: int) -> None:
    """Post a write that belongs to the current session: if it is still queued when the session ends, it is not sent."""
    await link._post_for(link._caller(), address, value, of_session=True)  # noqa: SLF001  (the same package)


def most_words(link: Link) -> int:
    """Return the most words of one request: ``gateway.block_words``, or fewer if a UDP datagram holds fewer."""
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
    """A pending read or write of consecutive words, in one bus transaction.

    Args:
        link: an open link.
        address: address of the first word.
        count: number of words to read, at most `most_words`.
        write: words to write instead of reading, at most `most_words`.
        to_queue: write all words to the same address, the port of a queue.

    Raises:
        LinkLostError: if the link has ended.
        UnsupportedError: if `to_queue` is set and the gateway was built without queue commands.
    """

    def __init__(
        self, link: Link, address: int, count: int = 0, *, write: Sequence[int] = (), to_queue: bool = False
    ) -> None:
        begin = link._begin_block  # noqa: SLF001  (the same package)
        self._waiter, self._cancel = begin(address, count, write, to_queue=to_queue)

    def done(self) -> bool:
        """Return whether the answer or an error has arrived."""
        return self._waiter.done()

    async def words(self) -> list[int]:
        """Wait for the answer, and return the words read; empty for a write.

        Raises:
            LinkLostError: if the link has ended.
            GatewayError: if the gateway refused the request.
        """
        answer: Any = await self._waiter
        return [] if answer is None else [int(word) for word in answer]

    def give_up(self) -> None:
        """Cancel the request: if it is still queued, it is not sent; otherwise its answer is ignored."""
        self._cancel()
        if not self._waiter.cancel() and not self._waiter.cancelled():
            # Retrieved, so that the event loop does not log it as never retrieved.
            self._waiter.exception()
