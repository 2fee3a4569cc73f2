"""Passive observers: frames that were recorded or overheard on a line, decoded and put into words.

- `decoder`: one frame and its meaning
- `observed_session`: the session that the frames belong to
- `transcript`: the bytes of both directions as frames with times and meanings
- `pcapng`: the blocks of a recording

Nothing here sends a byte, or changes what a link does.
"""
