"""The common part of the transports of this package: who is delivered to, and when which side has to pause."""

from __future__ import annotations

import asyncio

HIGH_WATER, LOW_WATER = 65_536, 16_384
"""Unwritten bytes above which the protocol is asked to pause writing, and down to which it may go on."""


class BufferedTransport(asyncio.Transport):
    """A transport with a buffer in each direction.

    What derives from it says how many bytes are not written yet, calls `_pause_writing_if_full` when there are more and
    `_resume_writing_if_calm` when there are fewer, and delivers only while `is_reading`.

    Args:
        protocol: reads and writes.
        extra: what `get_extra_info` tells.
    """

    def __init__(self, protocol: asyncio.Protocol, extra: dict[str, object] | None = None) -> None:
        super().__init__(extra)
        self._loop = asyncio.get_running_loop()
        self._protocol = protocol
        self._reading = True
        self._closing = False
        self._writing_paused = False

    def set_protocol(self, protocol: asyncio.BaseProtocol) -> None:
        """Deliver to another protocol."""
        assert isinstance(protocol, asyncio.Protocol)
        self._protocol = protocol

    def get_protocol(self) -> asyncio.BaseProtocol:
        """Return the protocol that is delivered to."""
        return self._protocol

    def get_write_buffer_size(self) -> int:
        """Return how many bytes are not written yet."""
        raise NotImplementedError

    def get_write_buffer_limits(self) -> tuple[int, int]:
        """Return the levels at which the protocol may write again, and must pause."""
        return LOW_WATER, HIGH_WATER

    def can_write_eof(self) -> bool:
        """Return False: a gateway knows no end of a stream."""
        return False

    def pause_reading(self) -> None:
        """Deliver nothing until `resume_reading`; what arrives is kept, as far as there is room."""
        self._reading = False

    def is_reading(self) -> bool:
        """Return whether what arrives is delivered."""
        return self._reading and not self._closing

    def is_closing(self) -> bool:
        """Return whether the end was asked for, or has come."""
        return self._closing

    def _pause_writing_if_full(self) -> None:
        if not self._writing_paused and self.get_write_buffer_size() > HIGH_WATER:
            self._writing_paused = True
            self._protocol.pause_writing()

    def _resume_writing_if_calm(self) -> None:
        if self._writing_paused and self.get_write_buffer_size() <= LOW_WATER:
            self._writing_paused = False
            self._protocol.resume_writing()
