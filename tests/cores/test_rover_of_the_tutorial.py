"""The tutorial's rover stops however its program ends; the test uses the files of the page."""

from __future__ import annotations

import signal
import subprocess
import sys
from pathlib import Path

import pytest

import unity_link
from docs.walkthrough import files_of
from support.bridge_programs import PROGRAM, line_of, wait_until
from unity_link import blocking
from unity_link.data.blocking import put

PAGE = Path(__file__).parents[2] / "docs" / "tutorials" / "rover.md"


@pytest.mark.parametrize("way", ["SIGINT", "SIGTERM", "SIGKILL", "SIGSTOP"])
def test_the_wheels_have_no_duty_after_the_program_has_ended(way: str, tmp_path: Path) -> None:
    for name, text in files_of(PAGE).items():
        (tmp_path / name).write_text(text)
    # Let the program run for longer than the test.
    program = (tmp_path / "drive.py").read_text()
    assert "drive(rover, 1)" in program
    (tmp_path / "drive.py").write_text(program.replace("drive(rover, 1)", "drive(rover, 1000)"))
    subprocess.run([PROGRAM, "generate", "python", "rover.ul"], cwd=tmp_path, check=True, capture_output=True)
    command = [PROGRAM, "serve", "sim:rover.ul?model=model.py:Rover", "--unix", "rover.sock"]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, text=True) as server:
        try:
            with (
                blocking.connect(line_of(server)) as link,
                subprocess.Popen([sys.executable, "drive.py"], cwd=tmp_path, stderr=subprocess.DEVNULL) as driving,
            ):
                rover = put(unity_link.load(tmp_path / "rover.ul"), link)
                try:
                    wait_until(lambda: rover.left.speed.get() > 0.9)
                    driving.send_signal(signal.Signals[way])
                    wait_until(lambda: not rover.drive.armed_.get())
                    assert (rover.left.duty.get(), rover.right.duty.get()) == (0, 0)
                    wait_until(lambda: rover.left.speed.get() < 0.01)
                finally:
                    driving.kill()
        finally:
            server.kill()
