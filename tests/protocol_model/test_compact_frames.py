"""Text, compact and cut frames: every reader of frames agrees with a gateway that was written from the page alone."""

from __future__ import annotations

import dataclasses
import random
import re
from typing import TYPE_CHECKING

import pytest

from protocol_model.gateway_on_the_page import CR, END, ESCAPE, LF, START, GatewayOnThePage, Widths
from protocol_model.mixed_frames import FRAMES, HOSTS, Mixture, from_a_gateway, lines_in, lines_on_the_page
from support.makers import COMPACT, CRC_32, RTL, compiled, simulated
from support.sharing import call, settle, sharing
from support.simulated_time import on_simulated_time
from support.worked_examples import DOCUMENT, worked_examples
from unity_link.protocol.gateway.datagrams import GatewayDatagrams
from unity_link.protocol.wire.compact import CompactForm, Unpacker
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import Framing
from unity_link.protocol.wire.messages import Codec
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.virtual import BareGateway

FEATURES = GatewayInfo().features | Feature.COMPACT
INFO = GatewayInfo(features=FEATURES)
FRAMING = Framing(Crc())
CODEC_32 = Codec(GatewayInfo(crc_bits=32, crc_polynomial=CRC_32["crc_polynomial"]))
GATEWAYS = {
    "default": (INFO, None),
    "short": (GatewayInfo(id_digits=2, crc_bits=8, crc_polynomial=0x07, features=FEATURES), None),
    "small": (
        GatewayInfo(
            address_bits=12, data_bits=16, crc_bits=32, crc_polynomial=0x04C11DB7, block_words=6, features=FEATURES
        ),
        None,
    ),
    "node": (GatewayInfo(id_digits=2, address_bits=12, features=FEATURES), 0xB5),
}
LIFE = 250
"""Number of frames that a gateway receives before a new one replaces it."""
AMOUNTS = [2_000, pytest.param(25_000, marks=pytest.mark.campaign)]
"""Number of frames for each of the four gateways."""


def widths_of(info: GatewayInfo, node: int | None = None) -> Widths:
    """Return the widths of a gateway, for the page."""
    return Widths(
        info.id_digits,
        info.crc_bits,
        info.crc_polynomial,
        info.address_digits,
        info.data_digits,
        info.block_words,
        info.group_words,
        info.groups,
        node,
        compact=Feature.COMPACT in info.features,
    )


def on_the_page(gateway: BareGateway, node: int | None = None) -> GatewayOnThePage:
    """Return a gateway on the page with the widths and configuration of another gateway."""
    return GatewayOnThePage(widths_of(gateway.info, node), gateway.info.to_hex().decode())


def assert_agree(gateway: BareGateway, page: GatewayOnThePage, seed: int, amount: int = LIFE) -> None:
    """Send frames to a gateway, and assert that each is answered as on the page."""
    sent = []
    for piece, answer in Mixture(page, random.Random(seed)).pieces(amount):
        sent.append(piece)
        assert (gateway.receive(piece, 0.0), sent[-5:]) == (answer, sent[-5:])


# The examples of the page


def bytes_of(cell: str) -> bytes | None:
    """Return the bytes that a cell of the table of cut frames shows; None if the cell abbreviates them."""
    names = {"LF": LF, "CR": CR}
    found = bytearray()
    for span in re.findall("`([^`]+)`", cell):
        words = span.split()
        if "…" in words:
            return None
        is_hex = all(word in names or re.fullmatch("[0-9A-F]{2}", word) for word in words)
        found += bytes(names.get(word) or int(word, 16) for word in words) if is_hex else span.encode()
    return bytes(found)


def rows_of_the_page() -> list[tuple[bytes, bytes]]:
    """Return bytes and expected answers from the table of cut frames."""
    text = DOCUMENT.read_text(encoding="utf-8").partition("### Cut frames")[2].partition("\n### ")[0]
    rows = [line.split("|")[1:3] for line in text.splitlines() if line.startswith("| `")]
    pairs = [(bytes_of(sent), answer) for sent, answer in rows]
    return [(sent, b"X01D488\n" if "X01" in answer else b"") for sent, answer in pairs if sent is not None]


def test_the_page_has_a_row_for_each_way_to_cut_a_frame() -> None:
    assert len(rows_of_the_page()) == 9
    assert (bytes((START, END)), b"") in rows_of_the_page()
    assert (b"KF9AF" + bytes((END,)), b"X01D488\n") in rows_of_the_page()


@pytest.mark.parametrize("kind", ["page", "sim", RTL])
@pytest.mark.parametrize("begins", [b"", FRAMING.checked(b"K0001234")], ids=["no session", "session"])
def test_each_row_of_the_table_of_cut_frames_is_answered_as_written(kind: str, begins: bytes) -> None:
    rows, harmless = rows_of_the_page(), FRAMING.checked(b"H")
    if kind == "rtl":
        # The compiled gateway has another CRC.
        rows = [row for row in rows if not row[0].startswith(b"K")]
        begins = begins and CODEC_32.framing.checked(b"K0001234")
        harmless, cut = CODEC_32.framing.checked(b"H"), CODEC_32.framing.checked(b"X01")
        rows = [(sent, answer and cut) for sent, answer in rows]
    for sent, answer in rows:
        take = taker_of(kind)
        take(begins)
        assert take(b"\n" + sent) == answer
        # After any cut frame, the next frame is complete.
        assert take(b"\n" + harmless) == harmless


def taker_of(kind: str) -> Callable[[bytes], bytes]:
    """Return a function that passes bytes to a newly reset gateway and returns its answers."""
    if kind == "page":
        page = GatewayOnThePage()
        return lambda data: b"".join(page.answers(data))
    gateway = compiled(**COMPACT) if kind == "rtl" else VirtualGateway(INFO)
    return lambda data: gateway.receive(data, 0.0)


def test_the_gateway_on_the_page_gives_the_answers_of_its_examples() -> None:
    answered = 0
    for example in worked_examples():
        if example.bus_errors or example.bus_timeouts or any(sent.startswith(b"GS") for sent, _ in example.exchange):
            continue
        page = GatewayOnThePage(Widths(node=example.node, compact=False), GatewayInfo().to_hex().decode())
        page.memory.update(example.memory)
        for sent, answer in example.exchange:
            assert b"".join(page.answers(sent)) == answer
            answered += 1
    assert answered > 25


# Gateways


@pytest.mark.parametrize("amount", AMOUNTS)
@pytest.mark.parametrize("name", GATEWAYS)
def test_the_model_answers_cut_and_mixed_frames_as_the_page_says(name: str, amount: int) -> None:
    info, node = GATEWAYS[name]
    for seed in range(amount // LIFE):
        gateway = VirtualGateway(info, node=node)
        assert_agree(gateway, on_the_page(gateway, node), seed)


@pytest.mark.rtl
@pytest.mark.parametrize("amount", [1_000, pytest.param(100_000, marks=pytest.mark.campaign)])
def test_the_gateware_answers_cut_and_mixed_frames_as_the_page_says(amount: int) -> None:
    for seed in range(amount // LIFE):
        gateway = compiled(**COMPACT)
        assert_agree(gateway, on_the_page(gateway), seed)


@pytest.mark.parametrize("kind", ["sim", RTL])
@pytest.mark.parametrize("cut", [b"\n", b"\r", bytes((START, END)), bytes((ESCAPE, END))], ids=lambda cut: cut.hex())
def test_lost_bytes_and_length_are_reported_before_a_cut(kind: str, cut: bytes) -> None:
    gateway = (compiled if kind == "rtl" else simulated)(**COMPACT)
    longest = on_the_page(gateway).widths.longest
    begun = bytes((START, 0x30))
    assert gateway.receive(begun, 0.0) == b""
    gateway.overflow()
    assert gateway.receive(cut, 0.0)[:3] == b"X09"
    # The beginning has two characters of text; the end byte counts too.
    most = (longest - 3) // 2
    assert gateway.receive(begun + bytes(most) + cut, 0.0)[:3] == b"X01"
    assert gateway.receive(begun + bytes(most + 1) + cut, 0.0)[:3] == b"X07"


def test_the_end_of_a_datagram_cuts_a_compact_frame() -> None:
    gateway = VirtualGateway(INFO)
    sent: list[bytes] = []

    def execute(frames: bytes) -> None:
        datagrams.put(gateway.receive(frames, 0.0))

    def take(*frames: bytes) -> bytes:
        datagrams.take(b"".join(frames), 1)
        return sent.pop().partition(b"\n")[2] if sent else b""

    datagrams = GatewayDatagrams[int](Codec(INFO), execute, lambda datagram, _: sent.append(datagram), lambda: 7)
    page = GatewayOnThePage()
    page.answers(FRAMING.checked(b"K0009234"))
    frame = page.widths.pack(f"h000{page.widths.crc('h000', page.seed):04X}", from_gateway=False)
    assert take(frame[:-1]) == b"X01D488\n"
    assert take(FRAMING.checked(b"U0000000700000001"), FRAMING.checked(b"K0009234"))[:4] == b"K000"
    assert take(FRAMING.checked(b"U0000000700000002"), frame[:-1]) == b"X01D488\n"
    assert take(FRAMING.checked(b"U0000000700000003"), frame) == b"".join(page.answers(frame))


# Hosts


@pytest.mark.parametrize("amount", AMOUNTS)
@pytest.mark.parametrize("widths", HOSTS, ids=str)
def test_the_host_cuts_the_frames_of_a_gateway_as_the_page_says(widths: Widths, amount: int) -> None:
    form = CompactForm(widths.id_digits, widths.crc_digits, widths.address_digits, from_gateway=True)
    form = dataclasses.replace(form, has_node=widths.node is not None)
    for seed in range(amount // FRAMES):
        unpacker, arrived = Unpacker(form), from_a_gateway(widths, seed)
        assert lines_in(b"".join(map(unpacker.unpack, arrived))) == lines_on_the_page(widths, b"".join(arrived))


@pytest.mark.parametrize("amount", [500, pytest.param(100_000, marks=pytest.mark.campaign)])
def test_a_server_before_a_compact_gateway_answers_frames_as_the_page_says(amount: int) -> None:
    @on_simulated_time
    async def play(seed: int) -> None:
        async with sharing(VirtualGateway(INFO)) as shared:
            assert shared.codec is not None
            client = call(shared)
            page = GatewayOnThePage(widths_of(shared.codec.info), shared.codec.info.to_hex().decode())
            for piece, answer in Mixture(page, random.Random(seed)).pieces(LIFE):
                client.transport.write(piece)
                await settle(shared)
                assert (client.take(), piece) == (answer, piece)

    for seed in range(amount // LIFE):
        play(seed)
