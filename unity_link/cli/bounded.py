"""Calls a function in a process of its own, for input that can require any amount of time and memory."""

from __future__ import annotations

import os
import pickle
import signal
import sys
import traceback
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from unity_link.errors import UnityLinkError

if TYPE_CHECKING:
    from collections.abc import Callable

T = TypeVar("T")

_MOST_BYTES = 2 << 30
"""Memory in bytes that the new process may use in addition to that of this one."""
_TOO_LARGE = 3
"""Exit code of the new process if it has no memory left."""


class TooMuchError(UnityLinkError):
    """Input requires more time or memory than a command allows."""


def call_bounded(function: Callable[[], T], name: str, seconds: int) -> T:
    """Call a function in a new process with limited time and memory, and return its result.

    Args:
        function: returns or raises objects that can be pickled.
        name: name of the input, for messages.
        seconds: processor time that the new process may use, at least 1.

    Raises:
        UnityLinkError: if the function raises it.
        TooMuchError: if it needs more time or memory.
    """
    sys.stdout.flush()
    sys.stderr.flush()
    reading, writing = os.pipe()
    child = os.fork()
    if not child:
        os.close(reading)
        _answer(function, writing, seconds)
    os.close(writing)
    with os.fdopen(reading, "rb") as pipe:
        answer = pipe.read()
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    if code == -signal.SIGXCPU:
        raise TooMuchError(f"{name} takes more than {seconds} s of processor time; `--seconds` gives it more")
    # A C++ library that cannot allocate memory kills the process by a signal.
    if code == _TOO_LARGE or code < 0:
        raise TooMuchError(f"{name} takes more than {_MOST_BYTES >> 30} GiB of memory")
    if code:
        raise UnityLinkError(f"{name} cannot be read: the process that reads it has ended with {code}")
    result, error = pickle.loads(answer)  # noqa: S301  (written by the child process)
    if error is not None:
        raise error
    made: T = result
    return made


def _answer(function: Callable[[], object], writing: int, seconds: int) -> None:
    """In the new process: write the pickled result of the function, or its error, and exit."""
    import resource

    code = 1
    try:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        most = _address_space() + _MOST_BYTES
        resource.setrlimit(resource.RLIMIT_AS, (most, most))
        try:
            answer = pickle.dumps((function(), None))
        except (UnityLinkError, OSError) as error:
            answer = pickle.dumps((None, error))
        with os.fdopen(writing, "wb") as pipe:
            pipe.write(answer)
        code = 0
    except MemoryError:
        code = _TOO_LARGE
    except Exception:  # noqa: BLE001  (reported here, and by the exit code)
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)


def _address_space() -> int:
    """Return the size in bytes of this process's address space, from proc(5); 0 on systems without it."""
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[0])
    except OSError:
        return 0
    return pages * os.sysconf("SC_PAGE_SIZE")
