"""The protocol of docs/protocol.md without I/O, clocks or tasks: bytes and numbers in, bytes and events out.

- `wire`: bytes and their meaning: CRC, frames, compact form, messages, the gateway's configuration, datagrams
- `window`: exactly-once delivery in order, for the messages of one host
- `host`: the host's end
- `gateway`: the gateway's end, which the simulated gateway and `unity-link serve` share

`host` and `gateway` import `window` and `wire`, and never each other.
"""
