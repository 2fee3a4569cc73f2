"""Completes arguments in a shell: URLs that were used before, schemes, ports, signals.

URLs that a command has used successfully are stored in a file of the user, except for those with a token. Completion
connects to no gateway, so it is quick.
"""

from __future__ import annotations

import contextlib
import io
import os
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from unity_link.errors import ArgumentError
from unity_link.files import write_files

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

MEMORY_VARIABLE = "UNITY_LINK_MEMORY"
"""Environment variable with the path of the file of URLs; empty to store none."""
_MOST = 20
"""Most URLs that are stored."""
_ASKED, _BY_BASH = "_UNITY_LINK_COMPLETE", "complete_bash"
"""Environment variables that typer's scripts for shells set."""
_BREAKS = (":", "=")
"""Characters at which bash splits words, and which occur in URLs and assignments."""
_LISTS = ("names", "assignments", "signals")
"""Parameters of commands that contain specs and signals."""
_SUFFIX = ".ul"
_SECRET = re.compile(r"[?&]token=")
SCHEMES = ("serial:", "tcp://", "unix:", "udp://", "zenoh:", "ftdi://", "ftdi-async://", "sim:", "rtl:")
_OBEYED = frozenset("\\\"'`$;|<>")
_DEVICES = ("ttyUSB*", "ttyACM*")


_used: list[str] = []
"""URL of the running command, if it has one."""


def note(url: str) -> str:
    """Store the URL of the running command in memory, and return it."""
    _used[:] = [url]
    return url


def remember_used() -> None:
    """Write the URL of a successful command to the file, the newest first. Failing to write it is no error."""
    # Do not store a token in a file that the user may not know about.
    for url in _used:
        path = _memory()
        if path is None or _SECRET.search(url) or "\n" in url:
            return
        before = remembered()
        if before[:1] == [url]:
            return
        kept = [url, *(other for other in before if other != url)][:_MOST]
        text = "\n".join(kept) + "\n"
        with contextlib.suppress(ArgumentError):
            write_files({path: text.encode(errors="surrogateescape")}, overwrite=True)


def remembered() -> list[str]:
    """Return the stored URLs, the newest first."""
    path = _memory()
    try:
        return [] if path is None else path.read_text(encoding="utf-8", errors="surrogateescape").splitlines()
    except OSError:
        return []


def _memory() -> Path | None:
    """Return the path of the file of URLs; None if the environment disables it or the user has no home directory."""
    named = os.environ.get(MEMORY_VARIABLE)
    if named is not None:
        return Path(named) if named else None
    try:
        state = os.environ.get("XDG_STATE_HOME") or Path.home() / ".local" / "state"
    except RuntimeError:
        # The user has no home directory.
        return None
    return Path(state) / "unity-link" / "urls"


@contextlib.contextmanager
def words_of_bash() -> Iterator[None]:
    """Make completion in bash work as in other shells, although bash splits words at `:` and `=`.

    The split words are joined before completion, and the part up to the last such character is removed from the
    answers, because bash replaces only the text after it.
    """
    if os.environ.get(_ASKED) != _BY_BASH:
        yield
        return
    words, place = _joined(os.environ.get("COMP_WORDS", "").split("\n"), int(os.environ.get("COMP_CWORD", "0")))
    os.environ.update(COMP_WORDS="\n".join(words), COMP_CWORD=str(place))
    typed = words[place] if place < len(words) else ""
    cut = 1 + max(map(typed.rfind, _BREAKS))
    answer = io.StringIO()
    try:
        with contextlib.redirect_stdout(answer):
            yield
    finally:
        sys.stdout.write("\n".join(line[cut:] for line in answer.getvalue().splitlines()))


def _joined(words: list[str], place: int) -> tuple[list[str], int]:
    """Return the words joined at breaks, and the index of the joined word that contains the word at `place`.

    Words after a break are always joined: bash does not report whether a space was between them.
    """
    joined: list[str] = []
    at = 0
    for number, word in enumerate(words):
        if number > 1 and (word in _BREAKS or joined[-1].endswith(_BREAKS)):
            joined[-1] += word
        else:
            joined.append(word)
        if number == place:
            at = len(joined) - 1
    return joined, at


def _ways(incomplete: str, known: Iterable[str]) -> list[str]:
    """Return the completions that begin with a text, each once, without characters that zsh would evaluate."""
    return [
        text
        for text in dict.fromkeys(known)
        if text.startswith(incomplete) and text.isprintable() and _OBEYED.isdisjoint(text)
    ]


def complete_url(incomplete: str) -> list[str]:
    """Return URLs that begin with a text: stored URLs, ports of this computer, and schemes."""
    ports = [f"serial:{port}" for pattern in _DEVICES for port in sorted(Path("/dev").glob(pattern))]
    known = [*remembered(), *ports, *(f"sim:{robot}" for robot in complete_robot("")), *SCHEMES]
    return _ways(incomplete, known)


def complete_robot(incomplete: str) -> list[str]:
    """Return the names of the robots that can be simulated."""
    from unity_link.virtual.build import ROBOTS

    return _ways(incomplete, filter(None, ROBOTS))


def complete_simulated(incomplete: str) -> list[str]:
    """Return the robots that `simulate` accepts: specs of this folder, and robots by name."""
    return _ways(incomplete, [*complete_robot(""), *sorted(_specs(incomplete))])


def complete_board(incomplete: str) -> list[str]:
    """Return the names of the known boards."""
    from unity_link.boards.loading import board_names

    return _ways(incomplete, board_names())


def complete_signal(ctx: Any, args: list[str], incomplete: str) -> list[str]:  # noqa: ARG001  (typer's)
    """Return specs of this folder for the first argument after the URL, and then signals of that spec."""
    given = [text for name in _LISTS for text in ctx.params.get(name) or ()]
    specs = [text for text in given if text.endswith(_SUFFIX)]
    specs += list(filter(None, [os.environ.get("UNITY_LINK_SPEC")]))
    if not specs:
        return _ways(incomplete, sorted(_specs(incomplete)))
    end = "=" if ctx.info_name == "set" else ""
    return _ways(incomplete, (path + end for path in _paths(Path(specs[0]))))


def _specs(incomplete: str) -> Iterator[str]:
    folder, _, beginning = incomplete.rpartition("/")
    for path in Path(folder or ("/" if incomplete.startswith("/") else ".")).glob("*"):
        if path.name.startswith(beginning) and (path.suffix == _SUFFIX or path.is_dir()):
            yield incomplete[: len(incomplete) - len(beginning)] + path.name + ("/" if path.is_dir() else "")


def _paths(spec: Path) -> list[str]:
    from unity_link.errors import UnityLinkError
    from unity_link.spec import compile_file

    # The command itself will report faults of the spec.
    with contextlib.suppress(UnityLinkError, OSError, ValueError):
        return [path for one in compile_file(spec).interfaces for path in one.signals]
    return []
