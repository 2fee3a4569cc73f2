"""Verilog of a spec, for the requested clock and baud rate."""

from __future__ import annotations

import shutil
import subprocess
from typing import TYPE_CHECKING

import pytest

from unity_link.errors import ArgumentError
from unity_link.generate import generate
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.messages import Codec
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from pathlib import Path

LAMP = compile_text("public lamp() { @on = 0[7:0]: unsigned READWRITE(); @clock_hz = 1: unsigned 8 READ(); }")
FRAMING = Codec(GatewayInfo()).framing
CLOCK_HZ, BAUD = 12_000_000, 2_000_000
BENCH = """\
module bench;
  reg clk = 0, rst = 1, rx = 1;
  wire tx;
  reg [7:0] got;
  integer bit;
  always #1 clk = !clk;
  lamp_on_uart lamp(.clk(clk), .rst(rst), .uart_rxd(rx), .uart_txd(tx), .uart_cts_n(1'b0), .ft_clkout(1'b0),
    .ft_data_in(8'b0), .ft_rxf_n(1'b1), .ft_txe_n(1'b1), .trigger(16'b0), .clock_hz_2(8'b0),
    .elsewhere_dat_i(32'b0), .elsewhere_ack(1'b0), .elsewhere_err(1'b1));
  task send(input [7:0] byte);
    begin
      rx = 0;
      repeat (CYCLES) @(posedge clk);
      for (bit = 0; bit < 8; bit = bit + 1) begin
        rx = byte[bit];
        repeat (CYCLES) @(posedge clk);
      end
      rx = 1;
      repeat (CYCLES) @(posedge clk);
    end
  endtask
  initial begin
    repeat (10) @(posedge clk);
    rst = 0;
    repeat (20 * CYCLES) @(posedge clk);
    QUESTION
    repeat (200 * 10 * CYCLES) @(posedge clk);
    $finish;
  end
  integer heard;
  always @(negedge tx) begin
    repeat (CYCLES / 2) @(posedge clk);
    for (heard = 0; heard < 8; heard = heard + 1) begin
      repeat (CYCLES) @(posedge clk);
      got[heard] = tx;
    end
    repeat (CYCLES / 2) @(posedge clk);
    $write("%c", got);
  end
endmodule
"""


@pytest.mark.rtl
@pytest.mark.skipif(shutil.which("iverilog") is None, reason="no Icarus Verilog: apt install iverilog")
def test_netlist_has_the_requested_clock_and_baud_rate(tmp_path: Path) -> None:
    (text,) = (
        file.text for file in generate("verilog", LAMP, clock_hz=CLOCK_HZ, baud=BAUD) if file.name == "lamp_on_uart.v"
    )
    assert "// The gateway of lamp on a UART of 2000000 baud, at 12 MHz.\n" in text
    (tmp_path / "lamp.v").write_text(text)
    question = " ".join(f"send(8'd{byte});" for byte in FRAMING.checked(b"Q"))
    (tmp_path / "bench.v").write_text(BENCH.replace("CYCLES", str(CLOCK_HZ // BAUD)).replace("QUESTION", question))
    subprocess.run(["iverilog", "-g2005", "-o", "bench", "lamp.v", "bench.v"], cwd=tmp_path, check=True)
    said = subprocess.run(["vvp", "-n", "bench"], cwd=tmp_path, check=True, capture_output=True).stdout
    answer = FRAMING.open(said.splitlines()[0])
    assert GatewayInfo.from_hex(answer[1:]).clock_hz == CLOCK_HZ


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"clock_hz": 4_000_000, "baud": 1_000_001}, "baud is 1000001: at most a quarter of a clock of 4000000 Hz"),
        ({"clock_hz": 0}, "clock_hz is 0 and baud 1000000: more than 0 was expected of both"),
        ({"baud": -1}, "clock_hz is 50000000 and baud -1: more than 0"),
        ({"clock_hz": 1_000_000, "baud": 9600}, "leaves 10 cycles of a clock of 1000000 Hz"),
        ({"licence": "MIT"}, "verilog takes no licence: it is for ros1 and ros2"),
    ],
)
def test_generics_that_the_gateware_refuses_are_refused_before_conversion(
    options: dict[str, int | str], words: str
) -> None:
    with pytest.raises(ArgumentError, match=words):
        generate("verilog", LAMP, None, **options)


def test_clock_option_is_only_for_verilog() -> None:
    with pytest.raises(ArgumentError, match="ros1 takes no clock_hz: it is for verilog"):
        generate("ros1", LAMP, clock_hz=1)
