"""An RS-485 line: several gateways on one pair of wires, with detection of collisions.

Bytes take the time of the line's baud rate. Each node receives the bytes of the host. For its answer it enables its
driver half a bit and a lead time after the last stop bit, as the gateware's UART does. If two drivers send at the same
time, the bytes of both are damaged, and `SharedLine.collisions` gets a sentence about it.
"""

from __future__ import annotations

import asyncio
import math
from collections import deque
from typing import TYPE_CHECKING

import msgspec

from unity_link.errors import ArgumentError
from unity_link.protocol.window.constants import QUICK_TIMEOUT
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.transport.buffered import BufferedTransport
from unity_link.transport.turns import Line
from unity_link.virtual.gateway import Gateway, VirtualGateway
from unity_link.virtual.transport import GatewayTransport

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, MutableMapping

    from unity_link.transport.turns import Seat

DEFAULT_BAUD = 115_200
_BITS = 10
"""Bits on the line for each byte, including start and stop bit."""
_TURN_AROUND = 1.5
"""Time in bits from the last stop bit of the host to the first start bit of a node."""
_DAMAGED = b"\xff"
"""Byte that is received while two drivers send."""


def build_shared_line(
    nodes: Iterable[int],
    baud: int = DEFAULT_BAUD,
    info: GatewayInfo | None = None,
    delay: float = 0.0,
    build: Callable[[GatewayInfo, int], Gateway] | None = None,
) -> SharedLine:
    """Return a line with a half-duplex gateway with plain memory for each node.

    Args:
        nodes: numbers of the nodes.
        baud: baud rate of the line.
        info: configuration of each gateway.
        delay: seconds from a request to its answer, in addition to the turnaround time of the UART.
        build: returns the gateway for a configuration and a node; None for models.

    Raises:
        ArgumentError: if a number is out of range or occurs twice, or there is no node.
    """
    info = GatewayInfo() if info is None else info
    # RS-485 has no wires for flow control.
    features = (info.features | Feature.HALF_DUPLEX) & ~Feature.FLOW_CONTROL
    info = msgspec.structs.replace(info, features=features)
    gateways: dict[int, Gateway] = {}
    for node in nodes:
        if node in gateways:
            raise ArgumentError(f"node {node} is there twice: each node on a line has a number of its own")
        gateways[node] = VirtualGateway(info, node=node) if build is None else build(info, node)
    return SharedLine(gateways, baud, delay)


class SharedLine(Gateway):
    """A line with several gateways, which has the interface of one gateway for the host.

    Args:
        gateways: gateways by node number.
        baud: baud rate of the line.
        delay: seconds from a request to its answer, in addition to the turnaround time of the UART.

    Raises:
        ArgumentError: if there is no gateway, or the baud rate is not positive.
    """

    def __init__(self, gateways: Mapping[int, Gateway], baud: int = DEFAULT_BAUD, delay: float = 0.0) -> None:
        if not gateways:
            raise ArgumentError("a line without nodes answers nothing: one at least was expected")
        if baud <= 0:
            raise ArgumentError(f"baud={baud} is no rate: more than 0 was expected")
        self.gateways = dict(gateways)
        self.info = next(iter(gateways.values())).info
        self.wake: Callable[[], None] = lambda: None
        for gateway in gateways.values():
            gateway.wake = self._pass_on_wake
        self.gone: set[int] = set()
        """Numbers of nodes without power, which neither receive nor send."""
        self.collisions: list[str] = []
        """A sentence about each collision."""
        self.on_collision: Callable[[str], object] = lambda _: None
        """Is called with the sentence about each collision."""
        self._byte_time = _BITS / baud
        self._pause = _TURN_AROUND / baud + delay
        self._heard: deque[tuple[float, bytes]] = deque()
        """Bytes of the host on the line, with the times at which their last stop bits end."""
        self._sent: list[_Sending] = []
        """Transmissions of nodes on the line."""
        self._places: _Places | None = None

    def _pass_on_wake(self) -> None:
        self.wake()

    def at(self, node: int) -> Place:
        """Return the medium of a link to a node; `unity_link.connect` opens it like a URL."""
        return Place(self, node)

    def places(self) -> _Places:
        """Return the links of the running event loop to the nodes of the line."""
        if self._places is None or self._places.is_over:
            self._places = _Places(self, -math.inf if self._places is None else self._places.line.owed_until)
        return self._places

    @property
    def memory(self) -> MutableMapping[int, int]:
        """Words of the first gateway's memory, by address."""
        return next(iter(self.gateways.values())).memory

    @property
    def waiting(self) -> int:
        """Number of bytes of the host on the line."""
        return sum(len(data) for _, data in self._heard)

    @property
    def next_due(self) -> float | None:
        """Time at which bytes arrive, or a node has something to do."""
        times = [until for until, _ in self._heard] + [sending.until for sending in self._sent]
        times += [due for gateway in self.gateways.values() if (due := gateway.next_due) is not None]
        return min(times, default=None)

    def receive(self, data: bytes, now: float) -> bytes:
        """Send bytes of the host at the time `now`; return the bytes that have arrived from nodes."""
        arrived = self.advance(now)
        if data:
            begins = max(now, self._heard[-1][0]) if self._heard else now
            until = begins + len(data) * self._byte_time
            if self._collide("the host", begins, until):
                data = _DAMAGED * len(data)
            self._heard.append((until, data))
        return arrived

    def advance(self, now: float, room: int | None = None) -> bytes:  # noqa: ARG002  (the line has a rate of its own)
        """Advance to the time `now`, and return the bytes that have arrived from nodes."""
        arrived = b""
        while (due := self.next_due) is not None and due <= now:
            for node, gateway in self.gateways.items():
                if gateway.next_due is not None and gateway.next_due <= due:
                    self._send(node, gateway.advance(due), due)
            while self._heard and self._heard[0][0] <= due:
                _, data = self._heard.popleft()
                for node, gateway in self.gateways.items():
                    if node not in self.gone:
                        self._send(node, gateway.receive(data, due), due + self._pause)
            for sending in [sending for sending in self._sent if sending.until <= due]:
                self._sent.remove(sending)
                arrived += sending.data
        return arrived

    def _send(self, node: int, data: bytes, begins: float) -> None:
        """Send bytes of a node, from the time `begins` or after its earlier bytes."""
        if not data or node in self.gone:
            return
        own = [sending.until for sending in self._sent if sending.node == node]
        begins = max(begins, *own) if own else begins
        until = begins + len(data) * self._byte_time
        name = f"node {node}"
        damaged = self._collide(name, begins, until, node)
        if self._heard:
            self._record(f"{name} sends while the host does")
            self._heard = deque((ends, _DAMAGED * len(heard)) for ends, heard in self._heard)
            damaged = True
        self._sent.append(_Sending(node, begins, until, _DAMAGED * len(data) if damaged else data))

    def _collide(self, name: str, begins: float, until: float, node: int | None = None) -> bool:
        """Damage the transmissions of nodes that overlap with another one; return True if there are any.

        Args:
            name: the other sender, for messages.
            begins: start of the other transmission.
            until: end of the other transmission.
            node: number of the other sender; None for the host.
        """
        others = [sending for sending in self._sent if sending.node != node and sending.until > begins]
        # For a node, count only transmissions that begin before its own ends.
        others = [sending for sending in others if node is None or sending.begins < until]
        for other in others:
            other.data = _DAMAGED * len(other.data)
            self._record(f"{name} sends while node {other.node} does")
        return bool(others)

    def _record(self, text: str) -> None:
        self.collisions.append(text)
        self.on_collision(text)


class _Sending:
    """A transmission of a node."""

    def __init__(self, node: int, begins: float, until: float, data: bytes) -> None:
        self.node, self.begins, self.until, self.data = node, begins, until, data


class Place:
    """The medium of a link to one node, which may be opened repeatedly; created by `SharedLine.at`."""

    def __init__(self, line: SharedLine, node: int) -> None:
        self.node = node
        self._line = line

    async def open(self, protocol: asyncio.Protocol) -> asyncio.Transport:
        """Connect a protocol to the node, in the running event loop."""
        places = self._line.places()
        transport = _PlaceTransport(places, places.line.join(self.node), protocol)
        places.protocols[self.node] = protocol
        protocol.connection_made(transport)
        return transport


class _PlaceTransport(BufferedTransport):
    """The transport of a link to one node."""

    def __init__(self, places: _Places, seat: Seat, protocol: asyncio.Protocol) -> None:
        super().__init__(protocol, {"seat": seat, "byte_time": places.byte_time, "shortest_timeout": QUICK_TIMEOUT})
        self._places = places
        self._seat = seat

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Send a frame in the link's slot; outside of it, drop the frame."""
        if not self._closing and self._seat.has_turn:
            self._places.transport.write(data)

    def get_write_buffer_size(self) -> int:
        """Return the number of unwritten bytes: always 0."""
        return 0

    def abort(self) -> None:
        """Close the connection; a pending answer of the node still occupies the line."""
        if self._closing:
            return
        self._closing = True
        self._places.leave(self._seat.node)
        self._seat.leave()
        self._loop.call_soon(self._protocol.connection_lost, None)

    close = abort


class _Places(asyncio.Protocol):
    """All links of one event loop to the nodes of a line.

    Args:
        line: the line.
        free_at: time at which the first slot may begin; earlier links may still have pending answers.
    """

    def __init__(self, line: SharedLine, free_at: float) -> None:
        loop = asyncio.get_running_loop()
        self.line = Line("the given line", loop.time, free_at)
        self.byte_time = line._byte_time  # noqa: SLF001  (they are two halves of one thing)
        self.protocols: dict[int, asyncio.Protocol] = {}
        self.is_over = False
        self.transport = GatewayTransport(line, self)

    def leave(self, node: int) -> None:
        """Remove a link; with the last link the connection to the line ends."""
        del self.protocols[node]
        if not self.protocols:
            self.is_over = True
            self.transport.abort()

    def data_received(self, data: bytes) -> None:
        """Pass received bytes to the link that has the slot."""
        holder = self.line.holder
        if holder is not None and holder.node in self.protocols:
            self.protocols[holder.node].data_received(data)
