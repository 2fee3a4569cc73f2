"""Hardware modules: offsets instead of addresses, and the operations of each kind."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import unity_link
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError, BusError, GatewayInfo
from unity_link.data.robot import MODULE_TYPES
from unity_link.modules import Fifo, Memory, Module
from unity_link.network import TosnetNetwork, TosnetNode
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.spec import compile_text
from unity_link.spec.modules import MODULES
from unity_link.virtual import AccessError, VirtualGateway


class Queue:
    """A queue of four words; it refuses reads while it is empty, and writes while it is full."""

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


# From a spec


@on_simulated_time
async def test_named_modules_of_a_spec_are_attributes_of_the_robot() -> None:
    spec = compile_text("""
    public robot() {
      tables[2]: MEMORY(BASE=0x40 + 4 * i, SIZE=4);
      port: FIFO(BASE=0x20, WORDS=16);
      leds: MEMORY(BASE=0x30) { @first = 0[0]: bool READWRITE(); }
      axis: part() @(0x80);
    }
    part(): @(base) { net: TOSNET(BASE=base, NODES=2); node: TOSNET_NODE(NODE=0); }
    """)
    gateway = VirtualGateway()
    async with unity_link.connect(gateway) as link:
        robot = unity_link.load(spec)(link)
        await robot.tables[1].store([1, 2, 3])
        assert [gateway.memory[address] for address in range(0x44, 0x48)] == [1, 2, 3, 0]
        await robot.first.set(True)
        assert await robot.leds.read(0) == 1
        assert [type(part) for part in (robot.port, robot.axis.net, robot.axis.node)] == [
            Fifo,
            TosnetNetwork,
            TosnetNode,
        ]
        assert (robot.axis.net.base, robot.axis.net.nodes, robot.port.words) == (0x80, 2, 16)


def test_every_module_that_a_spec_can_name_has_a_proxy() -> None:
    assert MODULES.keys() == MODULE_TYPES.keys()


@on_simulated_time
async def test_users_own_proxy_has_the_address_of_its_memory() -> None:
    class Stepper(Module):
        """A stepper motor."""

        SIZE = 2

        async def move_to(self, steps: int) -> None:
            await self.write(0, steps)

    gateway = VirtualGateway()
    async with unity_link.connect(gateway) as link:
        robot = unity_link.load(compile_text("public robot() { lift: MEMORY(BASE=0x40, SIZE=2); }"))(link)
        lift = Stepper(link, robot.lift.base)
        await lift.move_to(5)
        assert gateway.memory[0x40] == 5
        with pytest.raises(ArgumentError, match="<Stepper at 0x40, 2 words>: offset 2 asked for, 0 to 1 expected"):
            await lift.read(2)
