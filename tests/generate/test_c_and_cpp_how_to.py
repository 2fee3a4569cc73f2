"""The programs of docs/how-to/c-and-cpp.md compile and run, and print the text below them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from generate.peers import simulate
from generate.programs import CPP, HERE, C, compiled, generated, linked, output
from unity_link.spec import compile_file, compile_text

if TYPE_CHECKING:
    from pathlib import Path

ROWS = """
group motion(RATE=100);
imu(): @(at) { @acc[2] = at + i: signed 16 READ(PUBLISH(motion)); }
public arm() { imu: imu() @(0x10); }
"""
ROOT = HERE.parents[1]
BLOCKS = re.findall(r"^```(\w+)\n(.*?)^```$", (ROOT / "docs/how-to/c-and-cpp.md").read_text(), re.DOTALL | re.MULTILINE)


def blocks(language: str) -> list[str]:
    return [text for name, text in BLOCKS if name == language]


@pytest.fixture(scope="module")
def arm(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    directory = tmp_path_factory.mktemp("arm")
    files = generated("cpp", compile_file(ROOT / "examples/scara.ul"), directory)
    return compiled(C, [path for path in files if path.suffix == ".c"], directory)


@pytest.mark.slow
@pytest.mark.parametrize(("language", "compiler"), [("c", C), ("cpp", CPP)])
def test_program_prints_the_output_on_the_page(
    language: str, compiler: tuple[str, ...], arm: list[Path], tmp_path: Path
) -> None:
    source = tmp_path / f"arm.{language}"
    source.write_text(blocks(language)[0])
    objects = compiled(compiler, [source], tmp_path, f"-I{arm[0].parent}")
    program = linked(compiler, [*arm, *objects], tmp_path / "arm")
    with simulate("tcp", "--robot", "scara") as url:
        printed = output(program, url)
    expected = blocks("text")[0 if language == "c" else -1]
    # The machine determines in which sample the joint has passed 29.9; accept values around it.
    assert re.sub(r"\b(29\.9\d*|30(\.\d+)?)\b", "29.9", printed) == expected


@pytest.mark.slow
def test_functions_on_the_page_work_as_described(arm: list[Path], tmp_path: Path) -> None:
    whole, *parts = blocks("c")
    head = whole[: whole.index("int main")]
    main = (
        "int main(int count, char **arguments)\n{\n    uint64_t speed, position;\n    (void)count;\n"
        "    if (ul_connect(&arm, arguments[1], 5.0) || exchange(&speed, &position) || watch(0x8C)) return give_up();\n"
        "    return ul_close(&arm);\n}\n"
    )
    source = tmp_path / "parts.c"
    source.write_text(head + "".join(parts) + main)
    objects = compiled(C, [source], tmp_path, f"-I{arm[0].parent}")
    with simulate("tcp", "--robot", "scara") as url:
        printed = output(linked(C, [*arm, *objects], tmp_path / "parts"), url)
    assert [line.split()[1] for line in printed.splitlines()] == ["1200"] * 5


def test_the_structure_of_a_group_has_the_members_that_the_page_names(tmp_path: Path) -> None:
    page = (ROOT / "docs/how-to/c-and-cpp.md").read_text()
    header = {path.name: path.read_text() for path in generated("c", compile_text(ROWS), tmp_path)}["arm.h"]
    for member in re.findall(r"`motion\.(\w+)` of `imu\.acc\[0\]`", page):
        assert re.search(rf"\b{member};", header)
    assert "`motion.imu_acc_0` of" in page
