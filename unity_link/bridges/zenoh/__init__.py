"""Zenoh: a gateway for other machines, with no broker, or behind a router where there is one.

    @link/...     Streams: links of others, whole          \
    signals/...   Signals: reads and writes by keys         >  SharedLink: one window, one gateway
    samples/...   Samples: publications, many in one       /

- `bridge`: the life of all of it
- `streams`: what ``unity_link.connect("zenoh:robot/1")`` speaks to; `unity_link.transport.zenoh` is the other end
- `signals`, `writing`, `describing`: values by keys, for programs that have nothing but Zenoh
- `samples`: what the robot gives by itself
- `own_link`: how the bridge itself reaches the gateway, beside the links of others
"""

from unity_link.bridges.zenoh.bridge import ZenohBridge
from unity_link.transport.zenoh_session import Network

__all__ = ["Network", "ZenohBridge"]
