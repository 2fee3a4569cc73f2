"""A client's requests on their way to the gateway and back.

A `Relayed` is a request in the exchange of the one link, under the ID that the link's window gives it. It remembers the
ID and the form that its client used, so that the answer can be put under that ID again.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from unity_link.errors import GatewayError, Outcome, UnansweredError, UnityLinkError, UnsupportedError
from unity_link.requests import REPEATABLE, Message
from unity_link.wire.messages import COMMANDS, Codec, ErrorCode, Repetition

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.requests import Source


class Asker(Protocol):
    """Who is answered."""

    def answer(self, request: Relayed, body: bytes) -> None:
        """Take the body of the answer to a request; nothing, where it has none."""

    def sent(self, request: Relayed) -> None:
        """Take note that a posted write is on its way."""


def answer_digits(codec: Codec, command: str, count: int) -> int | None:
    """Give the hex digits behind the ID of the answer to a request of so many words; None where nothing answers it."""
    if command == "WS":
        return None
    return codec.info.data_digits * {"": 0, "d": 1, "D": count}[COMMANDS[command].reads]


class Relayed(Message):
    """One request of a client.

    Args:
        codec: the messages of the gateway, and of the client.
        command: in upper case.
        fields: hex digits, as the gateway is to see them.
        digits: hex digits of the answer's data, None where nothing answers.
        asker: who is answered.
        head: what the answer has before its data: command, and ID or echo.
        number: the client's ID, None where it gave none.
        plain: whether the request was a plain frame, and so is its answer.
    """

    __slots__ = ("_asker", "_frame", "after", "awaited", "cost", "fields", "head", "number", "plain", "reply", "silent")

    def __init__(
        self,
        codec: Codec,
        command: str,
        fields: bytes,
        digits: int | None,
        asker: Asker,
        head: bytes,
        number: int | None = None,
        *,
        plain: bool = False,
    ) -> None:
        super().__init__(codec, command, len(fields), digits)
        self.fields = fields
        self.head = head
        self.number = number
        self.plain = plain
        self.silent = False
        """Whether the client did not ask for this, and is not answered."""
        self.cost = self.size + self.reply_size
        """Bytes that it takes of the gateway's line."""
        self.reply: bytes | None = None
        """The frame for the client, once there is one."""
        self.awaited: bytearray | None = None
        """Where its client notes the IDs that are under way."""
        self.after: Callable[[], None] | None = None
        """Called when it is over."""
        self._asker = asker
        self._frame = b""

    def encode(self, offset: int, count: int) -> bytes:  # noqa: ARG002  (a request is a run of one)
        """Give the frame."""
        if not self._frame:
            self._frame = self.codec.request(self.command, self.first, self.fields)
        return self._frame

    def accept(self, offset: int, body: bytes, position: int) -> bool:  # noqa: ARG002
        """Hand on the answer."""
        command = self.codec.lower[self.command]
        if not body.startswith(command) or len(body) + self.codec.framing.overhead != self.reply_size:
            return False
        self._asker.answer(self, self.head + body[position:])
        return True

    def unwanted(self) -> bool:
        """Say whether nobody waits for it any more."""
        return self.given_up

    def fail(self, error: UnityLinkError) -> None:
        """Tell the client what the protocol has words for."""
        code = _code_of(error, self.command)
        self._asker.answer(self, self.head if code is None else self.codec.error(code, self.number))

    def refuse(self) -> None:
        """End it without an answer of the gateway: nothing on the bus answered."""
        self.given_up = True
        self._asker.answer(self, self.codec.error(ErrorCode.BUS_TIMEOUT, self.number))

    def fields_at(self, offset: int) -> bytes:  # noqa: ARG002
        """Give the fields."""
        return self.fields

    def again(self, offset: int, count: int) -> Source | None:  # noqa: ARG002
        """Give the request itself where it changes nothing."""
        if self.command not in REPEATABLE:
            return None
        self._frame = b""
        return self

    # A request is a source of itself, when a new session takes it again.

    def least(self) -> int:
        """Give one."""
        return 1

    def take(self, room: int) -> Message:  # noqa: ARG002
        """Give the request itself."""
        if self.posted:
            self._asker.sent(self)
        return self

    def exhausted(self) -> bool:
        """Say that one turn is enough."""
        return True


def _code_of(error: UnityLinkError, command: str) -> ErrorCode | None:
    """Give the error that a client is told, None where it is told that its request was executed.

    A link that ends may leave open whether a request was executed. The nearest that the protocol has is 05: nothing on
    the bus answered.
    """
    if isinstance(error, GatewayError):
        return ErrorCode(error.code) if error.code in set(ErrorCode) else ErrorCode.BUS_ERROR
    if isinstance(error, UnsupportedError):
        return ErrorCode.UNKNOWN_COMMAND
    if isinstance(error, UnansweredError) and error.outcome is Outcome.EXECUTED:
        refused = COMMANDS[command].repetition is Repetition.REFUSE
        return ErrorCode.ALREADY_EXECUTED if refused else None
    return ErrorCode.BUS_TIMEOUT


class Said:
    """An answer that needs nothing of the gateway, in line behind those that do."""

    __slots__ = ("reply",)

    def __init__(self, reply: bytes) -> None:
        self.reply = reply
