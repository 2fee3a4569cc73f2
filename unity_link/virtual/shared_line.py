"""An RS-485 line: several gateways on one pair of wires, on which two that send at the same time are found out.

What is sent takes its time on the line. Each node hears what the host sends, and enables its driver for its answer half
a bit and its lead behind the last stop bit, as the gateware's UART does. Where somebody begins to send while another
still does, both are damaged, and `SharedLine.collisions` has a sentence of it.
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
"""Bits of a byte, with start and stop bit."""
_TURN_AROUND = 1.5
"""Bits between the last stop bit of the host and the first start bit of a node."""
_DAMAGED = b"\xff"
"""Byte that is heard where two drivers are against each other."""


def build_shared_line(
    nodes: Iterable[int],
    baud: int = DEFAULT_BAUD,
    info: GatewayInfo | None = None,
    delay: float = 0.0,
    build: Callable[[GatewayInfo, int], Gateway] | None = None,
) -> SharedLine:
    """Return a line with a half-duplex gateway of plain memory for each of some nodes.

    Args:
        nodes: their numbers.
        baud: of the line.
        info: the configuration of each.
        delay: seconds from a request to the beginning of its answer, beyond what the UART needs.
        build: makes the gateway of a configuration and a node; None: a model.

    Raises:
        ArgumentError: for a number that no node can have, or two have, and for no node at all.
    """
    info = GatewayInfo() if info is None else info
    # A UART without flow control, as there is no third wire.
    features = (info.features | Feature.HALF_DUPLEX) & ~Feature.FLOW_CONTROL
    info = msgspec.structs.replace(info, features=features)
    gateways: dict[int, Gateway] = {}
    for node in nodes:
        if node in gateways:
            raise ArgumentError(f"node {node} is there twice: each node on a line has a number of its own")
        gateways[node] = VirtualGateway(info, node=node) if build is None else build(info, node)
    return SharedLine(gateways, baud, delay)


class SharedLine(Gateway):
    """A line with gateways on it: towards the host it behaves as one.

    Args:
        gateways: by the numbers of their nodes.
        baud: of the line.
        delay: seconds from a request to the beginning of its answer, beyond what the UART needs.

    Raises:
        ArgumentError: where there is no gateway, or for a rate of 0 or less.
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
        """Nodes without power: they hear nothing and send nothing."""
        self.collisions: list[str] = []
        self.on_collision: Callable[[str], object] = lambda _: None
        """Is told of each."""
        self._byte_time = _BITS / baud
        self._pause = _TURN_AROUND / baud + delay
        self._heard: deque[tuple[float, bytes]] = deque()
        """Bytes that the host sends, and the instants at which their last stop bits are over."""
        self._sent: list[_Sending] = []
        """Transmissions of nodes."""
        self._places: _Places | None = None

    def _pass_on_wake(self) -> None:
        self.wake()

    def at(self, node: int) -> Place:
        """Return the medium of a link to a node: what `unity_link.connect` takes in place of a URL."""
        return Place(self, node)

    def places(self) -> _Places:
        """Return where links in the running loop take their places."""
        if self._places is None or self._places.is_over:
            self._places = _Places(self, -math.inf if self._places is None else self._places.line.owed_until)
        return self._places

    @property
    def memory(self) -> MutableMapping[int, int]:
        """The words behind the first of the gateways, by address."""
        return next(iter(self.gateways.values())).memory

    @property
    def waiting(self) -> int:
        """Bytes not looked at yet: as many as are on the line."""
        return sum(len(data) for _, data in self._heard)

    @property
    def next_due(self) -> float | None:
        """Instant at which something arrives, or a node sends by itself."""
        times = [until for until, _ in self._heard] + [sending.until for sending in self._sent]
        times += [due for gateway in self.gateways.values() if (due := gateway.next_due) is not None]
        return min(times, default=None)

    def receive(self, data: bytes, now: float) -> bytes:
        """Send bytes as the host; return what has arrived from the nodes."""
        arrived = self.advance(now)
        if data:
            begins = max(now, self._heard[-1][0]) if self._heard else now
            until = begins + len(data) * self._byte_time
            if self._collide("the host", begins, until):
                data = _DAMAGED * len(data)
            self._heard.append((until, data))
        return arrived

    def advance(self, now: float, room: int | None = None) -> bytes:  # noqa: ARG002  (the line has a rate of its own)
        """Let time pass, and return what has arrived."""
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
        """Send as a node."""
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
        """Damage what nodes send in a time in which another sends; return whether there is any."""
        others = [sending for sending in self._sent if sending.node != node and sending.until > begins]
        # A node that will have begun within this time has an answer on its way.
        others = [sending for sending in others if node is None or sending.begins < until]
        for other in others:
            other.data = _DAMAGED * len(other.data)
            self._record(f"{name} sends while node {other.node} does")
        return bool(others)

    def _record(self, text: str) -> None:
        self.collisions.append(text)
        self.on_collision(text)


class _Sending:
    """Transmission of a node."""

    def __init__(self, node: int, begins: float, until: float, data: bytes) -> None:
        self.node, self.begins, self.until, self.data = node, begins, until, data


class Place:
    """The medium of a link to one node, in the loop in which it is opened, again and again; made by `SharedLine.at`."""

    def __init__(self, line: SharedLine, node: int) -> None:
        self.node = node
        self._line = line

    async def open(self, protocol: asyncio.Protocol) -> asyncio.Transport:
        """Connect a protocol to the line."""
        places = self._line.places()
        transport = _PlaceTransport(places, places.line.join(self.node), protocol)
        places.protocols[self.node] = protocol
        protocol.connection_made(transport)
        return transport


class _PlaceTransport(BufferedTransport):
    """The connection of a link to one node."""

    def __init__(self, places: _Places, seat: Seat, protocol: asyncio.Protocol) -> None:
        super().__init__(protocol, {"seat": seat, "byte_time": places.byte_time, "shortest_timeout": QUICK_TIMEOUT})
        self._places = places
        self._seat = seat

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Send a frame, in the turn of the link."""
        if not self._closing and self._seat.has_turn:
            self._places.transport.write(data)

    def get_write_buffer_size(self) -> int:
        """Return how many bytes are not written yet."""
        return 0

    def abort(self) -> None:
        """End the connection; an answer that is owed still comes."""
        if self._closing:
            return
        self._closing = True
        self._places.leave(self._seat.node)
        self._seat.leave()
        self._loop.call_soon(self._protocol.connection_lost, None)

    close = abort


class _Places(asyncio.Protocol):
    """All links to the nodes of a line, in one event loop.

    Args:
        line: the line.
        free_at: when the first turn may begin: an answer may be owed to links that were there before.
    """

    def __init__(self, line: SharedLine, free_at: float) -> None:
        loop = asyncio.get_running_loop()
        self.line = Line("the given line", loop.time, free_at)
        self.byte_time = line._byte_time  # noqa: SLF001  (they are two halves of one thing)
        self.protocols: dict[int, asyncio.Protocol] = {}
        self.is_over = False
        self.transport = GatewayTransport(line, self)

    def leave(self, node: int) -> None:
        """Forget a link; the last one leaves the line."""
        del self.protocols[node]
        if not self.protocols:
            self.is_over = True
            self.transport.abort()

    def data_received(self, data: bytes) -> None:
        """Hand on what arrives to the link whose turn it is."""
        holder = self.line.holder
        if holder is not None and holder.node in self.protocols:
            self.protocols[holder.node].data_received(data)
