"""Compiles the gateware's C++ at first use, and keeps the library in the user's cache.

The name of a library contains a hash of its sources, the compiler and the options, so that it is never outdated.
Compiling takes half a minute after an installation or an update. Two programs may compile at the same time: each
renames its complete library into place, and both libraries are the same.
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
# With -O3 the gateware runs twice as fast as with -O2.
_OPTIONS = ("-O3", "-std=c++14", "-shared", "-fPIC")
log = logging.getLogger("unity_link.rtl")


def compiled(configuration: Configuration) -> Path:
    """Return the path of the shared library of a build; compile it if the cache does not have it.

    Raises:
        ArgumentError: if this installation does not have the C++ of the build.
        ConnectError: if no C++ compiler is installed, the compiler fails, or the library cannot be stored.
    """
    plan = _Plan.of(configuration)
    if not cache.is_whole(plan.library):
        with plan.compiling() as process:
            plan.check(process.communicate()[1], process.returncode)
    return plan.library


async def compile_beside(configuration: Configuration) -> None:
    """Compile a build as `compiled` does, without blocking the event loop; cancellation ends the compiler.

    Raises:
        ConnectError: as for `compiled`.
    """
    plan = _Plan.of(configuration)
    if cache.is_whole(plan.library):
        return
    with plan.compiling() as process:
        # Wait in a thread, because not all event loops support processes of asyncio.
        errors = (await asyncio.to_thread(process.communicate))[1]
        plan.check(errors, process.returncode)


class _Plan(msgspec.Struct, frozen=True):
    """A compilation: the compiler's command, the build, and the path of the library."""

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
        """Run the compiler; store the library if the block ends without an exception."""
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
        """Raise `ConnectError` if the compiler has failed."""
        if code:
            lines = errors.decode(errors="replace").strip().splitlines()
            reason = next((line for line in lines if "error" in line), lines[0] if lines else f"exit code {code}")
            raise ConnectError(f"the gateware could not be compiled by {self.compiler[0]}: {reason}")


def compiler() -> list[str]:
    """Return the command of the C++ compiler.

    Raises:
        ConnectError: if no compiler is installed.
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
    """Return the folder of the cache for libraries and their C++; create it if it does not exist.

    Raises:
        ConnectError: if the folder cannot be created.
    """
    try:
        return cache.cache_folder("rtl")
    except OSError as error:
        raise _not_kept(Path(error.filename), error.strerror or str(error)) from error
