"""Marks every bench `rtl`, the benches of `gateware/bench` also `slow`, and skips a bench if its tool is missing.

A bench compiles its entity before it runs, which takes long, so `make test` runs only one bench for each core.
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
    """Declare the mark, for runs of this folder alone too."""
    config.addinivalue_line("markers", "rtl: runs the gateware in a simulator (needs ghdl and cocotb)")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark the benches in this folder, and skip them if there is no simulator."""
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
    """Skip a test whose tool is missing, with the error text as the reason."""
    try:
        return (yield)
    except ToolMissingError as error:
        pytest.skip(str(error))
