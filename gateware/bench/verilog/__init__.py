"""The Verilog release, in two simulators other than GHDL."""
