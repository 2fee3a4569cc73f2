"""The Verilog release, in two simulators beside GHDL."""
