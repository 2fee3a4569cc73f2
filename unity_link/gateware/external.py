"""External tools and the temporary folders that they work in: none of them outlives this program.

A watcher reads from a pipe that this program holds: a shell in a session of its own, which no signal for this program
reaches. The pipe is closed at the end of a block, and when this program dies, by whatever signal. The watcher then
kills the tool with all processes that it started, or removes the folder.
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
# The last line is the process group of a tool that runs, or empty. PATH may have no `rm`. Removing is tried again,
# because a tool that is being killed may make one more file meanwhile.
_WATCHER = """
trap '' HUP INT TERM
while read -r group; do last=$group; done
[ -z "$last" ] || kill -s KILL -- "-$last"
PATH=$PATH:/usr/bin:/bin
for folder; do
    for _ in 1 2 3 4 5 6 7 8 9 10; do rm -rf -- "$folder" && break; done
done
"""
# The shell reports its process group before it becomes the tool: the watcher has the group of every tool that runs.
_TOOL = 'echo "$$" >&0; exec "$@" </dev/null'
_OF_THE_DISK = {errno.EDQUOT, errno.EFBIG, errno.EIO, errno.ENOSPC, errno.EROFS}


class FolderError(UnityLinkError):
    """A folder cannot hold temporary files; the message names the folder, and a variable that names another one."""

    def __init__(self, around: Path, error: OSError, variable: str) -> None:
        self.reason = error.strerror or str(error)
        super().__init__(f"{around} can't hold temporary files ({self.reason}): name another folder in {variable}")


@contextlib.contextmanager
def temporary_folder(parent: Path | None = None) -> Iterator[Path]:
    """Make a folder that is removed at the end of the block, also if a signal ends this program.

    Args:
        parent: the folder around it; None for that of temporary files (TMPDIR).

    Raises:
        FolderError: if it cannot be made, or something in it cannot be written.
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
    """Run a tool, which ends with the block or with this program, as do the processes that it starts.

    Args:
        command: the tool and its arguments.
        folder: for its own temporary files, a `temporary_folder`.
        cwd: the folder in which it runs; None for that of this program.
        environment: variables beside those of this program.
        stdout: as that of `subprocess.Popen`.
        stderr: likewise.
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
                # The number of its group is free for another program from now on.
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
        command: as that of `running`.
        folder: as that of `running`.
        cwd: as that of `running`.
        environment: as that of `running`.
        timeout: seconds after which the tool is ended.

    Raises:
        subprocess.TimeoutExpired: if it was ended.
    """
    with running(command, folder, cwd=cwd, environment=environment, stdout=subprocess.PIPE) as process:
        # It shows lines of a user's files, whose bytes may be any.
        stdout, stderr = (text.decode(errors="replace") for text in process.communicate(timeout=timeout))
    return subprocess.CompletedProcess(list(command), process.returncode, stdout, stderr)


@contextlib.contextmanager
def _watched(*folders: Path) -> Iterator[int]:
    """Start a watcher; yield the end of the pipe that holds it."""
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
    """Return whether an error says that a folder has no room; writing to an open file names no file."""
    if error.filename is None:
        return error.errno in _OF_THE_DISK
    return Path(os.fsdecode(error.filename)).is_relative_to(folder)
