"""Converts the gateware's VHDL, and that of users, to Verilog by GHDL (version 4 or later).

- `cache`: paths of the VHDL sources, and the cache of converted files
- `sources`: copies of the gateware's files for a user's design
- `external`: runs tools and makes temporary folders, all of which end with the program
- `ghdl`: finds or fetches a GHDL that converts correctly
- `design`: the VHDL of a design in a working folder of GHDL, and GHDL's messages
- `entity`: generics and ports of an entity, from GHDL's syntax tree
- `convert`: converts an entity to Verilog
- `refused`: refuses VHDL that GHDL is known to convert wrongly
- `own_vhdl`: reads a user's VHDL and converts it
- `own_circuits`, `comparing`: compare the Verilog of a user's entities with GHDL's simulation
- `netlist`, `random_inputs`: Verilog as a Python function, and inputs for it
- `registers`, `release`: Verilog as a file for users without VHDL, with registers named as in the VHDL
- `limits`: limits of the gateware's generics
- `pin_times`: timing at the pins of external chips
- `vendors`: lists of VHDL files for vendors' tools
- `words`: keywords of SystemVerilog that are legal names in Verilog
- `yowasp`: runs Yosys and nextpnr
"""

LICENCE = "SPDX-License-Identifier: BSD-3-Clause"
"""Licence text at the top of each source that users copy."""
