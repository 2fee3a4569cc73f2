"""The numbers of the model, each with its source. None is fitted to a measurement that the model is compared with."""

from __future__ import annotations

import math

import msgspec


class Timing(msgspec.Struct, frozen=True, kw_only=True):
    """Durations in seconds, and sizes in bytes."""

    microframe: float = 125e-6
    """Period of a high-speed bus (USB 2.0, section 8.4.3.1). A transfer that the program submits is begun at the next
    microframe, and its end is told to the program at the end of the microframe in which it comes: the turn-around of a
    host controller whose interrupts are held back for one microframe (Linux: ``log2_irq_thresh`` = 0). What the
    program itself takes is not modelled but measured, by running it."""
    packets_per_microframe: int = 13
    """Most bulk packets of 512 bytes in one microframe, both directions together (USB 2.0, table 5-10)."""
    fifo_bytes_per_second: float = 8e6
    """Asynchronous FT245, for each direction (FT232H datasheet, section 4.4). A cycle of RD# or WR# holds the bus for
    30 ns of the 125 ns, so both directions fit side by side."""
    synchronous_bytes_per_second: float = 40e6
    """Synchronous FT245 (FT232H datasheet, section 4.5); its bus carries one direction at a time."""
    default_latency: int = 16
    """Latency timer after a reset, ms (AN232B-04)."""
    short_packet_after_full: bool = False
    """True if a flush that fills a packet to its last byte is followed by an empty one, which ends the host's transfer.
    Not documented; the default is the worse case, in which the latency timer ends it."""

    @property
    def packet(self) -> float:
        """Time that one packet takes on the bus."""
        return self.microframe / self.packets_per_microframe

    def boundary_after(self, now: float) -> float:
        """Return the next beginning of a microframe; `now` itself where it is one."""
        return math.ceil(now / self.microframe - 1e-6) * self.microframe
