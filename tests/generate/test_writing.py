"""Files written by `generate`, `fmt` and `export` are complete, or not written; on a full disk the old files stay."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from support.unmeasured import unmeasured_environment
from unity_link import ArgumentError
from unity_link.files import MARK
from unity_link.generate import GeneratedFile, write

MARKED = f"# {MARK} generate x`\n"
SPEC = Path(__file__).parents[2] / "examples" / "walker.ul"
ON_A_FULL_DISK = """
import resource, signal, sys
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[1]), resource.RLIM_INFINITY))
sys.argv[1:] = sys.argv[2:]
from unity_link.cli import main
main()
"""


def on_a_full_disk(room: int, *arguments: str | Path) -> str:
    """Run a command in a process whose files may have at most `room` bytes; return its message."""
    command = [sys.executable, "-B", "-c", ON_A_FULL_DISK, str(room), *map(str, arguments)]
    environment = unmeasured_environment()
    result = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False, env=environment)
    assert (result.returncode, result.stdout) == (2, ""), result
    (line,) = result.stderr.splitlines()
    return line


def tree(folder: Path) -> dict[str, str]:
    return {
        str(path.relative_to(folder)): path.read_text() if path.is_file() else "" for path in sorted(folder.rglob("*"))
    }


@pytest.mark.slow
@pytest.mark.parametrize("target", ["c", "vhdl"])
def test_a_full_disk_leaves_no_generated_file(target: str, tmp_path: Path) -> None:
    said = on_a_full_disk(4000, "generate", target, SPEC, "-o", tmp_path / "new" / "folder")

    assert said.startswith(f"error: {tmp_path / 'new' / 'folder'}/")
    assert said.endswith(" cannot be written: File too large")
    assert tree(tmp_path) == {}


def test_a_full_disk_leaves_the_files_of_before(tmp_path: Path) -> None:
    write([GeneratedFile("robot.h", "before\n"), GeneratedFile("more/robot.c", "before\n")], tmp_path)
    before = tree(tmp_path)
    after = [GeneratedFile("robot.h", "after\n"), GeneratedFile("more/robot.c", "x" * 10_000)]
    code = (
        f"import sys; sys.path[:0] = {sys.path!r}\n"
        f"""
import resource
from pathlib import Path
from unity_link.generate import GeneratedFile, write
resource.setrlimit(resource.RLIMIT_FSIZE, (5000, resource.RLIM_INFINITY))
try:
    write([GeneratedFile(*file) for file in {[tuple(file) for file in after]!r}], Path({str(tmp_path)!r}))
except Exception as error:
    print(error)
"""
    )
    result = subprocess.run([sys.executable, "-B", "-c", code], capture_output=True, text=True, timeout=60, check=True)

    assert result.stdout == f"{tmp_path / 'more' / 'robot.c'} cannot be written: File too large\n"
    assert tree(tmp_path) == before


def test_files_are_replaced_and_programs_are_executable(tmp_path: Path) -> None:
    write([GeneratedFile("a/b", MARKED)], tmp_path)

    files = [GeneratedFile("a/b", MARKED * 2, executable=True), GeneratedFile("c", ""), GeneratedFile("c.h", MARKED)]
    paths = write(files, tmp_path)

    assert paths == [tmp_path / "a" / "b", tmp_path / "c", tmp_path / "c.h"]
    assert tree(tmp_path) == {"a": "", "a/b": MARKED * 2, "c": "", "c.h": MARKED}
    assert paths[0].stat().st_mode & 0o111


def test_folder_with_the_name_of_a_file_is_reported_and_nothing_is_written(tmp_path: Path) -> None:
    (tmp_path / "c").mkdir()

    with pytest.raises(ArgumentError, match=r"/c cannot be written: Is a directory$"):
        write([GeneratedFile("a/b", "new"), GeneratedFile("c", "")], tmp_path)

    assert tree(tmp_path) == {"c": ""}


@pytest.mark.slow
def test_a_full_disk_leaves_a_spec_as_it_was_and_half_of_none(tmp_path: Path) -> None:
    spec = tmp_path / "robot.ul"
    lines = "".join(f"  @s{number}={number}:READ();\n" for number in range(200))
    spec.write_text(f"public robot() {{\n{lines}}}\n")
    before = tree(tmp_path)

    assert on_a_full_disk(1000, "fmt", spec).endswith("cannot be written: File too large")
    assert on_a_full_disk(1000, "export", "rdl", spec, "-o", tmp_path / "robot.rdl").endswith(": File too large")

    assert tree(tmp_path) == before
