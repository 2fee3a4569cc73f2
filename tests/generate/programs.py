"""Functions that compile generated clients as a careful user would, and control them from a test."""

from __future__ import annotations

import math
import subprocess
from collections import deque
from pathlib import Path
from typing import TYPE_CHECKING, Self

from unity_link.generate import generate, write

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from types import TracebackType

    from unity_link.spec import Spec
    from unity_link.virtual.gateway import Gateway

C = ("gcc", "-std=c99")
CPP = ("g++", "-std=c++17")
STRICT = ("-pedantic", "-Wall", "-Wextra", "-Werror", "-Wshadow", "-Wconversion", "-O1")
SANITIZED = ("-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
HERE = Path(__file__).parent
PATIENCE = 120
"""Seconds after which a program is considered to hang; a loaded machine does not reach them."""
SIMULATED_PATIENCE = 600
"""Simulated seconds after which a program is considered to hang."""


def generated(target: str, spec: Spec, directory: Path) -> list[Path]:
    """Write the files of a target; return their paths."""
    return write(generate(target, spec), directory)


def compiled(compiler: Sequence[str], sources: Sequence[Path], directory: Path, *options: str) -> list[Path]:
    """Compile sources without warnings; return the object files."""
    objects = []
    for source in sources:
        made = directory / f"{source.name}.o"
        _run([*compiler, *STRICT, *options, f"-I{directory}", "-c", str(source), "-o", str(made)])
        objects.append(made)
    return objects


def checked(compiler: Sequence[str], source: Path, directory: Path) -> None:
    """Check the syntax and warnings of a source without compiling it, which is much faster."""
    warnings = ("-pedantic", "-Wall", "-Wextra", "-Werror")
    _run([*compiler, *warnings, f"-I{directory}", "-fsyntax-only", str(source)])


def linked(compiler: Sequence[str], objects: Sequence[Path], program: Path, *options: str) -> Path:
    """Link object files; return the program."""
    _run([*compiler, *options, *map(str, objects), "-o", str(program)])
    return program


def _run(command: list[str]) -> None:
    result = subprocess.run(command, capture_output=True, text=True, check=False, timeout=PATIENCE)
    assert result.returncode == 0, result.stderr[:4000]
    assert not result.stderr, result.stderr[:4000]


def output(program: Path, *arguments: str) -> str:
    """Run a program, which must succeed; return its output."""
    result = subprocess.run([program, *arguments], capture_output=True, text=True, timeout=PATIENCE, check=False)
    assert result.returncode == 0, result.stderr[:4000]
    return result.stdout


class Driven:
    """A client that reads commands, as `driver.c` does, and answers each with a line."""

    def __init__(self, program: Path) -> None:
        self._process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if error is not None:
            self._process.kill()
        self._process.communicate(timeout=PATIENCE)
        # The sanitizers end a program with another exit code if they found an error.
        assert error is not None or self._process.returncode == 0

    def __call__(self, command: str) -> str:
        """Send a command; return the answer."""
        self.send(command)
        return self.answer()

    def send(self, command: str) -> None:
        """Send a command without waiting for the answer."""
        assert self._process.stdin is not None
        self._process.stdin.write(f"{command}\n")
        self._process.stdin.flush()

    def answer(self) -> str:
        """Return the answer to a command."""
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        assert line, "the program has ended"
        return line.rstrip("\n")

    def words(self, command: str) -> list[int]:
        """Send a command that must succeed; return the numbers of its answer."""
        status, *numbers = self(command).split()
        assert status == "0", f"{command} gives {status} {' '.join(numbers)}"
        return [int(number) for number in numbers]


class Simulated(Driven):
    """A client on simulated time; ``connect test: 5`` connects it to a gateway of the test.

    Args:
        program: `driver.c`, compiled.
        gateway: function of bytes and the time; returns the bytes that arrive after `latency`.
        latency: seconds until an answer of the gateway arrives.
    """

    def __init__(self, program: Path, gateway: Callable[[bytes, float], bytes], latency: float = 0.001) -> None:
        super().__init__(program)
        self._gateway, self.latency = gateway, latency
        self._under_way: deque[tuple[float, bytes]] = deque()
        self.now = 0.0

    def answer(self) -> str:
        """Return the answer to a command; let simulated time pass until it arrives."""
        give_up = self.now + SIMULATED_PATIENCE
        while (line := super().answer()).startswith("~"):
            assert self.now < give_up, "the client does not end"
            _, seconds, *sent = line.split()
            arrived = self._wait(float.fromhex(seconds), bytes.fromhex("".join(sent)))
            self.send(f"{self.now.hex()} {arrived.hex()}")
        return line

    def _wait(self, seconds: float, sent: bytes) -> bytes:
        answer = self._gateway(sent, self.now)
        if answer:
            self._under_way.append((self.now + self.latency, answer))
        until = self.now + seconds
        if self._under_way and self._under_way[0][0] <= until:
            self.now, arrived = self._under_way.popleft()
            return arrived
        # Advance by at least the smallest step of a float, so that time always passes.
        self.now = max(until, math.nextafter(self.now, math.inf))
        return b""


class SimulatedLine(Simulated):
    """A client on simulated time with a line that delays bytes: the line returns the bytes that arrive, and when."""

    def __init__(self, program: Path, line: Gateway) -> None:
        super().__init__(program, line.receive)
        self._line = line

    def _wait(self, seconds: float, sent: bytes) -> bytes:
        until = max(self.now + seconds, math.nextafter(self.now, math.inf))
        arrived = self._line.receive(sent, self.now)
        while not arrived and (due := self._line.next_due) is not None and due <= until:
            self.now = max(due, self.now)
            arrived = self._line.advance(self.now)
        if not arrived:
            self.now = until
        return arrived
