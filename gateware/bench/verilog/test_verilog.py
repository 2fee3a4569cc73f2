"""The gateway in Verilog answers like the VHDL, in two simulators other than GHDL: Verilator and Icarus."""

from __future__ import annotations

import json
import random
import re
import shutil
from typing import TYPE_CHECKING, Any

import pytest

from gateware.bench.unity_link.bench_differential import (
    ERROR_AT,
    GROUP_WORDS,
    GROUPS,
    SILENT_AT,
    Frames,
    _all_responses,
    _what_is_about_groups,
)
from gateware.bench.unity_link.test_vectors import VECTORS, generics_of
from gateware.bench.verilog.simulators import (
    ENTITY,
    Design,
    complaints,
    icarus_complains,
    in_icarus,
    lint,
    verilated,
)
from gateware.tools import verilog
from gateware.tools.verilog import RELEASES
from unity_link.gateware.convert import to_verilog
from unity_link.gateware.ghdl import ToolMissingError
from unity_link.gateware.release import release, released
from unity_link.gateware.words import SYSTEMVERILOG
from unity_link.generate.vhdl.names import RESERVED
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(shutil.which("verilator") is None, reason="no Verilator: apt install verilator"),
    pytest.mark.skipif(shutil.which("iverilog") is None, reason="no Icarus Verilog: apt install iverilog"),
]
FILES = [
    pytest.param(path, marks=[] if path.stem == "bare" else [pytest.mark.campaign])
    for path in sorted(VECTORS.glob("*.ndjson"))
]
SHARE = [(2_000, 1, 0.0)]
WHOLE = [(16_000, 1, 0.0), (4_000, 2, 0.2)]


@pytest.mark.parametrize("name", RELEASES)
def test_release_is_clean_verilog_and_names_its_origin(name: str) -> None:
    text = RELEASES[name].text(name)
    assert text.startswith("// SPDX-License-Identifier: BSD-3-Clause\n")
    assert "// A netlist in Verilog-2005, converted by GHDL from the VHDL of Unity-Link" in text
    assert all(f"//   {generic} => {value}\n" in text for generic, value in RELEASES[name].generics.items())
    modules = re.findall(r"^module (\w+)$", text, re.MULTILINE)
    assert modules[-1] == name
    assert all(module.startswith(f"{name}_") for module in modules[:-1])
    assert len(set(modules)) == len(modules)
    assert complaints(text, name) == {}


WORDS = """\
library ieee;
  use ieee.std_logic_1164.all;

entity words is
  port (
    clk : in    std_logic;
{ports}
  );
end entity words;

architecture rtl of words is
{signals}
begin
  process (clk) is
  begin
    if rising_edge(clk) then
{steps}
    end if;
  end process;
{outputs}
end architecture rtl;
"""
"""An entity with a port for one half of the keywords, and a register for the other half."""


def test_names_that_are_words_of_systemverilog_are_read_in_each_language(tmp_path: Path) -> None:
    words = sorted(SYSTEMVERILOG - RESERVED)
    ports, registers = words[::2], words[1::2]
    path = tmp_path / "words.vhd"
    path.write_text(
        WORDS.format(
            ports=";\n".join(f"    {port} : out std_logic" for port in ports) + ";\n    given : in std_logic",
            signals="\n".join(f"  signal {register} : std_logic;" for register in registers),
            steps="\n".join(f"      {register} <= given;" for register in registers),
            outputs="\n".join(f"  {port} <= {registers[place % len(registers)]};" for place, port in enumerate(ports)),
        )
    )
    converted = to_verilog("words", {}, [path]).read_text()
    text = released("given_words", ["For this test."], "words", converted, [path])
    assert complaints(text, "given_words") == {}
    found = re.findall(r"^//   \.(\w+)\(", text, re.MULTILINE)
    assert sorted(found) == sorted(["clk", "given", *(f"{port}_x" for port in ports)])


def test_simulators_warn_about_faults() -> None:
    wrong = "module wrong(input [3:0] a, output [1:0] b);\n  assign b = {};\nendmodule\n"
    assert "%Warning-WIDTH" in lint(wrong.format("a"), "wrong")
    assert "missing" in icarus_complains(wrong.format("missing"))
    right = "module right(input [1:0] a, output [1:0] b);\n  assign b = a;\nendmodule\n"
    assert lint(right, "right") == icarus_complains(right) == ""


def answered(path: Path) -> tuple[Design, bytes, list[dict[str, Any]], bytes]:
    """Return the gateway of a file of vectors, all bytes to send, the steps, and the first bytes of its samples."""
    header, *steps = map(json.loads, path.read_text().splitlines())
    generics = generics_of(header["configuration"], header["node"])
    for vector in ("crc_polynomial", "build_id"):
        generics[vector] = f"{generics[vector]:032b}"
    text = release("gateway", ["For the vectors."], ENTITY, generics)
    design = Design("gateway", text, header["bus_error"][0], header["bus_timeout"][0])
    prefix = b"" if header["node"] is None else b"Z%02X" % header["node"]
    return design, b"".join(step["send"].encode("latin-1") for step in steps), steps, prefix + b"P"


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_the_shared_vectors_are_answered_in_both_simulators(path: Path) -> None:
    design, sent, steps, sample = answered(path)
    with verilated(design) as gateway:
        gateway.send(sent)
        in_verilator = gateway.take()
    frames = in_verilator.splitlines(keepends=True)
    for name, is_sample in (("answers", False), ("publishes", True)):
        got = b"".join(frame for frame in frames if frame.startswith(sample) == is_sample)
        assert got == "".join(step.get(name, "") for step in steps).encode("latin-1"), name
    assert in_icarus(design, sent) == in_verilator


@pytest.mark.parametrize(
    ("count", "seed", "pause"), [*SHARE, *(pytest.param(*run, marks=pytest.mark.campaign) for run in WHOLE)]
)
def test_random_frames_are_answered_as_the_model_answers_them(count: int, seed: int, pause: float) -> None:
    model = VirtualGateway(GatewayInfo(groups=GROUPS, group_words=GROUP_WORDS))
    model.attach(Failing(ErrorCode.BUS_ERROR), [ERROR_AT])
    model.attach(Failing(ErrorCode.BUS_TIMEOUT), [SILENT_AT])
    frames, rng = Frames(seed, model), random.Random(seed + 1)
    design = Design("unity_link_fifo", RELEASES["unity_link_fifo"].text("unity_link_fifo"), ERROR_AT, SILENT_AT)
    with verilated(design, pause=pause, seed=seed) as gateway:
        for _ in range(count // 100):
            gateway.set_wait_states(rng.choice((0, 0, 1, 3, 9)) if pause else 0)
            if rng.random() < 0.3:
                gateway.reset()
                model.reset()
            sent, expected = [], b""
            for _ in range(100):
                frame = frames.one()
                lost_before = rng.randrange(len(frame)) if frame and rng.random() < 0.01 else None
                sent.append(frame)
                gateway.send(frame, lost_before=lost_before)
                if lost_before is not None:
                    expected += model.receive(frame[:lost_before], 0.0)
                    model.overflow()
                    frame = frame[lost_before:]
                expected += model.receive(frame, 0.0)
            received = gateway.take(4000)
            for is_in_order in (_all_responses, _what_is_about_groups):
                got, wanted = (
                    [frame for frame in data.splitlines(keepends=True) if is_in_order(frame)]
                    for data in (received, expected)
                )
                assert got == wanted, sent


def test_missing_ghdl_is_one_sentence_and_nothing_is_written(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    def missing(*_: object) -> str:
        raise ToolMissingError("GHDL 4 or later converts the gateware, and there is none")

    monkeypatch.setattr("unity_link.gateware.convert.converting_ghdl", missing)
    monkeypatch.setattr("sys.argv", ["verilog", str(tmp_path / "out")])
    assert verilog.main() == 1
    assert capsys.readouterr().err == "GHDL 4 or later converts the gateware, and there is none\n"
    assert not (tmp_path / "out").exists()
