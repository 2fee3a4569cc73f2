"""One client: what comes over its connection goes to its conversation."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.bridges.serve.connection import ClientConnection
from unity_link.bridges.serve.conversation import Conversation

if TYPE_CHECKING:
    from unity_link.bridges.serve.shared import SharedLink


class Client(ClientConnection):
    """A program that shares the link.

    Args:
        shared: the link that it shares with others.
    """

    def __init__(self, shared: SharedLink) -> None:
        super().__init__(shared)
        self._conversation: Conversation | None = None
        """None before it has said anything that could be understood."""
        self._rest = b""

    def data_received(self, data: bytes) -> None:
        """Take what the client says; before the gateway has said what it is, nothing of it could be understood."""
        codec = self._shared.codec
        if codec is None:
            return
        if self._conversation is None:
            self._conversation = Conversation(self, self._shared, codec)
        self._rest += data
        if self.listening:
            self._read()

    def _read(self) -> None:
        if self._conversation is not None and self._rest:
            data, self._rest = self._rest, b""
            self._rest = self._conversation.read(data)
            self._shared.turns.join(self.queue)

    def lose_session(self) -> None:
        """Answer for a reset of the gateway; all waiting requests end but those that need no session."""
        if self._conversation is not None:
            self._conversation.reset()
        super().lose_session()
