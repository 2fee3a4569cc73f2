"""The pictures of wiring are those that their script draws, with the ports of the gateware."""

import re
from pathlib import Path

import pytest

from docs.images.make import PICTURES
from unity_link.boards.loading import load_board

IMAGES = Path(__file__).parents[1] / "docs" / "images"
WIRING = sorted(name for name in PICTURES if name.startswith(("wiring-", "core-")))


@pytest.mark.parametrize("name", WIRING)
def test_a_picture_is_what_its_script_draws(name: str, tmp_path: Path) -> None:
    PICTURES[name](tmp_path / name)
    assert (tmp_path / name).read_text(encoding="utf-8") == (IMAGES / name).read_text(encoding="utf-8")


@pytest.mark.parametrize(("name", "board"), [("wiring-uart.svg", "ulx3s"), ("wiring-ft245.svg", "ulx3s_ft245_sync")])
def test_a_picture_has_the_ports_that_a_build_wires(name: str, board: str) -> None:
    _, described = load_board(board)
    ports = {re.sub(r"\[\d\]", "[0..7]", pin) for pin in described.pins if pin.startswith(("uart_", "ft_"))}
    shown = re.findall(r">((?:uart|ft)_[a-z]\w*(?:\[0\.\.7\])?)", (IMAGES / name).read_text(encoding="utf-8"))
    assert set(shown) == ports
