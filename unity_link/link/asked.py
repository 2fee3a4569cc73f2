"""Words that a program asks for without waiting, to look at the answer when it comes by again."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link import protocol
from unity_link.protocol.requests import Request

if TYPE_CHECKING:
    from unity_link.link.link import Link


class Asked:
    """Consecutive words, of one transaction of the bus, that were asked for.

    Args:
        link: an open link.
        address: of the first word.
        count: number of words, at most ``gateway.block_words``.

    Raises:
        LinkLostError: where the link has ended.
    """

    def __init__(self, link: Link, address: int, count: int) -> None:
        flow = link._flow  # noqa: SLF001  (the same room)
        codec = flow.codec
        # Imported here, not in the callback that takes the answer.
        self._joined = protocol.arrays.joined
        digits = count * codec.info.data_digits
        self._request = Request(codec, "RM", codec.fields("RM", address, count), digits)
        self._request.owner = self._waiter = flow.create_future()
        flow.submit(self._request)

    def done(self) -> bool:
        """Return whether the answer is there."""
        return self._waiter.done()

    async def words(self) -> list[int]:
        """Return the words; waits for them where they are not there yet.

        Raises:
            LinkLostError: where the link has ended.
            GatewayError: where the gateway refused the read.
        """
        words: list[int] = self._joined([await self._waiter]).tolist()
        return words

    def give_up(self) -> None:
        """Want the answer no more."""
        self._request.cancel()
        if not self._waiter.cancel() and not self._waiter.cancelled():
            # Retrieved, so that the event loop does not log it as never retrieved.
            self._waiter.exception()
