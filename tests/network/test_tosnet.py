"""A TosNet network with its double buffers, which are exchanged at the next cycle."""

from __future__ import annotations

import asyncio
import itertools
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import unity_link
from support.simulated_time import on_simulated_time
from support.spec_examples import FIGURE_1
from unity_link import ArgumentError, GatewayInfo, UnityLinkError
from unity_link.data import Group
from unity_link.network import TosnetNetwork
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.tosnet import Control, SharedMemory

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.virtual import Device

CTRL, COMM = 0x7F0, 0x7F4
BASE = 0x400


class Accesses:
    """A device on a bus without time: a cycle of the network takes a number of accesses to all its devices."""

    passed = 0

    def __init__(self, device: Device) -> None:
        self._device = device

    def read(self, offset: int, _: float) -> int:
        Accesses.passed += 1
        return self._device.read(offset, Accesses.passed)

    def write(self, offset: int, value: int, _: float) -> None:
        Accesses.passed += 1
        self._device.write(offset, value, Accesses.passed)


def network(cycle: int = 3) -> tuple[VirtualGateway, SharedMemory]:
    gateway = VirtualGateway(GatewayInfo(address_bits=12))
    memory = SharedMemory(15 * 64, cycle)
    Accesses.passed = 0
    gateway.attach(Accesses(memory), range(BASE, BASE + 15 * 64))
    gateway.attach(Accesses(Control(memory)), [CTRL, *range(COMM, COMM + 4)])
    return gateway, memory


@pytest.mark.parametrize("cycle", [1, 2, 3, 5, 7, 50])
def test_no_set_point_returns_to_an_older_value_at_any_phase_of_cycles(cycle: int) -> None:
    @on_simulated_time
    async def check() -> None:
        gateway, memory = network(cycle)
        async with unity_link.connect(gateway) as link:
            tosnet = TosnetNetwork(link, BASE, ctrl=CTRL, nodes=15)
            node = tosnet.node(2)
            for number in range(1, 8):
                await node.write(4, number)
                await node.write(5 + number % 2, number)
            await tosnet.commit_write()
        words = [tuple(sent.get(2 * 64 + offset, 0) for offset in (4, 5, 6)) for sent in memory.sent]
        for before, after in itertools.pairwise(words):
            assert all(old <= new for old, new in zip(before, after, strict=True))
        assert words[-1] == (7, 6, 7)

    check()


@on_simulated_time
async def test_figure_1_commits_only_if_ctrl_is_given() -> None:
    wide = FIGURE_1.replace("TOSNET(", "GATEWAY(ADDRESS_BITS=12); TOSNET(").replace("BASE=0", f"BASE={BASE}")
    scara = unity_link.load(compile_text(wide))
    gateway, memory = network()
    node_2 = [0x80 + offset for offset in (0x0C, 0x0D)]
    async with unity_link.connect(gateway) as link:
        robot = scara(link)
        await robot.j1.pos_sp.set(1200)
        assert not memory.sent
        assert memory.buffers[0][node_2[0]] == 1200
    gateway, memory = network()
    async with unity_link.connect(gateway) as link:
        robot = scara(link, ctrl=CTRL, comm=COMM)
        (tosnet,) = robot.modules
        assert isinstance(tosnet, TosnetNetwork)
        assert (await tosnet.state()).online
        await robot.j1.pos_sp.set(1200)
        await Group(robot.j1.pos_sp, robot.j2.pos_sp).set([1300, 5])
        await robot.j2.pos_sp.post(6)
        await link.read_many([CTRL] * 10)
        assert [memory.sent[-1][address] for address in node_2] == [1300, 6]


@on_simulated_time
async def test_nodes_have_registers_of_four_words_in_each_direction() -> None:
    gateway = VirtualGateway(GatewayInfo(address_bits=12))
    async with unity_link.connect(gateway) as link:
        node = TosnetNetwork(link, BASE).node(2)
        await node.send(1, [1, 2, 3, 4])
        assert [gateway.memory[BASE + 0x8C + word] for word in range(4)] == [1, 2, 3, 4]
        gateway.memory[BASE + 0x88 + 3] = 9
        assert (await node.sent_by(1)).tolist() == [0, 0, 0, 9]
        assert (await node.sent_to(1)).tolist() == [1, 2, 3, 4]
        narrow: Any = np.uint8
        await TosnetNetwork(link, BASE).node(narrow(5)).send(narrow(7), [7])
        assert (await TosnetNetwork(link, BASE).node(5).sent_to(7)).tolist() == [7, 0, 0, 0]
        wrong: list[tuple[Callable[[], object], str]] = [
            (lambda: node.sent_by(8), "register 8 asked for, 0 to 7 expected"),
            (lambda: node.send(0, range(5)), "5 words were given for a register, 1 to 4 expected"),
            (lambda: node.read(64), "offset 64 asked for, 0 to 63 expected"),
        ]
        for call, message in wrong:
            with pytest.raises(ArgumentError, match=message):
                await call()  # type: ignore[misc]
        with pytest.raises(ArgumentError, match="node 16 asked for, 0 to 15 expected"):
            TosnetNetwork(link, BASE).node(16)


@on_simulated_time
async def test_comm_has_the_state_of_the_network_and_ctrl_its_commits() -> None:
    gateway, memory = network()
    memory.resets, memory.errors = 2, 9
    async with unity_link.connect(gateway) as link:
        await link.read_many([COMM] * 3)
        state = await TosnetNetwork(link, BASE, comm=COMM, nodes=15).state()
        assert (state.online, state.is_master, state.packet_error, state.system_halt) == (True, True, False, False)
        assert (state.resets, state.errors) == (2, 9)
        assert 0 < state.packets <= memory.packets(Accesses.passed)
        without = TosnetNetwork(link, BASE, nodes=15)
        with pytest.raises(ArgumentError, match="its state cannot be read, because no COMM was given"):
            await without.state()
        with pytest.raises(ArgumentError, match="it cannot commit, because no CTRL was given"):
            await without.commit_write()


@on_simulated_time
async def test_a_stopped_network_causes_an_error_and_no_endless_wait() -> None:
    gateway = VirtualGateway(GatewayInfo(address_bits=12))
    async with unity_link.connect(gateway) as link:
        tosnet = TosnetNetwork(link, BASE, ctrl=CTRL)
        await tosnet.node(1).write(4, 1)
        with pytest.raises(UnityLinkError, match=r"CTRL at 0x7f0 stays 1\): is the network online"):
            await tosnet.node(1).write(4, 2)
        with pytest.raises(UnityLinkError, match="is the network online"):
            await tosnet.commit_read()


@on_simulated_time
async def test_fields_change_the_last_written_word_not_that_of_the_other_buffer() -> None:
    gateway, memory = network()
    async with unity_link.connect(gateway) as link:
        node = TosnetNetwork(link, BASE, ctrl=CTRL, nodes=15).node(1)
        assert await node.write_masked(4, 0x11, 0xFF) == 0
        assert await node.write_masked(4, 0x2200, 0xFF00) == 0x11
        await node.write_block(5, [1, 2])
        await link.read_many([CTRL] * 10)
        assert [memory.sent[-1][64 + offset] for offset in (4, 5, 6)] == [0x2211, 1, 2]


@on_simulated_time
async def test_fields_of_one_word_written_at_once_are_all_stored() -> None:
    gateway, memory = network()
    async with unity_link.connect(gateway) as link:
        node = TosnetNetwork(link, BASE, ctrl=CTRL, nodes=15).node(1)
        masks = [0xF << 4 * place for place in range(8)]
        old = await asyncio.gather(*(node.write_masked(4, 0x7654_3210, mask) for mask in masks))
        await link.read_many([CTRL] * 10)
        assert old == [0, 0, 0x10, 0x210, 0x3210, 0x4_3210, 0x54_3210, 0x654_3210]
        assert memory.sent[-1][64 + 4] == 0x7654_3210


@on_simulated_time
async def test_two_proxies_of_a_network_on_a_link_keep_each_others_writes() -> None:
    gateway, memory = network()
    async with unity_link.connect(gateway) as link:
        one, other = (TosnetNetwork(link, BASE, ctrl=CTRL, nodes=15).node(1) for _ in range(2))
        for turn in range(4):
            await asyncio.gather(one.write(4, 10 + turn), other.write(5, 20 + turn))
            await asyncio.gather(one.write_masked(6, 0x1111, 0x00FF), other.write_masked(6, 0x2222, 0xFF00))
        await link.read_many([CTRL] * 10)
        assert [memory.sent[-1][64 + offset] for offset in (4, 5, 6)] == [13, 23, 0x2211]
