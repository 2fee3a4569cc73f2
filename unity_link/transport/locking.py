"""Locks files, so that only one program at a time writes them."""

from __future__ import annotations

import sys


def lock_file(descriptor: int) -> None:
    """Lock an open file against other programs until it is closed; on Windows, do nothing.

    Raises:
        BlockingIOError: if another program has locked the file.
        OSError: if the file system does not support locks.
    """
    if sys.platform != "win32":
        import fcntl

        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
