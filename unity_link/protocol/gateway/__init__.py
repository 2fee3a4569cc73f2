"""The gateway's end of the protocol, which the simulated gateway and `unity-link serve` share.

- `session`: the reaction to each received frame: execute it, repeat an answer, or refuse it
- `reception`: the checks of a request before it is executed, and the sequence of IDs
- `datagrams`: frames in datagrams
"""
