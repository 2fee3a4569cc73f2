"""The lease of a program in C ends when its link is opened again, whatever the registers of the gateway contain."""

from __future__ import annotations

import asyncio
import contextlib
import subprocess
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from generate.programs import STRICT, C, generated
from unity_link import UnityLinkError
from unity_link.bridges.serve import serve
from unity_link.spec import compile_text
from unity_link.virtual.build import simulated

if TYPE_CHECKING:
    from pathlib import Path

SPEC = compile_text("""
public robot() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=20) @(0x80);
  @duty = 0x10: signed 16 READWRITE(SAFE(-1, drive));
}
""")
PROGRAM = r"""
#include <stdio.h>
#include <string.h>
#include "robot.h"

static ul_link link;

int main(int count, char **arguments)
{
    ul_lease drive = UL_LEASE(robot.drive);
    char line[16];
    while (count == 2 && fgets(line, sizeof line, stdin) != NULL) {
        ul_status status = strcmp(line, "open\n") == 0  ? ul_connect(&link, arguments[1], 5.0)
                         : strcmp(line, "arm\n") == 0 ? ul_lease_arm(&link, &drive, 10.0)
                                                       : ul_lease_kick(&link, &drive);
        printf("%d %s\n", (int)status, status == UL_OK ? "" : ul_error(&link));
        fflush(stdout);
    }
    return 0;
}
"""


@pytest.mark.slow
@pytest.mark.asyncio
async def test_a_kick_on_a_link_that_was_opened_again_is_refused(tmp_path: Path) -> None:
    generated("c", SPEC, tmp_path)
    (tmp_path / "kick.c").write_text(PROGRAM)
    sources = ["kick.c", "robot.c", "unity_link.c", "unity_link_posix.c"]
    await asyncio.to_thread(subprocess.run, [*C, *STRICT, *sources, "-o", "kick"], cwd=tmp_path, check=True)
    gateway: Any = simulated(SPEC.interface())
    async with serve(gateway, unix=tmp_path / "gateway") as server, unity_link.connect(server.urls[0]) as link:
        program = await asyncio.create_subprocess_exec(
            tmp_path / "kick", server.urls[0], stdin=subprocess.PIPE, stdout=subprocess.PIPE
        )
        asks, answers = program.stdin, program.stdout
        assert asks is not None
        assert answers is not None

        async def do(command: str) -> str:
            asks.write(f"{command}\n".encode())
            return (await answers.readline()).decode().strip()

        assert [await do(command) for command in ("open", "arm", "kick")] == ["0"] * 3
        gateway.reset()
        robot: Any = unity_link.load(SPEC)(link)
        while not link.resets:
            with contextlib.suppress(UnityLinkError):
                await robot.duty.get()
        async with robot.armed():
            # After an idle second, the link first proves its session; it cannot know whether the read was executed.
            kicked = await do("kick")
            assert kicked[:2] in {"32", "34"}, kicked
            assert "the gateway was reset, which ends the link" in kicked
            assert await do("open") == "0"
            assert (await do("kick")).endswith("drive.armed at 0x090: it was armed in another session: arm it again")
            assert await robot.drive.armed_.get()
        assert await do("arm") == "0"
        assert await do("kick") == "0"
        asks.close()
        await program.wait()
