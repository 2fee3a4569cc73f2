"""Runs external tools and makes temporary folders; tools end and folders are removed when this program ends.

For each of them a watcher runs: a shell in its own session, so that signals sent to this program do not reach it. The
watcher reads from a pipe. The pipe closes at the end of a block, and if any signal ends this program. The watcher then
kills the tool and all processes that it started, or removes the folder.
"""

from __future__ import annotations

import contextlib
import errno
import os
import secrets
import signal
import subprocess
import tempfile
from pathlib import Path
from typing import IO, TYPE_CHECKING

from unity_link.errors import UnityLinkError

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    Output = int | IO[str] | IO[bytes]

_SHELL = "/bin/sh"
# The last line read is the process group of a running tool, or empty. PATH may not contain `rm`. Removing is retried,
# because a tool may create files until it is killed.
_WATCHER = """
trap '' HUP INT TERM
while read -r group; do last=$group; done
[ -z "$last" ] || kill -s KILL -- "-$last"
PATH=$PATH:/usr/bin:/bin
for folder; do
    for _ in 1 2 3 4 5 6 7 8 9 10; do rm -rf -- "$folder" && break; done
done
"""
# The shell sends its process group to the watcher before it executes the tool, so the watcher can always kill the tool.
_TOOL = 'echo "$$" >&0; exec "$@" </dev/null'
_OF_THE_DISK = {errno.EDQUOT, errno.EFBIG, errno.EIO, errno.ENOSPC, errno.EROFS}


class FolderError(UnityLinkError):
    """Temporary files cannot be written; the message names the folder, and the variable that selects another folder."""

    def __init__(self, around: Path, error: OSError, variable: str) -> None:
        self.reason = error.strerror or str(error)
        super().__init__(f"{around} can't hold temporary files ({self.reason}): name another folder in {variable}")


@contextlib.contextmanager
def temporary_folder(parent: Path | None = None) -> Iterator[Path]:
    """Make a folder that is removed at the end of the block, also if a signal ends this program.

    Args:
        parent: the folder in which it is made; None for the system's folder of temporary files (TMPDIR).

    Raises:
        FolderError: if the folder cannot be made, or a file in it cannot be written.
    """
    around = Path(tempfile.gettempdir()) if parent is None else parent
    folder = around / f"unity-link-{secrets.token_hex(8)}"
    try:
        with _watched(folder):
            folder.mkdir(mode=0o700)
            yield folder
    except OSError as error:
        if not _is_about(error, folder):
            raise
        raise FolderError(around, error, "TMPDIR" if parent is None else "XDG_CACHE_HOME") from error


@contextlib.contextmanager
def running(
    command: Sequence[str],
    folder: Path,
    *,
    cwd: Path | None = None,
    environment: Mapping[str, str] | None = None,
    stdout: Output = subprocess.DEVNULL,
    stderr: Output = subprocess.PIPE,
) -> Iterator[subprocess.Popen[bytes]]:
    """Run a tool; it and the processes that it starts end at the latest with the block or with this program.

    Args:
        command: the tool and its arguments.
        folder: a `temporary_folder` for the tool's own temporary files.
        cwd: working directory of the tool; None for that of this program.
        environment: additional environment variables.
        stdout: as in `subprocess.Popen`.
        stderr: as in `subprocess.Popen`.
    """
    with _watched() as alive:
        process = None
        try:
            process = subprocess.Popen(
                [_SHELL, "-c", _TOOL, "sh", *command],
                stdin=alive,
                stdout=stdout,
                stderr=stderr,
                cwd=cwd,
                env={**os.environ, **(environment or {}), "TMPDIR": str(folder)},
                process_group=0,
            )
            yield process
        finally:
            if process is not None:
                if process.poll() is None:
                    with contextlib.suppress(ProcessLookupError):
                        os.killpg(process.pid, signal.SIGKILL)
                    process.wait()
                # Clear the watcher's group number: the system may now give it to another program.
                with contextlib.suppress(OSError):
                    os.write(alive, b"\n")


def run(
    command: Sequence[str],
    folder: Path,
    *,
    cwd: Path | None = None,
    environment: Mapping[str, str] | None = None,
    timeout: float | None = None,
) -> subprocess.CompletedProcess[str]:
    """Run a tool as `running` does, and return its exit status and its output.

    Args:
        command: as in `running`.
        folder: as in `running`.
        cwd: as in `running`.
        environment: as in `running`.
        timeout: seconds after which the tool is killed.

    Raises:
        subprocess.TimeoutExpired: if the tool was killed.
    """
    with running(command, folder, cwd=cwd, environment=environment, stdout=subprocess.PIPE) as process:
        # The output may quote lines of a user's files, which need not be UTF-8.
        stdout, stderr = (text.decode(errors="replace") for text in process.communicate(timeout=timeout))
    return subprocess.CompletedProcess(list(command), process.returncode, stdout, stderr)


@contextlib.contextmanager
def _watched(*folders: Path) -> Iterator[int]:
    """Start a watcher; yield the file descriptor of the pipe that keeps it waiting."""
    held, alive = os.pipe()
    try:
        watcher = subprocess.Popen(
            [_SHELL, "-c", _WATCHER, "sh", *map(str, folders)],
            stdin=held,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            cwd="/",
            start_new_session=True,
        )
    except BaseException:
        os.close(alive)
        raise
    finally:
        os.close(held)
    try:
        yield alive
    finally:
        os.close(alive)
        watcher.wait()


def _is_about(error: OSError, folder: Path) -> bool:
    """Return True if an error is about a folder; an error of writing to an open file names no file."""
    if error.filename is None:
        return error.errno in _OF_THE_DISK
    return Path(os.fsdecode(error.filename)).is_relative_to(folder)
