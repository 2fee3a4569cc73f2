"""Settings of PLLs that make exactly the core clock that a board's file requests.

The frequency must be exact, because baud rates and times are counted in cycles of this clock. The limits are from:
Lattice TN1251 (iCE40) and TN1263 (ECP5), Gowin UG286 and the devices' own, Cologne Chip DS1001 (GateMate).
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from unity_link.boards.board import Board

_MHZ = 1_000_000
_ICE40_PADS = {("up5k", "35")}
"""Device and site of clock inputs that are connected only to the PLL."""
# Highest frequency of the phase detector in MHz, and the setting of the filter up to it.
_ICE40_FILTERS = ((17, 1), (26, 2), (44, 3), (66, 4), (101, 5), (133, 6))


class _Settings(NamedTuple):
    hz: Fraction
    divider: int
    """Divider of the input clock."""
    factor: int
    output: int
    """Divider between the oscillator and the output."""


def pll(board: Board) -> str:
    """Return the Verilog instance of a PLL that makes `core_clk` from `clk`; `ready` is its lock signal.

    Raises:
        ArgumentError: if the board's FPGA cannot make the frequency.
    """
    candidates, text = {
        "ice40": (_ice40, _ice40_text),
        "ecp5": (_ecp5, _ecp5_text),
        "gowin": (_gowin, _gowin_text),
        "gatemate": (_gatemate, _gatemate_text),
    }[board.family]
    wanted = board.core_hz
    best = min(candidates(board.clock.hz), key=lambda one: abs(one.hz - wanted), default=None)
    if best is None or best.hz != wanted:
        nearest = f"; the nearest is {float(best.hz) / _MHZ:.6f} MHz" if best is not None else ""
        given = f"{board.clock.hz / _MHZ:g} MHz"
        raise ArgumentError(f"the PLL of an {board.device} cannot make {wanted / _MHZ:.9g} MHz of {given}{nearest}")
    return text(board, best)


def _within(
    hz: int,
    dividers: Iterable[int],
    factors: Iterable[int],
    outputs: Iterable[int],
    detector: tuple[int, int],
    vco: range,
) -> Iterator[_Settings]:
    """Yield the possible settings of a PLL whose oscillator runs at input / divider * factor.

    Args:
        hz: input frequency in Hz.
        dividers: possible dividers of the input clock.
        factors: possible factors.
        outputs: possible dividers of the output.
        detector: lowest and highest frequency of the phase detector, in MHz.
        vco: lowest and highest frequency of the oscillator, in MHz.
    """
    for divider in dividers:
        # Compare integers, not fractions: there are a million settings to try.
        unit = divider * _MHZ
        if not detector[0] * unit <= hz <= detector[1] * unit:
            continue
        for factor in factors:
            if vco.start * unit <= hz * factor <= vco.stop * unit:
                made = Fraction(hz * factor, divider)
                yield from (_Settings(made / output, divider, factor, output) for output in outputs)


def _ice40(hz: int) -> Iterator[_Settings]:
    return _within(hz, range(1, 17), range(1, 65), [2**power for power in range(1, 7)], (10, 133), range(533, 1066))


def _feedback(
    hz: int, dividers: range, factors: range, outputs: Iterable[int], detector: tuple[int, int], vco: range
) -> Iterator[_Settings]:
    """Yield the possible settings of a PLL with feedback from its output, which runs at input / divider * factor."""
    for output in outputs:
        for found in _within(hz, dividers, range(output, factors.stop * output, output), (output,), detector, vco):
            yield found._replace(factor=found.factor // output)


def _ecp5(hz: int) -> Iterator[_Settings]:
    return _feedback(hz, range(1, 129), range(1, 81), range(1, 129), (4, 400), range(400, 800))


def _gowin(hz: int) -> Iterator[_Settings]:
    outputs = (2, 4, 8, 16, 32, 48, 64, 80, 96, 112, 128)
    # The limits that GW1N, GW1NR, GW2A and GW2AR have in common.
    return _feedback(hz, range(1, 65), range(1, 65), outputs, (3, 400), range(500, 1200))


def _gatemate(hz: int) -> Iterator[_Settings]:
    # The factor is the product of two dividers; the first one is 2 to 64.
    factors = [factor for factor in range(2, 201) if any(factor % first == 0 for first in range(2, 65))]
    return _within(hz, (1,), factors, range(4, 4097, 4), (5, 50), range(500, 1000))


def _ice40_text(board: Board, found: _Settings) -> str:
    detector = board.clock.hz / found.divider / _MHZ
    filter_range = next(setting for limit, setting in _ICE40_FILTERS if detector <= limit)
    pad = (board.device, board.pins["clk"]) in _ICE40_PADS
    return f"""\
  SB_PLL40_{"PAD" if pad else "CORE"} #(
    .FEEDBACK_PATH("SIMPLE"), .DIVR(4'd{found.divider - 1}), .DIVF(7'd{found.factor - 1}),
    .DIVQ(3'd{found.output.bit_length() - 1}), .FILTER_RANGE(3'd{filter_range})
  ) pll (
    .{"PACKAGEPIN" if pad else "REFERENCECLK"}(clk), .PLLOUTGLOBAL(core_clk), .LOCK(ready), .RESETB(1'b1), .BYPASS(1'b0)
  );
"""


def _ecp5_text(board: Board, found: _Settings) -> str:
    return f"""\
  (* FREQUENCY_PIN_CLKI = "{board.clock.hz / _MHZ:g}", FREQUENCY_PIN_CLKOP = "{board.core_hz / _MHZ:g}" *)
  (* ICP_CURRENT = "12", LPF_RESISTOR = "8", MFG_ENABLE_FILTEROPAMP = "1", MFG_GMCREF_SEL = "2" *)
  EHXPLLL #(
    .PLLRST_ENA("DISABLED"), .INTFB_WAKE("DISABLED"), .STDBY_ENABLE("DISABLED"), .DPHASE_SOURCE("DISABLED"),
    .FEEDBK_PATH("CLKOP"), .OUTDIVIDER_MUXA("DIVA"), .CLKOP_ENABLE("ENABLED"), .CLKI_DIV({found.divider}),
    .CLKFB_DIV({found.factor}), .CLKOP_DIV({found.output}), .CLKOP_CPHASE({found.output // 2}), .CLKOP_FPHASE(0)
  ) pll (
    .CLKI(clk), .CLKFB(core_clk), .CLKOP(core_clk), .LOCK(ready), .RST(1'b0), .STDBY(1'b0), .CLKINTFB(),
    .PHASESEL0(1'b0), .PHASESEL1(1'b0), .PHASEDIR(1'b1), .PHASESTEP(1'b1), .PHASELOADREG(1'b1),
    .PLLWAKESYNC(1'b0), .ENCLKOP(1'b0)
  );
"""


def _gowin_text(board: Board, found: _Settings) -> str:
    return f"""\
  rPLL #(
    .DEVICE("{board.device}"), .FCLKIN("{board.clock.hz / _MHZ:g}"), .IDIV_SEL({found.divider - 1}),
    .FBDIV_SEL({found.factor - 1}), .ODIV_SEL({found.output}), .CLKFB_SEL("internal"), .DYN_IDIV_SEL("false"),
    .DYN_FBDIV_SEL("false"), .DYN_ODIV_SEL("false"), .DYN_DA_EN("false"), .PSDA_SEL("0000"), .DUTYDA_SEL("1000")
  ) pll (
    .CLKIN(clk), .CLKOUT(core_clk), .LOCK(ready), .RESET(1'b0), .RESET_P(1'b0), .CLKFB(1'b0), .FBDSEL(6'b0),
    .IDSEL(6'b0), .ODSEL(6'b0), .PSDA(4'b0), .DUTYDA(4'b0), .FDLY(4'b0)
  );
"""


def _gatemate_text(board: Board, found: _Settings) -> str:  # noqa: ARG001  (nextpnr looks for the dividers itself)
    return f"""\
  CC_PLL #(
    .REF_CLK("{board.clock.hz / _MHZ:g}"), .OUT_CLK("{board.core_hz / _MHZ:.9g}"), .PERF_MD("ECONOMY"),
    .LOW_JITTER(1), .LOCK_REQ(1), .CI_FILTER_CONST(2), .CP_FILTER_CONST(4)
  ) pll (
    .CLK_REF(clk), .USR_CLK_REF(1'b0), .CLK_FEEDBACK(1'b0), .USR_LOCKED_STDY_RST(1'b0), .CLK0(core_clk),
    .USR_PLL_LOCKED(ready), .CLK90(), .CLK180(), .CLK270(), .CLK_REF_OUT(), .USR_PLL_LOCKED_STDY()
  );
"""
