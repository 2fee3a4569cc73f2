"""Boards: from a spec to a bitstream, with tools of PyPI alone; or to a project of the vendor's tool.

- `board`: what a board is, read from a file of `data` or of the user
- `clocks`: how a PLL makes the frequency that a board's file asks for
- `families`: how Yosys, nextpnr and a packer are called for iCE40, ECP5, Gowin and GateMate
- `build`: the way from an interface to a bitstream and its report, and into the board
- `pins`: which pins of a board the ports of a design are
- `projects`: boards that only Vivado or Quartus places

A new board is a new file in `data`, and a new family an entry of `families` or `projects`.
"""
