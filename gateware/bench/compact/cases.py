"""Frames and bytes for the benches of the compact form."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.protocol.wire.compact import COMMANDS, END, RESERVED, CompactForm, Unpacker

if TYPE_CHECKING:
    import random

    from cocotb.handle import SimHandleBase


def form_of(dut: SimHandleBase, *, from_gateway: bool) -> CompactForm:
    """Return the form for which an entity was built; a transmitter has no address digits."""
    address_digits = 0 if from_gateway else int(dut.address_digits.value)
    has_node = dut.node.value.to_signed() >= 0
    return CompactForm(int(dut.id_digits.value), 4, address_digits, from_gateway=from_gateway, has_node=has_node)


def text_of(form: CompactForm, data: bytes) -> bytes:
    """Return the text that the gateware outputs; with a node, a line end after a compact end is an empty frame."""
    return Unpacker(form).unpack(data.replace(END + b"\n", END + b"\n\n") if form.has_node else data)


def frames(form: CompactForm, rng: random.Random, count: int) -> bytes:
    """Return frames of every command, with any allowed number of digits, mixed with other frames."""
    text = ""
    for _ in range(count):
        prefix = "ZB5" if form.has_node else ""
        command = rng.choice([*COMMANDS, "gs", "K", "Q", "X", "R", "WM"])
        odd = command not in COMMANDS or not form.is_filled(command)
        digits = 8 + odd + 2 * rng.randrange(12)
        end = "\r\n" if rng.random() < 0.1 else "\n"
        text += prefix + command + "".join(rng.choices("0123456789ABCDEF0AD", k=digits)) + end
    return text.encode()


def damaged(data: bytes, rng: random.Random) -> bytes:
    """Return bytes of which some were lost, changed or added."""
    found = bytearray()
    for byte in data:
        chance = rng.random()
        if chance < 0.02:
            continue
        if chance < 0.04:
            found.append(rng.choice(RESERVED))
        elif chance < 0.06:
            found.append(byte ^ 1 << rng.randrange(8))
            continue
        found.append(byte)
    return bytes(found)
