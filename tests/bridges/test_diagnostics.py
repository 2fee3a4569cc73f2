"""Diagnostics of the bridges to ROS where a server stands before the gateway."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.recordings import InPlace
from support.sharing import PipedLink, sharing
from support.simulated_time import on_simulated_time
from support.valve import Valve
from unity_link.bridges.diagnostics import ERROR, OK, Status
from unity_link.bridges.ros import RosBridge
from unity_link.spec import compile_file, compile_text
from unity_link.virtual.build import build_gateway

if TYPE_CHECKING:
    from unity_link.data import Robot
    from unity_link.spec import Spec

SCARA = Path(__file__).parents[2] / "examples" / "scara.ul"
CHANGED_ALONE = compile_text("""
group changed(1, 10, ON_CHANGE);
public robot() { @a = 0x10: READ(PUBLISH(changed)); }
""")


class Bridge(RosBridge[Any]):
    """A bridge without subscribers; keeps the diagnostics that it publishes."""

    def __init__(self, robot: Robot) -> None:
        super().__init__(robot, None, None, "", lambda _: None)
        self.told: list[Status] = []

    async def run(self) -> None:
        self._open_outlets()
        await self._carrier.run(InPlace(), self._diagnose(InPlace()))

    def _tell(self, status: Status, at: float) -> None:
        self.told.append(status)

    def _open_outlet(self, *_: Any) -> Any:
        return _Nobody

    def _number_rows(self, *_: Any) -> Any:
        raise NotImplementedError

    def _joint_rows(self, *_: Any) -> Any:
        raise NotImplementedError


class _Nobody:
    sent = lost = 0
    is_wanted = False


@on_simulated_time
@pytest.mark.parametrize("spec", [compile_file(SCARA), CHANGED_ALONE], ids=["samples at a rate", "changes alone"])
async def test_a_gateway_that_is_away_behind_a_server_is_an_error_until_it_is_back(spec: Spec) -> None:
    gateway = Valve(build_gateway("scara"))
    async with sharing(gateway) as shared, PipedLink(shared) as link:
        bridge = Bridge(unity_link.load(spec)(link))
        running = asyncio.create_task(bridge.run())
        levels = []
        for away in (False, True, False):
            if away:
                gateway.go_away(shared)
            else:
                gateway.come_back()
            await asyncio.sleep(10)
            levels.append(bridge.told[-1][:3:2])
        assert link.connected
        running.cancel()
        await asyncio.wait([running])
    assert levels == [(OK, "connected"), (ERROR, "the gateway is away"), (OK, "connected")]
