"""Compiles the gateware's C++ at first use, and keeps the result.

A compiled library is kept in the user's cache under a hash of its sources, of the compiler and of its options, so that
it is never stale; half a minute is spent once after an installation or an update. Two programs may do so at once: each
puts its own in place as a whole, and both are the same.
"""

from __future__ import annotations

import asyncio
import contextlib
import hashlib
import logging
import os
import shlex
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from unity_link.errors import ConnectError
from unity_link.gateware import cache

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from unity_link.virtual.rtl.configurations import Configuration

_HERE = Path(__file__).parent
RUNTIME = _HERE / "cxxrtl_runtime"
_SHIM = _HERE / "shim.cc"
_COMPILERS = ("c++", "g++", "clang++")
# Of what compilers offer, -O3 makes the quickest gateware: twice that of -O2.
_OPTIONS = ("-O3", "-std=c++14", "-shared", "-fPIC")
_WATCHED = (
    'exec 3<&0; (read _ <&3; kill -9 0) >/dev/null 2>&1 & exec 3<&-; "$@" </dev/null; status=$?; kill $!; exit $status'
)
"""Runs a command for `sh`, and kills the process group as soon as nobody can write to its input any more: a program
that a signal ends has no time to do so. The shell needs no program for it, as PATH may have none."""
_UNFINISHED = "tmp"
_STALE = 24 * 3600
"""Seconds after which a folder that nobody has finished is removed."""
log = logging.getLogger("unity_link.rtl")


def compiled(configuration: Configuration) -> Path:
    """Return the shared library of a build of the gateware, compiled unless that was done before.

    Raises:
        ArgumentError: where this installation does not have its C++.
        ConnectError: where no C++ compiler is installed, it fails, or the result cannot be kept.
    """
    plan = _Plan.of(configuration)
    if not plan.library.exists():
        with plan.compiling() as command, running(command) as process:
            plan.check(process.communicate()[1], process.returncode)
    return plan.library


async def compile_beside(configuration: Configuration) -> None:
    """Do what `compiled` does while the event loop goes on; cancellation ends the compiler.

    Raises:
        ConnectError: as `compiled`.
    """
    plan = _Plan.of(configuration)
    if plan.library.exists():
        return
    with plan.compiling() as command, running(command) as process:
        # A thread waits, for processes of asyncio need a loop that watches children.
        errors = (await asyncio.to_thread(process.communicate))[1]
        plan.check(errors, process.returncode)


class _Plan(msgspec.Struct, frozen=True):
    """Steps of a compilation, and the paths of their results."""

    compiler: list[str]
    configuration: Configuration
    library: Path

    @classmethod
    def of(cls, configuration: Configuration) -> _Plan:
        chosen = compiler()
        version = subprocess.run([*chosen, "--version"], check=False, capture_output=True).stdout  # noqa: S603
        named = (version, *(option.encode() for option in _OPTIONS), configuration.digest.encode())
        digest = hashlib.sha256(b"\0".join(named))
        for part in (_SHIM, *sorted(RUNTIME.rglob("*.h"))):
            digest.update(part.read_bytes())
        return cls(chosen, configuration, cache_folder() / f"{configuration.name}-{digest.hexdigest()[:16]}.so")

    @contextlib.contextmanager
    def compiling(self) -> Iterator[list[str]]:
        """Return the command to run; what it made is kept if the block ends well."""
        text = self.configuration.text()
        log.warning("compiling the gateware by %s: once, this takes a while", self.compiler[0])
        try:
            self.library.parent.mkdir(parents=True, exist_ok=True)
            _remove_stale(self.library.parent)
            with tempfile.TemporaryDirectory(
                dir=self.library.parent, prefix=_UNFINISHED, ignore_cleanup_errors=True
            ) as scratch:
                built, model = Path(scratch, self.library.name), Path(scratch, "model.cc")
                model.write_bytes(text)
                named = f'-DUL_MODEL="{model}"'
                yield [*self.compiler, *_OPTIONS, f"-I{RUNTIME}", named, str(_SHIM), "-o", str(built)]
                built.replace(self.library)
        except OSError as error:
            raise _not_kept(self.library.parent, error) from error

    def check(self, errors: bytes, code: int) -> None:
        """Raise `ConnectError` where the compiler has failed."""
        if code:
            lines = errors.decode(errors="replace").strip().splitlines()
            reason = next((line for line in lines if "error" in line), lines[0] if lines else f"exit code {code}")
            raise ConnectError(f"the gateware could not be compiled by {self.compiler[0]}: {reason}")


@contextlib.contextmanager
def running(command: list[str], environment: Mapping[str, str] | None = None) -> Iterator[subprocess.Popen[bytes]]:
    """Run a command that outlives neither the block nor this process, nor do the processes that it starts."""
    held, alive = os.pipe()
    try:
        process = subprocess.Popen(  # noqa: S603
            ["/bin/sh", "-c", _WATCHED, "sh", *command],
            stdin=held,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            process_group=0,
            env=environment,
        )
    except BaseException:
        os.close(alive)
        raise
    finally:
        os.close(held)
    try:
        yield process
    finally:
        os.close(alive)
        if process.poll() is None:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()


def _remove_stale(folder: Path) -> None:
    """Remove what programs that were killed have left of a compilation."""
    for left in folder.glob(f"{_UNFINISHED}*/"):
        with contextlib.suppress(OSError):
            if time.time() - left.stat().st_mtime > _STALE:
                shutil.rmtree(left)


def compiler() -> list[str]:
    """Return the command of the C++ compiler.

    Raises:
        ConnectError: where none is installed.
    """
    chosen = shlex.split(os.environ.get("CXX", ""))
    for candidate in [chosen] if chosen else [[name] for name in _COMPILERS]:
        if shutil.which(candidate[0]):
            return candidate
    if chosen:
        raise ConnectError(f"the C++ compiler that CXX names, {chosen[0]!r}, is not there: unset CXX, or install it")
    raise ConnectError("the gateware is compiled at its first use, and no C++ compiler is there: apt install g++")


def _not_kept(folder: Path, error: OSError) -> ConnectError:
    return ConnectError(
        f"the compiled gateware can't be kept in {folder} ({error.strerror or error}): "
        "name another folder in XDG_CACHE_HOME"
    )


def cache_folder() -> Path:
    """Return the folder in which libraries, and what they are compiled from, are kept; it is made.

    Raises:
        ConnectError: where it cannot be made.
    """
    try:
        return cache.cache_folder("rtl")
    except OSError as error:
        raise _not_kept(Path(error.filename), error) from error
