"""Interleaved samples of several groups, found with arrays."""

from __future__ import annotations

import pytest

from unity_link.protocol.host.group_table import HeldGroup
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import Framing
from unity_link.protocol.wire.interleaved_samples import FEWEST_OF_A_SIZE, find_interleaved

FRAMING = Framing(Crc())
SEED = 0x2469
SHORT, LONG = (
    HeldGroup(number, b"", length, owner) for number, length, owner in ((1, 13, "short"), (0x2A, 21, "long"))
)
GROUPS = {group.text: group for group in (SHORT, LONG)}


def sample(group: HeldGroup, sequence: int) -> bytes:
    body = b"P" + group.text + b"%02X" % sequence
    return FRAMING.checked(body.ljust(group.length, b"A"), SEED)


def found(data: bytes, start: int = 0) -> tuple[list[str], int]:
    """Return the owners in the order of the samples, and the number of characters that the samples take."""
    samples = find_interleaved(data, start, FRAMING, GROUPS, SEED)
    if samples is None:
        return [], 0
    assert sorted(place for places, _ in samples.parts for place in places) == [*range(len(samples.owners))]
    assert all(len(places) == len(bodies) for places, bodies in samples.parts)
    return samples.owners, samples.size


@pytest.mark.parametrize("start", [0, 5])
def test_samples_of_one_size_are_found_until_one_belongs_to_no_group(start: int) -> None:
    data = b"".join(sample(SHORT, number) for number in range(10))
    stray = FRAMING.checked(b"P0905".ljust(SHORT.length, b"A"), SEED)
    assert found(b"-" * start + data + stray + data, start) == (["short"] * 10, len(data))


def test_samples_of_different_sizes_are_found_in_their_order() -> None:
    order = [SHORT, LONG, LONG, SHORT] * FEWEST_OF_A_SIZE
    data = b"".join(sample(group, number) for number, group in enumerate(order))
    assert found(data) == ([group.owner for group in order], len(data))
    samples = find_interleaved(data, 0, FRAMING, GROUPS, SEED)
    assert samples is not None
    for places, bodies in samples.parts:
        assert [bytes(body) for body in bodies] == [sample(order[place], place)[:-5] for place in places]


def test_a_damaged_sample_ends_the_interleaved_samples() -> None:
    order = [SHORT, LONG] * (2 * FEWEST_OF_A_SIZE)
    frames = [sample(group, number) for number, group in enumerate(order)]
    frames[21] = frames[21].replace(b"A", b"B", 1)
    owners, size = found(b"".join(frames))
    assert (owners, size) == ([group.owner for group in order[:21]], sum(map(len, frames[:21])))


def test_a_sample_with_another_length_than_its_group_is_not_found() -> None:
    good = b"".join(sample(SHORT, number) for number in range(10))
    long = FRAMING.checked((b"P" + SHORT.text + b"00").ljust(SHORT.length + 8, b"A"), SEED)
    assert found(long * 10) == ([], 0)
    assert found(good + long * 10)[0] == ["short"] * 10


@pytest.mark.parametrize("data", [b"\n", b"ABCD\n", b"no end", b""])
def test_data_shorter_than_any_frame_is_no_sample(data: bytes) -> None:
    assert found(data) == ([], 0)
