"""A walking robot of 18 joints takes steps, three legs at a time, and reports how well its joints follow.

python examples/walker.py             # the virtual robot: no hardware
python examples/walker.py tcp://robot.local:7000
"""

from __future__ import annotations

import asyncio
import math
import sys
from pathlib import Path

import numpy as np

import unity_link
from unity_link.data import Batch, Group

Walker = unity_link.load(Path(__file__).with_name("walker.ul"))

STEP, STEP_TIME = 0.4, 0.8
"""How far a leg swings, in rad, and how long a step takes, in s."""
STEPS, RATE = 4, 50
"""How many steps, and how many new set points a second."""


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


async def main(url: str) -> None:
    """Walk."""
    async with unity_link.connect(url) as link:
        robot = Walker(link)
        joints = [joint for leg in robot.legs for joint in (leg.coxa, leg.femur, leg.tibia)]
        targets = Group(*(joint.pos_sp for joint in joints))
        await Group(*(joint.spd_sp for joint in joints)).set(np.full(len(joints), 8.0))

        fastest = np.zeros(len(joints))
        samples = 0

        def watch(batch: Batch) -> None:
            nonlocal samples
            samples += len(batch)
            for number, joint in enumerate(joints):
                fastest[number] = max(fastest[number], np.abs(batch[joint.spd]).max())

        loop = asyncio.get_running_loop()
        began = loop.time()
        with robot.groups["state"].on_batch(watch):
            for turn in range(int(STEPS * STEP_TIME * RATE)):
                await targets.set(gait(turn / RATE))
                await asyncio.sleep(began + (turn + 1) / RATE - loop.time())
                if turn % RATE == 0:
                    errors = [
                        abs(joint.cpos.value - joint.pos_sp.value) for joint in joints if joint.cpos.value is not None
                    ]
                    print(f"{turn / RATE:4.1f} s: joints are up to {max(errors, default=0):.3f} rad behind")

        print(f"{samples} samples of {len(robot.groups['state'])} values, {link.statistics.samples_lost} lost")
        print(f"the fastest joint made {fastest.max():.1f} rad/s")


if __name__ == "__main__":
    try:
        asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else "sim:walker"))
    except unity_link.UnityLinkError as error:
        sys.exit(f"error: {error}")
    except KeyboardInterrupt:
        sys.exit(130)
