"""The generated client in C reads frames of both forms as the page defines, and uses text if a line changes bytes."""

from __future__ import annotations

import random
import subprocess
from typing import TYPE_CHECKING

import pytest

from generate.programs import HERE, PATIENCE, SANITIZED, C, Driven, Simulated
from protocol_model.gateway_on_the_page import END, START, Widths
from protocol_model.mixed_frames import FRAMES, HOSTS, from_a_gateway, lines_in, lines_on_the_page
from support.changed_lines import DIRECTIONS, LINES, ChangedLine, on_a_port
from support.makers import SHORT, simulated
from unity_link.protocol.host.handshake import NOT_CARRIED
from unity_link.protocol.host.session import COMPACT_HINT
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.virtual.faults import Noise, NoisyLine

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

NODE = Widths(node=5)
FEATURES = int(GatewayInfo().features | Feature.COMPACT)
NO_CONNECTION = "36 "
WORDS = [0x00111300, 0xFFFFFFFF, 0xB5CAD30A, 0x0D800011]


@pytest.fixture(scope="module")
def expanding(runtime: list[Path]) -> Path:
    """Return a program that prints the text frames which the client makes of received bytes."""
    folder = runtime[0].parent
    options = [*SANITIZED, "-O1", f"-I{folder}", "-Wno-unused-function"]
    subprocess.run([*C, *options, HERE / "expanding.c", "-o", folder / "expanding"], check=True, timeout=PATIENCE)
    return folder / "expanding"


def texts(program: Path, cases: Iterable[tuple[Widths, int, bytes]]) -> list[list[bytes]]:
    """Return, for each case, the lines that the client makes of a gateway's bytes, read `size` bytes at a time."""
    words = [
        f"{widths.id_digits} {widths.crc_digits} {widths.address_digits} {-1 if widths.node is None else widths.node} "
        f"{size} {data.hex().upper()}\n"
        for widths, size, data in cases
    ]
    result = subprocess.run([program], input="".join(words), capture_output=True, text=True, timeout=None, check=False)
    assert result.returncode == 0, result.stderr[:4000]
    return [lines_in(bytes.fromhex(line)) for line in result.stdout.splitlines()]


@pytest.mark.parametrize("amount", [2_000, pytest.param(25_000, marks=pytest.mark.campaign)])
@pytest.mark.parametrize("widths", HOSTS, ids=str)
def test_cut_and_mixed_frames_become_the_lines_that_the_page_defines(
    expanding: Path, widths: Widths, amount: int
) -> None:
    draw = random.Random(1)
    sent = [b"".join(from_a_gateway(widths, seed)) for seed in range(amount // FRAMES)]
    found = texts(expanding, [(widths, draw.choice([1, 2, 7, 100, 5000]), data) for data in sent])
    for lines, data in zip(found, sent, strict=True):
        assert lines == lines_on_the_page(widths, data)


@pytest.mark.parametrize("flood", [bytes((START,)), bytes((START, 0x10)), bytes((START, 5, 0x10)), bytes((END,))])
@pytest.mark.parametrize("widths", [Widths(), NODE], ids=["alone", "node"])
def test_a_flood_of_cut_frames_stays_within_the_buffer(expanding: Path, widths: Widths, flood: bytes) -> None:
    data = flood * 10_000
    assert texts(expanding, [(widths, 5000, data)]) == [lines_on_the_page(widths, data)]


# Lines that change bytes


@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("fields", [{}, SHORT], ids=["CRC-16", "CRC-8"])
@pytest.mark.parametrize("name", LINES)
def test_a_link_uses_text_or_ends_with_a_sentence_within_its_time_out(
    driver: Path, name: str, fields: dict[str, int], direction: str
) -> None:
    line = ChangedLine(simulated(**fields, features=FEATURES), LINES[name], direction)
    with Simulated(driver, line.receive) as client:
        told = client("connect test: 2")
        if told.startswith(NO_CONNECTION):
            assert client.now <= 2.01
            assert not LINES[name].carries_text or (LINES[name].stops and told == NO_CONNECTION + NOT_CARRIED)
            return
        assert LINES[name].carries_text
        assert START in line.sent
        line.sent = b""
        for address, word in enumerate(WORDS):
            client.words(f"write {address:X} {word:X}")
            assert client.words(f"read {address:X}") == [word]
        client("close")
    assert START not in line.sent


@pytest.mark.parametrize("name", ["seven bits", "NUL taken out"])
def test_link_on_a_real_port_uses_text(client: Driven, name: str) -> None:
    with on_a_port(ChangedLine(simulated(features=FEATURES), LINES[name]), "tcp") as url:
        client.words(f"connect {url} 5")
        client.words(f"write 1 {WORDS[0]:X}")
        assert client.words("read 1") == [WORDS[0]]
        client.words("close")


def test_an_error_of_a_session_in_compact_form_names_the_option(driver: Path) -> None:
    gateway, is_broken = simulated(features=FEATURES), False

    def answers(data: bytes, now: float) -> bytes:
        answer = gateway.receive(data, now)
        return bytes(byte & 0x7F for byte in answer) if is_broken else answer

    with Simulated(driver, answers) as client:
        client.words("connect test: 5")
        is_broken = True
        assert COMPACT_HINT in client("write 10 1")
        client("close")


@pytest.mark.parametrize("seed", range(10))
def test_noise_at_the_opening_costs_the_form_at_most(driver: Path, seed: int) -> None:
    gateway = simulated(features=FEATURES)
    line = NoisyLine(gateway, Noise(2 * seed, flip=0.01, loss=0.01), Noise(2 * seed + 1, flip=0.01, loss=0.01))
    with Simulated(driver, line.receive) as client:
        client.words("connect test: 5")
        for address, word in enumerate(WORDS):
            client.words(f"write {address:X} {word:X}")
            assert client.words(f"read {address:X}") == [word]
        client("close")
