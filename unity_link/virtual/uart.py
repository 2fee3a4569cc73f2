"""The bytes that a UART receives from another UART with a different baud rate.

The idle line is high. A byte consists of a low start bit, eight data bits, lowest first, and a high stop bit. The
receiver waits for a falling edge, and then samples the line in the middle of each bit by its own baud rate. If the stop
bit is low, it still delivers the byte, as Linux does for a port in raw mode.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.virtual.gateway import Gateway

if TYPE_CHECKING:
    from collections.abc import Callable, MutableMapping

_DATA_BITS = 8


def hear(data: bytes, sent_at: float, heard_at: float) -> bytes:
    """Return the bytes that a UART receives when another one sends bytes without pauses.

    Args:
        data: the sent bytes.
        sent_at: baud rate of the sender.
        heard_at: baud rate of the receiver.
    """
    levels = [1]
    for byte in data:
        levels += [0, *(byte >> bit & 1 for bit in range(_DATA_BITS)), 1]
    ratio = sent_at / heard_at
    heard = bytearray()
    place = 0
    while (edge := _falling_edge(levels, place)) is not None:
        bits = (_level(levels, edge + (1.5 + bit) * ratio) << bit for bit in range(_DATA_BITS))
        heard.append(sum(bits))
        place = int(edge + 9.5 * ratio)
    return bytes(heard)


def _falling_edge(levels: list[int], start: int) -> int | None:
    for place in range(max(start, 0) + 1, len(levels)):
        if levels[place - 1] and not levels[place]:
            return place
    return None


def _level(levels: list[int], time: float) -> int:
    place = int(time)
    return levels[place] if place < len(levels) else 1


class UartLine(Gateway):
    """A gateway with a UART; the host's port may have another baud rate.

    Args:
        gateway: the gateway.
        baud: baud rate of the gateway's UART.
        port_baud: returns the baud rate of the host's port.
    """

    def __init__(self, gateway: Gateway, baud: float, port_baud: Callable[[], float]) -> None:
        self.info = gateway.info
        self.wake: Callable[[], None] = lambda: None
        gateway.wake = self._pass_on_wake
        self._gateway = gateway
        self._baud = baud
        self._port_baud = port_baud

    def _pass_on_wake(self) -> None:
        self.wake()

    @property
    def memory(self) -> MutableMapping[int, int]:
        """Words of the gateway's memory, by address."""
        return self._gateway.memory

    @property
    def next_due(self) -> float | None:
        """Time at which the gateway has something to do."""
        return self._gateway.next_due

    @property
    def waiting(self) -> int:
        """Number of unprocessed bytes in the gateway."""
        return self._gateway.waiting

    def receive(self, data: bytes, now: float) -> bytes:
        """Send bytes to the gateway at the time `now` in seconds, and return the bytes that the host receives."""
        port = self._port_baud()
        if port == self._baud:
            return self._gateway.receive(data, now)
        return hear(self._gateway.receive(hear(data, port, self._baud), now), self._baud, port)

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Advance to the time `now`, and return the bytes that the host receives; see `Gateway`."""
        sent, port = self._gateway.advance(now, room), self._port_baud()
        return sent if port == self._baud else hear(sent, self._baud, port)
