"""Stand-ins for hardware.

- `gateway`: the protocol as a model; `commands`, `groups` and `bus` are its inside
- `rtl`: the gateware itself, compiled
- `scara`, `walker`: robots behind the bus, made of joints as in `servo`; `tosnet`: the first as a node of a network
- `simulated`, `registers`: the robot of a spec, moved by a model; `simulating`: the gateway that lets its time pass
- `build`: any of it from what a URL or a command says; `simulate` is the same for programs
- `line`, `faults`: what can happen between a gateway and a host; each is a gateway in front of another one
- `transport`, `serving`: gateways on an event loop, in the process and for other programs
- `ft232h`: a USB chip in front of a gateway; `modelled_time`: a loop on which all of it is exact in time

Everything that takes a `Gateway` takes any of them.
"""

from unity_link.virtual.bus import AccessError, Device
from unity_link.virtual.gateway import BareGateway, Gateway, VirtualGateway

__all__ = ["AccessError", "BareGateway", "Device", "Gateway", "VirtualGateway"]
