"""A command that a signal ends at any instant leaves no process, no folder, no unfinished file and no lock."""

from __future__ import annotations

import math
import random
import signal
from pathlib import Path

import pytest

from support.bridge_programs import PROGRAM
from support.interrupted import Left, Place

EXAMPLES = Path(__file__).parents[1] / "examples"
SCARA, ROVER = str(EXAMPLES / "scara.ul"), str(EXAMPLES / "rover.ul")
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
TOOL_COMMANDS = {
    "build": ["build", "blinking.ul", "--board", "hx8k_breakout", "-o", "made"],
    "generate verilog": ["generate", "verilog", "blinking.ul", "-o", "made"],
    "rtl": ["get", "rtl:blinking.ul", "blinking.ul"],
}
"""Commands that run external tools for up to a minute."""
BLINKING = 'public blinking() { @lamp = 0x30[0]: bool READWRITE(PIN="led0"); }'
QUICK_COMMANDS = {
    "check": ["check", SCARA],
    "demo": ["demo"],
    "doctor": ["doctor", "sim:scara"],
    "find": ["find"],
    "fmt": ["fmt", "blinking.ul"],
    "gateware": ["gateware", "copy", "made"],
    "info": ["info", "sim:"],
    "live": ["live", "sim:scara", SCARA],
    "project": ["build", "blinking.ul", "--board", "arty_a7", "-o", "made"],
    "read": ["read", "sim:", "0"],
    "record": ["record", "sim:scara", SCARA, "-o", "made.mcap"],
    "ros2": ["ros2", SCARA, "--link", "sim:scara"],
    "serve": ["serve", "sim:scara", "--unix", "made.socket"],
    "show": ["show", SCARA],
    "simulate": ["simulate", "--unix", "made.socket"],
    "watch": ["watch", "sim:scara", SCARA],
    "write": ["write", "sim:", "0", "1"],
    "zenoh": ["zenoh", SCARA, "--link", "sim:scara", "--prefix", "robot"],
    **{f"generate {target}": ["generate", target, SCARA, "-o", "made"] for target in ("c", "docs", "matlab", "vhdl")},
}
COMMANDS = TOOL_COMMANDS | QUICK_COMMANDS
LONGEST = {"build": 90.0, "generate verilog": 60.0, "rtl": 60.0}
"""Seconds within which the campaign sends its signals; 3 for all other commands."""


def interrupted(folder: Path, name: str, draw: random.Random, longest: float) -> Left:
    """Send a signal to a command at a random instant, early instants more often, because more work begins then."""
    place = Place(folder)
    (place.work / "blinking.ul").write_text(BLINKING)
    after = math.exp(draw.uniform(math.log(0.2), math.log(longest)))
    return place.interrupt([PROGRAM, *COMMANDS[name]], after, draw.choice(SIGNALS), group=draw.random() < 0.5)


def left_nothing(left: Left) -> bool:
    return (left.processes, left.files) == ([], []) and "Traceback" not in left.said


@pytest.mark.slow
@pytest.mark.timeout(900)
@pytest.mark.parametrize("name", TOOL_COMMANDS)
def test_command_with_tools_leaves_nothing_at_a_signal(name: str, tmp_path: Path) -> None:
    draw = random.Random(name)
    for turn in range(20):
        left = interrupted(tmp_path / str(turn), name, draw, 5.0)
        assert left_nothing(left), (turn, left)


@pytest.mark.campaign
@pytest.mark.parametrize("seed", range(40))
def test_no_command_leaves_anything_at_a_signal(seed: int, tmp_path: Path) -> None:
    draw = random.Random(seed)
    for turn in range(25):
        name = draw.choice(list(COMMANDS))
        left = interrupted(tmp_path / str(turn), name, draw, LONGEST.get(name, 3.0))
        assert left_nothing(left), (turn, name, left)
