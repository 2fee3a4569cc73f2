"""Networks behind a gateway: memories that several nodes share, and in which each writer commits its own writes.

- `tosnet`: the proxies of TosNet, the paper's network
- `memories`: the double-buffered memories of a spec, for clients in other languages, which commit by themselves
"""

from unity_link.network.tosnet import TosnetNetwork, TosnetNode, TosnetState

__all__ = ["TosnetNetwork", "TosnetNode", "TosnetState"]
