"""The generated clients in C and C++, built for fuzzing: an input chooses a gateway's answers and a program's calls.

`medium.h` is the gateway, `client.c` and `client.cc` are the programs; all other code is generated from `robot.ul`. For
a search, clang builds them with libFuzzer; gcc is enough to replay known inputs.
"""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING

from unity_link.generate import generate, write
from unity_link.spec import compile_file

if TYPE_CHECKING:
    from collections.abc import Sequence

HERE = Path(__file__).parent
PROGRAMS = {"client_c": "client.c", "client_cpp": "client.cc"}
"""The program of each target."""
CLANGS = ("clang", *(f"clang-{version}" for version in range(22, 11, -1)))
FLAGS = ("-g", "-fno-omit-frame-pointer", "-fno-sanitize-recover=all")
WITHOUT_CLANG = "clang with libFuzzer is needed to fuzz the clients in C and C++ (Debian: apt install clang)"


def build_search(target: str, folder: Path) -> Path:
    """Return a program that searches, built by clang.

    Raises:
        FileNotFoundError: if clang or its libFuzzer is missing.
    """
    clang = next((path for path in map(shutil.which, CLANGS) if path), None)
    if clang is None:
        raise FileNotFoundError(WITHOUT_CLANG)
    try:
        return _build(
            target, folder, [clang], [clang, "--driver-mode=g++"], "-O1", "-fsanitize=address,undefined,fuzzer"
        )
    except subprocess.CalledProcessError as error:
        if "libclang_rt.fuzzer" in error.stderr:
            raise FileNotFoundError(f"{WITHOUT_CLANG}: {clang} has none (apt install libclang-rt-14-dev)") from error
        raise


def build_replay(target: str, folder: Path) -> Path:
    """Return a program, built by gcc, that passes files to a target, whole and in pieces."""
    sources = [HERE / "replay.c"]
    return _build(target, folder, ["gcc"], ["g++"], "-O0", "-fsanitize=address,undefined", more=sources)


def _build(
    target: str, folder: Path, c: Sequence[str], cxx: Sequence[str], *options: str, more: Sequence[Path] = ()
) -> Path:
    write(generate("cpp", compile_file(HERE / "robot.ul")), folder)
    program = HERE / PROGRAMS[target]
    objects = []
    for source in (folder / "unity_link.c", folder / "robot.c", program, *more):
        made = folder / f"{source.name}.o"
        compiler, standard = (cxx, "-std=c++17") if source.suffix == ".cc" else (c, "-std=c99")
        includes = [f"-I{folder}", f"-I{HERE}"]
        _run([*compiler, standard, *FLAGS, *options, *includes, "-c", str(source), "-o", str(made)])
        objects.append(str(made))
    linker = cxx if program.suffix == ".cc" else c
    _run([*linker, *FLAGS, *options, *objects, "-o", str(folder / target)])
    return folder / target


def _run(command: list[str]) -> None:
    subprocess.run(command, capture_output=True, text=True, check=True)
