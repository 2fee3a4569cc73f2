"""The constants of the host are in one table, which needs no installed package and is the same in every language."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from support.spec_examples import FIGURE_1
from unity_link.generate import generate
from unity_link.protocol.window import constants, window
from unity_link.spec import compile_text

DOCUMENT = Path(__file__).parents[3] / "docs" / "reliability.md"


def test_the_table_needs_no_installed_package() -> None:
    path = str(Path(constants.__file__))
    subprocess.run([sys.executable, "-I", "-S", "-W", "error", path], check=True, cwd="/")


def test_all_constants_of_the_window_are_in_the_table() -> None:
    numbers = {name: value for name, value in vars(window).items() if type(value) in {int, float}}
    # NEVER marks "no position"; it is not a constant of the protocol.
    assert numbers.pop("NEVER") == -1
    assert numbers.items() <= constants.TABLE.items()


def test_the_documents_have_the_table() -> None:
    rows = re.findall(r"^\| `([A-Z_]+)` \| ([\d.]+) \|", DOCUMENT.read_text("utf-8"), re.MULTILINE)
    assert {name: float(value) for name, value in rows} == constants.TABLE


def test_the_shortest_timeout_exceeds_the_latency_timer_of_usb_chips() -> None:
    assert constants.SHORTEST_TIMEOUT > 0.016


@pytest.mark.parametrize("target", ["c", "cpp", "matlab"])
def test_the_client_in_c_has_the_table(target: str) -> None:
    files = generate(target, compile_text(FIGURE_1))
    text = next(file.text for file in files if Path(file.name).name == "unity_link.c")
    found = {name: float(value) for name, value in re.findall(r"^#define (\w+) ([\d.]+)$", text, re.MULTILINE)}
    assert found == constants.TABLE
