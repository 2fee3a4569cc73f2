"""The contents of the datasheets' pictures: the bench, its signals, and the clock whose cycles are numbered.

Each picture is a part of a simulation; the bench marks its begin and end (`gateware.bench.datasheets.window`).
"""

from __future__ import annotations

import dataclasses
import json
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from gateware.bench.runner import GATEWARE, run_bench
from gateware.tools import generated
from gateware.tools.drawing import Row, Waveform, Window, draw

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

PICTURES = GATEWARE.parent / "docs" / "images" / "gateware"
_GENERATED = GATEWARE / "build" / "datasheets"
_GATEWAY = GATEWARE / "bench" / "unity_link" / "unity_link_bench.vhd"


@dataclasses.dataclass(frozen=True)
class Picture:
    """One picture; the bench's test and the picture's file have the same name."""

    title: str
    rows: tuple[Row, ...]
    clock: str = "clk"


@dataclasses.dataclass(frozen=True)
class Simulation:
    """A run of a bench from which pictures are drawn."""

    entity: str
    bench: str
    pictures: Mapping[str, Picture]
    generics: Mapping[str, object] = dataclasses.field(default_factory=dict)
    sources: tuple[Path, ...] = ()
    generated: bool = False
    """True if the entity is generated from a spec."""

    def draw(self) -> Iterator[tuple[str, str]]:
        """Simulate, and yield the name of each picture with its text."""
        with tempfile.TemporaryDirectory() as folder:
            waves, windows = Path(folder, "waves.vcd"), Path(folder, "windows.json")
            run_bench(
                self.entity,
                f"gateware.bench.datasheets.{self.bench}",
                generics=self.generics,
                extra_sources=[*(generated.sources(_GENERATED) if self.generated else ()), *self.sources],
                testcase=tuple(self.pictures),
                extra_env={"WINDOWS": str(windows)},
                waves=waves,
            )
            shown = [row for picture in self.pictures.values() for row in picture.rows]
            names = {name for row in shown for name in (row.signal, row.when, row.each) if name}
            waveform = Waveform(waves, [*names, *(picture.clock for picture in self.pictures.values())])
            for name, window in json.loads(windows.read_text()).items():
                picture = self.pictures[name]
                yield name, draw(waveform, picture.title, picture.rows, picture.clock, Window(*window))


def _rows(*signals: str | Row) -> tuple[Row, ...]:
    return tuple(Row(signal) if isinstance(signal, str) else signal for signal in signals)


_STREAM = (
    Row("in_data", when="in_valid", as_text=True, each="clk"),
    "in_valid",
    Row("out_data", when="out_valid", as_text=True, each="clk"),
    "out_valid",
)
_BUS = (
    "wb_cyc",
    "wb_stb",
    "wb_we",
    Row("wb_adr", when="wb_stb"),
    Row("wb_dat_i", when="wb_ack"),
    "wb_ack",
)
_WRITTEN = (*_BUS[:4], Row("wb_dat_o", when="wb_stb"), "wb_ack")
_CORE = (
    Row("rx_data", when="rx_valid", as_text=True),
    "rx_valid",
    "rx_ready",
    Row("tx_data", when="tx_valid", as_text=True),
    "tx_valid",
    "tx_ready",
)
_CHAIN = _rows("clk", "to_chain", "chain_load_n", "chain_clk", "chain_out", "chain_in", "from_chain")
_STREAM_OF_ENTRIES = (
    Row("in_data", when="in_valid"),
    "in_valid",
    "in_ready",
    Row("out_data", when="out_valid"),
    "out_valid",
    "out_ready",
)
_READ = ("clk", "wb_cyc", "wb_stb", Row("wb_adr", when="wb_stb"), Row("wb_dat_o", when="wb_ack"), "wb_ack")
SIMULATIONS = (
    Simulation(
        "unity_link_bench",
        "bench_gateway",
        {
            "read": Picture("A read: request, bus access, answer", _rows("clk", *_STREAM, *_BUS)),
            "write": Picture("A write: request, bus access, answer", _rows("clk", *_STREAM, *_WRITTEN)),
            "sample": Picture(
                "A trigger, the sample strobe, and the three reads of the sample",
                _rows(
                    "clk",
                    "trigger",
                    Row("gateway.sample_strobe", "sample_strobe"),
                    Row("gateway.sample_access", "sample_access"),
                    *_BUS,
                    *_STREAM[2:],
                ),
            ),
            "timeout": Picture(
                "A read without an answer, error 05, the released bus, and the next read",
                _rows("clk", *_STREAM, *_BUS[:2], _BUS[3], "wb_ack"),
            ),
        },
        {"silent_at": 0xE8, "bus_timeout": 16, "groups": 1},
        (_GATEWAY,),
    ),
    Simulation(
        "unity_link_bench",
        "bench_gateway",
        {
            "block": Picture(
                "Four words in a pipeline: a read in each cycle, each answered in the next",
                _rows("clk", "wb_cyc", "wb_stb", *_BUS[3:], *_STREAM[2:]),
            )
        },
        {"wb_pipelined": True, "groups": 0},
        (_GATEWAY,),
    ),
    Simulation(
        "ul_uart",
        "bench_uart",
        {
            "uart_in": Picture("A byte is received", _rows("clk", "rxd", *_CORE[:3])),
            "uart_out": Picture("A byte is transmitted", _rows("clk", *_CORE[3:], "txd")),
        },
        {"clock_hz": 48_000_000, "baud": 8_000_000},
    ),
    Simulation(
        "ul_uart",
        "bench_uart",
        {
            "rs485": Picture(
                "After the far end's byte the driver is enabled for two bytes, with one bit before and one after them",
                _rows("rxd", "driver_enable", "txd", *_CORE[3:]),
            )
        },
        {"clock_hz": 48_000_000, "baud": 8_000_000, "half_duplex": True, "driver_lead": 1, "driver_tail": 1},
    ),
    Simulation(
        "ul_ft245_async",
        "bench_ft245_async",
        {
            "ft245_async_read": Picture(
                "A byte is read from the chip", _rows("clk", "rxf_n", "rd_n", "data_in", *_CORE[:3])
            ),
            "ft245_async_write": Picture(
                "A byte is written to the chip, and sent at once",
                _rows("clk", *_CORE[3:], "flush", "txe_n", "data_oe", "data_out", "wr_n", "siwu_n"),
            ),
        },
    ),
    Simulation(
        "ul_ft245_sync",
        "bench_ft245_sync",
        {
            "ft245_sync_read": Picture(
                "Four bytes are read from the chip",
                _rows("clkout", "rxf_n", "oe_n", "rd_n", "data_in", "clk", *_CORE[:2]),
                "clkout",
            ),
            "ft245_sync_write": Picture(
                "Four bytes are written to the chip, and sent at once",
                _rows("clk", *_CORE[3:], "flush", "clkout", "txe_n", "data_oe", "data_out", "wr_n", "siwu_n"),
                "clkout",
            ),
        },
    ),
    Simulation(
        "ul_wishbone_master",
        "bench_masters",
        {
            "wishbone_classic": Picture(
                "A read with two wait states, and a write that the slave answers with rty once",
                _rows(
                    "clk",
                    "bus_request",
                    "bus_write",
                    Row("bus_address", when="bus_request"),
                    Row("bus_read_data", when="bus_done"),
                    "bus_done",
                    "cyc",
                    "stb",
                    "ack",
                    "rty",
                ),
            )
        },
    ),
    Simulation(
        "ul_axi4_lite_master",
        "bench_masters",
        {
            "axi4_lite": Picture(
                "A write, and a read",
                _rows(
                    "clk",
                    "bus_request",
                    "bus_write",
                    Row("bus_address", when="bus_request"),
                    "bus_done",
                    *(Row(name, when=f"{name[:-4]}valid") for name in ("awaddr", "wdata")),
                    "awvalid",
                    "awready",
                    "wvalid",
                    "wready",
                    "bvalid",
                    "bready",
                    Row("araddr", when="arvalid"),
                    "arvalid",
                    "arready",
                    Row("rdata", when="rvalid"),
                    "rvalid",
                    "rready",
                ),
            )
        },
    ),
    Simulation(
        "ul_fifo_sync",
        "bench_cores",
        {"fifo_sync": Picture("Three entries are written and read", _rows("clk", *_STREAM_OF_ENTRIES, "level"))},
        {"depth": 4},
    ),
    Simulation(
        "ul_fifo_async",
        "bench_cores",
        {
            "fifo_async": Picture(
                "Three entries cross from a clock of 20 ns to one of 14 ns",
                _rows("in_clk", *_STREAM_OF_ENTRIES[:3], "in_level", "out_clk", *_STREAM_OF_ENTRIES[3:]),
                "in_clk",
            )
        },
    ),
    Simulation(
        "ul_stream_register",
        "bench_cores",
        {"stream_register": Picture("Three entries pass, and one of them waits", _rows("clk", *_STREAM_OF_ENTRIES))},
    ),
    Simulation(
        "ul_synchroniser",
        "bench_cores",
        {"crossing": Picture("A signal that changes anywhere in a cycle", _rows("clk", "d", "q"))},
    ),
    Simulation(
        "ul_reset_synchroniser",
        "bench_cores",
        {"reset_synchroniser": Picture("A reset begins at once and ends with the clock", _rows("clk", "cause", "rst"))},
    ),
    Simulation(
        "shift_chain",
        "bench_cores",
        {
            "shift_chain": Picture(
                "A frame of four bits out and three in",
                _CHAIN,
            )
        },
        {"bits_out": 4, "bits_in": 3},
        (GATEWARE / "boards" / "shift_chain.vhd",),
    ),
    Simulation(
        "shift_chain",
        "bench_cores",
        {
            "one_bit": Picture(
                "One bit, and a wire from the end to the beginning: the output is the bit",
                _CHAIN,
            )
        },
        {"bits_out": 1, "bits_in": 1},
        (GATEWARE / "boards" / "shift_chain.vhd",),
    ),
    Simulation(
        "rover_bank",
        "bench_bank",
        {
            "bank_accesses": Picture(
                "A write, a read of the same register, a read of a hardware value, and a read of an unused address",
                _rows(
                    *_READ[:3],
                    "wb_we",
                    _READ[3],
                    Row("wb_dat_i", when="wb_we"),
                    *_READ[4:],
                    "wb_err",
                    "left_duty",
                    "left_duty_written",
                ),
            ),
            "bank_fifo": Picture(
                "A read of a FIFO port that has no word yet, and the next read",
                _rows(*_READ, "wb_stall", "log", "log_valid", "log_ready"),
            ),
            "bank_sample": Picture(
                "A read during a sample returns the value at its strobe, a later read returns the present value",
                _rows(*_READ, "sample_access", "hits"),
            ),
        },
        sources=(GATEWARE / "bench" / "datasheets" / "rover_bank.vhd",),
        generated=True,
    ),
)


def pictures() -> dict[str, str]:
    """Return the text of each picture by the name of its file, from simulations that run now."""
    return {f"{name}.svg": text for simulation in SIMULATIONS for name, text in simulation.draw()}
