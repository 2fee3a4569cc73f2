"""A write that a lease refuses: the error of each generated client contains the reason."""

from __future__ import annotations

import asyncio
import re
import subprocess
from typing import TYPE_CHECKING, Any

import pytest
import pytest_asyncio

import unity_link
from generate.programs import CPP, C, generated
from unity_link.bridges.serve import serve
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.spec import compile_text
from unity_link.virtual.build import simulated
from unity_link.virtual.bus import AccessError
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable
    from pathlib import Path

SPEC = compile_text("""
public robot() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=20, FINISH=20) @(0x80);
  spare: LEASE(TIMEOUT=20) @(0xA0);
  plan: SCHEDULE(DEPTH=64) @(0xC0);
  @duty = 0x10: signed 16 READWRITE(SAFE(-1, drive), TIMED(plan));
  @wide = 0x12: signed 48 READWRITE(SAFE(0, drive));
  @bit = 0x14[3]: bool READWRITE(SAFE(false, spare));
  @other = 0x14[7:4]: unsigned 4 READWRITE(SAFE(0, spare));
  @free = 0x16: READWRITE();
}
""")
ENDS = {
    "c": r"""
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "robot.h"

static ul_link link;

static ul_status set_all(void)
{
    uint64_t words[3][UL_SIGNAL_WORDS] = {{1}, {0}, {1 << 3}};
    ul_batch batch = UL_BATCH;
    ul_start_set(&link, &batch, &robot.free.signal, words[0]);
    ul_start_set(&link, &batch, &robot.wide.signal, words[1]);
    ul_start_set(&link, &batch, &robot.bit.signal, words[2]);
    return ul_finish(&link, &batch);
}

int main(int count, char **arguments)
{
    ul_lease drive = UL_LEASE(robot.drive), again = UL_LEASE(robot.drive);
    char line[16];
    while (count == 2 && fgets(line, sizeof line, stdin) != NULL) {
        ul_status status = UL_OK;
        line[strcspn(line, "\n")] = '\0';
        drive.finishes = strcmp(line, "finish") == 0;
        if (strcmp(line, "open") == 0) status = ul_connect(&link, arguments[1], 5.0);
        else if (strcmp(line, "set") == 0) status = ul_set_signed(&link, &robot.duty, 3);
        else if (strcmp(line, "bit") == 0) status = ul_set_bool(&link, &robot.bit, true);
        else if (strcmp(line, "free") == 0) status = ul_set_unsigned(&link, &robot.free, 3);
        else if (strcmp(line, "raw") == 0) status = ul_write(&link, 0x10, 3);
        else if (strcmp(line, "post") == 0) status = ul_post_signed(&link, &robot.duty, 3);
        else if (strcmp(line, "fence") == 0) status = ul_fence(&link);
        else if (strcmp(line, "all") == 0) status = set_all();
        else if (strcmp(line, "arm") == 0) status = ul_lease_arm(&link, &drive, 10.0);
        else if (strcmp(line, "again") == 0) status = ul_lease_arm(&link, &again, 10.0);
        else if (strcmp(line, "long") == 0) status = ul_lease_arm(&link, &drive, 100.0);
        else if (strcmp(line, "brief") == 0) status = ul_lease_arm(&link, &drive, 0.3);
        else if (strcmp(line, "finish") == 0) status = ul_lease_arm(&link, &drive, 0.3);
        else if (strcmp(line, "kick") == 0) status = ul_lease_kick(&link, &drive);
        else if (strcmp(line, "disarm") == 0) status = ul_lease_disarm(&link, &drive);
        else return 1;
        printf("%s\n", status == UL_OK ? "" : ul_error(&link));
        fflush(stdout);
    }
    return 0;
}
""",
    "cpp": r"""
#include <iostream>
#include "robot.hpp"

int main(int, char **arguments)
{
    unity_link::Link link{arguments[1]};
    Robot the_robot{link};
    std::string line;
    while (std::getline(std::cin, line)) {
        try {
            if (line == "set") the_robot.duty.set(3);
            else if (line == "post") the_robot.duty.post(3);
            else if (line == "fence") link.fence();
            std::cout << std::endl;
        } catch (const unity_link::BusError &error) {
            std::cout << error.what() << std::endl;
        }
    }
}
""",
}
NEVER = "drive is not armed: nobody has armed it since the reset"
TAKEN = "another program has armed drive, and it alone may move what that guards"
REFUSED = "the bus refused the access"


class Program:
    """A client in another language on a server with the spec, and a link in Python to the same server."""

    def __init__(self, process: asyncio.subprocess.Process, gateway: Any, robot: Any) -> None:
        self._process = process
        self.gateway = gateway
        self.robot = robot
        """The robot on the link in Python."""

    async def do(self, command: str) -> str:
        """Send a command; return the error, or "" without an error."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(f"{command}\n".encode())
        line = await self._process.stdout.readline()
        assert line.endswith(b"\n")
        return line.decode().strip()

    async def reaches(self, state: str) -> None:
        """Wait until the lease has a state."""
        while await self.robot.drive.state.get() != state:
            pass


def built(language: str, folder: Path) -> Path:
    """Compile the program of a language; return its path."""
    sources = [str(path) for path in generated(language, SPEC, folder) if path.suffix == ".c"]
    main = folder / f"main.{language}"
    main.write_text(ENDS[language])
    run = ["-I", str(folder), "-o", str(folder / "main")]
    if language == "cpp":
        objects = []
        for source in sources:
            subprocess.run([*C, f"-I{folder}", "-c", source, "-o", f"{source}.o"], check=True)
            objects.append(f"{source}.o")
        subprocess.run([*CPP, str(main), *objects, *run], check=True)
    else:
        subprocess.run([*C, str(main), *sources, *run], check=True)
    return folder / "main"


class _Faulty(SimulatedRobot):
    """A robot whose register `free` refuses all writes, and `duty` refuses them if `is_broken`."""

    is_broken = False

    def written(self, name: str, value: Any) -> None:
        if name == "free" or (name == "duty" and self.is_broken):
            raise AccessError(ErrorCode.BUS_ERROR)


@pytest_asyncio.fixture
async def start(tmp_path: Path) -> AsyncIterator[Callable[[str], Any]]:
    gateway: Any = simulated(SPEC.interface(), _Faulty)
    processes = []
    async with serve(gateway, unix=tmp_path / "gateway") as server, unity_link.connect(server.urls[0]) as link:

        async def begin(language: str) -> Program:
            program = await asyncio.to_thread(built, language, tmp_path)
            process = await asyncio.create_subprocess_exec(
                program, server.urls[0], stdin=subprocess.PIPE, stdout=subprocess.PIPE
            )
            processes.append(process)
            made = Program(process, gateway, unity_link.load(SPEC)(link))
            assert await made.do("open") == ""
            return made

        yield begin
        for process in processes:
            process.kill()
            await process.wait()


@pytest.mark.asyncio
async def test_error_in_c_has_the_reason_why_a_lease_refuses_a_write(start: Callable[[str], Any]) -> None:
    program = await start("c")
    do, robot = program.do, program.robot
    duty = f"write of duty at 0x010: {REFUSED}"
    assert await do("set") == f"{duty}: {NEVER}"
    assert (await do("post"), await do("fence")) == ("", f"posted {duty}: {NEVER}")
    # The masked write of a field, and words without a signal
    assert await do("bit") == f"masked write of bit at 0x014: {REFUSED}: {NEVER.replace('drive', 'spare')}"
    assert await do("raw") == f"write at 0x010: {REFUSED}"
    assert (await do("arm"), await do("set"), await do("kick")) == ("", "", "")
    assert await do("again") == "drive.armed at 0x090: it cannot be armed: this program has armed it already"
    assert (await do("disarm"), await do("set")) == ("", f"{duty}: drive is not armed: it was disarmed")
    assert await do("kick") == "drive.armed at 0x090: drive is not armed: it was disarmed"
    async with robot.drive.armed():
        assert await do("set") == f"{duty}: {TAKEN}"
        assert (await do("post"), await do("fence")) == ("", f"posted {duty}: {TAKEN}")
        assert await do("kick") == "drive.armed at 0x090: it has ended, and another program has armed it since"
        assert await do("arm") == "drive.armed at 0x090: it cannot be armed: another program has armed it"
    assert await do("brief") == ""
    await program.reaches("fault")
    silent = r"drive is not armed: no kick came before its end, at \d+\.\d{6} s of the gateway's clock"
    assert re.fullmatch(f"{duty}: {silent}", await do("set"))
    assert re.fullmatch(f"drive.armed at 0x090: {silent}", await do("kick"))
    assert await do("arm") == ""
    program.gateway.robot.drive.estop = 0
    await program.reaches("fault")
    assert re.fullmatch(rf"{duty}: drive is not armed: its e-stop was opened, at \d+\.\d+ s of .*", await do("set"))
    assert await do("arm") == "drive.armed at 0x090: it cannot be armed: its e-stop is open"
    program.gateway.robot.drive.estop = 1
    assert (await do("long")).endswith(
        "it was not armed: the line takes longer than the lease, or that is longer than TIMEOUT of the spec"
    )


@pytest.mark.asyncio
async def test_error_in_c_for_a_write_that_a_module_refuses_names_no_lease(start: Callable[[str], Any]) -> None:
    program = await start("c")
    # A batch reports its first failure, with the signal of that write.
    assert await program.do("all") == f"write of free at 0x016: {REFUSED}"
    assert await program.do("arm") == ""
    program.gateway.robot.is_broken = True
    assert await program.do("set") == f"write of duty at 0x010: {REFUSED}"


@pytest.mark.slow
@pytest.mark.asyncio
async def test_error_in_cpp_has_the_reason_why_a_lease_refuses_a_write(start: Callable[[str], Any]) -> None:
    program = await start("cpp")
    duty = f"write of duty at 0x010: {REFUSED}: {NEVER}"
    assert await program.do("set") == duty
    assert (await program.do("post"), await program.do("fence")) == ("", f"posted {duty}")
