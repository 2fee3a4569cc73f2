"""The programs of the pages are typed: mypy --strict and pyright find no faults in them, and find those of wrong ones.

The blocks of a page are one program, as its reader types them one by one; blocks with the name of a file are files.
The generated class of a spec replaces each call that loads the spec, so that each signal has its type.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from docs.walkthrough import PAGES, WALKTHROUGHS, blocks
from unity_link.data.robot import class_name
from unity_link.generate import generate, write
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from collections.abc import Callable

ROOT = Path(__file__).parents[1]
LOAD = re.compile(r"unity_link\.load\((?:\"([\w/.]+)\"|path|compile_text\(\w+\))\)")
"""Matches a call that loads a spec, by its path or from the text before the call."""
TEXT = re.compile(r'= """\n(public .*?)"""', re.DOTALL)
UNTYPED = ("Argument", "Member", "Variable")
"""Rules of pyright that packages without types break."""
MACHINE = """\
enum mode { idle, balance }
public machine() {
  @angle = 1: signed READ(SCALE=0.1, PUBLISH(state));
  @duty = 2: signed READWRITE(SCALE=0.1);
  @mode = 3: mode 2 READWRITE(PUBLISH(state));
  @queue = 4: mode 32 READWRITE(FIFO);
}
group state(1, 100);
"""
RIGHT = """\
from typing import assert_type

import unity_link
from machine import Machine, Mode
from unity_link.data import Group, ReadWrite


async def switch(signal: ReadWrite[float]) -> None:
    await signal.set(3)


async def main(link: unity_link.Link) -> None:
    machine = Machine(link)
    await machine.mode.set("balance")
    await machine.mode.post(Mode.idle)
    await machine.mode.set(3)
    assert await machine.mode.get() == "balance"
    await machine.queue.set("idle")
    await switch(machine.duty)
    assert_type(await machine.mode.get(), Mode | int)
    assert_type(machine.duty.value, float | None)
    async for sample in Group(machine.angle, machine.mode, rate_hz=10):
        assert_type(sample[machine.angle], float)
        assert_type(sample[machine.mode], Mode | int)
        assert_type(sample.lost, int)
"""
WRONG = """\
import unity_link
from machine import Machine


async def main(link: unity_link.Link) -> None:
    machine = Machine(link)
    machine.mode.set("balance")  # wrong
    await machine.mode.set("balanced")  # wrong
    await machine.queue.set("balanced")  # wrong
    await machine.angle.set(1)  # wrong
    async with machine.groups["state"].subscribe() as samples:
        async for now in samples:
            print(now[machine.angle].upper())  # wrong
            print(now[machine.missing])  # wrong
    print((await machine.groups["state"].get())[machine.angle].upper())  # wrong
"""


def write_module(text: str, folder: Path, path: Path | None = None) -> tuple[str, str]:
    """Write the generated module of a spec into its own package; return the names of the module and the robot's class.

    The cores of the spec are found relative to `path`.
    """
    spec = compile_text(text, path=path)
    package = f"spec_{hashlib.sha256(text.encode()).hexdigest()[:12]}"
    (module,) = write(generate("python", spec), folder / package)
    return f"{package}.{module.stem}", class_name(spec.interface().name)


def folder_of(page: Path, folder: Path) -> Path:
    """Return the folder for the programs of a page."""
    return folder / f"page_{page.stem.replace('-', '_').lower()}"


def write_programs(page: Path, folder: Path) -> None:
    """Write the programs of a page into the page's folder, each line at its line number on the page."""
    specs: dict[str, str] = {}
    programs: dict[str, list[str]] = {}
    for block in blocks(page):
        if block.language == "ul":
            specs[block.caption] = block.text
        elif block.language == "python":
            lines = programs.setdefault(block.caption or "page.py", [])
            lines += [""] * (block.line - 1 - len(lines)) + block.text.splitlines()
    own = folder_of(page, folder)
    for name, text in specs.items():
        if name:
            (own / name).parent.mkdir(parents=True, exist_ok=True)
            (own / name).write_text(text, encoding="utf-8")
        if f"generate python {name}" in page.read_text(encoding="utf-8"):
            write(generate("python", compile_text(text)), own)
    for name, lines in programs.items():
        own.mkdir(exist_ok=True)
        (own / name).write_text(with_classes("\n".join(lines) + "\n", specs, folder, own), encoding="utf-8")


def with_classes(program: str, specs: dict[str, str], folder: Path, own: Path) -> str:
    """Return a program in which the generated class of each spec replaces the call that loads it."""
    before = TEXT.search(program)
    imports: set[str] = set()

    def generated(load: re.Match[str]) -> str:
        path = load[1]
        if path is None:
            assert before is not None, load[0]
            spec = before[1]
        else:
            found = next(file for file in (ROOT / path, ROOT / "examples" / path) if path in specs or file.exists())
            spec = specs.get(path) or found.read_text(encoding="utf-8")
        module, robot = write_module(spec, folder, own / (path or "page.ul"))
        imports.add(f"import {module}")
        return f"{module}.{robot}"

    program = LOAD.sub(generated, program)
    # The first line of a page is its title, so that no program begins there.
    return "; ".join(sorted(imports)) + program


def by_mypy(folder: Path) -> list[str]:
    """Return the faults that mypy finds in the programs of all folders in `folder`."""
    options = ["--strict", "--config-file=", f"--cache-dir={ROOT / '.mypy_cache'}", "--explicit-package-bases"]
    # Each program of a page defines `main` again, and some packages have no types.
    options += ["--disable-error-code=no-redef", "--disable-error-code=import-untyped"]
    places = [folder, folder / "own", *(folder_of(Path(page), folder) for page in WALKTHROUGHS), ROOT]
    done = subprocess.run(
        [sys.executable, "-m", "mypy", *options, "."],
        cwd=folder,
        env=os.environ | {"MYPYPATH": os.pathsep.join(map(str, places))},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stdout, done.stderr
    return [line for line in done.stdout.splitlines() if ": error:" in line]


def by_pyright(folder: Path) -> list[str]:
    """Return the faults that pyright finds in the programs of all folders in `folder`."""
    settings = {
        "typeCheckingMode": "strict",
        "extraPaths": [str(folder), str(ROOT)],
        # As for mypy; besides, a page imports names for its reader that its own blocks do not use.
        **dict.fromkeys(
            ["reportRedeclaration", "reportMissingTypeStubs", *map("reportUnknown{}Type".format, UNTYPED)], False
        ),
        **dict.fromkeys(["reportDuplicateImport", "reportUnusedImport", "reportUnusedVariable"], False),
    }
    (folder / "pyrightconfig.json").write_text(json.dumps(settings))
    done = subprocess.run(
        [sys.executable, "-m", "basedpyright", "--outputjson", "--pythonpath", sys.executable, "-p", str(folder)],
        capture_output=True,
        text=True,
        check=False,
    )
    found = json.loads(done.stdout)
    assert found["summary"]["filesAnalyzed"], done.stdout + done.stderr
    return [
        f"{Path(fault['file']).relative_to(folder)}:{fault['range']['start']['line'] + 1}: {fault['severity']}: "
        f"{fault['message']}  [{fault.get('rule')}]"
        for fault in found["generalDiagnostics"]
    ]


@pytest.fixture(scope="module")
def programs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the programs of all pages, and those of this file."""
    folder = tmp_path_factory.mktemp("programs")
    for page in PAGES:
        write_programs(page, folder)
    (module,) = write(generate("python", compile_text(MACHINE)), folder / "own")
    assert module.name == "machine.py"
    (folder / "own" / "right.py").write_text(RIGHT)
    (folder / "own" / "wrong.py").write_text(WRONG)
    return folder


@pytest.mark.slow
@pytest.mark.parametrize("check", [by_mypy, by_pyright])
def test_programs_of_the_pages_are_typed_and_wrong_ones_are_found(
    check: Callable[[Path], list[str]], programs: Path
) -> None:
    found = check(programs)
    elsewhere = [fault for fault in found if not fault.startswith("own/wrong.py:")]
    assert not elsewhere, "\n".join(elsewhere)
    wrong = {number for number, line in enumerate(WRONG.splitlines(), 1) if line.endswith("# wrong")}
    assert {int(fault.split(":")[1]) for fault in found} == wrong
