"""Files that one program writes at a time."""

from __future__ import annotations

import sys


def lock_file(descriptor: int) -> None:
    """Lock an open file against other programs until it is closed. On Windows nothing is locked.

    Raises:
        BlockingIOError: where another program has locked it.
        OSError: where its file system has no locks.
    """
    if sys.platform != "win32":
        import fcntl

        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
