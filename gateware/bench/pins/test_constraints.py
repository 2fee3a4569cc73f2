"""The names in vendors' constraint files exist, and their figures are those of the chips that the benches model."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from gateware.bench.ft245_sync.chip import CHIPS, PERIOD_PS
from gateware.bench.runner import GATEWARE
from unity_link.boards.board import CLOCKS, PINS
from unity_link.gateware.cache import vhdl_sources

if TYPE_CHECKING:
    from pathlib import Path

_FILES = sorted(
    path for path in (GATEWARE / "constraints").rglob("*") if path.suffix in (".xdc", ".sdc", ".lpf", ".pdc")
)
_WITH_PINS = [path for path in _FILES if "set_input_delay" in path.read_text()]
_SOURCES = {path.stem: path.read_text() for path in vhdl_sources()}


def _id(path: Path) -> str:
    return f"{path.parent.name}/{path.name}"


def _code(path: Path) -> str:
    return "\n".join(line for line in path.read_text().splitlines() if not re.match(r"\s*(#|//)", line))


@pytest.mark.parametrize("path", _FILES, ids=_id)
def test_every_register_that_is_named_is_in_the_sources(path: Path) -> None:
    own = _SOURCES.get(path.stem)
    text = own if path.parent.name == "vivado" and own else "\n".join(_SOURCES.values())
    named = set(re.findall(r"\b(\w+)_reg\b", _code(path))) - {"meta", "pad"}
    named |= set(re.findall(r"\b(\w+_crossing|chip_\w+|write_gray|read_gray)\b(?!_reg)", _code(path)))
    for name in named:
        assert re.search(rf"\b{name.removesuffix('_reg')}\b", text), name


@pytest.mark.parametrize("path", _FILES, ids=_id)
def test_unchecked_constraints_are_marked_as_such(path: Path) -> None:
    assert "Unchecked" in path.read_text()


_CHIP = CHIPS["ft232h"]
_STANDARDS = {
    # FT_000288, table 4.1, as in the chip model of the bench.
    "ft245_sync": {
        ("in", "ft_clkout", False): (0, _CHIP.output / 1000),
        ("out", "ft_clkout", False): (0, _CHIP.setup / 1000),
    },
    # RMII 1.2: the PHY's outputs come 2 to 14 ns after REF_CLK; its inputs need 4 ns before and 2 ns after.
    "rmii": {("in", "phy_clk", False): (2, 14), ("out", "phy_clk", False): (-2, 4)},
    # IEEE 802.3, 22.3: 10 ns before and after RX_CLK; 0 to 25 ns after TX_CLK, of 40.
    "mii": {("in", "phy_rx_clk", False): (10, 40 - 10), ("out", "phy_tx_clk", False): (0, 40 - 25)},
    # RGMII 2.0: 1.0 to 2.6 ns before each edge of RXC; 1.0 ns before and after each of TXC, which may be 2.6 ns late.
    "rgmii": {
        (way, clock, fall): times
        for fall in (False, True)
        for way, clock, times in (("in", "phy_rx_clk", (20 - 2.6, 20 - 1)), ("out", "phy_txc", (-1 - 2.6, 1)))
    },
}
"""Minimum and maximum delay in ns, by direction, clock, and whether it refers to a falling edge."""
_PERIODS = {"ft_clkout": PERIOD_PS / 1000, **{clock: 1e9 / hz for of in CLOCKS.values() for clock, hz in of.items()}}
_DELAY = re.compile(
    r"^ *set_(in|out)put_delay -clock (?:\[get_clocks )?(\w+)\]?( -clock_fall -add_delay)? -(max|min) (\S+) "
    r"\[get_ports \{(.*)\}\]$",
    re.MULTILINE,
)


def _medium(path: Path) -> str:
    return next((medium for medium in ("rmii", "mii", "rgmii") if f"_{medium}_" in f"_{path.stem}_"), "ft245_sync")


@pytest.mark.parametrize("path", _WITH_PINS, ids=_id)
def test_the_pins_have_the_times_of_the_chip_or_the_standard(path: Path) -> None:
    code, medium = _code(path), _medium(path)
    found: dict[tuple[str, str, bool], dict[str, float]] = {}
    for way, clock, fall, end, time, _ in _DELAY.findall(code):
        found.setdefault((way, clock, bool(fall)), {})[end] = float(time)
    assert {
        place: (pytest.approx(times["min"]), pytest.approx(times["max"])) for place, times in found.items()
    } == _STANDARDS[medium]
    periods = {clock: float(period) for clock, period in re.findall(r"create_clock -name (\w+) -period (\S+)", code)}
    assert periods == {clock: pytest.approx(_PERIODS[clock], abs=0.001) for clock in periods}
    made = re.findall(r"create_generated_clock -name (\w+) .* -divide_by 2 ", code)
    assert {*periods, *made} == {clock for _, clock, _ in _STANDARDS[medium]}
    assert made == (["phy_txc"] if medium == "rgmii" else [])


@pytest.mark.parametrize("path", _WITH_PINS, ids=_id)
def test_each_pin_of_the_chip_has_a_delay(path: Path) -> None:
    pins, medium = PINS[_medium(path)], _medium(path)
    chips = {pin for pin in pins if pin.startswith(("ft_", "phy_"))}
    free = {*CLOCKS[medium], "phy_txc", "phy_rst_n", "phy_clk_25"}
    for way, ends in (("in", ("input", "inout")), ("out", ("output", "inout"))):
        named = {port for its, *_, ports in _DELAY.findall(_code(path)) if its == way for port in ports.split()}
        wanted = {pin for pin in chips - free if pins[pin] in ends}
        assert {re.sub(r"\[\d+\]", "[*]", pin) for pin in wanted} == named


@pytest.mark.parametrize("medium", ["rmii", "mii", "rgmii"])
def test_the_preferences_of_diamond_have_the_same_times(medium: str) -> None:
    code = _code(GATEWARE / "constraints" / "lattice" / f"{medium}_pins.lpf")
    interval = 20 if medium in ("rmii", "rgmii") else 40
    wanted = {way: times for (way, _, fall), times in _STANDARDS[medium].items() if not fall}
    setups = re.findall(r'^INPUT_SETUP PORT "(\S+)" (\S+) NS HOLD (\S+) NS ', code, re.MULTILINE)
    times_in = {(float(setup), float(hold)) for _, setup, hold in setups}
    assert times_in == {(round(interval - wanted["in"][1], 3), round(wanted["in"][0], 3))}
    outputs = re.findall(r'^CLOCK_TO_OUT PORT "(\S+)" MAX (\S+) NS MIN (\S+) NS ', code, re.MULTILINE)
    times_out = {(float(most), float(least)) for _, most, least in outputs}
    assert times_out == {(round(interval - wanted["out"][1], 3), round(-wanted["out"][0], 3))}
    data = {pin for pin in PINS[medium] if pin.startswith("phy_")} - {*CLOCKS[medium], "phy_txc", "phy_rst_n"}
    assert {pin for pin, *_ in (*setups, *outputs)} == data - {"phy_clk_25"}


def test_constraints_of_the_board_have_the_intervals_of_its_chip() -> None:
    text = (GATEWARE / "boards" / "ecp5_ft2232h" / "ecp5_ft2232h.lpf").read_text()
    chip = CHIPS["ft2232h"]
    setups = set(re.findall(r'^INPUT_SETUP PORT "\S+" ([\d.]+) NS HOLD ([\d.]+) NS', text, re.MULTILINE))
    assert setups == {(f"{(PERIOD_PS - chip.output) / 1000:.2f}", f"{chip.hold / 1000:g}")}
    outputs = set(re.findall(r'^CLOCK_TO_OUT PORT "\S+" MAX ([\d.]+) NS', text, re.MULTILINE))
    assert outputs == {f"{(PERIOD_PS - chip.setup) / 1000:.2f}"}


def test_every_crossing_is_in_the_files_of_every_vendor() -> None:
    crossings = {
        name for text in _SOURCES.values() for name in re.findall(r"^ *(\w+_crossing) : entity", text, re.MULTILINE)
    }
    assert crossings
    vendors = {path.parent.name for path in _FILES}
    for vendor in vendors:
        for suffix in {path.suffix for path in _FILES if path.parent.name == vendor}:
            of_one_tool = [path for path in _FILES if path.parent.name == vendor and path.suffix == suffix]
            text = "\n".join(map(_code, of_one_tool))
            named = {name for name in crossings if name in text or re.search(r"\$\{way\}_crossing", text)}
            assert named == crossings, f"{vendor}, {suffix}"
