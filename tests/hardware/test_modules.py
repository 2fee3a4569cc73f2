"""Hardware modules: offsets instead of addresses, and what each kind can do."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import unity_link
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError, BusError, Feature, GatewayInfo, UnsupportedError
from unity_link.hardware import Counter, Fifo, Gpio, Memory, Module, Pwm, Quadrature
from unity_link.protocol.messages import ErrorCode
from unity_link.spec import SpecError, compile_text
from unity_link.spec.arguments import ArgumentSlot, Shape
from unity_link.virtual import AccessError, VirtualGateway


class Queue:
    """A queue of four words that refuses what it cannot do."""

    def __init__(self) -> None:
        self.words: list[int] = []

    def read(self, offset: int, now: float) -> int:
        if not self.words:
            raise AccessError(ErrorCode.BUS_ERROR)
        return self.words.pop(0)

    def write(self, offset: int, value: int, now: float) -> None:
        if len(self.words) == 4:
            raise AccessError(ErrorCode.BUS_ERROR)
        self.words.append(value)


@on_simulated_time
async def test_offsets_count_from_the_first_word_of_the_module() -> None:
    gateway = VirtualGateway()
    async with unity_link.connect(gateway) as link:
        module = Module(link, 0x40, size=8)
        await module.write(1, 11)
        await module.post(2, 12)
        await module.write_block(3, [13, 14])
        await module.write_many([6, 5], [16, 15])
        assert await module.write_masked(7, 0xF0, 0xFF) == 0
        assert [gateway.memory[0x40 + offset] for offset in range(8)] == [0, 11, 12, 13, 14, 15, 16, 0xF0]
        assert await module.read(1) == 11
        assert (await module.read_block(1, 3)).tolist() == [11, 12, 13]
        assert (await module.read_many([4, 2])).tolist() == [14, 12]
        async with module.subscribe([3, 1], rate_hz=1000) as samples:
            assert (await anext(samples)).values.tolist() == [13, 11]


@on_simulated_time
async def test_an_offset_outside_of_the_module_is_refused_before_anything_is_sent() -> None:
    async with unity_link.connect(VirtualGateway()) as link:
        module = Module(link, 0x40, size=8)
        before = link.statistics.requests
        with pytest.raises(ArgumentError, match="<Module at 0x40, 8 words>: offset 8 asked for, 0 to 7 expected"):
            await module.read(8)
        with pytest.raises(ArgumentError, match="offset -1 asked for, 0 to 7 expected"):
            await module.write(-1, 0)
        with pytest.raises(ArgumentError, match="3 words at offset 6 asked for, 0 to 5 expected"):
            await module.write_block(6, [1, 2, 3])
        assert link.statistics.requests == before
        with pytest.raises(ArgumentError, match="a module of 0 words"):
            Module(link, 0x40, size=0)
        await Module(link, 0x40).read(100)


@on_simulated_time
async def test_memory_is_loaded_stored_and_filled() -> None:
    async with unity_link.connect(VirtualGateway(GatewayInfo(address_bits=16))) as link:
        memory = Memory(link, 0x100, size=600)
        await memory.store(np.arange(600))
        assert (await memory.load()).tolist() == list(range(600))
        await memory.fill(7)
        assert set((await memory.load()).tolist()) == {7}
        assert len(memory) == 600
        with pytest.raises(ArgumentError, match="its size is not known; give SIZE in the spec"):
            await Memory(link, 0x100).load()


@on_simulated_time
async def test_a_queue_is_appended_to_and_taken_from_in_order() -> None:
    gateway = VirtualGateway()
    gateway.attach(Queue(), [0x20])
    async with unity_link.connect(gateway) as link:
        fifo = Fifo(link, 0x20, words=4)
        await fifo.append([1, 2, 3])
        await fifo.append(4)
        with pytest.raises(BusError):
            await fifo.append(5)
        assert (await fifo.take(4)).tolist() == [1, 2, 3, 4]
        with pytest.raises(BusError):
            await fifo.take(1)


@on_simulated_time
async def test_pins_are_read_and_set_one_by_one_and_together() -> None:
    gateway = VirtualGateway()
    async with unity_link.connect(gateway) as link:
        pins = Gpio(link, 0x20, width=8)
        await pins.set_levels(0b1010_0000)
        await pins.set(0, True)
        await pins.set(7, False)
        assert await pins.levels() == 0b0010_0001
        assert (await pins.get(0), await pins.get(1)) == (True, False)
        await pins.set_direction(3, output=True)
        assert gateway.memory[0x21] == 8
        with pytest.raises(ArgumentError, match="pin 8 asked for, 0 to 7 expected"):
            await pins.set(8, True)
        with pytest.raises(ArgumentError, match="levels 0x100 were given for 8 pins, 0 to 0xff expected"):
            await pins.set_levels(0x100)
        gateway.memory[0x20] = 0xFFFF
        assert await pins.levels() == 0xFF


@on_simulated_time
async def test_numbers_of_numpy_are_those_of_python_in_every_module() -> None:
    narrow: Any = np.uint8
    gateway = VirtualGateway(GatewayInfo(address_bits=16))
    async with unity_link.connect(gateway) as link:
        memory = Memory(link, 0x140, size=300)
        await memory.write_block(narrow(250), range(50))
        assert (await memory.read_block(narrow(250), narrow(50))).tolist() == list(range(50))
        with pytest.raises(ArgumentError, match="offset 255 asked for, 0 to 15 expected"):
            await Memory(link, 0x40, size=16).write(narrow(255), 9)
        with pytest.raises(ArgumentError, match=r"an offset is a whole number, not 1\.5"):
            await memory.read(1.5)  # type: ignore[arg-type]
        pins = Gpio(link, 0x60)
        await pins.set(narrow(9), True)
        assert gateway.memory[0x60] == 1 << 9
        assert await pins.get(narrow(9))
        axes = Quadrature(link, 0x80, channels=2)
        await axes.set(narrow(1), np.int16(-5))  # type: ignore[arg-type]
        assert await axes.position(narrow(1)) == -5
        await Pwm(link, 0x90, channels=1, width=32).set(0, np.float32(1))  # type: ignore[arg-type]
        assert gateway.memory[0x90] == 0xFFFF_FFFF


@on_simulated_time
async def test_single_pins_need_masked_writes() -> None:
    without = GatewayInfo(features=GatewayInfo().features & ~Feature.MASKED_WRITE)
    async with unity_link.connect(VirtualGateway(without)) as link:
        with pytest.raises(UnsupportedError, match="masked writes"):
            await Gpio(link, 0x20).set(0, True)


@on_simulated_time
async def test_duties_are_fractions_of_the_width() -> None:
    gateway = VirtualGateway()
    async with unity_link.connect(gateway) as link:
        motors = Pwm(link, 0x40, channels=3, width=10)
        await motors.set(2, 0.5)
        assert gateway.memory[0x42] == 512
        assert await motors.get(2) == pytest.approx(0.5, abs=1e-3)
        await motors.set_all(0, 1, 0.25)
        assert [gateway.memory[0x40 + channel] for channel in range(3)] == [0, 1023, 256]
        with pytest.raises(ArgumentError, match="a duty is a number from 0 to 1, not True"):
            await motors.set(0, True)
        for duty in (-0.1, 1.01):
            with pytest.raises(ArgumentError, match=f"a duty of {duty} was given, 0 to 1 expected"):
                await motors.set(0, duty)
        for wrong in (motors.set(3, 0), motors.set_all(0, 0, 0, 0)):
            with pytest.raises(ArgumentError, match="channel 3 asked for, 0 to 2 expected"):
                await wrong
        with pytest.raises(ArgumentError, match="a width of 33 bits was given, 1 to 32 expected"):
            Pwm(link, 0x40, width=33)
        with pytest.raises(ArgumentError, match="3 channels do not fit"):
            Pwm(link, 0x40, size=2, channels=3)


@on_simulated_time
async def test_counts_go_on_where_a_counter_goes_round() -> None:
    gateway = VirtualGateway()
    async with unity_link.connect(gateway) as link:
        events = Counter(link, 0x30, channels=2, width=8)
        gateway.memory[0x31] = 250
        assert await events.total(1) == 250
        for word, total in ((4, 260), (100, 356), (90, 346)):
            gateway.memory[0x31] = word
            assert await events.total(1) == total
            assert await events.count(1) == word
        await events.set(1, 5)
        assert await events.total(1) == 5
        assert await events.total(0) == 0


@on_simulated_time
async def test_positions_have_a_sign_and_go_on_where_a_decoder_goes_round() -> None:
    gateway = VirtualGateway()
    async with unity_link.connect(gateway) as link:
        encoder = Quadrature(link, 0x30, width=16)
        for word, total in ((0xFFFE, -2), (0x8001, -0x7FFF), (0x7FFF, -0x8001), (0x8001, -0x7FFF), (3, 3)):
            gateway.memory[0x30] = word
            if total != 3:
                assert await encoder.total() == total
        assert await encoder.position() == 3
        await encoder.set(0, -5)
        assert gateway.memory[0x30] == 0xFFFB
        assert (await encoder.total(), await encoder.position()) == (-5, -5)
        with pytest.raises(ArgumentError, match="position 32768 was given, -32768 to 32767 expected"):
            await encoder.set(0, 0x8000)


# From a spec


@on_simulated_time
async def test_named_modules_of_a_spec_are_attributes_of_the_robot() -> None:
    spec = compile_text("""
    public robot() {
      motors[2]: PWM(BASE=0x40 + 2 * i, CHANNELS=2, WIDTH=8);
      pool: MEMORY(BASE=0x10, SIZE=8);
      port: FIFO(BASE=0x20, WORDS=16);
      leds: GPIO(BASE=0x30, WIDTH=8) { @first = 0[0]: bool READWRITE(); }
      axis: part() @(0x50);
    }
    part(): @(base) { encoder: QUADRATURE(BASE=base, CHANNELS=1); events: COUNTER(BASE=base + 1); }
    """)
    gateway = VirtualGateway()
    async with unity_link.connect(gateway) as link:
        robot = unity_link.load(spec)(link)
        await robot.motors[1].set(1, 1)
        assert gateway.memory[0x43] == 255
        await robot.pool.fill(3)
        assert gateway.memory[0x17] == 3
        await robot.first.set(True)
        await robot.leds.set(1, True)
        assert await robot.leds.levels() == 3
        assert [type(part) for part in (robot.port, robot.axis.encoder, robot.axis.events)] == [
            Fifo,
            Quadrature,
            Counter,
        ]
        assert (robot.axis.encoder.base, robot.port.words) == (0x50, 16)


@on_simulated_time
async def test_a_module_of_ones_own_is_ten_lines_and_a_word_of_specs() -> None:
    class Stepper(Module, word="STEPPER", slots=[ArgumentSlot("STEPS", Shape.WHOLE, 1, 64)]):
        """A stepper motor."""

        SIZE = 2

        async def move_to(self, steps: int) -> None:
            await self.write(0, steps)

        async def position(self) -> int:
            return await self.read(1)

    spec = compile_text("public robot() { lift: STEPPER(BASE=0x40, STEPS=16); other: MEMORY(BASE=0x42, SIZE=1); }")
    gateway = VirtualGateway()
    gateway.memory[0x41] = 70
    async with unity_link.connect(gateway) as link:
        robot = unity_link.load(spec)(link)
        assert robot.lift.parameters == {"steps": 16}
        await robot.lift.move_to(5)
        assert (gateway.memory[0x40], await robot.lift.position()) == (5, 70)
    with pytest.raises(SpecError, match="MEMORY at 0x41 lies in STEPPER at 0x40 to 0x41"):
        compile_text("public robot() { lift: STEPPER(BASE=0x40); other: MEMORY(BASE=0x41, SIZE=1); }")
