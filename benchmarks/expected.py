"""The word that benchmarks read, and its check: a benchmark that is quick but wrong must fail."""

from __future__ import annotations

ADDRESS = 0x0A
WORD = 0x0A0A0A0A
"""Word of all responders at `ADDRESS`."""


def expect(value: object, expected: object = WORD) -> None:
    """Check a value that was read.

    Raises:
        RuntimeError: if it differs from the expected one.
    """
    if value != expected:
        raise RuntimeError(f"{value!r} was read, expected {expected!r}")
