"""The gateway's end of the protocol, which the simulated gateway and `unity-link serve` share.

- `session`: what a gateway does with each frame that arrives: execute it, answer again, or refuse it
- `reception`: the checks of a request before it is executed, and the sequence of IDs
- `datagrams`: frames in datagrams
"""
