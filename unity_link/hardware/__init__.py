"""Layer 3, hardware proxies: windows on a gateway's bus, each by addresses of its own.

- `bus`: what they stand on
- `module`: what all have in common
- `memory`, `fifo`: one file for a kind, which states its registers

A proxy stands on a link and a base address, with or without a spec::

    pool = Memory(link, 0x80, size=64)
    await pool.store(range(64))
"""

from unity_link.hardware.bus import Bus, link_under
from unity_link.hardware.fifo import Fifo
from unity_link.hardware.memory import Memory
from unity_link.hardware.module import Module

__all__ = ["Bus", "Fifo", "Memory", "Module", "link_under"]
