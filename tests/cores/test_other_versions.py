"""Boards whose cores have another map than in this version: their registers work, and their core API is refused."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import unity_link
from unity_link import UnsupportedError
from unity_link.bridges.serve import serve
from unity_link.spec import compile_description, compile_file
from unity_link.spec.cores import INSTALLED
from unity_link.virtual.build import simulated

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link.virtual.gateway import Gateway

LEASE = (INSTALLED / "lease" / "lease.ul").read_text(encoding="utf-8")
SCHEDULE = (INSTALLED / "schedule" / "schedule.ul").read_text(encoding="utf-8")
STEPGEN = (INSTALLED / "stepgen" / "stepgen.ul").read_text(encoding="utf-8")
NOT = "is no LEASE as this version of Unity-Link has it: "
OTHERS = {
    "no generic": (LEASE.replace("most_us=", "longest_us="), f"drive {NOT}it has no generic most_us"),
    "a text": (
        LEASE.replace("most_us=TIMEOUT * 1000000", 'most_us="long"'),
        f"drive {NOT}its generic most_us is 'long', a value such as 1000000 was expected",
    ),
    "no register": (LEASE.replace("@kick =", "@feed ="), f"drive {NOT}it has no register kick"),
    "another width": (
        LEASE.replace("@arm = BASE: unsigned 64", "@arm = BASE: unsigned 32"),
        f"drive {NOT}the width of its register arm is 32, 64 was expected",
    ),
    "another place": (
        LEASE.replace("BASE + 17", "BASE + 19"),
        f"drive {NOT}the distance in words of its register arms is 19, 17 was expected",
    ),
    "another access": (
        LEASE.replace("unsigned 1 WRITE()", "unsigned 1 READWRITE()"),
        f"drive {NOT}the access of its register disarm is READWRITE, WRITE was expected",
    ),
    "other names": (
        LEASE.replace("{ disarmed, armed, fault, finishing }", "{ fault, armed }"),
        f"drive {NOT}the enumeration of its register state is fault armed, disarmed armed fault finishing was expected",
    ),
    "no registers": (
        'LEASE(TIMEOUT=1): @(BASE) { ENTITY("ul_lease", most_us=1); @enable: PIN(OUT); }',
        "drive has no registers, so it is no core as this version of Unity-Link has it",
    ),
}
"""Maps of LEASE that differ from ours, and the error for each."""
ROBOT = """
public rover() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=1) @(0xE0);
  @speed = 0x10: signed READWRITE();
}
"""


def board(folder: Path, map_: str, text: str = ROBOT, word: str = "lease") -> Gateway:
    """Return a board that was built from a spec with a core of another map."""
    (folder / "cores" / word).mkdir(parents=True)
    (folder / "cores" / word / f"{word}.ul").write_text(map_)
    (folder / "rover.ul").write_text(text)
    return simulated(compile_file(folder / "rover.ul").interface())


@pytest.mark.asyncio
@pytest.mark.parametrize(("map_", "says"), OTHERS.values(), ids=OTHERS)
async def test_api_of_a_lease_with_another_map_is_refused(map_: str, says: str, tmp_path: Path) -> None:
    async with unity_link.connect(board(tmp_path, map_)) as link:
        robot = await unity_link.robot(link)
        for call in (robot.armed, robot.drive.armed):
            with pytest.raises(UnsupportedError) as caught:
                call()
            assert str(caught.value) == says
        with pytest.raises(UnsupportedError):
            await robot.drive.stop()
        await robot.speed.set(7)
        assert await robot.speed.get() == 7


@pytest.mark.asyncio
@pytest.mark.parametrize("map_", [map_ for map_, _ in OTHERS.values()], ids=OTHERS)
async def test_serve_goes_on_without_a_lease_of_another_map(map_: str, tmp_path: Path) -> None:
    reports: list[str] = []
    async with serve(board(tmp_path, map_), unix=tmp_path / "gateway", report=reports.append) as server:
        for _ in range(2):
            async with unity_link.connect(server.urls[0]) as link:
                await link.write(0x10, 7)
                assert await link.read(0x10) == 7
    (said,) = [text for text in reports if "leases" in text]
    assert said.startswith("its leases are not those of clients, since drive is no LEASE as this version")


@pytest.mark.asyncio
async def test_api_of_a_schedule_with_another_map_is_refused(tmp_path: Path) -> None:
    text = """public rover() {
      GATEWAY(ADDRESS_BITS=12);
      line: SCHEDULE() @(0xE0);
      @pen = 0x10[0]: bool READWRITE(TIMED(line));
    }"""
    async with unity_link.connect(board(tmp_path, SCHEDULE.replace("@slack", "@spare"), text, "schedule")) as link:
        robot = await unity_link.robot(link)
        for call in (robot.line.timeline, lambda: robot.line.play([0], {robot.pen: [1]})):
            with pytest.raises(UnsupportedError, match=r"^line is no SCHEDULE .* it has no register slack$"):
                await call()


@pytest.mark.asyncio
async def test_api_of_a_step_generator_with_another_map_is_refused(tmp_path: Path) -> None:
    text = "public rover() { GATEWAY(ADDRESS_BITS=12); x: STEPGEN() @(0xE0); }"
    map_ = STEPGEN.replace("@in_position", "@there")
    async with unity_link.connect(board(tmp_path, map_, text, "stepgen")) as link:
        robot = await unity_link.robot(link)
        for call in (lambda: robot.x.move_to(1), robot.x.stop):
            with pytest.raises(UnsupportedError, match=r"^x is no STEPGEN .* it has no register in_position$"):
                await call()
        assert await robot.x.velocity_cmd.get() == 0


def test_boards_of_this_version_have_the_api_of_their_cores() -> None:
    cores = ["lease", "schedule", "stepgen", "encoder", "gpio", "pwm"]
    placed = "".join(f"c{at}: {word.upper()}() @({at * 0x20 + 1});" for at, word in enumerate(cores))
    text = f'public r() {{ GATEWAY(ADDRESS_BITS=12); c9: PWM(WIDTH=8, MODE="offset") @(0x200); {placed} }}'
    interface = unity_link.spec.compile_text(text).interface()
    described = compile_description(interface.description).interface()
    assert described.misfits == {}
    assert described.leases == interface.leases == ("c0",)
