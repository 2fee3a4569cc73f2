"""Programs in several languages on one link: the generated client in C, Python, and a person at a terminal."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from itertools import accumulate
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from generate.programs import HERE, C, Driven, compiled, generated, linked
from support.spec_examples import FIGURE_1
from unity_link import blocking
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from collections.abc import Iterator

PROGRAM = str(Path(sys.executable).parent / "unity-link")


@pytest.fixture(scope="module")
def driver(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the client in C, built as a program that reads commands."""
    directory = tmp_path_factory.mktemp("driver")
    generated("c", compile_text(FIGURE_1), directory)
    sources = [directory / "unity_link.c", directory / "unity_link_posix.c", HERE / "driver.c"]
    return linked(C, compiled(C, sources, directory), directory / "driver")


@pytest.fixture
def place(tmp_path: Path) -> Iterator[Path]:
    """Share the virtual SCARA; yield the folder of its socket."""
    path = tmp_path / "shared.sock"
    arguments = [PROGRAM, "serve", "sim:scara", "--unix", str(path)]
    with subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=os.environ) as server:
        assert server.stdout is not None
        server.stdout.readline()
        try:
            yield path
        finally:
            server.terminate()
            server.communicate(timeout=60)


@pytest.mark.slow
def test_programs_in_c_and_python_and_a_person_share_a_robot(driver: Path, place: Path) -> None:
    url = f"unix:{place}"
    with (
        Driven(driver) as one,
        Driven(driver) as two,
        blocking.connect(url) as link,
        socket.socket(socket.AF_UNIX) as typed,
    ):
        one.words(f"connect {url} 30")
        two.words(f"connect {url} 30")
        # Both clients use the same group numbers, each for its own groups: 0x88 is a position, 0x8C its set point.
        one.words("subscribe 0 100 t 88")
        two.words("subscribe 0 50 t 8c 88")
        link.write(0x8C, 1200)
        with link.subscribe([0x8C], rate_hz=20) as samples:
            assert two.words("read 8c") == [1200]
            assert [int(next(iter(samples)).values[0]) for _ in range(3)] == [1200] * 3
            ones = [one("next 0 30").split() for _ in range(20)]
            twos = [two("next 0 30").split() for _ in range(20)]
        # A client that fetches samples too late loses some, and reports how many.
        assert numbers(ones) == [int(sample[1]) for sample in ones]
        assert numbers(twos) == [int(sample[1]) for sample in twos]
        assert {len(sample) for sample in ones} == {5}
        assert {len(sample) for sample in twos} == {6}
        typed.connect(str(place))
        typed.settimeout(60)
        typed.sendall(b"R8C\r\n")
        assert typed.recv(100) == b"R8C000004B0\r\n"
        two.words("close")
        one.words("write 8c 7")
        assert link.read(0x8C) == 7


def numbers(samples: list[list[str]]) -> list[int]:
    """Return the sequence numbers that samples must have, by the losses reported with each."""
    return [number - 1 for number in accumulate(int(sample[2]) + 1 for sample in samples)]
