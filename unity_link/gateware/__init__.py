"""Products that a tool makes of the gateware's VHDL: GHDL, of version 4 or later.

- `cache`: where the VHDL is, where made things are kept, and under which name
- `sources`: the VHDL and all that belongs to it, for a design of a user's own
- `external`: tools and temporary folders, none of which outlives the program
- `ghdl`: a GHDL that converts correctly, found or fetched
- `design`: VHDL in a folder of GHDL's, and the errors of GHDL
- `convert`: an entity as Verilog
- `refused`: what GHDL is known to convert wrongly
- `own_vhdl`: VHDL of a user's own, and how it becomes Verilog
- `own_circuits`, `comparing`: whether that Verilog is the circuit that GHDL simulates
- `netlist`, `random_inputs`: Verilog as a function, and what it gets
- `release`: the same as a file for those who have no VHDL
- `words`: names that Verilog takes and SystemVerilog does not
- `yowasp`: what reads that Verilog
"""

LICENCE = "SPDX-License-Identifier: BSD-3-Clause"
"""Licence text at the top of each source that users copy."""
