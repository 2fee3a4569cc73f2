"""Layer 2, the link: the connection of a program to one gateway.

- `connecting`: `connect`, which opens a link
- `link`: the asynchronous API: reads, writes, blocks, batches, subscriptions
- `mapped`: the same API for a bus that is mapped into memory
- `subscription`: streams of the samples that the gateway takes of a group of addresses
- `publishing`, `samples_together`: samples on their way from the session to a subscription
- `gateway_clock`: the gateway's time in seconds, from timestamps of 32 bits
- `connection`: opening, losing, reopening and closing the connection
- `flow`: a session of the protocol, driven by a stream, a clock and futures
- `runtimes`: an event loop, the calling thread, or tasks of trio, which run the coroutines of a link
- `html`: links and robots in notebooks

The handshake and all requests to the gateway are in `unity_link.protocol`.
"""
