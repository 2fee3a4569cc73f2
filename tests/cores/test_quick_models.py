"""Quick models of the installed cores: registers follow the values that a plant sets, as in the entities."""

from __future__ import annotations

import asyncio
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import unity_link
from support.simulated_time import on_simulated_time
from unity_link.cores.batches import batch_of
from unity_link.cores.lease import TIME_BITS
from unity_link.spec import compile_text
from unity_link.virtual.build import simulated
from unity_link.virtual.bus import AccessError
from unity_link.virtual.simulated import SimulatedRobot

SPEC = compile_text("""
group edges(TRIGGER);
public robot() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE() @(0xE0);
  wheel: ENCODER(COUNTS=1000, SCALE=0.001, UNIT="turn") @(0x20);
  button: GPIO(ON_EDGE=edges) @(0x40);
  lamp: GPIO(LEASE=drive) @(0x50);
  @seen = 0x60: READ(PUBLISH(edges));
}
""")
HZ = 50_000_000


class Plant(SimulatedRobot):
    """Turns a wheel and presses a button as a test requests."""

    speed = 0.0
    pressed = 0

    def step(self, dt: float) -> None:
        self.wheel.position += self.speed * dt
        self.button.pin = self.pressed


class Unmoved(SimulatedRobot):
    """A robot without motion."""

    def step(self, dt: float) -> None:
        pass


@on_simulated_time
async def test_velocity_and_index_follow_the_position_that_a_plant_sets() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    plant: Any = gateway.robot
    async with unity_link.connect(gateway) as link:
        wheel: Any = unity_link.load(SPEC)(link).wheel
        plant.speed = 2.5
        for _ in range(50):
            # Reads between two steps of the plant have no effect.
            await asyncio.sleep(0.0203)
            assert await wheel.velocity.get() == pytest.approx(2.5, rel=0.01)
        assert await wheel.index_count.get() == 2
        assert await wheel.index_position.get() == pytest.approx(2)
        plant.speed = -1.0
        await asyncio.sleep(0.5)
        assert await wheel.velocity.get() == pytest.approx(-1, rel=0.01)
        plant.speed = 0.0
        await asyncio.sleep(0.1)
        assert -0.011 < await wheel.velocity.get() < -0.009
        await asyncio.sleep(0.5)
        assert await wheel.velocity.get() == 0
        assert await wheel.errors.get() == 0


@on_simulated_time
async def test_edges_of_a_pin_are_counted_and_timed_and_fire_their_trigger() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    plant: Any = gateway.robot
    async with unity_link.connect(gateway) as link:
        robot: Any = unity_link.load(SPEC)(link)
        async with robot.groups["edges"].subscribe() as samples:
            await asyncio.sleep(0.0105)
            plant.pressed = 1
            await asyncio.sleep(0.0105)
            plant.pressed = 0
            await asyncio.sleep(0.0105)
            assert len(await samples.take()) == 2
        assert (await robot.button.level.get(), await robot.button.edges.get()) == (False, 2)
        assert gateway.ticks_at(asyncio.get_running_loop().time()) - await robot.button.last.get() < 0.02 * HZ


@on_simulated_time
async def test_a_pin_is_driven_while_its_lease_is_armed() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    async with unity_link.connect(gateway) as link:
        robot: Any = unity_link.load(SPEC)(link)
        with pytest.raises(unity_link.NotArmedError):
            await robot.lamp.drive.set(True)
        assert await robot.lamp.level.get() is False
        async with robot.armed():
            await robot.lamp.output.set(True)
            await robot.lamp.drive.set(True)
            assert await robot.lamp.level.get() is True
        assert await robot.lamp.level.get() is False
        assert await robot.lamp.edges.get() == 2


BARE = compile_text("""
public robot() {
  wheel: ENCODER(COUNTS=1000, SCALE=0.001, UNIT="turn") @(0x20, z=none);
  lamp: GPIO() @(0x30, pin=none);
  drive: LEASE() @(0xC0, estop=none);
  button: GPIO() @(0x40);
}
""")


@on_simulated_time
async def test_unused_pins_are_inputs_of_0_and_cannot_be_set_by_a_plant() -> None:
    gateway = simulated(BARE.interface(), Unmoved)
    plant: Any = gateway.robot
    async with unity_link.connect(gateway) as link:
        robot: Any = unity_link.load(BARE)(link)
        for turns in (2.5, -3.0, 0.0):
            plant.wheel.position = turns
            await asyncio.sleep(0.01)
            assert await robot.wheel.position.get() == turns
            assert await robot.wheel.index_count.get() == await robot.wheel.index_position.get() == 0
        await robot.lamp.output.set(True)
        await robot.lamp.drive.set(True)
        assert await robot.lamp.level.get() is False
        assert (plant.drive.estop, await robot.drive.estop_open.get()) == (1, False)
        for name, part in (("wheel.z", plant.wheel), ("lamp.pin", plant.lamp), ("drive.estop", plant.drive)):
            with pytest.raises(unity_link.ArgumentError, match=f"{name} is none in the spec"):
                setattr(part, name.partition(".")[2], 1)


@on_simulated_time
async def test_the_position_register_of_a_wheel_wraps_around() -> None:
    gateway = simulated(SPEC.interface(), Plant)
    plant: Any = gateway.robot
    plant.wheel.position = 2_147_480.0
    plant.speed = 4000.0
    async with unity_link.connect(gateway) as link:
        robot: Any = unity_link.load(SPEC)(link)
        await asyncio.sleep(2)
        assert plant.wheel.position == pytest.approx(2_155_480, abs=10)
        # The registers themselves have wrapped by 2 ** 32 counts.
        position, _, index = await link.read_block(0x20, 3)
        assert int(position) == round(plant.wheel.position * 1000) % (1 << 32)
        assert int(index) == int(plant.wheel.position + 1e-6) * 1000 % (1 << 32)
        assert 1 << 31 < int(index) <= int(position)
        assert await robot.wheel.velocity.get() == pytest.approx(4000, rel=0.01)


@on_simulated_time
async def test_the_time_of_an_edge_wraps_with_32_bits_of_the_clock() -> None:
    class Slow(Unmoved):
        step_seconds = 10

    gateway = simulated(BARE.interface(), Slow)
    plant: Any = gateway.robot
    async with unity_link.connect(gateway) as link:
        robot: Any = unity_link.load(BARE)(link)
        await asyncio.sleep(1.5 * (1 << 32) / HZ)
        await robot.button.level.get()
        plant.button.pin = 1
        ticks = gateway.ticks_at(asyncio.get_running_loop().time())
        assert ticks > 1 << 32
        assert await robot.button.last.get() == pytest.approx(ticks % (1 << 32), abs=HZ // 100)


GUARDED = compile_text("""
public robot() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE() @(0xE0);
  plan: SCHEDULE(DEPTH=64) @(0x100);
  axis: STEPGEN(LEASE=drive, SCHEDULE=plan) @(0x20);
  lamp: GPIO(LEASE=drive) @(0x50);
  @free = 0x60: unsigned 64 READWRITE(TIMED(plan));
}
""").interface()
STEPS = st.one_of(
    st.tuples(st.sampled_from(["drive.arm", "drive.kick"]), st.integers(0, 60)),
    st.tuples(st.just("plan.entry"), st.integers(0, 120)),
    st.tuples(st.sampled_from(["drive.disarm", "plan.cancel", "lamp.drive", "lamp.output"]), st.integers(0, 1)),
    st.tuples(st.sampled_from(["axis.position_cmd", "axis.mode", "axis.maxvel", "free"]), st.integers(0, 2)),
)


@given(st.lists(st.tuples(st.integers(0, 30), st.lists(STEPS, max_size=4)), max_size=30))
def test_words_of_one_instant_have_the_same_effect_if_time_is_read_between(
    story: list[tuple[int, list[tuple[str, int]]]],
) -> None:
    def tell(*, looks: bool) -> list[Any]:
        robot = simulated(GUARDED, Unmoved).robot
        now, told = 1000, list[Any]()
        for passed, steps in story:
            now += passed
            instant = (now + 0.5) / HZ
            for path, value in steps:
                signal, number = GUARDED.signals[path], value
                if path in {"drive.arm", "drive.kick"}:
                    number = 1 << TIME_BITS | now + value
                words = (
                    batch_of(now + value, {0: value})
                    if path == "plan.entry"
                    else [number >> 32 * part & 0xFFFFFFFF for part in range(signal.words)]
                )
                for index, word in enumerate(words):
                    try:
                        robot.write(signal.address + (path != "plan.entry") * index, word, instant)
                    except AccessError as error:
                        told.append((now, path, error.code))
                    if looks:
                        robot.pass_time(instant)
        robot.pass_time((now + 0.5) / HZ)
        return [*told, {path: cell.raw for path, cell in robot.cells.items()}]

    assert tell(looks=False) == tell(looks=True)
