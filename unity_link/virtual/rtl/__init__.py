"""The gateware itself in this process: the VHDL, compiled, behind the same interface as the model.

- `shim.cc`: the clock, the medium and the bus around the compiled gateware, in C++
- `generated/`: the gateware as C++, one file for each configuration; `make rtl` writes it from the VHDL
- `cxxrtl_runtime/`: the headers that it includes, from Yosys, under their own licence (ISC, in each of them)
- `library`: compiles the three at first use and loads them
- `gateway`: `RtlGateway`, what everything else uses
"""

from unity_link.virtual.rtl.gateway import RtlGateway
from unity_link.virtual.rtl.library import configurations

__all__ = ["RtlGateway", "configurations"]
