"""Reads and writes of every kind, on every kind of gateway."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import unity_link
from support.makers import BUS_ERROR, BUS_TIMEOUT, Maker, on_each_kind
from unity_link import ArgumentError, BusError, BusTimeoutError, Feature, OutOfRangeError, UnsupportedError

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable

    from unity_link import Link
    from unity_link.virtual import Gateway

pytestmark = pytest.mark.asyncio


def words(gateway: Gateway, start: int, count: int) -> list[int]:
    return [gateway.memory[address] for address in range(start, start + count)]


# Words


async def test_a_read_returns_the_word_at_its_address(link: Link, gateway: Gateway) -> None:
    gateway.memory[0x0A] = 0x12
    assert await link.read(0x0A) == 0x12


@pytest.mark.parametrize("value", [0, 1, 0xDEADBEEF, 0xFFFFFFFF], ids=hex)
async def test_a_write_is_on_the_bus_when_it_returns(link: Link, gateway: Gateway, value: int) -> None:
    await link.write(0xFF, value)
    assert gateway.memory[0xFF] == value
    assert await link.read(0xFF) == value


async def test_a_masked_write_changes_the_masked_bits_and_returns_the_old_word(link: Link, gateway: Gateway) -> None:
    gateway.memory[7] = 0x0000FF00
    assert await link.write_masked(7, 0x12345678, 0x00000FF0) == 0xFF00
    assert gateway.memory[7] == 0x0000F670


async def test_numpy_integers_are_accepted_as_words_and_addresses(link: Link, gateway: Gateway) -> None:
    address: Any = np.uint8(5)
    word: Any = np.uint32(77)
    await link.write(address, word)
    assert await link.read(address) == 77


async def test_calculations_with_numpy_integers_do_not_wrap(make_gateway: Maker) -> None:
    gateway = make_gateway()
    narrow: Any = np.uint8
    async with unity_link.connect(gateway) as link:
        await link.write_block(narrow(50), range(200))
        assert words(gateway, 50, 200) == list(range(200))
        assert (await link.read_block(narrow(50), narrow(200))).tolist() == list(range(200))
        assert (await link.read_queue(narrow(60), narrow(200))).tolist() == [10] * 200
        await link.write_queue(narrow(60), range(200))
        assert gateway.memory[60] == 199
        with pytest.raises(ArgumentError, match="30 words from 0xfa on would pass the last address, 0xff"):
            await link.read_block(narrow(250), narrow(30))
        with pytest.raises(ArgumentError, match="300 words from 0x10 on"):
            await link.read_block(narrow(16), 300)
        assert await link.write_masked(narrow(60), narrow(0), narrow(255)) == 199


@pytest.mark.parametrize("given", [1.7, "5", None, float("nan")])
async def test_an_array_of_objects_with_a_value_that_is_no_integer_is_refused(link: Link, given: object) -> None:
    values = np.array([given], object)
    with pytest.raises(ArgumentError, match="a sequence of whole numbers was expected for each value"):
        await link.write_many([0x10], values)
    with pytest.raises(ArgumentError, match="a sequence of whole numbers was expected for each address"):
        await link.read_many(values)
    await link.write_many(np.array([0x10], object), np.array([7], object))
    assert await link.read(0x10) == 7


# Blocks


@pytest.mark.parametrize("count", [1, 2, 255, 256])
async def test_a_block_is_read_as_it_was_written(make_gateway: Maker, count: int) -> None:
    gateway = make_gateway()
    values = np.arange(count, dtype=np.uint32) * np.uint32(0x01010101)
    async with unity_link.connect(gateway) as link:
        await link.write_block(0, values)
        assert words(gateway, 0, count) == values.tolist()
        read = await link.read_block(0, count)
    assert read.dtype == np.uint32
    assert read.tolist() == values.tolist()


async def test_a_long_block_is_split_at_the_gateways_limit(make_gateway: Maker) -> None:
    gateway = make_gateway(block_words=10)
    async with unity_link.connect(gateway) as link:
        before = link.statistics.requests
        await link.write_block(3, range(35))
        assert link.statistics.requests == before + 4
        assert (await link.read_block(3, 35)).tolist() == list(range(35))
        assert link.statistics.requests == before + 8
        await link.write_queue(100, range(35))
        assert gateway.memory[100] == 34
        assert (await link.read_queue(100, 35)).tolist() == [34] * 35


async def test_a_queue_is_one_address(link: Link, gateway: Gateway) -> None:
    await link.write_queue(0x21, [7, 8])
    assert words(gateway, 0x20, 3) == [0, 8, 0]
    assert (await link.read_queue(0x21, 3)).tolist() == [8, 8, 8]


# Batches


@pytest.mark.parametrize("count", [1, 7, 31, 32, 33, 200, 5000])
async def test_thousands_of_words_are_transferred_in_one_await(link: Link, gateway: Gateway, count: int) -> None:
    random = np.random.default_rng(count)
    addresses = random.integers(0, 0x80, count)
    values = random.integers(0, 1 << 32, count, dtype=np.uint32)
    await link.write_many(addresses, values)
    last = dict(zip(addresses.tolist(), values.tolist(), strict=True))
    assert {address: gateway.memory[address] for address in last} == last
    read = await link.read_many(addresses)
    assert read.dtype == np.uint32
    assert read.tolist() == [last[address] for address in addresses.tolist()]


async def test_an_error_in_a_batch_is_raised_and_the_others_are_done(link: Link, gateway: Gateway) -> None:
    with pytest.raises(BusError, match="write at 0xE0"):
        await link.write_many([1, BUS_ERROR, 2], [11, 12, 13])
    with pytest.raises(BusTimeoutError, match="read at 0xE8"):
        await link.read_many([*range(100), BUS_TIMEOUT, *range(100)])
    assert words(gateway, 1, 2) == [11, 13]
    assert await link.read(1) == 11


# Errors of the gateway


@pytest.mark.parametrize(
    ("call", "what"),
    [
        (lambda link: link.read(BUS_ERROR), "^read at 0xE0: the bus refused"),
        (lambda link: link.write(BUS_ERROR, 1), "^write at 0xE0: "),
        (lambda link: link.write_masked(BUS_ERROR, 1, 1), "^masked write at 0xE0: "),
        (lambda link: link.read_block(BUS_ERROR - 1, 3), "^block read at 0xDF: "),
        (lambda link: link.write_block(BUS_ERROR - 1, [1, 2, 3]), "^block write at 0xDF: "),
        (lambda link: link.read_queue(BUS_ERROR, 3), "^queue read at 0xE0: "),
        (lambda link: link.write_queue(BUS_ERROR, [1, 2, 3]), "^queue write at 0xE0: "),
    ],
)
async def test_a_refused_access_raises_and_names_the_request(
    link: Link, call: Callable[[Link], Awaitable[object]], what: str
) -> None:
    with pytest.raises(BusError, match=what) as caught:
        await call(link)
    assert caught.value.code == 4
    assert await link.read(0) == 0


async def test_an_address_without_a_slave_raises_its_own_error(link: Link) -> None:
    with pytest.raises(BusTimeoutError, match="nothing on the bus answered") as caught:
        await link.read(BUS_TIMEOUT)
    assert caught.value.code == 5


async def test_the_words_of_a_block_before_its_error_are_written(link: Link, gateway: Gateway) -> None:
    with pytest.raises(BusError):
        await link.write_block(BUS_ERROR - 2, [1, 2, 3, 4])
    assert words(gateway, BUS_ERROR - 2, 2) == [1, 2]


# Posted writes


async def test_posted_writes_are_done_in_order_when_the_fence_returns(link: Link, gateway: Gateway) -> None:
    for value in range(1000):
        await link.post(value % 8, value)
    await link.fence()
    assert words(gateway, 0, 8) == list(range(992, 1000))


async def test_a_fence_raises_the_first_error_of_posts_and_counts_the_others(link: Link) -> None:
    await link.post(BUS_TIMEOUT, 1)
    for _ in range(3):
        await link.post(BUS_ERROR, 1)
    with pytest.raises(BusTimeoutError, match="posted write at 0xE8") as caught:
        await link.fence()
    assert caught.value.__notes__ == ["3 more posted writes failed as well"]
    await link.fence()


async def test_one_failed_posted_write_needs_no_note(link: Link) -> None:
    await link.post(BUS_ERROR, 1)
    with pytest.raises(BusError) as caught:
        await link.fence()
    assert not hasattr(caught.value, "__notes__")


async def test_errors_of_posted_writes_without_a_fence_take_no_memory(link: Link) -> None:
    for _ in range(2000):
        await link.post(BUS_ERROR, 1)
    with pytest.raises(BusError) as caught:
        await link.fence()
    assert caught.value.__notes__ == ["1999 more posted writes failed as well"]
    assert not [value for value in vars(link).values() if isinstance(value, list)]


async def test_posted_writes_are_confirmed_without_a_fence(link: Link, gateway: Gateway) -> None:
    await link.post(1, 5)
    while link.statistics.in_flight:  # noqa: ASYNC110  (no event reports the confirmation)
        await asyncio.sleep(0.001)
    assert gateway.memory[1] == 5


# Many at once


async def test_hundreds_of_tasks_share_a_link(link: Link, gateway: Gateway) -> None:
    async def work(number: int) -> int:
        await link.write(number, number * 3)
        return await link.read(number)

    assert await asyncio.gather(*(work(number) for number in range(0xE0))) == [number * 3 for number in range(0xE0)]


async def test_a_batch_of_thousands_does_not_delay_a_read(link: Link) -> None:
    done: list[str] = []

    async def batch() -> None:
        await link.read_many(np.zeros(20_000, int))
        done.append("batch")

    async def read() -> None:
        await link.read(0)
        done.append("read")

    await asyncio.gather(batch(), read())
    assert done == ["read", "batch"]


async def test_requests_are_executed_in_the_order_of_the_calls(link: Link) -> None:
    calls: list[Awaitable[Any]] = []
    for value in range(300):
        calls += [link.write(3, value), link.read(3)]
    answers = await asyncio.gather(*calls)
    assert answers[1::2] == list(range(300))


# Arguments

WRONG: dict[str, Callable[[Link], Awaitable[object]]] = {
    "a negative address": lambda link: link.read(-1),
    "an address beyond the last": lambda link: link.read(0x100),
    "a write beyond the last address": lambda link: link.write(0x100, 0),
    "a negative word": lambda link: link.write(0, -1),
    "a word too wide": lambda link: link.write(0, 1 << 32),
    "a posted word too wide": lambda link: link.post(0, 1 << 32),
    "a posted address beyond the last": lambda link: link.post(0x100, 0),
    "a mask too wide": lambda link: link.write_masked(0, 0, 1 << 32),
    "a masked word too wide": lambda link: link.write_masked(0, 1 << 32, 0),
    "a masked address beyond the last": lambda link: link.write_masked(0x100, 0, 0),
    "a block of nothing": lambda link: link.read_block(0, 0),
    "a block of less than nothing": lambda link: link.read_block(0, -1),
    "a block beyond the last address": lambda link: link.read_block(0xFF, 2),
    "a written block beyond the last address": lambda link: link.write_block(0xFF, [1, 2]),
    "an empty block": lambda link: link.write_block(0, []),
    "a word too wide in a block": lambda link: link.write_block(0, [0, 1 << 32]),
    "a word far too wide in a block": lambda link: link.write_block(0, [1 << 100]),
    "a negative word in a block": lambda link: link.write_block(0, [0, -1]),
    "fractions in a block": lambda link: link.write_block(0, [0.5]),
    "text in a block": lambda link: link.write_block(0, ["1"]),
    "a block of two dimensions": lambda link: link.write_block(0, [[1, 2], [3, 4]]),
    "a ragged block": lambda link: link.write_block(0, [[1], [2, 3]]),
    "one word as a block": lambda link: link.write_block(0, 5),
    "a queue of nothing": lambda link: link.read_queue(0, 0),
    "a queue beyond the last address": lambda link: link.read_queue(0x100, 1),
    "an empty queue": lambda link: link.write_queue(0, []),
    "a written queue beyond the last address": lambda link: link.write_queue(0x100, [1]),
    "no addresses": lambda link: link.read_many([]),
    "an address beyond the last among many": lambda link: link.read_many([0, 0x100]),
    "a negative address among many": lambda link: link.read_many([0, -1]),
    "fewer values than addresses": lambda link: link.write_many([1, 2], [1]),
    "no addresses and no values": lambda link: link.write_many([], []),
    "a word too wide among many": lambda link: link.write_many([1], [1 << 32]),
    "a mode that is none": lambda link: link.send_immediate("sometimes"),  # type: ignore[arg-type]
    "a list in place of a mode": lambda link: link.send_immediate(["off"]),  # type: ignore[arg-type]
}


@pytest.mark.slow
@pytest.mark.parametrize("call", WRONG.values(), ids=WRONG)
async def test_a_wrong_argument_raises_before_a_request_is_sent(
    link: Link, call: Callable[[Link], Awaitable[object]]
) -> None:
    sent = link.statistics.bytes_sent
    with pytest.raises(ArgumentError):
        await call(link)
    assert link.statistics.bytes_sent == sent
    assert await link.read(0) == 0


# Features


@pytest.mark.parametrize("mode", ["off", "always", "adaptive"])
async def test_send_immediate_has_three_modes(link: Link, mode: Any) -> None:
    await link.send_immediate(mode)


BARE: dict[str, Callable[[Link], Awaitable[object]]] = {
    "masked write": lambda link: link.write_masked(0, 0, 0),
    "queue commands": lambda link: link.read_queue(0, 1),
    "send immediate": lambda link: link.send_immediate("off"),
}


@pytest.mark.parametrize(("name", "call"), BARE.items(), ids=BARE)
async def test_a_request_for_a_missing_feature_raises_and_is_not_sent(
    make_gateway: Maker, name: str, call: Callable[[Link], Awaitable[object]]
) -> None:
    gateway = make_gateway(features=Feature.FLOW_CONTROL)
    async with unity_link.connect(gateway) as link:
        sent = link.statistics.bytes_sent
        with pytest.raises(UnsupportedError, match=f"built without {name}"):
            await call(link)
        assert link.statistics.bytes_sent == sent
        await link.write(1, 2)
        assert await link.read(1) == 2


# Widths


WIDTHS = [
    {"data_bits": data_bits, "address_bits": address_bits, "id_digits": id_digits}
    for data_bits, address_bits in [(8, 8), (9, 13), (12, 16), (16, 10), (32, 8), (33, 20), (40, 32), (64, 32)]
    for id_digits in (2, 3)
]


@on_each_kind(WIDTHS, compiled=[2, 8, 9, 15])
async def test_every_request_works_at_every_width(make_gateway: Maker, fields: dict[str, int]) -> None:
    data_bits, address_bits, _ = fields.values()
    top, last = (1 << data_bits) - 1, (1 << address_bits) - 1
    async with unity_link.connect(make_gateway(**fields)) as link:
        await link.write(last, top)
        assert await link.read(last) == top
        assert await link.write_masked(last, 0, 1) == top
        await link.write_block(last - 2, [1, top, 3])
        block = await link.read_block(last - 2, 3)
        assert block.tolist() == [1, top, 3]
        assert block.dtype.itemsize == next(size for size in (1, 2, 4, 8) if size * 8 >= 4 * -(-data_bits // 4))
        await link.write_many([last] * 100 + [0], [5] * 100 + [top])
        assert (await link.read_many([0, last] * 50)).tolist() == [top, 5] * 50
        await link.post(1, top)
        await link.write_queue(2, [top, top - 1])
        assert (await link.read_queue(2, 2)).tolist() == [top - 1] * 2
        assert await link.read(1) == top
        with pytest.raises(ArgumentError):
            await link.write(0, top + 1)
        with pytest.raises(ArgumentError):
            await link.read(last + 1)
        async with link.subscribe([1, 2, last], timestamps=True) as samples:
            await samples.publish()
            assert (await anext(samples)).values.tolist() == [top, top - 1, 5]


CRCS = [
    {"crc_bits": bits, "crc_polynomial": polynomial}
    for bits, polynomial in [(8, 0x31), (16, 0x1021), (16, 0x8005), (32, 0x04C11DB7), (32, 0x1EDC6F41)]
]


@on_each_kind(CRCS, compiled=[1, 3])
async def test_every_crc_works(make_gateway: Maker, fields: dict[str, int]) -> None:
    async with unity_link.connect(make_gateway(**fields)) as link:
        await link.write_many(range(100), range(100))
        assert (await link.read_block(0, 100)).tolist() == list(range(100))
        assert link.statistics.damaged_frames == 0


# Information about a link


async def test_a_link_has_the_configuration_of_its_gateway(make_gateway: Maker) -> None:
    gateway = make_gateway(build_id=0xCAFE)
    async with unity_link.connect(gateway) as link:
        assert link.gateway == gateway.info
        assert link.gateway.build_id == 0xCAFE


async def test_statistics_count_requests_bytes_and_errors(link: Link) -> None:
    before = link.statistics
    await link.read_many(range(100))
    with pytest.raises(BusError):
        await link.read(BUS_ERROR)
    after = link.statistics
    assert after.requests == before.requests + 101
    assert after.responses == before.responses + 101
    assert after.errors == before.errors + 1
    # A busy machine causes retransmissions, so more bytes may be sent.
    assert after.bytes_sent >= before.bytes_sent + 101 * len("riiiAAcccc\n")
    answers = 100 * len("riiiDDDDDDDDcccc\n") + len("xiii04cccc\n")
    assert after.bytes_received >= before.bytes_received + answers
    assert (after.in_flight, after.damaged_frames, after.reconnections) == (0, 0, 0)
    assert after.round_trip is not None
    with pytest.raises(AttributeError):
        after.requests = 0  # type: ignore[misc]


async def test_a_range_error_of_the_gateway_is_an_error_of_its_own(link: Link) -> None:
    with pytest.raises(OutOfRangeError, match=r"publishing a group: .* out of its range") as caught:
        await link._ask("GP", 0xFE)
    assert caught.value.code == 6
