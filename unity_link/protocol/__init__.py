"""The protocol without I/O, clocks or tasks: bytes and numbers in, bytes and events out.

- `crc`: the check of a frame
- `configuration`: what a gateway says of itself (`Q`), from which all widths follow
- `frames`: what stands between two line ends
- `messages`: what it means, for any widths
- `constants`: how long and how often a host tries
- `window`: exactly once, in order
"""
