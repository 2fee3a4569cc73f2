"""What arrives means the same however it is cut into reads: frames are taken many at a time only where that is so."""

from __future__ import annotations

import asyncio
import contextlib
from typing import TYPE_CHECKING, Any, NamedTuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import unity_link
from makers import SLOW, Maker, simulated
from scripted import Scripted
from simulated_time import on_simulated_time, run_simulated
from unity_link.protocol.crc import Crc
from unity_link.protocol.frames import Framing
from unity_link.virtual.build import build_gateway

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from unity_link import Sample

NODE, OTHER_NODE = 5, 6
FOREIGN = 7
"""A group that is not subscribed to."""


class Burst(NamedTuple):
    """Frames of one kind, side by side."""

    kind: str
    length: int


GROUPS = {"first": 0, "missing": 0, "second": 1, "other node": 0, "wrong length": 0, "damaged": 1, "foreign": FOREIGN}
KINDS = [*GROUPS, "answer", "noise", "empty"]
bursts = st.lists(st.builds(Burst, st.sampled_from(KINDS), st.integers(1, 3) | st.integers(10, 60)), max_size=12)


class Speaker:
    """Makes the frames of a gateway with two groups that are subscribed to."""

    def __init__(self, node: int | None) -> None:
        self._ours = Framing(Crc(), node)
        self._other = Framing(Crc(), None if node is None else OTHER_NODE)
        self._numbers = dict.fromkeys(GROUPS.values(), -1)

    def frame(self, kind: str) -> bytes:
        if kind in ("noise", "empty"):
            return kind.encode().replace(b"empty", b"") + b"\n"
        if kind == "answer":
            return self._ours.checked(b"rm000%08X" % 0xA)
        group = GROUPS[kind]
        self._numbers[group] += 3 if kind == "missing" else 1
        number = self._numbers[group]
        body = b"P%02X%02X%08X" % (group, number & 0xFF, group << 24 | number)
        if kind == "wrong length":
            body += b"00000000"
        frame = (self._other if kind == "other node" else self._ours).checked(body)
        return frame[:-4] + b"?" + frame[-3:] if kind == "damaged" else frame


def pieces_of(data: bytes, cuts: Sequence[int]) -> list[bytes]:
    ends = [*sorted({cut % (len(data) + 1) for cut in cuts} - {0}), len(data)]
    return [data[start:end] for start, end in zip([0, *ends], ends, strict=False) if start != end]


def seen(samples: Sequence[Sample]) -> list[tuple[int, list[int], int]]:
    return [(sample.sequence, sample.values.tolist(), sample.lost) for sample in samples]


async def heard(pieces: Sequence[bytes], node: int | None) -> object:
    """Return all that a program can see of a link on which `pieces` arrive."""
    told: tuple[list[Sample], list[Sample]] = ([], [])
    with scripted_driver() as gateways:
        async with (
            unity_link.connect("sim:?id_digits=3" + ("" if node is None else f"&node={node}")) as link,
            link.subscribe([1], timestamps=False, callback=told[0].append) as first,
            link.subscribe([2], timestamps=False, callback=told[1].append) as second,
        ):
            await asyncio.sleep(gateways[0].say(pieces))
            counted = link.statistics
            return (
                [seen(samples) for samples in told],
                (first.received, first.lost, second.received, second.lost),
                (counted.samples, counted.samples_lost, counted.damaged_frames, counted.stray_frames),
            )


@contextlib.contextmanager
def scripted_driver() -> Iterator[list[Scripted]]:
    """Have ``sim:`` open gateways of which a test writes what the host hears, and give them."""
    made: list[Scripted] = []

    def build(*arguments: Any, **options: Any) -> Scripted:
        made.append(Scripted(build_gateway(*arguments, **options)))
        return made[-1]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("unity_link.virtual.schemes.build_gateway", build)
        yield made


@pytest.mark.parametrize("node", [None, NODE], ids=["own medium", "shared medium"])
@settings(max_examples=60)
@given(arriving=bursts, cuts=st.lists(st.integers(0, 1 << 20), max_size=8))
def test_any_mixture_of_frames_cut_anywhere_is_what_it_is_line_by_line(
    node: int | None, arriving: list[Burst], cuts: list[int]
) -> None:
    speaker = Speaker(node)
    lines = [speaker.frame(burst.kind) for burst in arriving for _ in range(burst.length)]
    expected = run_simulated(heard(lines, node))
    assert run_simulated(heard(pieces_of(b"".join(lines), cuts), node)) == expected


@pytest.mark.parametrize("burst", [1, 2, 11, 12, 16, 40])
@on_simulated_time
async def test_samples_of_two_groups_in_bursts_reach_the_subscription_that_asked_for_them(
    make_bare: Maker, burst: int
) -> None:
    gateway = Scripted(make_bare(**SLOW))
    speaker = Speaker(None)
    frames = [speaker.frame(kind) for _ in range(20) for kind in ("first", "second") for _ in range(burst)]
    async with (
        unity_link.connect(gateway) as link,
        link.subscribe([1], timestamps=False) as first,
        link.subscribe([2], timestamps=False) as second,
    ):
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
async def test_answers_behind_samples_in_one_read_reach_their_calls() -> None:
    """Twenty samples and forty answers of their length arrive together."""
    gateway = Scripted(simulated(**SLOW, id_digits=3))
    speaker = Speaker(None)
    for address in range(40):
        gateway.memory[0x40 + address] = address
    async with unity_link.connect(gateway) as link, link.subscribe([1], timestamps=False) as samples:
        gateway.before_answer = b"".join(speaker.frame("first") for _ in range(20))
        words = await asyncio.gather(*(link.read_block(0x40 + address, 1) for address in range(40)))
        assert [word.tolist() for word in words] == [[address] for address in range(40)]
        assert [sample.values.tolist() for sample in await samples.take()] == [[number] for number in range(20)]
        assert (samples.lost, link.statistics.stray_frames) == (0, 0)
