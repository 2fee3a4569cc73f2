"""Runs the tests of files that differ from BASE: ``python -m support.check [BASE]``, for `make check`.

Uncommitted and untracked files count too. By default BASE is the commit at which the branch left `main`; on `main` it
is
the commit before the last one. Slow tests are left out: `make test-all` runs them.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
ALWAYS = ("tests/test_check.py", "tests/test_project.py", "tests/test_structure.py")
QUICK = "not slow and not campaign and not usb"
_LISTS = "gateware/bench/test_lists.py"
_TOPS = ("tests", "gateware/bench", "gateware/cores")


def changed_files(base: str | None = None) -> list[str]:
    """Return the files that differ from a commit, and the untracked files."""
    base = base or _base()
    names = [*_git("diff", "--name-only", "--no-renames", base), *_git("ls-files", "--others", "--exclude-standard")]
    return sorted(set(names))


def _base() -> str:
    head = _git("rev-parse", "HEAD")
    for branch in ("main", "origin/main"):
        if _git("rev-parse", "--verify", "--quiet", branch, check=False):
            left = _git("merge-base", "HEAD", branch)
            if left != head:
                return left[0]
    return _git("rev-parse", "HEAD~")[0]


def _git(*arguments: str, check: bool = True) -> list[str]:
    done = subprocess.run(["git", "-c", "core.quotePath=off", *arguments], cwd=ROOT, check=check, capture_output=True)
    return done.stdout.decode().splitlines()


def tests_of(files: list[str]) -> list[str]:
    """Return the files and folders of tests of the given files; all paths are relative to the root."""
    found = {path for file in files for path in _tests_of(file)} | set(ALWAYS)
    inside = {path for path in found if any(parent.as_posix() in found for parent in Path(path).parents)}
    return sorted(path for path in found - inside if (ROOT / path).exists())


def _tests_of(file: str) -> list[str]:
    path = Path(file)
    match path.parts:
        case ("tests", "support", _):
            found = _users(rf"support(\.| import ){path.stem}\b")
        case ("tests", _) | ("gateware", "bench", _) if path.name.startswith("test_"):
            found = [file]
        case ("tests", room, *_):
            found = [file if path.name.startswith("test_") else f"tests/{room}"]
        case ("gateware", *inside):
            found = _tests_of_gateware(inside)
        case ("benchmarks", *_):
            found = ["tests/benchmarks"]
        case ("unity_link", *inside):
            found = _tests_of_package(inside)
        case ("docs", *_) | ("README.md",) if path.suffix == ".md":
            found = [file, *_naming(path.name)]
        case _:
            found = _naming(path.name)
    return found


def _tests_of_gateware(inside: list[str]) -> list[str]:
    """Return the tests of a file in `gateware/`, given the parts of its path there."""
    path = Path(*inside)
    entity = path.stem.removeprefix("ul_")
    match inside:
        case ("bench", room, *rest):
            return [f"gateware/bench/{room}" if rest else "gateware/bench"]
        case ("cores", core, _):
            return [f"gateware/cores/{core}", *([_LISTS] if path.suffix == ".vhd" else [])]
        case ("rtl", *_) if (ROOT / "gateware/bench" / entity).is_dir():
            return [f"gateware/bench/{entity}", _LISTS]
        case ("tools", _):
            return _users(rf"gateware\.tools(\.| import .*){path.stem}\b")
    return _naming(path.name)


def _tests_of_package(inside: list[str]) -> list[str]:
    """Return the tests of a file in `unity_link/`: of its module, of its package, or otherwise all that import it."""
    room, rest = Path(inside[0]).stem, inside[1:]
    name = ".".join(["unity_link", room, *(Path(part).stem for part in rest[:1])])
    if (ROOT / "tests" / room).is_dir():
        return _of_part(room, rest[0], name) if len(rest) > 1 else [f"tests/{room}"]
    of_module = [path for path in _test_files("tests") if Path(path).match(f"tests/test_{room}*.py")]
    return of_module or _users(rf"{re.escape(name)}\b")


def _of_part(room: str, part: str, name: str) -> list[str]:
    """Return the tests of a part of a package: its folder, and all that import or name it; otherwise the package."""
    found = [
        path
        for path in _test_files(f"tests/{room}")
        if f"_{part}" in Path(path).stem or re.search(rf"\b{re.escape(name)}\b", (ROOT / path).read_text())
    ]
    folder = f"tests/{room}/{part}"
    return [folder, *found] if (ROOT / folder).is_dir() else found or [f"tests/{room}"]


def _users(pattern: str) -> list[str]:
    """Return the tests that import a module, directly or through shared code (then the folder of the shared code)."""
    users: list[str] = []
    for path in _test_files(*_TOPS, tests_only=False):
        if not re.search(rf"^\s*(from|import) .*{pattern}", (ROOT / path).read_text(), re.MULTILINE):
            continue
        # All benches import the shared code of `gateware/bench`, so that a change of it would select every bench.
        if Path(path).parent.as_posix() not in _TOPS or Path(path).name.startswith("test_"):
            users += _tests_of(path)
    return users


def _naming(name: str) -> list[str]:
    """Return the tests whose source contains the name of a file."""
    return [path for path in _test_files(*_TOPS) if re.search(rf"\b{re.escape(name)}\b", (ROOT / path).read_text())]


def _test_files(*folders: str, tests_only: bool = True) -> list[str]:
    pattern = "test_*.py" if tests_only else "*.py"
    return [path.relative_to(ROOT).as_posix() for folder in folders for path in sorted((ROOT / folder).rglob(pattern))]


def marks_of(files: list[str]) -> str:
    """Return the expression for `pytest -m`: tests of compiled gateware run only if a changed file belongs to it."""
    of_gateware = any(file.startswith("gateware/") or "rtl" in file for file in files)
    return QUICK if of_gateware else f"{QUICK} and not rtl"


def main() -> int:
    """Run the tests of the changed files; return the exit code of pytest."""
    files = changed_files(next((argument for argument in sys.argv[1:2] if argument), None))
    paths = tests_of(files)
    print(f"{len(files)} changed files, tests of: {' '.join(paths)}", flush=True)  # noqa: T201  (a command for people)
    command = [sys.executable, "-m", "pytest", "--numprocesses", "auto", "-q", "-m", marks_of(files), *paths]
    return subprocess.run(command, cwd=ROOT, check=False).returncode


if __name__ == "__main__":
    raise SystemExit(main())
