"""TosNet: the network of fibre optics whose nodes share a memory. TOSNET and TOSNET_NODE in a spec.

TosNet [1] mirrors one block of memory in all nodes, each cycle. Of its 1024 words, node n has the 64 from 64 n on; each
of a node's 8 registers has 8 words: 0 to 3 are sent by the node, 4 to 7 are sent to it. These are TosNet's own
addresses (`data_reg_addr` in its VHDL [2]: node, register, direction, word); figure 1 of the Unity-Link paper has its
joints so in node 2.

The memory is double-buffered. What is written goes into a buffer of its own until it is committed; with the next cycle
the buffers change places. So the buffer that comes up next has not got what was written last, and a writer must write
everything again: `TosnetNetwork` does.

TosNet leaves to the design around it how a processor reaches its signals. CTRL and COMM are addresses of

| word | bits | TosNet's signal |
|---|---|---|
| CTRL | 0 | `commit_write`: set by a write, reads as 1 until the buffers have changed places |
| | 1 | `commit_read`: likewise, of the buffer that is read |
| COMM | 0 | `online` |
| | 1 | `is_master` |
| | 2 | `packet_error`: the last packet was damaged |
| | 3 | `system_halt`: too many cycles without a commit |
| COMM + 1 | | `reset_counter` |
| COMM + 2 | | `packet_counter` |
| COMM + 3 | | `error_counter` |

Without CTRL nothing is committed from here: the gateware commits in each cycle by itself. With it, writes are committed
and reads are not, since groups that the gateway publishes need a gateware that commits reads by itself anyway.

[1] S. Falsig, A. S. Sørensen: TosNet: An easy-to-use, real-time communications protocol for modular, distributed robot
controllers. RoboComm 2009. [2] OpenCores, project tosnet, revision 3.2: tosnet.vhd, tal_top.vhd.
"""

from __future__ import annotations

from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

import msgspec
import numpy as np

from unity_link.errors import ArgumentError, UnityLinkError
from unity_link.link.runtimes.synchronisation import Lock
from unity_link.modules import Module, link_under
from unity_link.protocol.wire.numbers import whole_number

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from unity_link.link.link import Link
    from unity_link.modules import Bus
    from unity_link.protocol.wire.arrays import Words

NODES = 16
NODE_WORDS = 64
REGISTERS = 8
REGISTER_WORDS = 4
"""Words of a register in each direction."""
COMMIT_WRITE, COMMIT_READ = 1, 2
_STATE_WORDS = 4
_LOST_CYCLES = 1000
"""Reads of CTRL after which a commit counts as lost: many cycles of even the slowest network."""


class TosnetState(msgspec.Struct, frozen=True, kw_only=True):
    """State of a network; the counters count since the FPGA was configured."""

    online: bool
    """True if the network is configured and running."""
    is_master: bool
    """True if the gateway's node is the one that sends the packets."""
    packet_error: bool
    """True if the last packet was damaged."""
    system_halt: bool
    """True if there were too many cycles without a commit."""
    resets: int
    packets: int
    errors: int
    """Packets that arrived damaged."""


class TosnetNetwork(Module):
    """A TosNet network, seen from one of its nodes."""

    def __init__(
        self,
        bus: Bus,
        base: int = 0,
        *,
        size: int | None = None,
        ctrl: int | None = None,
        comm: int | None = None,
        nodes: int | None = None,
    ) -> None:
        """Stand on a link.

        Args:
            bus: as for `Module`.
            base: address of the shared memory.
            size: number of its words; None for those of all nodes.
            ctrl: address of the control word; None where the gateware commits by itself.
            comm: address of the words of state; None where there are none.
            nodes: how many there are, 1 to 16.
        """
        self.nodes = NODES if nodes is None else nodes
        super().__init__(bus, base, size=NODE_WORDS * self.nodes if size is None else size)
        self.ctrl = ctrl
        self.comm = comm
        self._committing = None if ctrl is None else CommittingBus(bus, ctrl)

    @property
    def bus(self) -> Bus:
        """The link, behind what commits each write."""
        return self.outer if self._committing is None else self._committing

    def node(self, number: int) -> TosnetNode:
        """Return the proxy of a node, 0 to 15."""
        number = whole_number(number, "a node")
        if not 0 <= number < self.nodes:
            raise ArgumentError(f"node {number} asked for, 0 to {self.nodes - 1} expected")
        return TosnetNode(self.bus, self.address(NODE_WORDS * number, NODE_WORDS), node=number)

    async def state(self) -> TosnetState:
        """Read the state of the network and its counters.

        Raises:
            ArgumentError: where no COMM was given.
        """
        if self.comm is None:
            raise ArgumentError(f"{self!r}: its state is behind COMM, which was not given")
        flags, resets, packets, errors = (int(word) for word in await self.link.read_block(self.comm, _STATE_WORDS))
        return TosnetState(
            online=bool(flags & 1),
            is_master=bool(flags & 2),
            packet_error=bool(flags & 4),
            system_halt=bool(flags & 8),
            resets=resets,
            packets=packets,
            errors=errors,
        )

    async def commit_read(self) -> None:
        """Show the newest packet to reads, and wait until it is shown; for gateware that does not by itself.

        Raises:
            ArgumentError: where no CTRL was given.
            UnityLinkError: where the network does not run.
        """
        await self._bus_with_control().commit_read()

    async def commit_write(self) -> None:
        """Send what was written, and wait until it is on its way. Writes through proxies do so by themselves.

        Raises:
            ArgumentError: where no CTRL was given.
            UnityLinkError: where the network does not run.
        """
        await self._bus_with_control().commit_write()

    def _bus_with_control(self) -> CommittingBus:
        if self._committing is None:
            raise ArgumentError(f"{self!r}: commits are behind CTRL, which was not given")
        return self._committing


class TosnetNode(Module):
    """The shared memory of one node: 8 registers, each of 4 words that it sends and 4 that are sent to it."""

    SIZE = NODE_WORDS

    def __init__(self, bus: Bus, base: int = 0, *, size: int | None = None, node: int = 0) -> None:
        """Stand on a link, or on a network's `bus`.

        Args:
            bus: as for `Module`.
            base: address of the node's first word.
            size: as for `Module`.
            node: its number.
        """
        super().__init__(bus, base, size=size)
        self.node = node

    async def sent_by(self, register: int) -> Words:
        """Read the 4 words of a register that the node sends."""
        return await self.read_block(self._offset(register, 0), REGISTER_WORDS)

    async def sent_to(self, register: int) -> Words:
        """Read the 4 words of a register that are sent to the node."""
        return await self.read_block(self._offset(register, 1), REGISTER_WORDS)

    async def send(self, register: int, values: ArrayLike) -> None:
        """Write the words of a register that are sent to the node, up to 4."""
        words = np.atleast_1d(np.asarray(values))
        if not 1 <= words.size <= REGISTER_WORDS:
            raise ArgumentError(f"{words.size} words were given for a register, 1 to {REGISTER_WORDS} expected")
        await self.write_block(self._offset(register, 1), words)

    def _offset(self, register: int, direction: int) -> int:
        register = whole_number(register, "a register")
        if not 0 <= register < REGISTERS:
            raise ArgumentError(f"register {register} asked for, 0 to {REGISTERS - 1} expected")
        return REGISTER_WORDS * (2 * register + direction)


class _Written:
    """Words ever written to a network over a link, by address."""

    def __init__(self) -> None:
        self.words: dict[int, int] = {}
        self.lock = Lock()


_WRITTEN: WeakKeyDictionary[Link, dict[int, _Written]] = WeakKeyDictionary()
"""Words written to networks, by the address of CTRL."""


class CommittingBus:
    """A link on which all that was ever written is written again with each write, and then committed."""

    def __init__(self, link: Bus, ctrl: int) -> None:
        self.gateway = link.gateway
        self.link = link_under(link)
        self._under = link
        self._ctrl = ctrl
        # What one proxy of a network writes, none may take back: all on a link share it, as long as that lives.
        shared = _WRITTEN.setdefault(self.link, {}).setdefault(ctrl, _Written())
        self._written, self._lock = shared.words, shared.lock

    async def read(self, address: int) -> int:
        """Read a word, as of the last commit of reads."""
        return await self._under.read(address)

    async def read_block(self, address: int, count: int) -> Words:
        """Read consecutive words."""
        return await self._under.read_block(address, count)

    async def read_many(self, addresses: ArrayLike) -> Words:
        """Read many words."""
        return await self._under.read_many(addresses)

    async def read_queue(self, address: int, count: int) -> Words:
        """Read an address many times."""
        return await self._under.read_queue(address, count)

    async def write_queue(self, address: int, values: ArrayLike) -> None:
        """Write an address many times, without a commit: a shared memory has no queues."""
        await self._under.write_queue(address, values)

    async def write(self, address: int, value: int) -> None:
        """Write a word and commit."""
        await self.write_many([address], [value])

    async def post(self, address: int, value: int) -> None:
        """Write a word and commit: a commit must be waited for."""
        await self.write_many([address], [value])

    async def write_masked(self, address: int, value: int, mask: int) -> int:
        """Change bits of what was written last, 0 at first: the other buffer would read back something older."""
        async with self._lock:
            old = self._written.get(address, 0)
            await self._send({address: old & ~mask | value & mask})
        return old

    async def write_block(self, address: int, values: ArrayLike) -> None:
        """Write consecutive words and commit."""
        words = np.asarray(values)
        await self.write_many(range(address, address + words.size), words)

    async def write_many(self, addresses: ArrayLike, values: ArrayLike) -> None:
        """Write words and commit."""
        new = dict(zip(np.asarray(addresses).tolist(), np.asarray(values).tolist(), strict=True))
        async with self._lock:
            await self._send(new)

    async def post_many(self, addresses: ArrayLike, values: ArrayLike) -> None:
        """Write words and commit: a commit must be waited for."""
        await self.write_many(addresses, values)

    async def commit_write(self) -> None:
        """Commit what was written, and wait until the buffers have changed places."""
        async with self._lock:
            await self._send({})
            await self._settle(COMMIT_WRITE)

    async def commit_read(self) -> None:
        """Commit the buffer that is read, and wait until it has changed places with the newest."""
        async with self._lock:
            await self._settle(COMMIT_WRITE)
            await self._under.write(self._ctrl, COMMIT_READ)
            await self._settle(COMMIT_READ)

    async def _send(self, new: dict[int, int]) -> None:
        # Until the buffers have changed places, a write would come into the one that may be leaving.
        await self._settle(COMMIT_WRITE)
        everything = self._written | new
        await self._under.write_many([*everything, self._ctrl], [*everything.values(), COMMIT_WRITE])
        self._written.update(new)

    async def _settle(self, which: int) -> None:
        for _ in range(_LOST_CYCLES):
            if not await self._under.read(self._ctrl) & which:
                return
        raise UnityLinkError(
            f"TosNet does not change its buffers (CTRL at {self._ctrl:#x} stays {which}): is the network online?"
        )
