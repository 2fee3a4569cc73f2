"""The trial of the line: a host tests if its line carries the compact form (docs/protocol.md, "The trial of the line").

1. After the session is opened, the host sends several ``h`` in compact form, which execute nothing.
2. Their IDs are chosen so that requests and answers contain the bytes that lines often change, such as XON and XOFF.
3. The IDs are in the half of the sequence space before the first ID, so the gateway answers them as repetitions.
4. The trial has passed when each ``h`` is answered undamaged. Unanswered ones are sent again, `TRIALS` times at most.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from unity_link.protocol.wire.compact import CompactForm, Packer, Unpacker
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.crc import seed_of
from unity_link.protocol.wire.frames import LF, FrameError
from unity_link.protocol.wire.messages import ErrorCode

if TYPE_CHECKING:
    from unity_link.protocol.host.host_codec import HostCodec
    from unity_link.protocol.wire.configuration import GatewayInfo

FIRST_IDS: Final = {2: range(0x14, 0x54), 3: range(0x132, 0x800)}
"""First IDs of sessions with a trial, by the digits of an ID; `IDS` are in the half of all IDs before them."""
# With three digits, the last two digits of an ID are one byte of the request, and the first two one byte of the answer.
# 11 (XON) comes last in both directions, because it restarts a line that 13 (XOFF) has stopped.
IDS: Final = {2: (0x00, 0xD3, 0xFF, 0x13, 0x11), 3: (0x000, 0x0D3, 0xFFF, 0x113, 0x131, 0x011, 0x110)}
ID_ALONE: Final = {2: 0x13, 3: 0x113}
"""ID of the request if only one is sent."""
_KEPT_ERRORS: Final = [b"%02X" % code for code in (ErrorCode.BUS_ERROR, ErrorCode.BUS_TIMEOUT, ErrorCode.OUT_OF_RANGE)]


def first_id(choice: int, info: GatewayInfo) -> int:
    """Return the first ID of a session that begins with a trial, chosen by a random number from 0 on."""
    firsts = FIRST_IDS[info.id_digits]
    return firsts[choice % len(firsts)]


class Trial:
    """The trial of the line in one session.

    Args:
        codec: message codec of the gateway.
        session: number of the session, which has just begun.
        takes_turns: True if nodes share the line, so that only one request is sent.
    """

    def __init__(self, codec: HostCodec, session: int, *, takes_turns: bool) -> None:
        info = codec.info
        self._framing = codec.framing
        self._seed_back = seed_of(session, from_gateway=True)
        self._unpacker = Unpacker(CompactForm.of(info, from_gateway=True))
        packer = Packer(CompactForm.of(info, from_gateway=False))
        seed = seed_of(session, from_gateway=False)
        frames = {number: packer.pack_one(codec.request("H", number, b"", seed)) for number in IDS[info.id_digits]}
        size = sum(map(len, frames.values()))
        has_room = Feature.FLOW_CONTROL in info.features or size <= info.receive_fifo_bytes
        if takes_turns or Feature.HALF_DUPLEX in info.features or not has_room:
            frames = {ID_ALONE[info.id_digits]: frames[ID_ALONE[info.id_digits]]}
        self._unanswered = {codec.id_text[number]: frame for number, frame in frames.items()}
        """Requests without an undamaged answer, by the text of their ID."""
        self._fields = [b"h", b"0" * info.id_digits], *([b"x", code] for code in _KEPT_ERRORS)
        self._awaited = 0
        """Number of answers to the last burst that have not arrived; damaged answers count as arrived."""
        self._rest = b""

    @property
    def has_passed(self) -> bool:
        """True if each request has an undamaged answer."""
        return not self._unanswered

    @property
    def is_answered(self) -> bool:
        """True if as many answers arrived as requests were sent; those still missing arrived damaged."""
        return self._awaited <= 0

    def frames(self) -> bytes:
        """Return the frames of the requests without an undamaged answer, to send them together."""
        self._awaited = len(self._unanswered)
        return b"".join(self._unanswered.values())

    def receive(self, data: bytes) -> None:
        """Take bytes of the gateway, cut anywhere."""
        *lines, self._rest = (self._rest + self._unpacker.unpack(data)).split(LF)
        for line in filter(None, lines):
            self._awaited -= 1
            try:
                body = self._framing.open(line, self._seed_back)
            except FrameError:
                continue
            after = 1 + len(next(iter(self._unanswered), b""))
            if not line.endswith(b"\r") and [body[:1], body[after:]] in self._fields:
                self._unanswered.pop(body[1:after], None)
