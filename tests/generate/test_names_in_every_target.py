"""Generated files are valid in their language for all names and texts of a spec. `test_c.py` has C and C++."""

from __future__ import annotations

import ast
import builtins
import keyword
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from typing import TYPE_CHECKING

import pytest
from hypothesis import Phase, given, settings

from generate.awkward_names import LONG, awkward_specs
from generate.octave import Octave, why_not
from generate.programs import generated
from support.searching import examples
from unity_link.errors import UnityLinkError
from unity_link.gateware.words import SYSTEMVERILOG
from unity_link.generate import TARGETS, generate
from unity_link.generate.matlab.names import KEYWORDS, MEMBERS
from unity_link.generate.vhdl.names import RESERVED
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from pathlib import Path

IN_PYTHON = (
    *keyword.kwlist,
    *keyword.softkwlist,
    *(name for name in dir(builtins) if not name.startswith("_")),
    *("annotations", "asyncio", "enum_", "get", "groups", "interface", "link", "msg", "name", "node", "robot", "rospy"),
    *("self", "set", "signal", "signals", "unity_link", "value", "values"),
)
IN_VHDL = (
    *RESERVED,
    *("clk", "ieee", "integer", "natural", "now", "numeric_std", "registers", "rst", "std", "std_logic", "to_unsigned"),
    *("wb_adr", "wb_dat_o", "work", "written"),
)
IN_MATLAB = (
    *KEYWORDS,
    *MEMBERS,
    "ans",
    "disp",
    "double",
    "eps",
    "handle",
    "inf",
    "nan",
    "numel",
    "obj",
    "self",
    "uint64",
)
QUICKLY = settings(max_examples=examples(3), phases=[Phase.explicit, Phase.reuse, Phase.generate])


@pytest.mark.slow
@QUICKLY
@given(text=awkward_specs(IN_PYTHON))
def test_any_names_make_a_module_of_python_that_can_be_imported(
    text: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    folder = tmp_path_factory.mktemp("python")
    spec = compile_text(text)
    (path,) = generated("python", spec, folder)
    program = f"""
import {path.stem} as made, unity_link
robot = next(value for value in vars(made).values() if isinstance(value, type) and value.__module__ == made.__name__
             and issubclass(value, unity_link.data.Robot))
async def main():
    async with unity_link.connect("sim:") as link:
        print(len(robot(link).signals))
import asyncio
asyncio.run(main())
"""
    done = subprocess.run([sys.executable, "-c", program], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) == len(spec.interface().signals)


@QUICKLY
@given(text=awkward_specs(IN_PYTHON))
@pytest.mark.parametrize("target", ["ros1", "ros2"])
def test_any_names_make_packages_of_ros_that_python_and_xml_take(target: str, text: str) -> None:
    for file in generate(target, compile_text(text)):
        if file.name.endswith(".py"):
            ast.parse(file.text, feature_version=(3, 8))
            compile(file.text, file.name, "exec")
        if file.name.endswith((".xml", ".launch")):
            ET.fromstring(file.text)


@pytest.mark.rtl
@pytest.mark.skipif(shutil.which("ghdl") is None, reason="no simulator: apt install ghdl-mcode")
@QUICKLY
@given(text=awkward_specs(IN_VHDL))
def test_any_names_make_vhdl_that_can_be_analysed(text: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = tmp_path_factory.mktemp("vhdl")
    files = [path for path in generated("vhdl", compile_text(text), folder) if path.suffix == ".vhd"]
    for part in ("_map", "_registers", "_bench"):
        (path,) = [path for path in files if path.stem.endswith(part)]
        done = subprocess.run(
            ["ghdl", "-a", "--std=08", "--workdir=.", path.name],
            cwd=folder,
            capture_output=True,
            text=True,
            check=False,
        )
        assert (done.returncode, done.stderr) == (0, ""), path.name


@QUICKLY
@given(text=awkward_specs(sorted(SYSTEMVERILOG)))
def test_no_name_of_a_spec_is_a_word_of_systemverilog_in_its_vhdl(text: str) -> None:
    for file in generate("vhdl", compile_text(text)):
        if file.name.endswith(".vhd") and not file.name.endswith("_bench.vhd"):
            code = re.sub(r'--.*|"[^"\n]*"', "", file.text).lower()
            assert set(re.findall(r"[a-z]\w*", code)) & SYSTEMVERILOG <= {*RESERVED, "bit", "string"}, file.name


@pytest.mark.skipif(bool(why_not()), reason=why_not())
@settings(QUICKLY, max_examples=examples(2))
@given(text=awkward_specs(IN_MATLAB))
def test_any_names_make_a_class_that_octave_takes(text: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    octave = Octave(tmp_path_factory.mktemp("octave"))
    spec = compile_text(text)
    octave.generate(spec)
    (made,) = [path for path in octave.folder.glob("*.m") if path.stem not in {"unity_link_mex", "script"}]
    # Octave parses the whole class for this call.
    shown = octave.run(f"show('class', meta.class.fromName('{made.stem}').Name);")
    assert shown["class"] == made.stem


@pytest.mark.parametrize("target", [target for target in TARGETS if target not in ("matlab", "verilog")])
def test_a_name_that_no_file_can_have_is_refused_before_anything_is_written(target: str, tmp_path: Path) -> None:
    spec = compile_text(f"public {LONG[0]}() {{ @a = 1: READ(); }}")
    with pytest.raises((UnityLinkError, OSError)):
        generated(target, spec, tmp_path)
    assert not [path for path in tmp_path.rglob("*") if path.is_file()]
