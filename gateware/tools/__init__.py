"""The tool flow of the gateware: VHDL to Verilog, to a C++ model of the same RTL, and to logic cells.

`ghdl` finds or fetches a GHDL that converts correctly, `convert` uses it, `model` makes what `unity_link.virtual.rtl`
compiles, `synth` what `gateware/RESULTS.md` shows, `mapped` what `gateware/mapped.json` has. Each result is kept under
a hash of what it was made from.
"""

from __future__ import annotations

import argparse


def parser_of(about: str | None) -> argparse.ArgumentParser:
    """Return the parser of the command line of a tool, which shows the tool's docstring as it is written."""
    return argparse.ArgumentParser(description=about, formatter_class=argparse.RawDescriptionHelpFormatter)
