"""Compiles the gateware's C++ at first use, keeps the result, and loads it.

A compiled library is kept in the user's cache under a hash of its sources, of the compiler and of its options, so that
it is never stale; a few seconds are spent once after an installation or an update.
"""

from __future__ import annotations

import ctypes
import functools
import hashlib
import os
import shutil
import subprocess
import tempfile
from ctypes import POINTER, c_int, c_size_t, c_uint8, c_uint64, c_void_p
from pathlib import Path

from unity_link.errors import ArgumentError, ConnectError

_HERE = Path(__file__).parent
_GENERATED = _HERE / "generated"
_RUNTIME = _HERE / "cxxrtl_runtime"
_SHIM = _HERE / "shim.cc"
_COMPILERS = ("c++", "g++", "clang++")
_OPTIONS = ("-O3", "-std=c++14", "-shared", "-fPIC")

DeviceFunction = ctypes.CFUNCTYPE(c_int, c_void_p, c_uint64, c_int, POINTER(c_uint64))
"""`Device` of shim.cc: context, address, whether it is a write, the word; gives an Answer."""

_PROTOTYPES: dict[str, tuple[type | None, tuple[type, ...]]] = {
    "ul_create": (c_void_p, ()),
    "ul_destroy": (None, (c_void_p,)),
    "ul_reset": (None, (c_void_p,)),
    "ul_run": (None, (c_void_p, c_uint64)),
    "ul_run_until_quiet": (c_uint64, (c_void_p, c_uint64)),
    "ul_cycles": (c_uint64, (c_void_p,)),
    "ul_flushes": (c_uint64, (c_void_p,)),
    "ul_push": (None, (c_void_p, ctypes.c_char_p, c_size_t)),
    "ul_waiting": (c_size_t, (c_void_p,)),
    "ul_lose": (None, (c_void_p,)),
    "ul_set_room": (None, (c_void_p, c_size_t)),
    "ul_available": (c_size_t, (c_void_p,)),
    "ul_pull": (c_size_t, (c_void_p, ctypes.c_char_p, c_size_t)),
    "ul_set_trigger": (None, (c_void_p, c_int)),
    "ul_read_memory": (c_uint64, (c_void_p, c_uint64)),
    "ul_write_memory": (None, (c_void_p, c_uint64, c_uint64)),
    "ul_used_memory": (c_size_t, (c_void_p, POINTER(c_uint64), c_size_t)),
    "ul_set_behind": (None, (c_void_p, c_uint64, c_uint8)),
    "ul_set_device": (None, (c_void_p, DeviceFunction, c_void_p)),
}


def configurations() -> list[str]:
    """Return the names of the configurations that are part of this installation."""
    return sorted(path.stem for path in _GENERATED.glob("*.cc"))


@functools.cache
def load(configuration: str) -> ctypes.CDLL:
    """Return the library of one configuration, compiled if need be.

    Raises:
        ArgumentError: for a configuration that there is not.
        ConnectError: where no C++ compiler is installed, or it fails.
    """
    known = configurations()
    if configuration not in known:
        raise ArgumentError(
            f"there is no gateware {configuration!r}: this installation has {', '.join(known) or 'none'}"
        )
    library = ctypes.CDLL(str(_compiled(_GENERATED / f"{configuration}.cc")))
    for name, (result, arguments) in _PROTOTYPES.items():
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


def _compiled(model: Path) -> Path:
    """Return the shared library of a generated file, compiled unless that was done before."""
    compiler = _compiler()
    version = subprocess.run([compiler, "--version"], check=False, capture_output=True, text=True).stdout  # noqa: S603
    digest = hashlib.sha256("\0".join((version, *_OPTIONS)).encode())
    for source in (model, _SHIM, *sorted(_RUNTIME.rglob("*.h"))):
        digest.update(source.read_bytes())
    library = _cache() / f"{model.stem}-{digest.hexdigest()[:16]}.so"
    if library.exists():
        return library
    with tempfile.TemporaryDirectory(dir=library.parent) as scratch:
        built = Path(scratch, library.name)
        command = [
            compiler,
            *_OPTIONS,
            f"-I{_RUNTIME}",
            f'-DUL_MODEL="{model}"',
            str(_SHIM),
            "-o",
            str(built),
        ]
        done = subprocess.run(command, check=False, capture_output=True, text=True)  # noqa: S603
        if done.returncode:
            reason = (done.stderr.strip().splitlines() or ["no reason given"])[0]
            raise ConnectError(f"the gateware could not be compiled by {compiler}: {reason}")
        # Two programs may compile at once: each puts its own in place, and both are the same.
        built.replace(library)
    return library


def _compiler() -> str:
    chosen = os.environ.get("CXX")
    candidates = (chosen,) if chosen else _COMPILERS
    for candidate in candidates:
        found = shutil.which(candidate)
        if found:
            return found
    if chosen:
        raise ConnectError(f"the C++ compiler that CXX names, {chosen!r}, is not there: unset CXX, or install it")
    raise ConnectError("the gateware runs in a process after a C++ compiler has seen it: apt install g++ (or clang)")


def _cache() -> Path:
    base = os.environ.get("XDG_CACHE_HOME")
    folder = Path(base) if base else Path.home() / ".cache"
    folder = folder / "unity-link" / "rtl"
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ConnectError(
            f"the compiled gateware can't be kept in {folder} ({error.strerror}): name another folder in XDG_CACHE_HOME"
        ) from error
    return folder
