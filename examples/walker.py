"""A walking robot of 18 joints takes steps, three legs at a time, and reports how well its joints follow.

python examples/walker.py             # the virtual robot: no hardware
python examples/walker.py rtl:walker  # the same behind the gateware itself, compiled
python examples/walker.py tcp://robot.local:7000
"""

from __future__ import annotations

import asyncio
import contextlib
import math
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

import unity_link
from unity_link.data import Batch, Group, GroupSubscription

if TYPE_CHECKING:
    from collections.abc import Sequence

Walker = unity_link.load(Path(__file__).with_name("walker.ul"))

STEP, STEP_TIME = 0.4, 0.8
"""Swing of a leg, in rad, and duration of a step, in s."""
STEPS, RATE = 4, 50
"""Number of steps, and of new set points a second."""


def gait(time: float) -> list[float]:
    """Return the angles of all joints: coxa, femur and tibia of legs 1 to 6, in rad.

    Legs 1, 3 and 5 swing forward through the air while 2, 4 and 6 push back on the ground, and the other way round.
    """
    angles = []
    for leg in range(6):
        phase = math.pi * (time / STEP_TIME + leg % 2)
        lift = max(0.0, math.sin(phase))
        angles += [-STEP * math.cos(phase), 0.3 + 0.4 * lift, -0.8 - 0.2 * lift]
    return angles


class Watcher:
    """Stores the samples of the robot's group."""

    def __init__(self, joints: Sequence[Any]) -> None:
        self.batches: list[Batch] = []
        self.fastest = np.zeros(len(joints))
        self._joints = joints

    async def watch(self, samples: GroupSubscription) -> None:
        """Store samples until the subscription ends."""
        # The samples end with the block of the subscription.
        with contextlib.suppress(StopAsyncIteration):
            while True:
                batch = await samples.take()
                self.batches.append(batch)
                speeds = [np.abs(batch[joint.spd]).max() for joint in self._joints]
                self.fastest = np.maximum(self.fastest, speeds)


async def walk(url: str) -> Watcher:
    """Walk, and return the watcher with all samples.

    Raises:
        UnityLinkError: the gateway is not that of a walker, or is lost.
    """
    async with unity_link.connect(url) as link:
        robot = Walker(link)
        joints = [joint for leg in robot.legs for joint in (leg.coxa, leg.femur, leg.tibia)]
        targets = Group(*(joint.pos_sp for joint in joints))
        await Group(*(joint.spd_sp for joint in joints)).set(np.full(len(joints), 8.0))

        loop = asyncio.get_running_loop()
        watcher = Watcher(joints)
        async with robot.groups["state"].subscribe() as samples:
            watching = asyncio.create_task(watcher.watch(samples))
            began = loop.time()
            for turn in range(int(STEPS * STEP_TIME * RATE)):
                await targets.set(gait(turn / RATE))
                await asyncio.sleep(began + (turn + 1) / RATE - loop.time())
                if turn % RATE == 0:
                    errors = [
                        abs(joint.cpos.value - joint.pos_sp.value) for joint in joints if joint.cpos.value is not None
                    ]
                    print(f"{turn / RATE:4.1f} s: joints are up to {max(errors, default=0):.3f} rad behind")
        await watching
        if not watcher.fastest.any():
            raise unity_link.UnityLinkError(
                f"{url}: not one joint has moved in {samples.received} samples: is it a walker?"
            )
        print(f"{samples.received} samples of {len(robot.groups['state'])} values, {samples.lost} lost")
        print(f"the fastest joint made {watcher.fastest.max():.1f} rad/s")
        return watcher


if __name__ == "__main__":
    try:
        asyncio.run(walk(sys.argv[1] if len(sys.argv) > 1 else "sim:walker"))
    except unity_link.UnityLinkError as error:
        sys.exit(f"error: {error}")
    except KeyboardInterrupt:
        sys.exit(130)
