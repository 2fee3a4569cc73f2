"""A feature has one bit and one name in Python, C, MATLAB, VHDL, command output and documents."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from support.spec_examples import FIGURE_1
from unity_link.generate import generate
from unity_link.protocol.wire.configuration import Feature
from unity_link.spec import compile_text
from unity_link.virtual.generics import FEATURES, info_of

ROOT = Path(__file__).parents[3]
BITS = {name.lower(): int(bit).bit_length() - 1 for name, bit in Feature.__members__.items()}
"""The table: bit numbers by names in lower case."""


def generated(target: str, name: str) -> str:
    """Return the text of a generated file."""
    return next(file.text for file in generate(target, compile_text(FIGURE_1)) if file.name.endswith(name))


def features_of_c(target: str) -> dict[str, int]:
    """Return the bit numbers that a C header names, by names in lower case."""
    found = re.findall(r"\bUL_FEATURE_(\w+) = (\d+)", generated(target, "unity_link.h"))
    return {name.lower(): int(value).bit_length() - 1 for name, value in found if int(value).bit_count() == 1}


def test_the_bits_are_numbered_without_gaps() -> None:
    assert list(BITS.values()) == list(range(len(Feature)))


@pytest.mark.parametrize("target", ["c", "cpp", "matlab"])
def test_c_has_the_features(target: str) -> None:
    assert features_of_c(target) == BITS


@pytest.mark.parametrize("target", ["c", "cpp", "matlab"])
def test_the_sources_in_c_use_no_other_feature(target: str) -> None:
    texts = [file.text for file in generate(target, compile_text(FIGURE_1))]
    asked = {name for text in texts for name in re.findall(r"\bUL_FEATURE_(\w+)", text)}
    assert asked == Feature.__members__.keys()


def test_the_struct_of_matlab_has_the_features_in_the_order_of_their_bits() -> None:
    names = re.search(r"make_features\(.*?NAMES\[\] = \{(.*?)\}", generated("matlab", "unity_link_mex.c"), re.DOTALL)
    assert names is not None
    assert re.findall(r'"(\w+)"', names[1]) == list(BITS)


def test_the_sources_in_matlab_use_no_other_feature() -> None:
    texts = [file.text for file in generate("matlab", compile_text(FIGURE_1)) if file.name.endswith(".m")]
    asked = {name for text in texts for name in re.findall(r"\.features\.(\w+)", text)}
    assert asked
    assert asked <= BITS.keys()


def test_the_gateware_has_the_features() -> None:
    rtl = ROOT / "gateware" / "rtl"
    declared = re.findall(
        r"constant feature_(\w+) +: natural := (\d+);", (rtl / "unity_link_pkg.vhd").read_text(encoding="utf-8")
    )
    assert {name: int(bit) for name, bit in declared} == BITS
    answered = re.findall(r"bits\(feature_(\w+)\)", (rtl / "unity_link_core.vhd").read_text(encoding="utf-8"))
    assert answered == list(BITS)


def test_generics_have_the_names_of_their_features_except_for_triggers() -> None:
    top = (ROOT / "gateware" / "rtl" / "unity_link_core.vhd").read_text(encoding="utf-8")
    assert FEATURES.keys() <= set(re.findall(r"^ +(\w+) +: boolean", top, re.MULTILINE))
    chosen = {bit: generic for generic, bit in FEATURES.items()}
    assert chosen.pop(Feature.EXTERNAL_TRIGGERS) == "triggers"
    assert all(generic.upper() == bit.name for bit, generic in chosen.items())
    assert [bit for bit in Feature if bit not in FEATURES.values()] == [Feature.GROUPS, Feature.ADDRESSED]


@pytest.mark.parametrize("bit", Feature)
def test_a_generic_sets_only_its_own_feature(bit: Feature) -> None:
    none = {**dict.fromkeys(FEATURES, False), "groups": 0, "node": -1}
    needed = Feature.GROUPS if bit in Feature.EXTERNAL_TRIGGERS | Feature.TIMESTAMPS else Feature(0)
    chosen = {generic: feature in bit | needed for generic, feature in FEATURES.items()}
    numbers = {"groups": int(Feature.GROUPS in bit | needed), "node": -1 + (bit is Feature.ADDRESSED)}
    assert info_of({**none, **chosen, **numbers}).features == bit | needed


def test_the_protocol_page_names_features_as_commands_print_them() -> None:
    page = (ROOT / "docs" / "protocol.md").read_text(encoding="utf-8")
    section = page[page.index("\n## Configuration") : page.index("\n## The compact form")]
    listed = re.findall(r"^\| (\d+) \| ([a-z ]+) \|", section, re.MULTILINE)
    printed = [feature.words for feature in Feature]
    assert listed == [(str(bit), words) for bit, words in enumerate(printed)]
    assert [words.replace(" ", "_") for words in printed] == list(BITS)
