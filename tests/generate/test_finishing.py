"""Leases of programs in C and Octave that let the schedule run to its end when the program is silent."""

from __future__ import annotations

import subprocess
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from generate.programs import STRICT, C, generated
from support.bridge_programs import PROGRAM, line_of, seen_until_disarmed
from unity_link import blocking
from unity_link.data.blocking import put
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from generate.octave import Octave

    Begin = Callable[[Path, str, bool], subprocess.Popen[str]]

SPEC = """\
public robot() {
  drive: LEASE(TIMEOUT=5, FINISH=20) @(0x80);
  plan: SCHEDULE(DEPTH=512) @(0xA0);
  @duty = 0x10: signed 16 READWRITE(SAFE(-1, drive), TIMED(plan));
}
"""
IN_C = """
#include <stdio.h>
#include "robot.h"

static ul_link link;

int main(int count, char **arguments)
{
    ul_lease drive = UL_LEASE(robot.drive);
    drive.finishes = count == 3;
    if (ul_connect(&link, arguments[1], 5.0) != UL_OK || ul_lease_arm(&link, &drive, 4.0) != UL_OK) return 1;
    uint64_t start;
    if (ul_get_unsigned(&link, &robot.plan.clock, &start) != UL_OK) return 1;
    for (unsigned row = 1; row <= 20; row++) {
        uint64_t at = start + (5 + row) * (uint64_t)5000000;
        uint64_t batch[] = {2u << 24 | at >> 32, at & 0xFFFFFFFF, 1u << 16, row};
        if (ul_write_queue(&link, 0xA0, batch, 4) != UL_OK) return 1;
    }
    puts("armed");
    fflush(stdout);
    return getchar();
}
"""
IN_OCTAVE = """
robot = robot('{url}');
lease = unity_link.Lease(robot.link, robot.drive);
lease.arm(4, '{on_silence}');
start = uint64(robot.plan.clock.get());
for row = 1:20
    at = start + uint64((5 + row) * 5000000);
    robot.link.write_queue(160, [bitor(uint64(2 ^ 25), bitshift(at, -32)), bitand(at, uint64(2 ^ 32 - 1)), ...
        uint64(65536), uint64(row)]);
end
printf('armed\\n');
fflush(stdout);
input('');
"""


def in_c(folder: Path, url: str, finishes: bool) -> subprocess.Popen[str]:
    generated("c", compile_text(SPEC), folder)
    (folder / "arm.c").write_text(IN_C)
    sources = ["arm.c", "robot.c", "unity_link.c", "unity_link_posix.c"]
    subprocess.run([*C, *STRICT, *sources, "-o", "arm"], cwd=folder, check=True)
    arguments = [str(folder / "arm"), url, *(["finish"] if finishes else [])]
    return subprocess.Popen(arguments, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


@pytest.fixture(params=["c", "octave"])
def begin(request: pytest.FixtureRequest) -> Begin:
    """Return a function that starts a program which arms the drive, and is silent from then on."""
    if request.param == "c":
        return in_c
    octave: Octave = request.getfixturevalue("octave")

    def in_octave(_: Path, url: str, finishes: bool) -> subprocess.Popen[str]:
        octave.generate(compile_text(SPEC))
        return octave.start(IN_OCTAVE.format(url=url, on_silence="finish" if finishes else "safe"))

    return in_octave


@pytest.mark.slow
@pytest.mark.parametrize("way", ["finish", "safe"])
def test_schedule_of_a_killed_program_runs_to_its_end_if_configured_to(begin: Begin, way: str, tmp_path: Path) -> None:
    spec = tmp_path / "robot.ul"
    spec.write_text(SPEC)
    command = [PROGRAM, "serve", f"sim:{spec}", "--unix", str(tmp_path / "gateway")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server:
        try:
            url = line_of(server)
            with begin(tmp_path, url, way == "finish") as program, blocking.connect(url) as link:
                robot: Any = put(unity_link.load(spec), link)
                assert line_of(program) == "armed"
                program.kill()
                seen = seen_until_disarmed(robot)
                assert robot.duty.get() == -1
                if way == "finish":
                    assert max(seen) in {19, 20}
                    assert robot.drive.reason.get().name == "silence"
                    assert robot.plan.refused.get() == robot.plan.late.get() == 0
                else:
                    assert max(seen) < 19
                    assert robot.drive.reason.get().name == "disarmed"
                    assert robot.plan.refused.get() > 0
        finally:
            server.kill()
