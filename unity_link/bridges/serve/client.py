"""One client: it passes the bytes from a connection to the client protocol."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.bridges.serve.connection import ClientConnection
from unity_link.bridges.serve.conversation import Conversation

if TYPE_CHECKING:
    from unity_link.bridges.serve.shared import SharedLink


class Client(ClientConnection):
    """A program that shares the link.

    Args:
        shared: the link that the clients share.
    """

    def __init__(self, shared: SharedLink) -> None:
        super().__init__(shared)
        self._conversation: Conversation | None = None
        """None until data arrives while the codec is known."""
        self._rest = b""

    def data_received(self, data: bytes) -> None:
        """Process data of the client. Discard it if the gateway's configuration, and so the codec, is not known yet."""
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
        """Report a reset of the gateway: all waiting requests end, except those that need no session."""
        if self._conversation is not None:
            self._conversation.reset()
        super().lose_session()
