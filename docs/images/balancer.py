"""Draws `examples/balancer` as an animation: runs its program and its physics on modelled time."""

import asyncio
import contextlib
import math
import runpy
from pathlib import Path
from typing import Any, NamedTuple

from docs.images.moving import style
from unity_link.errors import UnityLinkError
from unity_link.virtual.build import simulate
from unity_link.virtual.modelled_time import ModelledTimeLoop
from unity_link.virtual.simulating import load_model

FOLDER = Path(__file__).parents[2] / "examples" / "balancer"
PUSHED, LET_GO, PULLED, SECONDS = 2.0, 2.1, 5.0, 7.0
"""Seconds at which a hand pushes and lets go, the cable is pulled, and the picture repeats."""
RATE = 25
"""Recorded states in a second."""
SCALE = 700
"""Units of the picture for a metre."""


class Look(NamedTuple):
    """State of the robot at an instant."""

    way: float
    """Metres."""
    lean: float
    """Radians from upright, clockwise."""
    turn: float
    """Radians of the wheels, clockwise."""
    is_armed: bool


def draw_balancer(picture: Path) -> None:
    """Draw the robot in balance, pushed, and after its cable is pulled."""
    with asyncio.Runner(loop_factory=ModelledTimeLoop) as runner:
        looks = runner.run(_watch())
    picture.write_text(_svg(looks))


async def _watch() -> list[Look]:
    model = load_model(f"{FOLDER}/plant.py:Balancer")
    gateway = simulate(FOLDER / "balancer.ul", model)
    robot: Any = gateway.robot
    radius = runpy.run_path(str(FOLDER / "plant.py"))["RADIUS"]
    program = asyncio.ensure_future(runpy.run_path(str(FOLDER / "balance.py"))["balance"](gateway))
    looks = []
    for number in range(round(SECONDS * RATE) + 1):
        time = number / RATE
        robot.pushed = PUSHED <= time < LET_GO
        if time >= PULLED:
            vars(gateway)["receive"] = lambda _data, _now: b""
        looks.append(Look(radius * robot.angle, robot.lean, robot.angle, bool(robot.drive.armed)))
        await asyncio.sleep(1 / RATE)
    program.cancel()
    # Of the cable, if it has seen it.
    with contextlib.suppress(asyncio.CancelledError, UnityLinkError):
        await program
    return looks


def _svg(looks: list[Look]) -> str:
    off = next(number for number, look in enumerate(looks) if number / RATE > 1 and not look.is_armed) / RATE
    moves = {
        "way": [f"transform:translateX({SCALE * look.way:.1f}px)" for look in looks],
        "lean": [f"transform:rotate({math.degrees(look.lean):.1f}deg)" for look in looks],
        "turn": [f"transform:rotate({math.degrees(look.turn):.0f}deg)" for look in looks],
    }
    shown = {
        "runs": (0.0, PUSHED),
        "push": (PUSHED, PUSHED + 0.5),
        "back": (PUSHED + 0.5, PULLED),
        "pulled": (PULLED, off),
        "off": (off, SECONDS),
        "enabled": (0.0, off),
    }
    captions = {
        "runs": "its program keeps it upright",
        "push": "a hand pushes it",
        "back": "it goes back to where it was",
        "pulled": "the cable is pulled",
        "off": "0.15 s later its motors are off",
    }
    texts = "".join(f'<text class="{name}" x="250" y="28">{text}</text>\n' for name, text in captions.items())
    return f"""<svg viewBox="0 0 500 240" xmlns="http://www.w3.org/2000/svg">
<title>A robot on two wheels, simulated: it stands, is pushed, and falls when its cable is pulled</title>
<style>
{style(SECONDS, moves, shown, ".push,.back,.pulled,.off")}
</style>
<rect width="500" height="240" rx="8" fill="#f6f8fa"/>
{texts}<path d="M20 206H480" stroke="#8c959f" stroke-width="2"/>
<g transform="translate(220 178)"><g class="way">
<g class="push"><path d="M-78 -82h34m-9 -7l9 7l-9 7" stroke="#bf3989" stroke-width="4" fill="none"/></g>
<g class="lean"><rect x="-16" y="-118" width="32" height="112" rx="6" fill="#0969da"/>
<circle cx="0" cy="-102" r="6" fill="#cf222e"/><circle class="enabled" cx="0" cy="-102" r="6" fill="#4ac26b"/></g>
<g class="turn"><circle r="28" fill="#24292f"/><circle r="20" fill="#8c959f"/>
<path d="M-20 0H20M0 -20V20" stroke="#24292f" stroke-width="4"/></g>
</g></g>
</svg>
"""
