"""The tool flow of the gateware: converts VHDL to Verilog, to a C++ model of the same RTL, and to logic cells.

`ghdl` finds or downloads a GHDL that converts correctly, and `convert` uses it. `model` writes the C++ that
`unity_link.virtual.rtl` compiles, `synth` writes `gateware/RESULTS.md`, and `mapped` writes `gateware/mapped.json`.
Each result is stored under a hash of its inputs.
"""

from __future__ import annotations

import argparse


def parser_of(about: str | None) -> argparse.ArgumentParser:
    """Return the command-line parser of a tool, whose help shows the tool's docstring unchanged."""
    return argparse.ArgumentParser(description=about, formatter_class=argparse.RawDescriptionHelpFormatter)
