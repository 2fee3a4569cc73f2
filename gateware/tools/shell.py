"""Shell of registers for placing a core alone, which has more ports than an FPGA has pins.

Inputs come from the registers of a chain that is filled from a pin. Outputs end where they leave the core, and are kept
there. So the shell has no logic, and no way in it is longer than those from register to register inside the core.
"""

from __future__ import annotations

from typing import NamedTuple

from unity_link.gateware.cache import sources_for
from unity_link.gateware.release import ports

SHELL = "shell"
_MODULE = """
module {shell}(input clk, input d);
  reg [{last}:0] chain;
  always @(posedge clk) chain <= {{chain, d}};
{kept}  {entity} core({connections});
endmodule
"""


class Shelled(NamedTuple):
    """A core with the shell around it."""

    verilog: str
    chain: int
    """Registers of the shell."""


def shelled(entity: str, verilog: str) -> Shelled:
    """Return the Verilog of a core with a module `shell` around it, whose pins are `clk` and `d`."""
    found = ports(verilog, entity, entity, sources_for(entity))
    connections, kept, chain = [".clk(clk)"], "", 0
    for port in found:
        if port.name == "clk":
            continue
        if port.is_input:
            connections.append(f".{port.name}(chain[{chain + port.width - 1}:{chain}])")
            chain += port.width
        else:
            kept += f"  (* keep *) wire [{port.width - 1}:0] {port.name};\n"
            connections.append(f".{port.name}({port.name})")
    shell = _MODULE.format(shell=SHELL, last=chain - 1, kept=kept, entity=entity, connections=", ".join(connections))
    return Shelled(verilog + shell, chain)
