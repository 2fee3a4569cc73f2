"""A call in a process of its own, for input that can ask for any amount of time and memory."""

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
"""Memory that the new process may take beyond what this one has."""
_TOO_LARGE = 3
"""Exit code of the process where memory ran out."""


class TooMuchError(UnityLinkError):
    """Input asks for more time or memory than a command gives it."""


def call_bounded(function: Callable[[], T], name: str, seconds: int) -> T:
    """Call a function in a new process, which is ended at a bound, and return its result.

    Args:
        function: returns or raises what can be pickled.
        name: of what is read, for the message.
        seconds: processor time that the new process may take, at least 1.

    Raises:
        UnityLinkError: what the function raises.
        TooMuchError: where it took more time or memory than it may.
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
    # A library in C++ that finds no memory ends the process.
    if code == _TOO_LARGE or code < 0:
        raise TooMuchError(f"{name} takes more than {_MOST_BYTES >> 30} GiB of memory")
    if code:
        raise UnityLinkError(f"{name} cannot be read: the process that reads it has ended with {code}")
    result, error = pickle.loads(answer)  # noqa: S301  (what this program has written)
    if error is not None:
        raise error
    made: T = result
    return made


def _answer(function: Callable[[], object], writing: int, seconds: int) -> None:
    """Write the result of a function, or its error, in the new process, and end that."""
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
    except Exception:  # noqa: BLE001  (told here, and by the exit code)
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)


def _address_space() -> int:
    """Return the bytes of address space that this process has, by proc(5); 0 on systems without."""
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[0])
    except OSError:
        return 0
    return pages * os.sysconf("SC_PAGE_SIZE")
