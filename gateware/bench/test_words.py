"""No name in the gateware's VHDL is a keyword of SystemVerilog, so its Verilog is valid in both languages."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from gateware.bench.test_subset import SOURCES
from unity_link.gateware.words import SYSTEMVERILOG
from unity_link.generate.vhdl.names import RESERVED

if TYPE_CHECKING:
    from pathlib import Path

WORDS_OF_VHDL = RESERVED | {"bit", "string"}


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: path.stem)
def test_no_name_of_the_gateware_is_a_word_of_systemverilog(path: Path) -> None:
    code = re.sub(r'--.*|"[^"\n]*"', "", path.read_text()).lower()
    assert set(re.findall(r"[a-z]\w*", code)) & SYSTEMVERILOG <= WORDS_OF_VHDL
