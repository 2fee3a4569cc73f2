"""A spec of hostile strings, in a file with a hostile name: generated files have the structure of a plain spec's files.

The structure of a file is the output of its language's own parser, or the text without strings and comments.
"""

from __future__ import annotations

import ast
import configparser
import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree as ET

import pytest
import yaml

from support.readers import Tags, shape_of_markdown
from unity_link.generate import TARGETS, generate
from unity_link.spec import compile_file, compile_text

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.generate import GeneratedFile

# `tests/test_quoting.py` covers the strings that neither a spec nor a file name can contain.
HOSTILE_NAME = (
    "rover\nimport os;os.system('touch PWNED')#\r-->\u2028coding:utf-7 \"\"\" ''' \\ $(touch P) [exec] *\udce4.ul"
)
HOSTILE = (
    "-->]]><script>alert(1)</script> \"\"\" ''' \\ // ; pragma translate_off {{ 1 }} ${x} $(x) [exec touch PWNED]"
    " %{ #[[ | ` ` coding:utf-7 ??/"
)
HOSTILE_LINES = (
    f"{HOSTILE}\n/// pragma translate_off\n/// # coding: utf-7\n/// {HOSTILE}\n///     endmodule\u2028end;\x85exit(1)"
)
SPEC = """
/// DOC
public robot() {
  GATEWAY(ADDRESS_BITS=8, DATA_BITS=32);
  /// DOC
  @a = 0x10: signed 16 READWRITE(ID=TEXT, UNIT=TEXT);
  /// DOC
  @b = 0x11: mode READ(UNIT=TEXT2, PUBLISH(state));
  /// DOC
  arm[2]: joint() @(0x20 + 4 * i);
}
/// DOC
joint(): @(base) {
  /// DOC
  @p = base: fixed 8.8 READWRITE(UNIT=TEXT);
}
/// DOC
group state(NUMBER=1, RATE=100);
/// DOC
enum mode {
  /// DOC
  off = 0,
  /// DOC
  on = 1,
}
"""
PACKAGE = {"maintainer": HOSTILE, "email": HOSTILE, "licence": HOSTILE}
PLAIN_PACKAGE = {"maintainer": "A", "email": "a@example.com", "licence": "MIT"}
STRING = re.compile(r'"(?:[^"\\\n]|\\.)*"')
STRING_OF_MATLAB = re.compile(r"'(?:[^'\n]|'')*'")


def spec_text(doc: str, text: str) -> str:
    literal = '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'
    return SPEC.replace("DOC", doc).replace("TEXT2", literal).replace("TEXT", literal)


def without_comments(text: str) -> str:
    """Return a text in C or C++ without the comments, as the preprocessor sees them."""
    done = subprocess.run(
        ["cc", "-fpreprocessed", "-dD", "-E", "-P", "-x", "c", "-"],
        input=text,
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout


def shape_of_python(text: str) -> str:
    tree = ast.parse(text.encode())
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            node.value = ""
    return ast.dump(tree)


def shape_of_xml(text: str) -> list[Any]:
    return [(one.tag, sorted(one.keys())) for one in ET.fromstring(text).iter()]


def shape_of_ini(text: str) -> dict[str, dict[str, str]]:
    parser = configparser.ConfigParser(interpolation=None)
    parser.read_string(text)
    return {name: dict(section) for name, section in parser.items()}


def shape_of_matlab(text: str) -> str:
    lines = (re.sub(r"^( *)%.*|(?<=\w)    % .*", "", line) for line in text.split("\n"))
    # A long string moves to its own line.
    return "".join("".join(re.sub(r"\.\.\.$", "", STRING_OF_MATLAB.sub("''", line)).split()) for line in lines)


def without_lines(sign: str) -> Callable[[str], list[str]]:
    """Return a function that drops comments which are lines of their own."""
    return lambda text: [line for line in text.split("\n") if line.strip() and not line.lstrip().startswith(sign)]


SHAPES: dict[str, Callable[[str], Any]] = {
    ".py": shape_of_python,
    **dict.fromkeys((".c", ".h", ".hpp"), lambda text: STRING.sub('""', without_comments(text))),
    **dict.fromkeys((".xml", ".launch"), shape_of_xml),
    ".md": shape_of_markdown,
    ".html": lambda text: Tags(text).found,
    ".yaml": yaml.safe_load,
    ".cfg": shape_of_ini,
    ".m": shape_of_matlab,
    ".vhd": without_lines("--"),
    ".v": without_lines("//"),
    ".txt": without_lines("#"),
    ".ul": without_lines("//"),
}


def shape(file: GeneratedFile) -> Any:
    """Return the structure of a file, without strings and comments."""
    suffix = ".py" if file.executable else Path(file.name).suffix
    return SHAPES[suffix](file.text) if suffix else file.text


def made(
    target: str, folder: Path, name: str, doc: str, text: str, package: dict[str, str]
) -> dict[str, GeneratedFile]:
    path = folder / name
    path.write_text(spec_text(doc, text), encoding="utf-8")
    options = package if target in {"ros1", "ros2"} else {}
    spec = compile_file(path)
    # These numbers are computed from the strings, so give all specs the same numbers.
    same = compile_text("public same() { @a = 1: READ(); }").interface()
    facts = {"description": b"the same of each", "describe_open": same.describe_open, "fingerprint": 0x12345678}
    vars(spec.interface()).update(facts)
    return {file.name: file for file in generate(target, spec, **options)}


@pytest.mark.parametrize(
    "target", [pytest.param(one, marks=pytest.mark.slow) if one == "verilog" else one for one in TARGETS]
)
def test_hostile_strings_change_only_strings_and_comments(target: str, tmp_path: Path) -> None:
    plain = made(target, tmp_path, "plain.ul", "Plain.\n/// Lines.", "plain", PLAIN_PACKAGE)
    hostile = made(target, tmp_path, HOSTILE_NAME, HOSTILE_LINES, HOSTILE, PACKAGE)
    assert plain.keys() == hostile.keys()
    for name, file in hostile.items():
        assert [one for one in file.text if not one.isprintable() and one not in "\n\t"] == [], name
        assert shape(file) == shape(plain[name]), name


@pytest.mark.skipif(shutil.which("ghdl") is None, reason="no simulator: apt install ghdl-mcode")
def test_ghdl_reads_the_vhdl_of_hostile_strings(tmp_path: Path) -> None:
    files = made("vhdl", tmp_path, HOSTILE_NAME, HOSTILE_LINES, HOSTILE, {})
    for part in ("map", "registers"):
        (tmp_path / f"robot_{part}.vhd").write_text(files[f"robot_{part}.vhd"].text, encoding="utf-8")
        done = subprocess.run(
            ["ghdl", "-a", "--std=08", "--warn-error", f"robot_{part}.vhd"],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr


@pytest.mark.slow
@pytest.mark.parametrize("target", ["ros1", "ros2"])
def test_code_after_a_line_end_in_the_name_of_a_spec_does_not_run(target: str, tmp_path: Path) -> None:
    name = "rover\nimport os;os.system('touch PWNED')#.ul"
    for file in made(target, tmp_path, name, "Plain.", "plain", PLAIN_PACKAGE).values():
        if file.name.endswith((".py", "/bridge")):
            path = tmp_path / file.name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(file.text)
            # The program may fail without ROS; it must not run the commands in the name of its spec.
            subprocess.run(["python3", path.name], cwd=path.parent, capture_output=True, check=False, timeout=60)
    assert not [folder for folder, _, files in os.walk(tmp_path) if "PWNED" in files]
