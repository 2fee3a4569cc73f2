"""Write requests of a Zenoh peer: any bytes may arrive, and only valid requests are executed."""

from __future__ import annotations

import asyncio
import contextlib
from pathlib import Path
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

import unity_link
from support.bridge_programs import WRITES_NAMES, WRITES_SPEC
from unity_link import ArgumentError
from unity_link.bridges.merged_writes import write_in_order
from unity_link.bridges.zenoh.writing import Reader
from unity_link.data import load

SCALARS = st.none() | st.booleans() | st.integers(-(2**70), 2**70) | st.floats(allow_nan=False) | st.text(max_size=5)
JSON = st.recursive(
    SCALARS, lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(WRITES_NAMES), inner)
)


@pytest.fixture(scope="module")
def robot_type(tmp_path_factory: pytest.TempPathFactory) -> Any:
    spec = Path(tmp_path_factory.mktemp("spec") / "all.ul")
    spec.write_text(WRITES_SPEC)
    return load(spec)


@pytest.mark.slow
@given(payload=JSON.map(msgspec.json.encode) | st.binary(max_size=30) | st.just(b'{"word":1e999}'))
def test_any_payload_is_written_or_refused_in_one_sentence(robot_type: Any, payload: bytes) -> None:
    async def write() -> None:
        async with unity_link.connect("sim:") as link:
            reader = Reader(robot_type(link))
            for _ in range(2):
                with contextlib.suppress(ArgumentError):
                    await write_in_order(reader.read(payload), posted=True)

    asyncio.run(write())


@pytest.mark.parametrize(
    "payload", [b"[" * 100_000, b'{"word": 1001}', b'{"word": 1e999}', b"\xff", b"", b'{"seen": 1}']
)
def test_payload_that_cannot_be_written_is_refused(robot_type: Any, payload: bytes) -> None:
    async def write() -> None:
        async with unity_link.connect("sim:") as link:
            with pytest.raises(ArgumentError):
                Reader(robot_type(link)).read(payload)

    asyncio.run(write())


@pytest.mark.parametrize("posted", [False, True])
def test_words_fields_and_wide_values_are_written_in_the_order_of_objects(robot_type: Any, posted: bool) -> None:
    async def write() -> dict[str, Any]:
        async with unity_link.connect("sim:") as link:
            robot = robot_type(link)
            reader = Reader(robot)
            payload = b'[{"word": 1, "wide": 4294967296}, {"word": 2, "scaled": -1.5}, {"mode": "run"}, {"flag": true}]'
            await write_in_order(reader.read(payload), posted=posted)
            await link.fence()
            return {name: await robot[name].get() for name in WRITES_NAMES[:5]}

    assert asyncio.run(write()) == {"word": 2, "scaled": -1.5, "flag": True, "mode": 1, "wide": 1 << 32}
