"""The compiled gateware of a spec is the generated VHDL with its registers, and has a model at its ports."""

from __future__ import annotations

import asyncio
import json
import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import msgspec
import pytest

import unity_link
from support.bridge_programs import PROGRAM
from support.simulated_time import on_simulated_time
from unity_link.errors import ArgumentError
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.messages import GroupFlag
from unity_link.spec import compile_file, compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.build import simulate
from unity_link.virtual.rtl import configurations
from unity_link.virtual.rtl.making import origin
from unity_link.virtual.rtl.spec_gateway import SpecGateway
from unity_link.virtual.rtl.specs import configuration_of, configuration_of_node, made
from unity_link.virtual.shared_line import build_shared_line
from unity_link.virtual.simulated import SimulatedRobot

EXAMPLES = Path(__file__).parents[2] / "examples"
ROVER, WALKER = EXAMPLES / "rover.ul", EXAMPLES / "walker.ul"
MODEL = f"{EXAMPLES / 'rover.py'}:Rover"
Rover = unity_link.load(ROVER)
Walker = unity_link.load(WALKER)

pytestmark = pytest.mark.rtl


def test_the_configuration_is_that_of_the_generated_gateway() -> None:
    interface = compile_file(ROVER).interface()
    info = configuration_of(interface, {}, None).info
    assert (info.address_bits, info.data_bits, info.groups, info.group_words) == (8, 32, 16, 32)
    assert info.base_frequency_millihertz == 100_000_000
    assert Feature.FINGERPRINT in info.features
    assert info.build_id == interface.fingerprint
    # The slowest clock with enough cycles for a base tick.
    assert info.clock_hz == 100_000 * 24
    # The register bank at the bus is pipelined.
    assert json.loads(configuration_of(interface, {}, None).generics)["wb_pipelined"]
    chosen = {"base_frequency_millihertz": 10_000_000, "features": 0x11, "transmit_fifo_bytes": 512}
    other = configuration_of(interface, chosen, 7).info
    assert (other.clock_hz, other.transmit_fifo_bytes) == (500_000, 512)
    assert other.features == Feature(0x11) | Feature.ADDRESSED


@pytest.mark.parametrize(
    ("core", "group", "fields", "clock_hz", "base_hz"),
    [
        pytest.param("LEASE()", "RATE=200", {}, 200_000, 5000, id="a clock that a PC keeps pace with"),
        pytest.param("PWM()", "RATE=200", {}, 320_000, 10_000, id="16 cycles in a period of 20 kHz"),
        pytest.param("PWM(FREQUENCY=1000)", "RATE=300", {}, 201_600, 4800, id="a multiple of the rates"),
        pytest.param("LEASE()", "RATE=20000", {}, 480_000, 20_000, id="a rate that is above the usual base"),
        pytest.param("LEASE()", "DIVISOR=100", {}, 2_400_000, 100_000, id="a divisor counts from the gateware's own"),
        pytest.param("PWM()", "RATE=200", {"clock_hz": 1_000_000}, 1_000_000, 20_000, id="the user's clock"),
        pytest.param("PWM()", "RATE=200", {"base_frequency_millihertz": 1_000_000}, 320_000, 1000, id="and base"),
        pytest.param("", "RATE=200", {"clock_hz": 1_000_000}, 1_000_000, 20_000, id="without cores as well"),
    ],
)
def test_the_clock_of_a_spec_with_cores_is_slow_enough_for_a_pc(
    core: str, group: str, fields: dict[str, int], clock_hz: int, base_hz: int
) -> None:
    placed = f"core: {core} @(0x20);" if core else ""
    text = (
        f"group state({group}); public robot() {{ GATEWAY(ADDRESS_BITS=12); {placed} @a = 1: READ(PUBLISH(state)); }}"
    )
    info = configuration_of(compile_text(text).interface(), fields, None).info
    assert (info.clock_hz, info.base_frequency_millihertz) == (clock_hz, base_hz * 1000)


def test_a_clock_that_is_too_slow_for_its_rates_is_refused() -> None:
    text = "group state(RATE=20000); public robot() { @a = 1: READ(PUBLISH(state)); }"
    with pytest.raises(ArgumentError, match="a clock of at least 480000 Hz, was expected"):
        configuration_of(compile_text(text).interface(), {"clock_hz": 100_000}, None)


def test_the_configuration_of_a_node_is_that_of_its_model() -> None:
    info = build_shared_line([7], info=configurations()["default"].info).info
    build = configuration_of_node(info, 7)
    assert build.node == 7
    assert build.info == VirtualGateway(info, node=7).info
    assert Feature.HALF_DUPLEX in build.info.features


def test_the_configuration_of_the_walker_is_that_of_the_packages_build() -> None:
    build = configuration_of(compile_file(WALKER).interface(), {}, None)
    ready = configurations()["walker"].info
    assert build.info == msgspec.structs.replace(ready, features=ready.features | Feature.DESCRIPTION)
    assert build.design is not None
    assert build.design.top == "walker_flat"
    assert build.design.masters == (("elsewhere", 0),)


def test_addresses_with_one_answer_are_not_joined_in_one_vector() -> None:
    text = made(configuration_of(compile_file(WALKER).interface(), {}, None)).text().decode()
    plain = r"(?:[^()]|\(\))*"
    together = re.findall(rf"reduce_or<1>\(({plain}(?:\.concat\({plain}\))+)", text)
    # A compiler takes minutes for a chain of hundreds of signals.
    assert 0 < max(one.count(".concat(") for one in together) < 16


def test_doc_comments_and_positions_do_not_cause_another_build(tmp_path: Path) -> None:
    (tmp_path / "moved.ul").write_text("// Something else.\n" + ROVER.read_text())
    built = [configuration_of(compile_file(path).interface(), {}, None) for path in (ROVER, tmp_path / "moved.ul")]
    assert origin({}, built[0].design) == origin({}, built[1].design)


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        (
            {"clock_hz": 1_000_000, "base_frequency_millihertz": 100_000_000},
            "leaves 10 cycles of a clock of 1000000 Hz, and 16 groups take 24: at most 41666 Hz",
        ),
        ({"group_words": 255}, "sample_depth is 256, and one sample of a group of 255 words takes 257: at least 512"),
        ({"data_bits": 64}, r"data_bits is 64: the register bank of rover has the 32 of its spec; GATEWAY"),
        ({"address_bits": 9}, "address_bits is 9: the register bank of rover has the 8 of its spec"),
        ({"receive_fifo_bytes": 100}, "rx_fifo_depth is 100: a power of two was expected"),
        ({"transmit_fifo_bytes": 0x10000}, "tx_fifo_depth is 65536: at most 32768 was expected"),
        ({"crc_bits": 8, "crc_polynomial": 0x1021}, "crc_polynomial is 0x1021: that of a CRC of 8 bits was expected"),
    ],
)
def test_impossible_fields_are_refused_before_a_build(fields: dict[str, int], words: str) -> None:
    with pytest.raises(ArgumentError, match=words):
        configuration_of(compile_file(ROVER).interface(), fields, None)


@pytest.mark.parametrize(("bits", "polynomial"), [(8, 0x07), (16, 0x1021), (32, 0x04C11DB7)])
def test_a_crc_of_another_width_has_the_usual_polynomial_of_that_width(bits: int, polynomial: int) -> None:
    build = configuration_of(compile_file(ROVER).interface(), {"crc_bits": bits}, None)
    assert build.info.crc_polynomial == polynomial
    build.info.check()


class Marching(SimulatedRobot):
    """The position of every joint is the robot's time."""

    legs: Any

    def step(self, dt: float) -> None:
        for leg in self.legs:
            for joint in (leg.coxa, leg.femur, leg.tibia):
                joint.cpos = self.now


@pytest.mark.slow
@on_simulated_time
async def test_a_model_moves_and_each_sample_of_the_gateware_is_of_one_instant() -> None:
    async with unity_link.connect(simulate(WALKER, Marching, rtl=True)) as link:
        robot = Walker(link)
        assert link.gateway.build_id == Walker.interface.fingerprint
        assert (await unity_link.robot(link)).interface.description == Walker.interface.description
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


@pytest.mark.slow
def test_a_gateway_with_registers_is_idle_after_its_answer() -> None:
    interface = compile_file(WALKER).interface()
    gateway = SpecGateway(made(configuration_of(interface, {}, None)), interface)
    gateway.receive(b"Q\r", 0.0)
    before = gateway.cycles
    gateway._run_until_quiet()
    assert gateway.cycles - before < 200


@pytest.mark.slow
@on_simulated_time
async def test_a_late_gateway_publishes_less_often_without_a_loss() -> None:
    async with unity_link.connect("rtl:walker") as link, Walker(link).groups["state"].subscribe() as samples:
        await asyncio.sleep(0.02)
        loop: Any = asyncio.get_running_loop()
        # A pause too long for the model clock to catch up.
        loop.jump(2.0)
        await asyncio.sleep(0.02)
        assert samples.received > 15
        assert samples.lost == 0


@on_simulated_time
async def test_each_group_of_the_gateware_has_its_own_trigger() -> None:
    async with (
        unity_link.connect("rtl:?trigger=7:20") as link,
        link.subscribe([0x10], trigger=True, group=7) as fired,
        link.subscribe([0x10], trigger=True, group=8) as silent,
    ):
        await asyncio.sleep(0.51)
        assert fired.received in (10, 11)
        assert (fired.lost, silent.received) == (0, 0)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("programs", "words"),
    [
        ([], "the gateware is compiled at its first use, and no C++ compiler is there: apt install g++"),
        (["c++"], "the gateware of rover cannot be built: GHDL 4 or later converts the gateware, and there is none"),
    ],
)
def test_the_error_for_a_missing_tool_is_one_sentence(programs: list[str], words: str, tmp_path: Path) -> None:
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
def test_any_spec_is_built_once_and_cached(tmp_path: Path) -> None:
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


@pytest.mark.slow
@on_simulated_time
async def test_memory_and_queues_are_at_the_ports_of_the_gateware(tmp_path: Path) -> None:
    spec = tmp_path / "robot.ul"
    spec.write_text(
        "public robot() { @a = 0x30: READWRITE(); pool: MEMORY(BASE=0x10, SIZE=4); queue: FIFO(BASE=0x20, WORDS=2);\n"
        "node: TOSNET(BASE=0x80); }\n"
    )
    gateway = simulate(spec, rtl=True)
    async with unity_link.connect(gateway) as link:
        await link.write_block(0x10, [1, 2, 3, 4])
        assert (await link.read_block(0x10, 4)).tolist() == [1, 2, 3, 4]
        await link.write_queue(0x20, [5, 6])
        with pytest.raises(unity_link.BusError):
            await link.write(0x20, 7)
        assert (await link.read_queue(0x20, 2)).tolist() == [5, 6]
        await link.write(0x85, 9)
        assert await link.read(0x85) == 9
        with pytest.raises(unity_link.BusError):
            await link.read(0x40)
        gateway.attach(Counting(), [0x40, 0x41])
        assert [await link.read(0x41), await link.read(0x41), await link.read(0x40)] == [1, 2, 3]
        with pytest.raises(unity_link.BusError):
            await link.read(0x42)
        with pytest.raises(ArgumentError, match="0x30, the address of a in the register bank of robot: an"):
            gateway.attach(Counting(), [0x30])


class Counting:
    """Counts its reads."""

    def __init__(self) -> None:
        self.count = 0

    def read(self, offset: int, now: float) -> int:
        self.count += 1
        return self.count

    def write(self, offset: int, value: int, now: float) -> None:
        raise NotImplementedError


class Told(SimulatedRobot):
    """Records the written values and their times; it reads the left wheel as of its last step."""

    left: Any
    log: Any

    def start(self) -> None:
        self.told: list[tuple[str, Any, float]] = []
        self.battery = 12.5

    def step(self, dt: float) -> None:
        self.left.position += dt
        self.hits = round(self.now * 1000)
        if self.hits == 20:
            self.trigger("bump")

    def written(self, path: str, value: Any) -> None:
        self.told.append((path, value, self.now))
        if path == "lamps":
            self.log.put(value)


@pytest.mark.slow
@on_simulated_time
async def test_a_program_and_a_model_share_the_ports_of_the_register_bank() -> None:
    gateway = simulate(ROVER, Told, rtl=True)
    async with unity_link.connect(gateway) as link:
        rover, model = Rover(link), gateway.robot
        assert await rover.battery.get() == 12.5
        await rover.left.duty.set(-0.5)
        # The gateware does not check limits.
        await link.write(0x31, 200)
        assert [(path, value) for path, value, _ in model.told] == [("left.duty", -1024 / 2047), ("lamps", 200)]
        assert (model.left.duty, model.lamps, model.right.duty) == (-1024 / 2047, 200, 0)
        assert await rover.log.get() == 200
        with pytest.raises(unity_link.BusError):
            await rover.log.get()
        async with rover.groups["bump"].subscribe() as samples:
            await asyncio.sleep(0.1)
            batch = await samples.take()
        # The group has the values of the step that fired its trigger, although time was skipped.
        assert batch["hits"].tolist() == [20]
        assert await rover.left.position.get() == pytest.approx(model.now, abs=0.002)
        async with rover.groups["motion"].subscribe() as samples:
            await asyncio.sleep(0.1)
            moved = (await samples.take())["left.position"].tolist()
        assert [round(step, 3) for step in map(float.__sub__, moved[1:], moved)] == [0.01] * (len(moved) - 1)
        gateway.reset()
        assert (model.left.duty, model.lamps) == (0, 0)


@on_simulated_time
async def test_only_faults_that_gateware_supports_can_be_set() -> None:
    gateway = simulate(ROVER, Told, rtl=True)
    async with unity_link.connect(gateway) as link:
        rover, model = Rover(link), gateway.robot
        model.set_fault("left.position", "frozen")
        before = await rover.left.position.get()
        await asyncio.sleep(1)
        assert await rover.left.position.get() == before
        model.set_fault("left.position", on=False)
        assert await rover.left.position.get() > before + 0.9
        for path, how in (("battery", "error"), ("battery", "timeout"), ("lamps", "frozen"), ("log", "error")):
            with pytest.raises(ArgumentError, match=f"^{path} cannot have the fault {how}, as the compiled"):
                model.set_fault(path, how)  # type: ignore[arg-type]
    with pytest.raises(ArgumentError, match="battery cannot have the fault timeout"):
        await unity_link.connect(f"rtl:{ROVER}?fault=battery:timeout")


class Presumptuous(SimulatedRobot):
    """Sets a signal that only programs may write."""

    def start(self) -> None:
        self.lamps = 3


class Later(Presumptuous):
    """Sets it in a step instead."""

    def start(self) -> None:
        pass

    def step(self, dt: float) -> None:
        self.lamps = 3


@on_simulated_time
async def test_a_model_cannot_set_signals_that_programs_write(caplog: pytest.LogCaptureFixture) -> None:
    words = "lamps is READWRITE, and its register in the gateware changes with the writes of programs alone"
    with pytest.raises(ArgumentError, match=words):
        simulate(ROVER, Presumptuous, rtl=True)
    async with unity_link.connect(simulate(ROVER, Later, rtl=True)) as link:
        await asyncio.sleep(0.1)
        assert await Rover(link).lamps.get() == 0
    assert "failed 0.001 s after its start: nothing moves from now on" in caplog.text
    assert words in str(caplog.records[-1].exc_info)


class Faulty(Told):
    """A model with a bug."""

    def written(self, path: str, value: Any) -> None:
        raise ZeroDivisionError


@on_simulated_time
async def test_a_bug_in_a_model_is_logged_and_registers_continue(caplog: pytest.LogCaptureFixture) -> None:
    async with unity_link.connect(simulate(ROVER, Faulty, rtl=True)) as link:
        for lamps in (1, 2):
            await Rover(link).lamps.set(lamps)
            assert await Rover(link).lamps.get() == lamps
    assert [record.getMessage() for record in caplog.records if "failed in written" in record.getMessage()] == [
        "<Faulty of rover> failed in written('lamps'), which changes nothing in the gateware (told once)"
    ]


@on_simulated_time
async def test_ports_are_read_driven_and_counted_in_each_clock_cycle() -> None:
    gateway = simulate(ROVER, rtl=True)
    bare: Any = gateway._gateway
    ports = gateway.ports
    assert {name: (port.is_input, port.width) for name, port in ports.items() if name.startswith("left")} == {
        "left_duty": (False, 12),
        "left_duty_written": (False, 1),
        "left_position": (True, 32),
        "left_speed": (True, 32),
    }
    with pytest.raises(ArgumentError, match="left_duty is an output of the gateware"):
        ports["left_duty"].drive(0)
    with pytest.raises(ArgumentError, match="left_speed is driven to 0x100000000: 32 bits were expected"):
        ports["left_speed"].drive(1 << 32)
    duty, written = ports["left_duty"], ports["left_duty_written"]
    assert set(duty.take_counts() + written.take_counts()) == {(0, 0)}
    async with unity_link.connect(gateway) as link:
        for word in (0x001, 0x801, 0x801):
            await link.write(0x12, word)
        assert duty.value == 0x801
        assert written.take_counts() == [(3, 6)]
        counts = duty.take_counts()
        assert [count.edges for count in counts] == [1, *[0] * 10, 1]
        assert counts[0].high > counts[11].high > counts[1].high == 0
        # Inputs scheduled for a later cycle are set in that cycle.
        seen = []
        bare.watch(lambda: seen.append((bare.cycles, ports["left_speed"].value)), ports["right_speed"])
        begin = bare.cycles + 100
        for step in range(5):
            ports["left_speed"].drive(step, begin + step)
        ports["right_speed"].drive(1, begin)
        ports["right_speed"].drive(0, begin + 5)
        bare.run(200)
        assert seen == [(begin + step, step) for step in range(5)]
        assert await link.read(0x10) == 4


def test_idle_time_is_skipped_and_counts() -> None:
    gateway = simulate(ROVER, rtl=True)
    gateway.receive(f"GS01{int(GroupFlag.TIMESTAMP):02X}00010110\r".encode(), 0.0)
    stamps = [int(gateway.receive(b"GP01\r", now).partition(b"P01")[2][2:10], 16) for now in (1.0, 3600.0)]
    assert stamps[1] - stamps[0] == pytest.approx(3599 * gateway.info.clock_hz % (1 << 32), abs=1000)


def test_a_model_of_a_gateway_has_no_ports() -> None:
    assert simulate(ROVER).ports == {}
