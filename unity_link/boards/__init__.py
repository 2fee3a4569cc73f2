"""Boards: makes a bitstream from a spec with tools from PyPI, or a project for the vendor's tool.

- `board`: the description of a board
- `loading`: reads descriptions from the files of `data`, or from a user's file
- `checking`: checks of such a file
- `clocks`: settings of a PLL for the core clock of a board
- `families`: calls of Yosys, nextpnr and a packer for iCE40, ECP5, Gowin and GateMate
- `build`: makes a bitstream and its report from an interface, and programs a board
- `pins`: maps the ports of a design to pins of a board
- `projects`: projects for boards that only Vivado or Quartus can place

A new board is a new file in `data`, and a new family an entry of `families` or `projects`.
"""
