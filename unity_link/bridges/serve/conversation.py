"""The client protocol: decodes the requests of one client: frames, sequence numbers, groups, send-immediate.

To its client, a `Conversation` is a gateway that has just been reset. It keeps a session as every gateway does
(`unity_link.protocol.gateway.session`), passes on the next requests to be executed, and answers all others itself.
Most traffic is reads and writes of single words. Adjacent ones are checked and passed on together. A single one takes a
shorter path in the code, with the same effect as the general path, or with none before it leaves the request to that.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from unity_link.bridges.serve.groups import ClientGroup, GroupSettings
from unity_link.bridges.serve.leases import ArmRequest
from unity_link.bridges.serve.requests import Relayed, RelayedRows, answer_digits
from unity_link.protocol.gateway.reception import group_fits
from unity_link.protocol.gateway.session import PENDING, Answer, GatewaySession
from unity_link.protocol.wire.arrays import matching_rows
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.frames import LF, in_session
from unity_link.protocol.wire.messages import Codec, DecodedRequest, ErrorCode

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.bridges.serve.connection import ClientConnection
    from unity_link.bridges.serve.groups import Slot
    from unity_link.bridges.serve.leases import Leases
    from unity_link.bridges.serve.shared import SharedLink

FEWEST_ROWS = 8
"""Least number of adjacent requests that are processed together with numpy."""
ADAPTIVE = 2
_DONE_HERE = frozenset({"Q", "K", "GS", "GN", "GX", "GP", "I"})
"""Commands that the server answers itself. The gateway gets requests only if one of its own groups must change."""
_HEX = b"0123456789ABCDEF"
_IS_HEX = np.zeros(256, np.bool_)
_IS_HEX[list(_HEX)] = True
_R, _W = b"rw"


class Conversation:
    """The session of one client.

    Args:
        client: connection of the client.
        shared: the link that the clients share.
        codec: codec of the client's messages.
    """

    def __init__(self, client: ClientConnection, shared: SharedLink, codec: Codec) -> None:
        client.mode = ADAPTIVE
        self._client = client
        self._groups = client.groups
        self._shared = shared
        self._codec = codec
        self._takes_turns = Feature.HALF_DUPLEX in shared.gateway.features
        """True if only one side may send at a time on the gateway's medium."""
        self._session = GatewaySession(codec)
        self._sequence = self._session.sequence
        self._prepare_short_way(codec)

    # Frames

    def read(self, data: bytes) -> bytes:
        """Process all complete frames, or as many as the client may have in flight; return the remaining bytes."""
        start, batched, typed = 0, True, b"\r" in data
        while self._client.listening:
            if batched:
                # Look for adjacent requests at the start of a read and after an interruption, not at each line.
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
        # Keep only as much of a frame that is too long as is needed to detect it.
        return rest[: self._session.most_kept] if self._client.listening else rest

    def _take(self, line: bytes, *, plain: bool) -> None:
        """Process one frame."""
        if not line:
            self._client.spend_here()
            return
        begun = self._session.begun
        taken = self._session.take(line, plain=plain)
        if self._session.begun and not begun:
            self._client.follow_others()
        if not isinstance(taken, DecodedRequest) or taken.command in _DONE_HERE:
            self._client.spend_here()
        if taken is PENDING:
            # The answer will follow, because no bytes are lost between client and server: send a sign of life.
            self._client.write(LF)
        elif not isinstance(taken, Answer):
            self._execute(taken, plain=plain)
        elif taken.body:
            self._say(taken.body, taken.number, plain=plain)

    def reset(self) -> None:
        """End the session and delete the groups, because the gateway was reset."""
        self._session.reset()
        for group in self._groups.values():
            self._shared.slots.forget(group)
        self._groups.clear()
        self._client.mode = ADAPTIVE

    # Requests

    def _execute(self, request: DecodedRequest, *, plain: bool) -> None:
        """Pass a request on, or execute it here if it concerns only this client."""
        command, values = request.command, request.values
        if command == "Q":
            # While the gateway is away, do not answer: the client asks again, and an answer would claim a gateway.
            if not self._shared.away:
                self._say(b"Q" + self._codec.info.to_hex(), plain=plain)
        elif command == "K":
            self._start_session(request, plain=plain)
        elif command == "GS":
            self._set_up_group(request, plain=plain)
        elif command in ("GN", "GX", "GP"):
            self._change_group(request, plain=plain)
        elif command == "I":
            self._send_immediate(request, plain=plain)
        else:
            leases = self._shared.leases
            if leases is not None and self._concerns_lease(leases, request, plain=plain):
                return
            codec = self._codec
            count = values[1] if command in ("RM", "RQ") else 1
            digits = answer_digits(codec, command, count)
            self._relay(request, codec.fields(command, *values), digits, plain=plain)

    def _start_session(self, request: DecodedRequest, *, plain: bool) -> None:
        if not request.values:
            self._say(self._codec.response(request, self._session.state.number), plain=plain)
            return
        for group in self._groups.values():
            if group.slot is not None:
                # Stop the group even if it does not run: none of its samples may follow the answer to this request.
                self._relay_silently("GX", group.slot)
        self._choose_mode(ADAPTIVE)
        self._say(self._codec.response(request, self._session.ended), plain=plain)

    def _relay(
        self,
        request: DecodedRequest,
        fields: bytes,
        digits: int | None,
        *,
        plain: bool,
        after: Callable[[bool], None] | None = None,
        stored: Callable[[], None] | None = None,
    ) -> None:
        codec, command = self._codec, request.command
        head = codec.response(request)
        if command == "WS" and (self._takes_turns or self._client.must_confirm or after is not None):
            # Ask the gateway for an answer: on a half-duplex line its error could collide with the next request; or the
            # number of posted writes in flight must be known. The client only receives errors.
            command, head, digits = "W", b"", 0
        relayed = Relayed(self._shared.to_gateway, command, fields, digits, self._client, head, request.id, plain=plain)
        if command != request.command:
            relayed.stateless = True
            relayed.characters += 1
        relayed.repeated = request.repeated
        relayed.after = after
        relayed.stored = stored
        self._client.hand_on(relayed, self._session.state)

    def _relay_silently(self, command: str, slot: Slot, settings: GroupSettings | None = None) -> None:
        """Change a slot without a request of the client; its next requests are answered after this change."""
        fields = slot.text + (b"" if settings is None else settings.fields)
        relayed = Relayed(self._shared.to_gateway, command, fields, 0, self._client, b"")
        relayed.silent = True
        relayed.after = self._shared.naming(slot, command, settings)
        relayed.stored = None if settings is None else self._shared.slots.storing(slot)
        self._client.hand_on(relayed, self._session.state)

    # Leases

    def _concerns_lease(self, leases: Leases, request: DecodedRequest, *, plain: bool) -> bool:
        """Refuse a request that needs another client's lease, and process an arm; return False for all others."""
        client, codec = self._client, self._codec
        if leases.refuses(client, request, codec.highest_address):
            self._refuse(request, ErrorCode.BUS_ERROR, plain=plain)
            return True
        lease = leases.armed_by(request, codec.highest_address)
        if lease is None or self._shared.away:
            return False

        state = self._session.state

        def relay(over: Callable[[bool], None]) -> None:
            if self._session.state is not state:
                # The gateway was reset, and so was the client's session: a repetition is answered with error 0A.
                over(False)  # noqa: FBT003  (it has no name)
                return
            fields, digits = codec.fields(request.command, *request.values), answer_digits(codec, request.command, 1)
            self._relay(request, fields, digits, plain=plain, after=over)
            self._shared.turns.join(client.queue)

        def refuse(error: ErrorCode) -> None:
            if self._session.state is state:
                self._refuse(request, error, plain=plain)

        finishes = lease.is_to_finish(request, codec.highest_address)
        client.hold()
        self._shared.settle_arm(leases.arm(lease, ArmRequest(client, finishes, relay, refuse)))
        return True

    # The short path for single words

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
        """Pass on adjacent reads or writes of one word; return the position after them."""
        letter = data[start : start + 1]
        if letter == b"r":
            command, size = "R", self._read_size + 1
        elif letter == b"w":
            command, size = "W", self._write_size + 1
        else:
            return start
        codec, expected = self._codec, self._sequence.expected
        if not self._session.begun:
            return start
        last = start + (FEWEST_ROWS - 1) * size
        number = codec.id_text[expected + FEWEST_ROWS - 1 & self._sequence.mask]
        if data[last : last + 1 + self._id_digits] != letter + number or self._shared.away:
            return start
        room = self._client.room // (2 * size) + FEWEST_ROWS
        count = min((len(data) - start) // size, room, codec.id_count // 2)
        head = 1 + self._id_digits
        width = size - head - self._crc_digits - 1
        rows = data[start : start + count * size]
        fields = matching_rows(codec, command, expected, rows, width, self._session.state.seeds[0])
        good = _IS_HEX[fields].all(axis=1)
        leases = self._shared.leases
        if letter == b"w" and leases is not None:
            closed, digits = leases.closed_to(self._client, codec), codec.info.address_digits
            good = good & np.array([row.tobytes() not in closed for row in fields[:, :digits]], np.bool_)
        count = len(fields) if good.all() else int(good.argmin())
        if not count:
            return start
        self._sequence.advance(count)
        relayed = RelayedRows(self._shared.to_gateway, codec, command, fields[:count], self._client, expected)
        self._client.hand_on_rows(relayed, self._session.state)
        return start + count * size

    def _relay_quickly(self, line: bytes) -> bool:
        """Pass on `r`, `w` or `ws` with the expected ID in the usual spelling; return False for the general path."""
        size = len(line)
        digits: int | None = self._data_digits
        if size == self._read_size and line[0] == _R:
            head, command = 1, "R"
        elif size == self._write_size and line[0] == _W:
            head, command, digits = 1, "W", 0
        elif (
            size == self._write_size + 1
            and line[:2] == b"ws"
            and not self._takes_turns
            and not self._client.must_confirm
        ):
            head, command, digits = 2, "WS", None
        else:
            return False
        body = line[: -self._crc_digits]
        after = head + self._id_digits
        number = self._id_number.get(line[head:after])
        sequence = self._sequence
        check = self._crc_text(body, self._session.state.seeds[0])
        if number != sequence.expected or check != line[-self._crc_digits :]:
            return False
        fields = body[after:]
        if fields.translate(None, _HEX):
            return False
        leases = self._shared.leases
        if (
            leases is not None
            and command != "R"
            and fields[: self._codec.info.address_digits] in leases.closed_to(self._client, self._codec)
        ):
            return False
        sequence.advance()
        self._client.hand_on(
            Relayed(self._shared.to_gateway, command, fields, digits, self._client, line[:after], number),
            self._session.state,
        )
        return True

    # Groups

    def _set_up_group(self, request: DecodedRequest, *, plain: bool) -> None:
        number, flags, divisor, _, addresses = request.values
        # Use the gateway's own configuration: the client's lacks features of the medium, which limit groups.
        for_program = self._session.state.for_program
        if not group_fits(self._shared.gateway, number, flags, divisor, addresses, for_program=for_program):
            self._refuse(request, plain=plain)
            return
        settings = GroupSettings(self._codec, flags, divisor, addresses)
        group = self._groups.setdefault(number, ClientGroup(number, self._client, settings))
        group.settings = settings
        group.seed = self._session.state.seeds[1]
        if group.slot is None:
            self._say(self._codec.response(request), request.id, plain=plain)
        else:
            after, stored = self._shared.naming(group.slot, "GS", settings), self._shared.slots.storing(group.slot)
            self._relay(request, group.slot.text + settings.fields, 0, plain=plain, after=after, stored=stored)

    def _change_group(self, request: DecodedRequest, *, plain: bool) -> None:
        group, command = self._groups.get(request.values[0]), request.command
        if group is None:
            self._refuse(request, plain=plain)
            return
        slot, group.seed = group.slot, self._session.state.seeds[1]
        if self._shared.away and command != "GX":
            # No group may begin by itself when the gateway is back.
            self._refuse(request, ErrorCode.BUS_TIMEOUT, plain=plain)
            return
        if slot is None and command == "GX":
            self._say(self._codec.response(request), request.id, plain=plain)
            return
        if slot is None and (slot := self._shared.slots.take(group)) is not None:
            self._relay_silently("GS", slot, group.settings)
        if slot is None:
            self._refuse(request, plain=plain)
            return
        self._relay(request, slot.text, 0, plain=plain, after=self._shared.naming(slot, command))

    # Send-immediate

    def _send_immediate(self, request: DecodedRequest, *, plain: bool) -> None:
        mode = request.values[0]
        if mode > ADAPTIVE:
            self._refuse(request, plain=plain)
            return
        self._choose_mode(mode)
        self._say(self._codec.response(request), request.id, plain=plain)

    def _choose_mode(self, mode: int) -> None:
        self._client.mode = mode
        self._shared.settle_mode()

    # Answers

    def _refuse(self, request: DecodedRequest, error: ErrorCode = ErrorCode.OUT_OF_RANGE, *, plain: bool) -> None:
        if request.id is not None and not request.repeated:
            self._session.state.fail(request.id, error, posted=request.command == "WS")
        self._say(self._codec.error(error, request.id), request.id, plain=plain)

    def _say(self, body: bytes, number: int | None = None, *, plain: bool) -> None:
        """Answer a request in place of the gateway, after the answers to earlier requests.

        In a session, an answer with an ID confirms that all earlier requests were executed. If posted writes are not
        confirmed yet, the answer waits for an ``h`` that the gateway answers after them.
        """
        framing = self._codec.framing
        if self._session.begun and self._client.posts_unconfirmed and body[:1].islower():
            fence = Relayed(self._shared.to_gateway, "H", b"", 0, self._client, body, number, plain=plain)
            self._client.hand_on(fence, self._session.state)
        else:
            self._client.say(framing.plain_reply(body) if plain else framing.checked(body, self._seed(body)))

    def _seed(self, body: bytes) -> int:
        return self._session.state.seeds[1] if in_session(body[0]) else 0
