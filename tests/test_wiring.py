"""The pictures of wiring are the output of their script, with the ports of the gateware."""

import re
from pathlib import Path

import pytest

from docs.images.make import PICTURES
from unity_link.boards.loading import load_board

IMAGES = Path(__file__).parents[1] / "docs" / "images"
WIRING = sorted(name for name in PICTURES if name.startswith(("wiring-", "core-", "lease")))


@pytest.mark.parametrize("name", WIRING)
def test_picture_is_the_output_of_its_script(name: str, tmp_path: Path) -> None:
    PICTURES[name](tmp_path / name)
    assert (tmp_path / name).read_text(encoding="utf-8") == (IMAGES / name).read_text(encoding="utf-8")


def test_the_drawing_of_a_motor_has_the_pins_of_the_spec_beside_it() -> None:
    page = (IMAGES.parent / "how-to" / "stop-safely.md").read_text(encoding="utf-8")
    listing = re.search(r"```ul\n(drive: LEASE.*?)```\n\n!\[[^\]]*\]\(\.\./images/wiring-motor\.svg\)", page, re.DOTALL)
    assert listing is not None
    shown = re.findall(r">(\w+)  (gp\d+)<", (IMAGES / "wiring-motor.svg").read_text(encoding="utf-8"))
    assert sorted(shown) == sorted(re.findall(r'(\w+)="(gp\d+)"', listing[1]))
    assert {pin for _, pin in shown} <= load_board("ulx3s")[1].io_pins.keys()


@pytest.mark.parametrize(("name", "board"), [("wiring-uart.svg", "ulx3s"), ("wiring-ft245.svg", "ulx3s_ft245_sync")])
def test_a_picture_has_the_ports_that_a_build_wires(name: str, board: str) -> None:
    _, described = load_board(board)
    ports = {re.sub(r"\[\d\]", "[0..7]", pin) for pin in described.pins if pin.startswith(("uart_", "ft_"))}
    shown = re.findall(r">((?:uart|ft)_[a-z]\w*(?:\[0\.\.7\])?)", (IMAGES / name).read_text(encoding="utf-8"))
    assert set(shown) == ports
