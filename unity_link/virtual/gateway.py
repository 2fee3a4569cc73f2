"""The virtual gateway: the whole protocol as a model without I/O and without a clock.

Bytes and the time go in, bytes come out; the gateware answers the same bytes. Everything that happens at the gateway
happens inside `receive` and `advance`, so a test can stop the world between any two bytes. The order of the checks is
that of docs/protocol.md, "Errors": each step below either answers or hands on to the next.

`receive` -> `_answer` (node) -> `_body` (overflow to sequence: `unity_link.protocol.gateway.session`) -> `_execute`
(range, bus). Reads, and writes with the expected ID, of one word are most of the traffic and take a short way,
`_quick_read` and `_quick_write`, which gives exactly what the long way would, or gives up before anything changes.

The model answers at once and takes as many bytes as it is given. What a line and its FIFOs do to that is modelled in
front of it: `unity_link.virtual.line` and `unity_link.virtual.faults`. What these have no room for are samples alone:
they wait here, and while some do, they take turns with the responses, as in the gateware, and all leave before the
response to `K` or a group command.
"""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Protocol, runtime_checkable

import msgspec

from unity_link.errors import ArgumentError
from unity_link.protocol.gateway.session import Answer, GatewaySession
from unity_link.protocol.wire.compact import CompactForm, Packer, text_of
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.frames import in_session
from unity_link.protocol.wire.messages import COMMANDS, Codec, ErrorCode, Repeat, RequestError
from unity_link.virtual.bus import AccessError, Device, ModelBus
from unity_link.virtual.commands import CommandSet, FieldRangeError
from unity_link.virtual.groups import PublishGroups
from unity_link.virtual.model_clock import ClockedGateway
from unity_link.virtual.transport import GatewayTransport

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Callable, Iterable, MutableMapping

    from unity_link.protocol.wire.messages import DecodedRequest

_ENDS = re.compile(rb"([\r\n])")
_BROADCAST = 0xFF
_PREFIX_SIZE = 3
_LOWER_R, _LOWER_W = b"rw"
_BEHIND_SAMPLES = frozenset({"GS", "GN", "GX", "GP"})
"""Commands whose answer is behind every sample that was taken before it."""
_DEFAULT_INFO = GatewayInfo()


@runtime_checkable
class Gateway(ClockedGateway, Protocol):
    """Anything that behaves like a gateway: this model, the gateware in a simulator, a bad line before either.

    What subclasses it is a `unity_link.transport.Medium`: `unity_link.connect` opens it in place of a URL.
    """

    info: GatewayInfo

    @property
    def memory(self) -> MutableMapping[int, int]:
        """The words behind the gateway, by address."""

    async def open(self, protocol: asyncio.Protocol) -> asyncio.Transport:
        """Connect a protocol to the gateway, as a driver does to a medium."""
        transport = GatewayTransport(self, protocol)
        protocol.connection_made(transport)
        return transport


class BareGateway(Gateway, Protocol):
    """A gateway without a line before it, whose bus and pins are at hand: this model, or the compiled gateware."""

    def reset(self) -> None:
        """Go back to the state after power-up. What is behind the bus stays as it is."""

    def attach(self, device: Device, addresses: Iterable[int]) -> None:
        """Put a device behind addresses, which have none; the first is its offset 0."""

    def attach_elsewhere(self, device: Device) -> None:
        """Put a device behind every address that has none, in place of memory; its offsets are the addresses."""

    def detach(self, addresses: Iterable[int]) -> None:
        """Take the devices of addresses away again."""

    def overflow(self) -> None:
        """Lose bytes before the next one received: the frame that they belong to is answered by error 09."""

    def ticks_at(self, now: float) -> int:
        """Return the cycles of the gateway's clock since its reset, at an instant of an access (seconds)."""

    def trigger(self, now: float, group: int | None = None) -> None:
        """Apply a rising edge to the external trigger of a group; the publish comes out of the next call.

        Args:
            now: the time in seconds.
            group: number of the group; None for the triggers of all.
        """


class VirtualGateway(BareGateway):
    """A gateway with plain memory at every address.

    Args:
        info: the configuration that it reports and keeps to.
        node: its number on a shared medium, 0 to 254 (docs/protocol.md, "Addressed frames"); None for one of its own.

    Raises:
        ArgumentError: for a node number that does not fit.
        UnsupportedError: for a configuration that the protocol does not allow.
    """

    def __init__(self, info: GatewayInfo = _DEFAULT_INFO, *, node: int | None = None) -> None:
        info.check()
        if node is not None and not 0 <= node < _BROADCAST:
            raise ArgumentError(f"node {node} is not from 0 to 254")
        addressed = Feature.ADDRESSED if node is not None else Feature(0)
        self.info = msgspec.structs.replace(info, features=info.features & ~Feature.ADDRESSED | addressed)
        self.wake: Callable[[], None] = _do_nothing
        self.bus = ModelBus(self.info)
        self._node = node
        self._codec = Codec(self.info, node)
        self._framing = self._codec.framing
        self.groups = PublishGroups(self.info, self.bus, self._frame)
        self._waiting = self.groups.ring.waiting
        self._commands = CommandSet(self.info, self.bus, self.groups)
        self._session = GatewaySession(self._codec)
        self._packer = Packer(CompactForm.of(self.info, from_gateway=True))
        self._sequence = self._session.sequence
        self._prepare_quick_ways()
        self.reset()

    def reset(self) -> None:
        """Go back to the state after power-up. What is behind the bus stays as it is."""
        self._session.reset()
        self._text_of = text_of(self.info, from_gateway=False)
        self._tail = b""
        self._bytes_lost = False
        self.groups.reset()
        self._commands.reset()

    @property
    def expected(self) -> int:
        """The next ID expected, -1 before the first session since reset."""
        return self._sequence.expected

    @property
    def session(self) -> int:
        """Number of the session under way, 0 for none."""
        return self._session.state.number

    def begin(self, session: int, first: int) -> None:
        """Begin a program's session, as a checked `K` does."""
        self._session.begin(session, first)
        self._commands.start_session(for_program=True)

    # What is behind the bus

    @property
    def memory(self) -> MutableMapping[int, int]:
        """The words of plain memory, by address."""
        return self.bus.memory

    def attach(self, device: Device, addresses: Iterable[int]) -> None:
        """Put a device behind addresses; the first is its offset 0.

        Raises:
            ArgumentError: for an address that does not fit or has a device, or an object that is no device.
        """
        self.bus.attach(device, addresses)

    def attach_elsewhere(self, device: Device) -> None:
        """Put a device behind every address that has none, in place of memory; its offsets are the addresses.

        Raises:
            ArgumentError: for an object that is no device.
        """
        self.bus.attach_elsewhere(device)

    def detach(self, addresses: Iterable[int]) -> None:
        """Take the devices of addresses away again."""
        self.bus.detach(addresses)

    # Time

    @property
    def send_immediate(self) -> int:
        """Send-immediate mode of responses: 0 off, 1 always, 2 adaptive."""
        return self._commands.send_immediate

    @property
    def flush_wanted(self) -> bool:
        """Return whether a sample was sent that is to be flushed (group flag bit 2); the one who flushes clears it."""
        return self.groups.ring.flush_wanted

    @flush_wanted.setter
    def flush_wanted(self, wanted: bool) -> None:
        self.groups.ring.flush_wanted = wanted

    @property
    def waiting(self) -> int:
        """Bytes not looked at yet: always 0."""
        return 0

    @property
    def next_due(self) -> float | None:
        """Instant at which a sample is due next, or one that waits is to be asked for."""
        return self.groups.next_due

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Let time pass up to `now` (seconds), and return the samples that leave, as far as there is `room`."""
        self.groups.clock.start(now)
        return self.groups.advance(now, math.inf if room is None else room)

    def ticks_at(self, now: float) -> int:
        """Return the cycles of the gateway's clock since its reset, at an instant (seconds)."""
        return self.groups.clock.ticks_at(now)

    def trigger(self, now: float, group: int | None = None) -> None:
        """Apply a rising edge to the external trigger of a group, or of all; the publish comes out of the next call."""
        self.groups.clock.start(now)
        self.groups.trigger(now, group)
        self.wake()

    # Frames

    def receive(self, data: bytes, now: float) -> bytes:
        """Take bytes at the time `now` (seconds), and return what is sent at once."""
        # What waits was told that there is no room, by `advance`.
        replies = [self.advance(now, 0 if self._waiting else None)]
        data = self._text_of(data)
        lines = (self._tail + data).split(b"\n")
        tail = lines.pop()
        if self._bytes_lost or b"\r" in data:
            tail = self._take_any(self._tail + data, now, replies)
        else:
            self._take_checked(lines, now, replies)
        self._tail = tail[: self._session.most_kept]
        return b"".join(replies)

    def overflow(self) -> None:
        """Lose bytes before the next one received: the frame that they belong to is answered by error 09."""
        self._bytes_lost = True

    def _take_checked(self, lines: list[bytes], now: float, replies: list[bytes]) -> None:
        """Take frames that all end in LF."""
        waiting = self._waiting
        read_size, write_size, posted_size = self._quick_sizes
        for line in lines:
            size = len(line)
            reply: bytes | None = None
            if size == read_size and line[0] == _LOWER_R:
                reply = self._quick_way(line, 1, self._quick_read)
            elif size == write_size and line[0] == _LOWER_W:
                reply = self._quick_way(line, 1, self._quick_write)
            elif size == posted_size and line[:2] == b"ws":
                reply = self._quick_way(line, 2, self._quick_post)
            if reply is None:
                reply = self._answer(line, now, plain=False)
            elif self._session.state.compact:
                reply = self._packer.pack_one(reply)
            replies.append(reply)
            if waiting and reply:
                replies.append(self._turn_of_a_sample())

    def _take_any(self, data: bytes, now: float, replies: list[bytes]) -> bytes:
        """Take frames with any ends; return what follows the last end."""
        pieces = _ENDS.split(data)
        for line, end in zip(pieces[:-1:2], pieces[1::2], strict=True):
            reply = self._answer(line, now, plain=end == b"\r")
            replies.append(reply)
            if self._waiting and reply:
                replies.append(self._turn_of_a_sample())
        return pieces[-1]

    def _turn_of_a_sample(self) -> bytes:
        self.groups.ring.send_one()
        return self.groups.ring.take()

    def _frame(self, body: bytes, plain: bool) -> bytes:  # noqa: FBT001  (the form of a frame, everywhere)
        if plain:
            return self._framing.plain_reply(body)
        state = self._session.state
        frame = self._framing.checked(body, state.seeds[1] if in_session(body[0]) else 0)
        return self._packer.pack_one(frame) if state.compact else frame

    def _answer(self, line: bytes, now: float, *, plain: bool) -> bytes:
        """Return the reply to what stood before an end, behind the samples that come before it."""
        bytes_lost, self._bytes_lost = self._bytes_lost, False
        prefix, muted = b"", False
        if self._node is not None:
            prefix, line = line[:_PREFIX_SIZE], line[_PREFIX_SIZE:]
            number = _node_number(prefix)
            if number not in (self._node, _BROADCAST):
                return b""
            muted = number == _BROADCAST
        if not line and not bytes_lost:
            return b""
        if muted:
            self._for_all(prefix, line, now, plain=plain, bytes_lost=bytes_lost)
            return self.groups.ring.take()
        body = self._body(prefix, line, now, plain=plain, bytes_lost=bytes_lost)
        samples = self.groups.ring.take()
        if not body:
            return samples
        return samples + self._frame(body, plain)

    def _body(self, prefix: bytes, line: bytes, now: float, *, plain: bool, bytes_lost: bool) -> bytes:
        """Return the body of the reply."""
        taken = self._session.take(line, plain=plain, prefix=prefix, bytes_lost=bytes_lost)
        return taken.body if isinstance(taken, Answer) else self._execute(taken, now)

    def _for_all(self, prefix: bytes, line: bytes, now: float, *, plain: bool, bytes_lost: bool) -> None:
        """Execute what is for all nodes, of which none answers: a stateless write alone."""
        try:
            request = self._session.reception.read(line, plain=plain, prefix=prefix, bytes_lost=bytes_lost)
        except RequestError:
            return
        if request.command == "WS" and request.id is None and not (plain and self._session.state.for_program):
            self._execute(request, now)

    def _execute(self, request: DecodedRequest, now: float) -> bytes:
        command = request.command
        if command == "Q":
            return b"Q" + self.info.to_hex()
        if command == "H":
            return self._codec.response(request, self._session.state.failed)
        if command == "K":
            return self._start_or_tell_session(request)
        try:
            reads = self._commands.run[command](now, *request.values)
        except (FieldRangeError, AccessError) as fault:
            if request.id is not None and not request.repeated:
                self._session.state.fail(request.id, fault.code, posted=command == "WS")
            body = self._codec.error(fault.code, request.id)
        else:
            body = b"" if command == "WS" else self._codec.response(request, reads)
            if request.id is not None and COMMANDS[command].repetition is Repeat.KEPT:
                self._session.state.keep(request.id, [reads] if isinstance(reads, int) else reads or ())
        if command in _BEHIND_SAMPLES:
            self.groups.ring.send_all()
        return body

    def _start_or_tell_session(self, request: DecodedRequest) -> bytes:
        if not request.values:
            return self._codec.response(request, self._session.asked)
        self._commands.start_session(for_program=self._session.state.for_program)
        return self._codec.response(request, self._session.ended)

    # The short way for single words

    def _prepare_quick_ways(self) -> None:
        info, overhead = self.info, self._framing.crc.digits + self.info.id_digits + self.info.address_digits + 1
        quick = self._node is None
        write_size = overhead + info.data_digits
        self._quick_sizes = (overhead, write_size, write_size + 1) if quick else (-1, -1, -1)
        self._crc_text = self._framing.crc.text
        self._crc_digits = self._framing.crc.digits
        self._address_shift = 4 * info.address_digits
        self._address_field = (1 << self._address_shift) - 1
        self._data_shift = 4 * info.data_digits
        self._data_field = (1 << self._data_shift) - 1
        self._last_address = (1 << info.address_bits) - 1
        self._last_word = (1 << info.data_bits) - 1
        self._word_form = b"r%%b%%0%dX" % info.data_digits
        self._damage_reply = self._frame(self._codec.error(ErrorCode.CRC), plain=False)

    def _quick_way(self, line: bytes, head: int, answer: Callable[[int], bytes | None]) -> bytes | None:
        """Answer what may be a request of `head` letters, or give up: `answer` takes its fields as one number."""
        if self._sequence.expected < 0:
            return None
        digits = self._crc_digits
        check = self._crc_text(line[:-digits], self._session.state.seeds[0])
        if check != line[-digits:]:
            return None if check == line[-digits:].upper() else self._damage_reply
        # The second digit may be no X, for int() would take 0X for a prefix.
        if not line.isalnum() or line[head + 1] in b"xX":
            return None
        try:
            fields = int(line[head:-digits], 16)
        except ValueError:
            return None
        return answer(fields)

    def _quick_read(self, fields: int) -> bytes | None:
        """Answer `r` of plain memory in a session, ahead as well, or give up."""
        number, address = fields >> self._address_shift, fields & self._address_field
        sequence = self._sequence
        if address > self._last_address or address in self.bus.devices:
            return None
        ahead = number - sequence.expected & sequence.mask
        if not ahead:
            sequence.advance()
        elif ahead <= sequence.mask >> 1:
            told, sequence.gap_reported = sequence.gap_reported, True
            if told:
                return b""
            return self._framing.checked(self._codec.out_of_sequence(sequence.expected), self._session.state.seeds[1])
        elif sequence.outcome(number):
            return None
        body = self._word_form % (self._codec.id_text[number], self.bus.memory[address])
        return b"%b%b\n" % (body, self._crc_text(body, self._session.state.seeds[1]))

    def _quick_write(self, fields: int) -> bytes | None:
        """Answer `w` to plain memory with the expected ID, or give up."""
        number = self._sequence.expected
        if self._quick_post(fields) is None:
            return None
        body = b"w" + self._codec.id_text[number]
        return b"%b%b\n" % (body, self._crc_text(body, self._session.state.seeds[1]))

    def _quick_post(self, fields: int) -> bytes | None:
        """Do the same for `ws`, which has no answer."""
        rest, word = fields >> self._data_shift, fields & self._data_field
        number, address = rest >> self._address_shift, rest & self._address_field
        fits = address <= self._last_address and word <= self._last_word
        if number != self._sequence.expected or not fits or address in self.bus.devices:
            return None
        self._sequence.advance()
        dict.__setitem__(self.bus.memory, address, word)
        return b""


def _do_nothing() -> None:
    """Stand in for a caller that needs no waking."""


def _node_number(prefix: bytes) -> int | None:
    """Return the number in a prefix of `Z` and two hex digits, None where it is none."""
    if len(prefix) != _PREFIX_SIZE or prefix[:1] != b"Z" or not prefix[1:].isalnum():
        return None
    try:
        return int(prefix[1:], 16)
    except ValueError:
        return None
