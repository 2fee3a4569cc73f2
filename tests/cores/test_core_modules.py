"""The Python modules of cores: found beside their maps, not run by `check`, used by `load`, `generate` and `sim:`."""

from __future__ import annotations

import asyncio
import importlib.metadata
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.bridge_programs import PROGRAM
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError
from unity_link.spec import compile_file, compile_text
from unity_link.spec.cores import ENTRY_POINTS
from unity_link.virtual.build import simulate
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from pathlib import Path

MAP = """
BLINK(GROUP=none): @(BASE) {
  ENTITY("blink");
  @period = BASE: READWRITE(RESET=3);
  @fast = BASE + 1: READ();
  @count = BASE + 2: READ();
  @edge: TRIGGER(GROUP);
  @sense: PIN(IN);
  @led: PIN(OUT);
}
"""
PYTHON = """
from unity_link.cores import Model, RobotVerbs, Verbs


class BlinkVerbs(Verbs):
    async def fast(self) -> None:
        \"\"\"Blink as fast as can be.\"\"\"
        await self.period.set(1)


class BlinkingRobot(RobotVerbs):
    def blinkers(self) -> list[str]:
        return [component.path for component in self.interface.cores]


class BlinkModel(Model):
    def reset(self) -> None:
        self.part.count = 0

    def step(self, dt: float) -> None:
        self.part.fast = int(self.around.now)

    def written(self, name: str) -> None:
        self.part.count = self.part.count + (100 if name == "sense" else self.part.period)
        self.part.led = 1
        if name == "sense":
            self.around.trigger("edges")
"""
SPEC = """
group edges(TRIGGER);
public robot() {
  left: BLINK(GROUP=edges) @(0x10);
  right: BLINK() @(0x20);
  @position = 0x30: READ(PUBLISH(edges));
}
"""


def write(folder: Path, python: str = PYTHON) -> Path:
    """Write a spec with a core in the folder beside it; return the path of the spec."""
    core = folder / "cores" / "blink"
    core.mkdir(parents=True)
    (core / "blink.ul").write_text(MAP)
    (core / "blink.vhd").write_text("entity blink is end;")
    (core / "blink.py").write_text(python)
    spec = folder / "robot.ul"
    spec.write_text(SPEC)
    return spec


class Plant(SimulatedRobot):
    """Sets the input of the left core to 1 and leaves it there."""

    step_seconds = 0.01

    def step(self, dt: float) -> None:
        if not self.left.sense:
            self.left.sense = 1


@on_simulated_time
async def test_the_core_api_is_methods_and_signals_of_their_name_get_an_underscore(tmp_path: Path) -> None:
    spec = write(tmp_path)
    async with unity_link.connect(simulate(spec)) as link:
        robot = unity_link.load(spec)(link)
        assert await robot.left.period.get() == 3
        await robot.left.fast()
        assert await robot.left.period.get() == 1
        assert await robot.left.count.get() == 1
        assert robot.left.fast_.path == "left.fast"
        assert robot.blinkers() == ["left", "right"]
        assert await robot.right.count.get() == 0


@on_simulated_time
async def test_a_model_has_its_placement_clock_pins_and_triggers(tmp_path: Path) -> None:
    spec = write(tmp_path)
    gateway = simulate(spec, Plant)
    async with unity_link.connect(gateway) as link:
        robot = unity_link.load(spec)(link)
        async with robot.groups["edges"].subscribe() as samples:
            await asyncio.sleep(0.1)
            assert len(await samples.take()) == 1
        assert await robot.left.count.get() == 100
        assert (gateway.robot.left.led, gateway.robot.right.led, gateway.robot.left.sense) == (1, 0, 1)
        now = asyncio.get_running_loop().time()
        assert await robot["left.fast"].get() == gateway.ticks_at(now)  # type: ignore[attr-defined]
        with pytest.raises(ArgumentError, match=r"left\.sense is a pin, and 0 or 1, not 3"):
            gateway.robot.left.sense = 3
        gateway.reset()
        assert gateway.robot.left.count == 0


def test_check_and_show_do_not_run_the_python_of_a_core(tmp_path: Path) -> None:
    spec = write(tmp_path, "raise SystemExit('it ran')")
    for command in ("check", "show"):
        subprocess.run([PROGRAM, command, str(spec)], check=True, capture_output=True)
    compile_file(spec)
    with pytest.raises(SystemExit, match="it ran"):
        unity_link.load(spec)


@pytest.mark.parametrize(
    ("python", "says"),
    [
        ("1 / 0", r"blink\.py cannot be imported: ZeroDivisionError: division by zero"),
        ("import nowhere_at_all", r"blink\.py cannot be imported: ModuleNotFoundError"),
        (
            PYTHON + "\nclass Second(Verbs): ...\n",
            "has several subclasses of Verbs, BlinkVerbs and Second: one was expected",
        ),
    ],
)
def test_broken_python_of_a_core_is_reported_in_one_sentence(tmp_path: Path, python: str, says: str) -> None:
    spec = write(tmp_path, python)
    with pytest.raises(ArgumentError, match=says):
        unity_link.load(spec)


def test_a_generated_module_includes_the_python_of_a_core(tmp_path: Path) -> None:
    spec = write(tmp_path)
    subprocess.run([PROGRAM, "generate", "python", str(spec), "-o", str(tmp_path / "out")], check=True)
    text = (tmp_path / "out" / "robot.py").read_text()
    assert "class BLINK(BlinkVerbs, Component):" in text
    assert "class Robot_(BlinkingRobot, Robot):" in text
    assert "    fast_: Readable[int]\n" in text
    assert str(tmp_path) not in text
    program = """
import asyncio, unity_link
from robot import Robot_
async def main() -> None:
    async with unity_link.connect("sim:../robot.ul") as link:
        robot = Robot_(link)
        await robot.left.fast()
        print(await robot.left.period.get(), robot.blinkers())
asyncio.run(main())
"""
    (tmp_path / "out" / "main.py").write_text(program)
    done = subprocess.run([sys.executable, "main.py"], cwd=tmp_path / "out", capture_output=True, text=True, check=True)
    assert done.stdout == "1 ['left', 'right']\n"


def test_a_package_has_the_python_of_its_cores_imported_by_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    core = tmp_path / "shelf_of_cores" / "blink"
    core.mkdir(parents=True)
    (tmp_path / "shelf_of_cores" / "__init__.py").write_text("")
    (core / "blink.ul").write_text(MAP)
    (core / "blink.py").write_text(PYTHON)
    monkeypatch.syspath_prepend(tmp_path)
    point = importlib.metadata.EntryPoint("blink", "shelf_of_cores", ENTRY_POINTS)
    monkeypatch.setattr(importlib.metadata, "entry_points", lambda group: [point])
    compiled = compile_text(SPEC)
    assert "shelf_of_cores.blink.blink" not in sys.modules
    robot: Any = unity_link.load(compiled)
    assert robot.components["BLINK"].fast.__module__ == "shelf_of_cores.blink.blink"
