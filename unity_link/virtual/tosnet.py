"""The SCARA of the Unity-Link paper as in its laboratory: node 2 of a TosNet network.

| address  | word                                               |
|----------|----------------------------------------------------|
| 00 to BF | shared memory of three nodes; the joints are at 80 |
| F0       | CTRL                                               |
| F4 to F7 | COMM, and the counters of resets, packets, errors  |

The joints have the addresses of the paper's figure 1, as in `scara`, but with double buffers as in TosNet's VHDL
(tal_top.vhd). Writes go into one buffer, and the network sends the other one. In the first cycle after a commit the
buffers are exchanged; the buffer for writes then lacks the values that were written last. Reads return the values that
a node sent in the last cycle; the gateware commits reads in each cycle automatically. Both buffers start with the
joints' set points after power-up. The paper does not specify the length of a cycle, the addresses of CTRL and COMM, and
their bits; those here are our choice, and `unity_link.network.tosnet` documents them.
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
"""Bit of an address that is set for words 4 to 7 of a register, which are sent to the node."""
_RUNNING = 0b0011
"""Bits `online` and `is_master` of COMM."""


class SharedMemory:
    """The memory of all nodes as a device of the gateway's node.

    Args:
        words: number of words.
        cycle: seconds between two packets.
        deliver: is called after each exchange of the buffers, with the words that the network sends and the time of the
            packet.
        sent_by: returns the word that a node sends at an address, at the time of a packet; None if it sends none.
        initial: initial words of both buffers, by address.
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
        """The buffer for writes, and the buffer that the network sends."""
        self.sent: list[dict[int, int]] = []
        """Contents of the sent buffer after each of the last 64 exchanges."""
        self.resets, self.errors = 1, 0
        self._deliver = deliver
        self._sent_by = sent_by
        self._committed: dict[int, int] = {}
        """Number of the packet in which each pending commit was made, by the commit's bit."""

    def packets(self, now: float) -> int:
        """Return the number of packets up to a time."""
        # Rounding may put the time of a packet slightly before it.
        return math.floor(now / self.cycle + 1e-9)

    def commit(self, which: int, now: float) -> None:
        """Commit writes (`COMMIT_WRITE`), reads (`COMMIT_READ`) or both with the next packet."""
        self.pass_time(now)
        for bit in (COMMIT_WRITE, COMMIT_READ):
            if which & bit:
                self._committed.setdefault(bit, self.packets(now))

    def committed(self, now: float) -> int:
        """Return the bits of the pending commits."""
        self.pass_time(now)
        return sum(self._committed)

    def pass_time(self, now: float) -> None:
        """Send all packets up to a time."""
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
        """Return the word that a node sent in the last packet, or otherwise the word in the buffer for writes."""
        self.pass_time(now)
        if not offset & _SENT_TO and self._sent_by is not None:
            word = self._sent_by(offset, self.packets(now) * self.cycle)
            if word is not None:
                return word
        return self.buffers[0].get(offset, 0)

    def write(self, offset: int, value: int, now: float) -> None:
        """Write a word into the buffer for writes."""
        self.pass_time(now)
        self.buffers[0][offset] = value


class Control:
    """CTRL and COMM of a shared memory as a device: CTRL at offset 0, COMM and the counters at offsets 1 to 4."""

    def __init__(self, memory: SharedMemory) -> None:
        self._memory = memory

    def read(self, offset: int, now: float) -> int:
        """Return a word."""
        memory = self._memory
        return (memory.committed(now), _RUNNING, memory.resets, memory.packets(now), memory.errors)[offset]

    def write(self, offset: int, value: int, now: float) -> None:
        """Commit by a write to CTRL; writes to other words have no effect."""
        if offset == 0:
            self._memory.commit(value, now)


class ScaraOnTosnet:
    """The robot at a TosNet network."""

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
        """Return a robot and a network that are attached to a gateway.

        Raises:
            ArgumentError: if the gateway's words are too narrow for positions.
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
        # Each packet has all set points. Write only changed ones, because a write restarts the motion.
        for address, word in packet.items():
            if address in self._offsets and self._last.get(address) != word:
                self.scara.write(self._offsets[address], word, now)
        self._last = dict(packet)
