"""The SCARA of the Unity-Link paper as it stood in its laboratory: as node 2 of a TosNet network.

| address  | word                                               |
|----------|----------------------------------------------------|
| 00 to BF | the shared memory of three nodes, joints at 80 |
| F0       | CTRL                                               |
| F4 to F7 | COMM, and the counters of resets, packets, errors  |

The joints are at the addresses of the paper's figure 1, as those of `scara`, but behind double buffers, as TosNet's
VHDL (tal_top.vhd) has them: what is written goes into a buffer of its own, and with the first cycle after a commit the
buffers change places. The other buffer then has not got what was written last. What a node sends is shown as of the
last cycle; commits of reads are done by the gateware in each cycle by itself. Both buffers begin with the set points
that the joints have after power-up. What the paper does not tell is a choice made here: the length of a cycle, where
CTRL and COMM stand, and their bits, which `unity_link.network.tosnet` documents.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Self

from unity_link.network.tosnet import COMMIT_READ, COMMIT_WRITE, NODE_WORDS
from unity_link.virtual.scara import Scara

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from unity_link.virtual.bus import Device
    from unity_link.virtual.gateway import BareGateway

CYCLE = 0.001
"""Seconds between two packets."""
NODES = 3
CTRL, COMM = 0xF0, 0xF4
_SENT_TO = 4
"""Bit of an address: words 4 to 7 of a register are sent to the node."""
_RUNNING = 0b0011
"""`online` and `is_master`."""


class SharedMemory:
    """The memory of all nodes as a device, seen from the node that the gateway is.

    Args:
        words: how many it has.
        cycle: seconds between two packets.
        deliver: called with what the network sends after each change of the buffers, and the time of the packet.
        sent_by: gives the word that a node sends at an address, at the time of a packet; None where it sends none.
        initial: what stands in both buffers at first.
    """

    def __init__(
        self,
        words: int,
        cycle: float = CYCLE,
        deliver: Callable[[Mapping[int, int], float], object] | None = None,
        sent_by: Callable[[int, float], int | None] | None = None,
        initial: Mapping[int, int] | None = None,
    ) -> None:
        self.words = words
        self.cycle = cycle
        self.buffers = [dict(initial or {}), dict(initial or {})]
        """Buffers that are written to, and those that the network sends."""
        self.sent: list[dict[int, int]] = []
        """Buffers that the network has sent, as of each change; the last 64."""
        self.resets, self.errors = 1, 0
        self._deliver = deliver
        self._sent_by = sent_by
        self._committed: dict[int, int] = {}
        """The cycle of each commit that is under way, by its bit."""

    def packets(self, now: float) -> int:
        """Return how many packets there were until a time."""
        # A time that is meant to be that of a packet may be a little less.
        return math.floor(now / self.cycle + 1e-9)

    def commit(self, which: int, now: float) -> None:
        """Exchange the buffers of `COMMIT_WRITE` or `COMMIT_READ` with the next packet."""
        self.pass_time(now)
        for bit in (COMMIT_WRITE, COMMIT_READ):
            if which & bit:
                self._committed.setdefault(bit, self.packets(now))

    def committed(self, now: float) -> int:
        """Return the commits that are under way."""
        self.pass_time(now)
        return sum(self._committed)

    def pass_time(self, now: float) -> None:
        """Let packets pass up to a time."""
        packets = self.packets(now)
        for bit, at in list(self._committed.items()):
            if packets > at:
                del self._committed[bit]
                if bit == COMMIT_WRITE:
                    self._change((at + 1) * self.cycle)

    def _change(self, now: float) -> None:
        self.buffers.reverse()
        packet = dict(self.buffers[1])
        self.sent = [*self.sent[-63:], packet]
        if self._deliver is not None:
            self._deliver(packet, now)

    def read(self, offset: int, now: float) -> int:
        """Read a word: what a node sends as of the last packet, else what the buffer has."""
        self.pass_time(now)
        if not offset & _SENT_TO and self._sent_by is not None:
            word = self._sent_by(offset, self.packets(now) * self.cycle)
            if word is not None:
                return word
        return self.buffers[0].get(offset, 0)

    def write(self, offset: int, value: int, now: float) -> None:
        """Write a word into the buffer."""
        self.pass_time(now)
        self.buffers[0][offset] = value


class Control:
    """The words of CTRL and COMM of a memory as a device: CTRL at offset 0, COMM and the counters at 1 to 4."""

    def __init__(self, memory: SharedMemory) -> None:
        self._memory = memory

    def read(self, offset: int, now: float) -> int:
        """Read a word."""
        memory = self._memory
        return (memory.committed(now), _RUNNING, memory.resets, memory.packets(now), memory.errors)[offset]

    def write(self, offset: int, value: int, now: float) -> None:
        """Commit; the state cannot be written."""
        if offset == 0:
            self._memory.commit(value, now)


class ScaraOnTosnet:
    """The robot, and the network before it."""

    def __init__(self, scara: Scara) -> None:
        self.scara = scara
        self._offsets = {address: offset for offset, address in enumerate(scara.addresses())}
        self._mask = (1 << scara.word_bits) - 1
        self._last: dict[int, int] = {}
        initial = {address: self._word(address, 0.0) for address in self._offsets if address & _SENT_TO}
        self.memory = SharedMemory(NODES * NODE_WORDS, CYCLE, self._deliver, self._sent_by, initial)
        self._last = initial

    @classmethod
    def attach(cls, gateway: BareGateway) -> Self:
        """Put such a robot behind a gateway.

        Raises:
            ArgumentError: where the gateway's words are too narrow for its positions.
        """
        network = cls(Scara.made_for(gateway))
        gateway.attach(network.memory, range(NODES * NODE_WORDS))
        control: Device = Control(network.memory)
        gateway.attach(control, [CTRL, *range(COMM, COMM + 4)])
        return network

    def _word(self, address: int, now: float) -> int:
        return self.scara.read(self._offsets[address], now) & self._mask

    def _sent_by(self, address: int, now: float) -> int | None:
        return self._word(address, now) if address in self._offsets else None

    def _deliver(self, packet: Mapping[int, int], now: float) -> None:
        # Each packet has all set points; a motion goes on where they are the same.
        for address, word in packet.items():
            if address in self._offsets and self._last.get(address) != word:
                self.scara.write(self._offsets[address], word, now)
        self._last = dict(packet)
