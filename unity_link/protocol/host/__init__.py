"""The host's end of the protocol.

- `handshake`, `trial`: how a session begins, and whether its line carries the compact form
- `session`: requests and received bytes in, bytes to send and events out
- `requests`, `batches`: messages with their frames, answers and outcomes
- `receiver`: matches the received frames of an open session to requests and groups
- `events`: the events that a session returns
- `group_table`: the gateway's groups, and their holders
- `host_codec`: the message codec of one gateway, with the current session in each CRC
- `datagrams`: frames in datagrams
"""
