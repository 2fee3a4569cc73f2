"""Cores and leases on the compiled gateware: the levels at its pins, exact to the clock cycle."""

from __future__ import annotations

import asyncio
import contextlib
import math
import random
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.simulated_time import on_simulated_time
from unity_link import BusError, NotArmedError
from unity_link.spec import compile_file
from unity_link.virtual.build import simulate
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link.virtual.rtl.ports import Port

TIMEOUT = 0.02
SPEC = """\
group state(RATE=200, TIMESTAMPS);
public rover() {
  drive: LEASE(TIMEOUT=0.05) @(0xC0, enable="gp8", estop="sw0");
  @lamp = 0x10[0]: bool READWRITE(PIN="led0", SAFE(false, drive));
  @speed = 0x11: signed 16 READWRITE(SAFE(-5, drive));
  @free = 0x12: unsigned 8 READWRITE(PIN="gn", RESET=3);
  @button = 0x13[0]: bool READ(PIN="btn0", PUBLISH(state));
  left: PWM(LIMIT=12, UNIT="V", FREQUENCY=5000, LEASE=drive) @(0x20, pwm="gp4", dir="gp5");
  wheel: ENCODER(FILTER=3, GROUP=state) @(0x28, a="gp6", b="gp7", z=none);
  line: GPIO(LEASE=drive) @(0x30, pin="gp9");
}

"""


class Rover:
    """The compiled rover, a program's view of it, and its pins."""

    def __init__(self, path: Path) -> None:
        spec = path / "rover.ul"
        spec.write_text(SPEC)
        self.spec = compile_file(spec)
        # As quick as a board: an answer takes cycles of the gateware, but no time of the event loop.
        self.gateway = simulate(spec, rtl=True, clock_hz=2_400_000)
        self.bare: Any = self.gateway._gateway
        self.fell: list[int] = []

    @property
    def ports(self) -> dict[str, Port]:
        return dict(self.gateway.ports)

    def now(self) -> int:
        """Return the gateway's clock at this instant, in ticks; the cycles until then are simulated later."""
        return int(self.bare.ticks_at(asyncio.get_running_loop().time()))

    def see(self, *names: str) -> tuple[int, ...]:
        return tuple(self.ports[name].value for name in names)


@pytest.fixture
def rover(tmp_path: Path) -> Rover:
    return Rover(tmp_path)


@pytest.mark.slow
@pytest.mark.rtl
@on_simulated_time
async def test_outputs_are_safe_in_the_cycle_after_the_end_of_the_last_kick(rover: Rover) -> None:
    ports = rover.ports
    async with unity_link.connect(rover.gateway) as link:
        robot = unity_link.load(rover.spec)(link)
        assert rover.see("lamp", "free", "drive_enable", "speed") == (0, 3, 0, 0xFFFB)
        with pytest.raises(NotArmedError, match="nobody has armed it since the reset"):
            await robot.lamp.set(True)
        async with robot.drive.armed(timeout=TIMEOUT) as lease:
            assert rover.see("lamp", "drive_enable", "speed") == (0, 1, 0xFFFB)
            await robot.lamp.set(True)
            await robot.speed.set(700)
            assert rover.see("lamp", "drive_enable", "speed") == (1, 1, 700)
            for _ in range(10):
                await asyncio.sleep(TIMEOUT / 2)
                await lease.kick()
            assert rover.see("lamp", "drive_enable", "speed") == (1, 1, 700)
            ports["lamp"].take_counts()
            ports["drive_enable"].take_counts()
            end = lease._end
            await asyncio.sleep(3 * TIMEOUT)
            with pytest.raises(NotArmedError, match="no kick came before its end"):
                await lease.kick()
            assert rover.see("lamp", "drive_enable", "speed", "free") == (0, 0, 0xFFFB, 3)
            assert await robot.drive.fault_time.get() == end - 1
            with pytest.raises(BusError):
                await link.write(0x10, 1)
        assert await robot.drive.reason.get() == "silence"
        assert await robot.lamp.get() is False


@pytest.mark.rtl
@on_simulated_time
async def test_an_open_e_stop_stops_at_once_and_prevents_arming(rover: Rover) -> None:
    async with unity_link.connect(rover.gateway) as link:
        robot = unity_link.load(rover.spec)(link)
        async with robot.drive.armed(timeout=TIMEOUT) as lease:
            await robot.lamp.set(True)
            begun = rover.bare.cycles
            rover.ports["drive_estop"].drive(0)
            rover.bare.run(8)
            assert rover.bare.cycles - begun <= 8
            assert rover.see("lamp", "drive_enable") == (0, 0)
            await lease.kick()
            await asyncio.sleep(TIMEOUT / 4)
            with pytest.raises(NotArmedError, match="its e-stop was opened"):
                await lease.kick()
        with pytest.raises(NotArmedError, match="its e-stop is open"):
            async with robot.drive.armed(timeout=TIMEOUT):
                pass
        rover.ports["drive_estop"].drive(1)
        await asyncio.sleep(0.01)
        async with robot.drive.armed(timeout=TIMEOUT):
            assert rover.see("lamp", "drive_enable") == (0, 1)
            # The lamp does not return to the value of the earlier lease.
            await robot.lamp.set(True)
            assert rover.see("lamp") == (1,)


@pytest.mark.rtl
@on_simulated_time
async def test_a_loop_over_samples_keeps_the_lease_armed(rover: Rover) -> None:
    async with unity_link.connect(rover.gateway) as link:
        robot = unity_link.load(rover.spec)(link)
        seen = 0
        async with robot.drive.armed(timeout=TIMEOUT) as lease:
            async for sample in lease.each(robot.groups["state"]):
                await robot.lamp.set(True)
                rover.ports["button"].drive(1)
                seen += bool(sample[robot.button])
                if seen == 10:
                    break
            assert rover.see("lamp", "drive_enable") == (1, 1)
        assert rover.see("lamp", "drive_enable") == (0, 0)
        assert await robot.drive.reason.get() == "disarmed"


@pytest.mark.rtl
@on_simulated_time
async def test_a_pwm_has_the_duty_and_sign_of_its_value_and_stops_within_a_pulse(rover: Rover) -> None:
    ports = rover.ports
    clock_hz = rover.gateway.info.clock_hz
    async with unity_link.connect(rover.gateway) as link:
        robot = unity_link.load(rover.spec)(link)
        async with robot.drive.armed(timeout=0.05) as lease:
            for volts in (3, -9, 12, 0):
                await robot.left.value.set(volts)
                # A value takes effect at the next period.
                await asyncio.sleep(0.001)
                ports["left_pwm"].take_counts()
                await lease.kick()
                begun = rover.bare.cycles
                await asyncio.sleep(0.02)
                await link.fence()
                (count,) = ports["left_pwm"].take_counts()
                duty = count.high / (rover.bare.cycles - begun)
                assert duty == pytest.approx(abs(volts) / 12, abs=0.02)
                assert rover.see("left_dir") == (volts < 0,)
                await lease.kick()
            await robot.left.value.set(12)
            await asyncio.sleep(0.001)
            # The gateware simulates cycles when a request or a test reads its state.
            assert await robot.left.value.get() == 12
            assert rover.see("left_pwm") == (1,)
            await robot.drive.stop()
            ports["left_pwm"].take_counts()
            rover.bare.run(clock_hz // 1000)
            assert ports["left_pwm"].take_counts() == [(0, 0)]


@pytest.mark.slow
@pytest.mark.rtl
@on_simulated_time
async def test_an_encoder_measures_position_and_velocity_from_its_pins(rover: Rover) -> None:
    async with unity_link.connect(rover.gateway) as link:
        robot = unity_link.load(rover.spec)(link)
        levels = ((0, 0), (1, 0), (1, 1), (0, 1))
        spacing, turns = 100, 500
        begin = rover.bare.cycles + 1000
        for edge in range(1, turns + 1):
            for pin, level in zip(("wheel_a", "wheel_b"), levels[edge % 4], strict=True):
                rover.ports[pin].drive(level, begin + edge * spacing)
        rover.bare.run(1000 + turns * spacing // 2)
        count = math.tau / 4096
        assert await robot.wheel.velocity.get() == pytest.approx(
            count * rover.gateway.info.clock_hz / spacing, rel=0.02
        )
        rover.bare.run(1000 + turns * spacing // 2)
        assert await robot.wheel.position.get() == pytest.approx(turns * count)
        assert await robot.wheel.errors.get() == 0
        await asyncio.sleep(2)
        assert await robot.wheel.velocity.get() == 0


@pytest.mark.rtl
@on_simulated_time
async def test_a_gpio_counts_edges_and_is_driven_only_under_a_lease(rover: Rover) -> None:
    async with unity_link.connect(rover.gateway) as link:
        robot = unity_link.load(rover.spec)(link)
        assert await robot.line.level.get() is False
        rover.ports["line_pin_in"].drive(1)
        await asyncio.sleep(0.001)
        assert await robot.line.level.get() is True
        assert await robot.line.edges.get() == 1
        rover.ports["line_pin_in"].drive(0)
        async with robot.drive.armed(timeout=0.05):
            await robot.line.output.set(True)
            await robot.line.drive.set(True)
            assert rover.see("line_pin_out", "line_pin_oe") == (1, 1)
            # As at a pad, the input of the pin is its output.
            await asyncio.sleep(0.001)
            assert await robot.line.level.get() is True
        assert rover.see("line_pin_oe") == (0,)
        await asyncio.sleep(0.001)
        assert await robot.line.level.get() is False


class Plant(SimulatedRobot):
    """A wheel that turns in proportion to its motor's voltage, and a button with the level of the lamp."""

    def start(self) -> None:
        """Stop the wheel."""
        self.angle = 0.0
        self.volts: list[float] = []
        self.armed_for = self.lit_for = 0
        self.seen: list[tuple[str, Any]] = []

    def step(self, dt: float) -> None:
        """Turn the wheel by one step, and record the outputs."""
        self.volts.append(self.left.value)
        self.angle += 2.0 * self.left.value * dt
        self.wheel.position = self.angle
        self.armed_for += self.drive.armed
        self.lit_for += self.line.level
        self.button = self.lamp

    def written(self, path: str, value: Any) -> None:
        """Record the values that programs write to signals at pins."""
        if path in {"lamp", "free"}:
            self.seen.append((path, value))


@pytest.mark.slow
@pytest.mark.parametrize("rtl", [False, pytest.param(True, marks=pytest.mark.rtl)])
@on_simulated_time
async def test_a_plant_is_the_same_on_the_quick_models_and_at_the_pins(rtl: bool, tmp_path: Path) -> None:
    spec = tmp_path / "rover.ul"
    spec.write_text(SPEC)
    gateway = simulate(spec, Plant, rtl=rtl, clock_hz=2_400_000)
    plant: Any = gateway.robot
    async with unity_link.connect(gateway) as link:
        robot = unity_link.load(compile_file(spec))(link)
        await asyncio.sleep(0.02)
        async with robot.drive.armed(timeout=0.05) as lease:
            await robot.line.output.set(True)
            await robot.line.drive.set(True)
            assert (plant.lamp, plant.free, await robot.button.get()) == (False, 3, False)
            await robot.lamp.set(True)
            await robot.free.set(9)
            # Reading the values from outside does not call `written`.
            assert {plant.lamp, plant.free} <= {False, True, 3, 9}
            await asyncio.sleep(0.01)
            await lease.kick()
            assert (plant.lamp, plant.free, await robot.button.get()) == (True, 9, True)
            assert plant.seen == [("lamp", True), ("free", 9)]
            for volts in (6, -12, 0.03):
                await robot.left.value.set(volts)
                for _ in range(8):
                    await asyncio.sleep(0.01)
                    await lease.kick()
                assert plant.left.value == pytest.approx(volts, abs=0.03)
                assert plant.volts[-40:] == pytest.approx([volts] * 40, abs=0.03)
                if abs(volts) > 1:
                    assert await robot.wheel.velocity.get() == pytest.approx(2 * volts, rel=0.05)
                assert await robot.wheel.position.get() == pytest.approx(plant.angle, abs=0.08)
            assert plant.armed_for == pytest.approx(250, abs=5)
            assert plant.lit_for == pytest.approx(250, abs=5)
            await robot.left.value.set(6)
            await asyncio.sleep(0.2)
        # The writes went on after the last kick.
        assert (plant.left.value, plant.drive.armed, plant.line.level) == (0, False, False)
        assert (plant.lamp, plant.free) == (False, 9)
        assert await robot.wheel.errors.get() == 0
        assert await robot.wheel.position.get() == pytest.approx(plant.angle, abs=0.01)


@pytest.mark.slow
@pytest.mark.rtl
@on_simulated_time
async def test_requests_without_a_pause_do_not_let_the_clock_run_ahead(rover: Rover) -> None:
    async with unity_link.connect(rover.gateway) as link:
        robot = unity_link.load(rover.spec)(link)
        async with robot.drive.armed(timeout=0.02) as lease:
            begun = asyncio.get_running_loop().time()
            for _ in range(2000):
                await robot.lamp.set(True)
                await lease.kick()
                assert rover.bare.cycles - rover.now() < 0.006 * rover.gateway.info.clock_hz
            # So the requests take the time that the gateware needs for them.
            assert asyncio.get_running_loop().time() - begun > 0.03


WAYS = ("dies", "stands still", "goes on writing", "kicks late", "is disarmed", "loses the e-stop", "resets")
KILLS = 200


async def live_and_end(rover: Rover, way: str, chance: random.Random) -> tuple[int, int]:
    """Run a program until it ends in one of `WAYS`; return the end of its last kick, and the latest possible end."""
    timeout = chance.uniform(0.01, 0.03)
    async with unity_link.connect(rover.gateway) as link:
        robot = unity_link.load(rover.spec)(link)
        lease = robot.drive.armed(timeout=timeout)
        await lease.__aenter__()
        made = rover.now()
        # In simulated time answers take no time but cycles; the gateway's cycles are ahead of the time by as many.
        ahead = max(0, rover.bare.cycles - made)
        assert rover.see("lamp", "drive_enable") == (0, 1)
        await robot.lamp.set(True)
        for _ in range(chance.randrange(4)):
            await asyncio.sleep(chance.uniform(0, 0.5) * timeout)
            made = rover.now()
            await lease.kick()
            await link.fence()
            assert rover.see("lamp", "drive_enable") == (1, 1)
        end = lease._end
        stale = robot.drive.kick.signal.encode(lease._word())
        match way:
            case "goes on writing":
                with contextlib.suppress(BusError):
                    for _ in range(100):
                        await robot.lamp.set(True)
                        await asyncio.sleep(timeout / 20)
            case "kicks late":
                # The last kick again, as on a line that duplicates frames, and a kick with another token.
                for _ in range(30):
                    await link.post_many(robot.drive.kick.signal.addresses, stale)
                    await link.post_many(robot.drive.kick.signal.addresses, [stale[0] + 1000, stale[1] ^ 1 << 20])
                    await asyncio.sleep(timeout / 20)
                await link.fence()
            case "is disarmed":
                await robot.drive.stop()
            case "loses the e-stop":
                rover.ports["drive_estop"].drive(0)
                rover.bare.run(8)
                rover.ports["drive_estop"].drive(1)
            case "resets":
                rover.gateway.reset()
            case "stands still":
                await asyncio.sleep(2 * timeout)
    return end, made + int(timeout * rover.gateway.info.clock_hz) + 2 + ahead


async def outlive(rover: Rover, kills: int) -> None:
    for kill in range(kills):
        chance = random.Random(kill)
        way = WAYS[kill % len(WAYS)]
        end, latest = await live_and_end(rover, way, chance)
        async with unity_link.connect(rover.gateway) as link:
            robot = unity_link.load(rover.spec)(link)
            if way in {"is disarmed", "loses the e-stop", "resets"}:
                assert rover.see("lamp", "drive_enable") == (0, 0), (kill, way)
            if way == "dies":
                await asyncio.sleep(0.04)
            assert rover.see("lamp", "drive_enable", "speed") == (0, 0, 0xFFFB), (kill, way)
            reason = await robot.drive.reason.get()
            if reason == "silence":
                fell = int(await robot.drive.fault_time.get()) + 1
                assert fell == end, (kill, way)
                assert fell <= latest, (kill, way)
            else:
                assert reason == {"is disarmed": "disarmed", "loses the e-stop": "estop", "resets": "none_yet"}[way]
            # Outputs do not return to their earlier values under the next lease.
            async with robot.drive.armed(timeout=0.02):
                assert rover.see("lamp", "drive_enable", "speed") == (0, 1, 0xFFFB), (kill, way)


@pytest.mark.slow
@pytest.mark.rtl
@on_simulated_time
async def test_outputs_are_safe_however_a_program_ends(rover: Rover) -> None:
    await outlive(rover, KILLS)


@pytest.mark.campaign
@pytest.mark.rtl
@on_simulated_time
async def test_outputs_are_safe_after_ten_thousand_programs(rover: Rover) -> None:
    await outlive(rover, 10_000)
