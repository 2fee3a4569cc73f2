"""Features of built-in robots with a user's own robot: a spec with a model, on `sim:` and on `rtl:`.

The tests of the bridges to ROS (test_ros1.py, test_ros2.py) and of the page in a browser cover this too.
"""

from __future__ import annotations

import csv
import json
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from support.bridge_programs import PATIENCE, PROGRAM
from support.live_page import TOKEN, hear, live, looking, take, write
from support.own_robots import EXAMPLES, OWN
from unity_link.virtual.build import Wanted, build_bare

if TYPE_CHECKING:
    from support.own_robots import Own

own = pytest.mark.parametrize("own", [OWN["sim"], pytest.param(OWN["rtl"], marks=pytest.mark.rtl)], ids=OWN)


@pytest.fixture(autouse=True)
def built(request: pytest.FixtureRequest) -> None:
    """Build the gateware of a robot before the test's time limit begins, unless it was built before."""
    if "own" in request.fixturenames:
        robot = request.getfixturevalue("own")
        if robot.url.startswith("rtl:"):
            build_bare(Wanted(robot=robot.spec, rtl=True))


def run(*arguments: str, folder: Path) -> str:
    done = subprocess.run([PROGRAM, *arguments], cwd=folder, capture_output=True, text=True, timeout=90, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.slow
def test_demo_moves_a_users_scara(tmp_path: Path) -> None:
    summary = json.loads(run("demo", OWN["sim"].url, "--duration", "1", "--json", folder=tmp_path))
    assert summary["samples"] > 50
    assert summary["samples_lost"] == 0


@pytest.mark.campaign
def test_demo_moves_a_users_scara_behind_gateware_built_for_it(tmp_path: Path) -> None:
    url = OWN["sim"].url.replace("sim:", "rtl:")
    command = [PROGRAM, "demo", url, "--duration", "3", "--json"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=600, check=True)
    assert json.loads(done.stdout)["samples_lost"] == 0


@pytest.mark.slow
@own
def test_the_page_shows_and_moves_it(own: Own, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UNITY_LINK_TOKEN", TOKEN)
    # The test is about the page: ignore reports that the robot is slower than real time.
    with live(own.url, own.spec, "--allow-writes", begins="<") as running, looking(running, token=TOKEN) as connection:
        about = hear(connection, "about")
        place = next(known for known in about["signals"] if known["path"] == own.position)
        assert write(connection, own.set_point, 0.5)["type"] == "written"
        while True:
            table = take(connection, about).tables[place["stream"]]
            if table and table[-1][2 + place["column"]][-1] == pytest.approx(0.5, abs=0.001):
                break


@pytest.mark.slow
@own
def test_it_is_recorded_exported_and_replayed(own: Own, tmp_path: Path) -> None:
    run("record", own.url, own.spec, "-o", "run.mcap", "--duration", "1.5", folder=tmp_path)
    run("export", "run.mcap", "--csv", folder=tmp_path)
    with (tmp_path / "run.state.csv").open() as file:
        rows = list(csv.DictReader(file))
    positions = [float(row[own.position]) for row in rows]
    assert positions[0] < positions[-1] == pytest.approx(1, abs=0.001)
    assert {row["lost"] for row in rows} == {"0"}
    with subprocess.Popen(
        [PROGRAM, "replay", "run.mcap", "--unix", "robot", "--speed", "100"],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        text=True,
    ) as player:
        try:
            assert player.stdout is not None
            player.stdout.readline()
            command = ["watch", "unix:robot", own.spec, own.position, "--rate", "20", "--count", "5"]
            assert float(run(*command, folder=tmp_path).split()[-1]) == pytest.approx(1, abs=0.001)
            player.send_signal(signal.SIGINT)
            assert player.wait(PATIENCE) == 130
        finally:
            player.kill()


@pytest.mark.campaign
def test_the_notebook_runs_on_it(tmp_path: Path) -> None:
    for file in (EXAMPLES / "scara.ul", Path(__file__).parents[1] / "support" / "own_robots.py"):
        shutil.copy(file, tmp_path)
    text = (EXAMPLES / "scara.ipynb").read_text(encoding="utf-8")
    assert '\\"sim:scara\\"' in text
    notebook = tmp_path / "own.ipynb"
    notebook.write_text(text.replace('\\"sim:scara\\"', '\\"sim:scara.ul?model=own_robots.py:Scara\\"'))
    execute = [str(Path(sys.executable).with_name("jupyter-execute")), "--inplace", "--timeout=120", str(notebook)]
    done = subprocess.run(execute, cwd=tmp_path, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    outputs = json.dumps([cell.get("outputs") for cell in json.loads(notebook.read_text())["cells"]])
    assert "0 lost" in outputs
    assert "image/png" in outputs
