"""The line between a host and its peer: bytes are late, split, lost, damaged, duplicated, and connections are cut.

Datagrams are lost, damaged, duplicated and late, each by itself.

A `Network` connects by name. The last part of a host name is the listener, the whole name is the line: two programs
that open ``tcp://p3.server0:1`` and ``tcp://p4.server0:1`` reach the same server over lines of their own.
A line outlives its connections: its two `Course` objects count all bytes that were ever carried, and a fault belongs to
one byte number. So a shortened scenario has the same faults at the same bytes.
"""

from __future__ import annotations

import asyncio
import errno
import re
import socket
from collections import Counter
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

HIGH = 65_536
"""Bytes waiting in a connection at which its writer has to pause; it may resume at a quarter of them."""
NEVER = 1 << 62
Address = tuple[str, int]
STRETCH, IN_PIECES = 1_000, 250
"""Bytes in a stretch of a line that splits them, and the number of bytes at its start that arrive in pieces."""


TEXTS = (
    b"U-Boot 2024.01 (Jan 08 2024 - 15:37:48 +0000)\r\nDRAM:  1 GiB\r\nWDT:   Not starting\r\n",
    b"[    0.000000] Booting Linux on physical CPU 0x0\r\n[    0.000000] Kernel command line: console=ttyPS0\r\n",
    b"login: \x1b[6n\rr\nPassword:\rw\n$ \x04",
    b"\xff\x00\x80\x7f\n\x00\x00\xf0\n\r\xff",
    b"\x00" * 60,
    b"R40\rH\rRM4002\rQ\r",
)
"""Texts of boot loaders, consoles, noise and a person; none of them changes the state of a gateway."""
WRITES = b"W40000000FF\rW400000000FF\rWS41000000FF\rWS410000000FF\r"
"""Writes as a person types them, for words of 32 and of 36 bits (fault `typed`)."""
_OPENING = re.compile(rb"K[0-9A-F]{6}")


class Fault(NamedTuple):
    """Fault of a line at one of its bytes."""

    line: str
    back: bool
    """True for the direction from the gateway to the host."""
    at: int
    """Number of the byte since the start of the scenario."""
    kind: str
    """``lose``, ``flip``, ``double``, ``text``, ``typed``, ``stall`` or ``cut``; for the datagram with the byte
    ``lose``, ``flip``, ``copy`` or ``late``."""
    amount: float
    """Number of lost or duplicated bytes; inverted bits; index in `TEXTS`; seconds of a stall, until a cut is noticed,
    or until a datagram or its copy arrives."""


class Line(NamedTuple):
    """A line without faults."""

    name: str
    latency: float
    """Seconds that a byte takes to arrive."""
    piece: int
    """Largest number of bytes in one read, if bytes arrive in pieces."""
    room: int
    """Bytes that may wait before their writer has to pause, unless it sets another limit."""
    echoes: bool = False
    """True if the adapter also receives the bytes that it sends."""


class Course:
    """One direction of a line."""

    def __init__(self, name: str, faults: Sequence[Fault], trace: list[Any]) -> None:
        self.name = name
        self.position = 0
        self.fired = 0
        self.most_waiting = 0
        """Largest number of bytes that ever waited to be carried."""
        self._faults = sorted(faults, key=lambda fault: -fault.at)
        self._losing = 0
        self._next = self._faults[-1].at if self._faults else NEVER
        self._trace = trace

    def calm(self) -> None:
        """Remove all later faults."""
        self._faults.clear()
        self._next, self._losing = NEVER, 0

    def carry(self, data: bytes, now: float) -> tuple[bytes, bytes, Fault | None]:
        """Return the part of `data` that arrives, the part that is not carried yet, and the fault that stopped it."""
        if self.position + len(data) <= self._next and not self._losing:
            self.position += len(data)
            return data, b"", None
        return self._spoil(data, now)

    def _spoil(self, data: bytes, now: float) -> tuple[bytes, bytes, Fault | None]:
        arrived = bytearray()
        place = 0
        while place < len(data):
            if self._losing:
                lost = min(self._losing, len(data) - place)
                self._losing -= lost
                place += lost
                self.position += lost
                continue
            sound = min(len(data) - place, self._next - self.position)
            arrived += data[place : place + sound]
            place += sound
            self.position += sound
            if self.position < self._next or place == len(data):
                break
            fault = self._pop(now)
            if fault.kind == "lose":
                self._losing = int(fault.amount)
            elif fault.kind == "flip":
                arrived.append(data[place] ^ int(fault.amount))
                place += 1
                self.position += 1
            elif fault.kind == "double":
                arrived += data[place : place + int(fault.amount)]
            elif fault.kind == "text":
                arrived += TEXTS[int(fault.amount)]
            elif fault.kind == "typed":
                arrived += WRITES * self._has_opened()
            else:
                return bytes(arrived), data[place:], fault
        return bytes(arrived), b"", None

    def _has_opened(self) -> bool:
        """Return true if a host has sent an opening: before that, a gateway executes typed commands."""
        carried = (entry[3] for entry in self._trace if entry[1:3] == (self.name, "carry"))
        return any(_OPENING.search(data) for data in carried)

    def scatter(self, datagram: bytes, now: float) -> list[tuple[float, bytes]]:
        """Return the copies of a datagram that arrive, each with its delay in seconds."""
        end = self.position + len(datagram)
        arriving = [] if self._losing else [(0.0, datagram)]
        self._losing = max(0, self._losing - len(datagram))
        while self._next < end:
            place = self._next - self.position
            fault = self._pop(now)
            if fault.kind == "lose":
                self._losing = max(0, int(fault.amount) - len(datagram))
                arriving.clear()
            elif fault.kind == "flip":
                spoiled = datagram[:place] + bytes([datagram[place] ^ int(fault.amount)]) + datagram[place + 1 :]
                arriving = [(late, spoiled) for late, _ in arriving]
            elif fault.kind == "copy":
                arriving += [(fault.amount, data) for _, data in arriving]
            else:
                arriving = [(late + fault.amount, data) for late, data in arriving]
        self.position = end
        return arriving

    def _pop(self, now: float) -> Fault:
        fault = self._faults.pop()
        self._next = max(self.position, self._faults[-1].at) if self._faults else NEVER
        self.fired += 1
        self._trace.append((now, self.name, "fault", f"{fault.kind} {fault.amount:g} at byte {self.position}"))
        return fault


class _Socket:
    """The part of a socket that drivers use."""

    family = socket.AF_UNIX

    def __init__(self, port: int) -> None:
        self._port = port

    def getsockname(self) -> tuple[str, int]:
        return "simulated", self._port

    def setsockopt(self, *_: int) -> None:
        """Do nothing: there is no socket."""


class End(asyncio.Transport):
    """End of a connection: one side writes to it, and the other side receives the bytes."""

    def __init__(self, network: Network, protocol: asyncio.BaseProtocol, line: Line, course: Course) -> None:
        super().__init__({"socket": _Socket(0)})
        self.peer: End
        self.listens = False
        """True at the listener's end."""
        self.course = course
        self._network = network
        self._loop = network.loop
        self._protocol: Any = protocol
        self.line = line
        self._buffer = bytearray()
        self._high = line.room
        self._planned = self._paused = self._closing = self._dead = self._ending = False
        self._reading = True

    def set_write_buffer_limits(self, high: int | None = None, low: int | None = None) -> None:
        self._high = self.line.room if high is None else high

    def get_write_buffer_size(self) -> int:
        return len(self._buffer)

    def set_protocol(self, protocol: asyncio.BaseProtocol) -> None:
        self._protocol = protocol

    def get_protocol(self) -> asyncio.BaseProtocol:
        protocol: asyncio.BaseProtocol = self._protocol
        return protocol

    def is_closing(self) -> bool:
        return self._closing

    def is_reading(self) -> bool:
        return self._reading and not self._closing

    def pause_reading(self) -> None:
        self._reading = False

    def resume_reading(self) -> None:
        self._reading = True
        self.peer._plan(0.0)

    def write(self, data: bytes | bytearray | memoryview) -> None:
        if self._closing:
            return
        self._buffer += data
        waiting = len(self._buffer)
        self.course.most_waiting = max(self.course.most_waiting, waiting)
        if waiting > self._high and not self._paused:
            self._paused = True
            self._protocol.pause_writing()
        self._plan(self.line.latency)

    def write_eof(self) -> None:
        """Do nothing: the other side closes the connection anyway."""

    def close(self) -> None:
        """Carry the written bytes, then end the connection."""
        self._ending = self._closing = True
        if not self._buffer:
            self.abort()

    def abort(self) -> None:
        """End at once; the other side is notified after the latency of a byte."""
        self._closing = True
        self._end(0.0)
        self.peer._end(self.line.latency)

    def drop(self) -> None:
        """Lose the bytes that were written and have not arrived."""
        self._buffer.clear()
        if self._ending:
            self.abort()
        elif self._paused and not self._dead:
            self._paused = False
            self._protocol.resume_writing()

    def take(self, data: bytes) -> None:
        """Receive bytes that another host on the line has sent."""
        if not self._dead:
            self._protocol.data_received(data)

    def cut(self, noticed_after: float) -> None:
        """End both sides, this one at once and the other one later, as if a machine noticed a broken cable late."""
        self._closing = self.peer._closing = True
        self._end(0.0)
        self.peer._buffer.clear()
        self.peer._end(noticed_after)

    def _end(self, after: float) -> None:
        if self._dead:
            return
        self._dead = True
        self._buffer.clear()
        self._loop.call_later(after, self._lose)

    def _lose(self) -> None:
        self._closing = True
        self._network.open.pop(self, None)
        self._protocol.connection_lost(None)

    def _plan(self, after: float) -> None:
        if self._buffer and not self._planned:
            self._planned = True
            if after:
                self._loop.call_later(after, self._deliver)
            else:
                self._loop.call_soon(self._deliver)

    def _deliver(self) -> None:
        self._planned = False
        peer, buffer, course = self.peer, self._buffer, self.course
        if self._dead or not peer._reading or not buffer:
            return
        data = bytes(buffer)
        buffer.clear()
        if course.position % STRETCH < IN_PIECES and len(data) > self.line.piece:
            buffer += data[self.line.piece :]
            data = data[: self.line.piece]
        now = self._loop.time()
        arrived, rest, fault = course.carry(data, now)
        if self.line.echoes and not self.listens:
            self._protocol.data_received(data[: len(data) - len(rest)])
        if rest:
            buffer[:0] = rest
        if arrived and not peer._dead:
            self._network.trace.append((now, course.name, "carry", arrived))
            peer._protocol.data_received(arrived)
        if fault is not None and fault.kind == "cut":
            self.cut(fault.amount)
            return
        if self._paused and len(buffer) <= self._high // 4 and not self._dead:
            self._paused = False
            self._protocol.resume_writing()
        if buffer:
            self._plan(fault.amount if fault is not None else 0.0)
        elif self._ending:
            self.abort()


class Port(asyncio.DatagramTransport):
    """A datagram socket of a listener, or of a host, which sends to one address over its line.

    Args:
        network: network that carries the datagrams.
        protocol: receives arriving datagrams.
        address: address of the socket.
        remote: address to which a host sends.
    """

    def __init__(
        self, network: Network, protocol: asyncio.DatagramProtocol, address: Address, remote: Address | None
    ) -> None:
        super().__init__({"sockname": address})
        self.protocol = protocol
        self._network = network
        self._address = address
        self._remote = remote
        self._closing = False

    def sendto(self, data: Any, addr: Any = None) -> None:
        if not self._closing:
            self._network.post(self._address, self._remote or addr, bytes(data), back=self._remote is None)

    def is_closing(self) -> bool:
        return self._closing

    def close(self) -> None:
        """Stop sending and receiving."""
        if not self._closing:
            self.unplug()
            self._network.loop.call_soon(self.protocol.connection_lost, None)

    def unplug(self) -> None:
        """Stop sending and receiving, without notifying the protocol."""
        self._closing = True
        if self._network.ports.get(self._address) is self:
            del self._network.ports[self._address]

    abort = close


class _Listener:
    """The part of `asyncio.Server` that its users need."""

    def __init__(self, network: Network, host: str, port: int) -> None:
        self._network = network
        self._place = host, port
        self.sockets = [_Socket(port)]

    def close(self) -> None:
        self._network.listeners.pop(self._place, None)

    async def wait_closed(self) -> None:
        """Do nothing: the listener has no open tasks."""


class Network:
    """All lines of a scenario.

    Args:
        loop: event loop with the simulated time.
        lines: the lines.
        faults: faults of all lines.
        trace: receives the events.
    """

    def __init__(
        self, loop: asyncio.AbstractEventLoop, lines: Sequence[Line], faults: Sequence[Fault], trace: list[Any]
    ) -> None:
        self.loop = loop
        self.trace = trace
        self.listeners: dict[tuple[str, int], Callable[[], asyncio.BaseProtocol]] = {}
        self.away: set[str] = set()
        """Names of listeners that are unreachable at present."""
        self.open: dict[End, str] = {}
        """Listeners' ends of open connections, with the name of the listener."""
        self.ports: dict[Address, Port] = {}
        """Datagram sockets; a host's address is its line with a number of its own."""
        self.connections: Counter[str] = Counter()
        """Number of connections made on each line."""
        self.on_return: Callable[[Line], None] = lambda _: None
        """Called when a line is connected again."""
        self._lines = {line.name: line for line in lines}
        self.courses = {
            (line.name, back): Course(
                f"{line.name}{'<' if back else '>'}",
                [fault for fault in faults if fault.line == line.name and fault.back == back],
                trace,
            )
            for line in lines
            for back in (False, True)
        }

    def listen(self, factory: Callable[[], asyncio.BaseProtocol], host: str, port: int) -> _Listener:
        """Listen for connections."""
        self.listeners[host, port] = factory
        return _Listener(self, host, port)

    async def connect(
        self, factory: Callable[[], asyncio.BaseProtocol], host: str, port: int
    ) -> tuple[End, asyncio.BaseProtocol]:
        """Connect to a listener."""
        line, name = self._lines[host], host.rpartition(".")[2]
        await asyncio.sleep(2 * line.latency)
        listener = self.listeners.get((name, port))
        if listener is None or name in self.away:
            raise ConnectionRefusedError(errno.ECONNREFUSED, "Connection refused")
        near, far = factory(), listener()
        here = End(self, near, line, self.courses[host, False])
        there = End(self, far, line, self.courses[host, True])
        here.peer, there.peer = there, here
        there.listens = True
        self.open[there] = name
        self.connections[host] += 1
        self.trace.append((self.loop.time(), host, "connect", self.connections[host]))
        if self.connections[host] > 1:
            self.on_return(line)
        far.connection_made(there)
        near.connection_made(here)
        return here, near

    def open_port(
        self, factory: Callable[[], asyncio.DatagramProtocol], local: Address | None, remote: Address | None
    ) -> tuple[Port, asyncio.DatagramProtocol]:
        """Open a datagram socket: at a local address, or at any address for one remote address."""
        address = local
        if address is None:
            assert remote is not None
            host = remote[0]
            self.connections[host] += 1
            address = host, self.connections[host]
            self.trace.append((self.loop.time(), host, "connect", self.connections[host]))
        protocol = factory()
        self.ports[address] = port = Port(self, protocol, address, remote)
        protocol.connection_made(port)
        return port, protocol

    def post(self, source: Address, target: Address, datagram: bytes, *, back: bool) -> None:
        """Send a datagram over the line, which may lose it."""
        name = (target if back else source)[0]
        line, course = self._lines[name], self.courses[name, back]
        if not back:
            target = name.rpartition(".")[2], target[1]
        for late, arriving in course.scatter(datagram, self.loop.time()):
            self.loop.call_later(line.latency + late, self._arrive, course.name, source, target, arriving)

    def _arrive(self, name: str, source: Address, target: Address, datagram: bytes) -> None:
        port = self.ports.get(target)
        if port is not None and target[0] not in self.away:
            self.trace.append((self.loop.time(), name, "carry", datagram))
            port.protocol.datagram_received(datagram, source)

    def unplug(self, address: Address) -> None:
        """Stop an address from sending and receiving datagrams."""
        port = self.ports.get(address)
        if port is not None:
            port.unplug()

    def cut(self, name: str) -> None:
        """Cut all connections to a listener."""
        for end in [end for end, listener in self.open.items() if listener == name]:
            end.cut(0.0)

    def hang_up(self, line: str) -> None:
        """Cut the connections of a line."""
        for end in [end for end in self.open if end.line.name == line]:
            end.cut(0.0)

    def intrude(self, line: str, data: bytes) -> None:
        """Send data to the listener of a line, as another host on the line."""
        for end in [end for end in self.open if end.line.name == line]:
            end.take(data)

    def drop(self, name: str) -> None:
        """Lose the bytes that a listener has sent and that have not arrived."""
        for end in [end for end, listener in self.open.items() if listener == name]:
            end.drop()

    def calm(self) -> None:
        """Remove all later faults."""
        for course in self.courses.values():
            course.calm()
