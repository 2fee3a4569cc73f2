"""`unity-link set --arm`: outputs move while the command runs, and are safe after every end of it.

The commands, the server and the signals are real; a second client reads the outputs.
"""

from __future__ import annotations

import contextlib
import signal
import subprocess
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.bridge_programs import PROGRAM, line_of, wait_for, wait_until
from unity_link import blocking
from unity_link.data.blocking import put

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

TIMEOUT = 2
SPEC = f"""
public rover() {{
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT={TIMEOUT}) @(0xE0);
  arm: LEASE(TIMEOUT={TIMEOUT}) @(0xF8);
  @speed = 0x10: signed READWRITE(SAFE(0, drive));
  @lift = 0x11: signed READWRITE(SAFE(0, arm));
  @fastest = 0x12: signed READ();
}}
"""
MODEL = """
from unity_link.virtual.simulated import SimulatedRobot


class Rover(SimulatedRobot):
    def written(self, path, value):
        if path == "speed":
            self.fastest = max(self.fastest, value)
"""
RUNS = 20


@contextlib.contextmanager
def served(folder: Path, timeout: int = TIMEOUT) -> Iterator[tuple[subprocess.Popen[str], list[str], Any]]:
    """Serve a rover with two leases; give the server, the command that moves it, and the rover for a second client."""
    spec, model, place = folder / "rover.ul", folder / "rover.py", folder / "gateway"
    spec.write_text(SPEC.replace(f"TIMEOUT={TIMEOUT}", f"TIMEOUT={timeout}"))
    model.write_text(MODEL)
    command = [PROGRAM, "serve", f"sim:{spec}?model={model}:Rover", "--unix", str(place)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server:
        try:
            url = line_of(server)
            with blocking.connect(url) as link:
                yield server, [PROGRAM, "set", url, str(spec)], put(unity_link.load(spec), link)
        finally:
            server.kill()


@contextlib.contextmanager
def moving(command: list[str]) -> Iterator[subprocess.Popen[str]]:
    """Start a command that holds `speed` and `lift` for a minute; it does not outlive the block."""
    arguments = [*command, "speed=3", "lift=4", "--arm", "60"]
    with subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            yield process
        finally:
            process.kill()


def state(robot: Any) -> tuple[int, int, bool, bool]:
    """Return `speed`, `lift`, and whether each lease is armed."""
    return robot.speed.get(), robot.lift.get(), robot.drive.armed_.get(), robot.arm.armed_.get()


SAFE = (0, 0, False, False)


def reasons(robot: Any) -> set[str]:
    return {lease.reason.get().name for lease in (robot.drive, robot.arm)}


def test_set_with_arm_moves_for_its_time_and_disarms(tmp_path: Path) -> None:
    with served(tmp_path, timeout=20) as (_, command, robot):
        done = subprocess.run([*command, "speed=3", "--arm", "0.1"], capture_output=True, text=True, check=False)
        assert (done.returncode, done.stdout, done.stderr) == (0, "speed  3\n", "")
        assert robot.fastest.get() == 3
        assert state(robot) == SAFE
        # Only the lease of `speed` was armed.
        assert (robot.drive.arms.get(), robot.arm.arms.get()) == (1, 0)
        assert robot.drive.reason.get().name == "disarmed"


def test_set_with_arm_reports_a_lease_that_another_program_holds(tmp_path: Path) -> None:
    # No kick is needed while the command starts, on a busy machine too.
    with served(tmp_path, timeout=20) as (_, command, robot):
        with robot.arm.armed():
            arguments = [*command, "speed=3", "lift=4", "--arm", "9"]
            done = subprocess.run(arguments, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stdout) == (1, "")
        assert done.stderr == "error: arm cannot be armed: another program has armed it\n"
        # The lease that was armed first is disarmed again, and no signal was written.
        assert (robot.drive.arms.get(), robot.fastest.get(), state(robot)) == (1, 0, SAFE)


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=lambda number: number.name)
def test_a_signal_disarms_set_before_the_command_ends(number: signal.Signals, tmp_path: Path) -> None:
    with served(tmp_path, timeout=20) as (_, command, robot):
        for count in range(RUNS):
            with moving(command) as process:
                if count % 2:
                    assert [line_of(process), line_of(process)] == ["speed  3", "lift   4"]
                    assert state(robot) == (3, 4, True, True)
                else:
                    wait_until(robot.drive.armed_.get)
                process.send_signal(number)
                _, printed = process.communicate()
                assert (process.returncode, printed) == (128 + number, "")
            assert state(robot) == SAFE
            assert robot.drive.reason.get().name == "disarmed"


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGSTOP], ids=lambda number: number.name)
def test_set_that_cannot_disarm_leaves_outputs_safe_within_the_timeout(number: signal.Signals, tmp_path: Path) -> None:
    with served(tmp_path) as (_, command, robot):
        hertz = robot.link.gateway.clock_hz
        for _ in range(RUNS):
            with moving(command) as process:
                assert [line_of(process), line_of(process)] == ["speed  3", "lift   4"]
                assert state(robot) == (3, 4, True, True)
                process.send_signal(number)
                sent = robot.drive.clock.get()
                wait_until(lambda: not (robot.drive.armed_.get() or robot.arm.armed_.get()))
                assert state(robot) == SAFE
                if number == signal.SIGKILL:
                    # The server disarms for a client that has gone.
                    assert reasons(robot) == {"disarmed"}
                    continue
                assert reasons(robot) == {"silence"}
                assert all(lease.fault_time.get() <= sent + TIMEOUT * hertz for lease in (robot.drive, robot.arm))
                process.send_signal(signal.SIGCONT)
                _, printed = process.communicate()
                assert process.returncode == 1
                assert printed.startswith("error: drive is not armed: no kick came before its end")
            assert state(robot) == SAFE


@pytest.mark.slow
def test_ctrl_c_while_the_gateway_is_silent_says_which_lease_runs_out(tmp_path: Path) -> None:
    with served(tmp_path) as (server, command, _), moving(command) as process:
        assert [line_of(process), line_of(process)] == ["speed  3", "lift   4"]
        server.send_signal(signal.SIGSTOP)
        process.send_signal(signal.SIGINT)
        assert "it runs out by itself, 1.96 s after the last kick" in wait_for(
            process, "arm may not have been disarmed"
        )
        assert process.wait() == 130
        server.send_signal(signal.SIGCONT)


@pytest.mark.slow
def test_set_with_arm_reports_a_stop_by_another_program(tmp_path: Path) -> None:
    with served(tmp_path, timeout=20) as (_, command, robot), moving(command) as process:
        assert [line_of(process), line_of(process)] == ["speed  3", "lift   4"]
        assert robot.arm.stop()
        _, printed = process.communicate()
        assert (process.returncode, printed) == (1, "error: arm is not armed: it was disarmed\n")
        assert state(robot) == SAFE
