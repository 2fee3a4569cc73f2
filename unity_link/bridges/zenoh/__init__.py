"""Zenoh: one gateway for other machines, without a broker, or with a router.

    @link/...     Streams: links of other programs         \
    signals/...   Signals: reads and writes by keys         >  SharedLink: one window, one gateway
    samples/...   Samples: publications of many samples    /

- `bridge`: begins and ends all parts
- `streams`: the bridge's end of ``unity_link.connect("zenoh:robot/1")``; `unity_link.transport.zenoh` is the other end
- `signals`, `writing`, `describing`: values by keys, for programs that only have Zenoh
- `samples`: the samples of groups
- `own_link`: the bridge's own link to the gateway, beside the links of clients
"""

from unity_link.bridges.zenoh.bridge import ZenohBridge
from unity_link.transport.zenoh_session import Network

__all__ = ["Network", "ZenohBridge"]
