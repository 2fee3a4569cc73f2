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
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from unity_link.errors import ConnectError
from unity_link.gateware import cache
from unity_link.gateware.external import FolderError, running, temporary_folder

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.virtual.rtl.configurations import Configuration

_HERE = Path(__file__).parent
RUNTIME = _HERE / "cxxrtl_runtime"
_SHIM = _HERE / "shim.cc"
_COMPILERS = ("c++", "g++", "clang++")
# Of what compilers offer, -O3 makes the quickest gateware: twice that of -O2.
_OPTIONS = ("-O3", "-std=c++14", "-shared", "-fPIC")
log = logging.getLogger("unity_link.rtl")


def compiled(configuration: Configuration) -> Path:
    """Return the shared library of a build of the gateware, compiled unless that was done before.

    Raises:
        ArgumentError: where this installation does not have its C++.
        ConnectError: where no C++ compiler is installed, it fails, or the result cannot be kept.
    """
    plan = _Plan.of(configuration)
    if not cache.is_whole(plan.library):
        with plan.compiling() as process:
            plan.check(process.communicate()[1], process.returncode)
    return plan.library


async def compile_beside(configuration: Configuration) -> None:
    """Do what `compiled` does while the event loop goes on; cancellation ends the compiler.

    Raises:
        ConnectError: as `compiled`.
    """
    plan = _Plan.of(configuration)
    if cache.is_whole(plan.library):
        return
    with plan.compiling() as process:
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
    def compiling(self) -> Iterator[subprocess.Popen[bytes]]:
        """Run the compiler; the library is kept if the block ends well."""
        text = self.configuration.text()
        log.warning("compiling the gateware by %s: once, this takes a while", self.compiler[0])
        try:
            self.library.parent.mkdir(parents=True, exist_ok=True)
            with temporary_folder(self.library.parent) as scratch:
                built, model = scratch / self.library.name, scratch / "model.cc"
                model.write_bytes(text)
                named = f'-DUL_MODEL="{model}"'
                command = [*self.compiler, *_OPTIONS, f"-I{RUNTIME}", named, str(_SHIM), "-o", str(built)]
                with running(command, scratch) as process:
                    yield process
                built.write_bytes(cache.sealed(built.read_bytes()))
                built.replace(self.library)
        except FolderError as error:
            raise _not_kept(self.library.parent, error.reason) from error
        except OSError as error:
            raise _not_kept(self.library.parent, error.strerror or str(error)) from error

    def check(self, errors: bytes, code: int) -> None:
        """Raise `ConnectError` where the compiler has failed."""
        if code:
            lines = errors.decode(errors="replace").strip().splitlines()
            reason = next((line for line in lines if "error" in line), lines[0] if lines else f"exit code {code}")
            raise ConnectError(f"the gateware could not be compiled by {self.compiler[0]}: {reason}")


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


def _not_kept(folder: Path, reason: str) -> ConnectError:
    return ConnectError(
        f"the compiled gateware can't be kept in {folder} ({reason}): name another folder in XDG_CACHE_HOME"
    )


def cache_folder() -> Path:
    """Return the folder in which libraries, and what they are compiled from, are kept; it is made.

    Raises:
        ConnectError: where it cannot be made.
    """
    try:
        return cache.cache_folder("rtl")
    except OSError as error:
        raise _not_kept(Path(error.filename), error.strerror or str(error)) from error
