"""Diagnostics of the bridges to ROS if a server is between bridge and gateway."""

from __future__ import annotations

import asyncio
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.recordings import InPlace
from support.sharing import PipedLink, sharing
from support.simulated_time import on_simulated_time
from support.valve import Valve
from unity_link import NotArmedError
from unity_link.bridges.diagnostics import ERROR, OK, STALE, WARN, Status
from unity_link.bridges.ros import RosBridge
from unity_link.bridges.ros_settings import BridgeSettings
from unity_link.spec import compile_file, compile_text
from unity_link.virtual.build import build_gateway, simulated
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from unity_link.data import Robot
    from unity_link.spec import Spec

SCARA = Path(__file__).parents[2] / "examples" / "scara.ul"
CHANGED_ALONE = compile_text("""
group changed(1, 10, ON_CHANGE);
public robot() { @a = 0x10: READ(PUBLISH(changed)); }
""")


class Bridge(RosBridge):
    """A bridge without subscribers, which stores the diagnostics that it publishes."""

    def __init__(self, robot: Robot) -> None:
        super().__init__(robot, BridgeSettings(), lambda _: None)
        self.told: list[Status] = []
        self.leases: list[Status] = []

    async def run(self) -> None:
        self._open_outlets()
        await self._carrier.run(InPlace(), self._diagnose(InPlace()))

    def _tell(self, statuses: list[Status], at: float) -> None:
        (link, *leases) = statuses
        self.told.append(link)
        self.leases = leases

    def _open_outlet(self, *_: Any) -> Any:
        return _Nobody

    def _resolve(self, name: str) -> str:
        return f"/{name}".rstrip("/")

    def _open_lease(self, *_: Any) -> Any:
        raise NotImplementedError

    def _programs(self, *_: Any) -> Any:
        raise NotImplementedError


class _Nobody:
    sent = lost = 0
    is_wanted = False


@pytest.mark.slow
@on_simulated_time
@pytest.mark.parametrize("spec", [compile_file(SCARA), CHANGED_ALONE], ids=["samples at a rate", "changes alone"])
async def test_absent_gateway_of_a_server_is_an_error_until_it_returns(spec: Spec) -> None:
    gateway = Valve(build_gateway("scara"))
    async with sharing(gateway) as shared, PipedLink(shared) as link:
        bridge = Bridge(unity_link.load(spec)(link))
        running = asyncio.create_task(bridge.run())
        levels = []
        for away, seconds in ((False, 2), (True, 8), (False, 8)):
            if away:
                gateway.go_away(shared)
            else:
                gateway.come_back()
            await asyncio.sleep(seconds)
            levels.append(bridge.told[-1][:3:2])
        assert link.connected
        running.cancel()
        await asyncio.wait([running])
    assert levels == [(OK, "connected"), (ERROR, "the gateway is away"), (OK, "connected")]


LEASED = compile_text("""
group state(RATE=10);
public rover() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=0.5) @(0xE0);
  arms[1]: part() @(0x100);
  @speed = 0x10: signed READWRITE(SAFE(0, drive), PUBLISH(state));
}
part(): @(at) { lift: LEASE(TIMEOUT=20) @(at); }
""")


@on_simulated_time
async def test_status_of_each_lease_has_its_state_and_since_when() -> None:
    gateway = Valve(simulated(LEASED.interface(), SimulatedRobot))
    async with unity_link.connect(gateway, reconnect=True) as link:
        robot: Any = unity_link.load(LEASED)(link)
        bridge = Bridge(robot)
        running = asyncio.create_task(bridge.run())

        async def drive() -> list[tuple[int, str]]:
            await asyncio.sleep(2)
            return [one[:3:2] for one in bridge.leases]

        nobody = (WARN, "disarmed: nobody has armed it since the reset")
        assert await drive() == [nobody, nobody]
        assert [one.name for one in bridge.leases] == [
            "unity_link_rover: lease drive",
            "unity_link_rover: lease arms[0].lift",
        ]
        async with robot.arms[0].lift.armed(timeout=15):
            assert await drive() == [nobody, (OK, "armed")]

        async def stand_still() -> None:
            async with robot.drive.armed() as lease:
                await asyncio.sleep(1)
                await lease.kick()

        with pytest.raises(NotArmedError):
            await stand_still()
        (fault, level), other = await drive()
        assert (fault, other) == (ERROR, (WARN, "disarmed: it was disarmed"))
        assert re.fullmatch(r"fault: no kick came before its end, at \d+\.\d{6} s of the gateway's clock", level)
        values = dict(bridge.leases[0].values)
        assert values | {"time of the fault (s)": ""} == {
            "state": "fault",
            "reason": "silence",
            "e-stop": "closed",
            "leases begun": "1",
            "time of the fault (s)": "",
        }
        assert 4 < float(values["time of the fault (s)"]) < 6
        gateway.go_away(link)
        await asyncio.sleep(3)
        assert await drive() == [(STALE, "the gateway is away")] * 2
        gateway.come_back()
        await asyncio.sleep(10)
        assert bridge.leases[0].level == ERROR
        running.cancel()
        await asyncio.wait([running])
