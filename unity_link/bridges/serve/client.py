"""One client: its frames, the order of its requests and of their answers, and what it has set up.

To its client, a `Client` is a gateway that has just been reset. It checks frames and their sequence as every gateway
does (`unity_link.wire.reception`), hands on what is the next to be executed, and answers everything else itself.
Answers leave in the order of the requests, also where those of the gateway arrive in another.

Nothing grows. A client whose requests and their answers would take more than `MOST_UNDER_WAY` bytes, or that does not
read, is not listened to until that has changed; samples that it does not read are lost to it.
"""

from __future__ import annotations

import asyncio
from collections import deque
from typing import TYPE_CHECKING

import numpy as np

from unity_link.bridges.serve.groups import ClientGroup
from unity_link.bridges.serve.requests import Relayed, RelayedRows, Said, answer_digits
from unity_link.bridges.serve.turns import Queue
from unity_link.wire.frames import LF
from unity_link.wire.messages import COMMANDS, Codec, ErrorCode, Repetition, Request, RequestError
from unity_link.wire.reception import Place, Reception, Sequence, group_fits

if TYPE_CHECKING:
    from unity_link.bridges.serve.groups import Slot
    from unity_link.bridges.serve.shared import SharedLink

MOST_UNDER_WAY = 65_536
"""Bytes of requests and answers under way for one client, beyond which it is not listened to."""
FEWEST_ROWS = 8
"""Requests side by side that are worth a turn of numpy."""
MOST_UNSENT = 65_536
"""Bytes that wait for the client to read them, beyond which it is slow."""
ADAPTIVE = 2
_HEX = b"0123456789ABCDEF"
_IS_HEX = np.zeros(256, np.bool_)
_IS_HEX[list(_HEX)] = True
_R, _W = b"rw"


class Client(asyncio.Protocol):
    """One connection.

    Args:
        shared: the link that it shares with others.
    """

    def __init__(self, shared: SharedLink) -> None:
        self.queue = Queue()
        self.groups: dict[int, ClientGroup] = {}
        self.mode = ADAPTIVE
        """The send-immediate mode that it asks for."""
        self.samples_dropped = 0
        """Samples that it did not read in time."""
        self._shared = shared
        self._codec: Codec | None = None
        self._transport: asyncio.Transport | None = None
        self._rest = b""
        self._pending: deque[Relayed | RelayedRows | Said] = deque()
        self._under_way = 0
        self._out: list[bytes] = []
        self._flushing = False
        self._slow = False
        self._listening = True
        self._said_all = False

    def _meet(self, codec: Codec) -> None:
        """Begin, now that it is known what the gateway is."""
        self._codec = codec
        self._framing = codec.framing
        self._reception = Reception(codec)
        self._sequence = Sequence(codec.ring)
        self._awaited = bytearray(codec.ring)
        self._most_kept = self._reception.longest + 1
        self._prepare_short_way(codec)

    # Called by the transport

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Join those who share the link."""
        assert isinstance(transport, asyncio.Transport)
        self._transport = transport
        transport.set_write_buffer_limits(high=MOST_UNSENT)
        self._shared.join(self)

    def data_received(self, data: bytes) -> None:
        """Take what the client says; before the gateway has said what it is, nothing of it could be understood."""
        codec = self._shared.codec
        if codec is None:
            return
        if self._codec is None:
            self._meet(codec)
        self._rest += data
        if self._listening:
            self._read()

    def pause_writing(self) -> None:
        """Take note that the client does not read."""
        self._slow = True
        self._listen()

    def resume_writing(self) -> None:
        """Take note that it does again."""
        self._slow = False
        self._listen()

    def eof_received(self) -> bool:
        """Take note that the client has said all, as a pipe into a socket does: what it asked is still answered."""
        self._said_all = True
        self._wake()
        return True

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002  (why it has gone changes nothing)
        """Leave: nothing of it is sent any more, and what it has set up ends."""
        self._transport = None
        for request in self._shared.turns.leave(self.queue):
            if isinstance(request, Relayed):
                self._over(request)
        for entry in self._pending:
            if isinstance(entry, Relayed):
                entry.sent = False
            if not isinstance(entry, Said):
                entry.given_up = True
        self._shared.turns.forget(self.queue)
        self._pending.clear()
        self._shared.leave(self)

    def hang_up(self) -> None:
        """End the connection."""
        if self._transport is not None:
            self._transport.abort()

    def _listen(self) -> None:
        """Listen to the client, or not, as far as there is room for what it will say."""
        listening = not self._slow and self._under_way < MOST_UNDER_WAY
        if listening == self._listening or self._transport is None:
            return
        self._listening = listening
        if listening:
            self._transport.resume_reading()
            self._read()
        else:
            self._transport.pause_reading()

    # Frames

    def _read(self) -> None:
        """Take all whole frames, or as many as there is room for."""
        data, self._rest = self._rest, b""
        start, batched, typed = 0, True, b"\r" in data
        while self._listening:
            if batched:
                # Looked for at the start of a read and behind what interrupts a batch, not at each line.
                before, start = start, self._take_rows(data, start)
                batched = start != before
                continue
            end = data.find(b"\n", start)
            plain = typed and (found := data.find(b"\r", start, end if end >= 0 else len(data))) >= 0
            end = found if plain else end
            if end < 0:
                break
            line = data[start:end]
            start = end + 1
            if plain or not self._relay_quickly(line):
                self._take(line, plain=plain)
                batched = not plain
        rest = data[start:]
        self._rest = rest[: self._most_kept] if self._listening else rest
        self._shared.turns.join(self.queue)

    def _take(self, line: bytes, *, plain: bool) -> None:
        """Take one frame."""
        if not line:
            return
        codec = self._known
        try:
            request = self._reception.read(line, plain=plain)
        except RequestError as refusal:
            self._say(codec.error(refusal.code), plain=plain)
            return
        if request.command == "Q":
            # Who asks while the gateway is away asks again; an answer would promise too much.
            if not self._shared.away:
                self._say(b"Q" + codec.info.to_hex(), plain=plain)
        elif request.command == "K":
            self._start_session(request, plain=plain)
        elif request.id is None:
            self._execute(request, plain=plain)
        else:
            self._in_sequence(request, request.id, plain=plain)

    @property
    def _known(self) -> Codec:
        assert self._codec is not None
        return self._codec

    def _start_session(self, request: Request, *, plain: bool) -> None:
        self._sequence.start(request.values[0])
        # What is under way belongs to the session before.
        self._awaited = bytearray(len(self._awaited))
        for group in self.groups.values():
            self._stop(group)
        self._choose_mode(ADAPTIVE)
        self._say(self._known.response(request), plain=plain)

    def _in_sequence(self, request: Request, number: int, *, plain: bool) -> None:
        """Hand on the next request, and no other (protocol section 3)."""
        codec, place = self._known, self._sequence.place(number)
        if place is Place.NEXT:
            self._execute(request, plain=plain)
        elif place is Place.FIRST_AHEAD:
            self._say(codec.out_of_sequence(self._sequence.expected), plain=plain)
        elif place is Place.REPETITION and self._awaited[number]:
            # Its answer will come, for nothing is lost between the client and here; till then, a sign of life.
            self._write(LF)
        elif place is Place.REPETITION:
            self._repeat(request, number, plain=plain)

    def _repeat(self, request: Request, number: int, *, plain: bool) -> None:
        """Answer a request that was executed before."""
        codec, repetition = self._known, COMMANDS[request.command].repetition
        if repetition is Repetition.READ_AGAIN:
            self._execute(request, plain=plain)
        elif repetition is Repetition.REFUSE:
            self._say(codec.error(ErrorCode.ALREADY_EXECUTED, number), plain=plain)
        elif repetition is Repetition.ACKNOWLEDGE:
            self._say(codec.response(request), plain=plain)

    # Requests

    def _execute(self, request: Request, *, plain: bool) -> None:
        """Hand a request on, or do it where it is about what only this client sees."""
        command, values = request.command, request.values
        if command == "GS":
            self._set_up_group(request, plain=plain)
        elif command in ("GN", "GX", "GP"):
            self._change_group(request, plain=plain)
        elif command == "I":
            self._send_immediate(request, plain=plain)
        else:
            codec = self._known
            count = values[1] if command in ("RM", "RQ") else 1
            digits = answer_digits(codec, command, count)
            self._relay(request, codec.fields(command, *values), digits, plain=plain)

    def _relay(self, request: Request, fields: bytes, digits: int | None, *, plain: bool) -> Relayed:
        codec = self._known
        head = codec.response(request)
        relayed = Relayed(codec, request.command, fields, digits, self, head, request.id, plain=plain)
        self._hand_on(relayed)
        return relayed

    def _relay_silently(self, command: str, fields: bytes) -> Relayed:
        """Have a request done that the client did not ask for; what it asks for next is answered behind it."""
        relayed = Relayed(self._known, command, fields, 0, self, b"")
        relayed.silent = True
        self._hand_on(relayed)
        return relayed

    def _hand_on(self, relayed: Relayed) -> None:
        self._under_way += relayed.cost
        if not relayed.posted:
            if relayed.number is not None:
                self._awaited[relayed.number] = 1
                relayed.awaited = self._awaited
            self._pending.append(relayed)
        if self._shared.away:
            relayed.refuse()
            return
        self.queue.requests.append(relayed)
        if self._under_way >= MOST_UNDER_WAY:
            self._listen()

    def refuse_all(self) -> None:
        """Tell the client that the gateway is away; nothing that it waits for will be executed any more."""
        dropped = self._shared.turns.leave(self.queue)
        for entry in (*self._pending, *dropped):
            if isinstance(entry, RelayedRows) or (isinstance(entry, Relayed) and entry.reply is None):
                entry.refuse()

    # The short way for single words

    def _prepare_short_way(self, codec: Codec) -> None:
        info = codec.info
        self._read_size = 1 + info.id_digits + info.address_digits + codec.framing.crc.digits
        self._write_size = self._read_size + info.data_digits
        self._data_digits = info.data_digits
        self._crc_text = codec.framing.crc.text
        self._crc_digits = codec.framing.crc.digits
        self._id_digits = info.id_digits
        self._id_number = codec.id_number

    def _take_rows(self, data: bytes, start: int) -> int:
        """Hand on the reads or writes of one word that stand side by side; give where they end."""
        letter = data[start : start + 1]
        if letter == b"r":
            command, size, digits = "R", self._read_size + 1, self._data_digits
        elif letter == b"w":
            command, size, digits = "W", self._write_size + 1, 0
        else:
            return start
        codec, expected = self._known, self._sequence.expected
        last = start + (FEWEST_ROWS - 1) * size
        number = codec.id_text[expected + FEWEST_ROWS - 1 & self._sequence.mask]
        if data[last : last + 1 + self._id_digits] != letter + number or self._shared.away:
            return start
        room = (MOST_UNDER_WAY - self._under_way) // (2 * size) + FEWEST_ROWS
        count = min((len(data) - start) // size, room, codec.ring // 2)
        head = 1 + self._id_digits
        width = size - head - self._crc_digits - 1
        fields = codec.matching_rows(command, expected, data[start : start + count * size], width)
        good = _IS_HEX[fields].all(axis=1)
        count = len(fields) if good.all() else int(good.argmin())
        if not count:
            return start
        self._sequence.advance(count)
        self._hand_on_rows(RelayedRows(codec, command, fields[:count], digits, self, expected))
        return start + count * size

    def _hand_on_rows(self, rows: RelayedRows) -> None:
        self._under_way += rows.cost * rows.count
        self._mark(rows.number, rows.count, self._awaited, 1)
        rows.awaited = self._awaited
        self._pending.append(rows)
        self.queue.requests.append(rows)
        if self._under_way >= MOST_UNDER_WAY:
            self._listen()

    @staticmethod
    def _mark(first: int, count: int, awaited: bytearray, value: int) -> None:
        """Note of consecutive IDs whether they are under way."""
        before_wrap = min(count, len(awaited) - first)
        awaited[first : first + before_wrap] = bytes([value]) * before_wrap
        awaited[: count - before_wrap] = bytes([value]) * (count - before_wrap)

    def _relay_quickly(self, line: bytes) -> bool:
        """Hand on `r`, `w` or `ws` with the expected ID in the usual spelling, or leave it to the long way."""
        size = len(line)
        if size == self._read_size and line[0] == _R:
            head, command, digits = 1, "R", self._data_digits
        elif size == self._write_size and line[0] == _W:
            head, command, digits = 1, "W", 0
        else:
            return False
        body = line[: -self._crc_digits]
        after = head + self._id_digits
        number = self._id_number.get(line[head:after])
        sequence = self._sequence
        if number != sequence.expected or self._crc_text(body) != line[-self._crc_digits :]:
            return False
        fields = body[after:]
        if fields.translate(None, _HEX):
            return False
        sequence.advance()
        self._hand_on(Relayed(self._known, command, fields, digits, self, line[:after], number))
        return True

    # Groups

    def _set_up_group(self, request: Request, *, plain: bool) -> None:
        number, flags, divisor, _, addresses = request.values
        if not group_fits(self._known.info, number, flags, divisor, addresses):
            self._refuse(request, plain=plain)
            return
        group = self.groups.setdefault(number, ClientGroup(number, self))
        group.set_up(self._known, flags, divisor, addresses)
        if group.slot is None:
            self._say(self._known.response(request), plain=plain)
        else:
            self._shared.slots.silence(group.slot)
            self._name(group.slot, self._relay(request, group.slot.text + group.settings, 0, plain=plain))

    def _change_group(self, request: Request, *, plain: bool) -> None:
        group = self.groups.get(request.values[0])
        if group is None:
            self._refuse(request, plain=plain)
            return
        slot = group.slot
        if slot is None and request.command == "GX":
            self._say(self._known.response(request), plain=plain)
            return
        if slot is None and (slot := self._shared.slots.take(group)) is not None:
            group.begin_anew()
            self._name(slot, self._relay_silently("GS", slot.text + group.settings))
        if slot is None:
            self._refuse(request, plain=plain)
            return
        if request.command == "GX":
            group.running = False
        else:
            group.running = group.running or request.command == "GN"
            self._shared.slots.listen(slot)
        self._name(slot, self._relay(request, slot.text, 0, plain=plain))

    def _stop(self, group: ClientGroup) -> None:
        """Stop a group without an answer."""
        if group.running and group.slot is not None:
            self._name(group.slot, self._relay_silently("GX", group.slot.text))
        group.running = False

    def _name(self, slot: Slot, relayed: Relayed) -> None:
        """Keep a slot as long as a request names it."""
        if relayed.reply is not None:
            return
        slot.busy += 1

        def over() -> None:
            slot.busy -= 1
            self._shared.slots.settle(slot)

        relayed.after = over

    def sample(self, body: bytes, *, plain: bool) -> None:
        """Send a sample, if the client reads."""
        if self._slow:
            self.samples_dropped += 1
        else:
            self._write(self._frame(body, plain=plain))

    # Send-immediate

    def _send_immediate(self, request: Request, *, plain: bool) -> None:
        mode = request.values[0]
        if mode > ADAPTIVE:
            self._refuse(request, plain=plain)
            return
        self._choose_mode(mode)
        self._say(self._known.response(request), plain=plain)

    def _choose_mode(self, mode: int) -> None:
        self.mode = mode
        wanted = self._shared.change_mode()
        if wanted is not None:
            self._relay_silently("I", b"%02X" % wanted)

    # Answers

    def _refuse(self, request: Request, *, plain: bool) -> None:
        self._say(self._known.error(ErrorCode.OUT_OF_RANGE, request.id), plain=plain)

    def _say(self, body: bytes, *, plain: bool) -> None:
        """Answer without the gateway, behind what is under way."""
        frame = self._frame(body, plain=plain)
        if self._pending:
            self._pending.append(Said(frame))
            self._under_way += len(frame)
        else:
            self._write(frame)

    def answer(self, request: Relayed, body: bytes) -> None:
        """Take the answer to a request that was handed on."""
        if request.reply is not None:
            return
        request.reply = self._frame(body, plain=request.plain) if body and not request.silent else b""
        self._over(request)
        pending = self._pending
        if request.posted:
            # Whoever waits for one behind it learns of its error first.
            self._write(request.reply)
            return
        if pending and pending[0] is request:
            self._answer_on()

    def answer_rows(self, rows: RelayedRows) -> None:
        """Take note of answers to many requests."""
        if self._pending and self._pending[0] is rows:
            self._answer_on()

    def _answer_on(self) -> None:
        """Send what is the next in the order, as far as it is there."""
        pending = self._pending
        while pending:
            entry = pending[0]
            if isinstance(entry, RelayedRows):
                self._write_rows(entry)
                if entry.answered < entry.count:
                    return
            elif entry.reply is None:
                return
            else:
                if isinstance(entry, Said):
                    self._under_way -= len(entry.reply)
                elif entry.awaited is not None and entry.number is not None:
                    entry.awaited[entry.number] = 0
                self._write(entry.reply)
            pending.popleft()

    def _write_rows(self, rows: RelayedRows) -> None:
        first = rows.number + rows.answered & self._sequence.mask
        count, frames = rows.ready()
        if count:
            self._under_way -= count * rows.cost
            self._shared.turns.arrived(self.queue, count * rows.cost)
            self._mark(first, count, rows.awaited, 0)
            self._write(frames)

    def posted(self, request: Relayed) -> None:
        """Take note that a posted write is on its way: unless it fails, nothing more is heard of it."""
        self._under_way -= request.cost
        request.cost = 0
        self._wake()

    def _over(self, request: Relayed) -> None:
        """Forget a request that is answered or dropped."""
        self._under_way -= request.cost
        if request.sent:
            self._shared.turns.arrived(self.queue, request.cost)
        if request.after is not None:
            after, request.after = request.after, None
            after()

    def _frame(self, body: bytes, *, plain: bool) -> bytes:
        return self._framing.plain_reply(body) if plain else self._framing.checked(body)

    def _write(self, frame: bytes) -> None:
        """Send together with all else that is sent in this turn of the event loop."""
        self._out.append(frame)
        self._wake()

    def _wake(self) -> None:
        if not self._flushing:
            self._flushing = True
            self._shared.loop.call_soon(self._flush)

    def _flush(self) -> None:
        """Send, and listen again where that has made room."""
        self._flushing = False
        data = b"".join(self._out)
        self._out.clear()
        if self._transport is not None:
            self._transport.write(data)
            self._listen()
            if self._said_all and not self._pending and not self.queue.requests:
                self._transport.close()
