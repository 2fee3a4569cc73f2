"""Reads by programs in other languages, and by a bare one in C, each in a process of its own on a pseudo-terminal."""

from __future__ import annotations

import asyncio
import shutil
import subprocess
import tempfile
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from benchmarks.concurrent_reads import REQUEST, RESPONSE
from benchmarks.measure import Pair, Row
from benchmarks.responder import compiled
from unity_link.generate import generate, write
from unity_link.spec import compile_file

if TYPE_CHECKING:
    from collections.abc import Iterator

SOURCE = Path(__file__).with_name("round_trips.c")
SPEC = Path(__file__).parents[1] / "examples" / "scara.ul"
_OCTAVE = ("octave-cli", "--no-init-file", "--quiet", "--eval")
_SCRIPT = """\
link = unity_link.Link('serial:{path}');
seconds = zeros(1, {count});
for number = 1:{count}
  started = tic;
  word = link.read(10);
  seconds(number) = toc(started);
  assert(word == 168430090);
end
printf('%.9f\\n', median(seconds));
link.close();
"""


@contextmanager
def c_program() -> Iterator[Path]:
    """Compile the program that reads with the generated client or without one.

    Raises:
        FileNotFoundError: if there is no C compiler.
    """
    with tempfile.TemporaryDirectory() as folder:
        write(generate("c", compile_file(SPEC)), Path(folder))
        sources = [SOURCE, *sorted(Path(folder).glob("*.c"))]
        # Warnings are off, because the tests of the generated code check them.
        with compiled(sources, "-std=c99", "-w", f"-I{folder}") as program:
            yield program


def missing_octave() -> str:
    """Return an error text if the machine has no Octave; empty otherwise."""
    if shutil.which("octave-cli") and shutil.which("mkoctfile"):
        return ""
    return "it needs GNU Octave and its headers: apt install octave liboctave-dev"


@contextmanager
def octave_package() -> Iterator[Path]:
    """Build the package for Octave, and return its folder.

    Raises:
        FileNotFoundError: if there is no Octave.
    """
    if text := missing_octave():
        raise FileNotFoundError(text)
    with tempfile.TemporaryDirectory() as folder:
        write(generate("matlab", compile_file(SPEC)), Path(folder))
        _output([*_OCTAVE, "unity_link.build();"], Path(folder))
        yield Path(folder)


async def seconds_bare(program: Path, path: str, count: int) -> float:
    """Return the median of `count` round trips without a client, in seconds."""
    request = REQUEST.decode().removesuffix("\n")
    return await _printed([str(program), "bare", path, str(count), request, str(len(RESPONSE))])


async def seconds_in_c(program: Path, path: str, count: int) -> float:
    """Return the median of `count` reads by the client in C, in seconds."""
    return await _printed([str(program), "client", path, str(count)])


async def seconds_in_octave(package: Path, path: str, count: int) -> float:
    """Return the median of `count` reads in Octave, in seconds."""
    return await _printed([*_OCTAVE, _SCRIPT.format(path=path, count=count)], package)


async def _printed(command: list[str], folder: Path | None = None) -> float:
    return float(await asyncio.to_thread(_output, command, folder))


def _output(command: list[str], folder: Path | None) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"{command[0]} failed: {done.stderr.strip()}")
    return done.stdout


def row(question: str, pair: Pair, most: float) -> Row:
    """Return the row of a read that may take at most `most` times as long as that of a bare program."""
    return Row(
        question,
        f"{pair.ours * 1e6:.1f} us",
        f"{pair.bare * 1e6:.1f} us",
        f"{pair.ratio:.2f}",
        f"ratio at most {most}",
        pair.ratio <= most,
        pair.processor,
    )
