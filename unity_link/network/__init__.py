"""Networks behind a gateway: memories that several nodes share, and that are committed by whoever writes.

- `tosnet`: the proxies of TosNet, the paper's network
- `memories`: the double-buffered memories of a spec, for clients that commit by themselves
"""

from unity_link.network.tosnet import TosnetNetwork, TosnetNode, TosnetState

__all__ = ["TosnetNetwork", "TosnetNode", "TosnetState"]
