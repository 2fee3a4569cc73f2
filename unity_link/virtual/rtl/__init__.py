"""The gateware itself in this process: the VHDL, compiled, behind the same interface as the model.

- `shim.cc`: the clock, the medium and the bus around the compiled gateware, in C++
- `generated/`: the gateware as C++, all configurations in one archive, and an index; `make rtl` writes both
- `cxxrtl_runtime/`: the headers that it includes, from Yosys, under their own licence (ISC, in each of them)
- `archive`: reads and writes those
- `configurations`: which of them there are, and which one a user means
- `compiling`, `library`: compile the three at first use, and load them
- `gateway`: `RtlGateway`, what everything else uses; `ports`: what a whole design has beside the gateway's own
- `specs`, `making`: the whole design of a spec, made where it is wanted
- `spec_gateway`, `wiring`: that design with a simulated robot at its ports
- `snooped`, `retrace`: what a snoop has of a gateway, played into it
"""

from unity_link.virtual.rtl.configurations import choose, configurations
from unity_link.virtual.rtl.gateway import RtlGateway

__all__ = ["RtlGateway", "choose", "configurations"]
