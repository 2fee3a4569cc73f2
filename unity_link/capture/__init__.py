"""Passive observers of a connection: they decode recorded or observed bytes, and never send any.

- `decoder`: one frame and its meaning
- `observed_session`: the number of the session that the frames belong to
- `transcript`: the bytes of both directions as frames with times and meanings
- `pcapng`: the blocks of a capture file
"""
