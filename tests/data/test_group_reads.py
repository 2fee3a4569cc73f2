"""Reads of groups: the same values and errors as reads of each signal, in a few requests."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import unity_link
from support.recorded_bus import RecordedBus
from support.simulated_time import run_simulated
from unity_link import BusError
from unity_link.data import Group
from unity_link.data.layout import MOST_BLOCKS
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from unity_link.spec import Spec

KINDS = [
    "{}: READWRITE()",
    "{}[7:0]: READWRITE()",
    "{}[15:9]: signed READWRITE()",
    "{}[31]: bool READWRITE()",
    "{}: signed 16 READWRITE()",
    "{}: unsigned 64 READWRITE()",
    "{}: fixed 24.8 READWRITE()",
    "{}: signed READWRITE(SCALE=0.25, OFFSET=3)",
    "{}: float 64 READWRITE()",
]
"""Declarations of signals after their names, as formats of an address."""


@st.composite
def places(draw: st.DrawFn) -> list[tuple[int, str]]:
    """Return addresses and declarations of signals, some of them at consecutive addresses, others with gaps."""
    found: list[tuple[int, str]] = []
    address = draw(st.integers(0, 20))
    for kind in draw(st.lists(st.sampled_from(KINDS), min_size=1, max_size=40)):
        found.append((address, kind))
        address += (2 if "64" in kind else 1) + draw(st.sampled_from([0, 0, 0, 0, 1, 5]))
    return found


def made(signals: list[tuple[int, str]]) -> Spec:
    """Return a spec with the signals."""
    lines = [f"@s{number} = {kind.format(address)};" for number, (address, kind) in enumerate(signals)]
    return compile_text("public robot() {\n  GATEWAY(ADDRESS_BITS=12);\n" + "\n".join(lines) + "\n}")


@given(signals=places(), words=st.lists(st.integers(0, 2**32 - 1), min_size=16, max_size=16), order=st.randoms())
def test_group_reads_what_its_signals_read_one_by_one(signals: Any, words: list[int], order: Any) -> None:
    async def compare() -> None:
        gateway = VirtualGateway()
        bus = RecordedBus(gateway)
        bus.words.update({address: words[address % 16] ^ address for address in range(256)})
        async with unity_link.connect(gateway) as link:
            robot: Any = unity_link.load(made(signals))(link)
            proxies = list(robot.signals)
            order.shuffle(proxies)
            values = await Group(*proxies).get()
            for proxy in proxies:
                alone = await proxy.get()
                assert values[proxy] == alone or (alone != alone and values[proxy] != values[proxy])  # noqa: PLR0124
                assert proxy.value == alone or alone != alone  # noqa: PLR0124

    run_simulated(compare())


@pytest.mark.parametrize(("gap", "requests"), [(0, 1), (1, 3 * MOST_BLOCKS)])
def test_runs_of_addresses_are_read_by_blocks_unless_there_are_many(gap: int, requests: int) -> None:
    async def count() -> int:
        gateway = VirtualGateway()
        RecordedBus(gateway)
        signals = [(number * (1 + gap), KINDS[0]) for number in range(3 * MOST_BLOCKS)]
        async with unity_link.connect(gateway) as link:
            robot: Any = unity_link.load(made(signals))(link)
            before = link.statistics.requests
            await Group(robot).get()
            return link.statistics.requests - before

    assert run_simulated(count()) == requests


def test_error_of_a_group_read_names_the_word_that_was_refused() -> None:
    async def read() -> None:
        gateway = VirtualGateway()
        RecordedBus(gateway, failing=frozenset({3}))
        async with unity_link.connect(gateway) as link:
            robot: Any = unity_link.load(made([(number, KINDS[0]) for number in range(6)]))(link)
            await Group(robot).get()

    with pytest.raises(BusError, match=r"^read of s3 at 0x03"):
        run_simulated(read())
