"""Base class of the package's own transports: the protocol, and flow control in both directions."""

from __future__ import annotations

import asyncio

HIGH_WATER, LOW_WATER = 65_536, 16_384
"""Numbers of unwritten bytes: above the first the protocol must pause writing, at the second it may resume."""


class BufferedTransport(asyncio.Transport):
    """A transport with a buffer in each direction.

    A derived class returns the number of unwritten bytes, calls `_pause_writing_if_full` after it grew and
    `_resume_writing_if_calm` after it fell, and delivers received bytes only while `is_reading`.

    Args:
        protocol: receives the bytes.
        extra: values for `get_extra_info`.
    """

    def __init__(self, protocol: asyncio.Protocol, extra: dict[str, object] | None = None) -> None:
        super().__init__(extra)
        self._loop = asyncio.get_running_loop()
        self._protocol = protocol
        self._reading = True
        self._closing = False
        self._writing_paused = False

    def set_protocol(self, protocol: asyncio.BaseProtocol) -> None:
        """Deliver received bytes to another protocol from now on."""
        assert isinstance(protocol, asyncio.Protocol)
        self._protocol = protocol

    def get_protocol(self) -> asyncio.BaseProtocol:
        """Return the protocol that receives the bytes."""
        return self._protocol

    def get_write_buffer_size(self) -> int:
        """Return the number of unwritten bytes."""
        raise NotImplementedError

    def get_write_buffer_limits(self) -> tuple[int, int]:
        """Return the low and the high limit of unwritten bytes."""
        return LOW_WATER, HIGH_WATER

    def can_write_eof(self) -> bool:
        """Return False: the protocol of gateways has no end of a stream."""
        return False

    def pause_reading(self) -> None:
        """Stop delivering until `resume_reading`; received bytes are buffered up to a limit."""
        self._reading = False

    def is_reading(self) -> bool:
        """Return True if received bytes are delivered."""
        return self._reading and not self._closing

    def is_closing(self) -> bool:
        """Return True if the transport is closing or closed."""
        return self._closing

    def _pause_writing_if_full(self) -> None:
        if not self._writing_paused and self.get_write_buffer_size() > HIGH_WATER:
            self._writing_paused = True
            self._protocol.pause_writing()

    def _resume_writing_if_calm(self) -> None:
        if self._writing_paused and self.get_write_buffer_size() <= LOW_WATER:
            self._writing_paused = False
            self._protocol.resume_writing()
