"""Draws `examples/gantry` as an animation: runs its program and its physics on modelled time."""

import asyncio
import contextlib
import io
import math
import runpy
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

from docs.images.moving import style
from unity_link.errors import NotArmedError
from unity_link.virtual.build import simulate
from unity_link.virtual.modelled_time import ModelledTimeLoop
from unity_link.virtual.simulating import load_model

FOLDER = Path(__file__).parents[2] / "examples" / "gantry"
AFTER = 2.0
"""Seconds from the e-stop to the end of the picture."""
RATE = 200
"""Recorded states in a second."""
FRAME = 8
"""Recorded states from one frame of the picture to the next; motion between frames is even."""
SCALE = 9.0
"""Units of the picture for a millimetre."""


class Look(NamedTuple):
    """State of the gantry at an instant; positions in mm."""

    x: float
    y: float
    z: float
    flowers: int
    is_armed: bool


def draw_gantry(picture: Path) -> None:
    """Draw the gantry on the way to its switches, drawing, and stopped by its e-stop."""
    with asyncio.Runner(loop_factory=ModelledTimeLoop) as runner:
        looks = runner.run(_watch())
    picture.write_text(_svg(looks))


async def _watch() -> list[Look]:
    gateway = simulate(FOLDER / "gantry.ul", load_model(f"{FOLDER}/plant.py:Gantry"))
    robot: Any = gateway.robot
    robot.visitor = True
    program = asyncio.ensure_future(runpy.run_path(str(FOLDER / "gantry.py"))["draw"](gateway))
    looks: list[Look] = []
    left = round(AFTER * RATE)
    with contextlib.redirect_stdout(io.StringIO()), contextlib.suppress(NotArmedError):
        while left:
            await asyncio.sleep(1 / RATE)
            left -= robot.pressed
            flowers = robot.flowers if robot.drawn else 0
            x, y, z = (motor.place for motor in robot.motors)
            looks.append(Look(x, y, z, flowers, bool(robot.drive.armed)))
        await program
    return looks


def _drawing(looks: list[Look], number: int) -> tuple[str, list[str]]:
    """Return the path of a flower, and its drawn length at each frame."""
    points, lengths = [], [0.0]
    for before, look in pairwise(looks):
        is_drawn = look.flowers == before.flowers == number
        lengths.append(lengths[-1] + is_drawn * math.dist(before[:2], look[:2]))
        if is_drawn and lengths[-1] > lengths[-2]:
            points.append(f"{SCALE * look.x:.1f} {SCALE * look.y:.1f}")
    offsets = [f"stroke-dashoffset:{1 - length / lengths[-1]:.4f}" for length in lengths[::FRAME]]
    return "M" + "L".join(points), offsets


def _svg(looks: list[Look]) -> str:
    frames = looks[::FRAME]
    seconds = (len(frames) - 1) * FRAME / RATE
    first = next(index for index, look in enumerate(looks) if look.flowers) / RATE
    off = len([look for look in looks if look.is_armed]) / RATE
    path, offsets = _drawing(looks, 1)
    again, offsets_again = _drawing(looks, 2)
    moves = {
        "bridge": [f"transform:translateX({SCALE * look.x:.1f}px)" for look in frames],
        "head": [f"transform:translateY({SCALE * look.y:.1f}px)" for look in frames],
        "pen": [f"transform:scale({1.6 - 0.15 * look.z:.2f})" for look in frames],
        "one": offsets,
        "two": offsets_again,
    }
    shown = {"homing": (0.0, first), "draws": (first, off), "pressed": (off, seconds), "enabled": (0.0, off)}
    captions = {
        "homing": "it finds its switches",
        "draws": "a place every 2 ms, each in its clock cycle",
        "pressed": "e-stop: no current within two cycles, and its program ends",
    }
    texts = "".join(f'<text class="{name}" x="250" y="28">{text}</text>\n' for name, text in captions.items())
    return f"""<svg viewBox="0 0 500 340" xmlns="http://www.w3.org/2000/svg">
<title>A gantry, simulated: it goes to its switches, draws a flower, and stands when its e-stop is pressed</title>
<style>
{style(seconds, moves, shown, ".homing,.pressed")}
</style>
<rect width="500" height="340" rx="8" fill="#f6f8fa"/>
{texts}<rect x="96" y="52" width="308" height="268" fill="#fff" stroke="#d0d7de"/>
<path d="M70 48H430M70 324H430" stroke="#8c959f" stroke-width="6"/>
<g transform="translate(112 66)" fill="none">
<path class="one" pathLength="1" stroke-dasharray="1" stroke="#0969da" stroke-width="2" d="{path}"/>
<path class="two" pathLength="1" stroke-dasharray="1" stroke="#bf3989" stroke-width="2" d="{again}"/>
<g class="bridge"><path d="M0 -24V264" stroke="#24292f" stroke-width="10" opacity="0.75"/>
<g class="head"><rect x="-16" y="-14" width="32" height="28" rx="5" fill="#24292f"/>
<circle class="pen" r="5" fill="#ffd33d"/></g></g>
</g>
<circle cx="462" cy="186" r="14" fill="#cf222e"/><circle class="enabled" cx="462" cy="186" r="14" fill="#4ac26b"/>
</svg>
"""
