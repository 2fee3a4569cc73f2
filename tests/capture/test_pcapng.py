"""The records of a snoop: from a cut or damaged file, exactly the complete records before the damage are read."""

from __future__ import annotations

import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.capture import pcapng
from unity_link.capture.pcapng import DamagedFileError, Packet

PACKETS = st.builds(Packet, st.integers(0, 3), st.integers(0, (1 << 63) - 1), st.booleans(), st.binary(max_size=40))
HEAD = pcapng.section() + b"".join(pcapng.interface(f"gateway {number}") for number in range(4))


def read(data: bytes) -> tuple[list[Packet], DamagedFileError | None]:
    """Return the packets before the first damage, and the error of the damage."""
    found: list[Packet] = []
    try:
        for block in pcapng.blocks(data):
            found += [pcapng.read_packet(block.body)] if block.kind == pcapng.PACKET else []
    except DamagedFileError as error:
        return found, error
    return found, None


@given(st.lists(PACKETS, max_size=8), st.text(max_size=20))
def test_packets_are_read_as_they_were_written(packets: list[Packet], name: str) -> None:
    data = pcapng.section() + pcapng.interface(name) + b"".join(map(pcapng.packet, packets))
    assert read(data) == (packets, None)
    section, interface, *_ = pcapng.blocks(data)
    pcapng.check_section(section.body)
    assert pcapng.read_interface(interface.body) == name
    assert pcapng.length_of_whole(data) == len(data)
    assert pcapng.ends_whole(data)


@given(st.lists(PACKETS, min_size=1, max_size=8), st.data())
def test_all_complete_records_of_a_cut_file_are_read(packets: list[Packet], data: st.DataObject) -> None:
    ends = [len(HEAD)]
    whole = HEAD
    for packet in packets:
        whole += pcapng.packet(packet)
        ends.append(len(whole))
    cut = data.draw(st.integers(len(HEAD), len(whole)))
    found, error = read(whole[:cut])
    count = max(index for index, end in enumerate(ends) if end <= cut)
    assert found == packets[:count]
    assert (error is None) == (cut in ends)
    assert pcapng.length_of_whole(whole[:cut]) == ends[count]


@given(st.lists(PACKETS, min_size=1, max_size=4), st.binary(min_size=1, max_size=64))
def test_bytes_that_are_no_record_do_not_hide_earlier_records(packets: list[Packet], noise: bytes) -> None:
    whole = HEAD + b"".join(map(pcapng.packet, packets))
    found, _ = read(whole + noise)
    assert found[: len(packets)] == packets


@given(st.binary(max_size=60))
def test_a_record_of_any_bytes_is_read_or_refused(body: bytes) -> None:
    for reader in (pcapng.read_packet, pcapng.read_ending, pcapng.check_section):
        try:
            reader(body)
        except ValueError:
            continue


def test_a_connection_ends_with_its_time_and_the_reason() -> None:
    (block,) = pcapng.blocks(pcapng.ending(2, 1_700_000_000_123_456_789, "the other side closed it"))
    assert pcapng.read_ending(block.body) == (2, 1_700_000_000_123_456_789, "the other side closed it")


@pytest.mark.parametrize(
    ("body", "words"),
    [
        (struct.pack(">IHHq", pcapng.ORDER, 1, 0, -1), "its byte order is big-endian"),
        (struct.pack("<IHHq", pcapng.ORDER, 1, 0, -1), "but of another program"),
    ],
)
def test_a_file_of_another_program_is_distinguished_from_a_snoop(body: bytes, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        pcapng.check_section(body)
