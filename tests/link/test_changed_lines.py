"""Links on lines that do not carry every byte use text, or end with a one-sentence error within their time-out."""

from __future__ import annotations

import asyncio
import re

import pytest

import unity_link
from support.changed_lines import DIRECTIONS, LINES, ChangedLine, on_a_port
from support.makers import CRC_32, SHORT, SLOW, simulated
from support.searching import seeds
from support.simulated_time import on_simulated_time
from support.valve import Valve
from unity_link import blocking
from unity_link.bridges.serve import serve
from unity_link.protocol.host.handshake import NOT_CARRIED
from unity_link.protocol.host.session import COMPACT_HINT
from unity_link.protocol.host.trial import IDS
from unity_link.protocol.wire.compact import START
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.virtual.faults import Noise, NoisyLine

FEATURES = int(GatewayInfo().features | Feature.COMPACT)
WORDS = [0x00111300, 0xFFFFFFFF, 0xB5CAD30A, 0x0D800011]
TIMEOUT = 2.0
CARRYING_TEXT = [name for name, line in LINES.items() if line.carries_text and not line.stops]


@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("fields", [{}, SHORT, CRC_32], ids=["CRC-16", "CRC-8", "CRC-32"])
@pytest.mark.parametrize("name", LINES)
@on_simulated_time
async def test_a_link_uses_text_or_reports_an_error_within_its_time_out(
    name: str, fields: dict[str, int], direction: str
) -> None:
    line = ChangedLine(simulated(**SLOW, **fields, features=FEATURES), LINES[name], direction)
    began = asyncio.get_running_loop().time()
    link, refusal = None, ""
    try:
        link = await unity_link.connect(line, timeout=TIMEOUT)
    except unity_link.ConnectError as error:
        refusal = str(error)
    if link is None:
        assert asyncio.get_running_loop().time() - began <= TIMEOUT
        assert re.fullmatch(r"no gateway answered at .* within 2 s; [^\n]*", refusal)
        # A CRC may include an XOFF, which no XON follows.
        assert not LINES[name].carries_text or (LINES[name].stops and NOT_CARRIED in refusal)
        return
    assert LINES[name].carries_text
    async with link:
        assert START in line.sent
        line.sent = b""
        for address, word in enumerate(WORDS):
            await link.write(address, word)
            assert await link.read(address) == word
        await link.write_block(16, WORDS * 10)
        assert (await link.read_block(16, 40)).tolist() == WORDS * 10
        assert link.statistics.damaged_frames == 0
        assert START not in line.sent


@pytest.mark.parametrize("name", CARRYING_TEXT)
@pytest.mark.asyncio
async def test_a_server_for_a_compact_gateway_shares_a_line_that_changes_bytes(name: str) -> None:
    line = ChangedLine(simulated(**SLOW, features=FEATURES), LINES[name])
    async with serve(line, tcp=0) as served, unity_link.connect(served.urls[0]) as link:
        await link.write(1, WORDS[0])
        assert await link.read(1) == WORDS[0]


@pytest.mark.parametrize("kind", ["tcp", "pty"])
@pytest.mark.parametrize("name", [name for name, line in LINES.items() if not line.stops])
def test_a_link_at_a_real_port_uses_text_or_reports_an_error(name: str, kind: str) -> None:
    line = ChangedLine(simulated(features=FEATURES), LINES[name])
    with on_a_port(line, kind) as url:
        if LINES[name].carries_text:
            with blocking.connect(url) as link:
                link.write(1, WORDS[0])
                assert link.read(1) == WORDS[0]
        else:
            with pytest.raises(unity_link.ConnectError, match=r"CR or LF"):
                blocking.connect(url, timeout=0.5)


@on_simulated_time
async def test_a_reset_causes_no_second_trial_of_the_line() -> None:
    gateway = simulated(**SLOW, features=FEATURES)
    valve = Valve(gateway)
    async with unity_link.connect(valve) as link:
        first = valve.heard.count(START)
        gateway.reset()
        with pytest.raises(unity_link.GatewayResetError):
            await link.write(1, 2)
        valve.heard = b""
        await link.write(1, 2)
        assert (first, valve.heard.count(START)) == (len(IDS[3]), 1)


class BrokenLater(Valve):
    """A line that clears the highest bit of each byte once `is_broken` is set."""

    is_broken = False

    def receive(self, data: bytes, now: float) -> bytes:
        answers = super().receive(data, now)
        return bytes(byte & 0x7F for byte in answers) if self.is_broken else answers


@on_simulated_time
async def test_the_error_on_a_line_that_changes_bytes_later_names_the_option() -> None:
    line = BrokenLater(simulated(**SLOW, features=FEATURES))
    async with unity_link.connect(line) as link:
        await link.write(1, 2)
        line.is_broken = True
        with pytest.raises(unity_link.UnityLinkError, match=re.escape(COMPACT_HINT.strip())):
            await link.write(1, 3)


@on_simulated_time
async def test_the_error_in_text_form_does_not_name_the_option() -> None:
    line = BrokenLater(simulated(**SLOW))
    async with unity_link.connect(line) as link:
        line.answers_pass = False
        with pytest.raises(unity_link.LinkLostError) as told:
            await link.write(1, 3)
    assert "compact" not in str(told.value)


@pytest.mark.parametrize("seed", seeds(10, 300))
@on_simulated_time
async def test_noise_at_the_opening_costs_at_most_the_compact_form(seed: int) -> None:
    gateway = simulated(**SLOW, features=FEATURES)
    line = NoisyLine(gateway, Noise(2 * seed, flip=0.01, loss=0.01), Noise(2 * seed + 1, flip=0.01, loss=0.01))
    async with unity_link.connect(line) as link:
        for address, word in enumerate(WORDS):
            await link.write(address, word)
            assert await link.read(address) == word
