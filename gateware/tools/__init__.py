"""The tool flow of the gateware: VHDL to Verilog, to a C++ model of the same RTL, and to logic cells.

`ghdl` finds or fetches a GHDL that converts correctly, `convert` uses it, `model` makes what `unity_link.virtual.rtl`
compiles, `synth` what `gateware/RESULTS.md` shows, `mapped` what `gateware/mapped.json` has. Each result is kept under
a hash of what it was made from.
"""
