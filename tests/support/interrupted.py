"""Runs a command, sends it a signal after a time, and lists its remains: processes, files, folders, locks."""

from __future__ import annotations

import os
import secrets
import signal
import subprocess
import time
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import platformdirs

if TYPE_CHECKING:
    from collections.abc import Sequence

_MARK = "UNITY_LINK_INTERRUPTED"
_PATIENCE = 60.0
"""Seconds to wait for the end of a command, and for its remains to vanish."""
_LOOK = 0.01
_CACHE_OF_YOWASP = os.environ.get("YOWASP_CACHE_DIR", platformdirs.user_cache_dir("YoWASP", appauthor=False))
"""Compiled tools of YoWASP, shared by all runs, because compiling them takes a minute."""
_CACHE_OF_TOOLS = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache"), "unity-link", "tools")


class Left(NamedTuple):
    """Remains of a command that a signal has ended."""

    processes: list[str]
    """Command lines of processes that still run."""
    files: list[str]
    """Unfinished files, temporary folders and locks, by their paths relative to the folder of the command."""
    said: str
    """Text that the command printed on stderr."""
    status: int


class Place:
    """A folder with all folders that commands write to: the working folder, the cache, temporary files."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.work, self.cache, self.temporary = folder / "work", folder / "cache", folder / "temporary"
        for made in (self.work, self.cache / "unity-link", self.temporary):
            made.mkdir(parents=True)
        # Reuse a GHDL that was downloaded before.
        if _CACHE_OF_TOOLS.exists():
            (self.cache / "unity-link" / "tools").symlink_to(_CACHE_OF_TOOLS)

    def interrupt(self, command: Sequence[str], after: float, number: signal.Signals, *, group: bool = False) -> Left:
        """Run a command and send it a signal, unless the command has ended before; return its remains.

        Args:
            command: the command line.
            after: seconds from the start to the signal.
            number: the signal.
            group: if True, the whole process group gets the signal, as by Ctrl-C in a terminal.
        """
        mark = secrets.token_hex(8)
        environment = {
            **os.environ,
            _MARK: mark,
            "HOME": str(self.folder),
            "TMPDIR": str(self.temporary),
            "XDG_CACHE_HOME": str(self.cache),
            "YOWASP_CACHE_DIR": _CACHE_OF_YOWASP,
        }
        with subprocess.Popen(
            command,
            cwd=self.work,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
        ) as process:
            try:
                process.wait(after)
            except subprocess.TimeoutExpired:
                (os.killpg if group else os.kill)(process.pid, number)
            try:
                said = process.communicate(timeout=_PATIENCE)[1]
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                raise
        deadline = time.monotonic() + _PATIENCE
        while time.monotonic() < deadline and (_marked(mark) or self._unfinished()):
            time.sleep(_LOOK)
        return Left(_marked(mark), self._unfinished(), said, process.returncode)

    def _unfinished(self) -> list[str]:
        temporary = [*self.temporary.iterdir()]
        begun = [
            path
            for top in (self.work, self.cache)
            for path in top.rglob("*")
            if path.name.startswith((".unity-link-", "unity-link-", "tmp"))
            or path.suffix == ".lock"
            or path.is_socket()
        ]
        return sorted(str(path.relative_to(self.folder)) for path in (*temporary, *begun))


def _marked(mark: str) -> list[str]:
    """Return the command lines of the processes that have a mark in their environment."""
    wanted = f"{_MARK}={mark}".encode()
    found = []
    for folder in Path("/proc").iterdir():
        try:
            if folder.name.isdigit() and wanted in (folder / "environ").read_bytes().split(b"\0"):
                found.append((folder / "cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace"))
        except OSError:
            # The process has ended, or belongs to another user.
            continue
    return found
