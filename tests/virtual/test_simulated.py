"""The simulated robot of a spec: registers as in the generated bank, and a model that moves them."""

from __future__ import annotations

import asyncio
import contextlib
import logging
import math
import subprocess
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any
from unittest import mock

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import unity_link
from support.bridge_programs import PROGRAM, wait_for
from support.searching import examples
from support.simulated_time import on_simulated_time, run_simulated
from unity_link.bridges.recording import Recording
from unity_link.bridges.serve import serve
from unity_link.errors import ArgumentError, BusError, BusTimeoutError, UnsupportedError
from unity_link.generate.vhdl.bank import Bank
from unity_link.spec import compile_file, compile_text
from unity_link.transport import parse_url, prepare
from unity_link.virtual.build import simulate, simulated
from unity_link.virtual.bus import AccessError
from unity_link.virtual.registers import Registers
from unity_link.virtual.simulated import SimulatedRobot
from unity_link.virtual.simulating import load_model

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.data import Batch
    from unity_link.data.loading import LoadedRobot
    from unity_link.virtual.simulating import SimulatedGateway

EXAMPLES = Path(__file__).parents[2] / "examples"
ROVER = EXAMPLES / "rover.ul"
MODEL = f"{EXAMPLES / 'rover.py'}:Rover"
Rover = unity_link.load(ROVER)
AWKWARD = """
public awkward() {
  GATEWAY(ADDRESS_BITS=12, DATA_BITS=16);
  @wide = 0x00: signed 40 READWRITE();
  @counter = 0x08: unsigned 48 READ();
  @mode = 0x10[1:0]: mode READWRITE();
  @level = 0x10[9:4]: unsigned 6 WRITE();
  @flag = 0x11[0]: bool READ();
  @kick = 0x12: unsigned WRITE(MIN=2, MAX=5);
  @number = 0x13: float 16 READWRITE(MIN=-0.1, MAX=0.1);
  @class = 0x14: READWRITE();
  @step = 0x15: READWRITE();
  @queue = 0x16: READWRITE(FIFO(3));
  @seen = 0x17: READ(EFFECT=CLEAR_ON_READ);
  @alarm = 0x1A[0]: bool READWRITE(EFFECT=WRITE_1_TO_CLEAR);
  @fire = 0x1A[1]: bool WRITE(EFFECT=PULSE);
  @tick = 0x1B[0]: bool WRITE(EFFECT=PULSE);
  @gain = 0x1B[4:1]: WRITE();
  @lambda[2] = (0x18 + i): READWRITE();
  ram: MEMORY(BASE=0x100, SIZE=16);
  tube: FIFO(BASE=0x200, WORDS=2);
}
enum mode { off, slow, fast }
""".replace("  @lambda[2] = (0x18 + i): READWRITE();\n", "")


def awkward(model: type[SimulatedRobot] | None = None) -> SimulatedGateway:
    return simulated(compile_text(AWKWARD).interface(), model)


@contextlib.asynccontextmanager
async def rover(model: type[SimulatedRobot] | None = None) -> Any:
    gateway = simulate(ROVER, model or load_model(MODEL))
    async with unity_link.connect(gateway) as link:
        yield gateway, Rover(link)


def errors_of(caplog: pytest.LogCaptureFixture) -> str:
    return "\n".join(record.exc_text or "" for record in caplog.records if record.levelno == logging.ERROR)


# Registers


@pytest.mark.parametrize("source", [ROVER, EXAMPLES / "walker.ul", AWKWARD], ids=["rover", "walker", "awkward"])
def test_each_address_can_be_read_and_written_as_in_the_generated_bank(source: Path | str) -> None:
    spec = compile_text(source) if isinstance(source, str) else compile_file(source)
    interface = spec.interface()
    bank = {word.address: word for word in Bank(interface).words}
    windows = [(window.first, window.last) for window in Bank(interface).windows]
    page = Bank(interface).page
    number, described = (page.number, page.addresses) if page is not None else (-1, range(0))
    for address in range(0x240):
        registers = Registers(interface, loops_back=True)
        word = bank.get(address)
        in_window = any(first <= address <= last for first, last in windows)
        can_be_written = word.written if word is not None else in_window or address == number
        can_be_read = word.read if word is not None else in_window or address in {number, *described}
        queues = [
            cell for cell in registers.cells.values() if cell.queue is not None and cell.signal.address == address
        ]
        # A queue has the words that were written to it; the bank has no limits, so remove them here.
        for cell in registers.cells.values():
            cell._bounds = None, None
        with contextlib.nullcontext() if can_be_written else pytest.raises(AccessError):
            registers.write(address, 1)
        if all(cell.queue is None or cell.queue.to_program for cell in queues):
            with contextlib.nullcontext() if can_be_read else pytest.raises(AccessError):
                registers.read(address)


@on_simulated_time
async def test_without_a_model_registers_are_memory_of_the_width_of_each_signal() -> None:
    robot_type = unity_link.load(compile_text(AWKWARD))
    async with unity_link.connect(awkward()) as link:
        robot = robot_type(link)
        assert link.gateway.build_id == robot_type.interface.fingerprint
        await robot.wide.set(-(1 << 39))
        await robot.mode.set("fast")
        await robot.level.set(63)
        await robot.number.set(0.1)
        await robot.queue.append([7, 8])
        await robot.ram.write(5, 0xBEEF)
        await robot.tube.append([1, 2])
        assert (await robot.wide.get(), int(await robot.mode.get())) == (-(1 << 39), 2)
        assert await link.read(0x10) == 63 << 4 | 2
        assert await robot.number.get() == pytest.approx(0.1, rel=1e-3)
        assert (await robot.queue.take(2)).tolist() == [7, 8]
        assert await robot.ram.read(5) == 0xBEEF
        assert (await robot.tube.take(2)).tolist() == [1, 2]
        for refused in (robot.queue.take(1), robot.tube.take(1), robot.tube.append([1, 2, 3]), link.read(0x40)):
            with pytest.raises(BusError):
                await refused
        # A wide value changes with the write of its last word, and is read as it was at the read of its first word.
        await link.write(0x00, 0x1234)
        assert await robot.wide.get() == -(1 << 39)


@on_simulated_time
async def test_a_write_outside_of_the_limits_is_a_bus_error_that_the_log_explains(
    caplog: pytest.LogCaptureFixture,
) -> None:
    async with unity_link.connect(awkward()) as link:
        for word in (2, 5):
            await link.write(0x12, word)
        for word in (0, 6):
            with pytest.raises(BusError):
                await link.write(0x12, word)
    assert "a write of 6 to kick was refused: its limits are 2 to 5" in caplog.text


@pytest.mark.slow
@given(value=st.floats(-2, 2))
def test_values_within_the_limits_of_a_signal_are_never_refused(value: float) -> None:
    interface = compile_file(EXAMPLES / "walker.ul").interface()
    registers = Registers(interface, loops_back=True)
    signal = interface.signals["legs[2].femur.pos_sp"]
    registers.write(signal.address, signal.encode(value)[0])


def test_integers_between_fractional_limits_are_accepted() -> None:
    spec = compile_text("public lim() { @pos = 1: signed 8 READWRITE(MIN=-2.5, MAX=2.5); }")
    registers = Registers(spec.interface(), loops_back=True)
    for value in range(-2, 3):
        registers.write(1, value & 0xFF)
    for value in (-3, 3):
        with pytest.raises(AccessError):
            registers.write(1, value & 0xFF)


# Models


@on_simulated_time
async def test_a_model_moves_its_robot_on_simulated_time() -> None:
    async with rover() as (gateway, robot):
        await robot.left.duty.set(0.5)
        await asyncio.sleep(2)
        assert await robot.left.speed.get() == pytest.approx(3, abs=0.01)
        assert await robot.left.position.get() == pytest.approx(3 * 2 - 0.3, abs=0.02)
        assert await robot.battery.get() < 12
        assert gateway.robot.now == pytest.approx(2, abs=0.02)


@on_simulated_time
async def test_published_groups_run_and_each_sample_is_of_one_instant() -> None:
    async with rover() as (_, robot):
        await robot.left.duty.set(1)
        await robot.right.duty.set(1)
        async with robot.groups["motion"].subscribe() as samples:
            batches: list[Batch] = []
            while sum(len(batch) for batch in batches) < 100:
                batches.append(await samples.take())
        for batch in batches:
            assert batch[robot.left.position].tolist() == batch[robot.right.position].tolist()
            assert not batch.lost.any()


# A busy machine would leave out time.
@pytest.mark.slow
@mock.patch("unity_link.virtual.simulated.LONGEST_TURN", math.inf)
@settings(max_examples=examples(20))
@given(looks=st.lists(st.floats(0, 0.3), max_size=30))
def test_reading_does_not_change_the_motion(looks: list[float]) -> None:
    def position(instants: list[float]) -> Any:
        gateway = simulate(ROVER, load_model(MODEL))
        gateway.receive(b"W12%08X\r" % 2047, 0.0)
        for instant in sorted(instants):
            gateway.receive(b"R11\r", instant)
        return gateway.receive(b"R11\r", 0.4)

    assert position(looks) == position([])


@on_simulated_time
async def test_a_model_receives_each_write_and_fills_queues() -> None:
    async with rover() as (_, robot):
        for lamps in (1, 1, 8):
            await robot.lamps.set(lamps)
        assert (await robot.log.take(3)).tolist() == [1, 1, 8]


class Counts(SimulatedRobot):
    """Steps once for each read."""

    step_seconds = None
    kick: int
    class_: int

    def start(self) -> None:
        self.steps: list[float] = []
        self.class_ = 3

    def step(self, dt: float) -> None:
        self.steps.append(dt)
        self.step_ += 1


class Events(SimulatedRobot):
    step_seconds = None

    def start(self) -> None:
        self.alarm = True
        self.told: list[tuple[str, Any]] = []

    def written(self, path: str, value: Any) -> None:
        self.told.append((path, value))
        if path == "kick":
            self.seen = 1 << value


def test_a_model_sets_bits_that_a_program_clears_and_receives_pulses() -> None:
    robot = awkward(Events).robot
    registers = robot._registers
    for bit in (2, 3, 2):
        for cell in registers.write(0x12, bit):
            robot.tell_written(cell)
    assert (robot.seen, registers.read(0x17), registers.read(0x17), robot.seen) == (0b1100, 0b1100, 0, 0)
    robot.alarm = False
    assert registers.read(0x1A) == registers.read(0x1A) == 1
    robot.told.clear()
    for word in (2, 1, 0):
        for cell in registers.write(0x1A, word):
            robot.tell_written(cell)
    # A cleared event is not passed on to the model.
    assert robot.told == [("fire", True), ("fire", False), ("fire", False)]
    assert (robot.alarm, robot.fire, registers.read(0x1A)) == (False, False, 0)


def test_a_model_without_a_step_size_is_stepped_at_each_read() -> None:
    gateway = awkward(Counts)
    for now in (1.0, 1.5, 1.5, 4.0):
        gateway.receive(b"R014\r", now)
    assert isinstance(gateway.robot, Counts)
    assert gateway.robot.steps == [0.5, 2.5]
    assert gateway.receive(b"R014\rR015\r", 4.0) == b"R0140003\r\nR0150002\r\n"


def test_time_that_cannot_be_caught_up_is_left_out_and_logged(caplog: pytest.LogCaptureFixture) -> None:
    gateway = simulate(ROVER, load_model(MODEL))
    gateway.receive(b"R11\r", 0.0)
    gateway.receive(b"R11\r", 3600.0)
    assert gateway.robot is not None
    assert gateway.robot.now == pytest.approx(10)
    assert "is slower than time: 3.59e+03 s were left out" in caplog.text


class Slow(SimulatedRobot):
    def step(self, dt: float) -> None:
        # The step takes more processor time than it simulates.
        time.sleep(3 * dt)


@on_simulated_time
async def test_no_robot_is_too_slow_on_simulated_time(caplog: pytest.LogCaptureFixture) -> None:
    gateway = simulate(ROVER, Slow)
    for now in (0.0, 0.2):
        gateway.receive(b"R11\r", now)
    assert gateway.robot is not None
    assert gateway.robot.now == pytest.approx(0.2)
    assert not caplog.text


# Mistakes in a model


class Wrong(SimulatedRobot):
    left: Any
    lamps: int

    def step(self, dt: float) -> None:
        if self.now > 0.5:
            self.left.sped = 1

    def written(self, path: str, value: Any) -> None:
        if value == 13:
            raise ZeroDivisionError("unlucky")
        if value == 14:
            # As if the model asked a cancelled task for its result.
            raise asyncio.CancelledError


@on_simulated_time
async def test_a_bug_in_a_model_is_a_bus_error_and_a_logged_traceback(
    caplog: pytest.LogCaptureFixture,
) -> None:
    async with rover(Wrong) as (_, robot):
        with pytest.raises(BusError):
            await robot.lamps.set(13)
        assert "ZeroDivisionError: unlucky" in errors_of(caplog)
        with pytest.raises(BusError):
            await robot.lamps.set(14)
        assert "CancelledError" in errors_of(caplog)
        await robot.lamps.set(12)
        await asyncio.sleep(0.4)
        await robot.lamps.get()
        await asyncio.sleep(0.2)
        for _ in range(2):
            with pytest.raises(BusError):
                await robot.lamps.get()
    assert errors_of(caplog).count("AttributeError: left has nothing called 'sped': did you mean 'speed'?") == 1


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ("def start(self): self.left.duty = 3", r"left.duty: 3 is outside of -1.0.* the range of signed 12"),
        ("def start(self): self.log = 3", r"log is a FIFO port, .*: put\(value\) appends one"),
        (
            "def start(self): self.trigger('motion')",
            "rover has no trigger in the group 'motion': its groups with TRIGGER are bump",
        ),
        ("def start(self): self.set_fault('left.sped')", "no fault and no signal 'left.sped': did you mean 'left.spee"),
        ("def start(self): 1 / 0", "the model Model cannot be made for rover: ZeroDivisionError"),
        ("def start(self): raise CancelledError", "the model Model cannot be made for rover: CancelledError"),
        ("def __init__(self): pass", "the model Model cannot be made for rover: TypeError"),
        ("left = 3", "Model.left hides left of rover: give it another name"),
    ],
)
def test_a_mistake_in_a_model_causes_one_clear_error(body: str, words: str, tmp_path: Path) -> None:
    file = tmp_path / "wrong.py"
    file.write_text(
        "from asyncio import CancelledError\nfrom unity_link.virtual.simulated import SimulatedRobot\n"
        f"class Model(SimulatedRobot):\n    {body}\n"
    )
    with pytest.raises(ArgumentError, match=words):
        simulate(ROVER, load_model(f"{file}:Model"))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("{0}/none.py:Rover", "there is no file .*none.py"),
        ("{0}/good.py:Rower", "good.py has no class 'Rower' .its models are One, Two"),
        ("{0}/good.py:Path", "has no subclass of SimulatedRobot that is called 'Path'"),
        ("{0}/good.py", "has 2 models .its models are One, Two.: name one"),
        ("{0}/broken.py:One", "broken.py cannot be imported: ZeroDivisionError"),
        ("no_such_package:One", "there is no module 'no_such_package'"),
        ("Rover", "'Rover' names no model: a file and a class, such as my.py:Rover"),
    ],
)
def test_a_missing_model_causes_one_clear_error(text: str, words: str, tmp_path: Path) -> None:
    (tmp_path / "good.py").write_text(
        "from pathlib import Path\nfrom unity_link.virtual.simulated import SimulatedRobot\n"
        "class One(SimulatedRobot): pass\nclass Two(SimulatedRobot): pass\n"
    )
    (tmp_path / "broken.py").write_text("1 / 0\n")
    with pytest.raises(ArgumentError, match=words):
        load_model(text.format(tmp_path))


# Faults and triggers


@on_simulated_time
async def test_faults_are_switched_on_and_off() -> None:
    async with rover() as (gateway, robot):
        await robot.left.duty.set(1)
        gateway.robot.blocked = True
        assert gateway.robot.faults == {"blocked"}
        await asyncio.sleep(1)
        assert await robot.left.position.get() == 0
        gateway.robot.set_fault("blocked", on=False)
        await asyncio.sleep(1)
        assert await robot.left.position.get() > 3
        for how, error in (("timeout", BusTimeoutError), ("error", BusError)):
            gateway.robot.set_fault("left.speed", how)
            with pytest.raises(error):
                await robot.left.speed.get()
        gateway.robot.set_fault("left.position", "frozen")
        before = await robot.left.position.get()
        await asyncio.sleep(1)
        assert await robot.left.position.get() == before
        for path in ("left.speed", "left.position"):
            gateway.robot.set_fault(path, on=False)
        assert await robot.left.position.get() > before + 5
        await robot.left.speed.get()


TRIGGERED = """
public triggered() {
  @a = 0x10: READ(PUBLISH(first));
  @b = 0x11: READ(PUBLISH(second));
}
group first(4, TRIGGER, TIMESTAMPS);
group second(9, TRIGGER, TIMESTAMPS);
"""


class Ramps(SimulatedRobot):
    a: int
    b: int

    def step(self, dt: float) -> None:
        self.a = self.b = round(1000 * self.now)
        if self.a == 250:
            self.trigger("second")


@on_simulated_time
async def test_each_group_has_its_own_trigger_for_program_and_model() -> None:
    triggered_type = unity_link.load(compile_text(TRIGGERED))
    gateway = simulated(triggered_type.interface, Ramps)
    async with unity_link.connect(gateway) as link:
        robot = triggered_type(link)
        async with robot.groups["first"].subscribe() as first, robot.groups["second"].subscribe() as second:
            await asyncio.sleep(0.1)
            gateway.fire("first")
            await asyncio.sleep(0.05)
            gateway.fire(4)
            await asyncio.sleep(0.2)
            values = (await first.take())[robot.a].tolist()
            assert [round(value, -1) for value in values] == [100, 150]
            # The sample has the values of the instant at which the model fired.
            assert (await second.take())[robot.b].tolist() == [250]
            gateway.fire_at("second", 50)
            await asyncio.sleep(0.2)
            batch = await second.take()
            assert 9 <= len(batch) <= 11
            assert not batch.lost.any()
            assert first.received == 2


@on_simulated_time
async def test_a_subscription_with_a_trigger_gets_the_group_of_its_number() -> None:
    triggered_type = unity_link.load(compile_text(TRIGGERED.replace("first(4", "first(0")))
    async with unity_link.connect(simulated(triggered_type.interface)) as link:
        async with link.subscribe([0x10], rate_hz=10), triggered_type(link).groups["second"].subscribe():
            with pytest.raises(
                UnsupportedError, match="group 0 of the gateway, whose trigger was asked for, is in use"
            ):
                async with triggered_type(link).groups["first"].subscribe():
                    pass
        async with triggered_type(link).groups["first"].subscribe():
            pass
        with pytest.raises(UnsupportedError, match="group 16 was asked for, and the gateway has those from 0 to 15"):
            async with link.subscribe([0x10], trigger=True, group=16):
                pass


# By URL and by command


async def in_sim(url: str) -> tuple[Any, ...]:
    async with unity_link.connect(url) as link:
        robot = Rover(link)
        await robot.left.duty.set(1)
        await asyncio.sleep(1)
        battery = await robot.battery.get()
        return battery, await robot.left.position.get()


def test_a_url_names_spec_model_and_faults() -> None:
    assert run_simulated(in_sim(f"sim:{ROVER}")) == (0, 0)
    battery, position = run_simulated(in_sim(f"sim:{ROVER}?model={MODEL}&flip=0.0005"))
    assert battery == pytest.approx(12, abs=0.1)
    assert position > 4
    assert run_simulated(in_sim(f"sim:{ROVER}?model={MODEL}&fault=blocked"))[1] == 0
    with pytest.raises(BusTimeoutError):
        run_simulated(in_sim(f"sim:{ROVER}?model={MODEL}&fault=blocked,battery:timeout"))


@on_simulated_time
async def test_a_url_fires_triggers() -> None:
    async with (
        unity_link.connect(f"sim:{ROVER}?trigger=bump:20") as link,
        Rover(link).groups["bump"].subscribe() as samples,
    ):
        await asyncio.sleep(1.01)
        assert len(await samples.take()) in (20, 21)
    async with (
        unity_link.connect("sim:?trigger=7:20") as link,
        link.subscribe([0x10], trigger=True, group=7) as words,
    ):
        await asyncio.sleep(1.01)
        assert len(await words.take()) in (20, 21)


@pytest.mark.parametrize(
    ("url", "words"),
    [
        ("sim:nothing.ul", "there is no spec nothing.ul in "),
        ("sim:rover", "no robot 'rover' is known: did you mean rover.ul"),
        ("sim:delta", "no robot 'delta' is known: one of scara, tosnet, walker was expected, or the path of a spec"),
        ("sim:scara?model=my.py:A", "model is for the robot of a spec, not for scara"),
        ("sim:?fault=a", "fault is for the robot of a spec, not for plain memory"),
        ("sim:rover.ul?interface=x", "has no public interface 'x': rover was expected"),
        ("sim:rover.ul?fault=left.speed:broken", "one of error, timeout, frozen was expected after the colon"),
        ("sim:rover.ul?trigger=bump", "a group and a rate in Hz were expected, as in state:10"),
        ("sim:rover.ul?trigger=motion:3", "no trigger in the group 'motion'"),
        ("sim:rover.ul?trigger=bumb:3", "rover has no group 'bumb': did you mean 'bump'?"),
        ("sim:rover.ul?fault=x", "rover has no fault and no signal 'x': the path of a signal was expected, such as "),
        ("sim:rover.ul?trigger=bump:0", "a trigger of 0 Hz was asked for"),
        ("sim:?trigger=state:3", "there is no group 'state' without a spec: its number was expected"),
        ("sim:?trigger=300:3", "there is no group 300: this gateway has those from 0 to 255"),
        ("sim:?trigger=3:fast", "a group and a rate in Hz were expected"),
    ],
)
def test_an_impossible_url_of_a_robot_causes_one_clear_error(
    url: str, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(EXAMPLES)

    async def connect() -> None:
        async with unity_link.connect(url):
            pass

    with pytest.raises(ArgumentError, match=words):
        run_simulated(connect())


def test_the_spec_of_a_url_is_read_before_the_time_limit_of_a_connection() -> None:
    with pytest.raises(ArgumentError, match=r"there is no spec missing\.ul in "):
        run_simulated(prepare(parse_url("sim:missing.ul")))


@contextlib.contextmanager
def simulating(*arguments: str) -> Iterator[tuple[subprocess.Popen[str], str]]:
    process = subprocess.Popen(
        [PROGRAM, "simulate", *arguments],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    with process:
        try:
            assert process.stdout is not None
            yield process, process.stdout.readline().strip()
        finally:
            process.kill()


def test_simulate_serves_a_spec_and_reads_faults_and_triggers_as_lines() -> None:
    async def use(url: str, tell: Any) -> LoadedRobot:
        async with unity_link.connect(url) as link:
            robot = Rover(link)
            async with robot.groups["bump"].subscribe() as samples:
                tell("trigger bump", "the trigger of bump was fired")
                await samples.take()
            tell("fault left.speed:timeout", "left.speed is broken")
            with pytest.raises(BusTimeoutError):
                await robot.left.speed.get()
            tell("mend left.speed", "left.speed is mended")
            await robot.left.speed.get()
            tell("fault bloked", "error: rover has no fault and no signal 'bloked': did you mean 'blocked'?")
            tell("help", "error: help: trigger GROUP, fault NAME[:HOW] or mend NAME was expected")
            return robot

    with simulating(str(ROVER), "--model", MODEL) as (process, url):

        def tell(line: str, answer: str) -> None:
            assert process.stdin is not None
            process.stdin.write(line + "\n")
            process.stdin.flush()
            wait_for(process, answer)

        assert url.startswith("tcp://127.0.0.1:")
        asyncio.run(use(url, tell))


def test_record_runs_on_a_users_robot(tmp_path: Path) -> None:
    url, output = f"sim:{ROVER}?model={MODEL}&trigger=bump:20", tmp_path / "run.mcap"
    command = [PROGRAM, "record", url, str(ROVER), "-o", str(output), "--duration", "1"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    assert {samples.group.name for samples, _ in Recording(output).samples()} == {"motion", "slow", "bump"}


def test_a_bug_in_a_model_never_blocks_a_command(tmp_path: Path) -> None:
    model = tmp_path / "bad.py"
    model.write_text(
        "from unity_link.virtual.simulated import SimulatedRobot\n"
        "class Bad(SimulatedRobot):\n"
        "    step_seconds = 1e-6\n"
        "    def step(self, dt):\n"
        "        self.left.speed = 1 / 0\n"
    )
    command = [PROGRAM, "read", f"sim:{ROVER}?model={model}:Bad", "0x10"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 1
    assert f'File "{model}", line 5, in step' in done.stderr
    last = done.stderr.splitlines()[-1]
    assert last.startswith("error: read at 0x10: the bus refused the access, for the model Bad failed 0.000 s after")
    assert last.endswith("ZeroDivisionError: division by zero")


def test_a_trigger_reaches_its_group_through_a_shared_link(tmp_path: Path) -> None:
    async def use() -> None:
        path = f"{tmp_path}/shared"
        async with (
            serve(f"sim:{ROVER}?trigger=bump:50", unix=path),
            unity_link.connect(f"unix:{path}") as first,
            unity_link.connect(f"unix:{path}") as second,
            first.subscribe([0x10], rate_hz=10),
            Rover(second).groups["bump"].subscribe() as samples,
        ):
            for _ in range(2):
                await samples.take()

    asyncio.run(asyncio.wait_for(use(), 60))
