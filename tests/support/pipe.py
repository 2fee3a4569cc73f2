"""Two connected ends in this process, with noise in each direction."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.transport.pipe import PipeEnd, connect_pipe

if TYPE_CHECKING:
    import asyncio

    from unity_link.virtual.faults import Noise


class NoisyEnd(PipeEnd):
    """An end that spoils each write by noise."""

    def __init__(self, protocol: asyncio.Protocol, noise: Noise | None) -> None:
        super().__init__(protocol)
        self._noise = noise

    def write(self, data: bytes | bytearray | memoryview) -> None:
        super().write(data if self._noise is None else b"".join(self._noise.spoil(bytes(data))))


def connect(
    one: asyncio.Protocol, other: asyncio.Protocol, there: Noise | None = None, back: Noise | None = None
) -> PipeEnd:
    """Connect two protocols; return the transport of the first."""
    end = NoisyEnd(one, there)
    connect_pipe(end, NoisyEnd(other, back))
    return end
