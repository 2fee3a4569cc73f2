"""The virtual gateway: a model of the whole protocol, without I/O and without a clock.

The caller passes received bytes and the time, and gets the bytes to send; the gateware sends the same bytes. The model
works only inside `receive` and `advance`, so that a test can examine it between any two bytes. The checks have the
order of docs/protocol.md, "Errors". Each of these steps either answers or calls the next one:

`receive` -> `_answer` (node) -> `_body` (overflow to sequence: `unity_link.protocol.gateway.session`) -> `_execute`
(range, bus). Most requests read or write a single word. They take a shorter path, `_quick_read` and `_quick_write`,
with exactly the same results; if the shorter path does not apply, it returns None before it changes anything.

The model answers at once, and accepts any number of bytes. Rates and FIFOs of a line are modelled in front of it, by
`unity_link.virtual.line` and `unity_link.virtual.faults`. Only samples may have to wait in the model until the line has
room. As in the gateware, pending samples and responses then alternate, and all pending samples are sent before the
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
"""Commands whose response follows all samples that were taken before it."""
_DEFAULT_INFO = GatewayInfo()


@runtime_checkable
class Gateway(ClockedGateway, Protocol):
    """Interface of all gateways: the model, compiled gateware, and lines in front of either.

    A subclass is a `unity_link.transport.Medium`, so that `unity_link.connect` opens it like a URL.
    """

    info: GatewayInfo

    @property
    def memory(self) -> MutableMapping[int, int]:
        """Words of the gateway's memory, by address."""

    async def open(self, protocol: asyncio.Protocol) -> asyncio.Transport:
        """Connect a protocol to the gateway, as a driver connects it to a medium."""
        transport = GatewayTransport(self, protocol)
        protocol.connection_made(transport)
        return transport


class BareGateway(Gateway, Protocol):
    """A gateway without a line, with access to its bus and its pins: the model, or compiled gateware."""

    def reset(self) -> None:
        """Restore the state after power-up; memory and devices keep theirs."""

    def attach(self, device: Device, addresses: Iterable[int]) -> None:
        """Attach a device to addresses without one; the first address has offset 0."""

    def attach_elsewhere(self, device: Device) -> None:
        """Attach a device to all addresses without one, in place of memory; its offsets are the addresses."""

    def detach(self, addresses: Iterable[int]) -> None:
        """Detach the devices from addresses."""

    def overflow(self) -> None:
        """Lose bytes before the next received byte: the gateway answers their frame with error 09."""

    def ticks_at(self, now: float) -> int:
        """Return the number of clock cycles from the gateway's reset to the time of an access in seconds."""

    def trigger(self, now: float, group: int | None = None) -> None:
        """Apply a rising edge to the external trigger of a group; the next call returns the samples.

        Args:
            now: the time in seconds.
            group: number of the group; None for the triggers of all groups.
        """


class VirtualGateway(BareGateway):
    """The model of a gateway, with plain memory at all addresses.

    Args:
        info: the gateway's configuration.
        node: node number on a shared medium, 0 to 254 (docs/protocol.md, "Addressed frames"); None if the medium is not
            shared.

    Raises:
        ArgumentError: if the node number is out of range.
        UnsupportedError: if the protocol does not allow the configuration.
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
        """Restore the state after power-up; memory and devices keep theirs."""
        self._session.reset()
        self._text_of = text_of(self.info, from_gateway=False)
        self._tail = b""
        self._bytes_lost = False
        self.groups.reset()
        self._commands.reset()

    @property
    def expected(self) -> int:
        """The next expected ID; -1 before the first session since the reset."""
        return self._sequence.expected

    @property
    def session(self) -> int:
        """Number of the current session; 0 for none."""
        return self._session.state.number

    def begin(self, session: int, first: int) -> None:
        """Begin a program's session, as a checked `K` does."""
        self._session.begin(session, first)
        self._commands.start_session(for_program=True)

    # The bus

    @property
    def memory(self) -> MutableMapping[int, int]:
        """Words of plain memory, by address."""
        return self.bus.memory

    def attach(self, device: Device, addresses: Iterable[int]) -> None:
        """Attach a device to addresses; the first address has offset 0.

        Raises:
            ArgumentError: if an address does not fit or has a device, or the object is not a device.
        """
        self.bus.attach(device, addresses)

    def attach_elsewhere(self, device: Device) -> None:
        """Attach a device to all addresses without one, in place of memory; its offsets are the addresses.

        Raises:
            ArgumentError: if the object is not a device.
        """
        self.bus.attach_elsewhere(device)

    def detach(self, addresses: Iterable[int]) -> None:
        """Detach the devices from addresses."""
        self.bus.detach(addresses)

    # Time

    @property
    def send_immediate(self) -> int:
        """Send-immediate mode of responses: 0 off, 1 always, 2 adaptive."""
        return self._commands.send_immediate

    @property
    def flush_wanted(self) -> bool:
        """True after a sample that requests a flush (group flag bit 2) was sent; the medium clears it at the flush."""
        return self.groups.ring.flush_wanted

    @flush_wanted.setter
    def flush_wanted(self, wanted: bool) -> None:
        self.groups.ring.flush_wanted = wanted

    @property
    def waiting(self) -> int:
        """Number of unprocessed bytes: always 0."""
        return 0

    @property
    def next_due(self) -> float | None:
        """Time at which the next sample is due, or at which the model checks for room for a pending sample."""
        return self.groups.next_due

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Advance to the time `now` in seconds, and return the samples to send, while there is `room`."""
        self.groups.clock.start(now)
        return self.groups.advance(now, math.inf if room is None else room)

    def ticks_at(self, now: float) -> int:
        """Return the number of clock cycles from the gateway's reset to a time in seconds."""
        return self.groups.clock.ticks_at(now)

    def trigger(self, now: float, group: int | None = None) -> None:
        """Apply a rising edge to the external trigger of a group, or of all; the next call returns the samples."""
        self.groups.clock.start(now)
        self.groups.trigger(now, group)
        self.wake()

    # Frames

    def receive(self, data: bytes, now: float) -> bytes:
        """Process bytes received at the time `now` in seconds, and return the bytes to send."""
        # While samples are pending there is no room for them; `advance` set this limit.
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
        """Lose bytes before the next received byte: the gateway answers their frame with error 09."""
        self._bytes_lost = True

    def _take_checked(self, lines: list[bytes], now: float, replies: list[bytes]) -> None:
        """Process frames that all end with LF."""
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
        """Process frames that end with CR or LF; return the bytes after the last end."""
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

    def _frame(self, body: bytes, plain: bool) -> bytes:  # noqa: FBT001  (callers pass it by position)
        if plain:
            return self._framing.plain_reply(body)
        state = self._session.state
        frame = self._framing.checked(body, state.seeds[1] if in_session(body[0]) else 0)
        return self._packer.pack_one(frame) if state.compact else frame

    def _answer(self, line: bytes, now: float, *, plain: bool) -> bytes:
        """Return the reply to a frame, after the samples that must be sent before it."""
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
        """Execute a broadcast frame, which no node answers; only a posted write without ID is executed."""
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

    # The shorter path for single words

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
        """Return the reply to a frame, or None if the shorter path does not apply.

        Args:
            line: the frame without its end.
            head: number of letters of the command.
            answer: returns the reply for the fields, which it gets as one number.
        """
        if self._sequence.expected < 0:
            return None
        digits = self._crc_digits
        check = self._crc_text(line[:-digits], self._session.state.seeds[0])
        if check != line[-digits:]:
            return None if check == line[-digits:].upper() else self._damage_reply
        # An X as the second digit is invalid, but int() would accept the prefix 0X.
        if not line.isalnum() or line[head + 1] in b"xX":
            return None
        try:
            fields = int(line[head:-digits], 16)
        except ValueError:
            return None
        return answer(fields)

    def _quick_read(self, fields: int) -> bytes | None:
        """Return the reply to `r` of plain memory, also out of sequence; None if the shorter path does not apply."""
        number, address = fields >> self._address_shift, fields & self._address_field
        sequence = self._sequence
        if address > self._last_address or address in self.bus.devices:
            return None
        ahead = number - sequence.expected & sequence.mask
        if not ahead:
            sequence.advance()
        elif ahead <= sequence.mask >> 1:
            is_reported, sequence.gap_reported = sequence.gap_reported, True
            if is_reported:
                return b""
            return self._framing.checked(self._codec.out_of_sequence(sequence.expected), self._session.state.seeds[1])
        elif sequence.outcome(number):
            return None
        body = self._word_form % (self._codec.id_text[number], self.bus.memory[address])
        return b"%b%b\n" % (body, self._crc_text(body, self._session.state.seeds[1]))

    def _quick_write(self, fields: int) -> bytes | None:
        """Return the reply to `w` of plain memory with the expected ID; None if the shorter path does not apply."""
        number = self._sequence.expected
        if self._quick_post(fields) is None:
            return None
        body = b"w" + self._codec.id_text[number]
        return b"%b%b\n" % (body, self._crc_text(body, self._session.state.seeds[1]))

    def _quick_post(self, fields: int) -> bytes | None:
        """Execute `ws` of plain memory with the expected ID, which has no reply; None as in `_quick_write`."""
        rest, word = fields >> self._data_shift, fields & self._data_field
        number, address = rest >> self._address_shift, rest & self._address_field
        fits = address <= self._last_address and word <= self._last_word
        if number != self._sequence.expected or not fits or address in self.bus.devices:
            return None
        self._sequence.advance()
        dict.__setitem__(self.bus.memory, address, word)
        return b""


def _do_nothing() -> None:
    """Do nothing; the default of `wake`."""


def _node_number(prefix: bytes) -> int | None:
    """Return the number in a prefix of `Z` and two hex digits; None if the prefix has another form."""
    if len(prefix) != _PREFIX_SIZE or prefix[:1] != b"Z" or not prefix[1:].isalnum():
        return None
    try:
        return int(prefix[1:], 16)
    except ValueError:
        return None
