"""Marks every bench `rtl`, and skips by name what a simulator or another tool is missing for."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gateware.bench.runner import simulator_available
from unity_link.gateware.ghdl import ToolMissingError

if TYPE_CHECKING:
    from collections.abc import Generator

_HERE = Path(__file__).resolve().parent


def pytest_configure(config: pytest.Config) -> None:
    """Declare the mark, also when only this folder is run."""
    config.addinivalue_line("markers", "rtl: runs the gateware in a simulator (needs ghdl and cocotb)")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark what stands in this folder."""
    missing = pytest.mark.skip(reason="no simulator: apt install ghdl-mcode, pip install cocotb")
    for item in items:
        if _HERE in Path(item.path).parents:
            item.add_marker(pytest.mark.rtl)
            if not simulator_available():
                item.add_marker(missing)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call() -> Generator[None]:
    """Skip a test that a tool is missing for, with the sentence that names it."""
    try:
        return (yield)
    except ToolMissingError as error:
        pytest.skip(str(error))
