"""Writes of many values at once: all values are checked before the first one is sent.

Fields that together make up all writable bits of a word are written as one word; so are fields that a 0 does not
change. Other fields need a masked write each, and a value of several words a bus transaction of its own. All writes are
in flight at the same time, in order.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.data.proxies import refusal
from unity_link.errors import ArgumentError, BusError
from unity_link.link.runtimes.synchronisation import gather
from unity_link.modules import post_many_for

if TYPE_CHECKING:
    from collections.abc import Coroutine, Mapping

    from unity_link.data.proxies import Proxy
    from unity_link.modules import Bus


NOT_POSTED = object()


async def write_values(values: Mapping[Proxy[Any], Any], *, posted_by: object = NOT_POSTED) -> None:
    """Write values, each to its signal.

    Args:
        values: values by their proxies.
        posted_by: task or thread that posts writes of whole words, without waiting for their execution.

    Raises:
        ArgumentError: for a value that its signal cannot have; nothing was sent.
        NotArmedError: if a lease guards one of the signals and is not armed. The other writes are executed.
        GatewayError: the first error. The other writes are executed all the same.
    """
    encoded = [(proxy, _encode(proxy, value)) for proxy, value in values.items()]
    by_bus: dict[int, tuple[Bus, list[tuple[Proxy[Any], tuple[int, ...]]]]] = {}
    for proxy, words in encoded:
        by_bus.setdefault(id(proxy.bus), (proxy.bus, []))[1].append((proxy, words))
    work = [writing for bus, items in by_bus.values() for writing in _writings(bus, items, posted_by)]
    try:
        if len(work) == 1:
            await work[0]
        else:
            await gather(*work)
    except BusError as error:
        raise await refusal(error, values) from None
    for proxy, words in encoded:
        proxy.see_written(words)


def _encode(proxy: Proxy[Any], value: Any) -> tuple[int, ...]:
    if not proxy.signal.access.writes:
        raise ArgumentError(f"{proxy.path} can only be read")
    if proxy.signal.fifo:
        raise ArgumentError(f"{proxy.path} is the port of a queue, to which each write appends a word")
    return proxy.encode(value)


def _writings(
    bus: Bus, items: list[tuple[Proxy[Any], tuple[int, ...]]], posted_by: object
) -> list[Coroutine[Any, Any, object]]:
    """Return the writes on one bus, as coroutines that have not begun."""
    whole: dict[int, int] = {}
    fields: dict[int, tuple[int, int, int]] = {}
    blocks: list[Coroutine[Any, Any, object]] = []
    for proxy, words in items:
        signal = proxy.signal
        if signal.is_field:
            word_mask = (1 << signal.word_bits) - 1
            for part, (address, word) in enumerate(zip(signal.addresses, words, strict=True)):
                value, mask, written = fields.get(address, (0, 0, 0))
                own = signal.mask >> (part * signal.word_bits) & word_mask
                # Two robots of one spec may write the same field on one link: the last value counts.
                all_written = written | proxy.robot.interface.written_bits[address]
                fields[address] = (value & ~own | word, mask | own, all_written)
        elif signal.effect is not None:
            # Several such signals may share a word: a 0 does not change them.
            whole[signal.address] = whole.get(signal.address, 0) | words[0]
        elif len(words) == 1:
            whole[signal.address] = words[0]
        else:
            blocks.append(bus.write_block(signal.address, words))
    masked = []
    for address, (word, mask, written) in fields.items():
        if mask == written:
            whole[address] = word
        else:
            masked.append(bus.write_masked(address, word, mask))
    if not whole:
        return [*masked, *blocks]
    columns = list(whole), list(whole.values())
    many = bus.write_many(*columns) if posted_by is NOT_POSTED else post_many_for(posted_by, bus, *columns)
    return [many, *masked, *blocks]
