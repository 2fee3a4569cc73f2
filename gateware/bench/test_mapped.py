"""The tops that are mapped without placing: how cells are counted, and that the table has each configuration."""

from __future__ import annotations

import pytest

from gateware.tools.datasheets import PAGES, filled
from gateware.tools.mapped import MAPPED, RAM_BLOCKS, TARGETS, cells_of, counted, results, tools_of
from gateware.tools.synth import CONFIGURATIONS, unchanged

GOWIN, GATEMATE = TARGETS["gowin"], TARGETS["gatemate"]


def test_cells_are_counted_by_the_resources_that_they_take() -> None:
    cells = {"LUT1": 1, "LUT4": 2, "MUX2_LUT5": 9, "ALU": 3, "DFFRE": 4, "DFFP": 1, "RAM16SDP4": 5, "GND": 1}
    blocks = {"DPB": 1, "DPX9B": 1, "SDPB": 1, "SDPX9B": 1, "SP": 1, "SPX9": 1}
    assert counted(cells | blocks, GOWIN) == {
        "LUT4": 3,
        "carry cells": 3,
        "RAMs of LUTs": 5,
        "registers": 5,
        RAM_BLOCKS: 6,
    }
    trees = {"CC_LUT2": 1, "CC_L2T4": 2, "CC_L2T5": 3, "CC_MX4": 4, "CC_BUFG": 1, "$scopeinfo": 7}
    assert counted(trees | {"CC_BRAM_20K": 1, "CC_BRAM_40K": 1}, GATEMATE) == {
        "LUTs and multiplexers": 10,
        "carry cells": 0,
        "registers": 0,
        RAM_BLOCKS: 2,
    }


def test_an_unknown_cell_is_refused_by_its_name() -> None:
    with pytest.raises(ValueError, match="rPLL of Gowin GW1NR-9 is unknown"):
        counted({"LUT4": 1, "rPLL": 1}, GOWIN)


def test_results_have_each_target_configuration_and_kind() -> None:
    found = results()
    assert list(found) == list(MAPPED)
    assert set(MAPPED) <= set(CONFIGURATIONS)
    for written in found.values():
        assert {target: list(cells) for target, cells in written.cells.items()} == {
            name: list(target.cells) for name, target in TARGETS.items()
        }
        assert all(cells["registers"] > 0 for cells in written.cells.values())


def test_results_are_on_the_pages() -> None:
    text = filled("ul_fifo_async")
    assert (PAGES / "ul_fifo_async.md").read_text() == text
    for name, target in TARGETS.items():
        registers = results()["ul_fifo_async"].cells[name]["registers"]
        (row,) = [line for line in text.splitlines() if target.title in line]
        assert f" {registers} registers | 1 | mapped, not placed |" in row


@pytest.mark.parametrize("name", MAPPED)
def test_results_belong_to_the_present_gateware(name: str) -> None:
    assert unchanged(results()[name].origin, name, tools_of(name)), "run make synth"


@pytest.mark.parametrize("target", TARGETS)
def test_a_part_is_mapped(target: str) -> None:
    cells = cells_of("ul_fifo_async", target)
    assert cells[RAM_BLOCKS] == 1
    assert cells["registers"] > 50
