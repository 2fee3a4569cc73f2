"""Global buffers for nets that enable or reset a large part of an ECP5.

nextpnr gives clocks the global wires and nothing else. A reset or a clock enable of some thousand registers then goes
through the same wires as the logic, to every tile of the FPGA, and the router of a large design comes to no end. A
DCCA before them, in the netlist that Yosys has written, takes them off these wires.

Only pins of registers are moved: no global wire reaches those of logic, which stay at the driver of the net.
"""

from __future__ import annotations

import itertools
import json
from collections import defaultdict
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pathlib import Path

LEAST = 1000
"""Pins of registers from which on a net has a buffer: those below are routed as they are."""
_REGISTER = "TRELLIS_FF"
_PINS = ("CE", "LSR")


def buffer_wide_nets(netlist: Path, top: str) -> dict[str, int]:
    """Put a DCCA before each wide net of a netlist of Yosys in JSON.

    Returns:
        How many pins were moved, by the names of the buffers.
    """
    design: dict[str, Any] = json.loads(netlist.read_text())
    module = design["modules"][top]
    pins: dict[int, list[tuple[str, str]]] = defaultdict(list)
    for name, cell in module["cells"].items():
        if cell["type"] == _REGISTER:
            for pin in _PINS:
                for bit in cell["connections"].get(pin, ()):
                    # Constants are strings.
                    if isinstance(bit, int):
                        pins[bit].append((name, pin))
    wide = {bit: users for bit, users in pins.items() if len(users) >= LEAST}
    if not wide:
        return {}
    # Each bit has a name, the bits of ports too.
    named = (bit for net in module["netnames"].values() for bit in net["bits"] if isinstance(bit, int))
    free = itertools.count(1 + max(named))
    moved = {}
    for number, (bit, users) in enumerate(wide.items()):
        name, out = f"wide_net_{number}", next(free)
        module["cells"][name] = {
            "hide_name": 0,
            "type": "DCCA",
            "parameters": {},
            "attributes": {},
            "port_directions": {"CLKI": "input", "CE": "input", "CLKO": "output"},
            "connections": {"CLKI": [bit], "CE": ["1"], "CLKO": [out]},
        }
        module["netnames"][name] = {"hide_name": 0, "bits": [out], "attributes": {}}
        for cell, pin in users:
            module["cells"][cell]["connections"][pin] = [out]
        moved[name] = len(users)
    netlist.write_text(json.dumps(design))
    return moved
