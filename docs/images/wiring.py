"""Draws wiring and timing as SVG: boxes with pins on their sides, lines between pins, and levels over time."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from pathlib import Path

_ROW = 26
"""Height of a pin."""
_HEAD = 34
"""Height of a box above its first pin."""
_TEXT = 'font-family="sans-serif" font-size="13"'


class Box(NamedTuple):
    """Something with pins."""

    title: str
    x: int
    y: int
    width: int
    left: tuple[str, ...] = ()
    """Pins on the left side, from above; empty ones leave a gap."""
    right: tuple[str, ...] = ()

    def at(self, pin: str) -> tuple[int, int]:
        """Return the position of a pin, in units of the picture."""
        side, x = (self.left, self.x) if pin in self.left else (self.right, self.x + self.width)
        return x, self.y + _HEAD + _ROW * side.index(pin)

    def draw(self) -> str:
        """Return the box as SVG."""
        height = _HEAD + _ROW * max(len(self.left), len(self.right))
        parts = [
            (
                f'<rect x="{self.x}" y="{self.y}" width="{self.width}" height="{height}" rx="6" '
                'fill="#eef2f8" stroke="#345"/>'
            ),
            _text(self.x + self.width // 2, self.y + 16, self.title, "middle", 'font-weight="bold"'),
        ]
        for side, anchor, inside in ((self.left, "start", 8), (self.right, "end", -8)):
            for pin in filter(None, side):
                x, y = self.at(pin)
                parts += [f'<circle cx="{x}" cy="{y}" r="3.5" fill="#345"/>', _text(x + inside, y + 4, pin, anchor)]
        return "\n".join(parts)


def _text(x: int, y: int, text: str, anchor: str, more: str = "") -> str:
    return f'<text x="{x}" y="{y}" text-anchor="{anchor}" fill="#123" {_TEXT} {more}>{escape(text)}</text>'


def _path(steps: str, marks: str = "") -> str:
    return f'<path d="{steps}" fill="none" stroke="#b33" stroke-width="2" {marks}/>'


def _wire(start: tuple[int, int], end: tuple[int, int], arrow: str = "") -> str:
    """Return a level wire, with an arrow at its end, or at both."""
    marks = {"": "", "->": 'marker-end="url(#to)"', "<-": 'marker-start="url(#to)"'}
    marks["<->"] = f"{marks['->']} {marks['<-']}"
    return _path(f"M {start[0]} {start[1]} L {end[0]} {end[1]}", marks[arrow])


def _picture(width: int, height: int, parts: list[str]) -> str:
    arrow = (
        '<marker id="to" viewBox="0 0 10 10" refX="14" refY="5" markerWidth="5" markerHeight="5" '
        'orient="auto-start-reverse"><path d="M 0 0 L 10 5 L 0 10 z" fill="#b33"/></marker>'
    )
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}">'
    background = f'<rect width="{width}" height="{height}" rx="8" fill="white"/>'
    return "\n".join([head, f"<defs>{arrow}</defs>", background, *parts, "</svg>"]) + "\n"


def _side_by_side(left: str, right: str, wires: list[tuple[str, str, str]]) -> str:
    """Return a picture of two boxes with a wire in each row."""
    one = Box(left, 20, 20, 200, right=tuple(wire[0] for wire in wires))
    other = Box(right, 460, 20, 200, left=tuple(wire[2] for wire in wires))
    lines = [_wire(one.at(pin), other.at(to), arrow) for pin, arrow, to in wires]
    return _picture(680, 60 + _HEAD + _ROW * len(wires) - 20, [one.draw(), other.draw(), *lines])


def symbol(name: str, pins: dict[str, str], picture: Path) -> None:
    """Draw a core as a box: signals of programs on its left side, pins on its right.

    Args:
        name: in the box.
        pins: an arrow for each, by its name.
        picture: file to write.
    """
    box = Box(name, 40, 10, 130, left=("signals",), right=tuple(pins))
    lines = [_wire((10, box.at("signals")[1]), box.at("signals"), "<->")]
    lines += [_wire(box.at(pin), (200, box.at(pin)[1]), arrow) for pin, arrow in pins.items()]
    picture.write_text(_picture(210, 20 + _HEAD + _ROW * max(1, len(pins)), [box.draw(), *lines]))


def own_core(picture: Path) -> None:
    """Draw a core of one's own between the generated register bank and a pin."""
    ports = (("period", "->"), ("period_written", "->"), ("flashes", "<-"))
    names = tuple(name for name, _ in ports)
    bus = Box("PC", 20, 20, 60, left=(), right=("link",))
    bank = Box("register bank, generated", 150, 20, 190, left=("bus",), right=names)
    core = Box("blink.vhd", 440, 20, 150, left=names, right=("light",))
    board = Box("board", 660, 20, 80, left=("led0",))
    boxes = [box.draw() for box in (bus, bank, core, board)]
    lines = [_wire(bus.at("link"), bank.at("bus"), "<->"), _wire(core.at("light"), board.at("led0"), "->")]
    lines += [_wire(bank.at(name), core.at(name), arrow) for name, arrow in ports]
    picture.write_text(_picture(760, 60 + _HEAD + _ROW * len(ports) - 20, [*boxes, *lines]))


def lease(picture: Path) -> None:
    """Draw a lease over time: kicks of a program that dies, the end of the lease, and its outputs."""
    kicks, end = (130, 210, 290), 430
    parts = [_text(20, y, name, "start") for y, name in ((54, "program"), (104, "enable"), (154, "motor"))]
    parts += [_path(f"M {x} 62 V 38", 'marker-end="url(#to)"') + _text(x, 28, "kick", "middle") for x in kicks]
    parts += [_text(345, 54, "dies here", "middle"), _text(640, 54, "time", "end")]
    parts.append(_path("M 110 62 H 640", 'marker-end="url(#to)"'))
    for y, delay in ((110, 0), (160, 12)):
        parts.append(_path(f"M 110 {y} V {y - 22} H {end + delay} V {y} H 640"))
    parts += [_path(f"M {kicks[-1]} 190 H {end}", 'marker-start="url(#to)" marker-end="url(#to)"')]
    parts += [_text((kicks[-1] + end) // 2, 208, "time-out", "middle"), _text(end + 26, 152, "off", "start")]
    picture.write_text(_picture(660, 220, parts))


def uart(picture: Path) -> None:
    """Draw a UART through a USB adapter."""
    wires = [("TXD", "->", "uart_rxd"), ("RXD", "<-", "uart_txd"), ("GND", "", "GND")]
    picture.write_text(_side_by_side("USB adapter, 3.3 V", "FPGA", wires))


def ft245(picture: Path) -> None:
    """Draw an FT232H as a FIFO."""
    wires = [
        ("ADBUS0..7  D0..D7", "<->", "ft_data[0..7]"),
        ("ACBUS0  RXF#", "->", "ft_rxf_n"),
        ("ACBUS1  TXE#", "->", "ft_txe_n"),
        ("ACBUS2  RD#", "<-", "ft_rd_n"),
        ("ACBUS3  WR#", "<-", "ft_wr_n"),
        ("ACBUS4  SIWU#", "<-", "ft_siwu_n"),
        ("ACBUS5  CLKOUT *", "->", "ft_clkout *"),
        ("ACBUS6  OE# *", "<-", "ft_oe_n *"),
        ("GND", "", "GND"),
    ]
    picture.write_text(_side_by_side("FT232H, FT2232H port A", "FPGA   (* synchronous)", wires))


def rs485(picture: Path) -> None:
    """Draw two gateways on one pair of wires."""
    adapter = Box("USB adapter, RS-485", 20, 20, 180, right=("A", "B"))
    parts = [adapter.draw()]
    bottom = 0
    for number, node in enumerate((5, 6)):
        y = 20 + 190 * number
        transceiver = Box("transceiver", 330, y, 130, left=("A", "B"), right=("DI", "DE", "RE#", "RO"))
        fpga = Box(f"FPGA, node {node}", 550, y, 130, left=("uart_txd", "uart_de", "", "uart_rxd"))
        for line, pin in enumerate(("A", "B")):
            x, to_y = transceiver.at(pin)
            first = adapter.at(pin)
            rail = 260 + 30 * line
            parts.append(_path(f"M {first[0]} {first[1]} H {rail} V {to_y} H {x}"))
            parts.append(f'<circle cx="{rail}" cy="{first[1]}" r="3.5" fill="#b33"/>')
        for pin, arrow, to in (("DI", "<-", "uart_txd"), ("DE", "<-", "uart_de"), ("RO", "->", "uart_rxd")):
            parts.append(_wire(transceiver.at(pin), fpga.at(to), arrow))
        x, to_y = transceiver.at("RE#")
        parts.append(_path(f"M {x} {to_y} H {x + 20}"))
        parts += [_text(x + 26, to_y + 4, "GND", "start"), transceiver.draw(), fpga.draw()]
        bottom = y + _HEAD + 4 * _ROW + 20
    parts.append(_text(20, 150, "120 Ω between A and B at both", "start"))
    parts.append(_text(20, 168, "ends, bias at one; GND to all.", "start"))
    picture.write_text(_picture(700, bottom, parts))


def motor(picture: Path) -> None:
    """Draw a motor with its driver, encoder and e-stop at the board of a PC."""
    pins = (
        "pwm  gp0",
        "dir  gp1",
        "enable  gp8",
        "GND",
        "",
        "",
        "a  gp4",
        "b  gp5",
        "GND ",
        "3.3 V ",
        "",
        "",
        "3.3 V",
        "estop  gp9",
    )
    pc = Box("PC", 20, 98, 110, right=("USB",))
    board = Box("FPGA board", 210, 20, 150, left=("", "", "", "USB"), right=pins)
    driver = Box("motor driver", 530, 20, 150, left=("PWM", "DIR", "enable", "GND"), right=("supply", "M+", "M-"))
    turned = Box("motor, encoder", 530, 176, 150, left=("A", "B", "GND", "supply"), right=("M-", "M+"))
    button = Box("e-stop", 530, 332, 150, left=("contact 1", "contact 1 "), right=("contact 2", "contact 2 "))
    supply = Box("motor supply", 790, 358, 130, left=("+", "GND"))
    wires = [
        (pc.at("USB"), board.at("USB"), "<->"),
        (board.at("pwm  gp0"), driver.at("PWM"), "->"),
        (board.at("dir  gp1"), driver.at("DIR"), "->"),
        (board.at("enable  gp8"), driver.at("enable"), "->"),
        (board.at("GND"), driver.at("GND"), ""),
        (board.at("a  gp4"), turned.at("A"), "<-"),
        (board.at("b  gp5"), turned.at("B"), "<-"),
        (board.at("GND "), turned.at("GND"), ""),
        (board.at("3.3 V "), turned.at("supply"), ""),
        (board.at("3.3 V"), button.at("contact 1"), ""),
        (board.at("estop  gp9"), button.at("contact 1 "), "<-"),
        (button.at("contact 2 "), supply.at("+"), ""),
    ]
    parts = [_wire(*wire) for wire in wires]
    bends = [("M-", turned, "M-", 720), ("M+", turned, "M+", 740), ("supply", button, "contact 2", 760)]
    for pin, other, to, rail in bends:
        (x, y), (to_x, to_y) = driver.at(pin), other.at(to)
        parts.append(_path(f"M {x} {y} H {rail} V {to_y} H {to_x}"))
    x, y = supply.at("GND")
    parts += [_path(f"M {x} {y} H {x - 30} V {y + 22}"), _text(x - 30, y + 38, "GND of all", "middle")]
    for pin in ("enable  gp8", "estop  gp9"):
        parts.append(_text(445, board.at(pin)[1] - 7, "4.7 kΩ to GND", "middle"))
    boxes = [box.draw() for box in (pc, board, driver, turned, button, supply)]
    picture.write_text(_picture(940, 468, [*parts, *boxes]))
