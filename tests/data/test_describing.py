"""Robots of boards that carry the description of their spec."""

from __future__ import annotations

import asyncio
import zlib
from pathlib import Path
from typing import Any

import pytest

import unity_link
from support.simulated_time import on_simulated_time
from unity_link.data.describing import read_spec
from unity_link.errors import UnsupportedError
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.description import PAGE_WORDS, page_address, words_of
from unity_link.spec import compile_file
from unity_link.virtual.build import put_behind_line, simulate

BALANCER = Path(__file__).parents[2] / "examples" / "balancer" / "balancer.ul"


@on_simulated_time
async def test_a_described_robot_has_names_units_limits_and_the_core_apis() -> None:
    async with unity_link.connect(f"sim:{BALANCER}") as link:
        robot = await unity_link.robot(link)
        assert Feature.DESCRIPTION in link.gateway.features
        assert robot.interface.fingerprint == compile_file(BALANCER).interface().fingerprint
        assert (robot.left.value.unit, robot.left.value.signal.maximum) == ("V", 12)
        async with robot.armed(timeout=0.1):
            await robot.left.value.set(3)
            assert await robot.left.value.get() == pytest.approx(3, abs=0.01)


@on_simulated_time
async def test_a_description_is_read_within_two_seconds_at_a_megabaud() -> None:
    async with unity_link.connect(put_behind_line(simulate(BALANCER), bytes_per_second=100_000)) as link:
        began = asyncio.get_running_loop().time()
        await unity_link.robot(link)
        assert asyncio.get_running_loop().time() - began < 2


@on_simulated_time
async def test_concurrent_readers_of_a_description_read_it_completely() -> None:
    async with unity_link.connect(f"sim:{BALANCER}") as link:
        turns = 0

        class Turned:
            """The link, while another reader selects page 0 from time to time."""

            gateway = link.gateway

            async def post(self, address: int, value: int) -> None:
                nonlocal turns
                turns += 1
                await link.post(address, 0 if turns in {3, 10} else value)

            def __getattr__(self, name: str) -> Any:
                return getattr(link, name)

        turned: Any = Turned()
        spec = await read_spec(turned)
        assert spec.interface().fingerprint == compile_file(BALANCER).interface().fingerprint
        assert turns > 17


@on_simulated_time
async def test_the_error_for_a_gateway_without_a_description_says_so() -> None:
    async with unity_link.connect("sim:") as link:
        with pytest.raises(UnsupportedError, match="carries no description: give the spec that it was built from"):
            await unity_link.robot(link)


@on_simulated_time
async def test_a_permanently_damaged_description_is_refused() -> None:
    async with unity_link.connect(f"sim:{BALANCER}") as link:

        class Damaged:
            gateway = link.gateway

            async def read_block(self, address: int, count: int) -> list[int]:
                words = [int(word) for word in await link.read_block(address, count)]
                return [*words[:5], words[5] ^ 1, *words[6:]]

            def __getattr__(self, name: str) -> Any:
                return getattr(link, name)

        damaged: Any = Damaged()
        with pytest.raises(UnsupportedError, match="description cannot be read: its CRC is wrong"):
            await read_spec(damaged)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (
            "public r() { " + "@s = q; " * 1000 + "}",
            "cannot be read by this version: ':', '(' or '[' was expected, not ';'",
        ),
        (f"public r() {{ @{'n' * 9000} = 0: NONE(); }}", "cannot be read by this version: there is no access 'NONE'"),
        (f"public r() {{ @s = 0: READ(UNIT={'u' * 9000}); }}", f"read by this version: nothing is called '{'u' * 280}"),
        (
            f"public r() {{ @s = {'-' * 1_000_000}1: READ(); }}",
            "cannot be used (it has more signals, words or expressions",
        ),
        ("\0", "cannot be read by this version: the control character U+0000 is not allowed"),
    ],
)
@on_simulated_time
async def test_a_description_that_cannot_be_used_is_refused_in_one_sentence(text: str, says: str) -> None:
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    description = packer.compress(text.encode()) + packer.flush()
    async with unity_link.connect(f"sim:{BALANCER}") as link:

        class Described:
            gateway = link.gateway

            def __init__(self) -> None:
                self.words = words_of(description, link.gateway.data_bits)
                self.page = 0

            async def post(self, _: int, page: int) -> None:
                self.page = page

            async def read_block(self, _: int, count: int) -> list[int]:
                return [self.page, *self.words[self.page * PAGE_WORDS :][: count - 1]]

        described: Any = Described()
        with pytest.raises(UnsupportedError) as refusal:
            await read_spec(described)
    sentence = str(refusal.value)
    assert says in sentence
    assert sentence.startswith("the gateway's description ")
    assert "\n" not in sentence
    assert len(sentence) < 400


@on_simulated_time
async def test_the_page_address_of_a_described_gateway_cannot_be_written() -> None:
    async with unity_link.connect(f"sim:{BALANCER}") as link:
        with pytest.raises(unity_link.BusError):
            await link.write(page_address(link.gateway.address_bits) + 1, 0)
