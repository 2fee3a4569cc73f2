"""The result does not depend on the offsets at which bytes are cut into reads, even if frames are decoded together."""

from __future__ import annotations

import asyncio
import contextlib
import functools
from typing import TYPE_CHECKING, Any, NamedTuple

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import unity_link
from support.makers import SLOW, Maker, simulated
from support.scripted import Scripted
from support.searching import examples
from support.simulated_time import on_simulated_time, run_simulated
from support.valve import as_gateway
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import MOST_LINES, Framing
from unity_link.virtual.build import build_gateway

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from unity_link import Sample
    from unity_link.protocol.host.host_codec import HostCodec

NODE, OTHER_NODE = 5, 6
FOREIGN = 7
"""A group without a subscription."""


class Burst(NamedTuple):
    """Consecutive frames of one kind."""

    kind: str
    length: int


WORDS = {0: 1, 1: 1, 2: 3, 3: 1, 4: 2, FOREIGN: 1}
"""Words of each group; a sample of group 3 has the length of one of group 4 because it has a timestamp."""
STAMPED = 3
GROUPS = {
    "first": 0,
    "missing": 0,
    "second": 1,
    "long": 2,
    "stamped": STAMPED,
    "as long as stamped": 4,
    "other node": 0,
    "wrong length": 0,
    "damaged": 1,
    "no digit": 2,
    "foreign": FOREIGN,
}
TURNS = {
    "two in turn": ["first", "second"],
    "two of one length in turn": ["stamped", "as long as stamped"],
    "all in turn": ["first", "second", "long", "stamped", "as long as stamped"],
    "turns with gaps": ["first", "missing", "long"],
    "turns with damage": [*["first", "second"] * 10, "damaged"],
    "turns without digits": [*["long", "second"] * 10, "no digit"],
    "turns with answers": [*["stamped", "second"] * 8, "answer"],
}
KINDS = [*GROUPS, *TURNS, "answer", "noise", "empty", "endless answer", "endless sample"]
bursts = st.lists(st.builds(Burst, st.sampled_from(KINDS), st.integers(1, 3) | st.integers(10, 60)), max_size=12)


class Speaker:
    """Makes the frames of a gateway with subscribed groups."""

    def __init__(self, codec: HostCodec, node: int | None) -> None:
        self._ours = codec
        self._other = Framing(Crc(), None if node is None else OTHER_NODE)
        self._numbers = dict.fromkeys(GROUPS.values(), -1)

    def frame(self, kind: str) -> bytes:
        if kind in ("noise", "empty"):
            return kind.encode().replace(b"empty", b"") + b"\n"
        if kind in ("answer", "endless answer"):
            frame = as_gateway(self._ours, b"r000%08X" % 0xA)
            return frame if kind == "answer" else frame[:-1] + b"\x0b"
        if kind == "endless sample":
            return self.frame("second")[:-1] + b"\x0b"
        group = GROUPS[kind]
        self._numbers[group] += 3 if kind == "missing" else 1
        number = self._numbers[group]
        stamp = b"%08X" % (0xFFFF_F000 + 50_000 * number & 0xFFFF_FFFF) if group == STAMPED else b""
        word = b"%08X" % (group << 24 | number)
        body = b"P%02X%02X" % (group, number & 0xFF) + stamp + (b"0000000G" if kind == "no digit" else word)
        body += word * (WORDS[group] - 1)
        if kind == "wrong length":
            body += b"00000000"
        frame = self._other.checked(body) if kind == "other node" else as_gateway(self._ours, body)
        return frame[:-4] + b"?" + frame[-3:] if kind == "damaged" else frame


def pieces_of(data: bytes, cuts: Sequence[int]) -> list[bytes]:
    ends = [*sorted({cut % (len(data) + 1) for cut in cuts} - {0}), len(data)]
    return [data[start:end] for start, end in zip([0, *ends], ends, strict=False) if start != end]


def seen(samples: Sequence[Sample]) -> list[tuple[int, list[int], int]]:
    return [(sample.sequence, sample.values.tolist(), sample.lost) for sample in samples]


async def heard(kinds: Sequence[str], node: int | None, cuts: Sequence[int] | None) -> object:
    """Return all that a program can observe of a link on which frames arrive: one in a read, or cut at `cuts`."""
    told: list[object] = []

    def tell(group: int, sample: Sample) -> None:
        told.append((group, sample.time, sample.values.dtype, *seen([sample])))

    with scripted_driver() as gateways:
        async with (
            unity_link.connect("sim:?id_digits=3" + ("" if node is None else f"&node={node}")) as link,
            contextlib.AsyncExitStack() as stack,
        ):
            subscriptions = []
            for group in range(STAMPED + 2):
                addresses, stamped = range(WORDS[group]), group == STAMPED
                callback = functools.partial(tell, group)
                subscription = link.subscribe(addresses, timestamps=stamped, callback=callback)
                subscriptions.append(await stack.enter_async_context(subscription))
            speaker = Speaker(link._session.codec, node)
            lines = [speaker.frame(kind) for kind in kinds]
            await asyncio.sleep(gateways[0].say(lines if cuts is None else pieces_of(b"".join(lines), cuts)))
            counted = link.statistics
            return (
                told,
                [(subscription.received, subscription.lost) for subscription in subscriptions],
                (counted.samples, counted.samples_lost, counted.damaged_frames, counted.stray_frames),
            )


@contextlib.contextmanager
def scripted_driver() -> Iterator[list[Scripted]]:
    """Have ``sim:`` build gateways whose output the test writes itself, and yield the list of them."""
    made: list[Scripted] = []

    def build(*arguments: Any, **options: Any) -> Scripted:
        made.append(Scripted(build_gateway(*arguments, **options)))
        return made[-1]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("unity_link.virtual.schemes.build_gateway", build)
        yield made


@pytest.mark.slow
@pytest.mark.parametrize("node", [None, NODE], ids=["own medium", "shared medium"])
@settings(max_examples=examples(60))
@given(arriving=bursts, cuts=st.lists(st.integers(0, 1 << 20), max_size=8))
@example(arriving=[Burst("noise", MOST_LINES), Burst("endless sample", 1)], cuts=[])
@example(arriving=[Burst("noise", MOST_LINES), Burst("endless answer", 1)], cuts=[])
def test_frames_cut_anywhere_have_the_result_of_reading_line_by_line(
    node: int | None, arriving: list[Burst], cuts: list[int]
) -> None:
    kinds = [kind for burst in arriving for _ in range(burst.length) for kind in TURNS.get(burst.kind, [burst.kind])]
    expected = run_simulated(heard(kinds, node, None))
    assert run_simulated(heard(kinds, node, cuts)) == expected


@pytest.mark.parametrize("burst", [1, 2, 11, 12, 16, 40])
@on_simulated_time
async def test_samples_of_two_groups_in_bursts_reach_their_subscriptions(make_bare: Maker, burst: int) -> None:
    gateway = Scripted(make_bare(**SLOW))
    async with (
        unity_link.connect(gateway) as link,
        link.subscribe([1], timestamps=False) as first,
        link.subscribe([2], timestamps=False) as second,
    ):
        speaker = Speaker(link._session.codec, None)
        frames = [speaker.frame(kind) for _ in range(20) for kind in ("first", "second") for _ in range(burst)]
        await asyncio.sleep(gateway.say([b"".join(frames)]))
        for group, samples in enumerate((first, second)):
            assert [sample.values.tolist() for sample in await samples.take()] == [
                [group << 24 | number] for number in range(20 * burst)
            ]
            assert (samples.received, samples.lost) == (20 * burst, 0)


@on_simulated_time
async def test_answers_of_the_length_of_samples_reach_their_calls() -> None:
    gateway = simulated(**SLOW, id_digits=3)
    gateway.memory[1] = 0x5A
    for address in range(40):
        gateway.memory[0x40 + address] = address
    async with unity_link.connect(gateway) as link, link.subscribe([1], rate_hz=1000, timestamps=False) as samples:
        for _ in range(20):
            await asyncio.sleep(0.03)
            words = await asyncio.gather(*(link.read_block(0x40 + address, 1) for address in range(40)))
            assert [word.tolist() for word in words] == [[address] for address in range(40)]
        assert {tuple(sample.values.tolist()) for sample in await samples.take()} == {(0x5A,)}
        assert (samples.lost, link.statistics.repetitions) == (0, 0)


@on_simulated_time
async def test_answers_after_samples_in_one_read_reach_their_calls() -> None:
    """Twenty samples and forty answers of the same length arrive together."""
    gateway = Scripted(simulated(**SLOW, id_digits=3))
    for address in range(40):
        gateway.memory[0x40 + address] = address
    async with unity_link.connect(gateway) as link, link.subscribe([1], timestamps=False) as samples:
        speaker = Speaker(link._session.codec, None)
        gateway.before_answer = b"".join(speaker.frame("first") for _ in range(20))
        words = await asyncio.gather(*(link.read_block(0x40 + address, 1) for address in range(40)))
        assert [word.tolist() for word in words] == [[address] for address in range(40)]
        assert [sample.values.tolist() for sample in await samples.take()] == [[number] for number in range(20)]
        assert (samples.lost, link.statistics.stray_frames) == (0, 0)
