"""Links to gateways with the compact form: programs see no difference, and the line carries fewer bytes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import unity_link
from support.makers import RTL, SLOW, compiled, simulated
from support.simulated_time import on_simulated_time
from support.valve import Valve
from unity_link import blocking
from unity_link.bridges.serve import serve
from unity_link.capture.transcript import Transcript
from unity_link.protocol.wire.compact import END, START, text_of
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.virtual.line import SlowLine

if TYPE_CHECKING:
    from unity_link.virtual import BareGateway

FEATURES = int(GatewayInfo().features | Feature.COMPACT)
URL = f"sim:?features={FEATURES}"


def with_compact_form(kind: str) -> BareGateway:
    return compiled(features=FEATURES, crc_bits=32) if kind == "rtl" else simulated(**SLOW, features=FEATURES)


class Echoing(Valve):
    """Echoes each request before the answers to it."""

    def receive(self, data: bytes, now: float) -> bytes:
        return data + super().receive(data, now)


@pytest.mark.parametrize("kind", ["sim", RTL])
@on_simulated_time
async def test_words_blocks_batches_posts_and_samples_work_as_with_text(kind: str) -> None:
    valve = Valve(with_compact_form(kind))
    async with unity_link.connect(valve) as link:
        await link.write(5, 0xB5CAD30A)
        assert await link.read(5) == 0xB5CAD30A
        await link.write_block(0, range(0xCA00, 0xCAFF))
        assert (await link.read_block(0, 255)).tolist() == list(range(0xCA00, 0xCAFF))
        assert (await link.read_many(range(200))).tolist() == list(range(0xCA00, 0xCAC8))
        for value in range(300):
            await link.post(7, value)
        await link.fence()
        async with link.subscribe([7, 5], rate_hz=100, timestamps=False) as samples:
            sample = await anext(aiter(samples))
        assert sample.values.tolist() == [299, 0xCA05]
        assert link.statistics.damaged_frames == 0
        assert valve.heard.count(START) == valve.heard.count(END) > 500


@on_simulated_time
async def test_a_link_with_compact_off_sends_text() -> None:
    async with unity_link.connect(f"{URL}&compact=0") as link:
        before = link.statistics
        await link.read_many([0] * 100)
        counted = link.statistics
    assert counted.bytes_sent - before.bytes_sent == 100 * len("r00000cccc\n")
    assert counted.bytes_received - before.bytes_received == 100 * len("r000ddddddddcccc\n")


@on_simulated_time
async def test_a_batch_of_reads_takes_less_than_two_thirds_of_the_bytes_of_text() -> None:
    async with unity_link.connect(URL) as link:
        before = link.statistics
        await link.read_many([0] * 1000)
        counted = link.statistics
    assert counted.bytes_received - before.bytes_received < 1000 * 17 * 2 / 3


def test_an_option_other_than_0_or_1_is_refused() -> None:
    with pytest.raises(unity_link.ArgumentError, match=r"compact=2 in sim:\?compact=2 is neither 0 nor 1"):
        blocking.connect("sim:?compact=2")


@on_simulated_time
async def test_a_link_uses_text_on_an_adapter_that_echoes() -> None:
    valve = Echoing(with_compact_form("sim"))
    async with unity_link.connect(valve) as link:
        await link.write(1, 2)
        assert await link.read(1) == 2
    assert START not in valve.heard


@pytest.mark.parametrize("bytes_per_second", [960, 100_000])
@on_simulated_time
async def test_a_link_waits_for_long_answers_on_a_slow_line(bytes_per_second: int) -> None:
    async with unity_link.connect(SlowLine(with_compact_form("sim"), bytes_per_second), timeout=60) as link:
        for _ in range(5):
            assert len(await link.read_block(0, 255)) == 255
        assert link.statistics.repetitions == 0


@on_simulated_time
async def test_a_program_connects_while_samples_of_another_program_arrive() -> None:
    gateway = with_compact_form("sim")
    first = await unity_link.connect(gateway)
    async with first.subscribe(range(20), rate_hz=1000, timestamps=False) as samples:
        await anext(aiter(samples))
        async with unity_link.connect(gateway) as link:
            assert await link.read(0) == 0
    await first.aclose()


@pytest.mark.parametrize("kind", ["sim", RTL])
@on_simulated_time
async def test_after_a_reset_the_next_session_is_in_compact_form_again(kind: str) -> None:
    gateway = with_compact_form(kind)
    valve = Valve(gateway)
    async with unity_link.connect(valve) as link:
        await link.write(1, 2)
        gateway.reset()
        with pytest.raises(unity_link.GatewayResetError, match="known not to be executed"):
            await link.read(1)
        valve.heard = b""
        await link.write(1, 3)
        assert await link.read(1) == 3
    assert START in valve.heard


@pytest.mark.asyncio
async def test_a_shared_link_uses_text_with_its_clients() -> None:
    async with serve(URL, tcp=0) as served, unity_link.connect(served.urls[0]) as link:
        assert Feature.COMPACT not in link.gateway.features
        await link.write(1, 2)
        assert await link.read(1) == 2


@pytest.mark.parametrize("url", [f"{URL}&node=5", f"{URL}&flip=0.002&seed=3"])
@on_simulated_time
async def test_nodes_and_noisy_lines_work_as_with_text(url: str) -> None:
    async with unity_link.connect(url) as link:
        await link.write_many(range(200), range(200))
        assert (await link.read_many(range(200))).tolist() == list(range(200))


class Overheard(Valve):
    """Decodes the frames of both directions into words."""

    def __init__(self, gateway: BareGateway) -> None:
        super().__init__(gateway)
        self.words: list[str] = []
        self._transcript = Transcript()

    def receive(self, data: bytes, now: float) -> bytes:
        answers = super().receive(data, now)
        for passed, sent in ((data, True), (answers, False)):
            self.words += [timed.meaning.words for timed in self._transcript.take(passed, now, sent=sent)]
        return answers


@on_simulated_time
async def test_compact_frames_are_decoded_to_the_words_of_text_frames() -> None:
    overheard = Overheard(with_compact_form("sim"))
    async with unity_link.connect(overheard) as link:
        await link.write(0x0A, 42)
    words = "\n".join(overheard.words)
    assert "in compact form" in words
    assert "write to 0x0A done" in words
    assert "damaged" not in words


def test_bytes_of_the_compact_form_are_not_converted_without_the_feature() -> None:
    assert text_of(GatewayInfo(), from_gateway=True)(b"\xb5\x00\xca") == b"\xb5\x00\xca"
