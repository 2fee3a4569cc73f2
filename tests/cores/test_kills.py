"""Programs that end in every way while they move an output: all outputs become safe after the time-out, and stay so.

The programs, the server between them and the gateway, and the signals that end them are real; a second client observes.
"""

from __future__ import annotations

import asyncio
import contextlib
import signal
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from generate.programs import STRICT
from support.bridge_programs import PROGRAM, line_of, wait_until
from unity_link import blocking
from unity_link.data.blocking import put

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

SPEC = """
group state(RATE=200, TIMESTAMPS);
public rover() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=20) @(0xE0);
  @speed = 0x10: signed READWRITE(SAFE(0, drive));
  @position = 0x20: READ(PUBLISH(state));
}
"""
HEAD = """
import sys
import unity_link

Rover = unity_link.load(sys.argv[2])
"""
LOOP = """
{run}def main() -> None:
    {run}with {connect}(sys.argv[1]) as link:
        robot = {put}
        {run}with robot.armed(timeout=float(sys.argv[3])) as lease:
            {run}for sample in lease.each(robot.groups["state"]):
                {wait}robot.speed.set(1 + sample.sequence)
                if sample.sequence == 20:
                    print("moving", flush=True)
"""
ASYNC = HEAD + LOOP.format(run="async ", connect="unity_link.connect", put="Rover(link)", wait="await ")
FACES = {
    "asyncio": ASYNC + "\nimport asyncio\nasyncio.run(main())\n",
    "trio": ASYNC + "\nimport trio\ntrio.run(main)\n",
    "blocking": HEAD
    + "from unity_link import blocking\nfrom unity_link.data.blocking import put\n"
    + LOOP.format(run="", connect="blocking.connect", put="put(Rover, link)", wait="")
    + "\nmain()\n",
}
FLOOD = (
    HEAD
    + """
import asyncio

async def main() -> None:
    async with unity_link.connect(sys.argv[1]) as link:
        robot = Rover(link)
        async with robot.armed(timeout=float(sys.argv[3])) as lease:
            for number in range(1_000_000):
                await robot.speed.post(1 + number)
                if number % 50 == 0:
                    await lease.kick()
                if number == 1000:
                    print("moving", flush=True)

asyncio.run(main())
"""
)


C_PROGRAM = """
#include <stdio.h>
#include <stdlib.h>
#include "rover.h"

static ul_link link;

int main(int count, char **arguments)
{
    ul_lease drive = UL_LEASE(rover.drive);
    if (count != 3 || ul_connect(&link, arguments[1], 5.0)) return 2;
    ul_status status = ul_lease_arm(&link, &drive, atof(arguments[2]));
    for (int64_t turn = 1; status == UL_OK; turn++) {
        status = ul_lease_kick(&link, &drive);
        if (status == UL_OK) status = ul_set_signed(&link, &rover.speed, turn);
        if (turn == 20) { puts("moving"); fflush(stdout); }
    }
    fprintf(stderr, "%s", ul_error(&link));
    return 1;
}
"""


@pytest.fixture(scope="module")
def program_in_c(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("c")
    (folder / "rover.ul").write_text(SPEC)
    (folder / "move.c").write_text(C_PROGRAM)
    subprocess.run([PROGRAM, "generate", "c", "rover.ul"], cwd=folder, check=True, capture_output=True)
    sources = ["move.c", "rover.c", "unity_link.c", "unity_link_posix.c"]
    subprocess.run(["cc", "-std=c99", *STRICT, *sources, "-o", "move"], cwd=folder, check=True)
    return folder / "move"


@contextlib.contextmanager
def served(folder: Path, options: str = "") -> Iterator[tuple[str, str, Any]]:
    """Serve a rover; yield its URL, the path of its spec, and a rover of the observing client."""
    spec = folder / "rover.ul"
    spec.write_text(SPEC)
    command = [PROGRAM, "serve", f"sim:{spec}{options}", "--unix", str(folder / "gateway")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server:
        try:
            url = line_of(server)
            with blocking.connect(url) as link:
                yield url, str(spec), put(unity_link.load(spec), link)
        finally:
            server.kill()


@contextlib.contextmanager
def moving(program: str, url: str, spec: str, seconds: float = 3) -> Iterator[subprocess.Popen[str]]:
    """Run a program until it moves its output, under a lease of some seconds; end the program with the block."""
    command = [sys.executable, "-c", program, url, spec, str(seconds)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            assert line_of(process) == "moving"
            yield process
        finally:
            process.kill()


def reason(robot: Any) -> str:
    name: str = robot.drive.reason.get().name
    return name


@pytest.mark.slow
@pytest.mark.parametrize("face", FACES)
@pytest.mark.parametrize("way", ["SIGKILL", "SIGSTOP", "SIGINT"])
def test_a_program_that_is_terminated_leaves_its_output_safe(face: str, way: str, tmp_path: Path) -> None:
    with served(tmp_path) as (url, spec, robot), moving(FACES[face], url, spec) as program:
        assert robot.drive.armed_.get()
        assert robot.speed.get() > 0
        program.send_signal(signal.Signals[way])
        wait_until(lambda: not robot.drive.armed_.get())
        assert robot.speed.get() == 0
        # The server disarms for a client that has disconnected; a stopped client is only silent.
        assert reason(robot) == ("silence" if way == "SIGSTOP" else "disarmed")
        if way == "SIGSTOP":
            program.send_signal(signal.SIGCONT)
            _, told = program.communicate()
            assert "NotArmedError: " in told
            assert "drive is not armed: no kick came before its end" in told
        assert program.wait() != 0
        assert robot.speed.get() == 0
        with robot.armed(timeout=1):
            assert robot.speed.get() == 0


@pytest.mark.slow
@pytest.mark.parametrize("way", ["SIGKILL", "SIGSTOP", "stopped"])
def test_a_program_in_c_that_is_terminated_leaves_its_output_safe(way: str, program_in_c: Path, tmp_path: Path) -> None:
    with (
        served(tmp_path) as (url, _, robot),
        subprocess.Popen(
            [program_in_c, url, "3"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        ) as program,
    ):
        try:
            assert line_of(program) == "moving"
            assert robot.speed.get() > 0
            second = subprocess.run([program_in_c, url, "3"], capture_output=True, text=True, check=False, timeout=60)
            assert (second.returncode, second.stdout) == (1, "")
            assert "it cannot be armed: another program has armed it" in second.stderr
            if way == "stopped":
                assert robot.drive.stop()
            else:
                program.send_signal(signal.Signals[way])
            wait_until(lambda: not robot.drive.armed_.get())
            assert robot.speed.get() == 0
            if way == "stopped":
                # The next kick or write of the program raises the error.
                _, told = program.communicate(timeout=60)
                assert "drive is not armed: it was disarmed" in told
        finally:
            program.kill()


@pytest.mark.slow
@pytest.mark.parametrize("way", ["SIGKILL", "SIGSTOP"])
def test_writes_of_a_killed_program_that_wait_in_the_server_do_not_act(way: str, tmp_path: Path) -> None:
    with served(tmp_path, "?bytes_per_second=20000") as (url, spec, robot), moving(FLOOD, url, spec, 5) as program:
        program.send_signal(signal.Signals[way])
        wait_until(lambda: not robot.drive.armed_.get())
        for _ in range(100):
            assert robot.speed.get() == 0
        assert reason(robot) == ("silence" if way == "SIGSTOP" else "disarmed")


@pytest.mark.slow
def test_a_server_with_the_spec_disarms_for_a_killed_program(tmp_path: Path) -> None:
    spec = tmp_path / "rover.ul"
    spec.write_text(SPEC)
    board = [PROGRAM, "simulate", str(spec), "--unix", str(tmp_path / "board")]
    shared = [PROGRAM, "serve", f"unix:{tmp_path / 'board'}", "--spec", str(spec), "--unix", str(tmp_path / "gateway")]
    with contextlib.ExitStack() as stack:
        url = ""
        for command in (board, shared):
            process = stack.enter_context(subprocess.Popen(command, stdout=subprocess.PIPE, text=True))
            stack.callback(process.kill)
            url = line_of(process)
        robot = put(unity_link.load(spec), stack.enter_context(blocking.connect(url)))
        with moving(FACES["blocking"], url, str(spec), 20) as program:
            with pytest.raises(unity_link.BusError, match="another program has armed drive"):
                robot.speed.set(5)
            program.kill()
            wait_until(lambda: not robot.drive.armed_.get())
            assert reason(robot) == "disarmed"


def test_a_server_refuses_a_gateway_of_another_spec_than_its_option(tmp_path: Path) -> None:
    spec, other = tmp_path / "rover.ul", tmp_path / "other.ul"
    spec.write_text(SPEC)
    other.write_text(SPEC.replace("0x10", "0x12"))
    command = [PROGRAM, "serve", f"sim:{spec}", "--spec", str(other), "--unix", str(tmp_path / "gateway")]
    refused = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert refused.returncode == 1
    assert "the gateway was built for the map" in refused.stderr
    assert "Traceback" not in refused.stderr


@pytest.mark.slow
def test_another_program_can_stop_the_output_at_once(tmp_path: Path) -> None:
    with served(tmp_path) as (url, spec, robot), moving(FACES["asyncio"], url, spec, 20) as program:
        stopped = subprocess.run([PROGRAM, "stop", url, spec], capture_output=True, text=True, check=False)
        assert (stopped.returncode, stopped.stdout, stopped.stderr) == (0, "drive: disarmed\n", "")
        assert not robot.drive.armed_.get()
        assert robot.speed.get() == 0
        _, told = program.communicate()
        assert "NotArmedError: " in told
        assert "drive is not armed: it was disarmed" in told
        again = subprocess.run([PROGRAM, "stop", spec, url], capture_output=True, text=True, check=False)
        assert (again.returncode, again.stdout, again.stderr) == (0, "drive: was not armed\n", "")


def test_the_error_after_the_end_of_the_server_says_when_the_lease_ends(tmp_path: Path) -> None:
    spec = tmp_path / "rover.ul"
    spec.write_text(SPEC)

    async def lose() -> None:
        async with unity_link.connect(f"unix:{tmp_path / 'gateway'}") as link:
            robot = unity_link.load(spec)(link)
            async with robot.armed(timeout=20) as lease:
                server.kill()
                while True:
                    await lease.kick()
                    await asyncio.sleep(0.01)

    command = [PROGRAM, "serve", f"sim:{spec}", "--unix", str(tmp_path / "gateway")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server:
        line_of(server)
        with pytest.raises(unity_link.LinkLostError) as lost:
            asyncio.run(lose())
    # 98 % of TIMEOUT is the longest time-out that a lease uses.
    assert "it runs out by itself, 19.6 s after the last kick" in lost.value.__notes__[0]
