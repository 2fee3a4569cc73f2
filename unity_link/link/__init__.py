"""Layer 2, the link: what a program holds of one gateway.

- `link`: the asynchronous face: reads, writes, blocks, batches, subscriptions
- `subscription`: groups of addresses that the gateway samples by itself
- `connection`: the life of a link: opened, lost, opened again, closed
- `handshake`: the first words on a connection
- `exchange`, `requests`: requests in flight, and what one is
"""
