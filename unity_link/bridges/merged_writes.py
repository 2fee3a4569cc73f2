"""Writes of many values to a robot: in order, with as few requests as possible."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any, NamedTuple

from unity_link.data.writing import NOT_POSTED, write_values
from unity_link.errors import UnityLinkError

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from unity_link.data import Proxy
    from unity_link.modules import Bus


FEWEST = 12
"""Least number of words for a batch; fewer words are written faster one by one."""


class Value(NamedTuple):
    """A value to be written to one signal, checked and encoded."""

    proxy: Proxy[Any]
    value: Any
    words: tuple[int, ...]

    @classmethod
    def of(cls, proxy: Proxy[Any], value: Any) -> Value:
        """Check a value.

        Raises:
            ArgumentError: for a value that the signal cannot have.
        """
        return cls(proxy, value, proxy.encode(value))


Objects = list[list[Value]]
"""Values to be written, in objects; the values of one object are written together."""


async def write_in_order(objects: Objects, *, posted: bool) -> list[UnityLinkError]:
    """Write objects in order. Whole words of several objects are written as one batch.

    Args:
        objects: objects to write.
        posted: True to write without waiting for the execution; the link's next `fence` raises the errors.

    Returns:
        The errors of the values that were not written, or perhaps not. All others were written.
    """
    errors: list[UnityLinkError] = []
    for run in _runs(objects):
        if isinstance(run, _Words):
            try:
                await _send(run, posted=posted)
            except UnityLinkError as error:
                errors.append(error)
            continue
        # The requests are queued in the order in which the coroutines begin.
        posted_by = asyncio.current_task() if posted else NOT_POSTED
        writing = [write_values({proxy: value for proxy, value, _ in one}, posted_by=posted_by) for one in run]
        for outcome in await asyncio.gather(*writing, return_exceptions=True):
            if isinstance(outcome, UnityLinkError):
                errors.append(outcome)
            elif outcome is not None:
                raise outcome
    return errors


async def _send(run: _Words, *, posted: bool) -> None:
    bus, addresses, words = run
    if not posted:
        await bus.write_many(addresses, words)
    elif len(words) >= FEWEST:
        await bus.post_many(addresses, words)
    else:
        for address, word in zip(addresses, words, strict=True):
            await bus.post(address, word)


class _Words(NamedTuple):
    """Whole words to write on one bus."""

    bus: Bus
    addresses: list[int]
    words: list[int]


def _runs(objects: Objects) -> Iterator[_Words | Objects]:
    """Join consecutive objects of whole words on one bus; and other objects, if they need one request each."""
    words: _Words | None = None
    others: Objects = []
    for one in objects:
        if _is_plain(one):
            if others:
                yield others
                others = []
            for proxy, _, encoded in one:
                if words is not None and proxy.bus is not words.bus:
                    yield words
                    words = None
                words = words or _Words(proxy.bus, [], [])
                words.addresses.append(proxy.signal.address)
                words.words.extend(encoded)
            continue
        if words is not None:
            yield words
            words = None
        if others and (len(one) > 1 or len(others[0]) > 1):
            yield others
            others = []
        others.append(one)
    if words is not None:
        yield words
    if others:
        yield others


def _is_plain(values: Iterable[Value]) -> bool:
    return not any(len(words) > 1 or proxy.signal.is_field for proxy, _, words in values)
