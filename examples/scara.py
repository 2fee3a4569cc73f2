"""The SCARA of the Unity-Link paper moves through a few poses, and prints its position.

python examples/scara.py              # the virtual robot: no hardware
python examples/scara.py "serial:/dev/ttyUSB0?baud=3000000"
"""

from __future__ import annotations

import asyncio
import sys
from pathlib import Path

import unity_link
from unity_link.data import Group

Scara = unity_link.load(Path(__file__).with_name("scara.ul"))

POSES = ((40, 60, 0, 0), (40, 60, 120, 90), (-40, 30, 20, -90), (0, 0, 0, 0))
"""Shoulder, elbow and wrist in degrees, height in mm: shoulder, elbow, height, wrist."""
CLOSE = 0.01
PATIENCE = 10_000
"""Number of samples after which a pose counts as not reached."""


async def main(url: str) -> None:
    """Move through the poses.

    Raises:
        UnityLinkError: the gateway is not that of a SCARA, or is lost.
    """
    async with unity_link.connect(url) as link:
        robot = Scara(link)
        joints = (robot.j1, robot.j2, robot.j3, robot.j4)
        targets = Group(*(joint.pos_sp for joint in joints))
        await Group(*(joint.spd_sp for joint in joints)).set([150, 200, 250, 450])

        print("time / s   shoulder / deg   elbow / deg   z / mm   wrist / deg")
        for pose in POSES:
            await targets.set(pose)
            async with robot.groups["state"].subscribe() as samples:
                async for sample in samples:
                    positions = [sample.values[joint.cpos] for joint in joints]
                    there = all(abs(at - to) < CLOSE for at, to in zip(positions, pose, strict=True))
                    if there or sample.sequence % 100 == 0:
                        first, *others = positions
                        print(f"{sample.time:8.3f} {first:16.2f}", *(f"{other:11.2f}" for other in others))
                    if there:
                        break
                    if samples.received > PATIENCE:
                        raise unity_link.UnityLinkError(f"{url}: the pose {pose} is not reached: is it a SCARA?")


if __name__ == "__main__":
    try:
        asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else "sim:scara"))
    except unity_link.UnityLinkError as error:
        sys.exit(f"error: {error}")
    except KeyboardInterrupt:
        sys.exit(130)
