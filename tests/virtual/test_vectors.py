"""The model answers the shared vectors, however the bytes are cut."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from support.by_path import imported
from support.searching import examples
from unity_link.protocol.wire.compact import cut, is_sample
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing

FOLDER = Path(__file__).resolve().parents[1] / "vectors"
FILES = sorted(FOLDER.glob("*.ndjson"))


def load(path: Path) -> tuple[VirtualGateway, list[dict[str, Any]]]:
    header, *steps = map(json.loads, path.read_text().splitlines())
    values = header["configuration"]
    info = GatewayInfo(**{**values, "features": Feature(values["features"])})
    gateway = VirtualGateway(info, node=header["node"])
    gateway.attach(Failing(ErrorCode.BUS_ERROR), header["bus_error"])
    gateway.attach(Failing(ErrorCode.BUS_TIMEOUT), header["bus_timeout"])
    return gateway, steps


def split(answer: bytes, node: int | None) -> tuple[bytes, bytes]:
    """Return responses and samples."""
    prefix = b"" if node is None else b"Z%02X" % node
    frames = cut(answer)
    assert b"".join(frames) == answer
    return (
        b"".join(frame for frame in frames if not is_sample(frame, prefix)),
        b"".join(frame for frame in frames if is_sample(frame, prefix)),
    )


def expected(step: dict[str, Any]) -> tuple[bytes, bytes]:
    return step["answers"].encode("latin-1"), step.get("publishes", "").encode("latin-1")


def node_of(path: Path) -> int | None:
    node: int | None = json.loads(path.read_text().splitlines()[0])["node"]
    return node


def test_there_are_vectors_for_several_configurations() -> None:
    assert len(FILES) >= 6


@pytest.mark.slow
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_the_model_answers_every_vector_exactly(path: Path) -> None:
    gateway, steps = load(path)
    for step in steps:
        answer = gateway.receive(step["send"].encode("latin-1"), 0.0)
        assert split(answer, node_of(path)) == expected(step), step["about"]


@pytest.mark.slow
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_each_sample_precedes_the_answer_to_the_request_that_took_it(path: Path) -> None:
    gateway, steps = load(path)
    for step in steps:
        frames = cut(gateway.receive(step["send"].encode("latin-1"), 0.0))
        kinds = [bool(split(frame, node_of(path))[1]) for frame in frames]
        if step["about"] == "a damaged compact frame":
            # It may cut off the frame of the step before, which causes an error beside it.
            assert all(kinds[at + 1 : at + 2] == [False] for at, is_one in enumerate(kinds) if is_one), step["about"]
        else:
            assert not any(kinds) or kinds == [True, False] * (len(kinds) // 2), step["about"]


@pytest.mark.slow
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_bytes_may_arrive_one_at_a_time(path: Path) -> None:
    gateway, steps = load(path)
    for step in steps:
        answer = b"".join(gateway.receive(bytes([byte]), 0.0) for byte in step["send"].encode("latin-1"))
        assert split(answer, node_of(path)) == expected(step), step["about"]


@pytest.mark.slow
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
@settings(max_examples=examples(20))  # each goes through a whole file
@given(sizes=st.lists(st.integers(1, 5000), min_size=1, max_size=40))
def test_bytes_may_arrive_in_pieces_of_any_size(path: Path, sizes: list[int]) -> None:
    gateway, steps = load(path)
    stream = b"".join(step["send"].encode("latin-1") for step in steps)
    answer, position, turn = b"", 0, 0
    while position < len(stream):
        size = sizes[turn % len(sizes)] if len(sizes) > 1 else max(sizes[0], 100)
        answer += gateway.receive(stream[position : position + size], 0.0)
        position, turn = position + size, turn + 1
    both = split(answer, node_of(path))
    assert both[0] == b"".join(expected(step)[0] for step in steps)
    assert both[1] == b"".join(expected(step)[1] for step in steps)


def test_the_files_are_as_the_generator_writes_them() -> None:
    generator = imported(FOLDER / "generate.py")
    assert sorted(generator.CONFIGURATIONS) == [path.stem for path in FILES]
    for path in FILES:
        assert generator.generate(path.stem) == path.read_text(), path.name
