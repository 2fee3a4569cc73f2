"""Compiled gateware in this process, with the same interface as the model.

- `shim.cc`: the clock, the medium and the bus around the compiled gateware, in C++
- `generated/`: the gateware as C++, with all configurations in one archive, and an index; `make rtl` writes both
- `cxxrtl_runtime/`: headers of Yosys for this C++, under their own licence (ISC, in each file)
- `archive`: reads and writes the archive and the index
- `configurations`: lists and selects the configurations
- `compiling`, `library`: compile the C++ at first use, and load the library
- `gateway`: `RtlGateway`, the compiled gateware as a gateway; `pace`: warns if it is slower than real time
- `ports`: the ports of a whole design that do not belong to the gateway
- `specs`, `making`: make the whole design of a spec at first use
- `spec_gateway`, `wiring`: that design with a simulated robot at its ports
- `snooped`, `retrace`: read a recorded session, and run it on compiled gateware
"""

from unity_link.virtual.rtl.configurations import choose, configurations
from unity_link.virtual.rtl.gateway import RtlGateway

__all__ = ["RtlGateway", "choose", "configurations"]
