"""The figures of the paper that the experiment is compared with.

A. B. Lange, U. P. Schultz, A. S. Soerensen: "Unity-Link: A Software-Gateway Interface for Rapid Prototyping of
Experimental Robot Controllers on FPGAs". Measured there on a board with an FT232H, asynchronous FIFO, at 50 MHz. Only
what is known here is given; a quantity that is missing was not looked up, not found bad.
"""

from __future__ import annotations

GATEWARE_READ_US = 1.14
"""Last byte of the request in, to last byte of the response out."""
GATEWARE_WRITE_US = 1.26
GATEWARE_EFFECT_US = 0.84
"""Last byte of a write in, to its effect on the bus."""
GATEWARE_READS_MBITS = 85.7
"""Answers to pipelined reads, Mb/s."""
LOW_LEVEL_READ_US = 223.6
"""Synchronous read with send-immediate, through the driver alone."""
FULL_STACK_READ_US = 652.0
"""The same through the paper's whole stack."""
FULL_STACK_READS_MBITS = 0.89
"""Answers to reads through the paper's whole stack, of 64 Mb/s."""
POSTED_WRITES_MBITS = 62.5
"""Stateless writes, of 64 Mb/s."""
PUBLISH_KHZ = 1.8
"""Highest rate at which one word was published."""
