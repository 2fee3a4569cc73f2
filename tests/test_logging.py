"""The log of a program: the level and the text for events of links, samples and leases."""

from __future__ import annotations

import asyncio
import contextlib
import logging
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.simulated_time import on_simulated_time
from support.valve import Valve, cut
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.build import simulated

if TYPE_CHECKING:
    from collections.abc import Callable

    Lines = Callable[[], list[tuple[str, str, str]]]

ROBOT = compile_text("""
group state(RATE=500, TIMESTAMPS);
public rover() {
  GATEWAY(ADDRESS_BITS=12, DATA_BITS=32);
  drive: LEASE(TIMEOUT=0.1) @(0xE0);
  @speed = 0x10: signed 32 READWRITE(SAFE(0, drive));
  @lamp = 0x18: READWRITE();
  @position = 0x20: READ(PUBLISH(state));
}
""")
SLOW = GatewayInfo(base_frequency_millihertz=1_000_000)
HERE = "the given gateway"
SILENT = "nothing arrived: check that the gateway is powered, the port and the wiring"


@pytest.fixture
def lines(caplog: pytest.LogCaptureFixture) -> Lines:
    """Return a function that returns the records since its last call: level, logger, message without the gateway."""
    caplog.set_level(logging.INFO, "unity_link.frames")
    caplog.set_level(logging.DEBUG, "unity_link")

    def taken() -> list[tuple[str, str, str]]:
        records = [(one.levelname, one.name, one.getMessage().removeprefix(f"{HERE}: ")) for one in caplog.records]
        caplog.clear()
        return records

    return taken


@on_simulated_time
async def test_thousands_of_requests_and_samples_log_no_record(lines: Lines) -> None:
    robot = unity_link.load(ROBOT)
    async with unity_link.connect(simulated(ROBOT.interface())) as link:
        assert lines() == [
            ("INFO", "unity_link.link", "connected"),
            ("INFO", "unity_link.link", "session 1 has begun"),
        ]
        rover = robot(link)
        async with rover.drive.armed() as lease:
            lines()
            async for sample in lease.each(rover.groups["state"]):
                await rover.speed.set(sample.sequence)
                await link.post(0x18, 1)
                if sample.sequence == 1000:
                    break
            await link.read_many([0x20] * 4000)
            await link.fence()
            assert lines() == []
        lines()
    assert link.statistics.requests > 5000
    assert lines() == [("INFO", "unity_link.link", "the link was closed")]


@on_simulated_time
async def test_a_reset_of_the_gateway_is_logged_as_a_warning(lines: Lines) -> None:
    gateway = VirtualGateway(SLOW)
    async with unity_link.connect(gateway) as link:
        lines()
        gateway.reset()
        with pytest.raises(unity_link.GatewayResetError):
            await link.write(1, 1)
        await link.write(1, 1)
        assert lines() == [
            ("WARNING", "unity_link.link", "the gateway was reset"),
            ("INFO", "unity_link.link", "session 2 has begun"),
        ]


@on_simulated_time
async def test_a_connection_that_is_opened_again_is_logged_as_a_warning(lines: Lines) -> None:
    valve = Valve(VirtualGateway(SLOW))
    async with unity_link.connect(valve, reconnect=unity_link.Reconnect(first_pause=1), timeout=1) as link:
        lines()
        valve.go_away(link)
        await asyncio.sleep(1.5)
        valve.come_back()
        await link.read(1)
        assert [line for line in lines() if line[2] != "connected"] == [
            ("WARNING", "unity_link.link", "the other side closed the connection; connecting again"),
            (
                "INFO",
                "unity_link.link",
                f"not connected (no gateway answered at {HERE} within 1 s; {SILENT}); trying again",
            ),
            ("INFO", "unity_link.link", "session 2 has begun"),
        ]


@on_simulated_time
async def test_the_end_of_a_lost_link_is_logged_once(lines: Lines) -> None:
    async with unity_link.connect(VirtualGateway(SLOW)) as link:
        lines()
        cut(link)
        with pytest.raises(unity_link.LinkLostError):
            await link.read(1)
    assert lines() == [("INFO", "unity_link.link", "the other side closed the connection")]


@on_simulated_time
async def test_requests_without_an_answer_in_time_are_logged_at_debug(lines: Lines) -> None:
    valve = Valve(VirtualGateway(SLOW))
    async with unity_link.connect(valve) as link:
        await link.read(1)
        lines()
        valve.requests_pass = False
        tasks = [asyncio.create_task(link.write(1, value)) for value in range(3)]
        await asyncio.sleep(0.001)
        valve.requests_pass = True
        await asyncio.gather(*tasks)
        why = "because no answer came in time"
        assert lines() == [("DEBUG", "unity_link.link", f"requests retransmitted: 3, {why}")]
        assert link.statistics.repetitions == 3


@on_simulated_time
async def test_requests_after_a_lost_answer_are_logged_at_debug(lines: Lines) -> None:
    valve = Valve(VirtualGateway(SLOW))
    async with unity_link.connect(valve) as link:
        await link.read(1)
        lines()
        valve.requests_pass = False
        first = asyncio.create_task(link.write(1, 1))
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        valve.requests_pass = True
        await asyncio.gather(first, link.write(1, 2))
        why = "because a frame was lost or damaged"
        assert lines() == [
            ("DEBUG", "unity_link.link", f"requests retransmitted: {link.statistics.repetitions}, {why}")
        ]


@on_simulated_time
async def test_the_first_loss_of_samples_is_a_warning_and_later_ones_debug(lines: Lines) -> None:
    valve = Valve(VirtualGateway(SLOW))
    async with unity_link.connect(valve) as link, link.subscribe([0x0A, 0x0B], rate_hz=100) as samples:
        await anext(samples)
        lines()
        for _ in range(2):
            valve.gateway.advance(asyncio.get_running_loop().time() + 0.03)
            while not (await anext(samples)).lost:
                pass
        (first, second) = lines()
        assert first[:2] == ("WARNING", "unity_link.link")
        assert first[2].startswith("samples of the group of 0x0A and 1 more lost: ")
        assert (second[0], second[2][:20]) == ("DEBUG", first[2][:20])


@on_simulated_time
async def test_a_reader_that_is_too_slow_is_logged_once(lines: Lines) -> None:
    async with unity_link.connect(VirtualGateway(SLOW)) as link:
        async with link.subscribe([0x0A], rate_hz=100, buffer=4) as samples:
            lines()
            await asyncio.sleep(1)
            assert samples.lost > 90
        text = "the reader of the group of 0x0A is too slow: its buffer (samples: 4) drops the oldest (logged once)"
        assert lines() == [("WARNING", "unity_link.link", text)]


@on_simulated_time
async def test_a_reader_that_wants_the_newest_sample_logs_no_loss(lines: Lines) -> None:
    async with unity_link.connect(VirtualGateway(SLOW)) as link:
        async with link.subscribe([0x0A], rate_hz=100, latest=True) as samples:
            lines()
            await asyncio.sleep(1)
            await anext(samples)
        assert lines() == []


@on_simulated_time
async def test_a_loop_over_a_signal_that_is_too_slow_is_logged_once(lines: Lines) -> None:
    async with unity_link.connect(simulated(ROBOT.interface())) as link:
        rover = unity_link.load(ROBOT)(link)
        with rover.groups["state"].feed.listen(buffer=4, overflow="drop_oldest") as listener:
            await listener.next()
            lines()
            await asyncio.sleep(1)
            await listener.next()
        text = "the reader of state is too slow: its buffer (samples: 4) drops the oldest (logged once)"
        assert lines() == [("WARNING", "unity_link.data", text)]


@on_simulated_time
async def test_a_lease_that_is_armed_and_disarmed_is_logged_at_info(lines: Lines) -> None:
    async with unity_link.connect(simulated(ROBOT.interface())) as link:
        rover = unity_link.load(ROBOT)(link)
        lines()
        async with rover.drive.armed(timeout=0.05):
            assert lines() == [("INFO", "unity_link.cores", "lease drive: armed, with a time-out of 0.05 s")]
        assert lines() == [("INFO", "unity_link.cores", "lease drive: disarmed")]
        await rover.drive.stop()
        assert lines() == [("INFO", "unity_link.cores", "lease drive: disarmed by a stop")]


@pytest.mark.parametrize("error", [None, ZeroDivisionError()])
@on_simulated_time
async def test_lease_without_kicks_is_logged_as_a_warning(lines: Lines, error: Exception | None) -> None:
    async with unity_link.connect(simulated(ROBOT.interface())) as link:
        rover = unity_link.load(ROBOT)(link)
        with contextlib.suppress(ZeroDivisionError):
            async with rover.drive.armed(timeout=0.05):
                lines()
                await asyncio.sleep(1)
                if error is not None:
                    raise error
        text = "lease drive: it ran out, because no kick came in time"
        assert lines() == [("WARNING", "unity_link.cores", text)]


@pytest.mark.parametrize("event", ["silence", "reset", "stop"])
@on_simulated_time
async def test_a_lease_that_a_kick_finds_ended_is_logged_once(lines: Lines, event: str) -> None:
    gateway = simulated(ROBOT.interface())

    async def kick_after(rover: Any) -> None:
        async with rover.drive.armed(timeout=0.05) as lease:
            if event == "reset":
                gateway.reset()
            elif event == "stop":
                await rover.drive.stop()
            lines()
            await asyncio.sleep(0.01 if event == "stop" else 1)
            for _ in range(3):
                await lease.kick()
                await asyncio.sleep(0.01)

    async with unity_link.connect(gateway) as link:
        with pytest.raises(unity_link.NotArmedError) as ended:
            await kick_after(unity_link.load(ROBOT)(link))
        of_leases = [line for line in lines() if line[1] == "unity_link.cores"]
        assert of_leases == [("INFO", "unity_link.cores", f"lease drive: {ended.value}")]


@pytest.mark.parametrize("arguments", [[], ["of a command"]])
def test_only_programs_show_warnings_without_a_handler_on_stderr(arguments: list[str]) -> None:
    code = """
import logging, sys
from unity_link.cli.output import quote_logs
if sys.argv[1:]:
    quote_logs()
for name in ("link", "data", "cores", "virtual"):
    logging.getLogger(f"unity_link.{name}").warning(name)
logging.getLogger("unity_link.link").error("an error")
"""
    command = [sys.executable, "-c", code, *arguments]
    shown = subprocess.run(command, check=True, capture_output=True, text=True, timeout=300).stderr.split("\n")
    assert shown == [*([] if arguments else ["link", "data", "cores"]), "virtual", "an error", ""]
