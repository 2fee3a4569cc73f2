"""The figures of the model, each with its source; none is fitted to measurements that the model is compared with."""

from __future__ import annotations

import math

import msgspec


class Timing(msgspec.Struct, frozen=True, kw_only=True):
    """Durations in seconds, and sizes in bytes."""

    microframe: float = 125e-6
    """Period of microframes on a high-speed bus (USB 2.0, section 8.4.3.1).

    A submitted transfer begins at the next microframe, and its end is reported at the end of the microframe in which it
    ends. This is the turnaround of a host controller that delays interrupts by one microframe (Linux:
    ``log2_irq_thresh`` = 0). The program's own time is not modelled; it is measured by running the program.
    """
    packets_per_microframe: int = 13
    """Largest number of bulk packets of 512 bytes in a microframe, of both directions (USB 2.0, table 5-10)."""
    fifo_bytes_per_second: float = 8e6
    """Rate of an asynchronous FT245 in each direction (FT232H datasheet, section 4.4).

    A cycle of RD# or WR# occupies the bus for 30 ns of the 125 ns, so that both directions fit.
    """
    synchronous_bytes_per_second: float = 40e6
    """Rate of a synchronous FT245 (FT232H datasheet, section 4.5), whose bus carries one direction at a time."""
    default_latency: int = 16
    """Latency timer after a reset, in ms (AN232B-04)."""
    short_packet_after_full: bool = False
    """True if an empty packet, which ends the host's transfer, follows a flush that fills a packet exactly.

    FTDI does not document this. The default is the worse case, in which only the latency timer ends the transfer.
    """

    @property
    def packet(self) -> float:
        """Time of one packet on the bus, in seconds."""
        return self.microframe / self.packets_per_microframe

    def boundary_after(self, now: float) -> float:
        """Return the time of the next beginning of a microframe, which may be `now`."""
        return math.ceil(now / self.microframe - 1e-6) * self.microframe
