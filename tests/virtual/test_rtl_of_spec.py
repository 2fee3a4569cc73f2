"""The compiled gateware of a spec: its configuration is that of the generated VHDL, and so is what it refuses."""

from __future__ import annotations

import asyncio
import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

import unity_link
from support.bridge_programs import PROGRAM
from support.simulated_time import on_simulated_time
from unity_link.errors import ArgumentError, UnsupportedError
from unity_link.protocol.configuration import Feature
from unity_link.spec import compile_file, compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.build import simulate
from unity_link.virtual.rtl import configurations
from unity_link.virtual.rtl.specs import configuration_of, configuration_of_node
from unity_link.virtual.shared_line import build_shared_line
from unity_link.virtual.simulated import SimulatedRobot

EXAMPLES = Path(__file__).parents[2] / "examples"
ROVER, WALKER = EXAMPLES / "rover.ul", EXAMPLES / "walker.ul"
MODEL = f"{EXAMPLES / 'rover.py'}:Rover"
Walker = unity_link.load(WALKER)

pytestmark = pytest.mark.rtl


def test_the_configuration_is_that_of_the_generated_gateway() -> None:
    interface = compile_file(ROVER).interface()
    info = configuration_of(interface, {}, None).info
    assert (info.address_bits, info.data_bits, info.groups, info.group_words) == (8, 32, 16, 32)
    assert info.base_frequency_millihertz == 100_000_000
    assert Feature.FINGERPRINT in info.features
    assert info.build_id == interface.fingerprint
    # The slowest clock that leaves a base tick its cycles.
    assert info.clock_hz == 100_000 * 24
    # The bank behind it is.
    assert json.loads(configuration_of(interface, {}, None).generics)["wb_pipelined"]
    chosen = {"base_frequency_millihertz": 10_000_000, "features": 0x11, "transmit_fifo_bytes": 512}
    other = configuration_of(interface, chosen, 7).info
    assert (other.clock_hz, other.transmit_fifo_bytes) == (500_000, 512)
    assert other.features == Feature(0x11) | Feature.ADDRESSED


def test_that_of_a_node_is_what_the_model_of_one_is() -> None:
    info = build_shared_line([7], info=configurations()["default"].info).info
    build = configuration_of_node(info, 7)
    assert build.node == 7
    assert build.info == VirtualGateway(info, node=7).info
    assert Feature.HALF_DUPLEX in build.info.features


def test_that_of_the_walker_comes_with_the_package() -> None:
    build = configuration_of(compile_file(WALKER).interface(), {}, None)
    assert build is configurations()["walker"]
    assert build.info.group_words == 36


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"clock_hz": 1_000_000}, "leaves 10 cycles of a clock of 1000000 Hz, and 16 groups take 24: at most 41666 Hz"),
        ({"group_words": 255}, "sample_depth is 256, and one sample of a group of 255 words takes 257: at least 512"),
        ({"data_bits": 65}, "data_bits is 65: 8 to 64 was expected"),
        ({"receive_fifo_bytes": 100}, "rx_fifo_depth is 100: a power of two was expected"),
        ({"transmit_fifo_bytes": 0x10000}, "tx_fifo_depth is 65536: at most 32768 was expected"),
        ({"crc_bits": 8, "crc_polynomial": 0x1021}, "crc_polynomial is 0x1021: that of a CRC of 8 bits was expected"),
    ],
)
def test_what_the_gateware_refuses_is_refused_before_it_is_built(fields: dict[str, int], words: str) -> None:
    with pytest.raises(ArgumentError, match=words):
        configuration_of(compile_file(ROVER).interface(), fields, None)


@pytest.mark.parametrize(("bits", "polynomial"), [(8, 0x07), (16, 0x1021), (32, 0x04C11DB7)])
def test_a_crc_of_another_width_has_the_usual_polynomial_of_that(bits: int, polynomial: int) -> None:
    build = configuration_of(compile_file(ROVER).interface(), {"crc_bits": bits}, None)
    assert build.info.crc_polynomial == polynomial
    build.info.check()


class Marching(SimulatedRobot):
    """All joints stand where the robot's clock is."""

    legs: Any

    def step(self, dt: float) -> None:
        for leg in self.legs:
            for joint in (leg.coxa, leg.femur, leg.tibia):
                joint.cpos = self.now


@on_simulated_time
async def test_a_model_moves_behind_the_gateware_and_each_sample_is_of_one_instant() -> None:
    async with unity_link.connect(simulate(WALKER, Marching, rtl=True)) as link:
        robot = Walker(link)
        assert link.gateway.build_id == Walker.interface.fingerprint
        with pytest.raises(unity_link.BusError):
            await link.read(0x00)
        async with robot.groups["state"].subscribe() as samples:
            await asyncio.sleep(0.1)
            batch = await samples.take()
        columns = [batch[signal].tolist() for signal in batch.proxies if signal.path.endswith("cpos")]
        assert len(columns) == 18
        assert all(column == columns[0] for column in columns)
        assert columns[0][-1] > columns[0][0]
        assert not batch.lost.any()


@on_simulated_time
async def test_a_gateway_that_is_late_publishes_less_often_and_loses_nothing() -> None:
    async with unity_link.connect("rtl:walker") as link, Walker(link).groups["state"].subscribe() as samples:
        await asyncio.sleep(0.02)
        for _ in range(3):
            loop: Any = asyncio.get_running_loop()
            # Longer than a pump makes up for.
            loop.jump(2.0)
            await asyncio.sleep(0.02)
        assert samples.received > 30
        assert samples.lost == 0


@on_simulated_time
async def test_each_group_of_the_gateware_has_a_trigger_of_its_own() -> None:
    async with (
        unity_link.connect("rtl:?trigger=7:20") as link,
        link.subscribe([0x10], trigger=True, group=7) as fired,
        link.subscribe([0x10], trigger=True, group=8) as silent,
    ):
        await asyncio.sleep(0.51)
        assert fired.received in (10, 11)
        assert (fired.lost, silent.received) == (0, 0)


@pytest.mark.parametrize(
    ("programs", "words"),
    [
        ([], "the gateware is compiled at its first use, and no C++ compiler is there: apt install g++"),
        (["c++"], "the gateware of rover cannot be built: GHDL 4 or later converts the gateware, and there is none"),
    ],
)
def test_a_missing_tool_is_one_sentence(programs: list[str], words: str, tmp_path: Path) -> None:
    for program in programs:
        (tmp_path / program).symlink_to(str(shutil.which(program)))
    environment = {"PATH": str(tmp_path), "XDG_CACHE_HOME": str(tmp_path / "cache"), "HOME": str(tmp_path)}
    environment |= {name: os.environ[name] for name in ("PYTHONPATH",) if name in os.environ}
    command = [PROGRAM, "read", f"rtl:{ROVER}", "0x10"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False, env=environment)
    assert done.returncode == 1
    assert f"error: {words}" in done.stderr
    assert "Traceback" not in done.stderr
    assert not list((tmp_path / "cache").rglob("*.cc"))


@pytest.mark.campaign
def test_any_spec_is_built_once_and_kept(tmp_path: Path) -> None:
    environment = {**os.environ, "XDG_CACHE_HOME": str(tmp_path)}
    if (tools := Path("~/.cache/unity-link/tools").expanduser()).exists():
        (tmp_path / "unity-link").mkdir()
        (tmp_path / "unity-link" / "tools").symlink_to(tools)
    output = tmp_path / "run.mcap"
    said = []
    for _ in range(2):
        command = [PROGRAM, "record", f"rtl:{ROVER}?model={MODEL}", str(ROVER), "-o", str(output), "--overwrite"]
        done = subprocess.run(
            [*command, "--duration", "2"], capture_output=True, text=True, timeout=600, check=True, env=environment
        )
        said.append(done.stderr)
    assert "building the gateware of rover: once" in said[0]
    assert "the gateware of rover was built in " in said[0]
    assert "building" not in said[1]
    assert ", 0 lost" in said[1]


def test_a_spec_without_groups_has_a_configuration() -> None:
    interface = compile_text("public one() { @a = 0x10: READWRITE(); }").interface()
    assert configuration_of(interface, {}, None).info.groups == 16


@pytest.mark.parametrize("kind", ["PWM", "GPIO", "QUADRATURE", "COUNTER"])
@on_simulated_time
async def test_no_memory_stands_for_logic_that_the_gateware_does_not_have(kind: str, tmp_path: Path) -> None:
    (tmp_path / "robot.ul").write_text(f"public robot() {{ part: {kind}(BASE=0x20, SIZE=2); }}\n")
    with pytest.raises(
        UnsupportedError, match=rf"^robot has the module {kind} part, which the gateware has no logic for"
    ):
        await unity_link.connect(f"rtl:{tmp_path}/robot.ul")
    with pytest.raises(UnsupportedError, match="take sim:"):
        simulate(tmp_path / "robot.ul", rtl=True)
    async with unity_link.connect(f"sim:{tmp_path}/robot.ul") as link:
        await link.write(0x20, 5)
        assert await link.read(0x20) == 5


@pytest.mark.parametrize("declared", ["pool: MEMORY(BASE=0, SIZE=4)", "queue: FIFO(BASE=0)", "TOSNET(BASE=0)"])
def test_memory_and_queues_are_behind_the_gateware(declared: str, tmp_path: Path) -> None:
    (tmp_path / "robot.ul").write_text(f"public robot() {{ {declared}; }}\n")
    simulate(tmp_path / "robot.ul", rtl=True)
