"""Balances the robot of `balancer.ul`. Ctrl-C, kill -9 and a pulled cable stop its motors.

python balance.py [URL], or sim: or rtl: alone for the simulated one
"""

from __future__ import annotations

import asyncio
import contextlib
import sys
from pathlib import Path

import unity_link

HERE = Path(__file__).parent
Robot = unity_link.load(HERE / "balancer.ul")
SIMULATED = f"{HERE}/balancer.ul?model={HERE}/plant.py:Balancer"
TILT, RATE, SPEED, WAY = 28.6, 2.9, 0.82, 0.99
"""Gains of the controller: volts for each rad and rad/s of the tilt, and each rad/s and rad of the wheels."""
MOST_TILT = 0.5


async def balance(url: str) -> None:
    """Keep the robot upright, in its place."""
    async with unity_link.connect(url) as link:
        robot = Robot(link)
        await robot.fallen.set(False)
        async with robot.drive.armed(timeout=0.15) as lease:
            async for sample in lease.each(robot.groups["state"]):
                tilt = sample[robot.tilt]
                if abs(tilt) > MOST_TILT:
                    await robot.fallen.set(True)
                    break
                volts = TILT * tilt + RATE * sample[robot.gyro[1]]
                volts += SPEED * sample[robot.wheel.velocity] + WAY * sample[robot.wheel.position]
                volts = min(max(volts, -12.0), 12.0)
                await robot.left.value.post(volts)
                await robot.right.value.post(volts)


if __name__ == "__main__":
    url = sys.argv[1] if len(sys.argv) > 1 else "sim:"
    with contextlib.suppress(KeyboardInterrupt):
        asyncio.run(balance(url + SIMULATED if url in {"sim:", "rtl:"} else url))
