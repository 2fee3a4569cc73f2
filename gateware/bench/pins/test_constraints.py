"""The names in vendors' constraint files exist, and their figures are those of the chips that the benches model."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from gateware.bench.ft245_sync.chip import CHIPS, PERIOD_PS
from gateware.bench.runner import GATEWARE
from unity_link.gateware.cache import vhdl_sources

if TYPE_CHECKING:
    from pathlib import Path

_FILES = sorted(
    path for path in (GATEWARE / "constraints").rglob("*") if path.suffix in (".xdc", ".sdc", ".lpf", ".pdc")
)
_WITH_PINS = [path for path in _FILES if "set_input_delay" in path.read_text()]
_SOURCES = {path.stem: path.read_text() for path in vhdl_sources()}


def _id(path: Path) -> str:
    return f"{path.parent.name}/{path.name}"


def _code(path: Path) -> str:
    return "\n".join(line for line in path.read_text().splitlines() if not re.match(r"\s*(#|//)", line))


@pytest.mark.parametrize("path", _FILES, ids=_id)
def test_every_register_that_is_named_is_in_the_sources(path: Path) -> None:
    own = _SOURCES.get(path.stem)
    text = own if path.parent.name == "vivado" and own else "\n".join(_SOURCES.values())
    named = set(re.findall(r"\b(\w+)_reg\b", _code(path))) - {"meta", "pad"}
    named |= set(re.findall(r"\b(\w+_crossing|chip_\w+|write_gray|read_gray)\b(?!_reg)", _code(path)))
    for name in named:
        assert re.search(rf"\b{name.removesuffix('_reg')}\b", text), name


@pytest.mark.parametrize("path", _FILES, ids=_id)
def test_it_is_said_that_no_tool_has_read_it(path: Path) -> None:
    assert "Unchecked" in path.read_text()


@pytest.mark.parametrize("path", _WITH_PINS, ids=_id)
def test_the_pins_have_the_intervals_of_the_chip(path: Path) -> None:
    code, chip = _code(path), CHIPS["ft232h"]
    for name, value in re.findall(r"set (ft_\w+) ([\d.]+)", code):
        code = code.replace(f"${name}", value)
    asked = dict(re.findall(r"set_(input_delay|output_delay)\s.*?-max ([\d.]+)", code))
    assert {name: float(value) * 1000 for name, value in asked.items()} == {
        "input_delay": chip.output,
        "output_delay": chip.setup,
    }
    (period,) = re.findall(r"-period ([\d.]+)", code)
    assert float(period) * 1000 == PERIOD_PS


def test_the_board_has_the_intervals_of_its_own_chip() -> None:
    text = (GATEWARE / "boards" / "ecp5_ft2232h" / "ecp5_ft2232h.lpf").read_text()
    chip = CHIPS["ft2232h"]
    setups = set(re.findall(r'^INPUT_SETUP PORT "\S+" ([\d.]+) NS HOLD ([\d.]+) NS', text, re.MULTILINE))
    assert setups == {(f"{(PERIOD_PS - chip.output) / 1000:.2f}", f"{chip.hold / 1000:g}")}
    outputs = set(re.findall(r'^CLOCK_TO_OUT PORT "\S+" MAX ([\d.]+) NS', text, re.MULTILINE))
    assert outputs == {f"{(PERIOD_PS - chip.setup) / 1000:.2f}"}


def test_every_crossing_is_in_the_files_of_every_vendor() -> None:
    crossings = {
        name for text in _SOURCES.values() for name in re.findall(r"^ *(\w+_crossing) : entity", text, re.MULTILINE)
    }
    assert crossings
    vendors = {path.parent.name for path in _FILES}
    for vendor in vendors:
        for suffix in {path.suffix for path in _FILES if path.parent.name == vendor}:
            of_one_tool = [path for path in _FILES if path.parent.name == vendor and path.suffix == suffix]
            text = "\n".join(map(_code, of_one_tool))
            named = {name for name in crossings if name in text or re.search(r"\$\{way\}_crossing", text)}
            assert named == crossings, f"{vendor}, {suffix}"
