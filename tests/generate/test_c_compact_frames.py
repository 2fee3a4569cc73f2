"""The generated client in C cuts what a gateway sends, in both forms, as the page says."""

from __future__ import annotations

import random
import subprocess
from typing import TYPE_CHECKING

import pytest

from generate.programs import HERE, PATIENCE, SANITIZED, C
from protocol_model.gateway_on_the_page import END, START, Widths
from protocol_model.mixed_frames import FRAMES, HOSTS, from_a_gateway, lines_in, lines_on_the_page

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

NODE = Widths(node=5)


@pytest.fixture(scope="module")
def expanding(runtime: list[Path]) -> Path:
    """Return a program that prints what the client makes of bytes."""
    folder = runtime[0].parent
    options = [*SANITIZED, "-O1", f"-I{folder}", "-Wno-unused-function"]
    subprocess.run([*C, *options, HERE / "expanding.c", "-o", folder / "expanding"], check=True, timeout=PATIENCE)
    return folder / "expanding"


def texts(program: Path, cases: Iterable[tuple[Widths, int, bytes]]) -> list[list[bytes]]:
    """Return the lines that the client makes of bytes of a gateway, so many at a time, for each case."""
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
def test_cut_and_mixed_frames_become_the_lines_that_the_page_says(expanding: Path, widths: Widths, amount: int) -> None:
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
