"""Pins of cores and registers get sites by the board's names; a pin without a site, or with two uses, is reported."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from docs.walkthrough import files_of
from unity_link.boards.loading import load_board
from unity_link.boards.pins import generated_pins
from unity_link.errors import ArgumentError
from unity_link.generate.vhdl.bank import Bank
from unity_link.spec import compile_text

ROOT = Path(__file__).parents[2]
DATA = ROOT / "unity_link" / "boards" / "data"
HOW_TO = ROOT / "docs" / "how-to" / "boards.md"
CART = files_of(HOW_TO)["cart.ul"]
REFUSED = [line for line in HOW_TO.read_text().splitlines() if re.match(r"cart has pins|\S+ is at gp", line)]
CHAINED = """\
public lamp() {
  @lamp = 0: bool READWRITE(PIN="%s");
  @level = 1: unsigned 8 READWRITE();
}
"""


def sites(text: str, board: str = "ulx3s") -> dict[str, str]:
    """Return the sites of the pins of a spec, without the pins of the link."""
    pins = generated_pins(Bank(compile_text(text).interface()), board, load_board(board)[1])
    return {name: pin.site for name, pin in pins.items() if not name.startswith(("clk", "uart_"))}


def test_the_spec_of_the_page_is_at_the_sites_of_its_names_and_has_no_chain() -> None:
    assert sites(CART) == {
        "lamp": "B2",
        "fire[0]": "R1",
        "fire[1]": "T1",
        "left_pwm": "B11",
        "left_dir": "A10",
        "fan_pwm": "A9",
    }


@pytest.mark.parametrize(
    ("change", "sentence"),
    list(zip([(", dir=none", ""), ('"gp2"', '"gp99"'), ('"gp2"', '"gp1"')], REFUSED, strict=True)),
)
def test_faults_at_pins_are_reported_as_on_the_page(change: tuple[str, str], sentence: str) -> None:
    with pytest.raises(ArgumentError, match=f"^{re.escape(sentence).replace(re.escape('...'), '.*')}$"):
        sites(CART.replace(*change))


def test_signals_without_a_pin_use_a_chain_whose_pins_are_reserved() -> None:
    chain = {pin: site for pin, site in sites(CHAINED % "led0", "hx8k_breakout").items() if pin.startswith("chain_")}
    assert sorted(chain) == ["chain_clk", "chain_in", "chain_load_n", "chain_out"]
    with pytest.raises(
        ArgumentError, match=r"^lamp is at j2_\d+ of hx8k_breakout.*chain of shift registers.*level; take"
    ):
        sites(CHAINED % "j2_19", "hx8k_breakout")


@pytest.fixture
def small_board(tmp_path: Path) -> str:
    """Return the file of a board that has no pins for a chain of shift registers."""
    lines = (DATA / "hx8k_breakout.toml").read_text().splitlines()
    path = tmp_path / "small.toml"
    path.write_text("\n".join(line for line in lines if not line.startswith("chain_")))
    return str(path)


def test_board_without_chain_pins_takes_a_spec_without_a_chain(small_board: str) -> None:
    text = 'public lamp() { @lamp = 0: bool READWRITE(PIN="led0"); }'
    assert sites(text, small_board) == sites(text, "hx8k_breakout")


def test_board_without_chain_pins_refuses_signals_on_the_chain(small_board: str) -> None:
    with pytest.raises(ArgumentError) as caught:
        sites(CHAINED % "led0", small_board)
    assert str(caught.value) == (
        f"{small_board} has no pins for the chain of shift registers that holds the signals without a pin, level: give "
        "chain_clk, chain_load_n, chain_out, chain_in sites under [pins]"
    )


def test_board_with_some_of_the_chain_pins_is_refused(small_board: str) -> None:
    path = Path(small_board)
    path.write_text(path.read_text().replace("[pins]", '[pins]\nchain_clk = "P1"'))
    with pytest.raises(ArgumentError, match="the pin chain_load_n has no site"):
        load_board(small_board)
