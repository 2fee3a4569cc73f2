"""Marks every bench `rtl`, the benches of `gateware/bench` also `slow`, and skips a bench whose tool is missing.

A bench compiles its entity before it runs, so `make test` runs only the benches of the cores, one for each core.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gateware.bench.runner import simulator_available
from unity_link.gateware.ghdl import ToolMissingError

if TYPE_CHECKING:
    from collections.abc import Generator

_HERE = Path(__file__).resolve().parent
_BENCHES = _HERE / "bench"


def pytest_configure(config: pytest.Config) -> None:
    """Declare the mark, also when only this folder is run."""
    config.addinivalue_line("markers", "rtl: runs the gateware in a simulator (needs ghdl and cocotb)")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark what stands in this folder."""
    missing = pytest.mark.skip(reason="no simulator: apt install ghdl-mcode, pip install cocotb")
    for item in items:
        parents = Path(item.path).parents
        if _BENCHES in parents[1:]:
            item.add_marker(pytest.mark.slow)
        if _HERE in parents:
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
