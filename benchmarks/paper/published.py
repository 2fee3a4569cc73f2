"""The figures of the paper that the experiment is compared with.

A. B. Lange, U. P. Schultz, A. S. Soerensen: "Unity-Link: A Software-Gateway Interface for Rapid Prototyping of
Experimental Robot Controllers on FPGAs". Measured there on a board with an FT232H, asynchronous FIFO, at 50 MHz. All
are of its Table I, and of what the experiment does, too: the paper has no posted writes and no bursts through its whole
stack, and shows the rates of publishing in a picture alone.
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
LOW_LEVEL_READS_MBITS = 0.89
"""Answers to reads in long bursts, without send-immediate, through the driver alone."""
LOW_LEVEL_READS_IMMEDIATE_MBITS = 0.64
"""The same with send-immediate, in bursts of at most 18."""
LOW_LEVEL_WRITES_MBITS = 56.6
"""Requests of answered writes in a burst of 30, without send-immediate, through the driver alone."""
LOW_LEVEL_WRITES_IMMEDIATE_MBITS = 62.5
"""The same with send-immediate."""
