"""The host's end of the protocol.

- `handshake`, `trial`: how a session begins, and whether its line carries the compact form
- `session`: all of the host's side, from bytes and requests to bytes and events
- `requests`, `batches`: messages that know how they are sent, and what their answers mean
- `receiver`: what arrives in an open session
- `events`: what a session reports
- `group_table`: the gateway's groups, and whose each is
- `host_codec`: messages for the widths of one gateway and one session
- `datagrams`: frames in datagrams
"""
