"""Simulated hardware: gateways, robots, lines and an FT232H.

- `gateway`: the gateway as a model; it uses `commands`, `groups`, `sample_ring` and `bus`
- `rtl`: the gateway as compiled gateware
- `scara`, `walker`: built-in robots with the joints of `servo`; `tosnet`: the SCARA as a node of a TosNet network
- `simulated`, `registers`, `core_models`: the robot of a spec, moved by a model; `simulating`: its gateway
- `build`: builds a gateway from a URL or the options of a command; `simulate` does so for programs
- `line`, `shared_line`, `uart`, `faults`, `udp_relay`: rates, collisions and faults between a gateway and its host
- `model_clock`, `transport`, `serving`: run a gateway on an event loop, in this process or for other programs
- `ft232h`: a simulated USB chip with a gateway at its pins; `modelled_time`: an event loop with simulated time

All of these gateways have the interface `Gateway`, including lines, which are gateways in front of other gateways.
"""

from unity_link.virtual.bus import AccessError, Device
from unity_link.virtual.gateway import BareGateway, Gateway, VirtualGateway

__all__ = ["AccessError", "BareGateway", "Device", "Gateway", "VirtualGateway"]
