"""TosNet: a fibre-optic network in which all nodes share a memory; TOSNET and TOSNET_NODE in a spec.

TosNet [1] mirrors one block of memory of 1024 words in all nodes, once in each cycle. Node n has the 64 words from
address 64 n on. Each of its 8 registers has 8 words: the node sends words 0 to 3 and receives words 4 to 7. These are
TosNet's own addresses (`data_reg_addr` in its VHDL [2]: node, register, direction, word). The joints in figure 1 of the
Unity-Link paper have such addresses, in node 2.

The memory is double-buffered. Written words stay in a back buffer until they are committed; in the next cycle the two
buffers are exchanged. The new back buffer then lacks the words of the last commit, so a writer must write all its words
again with each commit, as `TosnetNetwork` does.

TosNet does not define how a processor reaches its signals. In a spec, CTRL and COMM are the addresses of these words:

| word | bits | TosNet's signal |
|---|---|---|
| CTRL | 0 | `commit_write`: set by a write, reads as 1 until the write buffers have been exchanged |
| | 1 | `commit_read`: the same for the read buffers |
| COMM | 0 | `online` |
| | 1 | `is_master` |
| | 2 | `packet_error`: the last packet was damaged |
| | 3 | `system_halt`: too many cycles without a commit |
| COMM + 1 | | `reset_counter` |
| COMM + 2 | | `packet_counter` |
| COMM + 3 | | `error_counter` |

Without CTRL this module commits nothing: the gateware must commit in each cycle by itself. With CTRL each write is
committed, but reads only if `commit_read` is called, because groups that the gateway publishes need gateware that
commits reads by itself anyway.

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
"""Number of words of a register in each direction."""
COMMIT_WRITE, COMMIT_READ = 1, 2
_STATE_WORDS = 4
_LOST_CYCLES = 1000
"""Reads of CTRL until a commit counts as failed; they take many cycles of even the slowest network."""


class TosnetState(msgspec.Struct, frozen=True, kw_only=True):
    """State of a network. The counters start at 0 when the FPGA is configured."""

    online: bool
    """True if the network is configured and running."""
    is_master: bool
    """True if the gateway's node is the master, which sends the packets."""
    packet_error: bool
    """True if the last packet was damaged."""
    system_halt: bool
    """True if there were too many cycles without a commit."""
    resets: int
    packets: int
    errors: int
    """Number of packets that arrived damaged."""


class TosnetNetwork(Module):
    """A TosNet network, accessed through one of its nodes."""

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
        """Create the proxy of a network.

        Args:
            bus: as for `Module`.
            base: address of the shared memory.
            size: number of words of the shared memory; None for 64 words per node.
            ctrl: address of the control word; None if the gateware commits by itself.
            comm: address of the state words; None if the gateway has none.
            nodes: number of nodes, 1 to 16; None for 16.
        """
        self.nodes = NODES if nodes is None else nodes
        super().__init__(bus, base, size=NODE_WORDS * self.nodes if size is None else size)
        self.ctrl = ctrl
        self.comm = comm
        self._committing = None if ctrl is None else CommittingBus(bus, ctrl)

    @property
    def bus(self) -> Bus:
        """The bus for reads and writes of the shared memory; with CTRL, it commits each write."""
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
            ArgumentError: if no COMM was given.
        """
        if self.comm is None:
            raise ArgumentError(f"{self!r}: its state cannot be read, because no COMM was given")
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
        """Make the newest packet visible to reads, for gateware that does not commit reads by itself.

        Return after the buffers have been exchanged.

        Raises:
            ArgumentError: if no CTRL was given.
            UnityLinkError: if the network does not run.
        """
        await self._bus_with_control().commit_read()

    async def commit_write(self) -> None:
        """Commit all written words, and wait until the buffers have been exchanged. Writes through proxies also commit.

        Raises:
            ArgumentError: if no CTRL was given.
            UnityLinkError: if the network does not run.
        """
        await self._bus_with_control().commit_write()

    def _bus_with_control(self) -> CommittingBus:
        if self._committing is None:
            raise ArgumentError(f"{self!r}: it cannot commit, because no CTRL was given")
        return self._committing


class TosnetNode(Module):
    """The shared memory of one node: 8 registers, each with 4 words that the node sends and 4 that it receives."""

    SIZE = NODE_WORDS

    def __init__(self, bus: Bus, base: int = 0, *, size: int | None = None, node: int = 0) -> None:
        """Create the proxy of a node.

        Args:
            bus: as for `Module`, or the `bus` of a network, which commits each write.
            base: address of the node's first word.
            size: as for `Module`.
            node: number of the node.
        """
        super().__init__(bus, base, size=size)
        self.node = node

    async def sent_by(self, register: int) -> Words:
        """Read the 4 words of a register that the node sends."""
        return await self.read_block(self._offset(register, 0), REGISTER_WORDS)

    async def sent_to(self, register: int) -> Words:
        """Read the 4 words of a register that the node receives."""
        return await self.read_block(self._offset(register, 1), REGISTER_WORDS)

    async def send(self, register: int, values: ArrayLike) -> None:
        """Write the first 1 to 4 of the words of a register that the node receives."""
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
    """Last value of each word that this program has written to a network over a link, by address."""

    def __init__(self) -> None:
        self.words: dict[int, int] = {}
        self.lock = Lock()


_WRITTEN: WeakKeyDictionary[Link, dict[int, _Written]] = WeakKeyDictionary()
"""Words written to networks, by link and by the address of CTRL."""


class CommittingBus:
    """A bus for which each write also repeats all earlier writes to the network, and commits them."""

    def __init__(self, link: Bus, ctrl: int) -> None:
        self.gateway = link.gateway
        self.link = link_under(link)
        self._under = link
        self._ctrl = ctrl
        # All proxies of a network on a link share the written words: otherwise one would commit old values of another.
        shared = _WRITTEN.setdefault(self.link, {}).setdefault(ctrl, _Written())
        self._written, self._lock = shared.words, shared.lock

    async def read(self, address: int) -> int:
        """Read a word of the buffer that was shown by the last commit of reads."""
        return await self._under.read(address)

    async def read_block(self, address: int, count: int) -> Words:
        """Read consecutive words."""
        return await self._under.read_block(address, count)

    async def read_many(self, addresses: ArrayLike) -> Words:
        """Read words at any addresses."""
        return await self._under.read_many(addresses)

    async def read_queue(self, address: int, count: int) -> Words:
        """Read one address several times."""
        return await self._under.read_queue(address, count)

    async def write_queue(self, address: int, values: ArrayLike) -> None:
        """Write one address several times, without a commit: a shared memory has no queues."""
        await self._under.write_queue(address, values)

    async def write(self, address: int, value: int) -> None:
        """Write a word and commit."""
        await self.write_many([address], [value])

    async def post(self, address: int, value: int) -> None:
        """Write a word, commit, and wait for both: a commit cannot be posted."""
        await self.write_many([address], [value])

    async def write_masked(self, address: int, value: int, mask: int) -> int:
        """Change bits of the word that was written last (0 at first). Return that word.

        The word is not read from the network, because the other buffer has an older one.
        """
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
        """Write words, commit, and wait for both: a commit cannot be posted."""
        await self.write_many(addresses, values)

    async def commit_write(self) -> None:
        """Commit all written words, and wait until the buffers have been exchanged."""
        async with self._lock:
            await self._send({})
            await self._settle(COMMIT_WRITE)

    async def commit_read(self) -> None:
        """Commit the buffer that is read, and wait until it has been exchanged with the newest."""
        async with self._lock:
            await self._settle(COMMIT_WRITE)
            await self._under.write(self._ctrl, COMMIT_READ)
            await self._settle(COMMIT_READ)

    async def _send(self, new: dict[int, int]) -> None:
        # Until the buffers have been exchanged, a write could change the buffer that is being sent.
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
