"""Draws flowers with the gantry of `gantry.ul`: python gantry.py [URL], or sim: or rtl: alone for the simulated one."""

import asyncio
import sys
from pathlib import Path
from typing import Any

import numpy as np

import unity_link

HERE = Path(__file__).parent
Gantry = unity_link.load(HERE / "gantry.ul")
SIMULATED = f"{HERE}/gantry.ul?model={HERE}/plant.py:Gantry&fault=visitor"
DT = 0.002  # seconds from one point to the next


def flower() -> Any:
    """Return the path of x, y and z in mm from the switches: to the flower, around it and back; shape (3, rows)."""
    slow, fast, turn = (3 * s**2 - 2 * s**3 for s in (np.linspace(0, 1, rows) for rows in (300, 100, 1000)))
    angle, radius = 2 * np.pi * turn, 8 - 3 * np.cos(10 * np.pi * turn)
    drawing = np.array([16 + radius * np.cos(angle), 13 + radius * np.sin(angle), np.full(len(turn), 4)])
    above = drawing[:, :1] * [[1], [1], [0]]
    there, down = above * slow, above + (drawing[:, :1] - above) * fast
    return np.hstack([there, down, drawing, down[:, ::-1], there[:, ::-1]])


async def draw(url: str) -> None:
    """Go to the switches, then draw flowers, each point of them in its clock cycle."""
    async with unity_link.connect(url) as link:
        robot, path, zeros, values = Gantry(link), flower(), dict[Any, float](), dict[Any, Any]()
        homes: dict[Any, Any] = {robot.x: robot.x_home, robot.y: robot.y_home, robot.z: robot.z_home}
        async with robot.drive.armed(timeout=0.8) as lease:
            for axis in homes:
                await axis.velocity_cmd.post(-10)
                await axis.mode.post("velocity")
            async for sample in lease.each(robot.groups["state"]):
                for axis in [axis for axis in homes if axis not in zeros and sample[homes[axis].level]]:
                    zeros[axis] = sample[axis.position]
                    await axis.position_cmd.post(zeros[axis])
                    await axis.mode.post("position")
                if len(zeros) == len(homes):
                    break
            for axis, places in zip(homes, path, strict=True):
                speeds = np.maximum(np.abs(np.diff(places, prepend=places[:1])) / DT, 1)
                values |= {axis.position_cmd: zeros[axis] + places, axis.maxvel: speeds}
                await axis.maxaccel.set(0)  # the path sets the pace; the spec's limit returns with the lease's end
            while True:
                rows = await robot.plan.play(DT * np.arange(path.shape[1]), values, lead=0.2, lease=lease)
                print("a flower of", rows, "places, each in its clock cycle")


if __name__ == "__main__":
    url = sys.argv[1] if len(sys.argv) > 1 else "sim:"
    try:
        asyncio.run(draw(url + SIMULATED if url in {"sim:", "rtl:"} else url))
    except unity_link.UnityLinkError as error:
        sys.exit(f"error: {error}")
    except KeyboardInterrupt:
        sys.exit(130)
