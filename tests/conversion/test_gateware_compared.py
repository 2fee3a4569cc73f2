"""The Verilog of each entity of the gateware is the circuit that GHDL simulates; a changed circuit is detected."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from unity_link.gateware.cache import LIBRARY, vhdl_sources
from unity_link.gateware.comparing import Comparison, Subject, UncomparedError
from unity_link.gateware.design import GhdlDesign
from unity_link.gateware.entity import SyntaxTree

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = pytest.mark.rtl
ENTITIES = [
    path.stem for path in vhdl_sources() if re.search(rf"^entity {path.stem} is$", path.read_text(), re.MULTILINE)
]
UNCOMPARED = {
    # Random datagrams lack the right checksum of Ethernet, so that none is received.
    "ul_ethernet": "its output rx_data is never '0' or '1'",
    "ul_datagram_reader": "its port job has the type job_t",
    "ul_datagram_writer": "its port job has the type job_t",
}
CHANGES = {
    "ul_gpio": ("settled ^ ", "settled & "),
    "ul_encoder_axis": (" + ", " - "),
    "ul_word_ring": (" + ", " - "),
    "ul_fifo_sync": (" == ", " != "),
}


def compared(name: str, folder: Path, change: tuple[str, str] | None = None) -> Comparison:
    """Return the comparison of an entity with its Verilog, after a change of one line of the Verilog."""
    (folder / "design").mkdir()
    design = GhdlDesign(folder / "design", vhdl_sources())
    design.make(name, LIBRARY)
    source = next(path for path in vhdl_sources() if path.stem == name)
    ports = SyntaxTree(design.description(source, library=LIBRARY)).entities()[name].ports
    verilog = design.verilog(name, {}, LIBRARY)
    if change is not None:
        assert change[0] in verilog
        verilog = verilog.replace(*change)
    subject = Subject(name, source.name, name, {}, LIBRARY)
    return Comparison(subject, {port: one.base for port, one in ports.items()}, design, verilog, folder)


@pytest.mark.campaign
@pytest.mark.parametrize("name", ENTITIES)
def test_an_entity_of_the_gateware_is_the_circuit_that_ghdl_simulates(name: str, tmp_path: Path) -> None:
    if name in UNCOMPARED:
        with pytest.raises(UncomparedError, match=re.escape(UNCOMPARED[name])):
            compared(name, tmp_path).deviations()
        return
    assert compared(name, tmp_path).deviations() == []


@pytest.mark.slow
@pytest.mark.parametrize("name", CHANGES)
def test_a_changed_circuit_is_noticed(name: str, tmp_path: Path) -> None:
    assert compared(name, tmp_path, CHANGES[name]).deviations() != []
