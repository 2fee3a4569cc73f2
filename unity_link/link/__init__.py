"""Layer 2, the link: what a program holds of one gateway.

- `connecting`: `connect`, which opens a link
- `link`: the asynchronous face: reads, writes, blocks, batches, subscriptions
- `mapped`: the same calls where the bus is mapped into memory
- `subscription`: streams of the samples that the gateway takes of a group of addresses
- `publishing`, `samples_together`: samples on their way from the session to a subscription
- `gateway_clock`: the gateway's time in seconds, from timestamps of 32 bits
- `connection`: the life of a link: opened, lost, opened again, closed
- `flow`: a session of the protocol, driven by a stream, a clock and futures
- `runtimes`: what runs the coroutines of a link: an event loop, the calling thread, tasks of trio
- `html`: links and robots in notebooks

What the link asks of the gateway, and the handshake, are `unity_link.protocol`.
"""
