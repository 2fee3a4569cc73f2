"""What a benchmark reads, and the check that it did: one that is quick and wrong has not finished."""

from __future__ import annotations

ADDRESS = 0x0A
WORD = 0x0A0A0A0A
"""Word of all responders at `ADDRESS`."""


def expect(value: object, expected: object = WORD) -> None:
    """Check what was read.

    Raises:
        RuntimeError: where it is something else.
    """
    if value != expected:
        raise RuntimeError(f"{value!r} was read where {expected!r} stands")
