"""`unity-link ft232h` with virtual chips."""

from __future__ import annotations

import socket
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
import pytest
import typer
from typer.testing import CliRunner

from unity_link.cli import ft232h
from unity_link.errors import ConnectError
from unity_link.transport.ft232h.eeprom_image import BLANK, build_eeprom, channel_type, checksum, strings
from unity_link.transport.ft232h.kinds import FT232H, FT2232H, ChipKind
from unity_link.virtual import VirtualGateway
from unity_link.virtual.ft232h.board import GatewayBoard
from unity_link.virtual.ft232h.bus import VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.pyusb_backend import installed

if TYPE_CHECKING:
    from collections.abc import Iterator

URL = "ftdi://ftdi:232h/1"
app = typer.Typer(pretty_exceptions_enable=False)
ft232h.add_to(app)


@contextmanager
def plugged_in(*images: bytes, kind: ChipKind = FT232H) -> Iterator[list[VirtualFt232h]]:
    devices = [VirtualFt232h(GatewayBoard(VirtualGateway()), kind=kind, image=image) for image in images]
    with installed(VirtualBus(*devices)):
        yield devices


def run(*arguments: str, answer: str = "") -> tuple[int, str, str]:
    result = CliRunner().invoke(app, ["ft232h", *arguments], input=answer)
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result.exit_code, result.stdout, result.stderr


def test_the_chips_that_are_plugged_in_are_listed_by_their_urls() -> None:
    with plugged_in(build_eeprom("FIFO", "AAA"), build_eeprom("UART", "BBB")):
        code, text, _ = run("info")
    assert code == 0
    assert [line.split()[0] for line in text.splitlines()] == ["ftdi://ftdi:232h:AAA/1", "ftdi://ftdi:232h:BBB/1"]


def test_missing_chip_is_reported() -> None:
    with plugged_in():
        assert run("info") == (0, "", "no FT232H and no FT2232H is plugged in\n")


def test_contents_of_an_eeprom_are_shown() -> None:
    with plugged_in(build_eeprom("UART", "S17")):
        code, text, _ = run("info", URL)
        data = msgspec.json.decode(run("info", URL, "--json")[1])
    assert code == 0
    assert "UART" in text
    assert "S17" in text
    assert (data["channel_type"], data["is_valid"], data["serial"]) == ("UART", True, "S17")


def test_strings_of_an_eeprom_make_no_lines() -> None:
    with plugged_in(build_eeprom("UART", "S1\r\npins", manufacturer="A\nEEPROM", product="B\x1b[2J\rpins")):
        text = run("info", URL)[1]
        listed = run("info")[1]
    assert [line.split()[0] for line in text.splitlines()].count("pins") == 1
    assert "A EEPROM" in text
    assert "S1 pins" in text
    assert len(listed.splitlines()) == 1
    assert "\x1b" not in text + listed


def test_a_blank_eeprom_is_shown_as_such() -> None:
    with plugged_in(BLANK):
        assert "blank" in run("info", URL)[1]


@pytest.mark.parametrize(("image", "serial"), [(build_eeprom("UART", "S1"), "S1"), (BLANK, "UL")])
def test_configure_makes_the_pins_a_fifo_after_the_next_plug_in(image: bytes, serial: str) -> None:
    with plugged_in(image) as [device]:
        code, _, notes = run("configure", URL, "--mode", "fifo", answer="y\n")
        assert code == 0
        assert "plug it in again" in notes
        assert channel_type(device.chip.eeprom) == "FIFO"
        assert strings(device.chip.eeprom)[2].startswith(serial)
        assert device.chip.ports[0].channel_type == "UART"
        device.unplug()
        device.plug_in()
        assert "FIFO" in run("info", URL)[1]


def test_configure_keeps_the_other_contents_of_a_valid_eeprom() -> None:
    image = build_eeprom("UART", "S1", manufacturer="Somebody", product="Something")
    with plugged_in(image) as [device]:
        run("configure", URL, "--mode", "fifo", "--yes")
        assert strings(device.chip.eeprom) == ("Somebody", "Something", "S1")


@pytest.mark.parametrize("answer", ["n\n", ""])
def test_eeprom_is_written_only_after_a_yes(answer: str) -> None:
    with plugged_in(build_eeprom("UART", "S1")) as [device]:
        code, _, notes = run("configure", URL, "--mode", "fifo", answer=answer)
        assert code == 1
        assert "Nothing was written" in notes
        assert device.chip.eeprom == build_eeprom("UART", "S1")


def test_eeprom_that_is_right_already_is_not_written() -> None:
    with plugged_in(build_eeprom("FIFO", "S1")):
        assert "nothing to do" in run("configure", URL, "--mode", "fifo")[2]


def test_eeprom_that_does_not_store_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    with plugged_in(BLANK) as [device]:
        monkeypatch.setattr(device.chip, "eeprom", KeepsNothing(BLANK))
        with pytest.raises(ConnectError, match="did not keep"):
            run("configure", URL, "--mode", "fifo", "--yes")


# FT2232H

PORT_B = "ftdi://ftdi:2232h/2"


def test_each_port_is_listed_by_its_url() -> None:
    with plugged_in(build_eeprom("FIFO", "AAA", kind=FT2232H), kind=FT2232H):
        lines = run("info")[1].splitlines()
    assert [line.split()[0] for line in lines] == ["ftdi://ftdi:2232h:AAA/1", "ftdi://ftdi:2232h:AAA/2"]


def test_contents_of_an_eeprom_are_shown_for_the_port() -> None:
    with plugged_in(build_eeprom("FIFO", "S17", kind=FT2232H), kind=FT2232H):
        answers = [msgspec.json.decode(run("info", f"ftdi://ftdi:2232h/{port}", "--json")[1]) for port in (1, 2)]
    assert [(answer["chip"], answer["port"], answer["channel_type"]) for answer in answers] == [
        ("FT2232H", 1, "FIFO"),
        ("FT2232H", 2, "UART"),
    ]
    assert answers[1]["description"] == "the EEPROM makes port B of the FT2232H a UART"


def test_configure_changes_one_port_and_keeps_the_driver_of_the_other() -> None:
    image = bytearray(build_eeprom("UART", "S1", kind=FT2232H))
    image[0] = image[1] = 0x08
    image[-2:] = checksum(image[:-2]).to_bytes(2, "little")
    with plugged_in(bytes(image), kind=FT2232H) as [device]:
        run("configure", PORT_B, "--mode", "fifo", "--yes")
        assert device.chip.eeprom[:2] == b"\x08\x09"
        assert strings(device.chip.eeprom, FT2232H)[2] == "S1"
        assert "nothing to do" in run("configure", PORT_B, "--mode", "fifo")[2]


def test_a_blank_eeprom_becomes_one_of_its_chip() -> None:
    with plugged_in(BLANK, kind=FT2232H) as [device]:
        run("configure", PORT_B, "--mode", "fifo", "--yes")
        device.unplug()
        device.plug_in()
        descriptor = device.chip.device_descriptor
        assert (descriptor.idProduct, descriptor.bcdDevice) == (0x6010, 0x0700)
        assert [port.channel_type for port in device.chip.ports] == ["UART", "FIFO"]
        assert device.chip.strings[:2] == ("FTDI", "FT2232H")
        assert device.chip.eeprom[2:8] == bytes.fromhex("0304 1060 0007")


def test_simulate_serves_a_chip_by_usbip_and_prints_how_to_attach_it() -> None:
    command = [str(Path(sys.executable).parent / "unity-link"), "simulate", "--usbip", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as served:
        assert served.stdout is not None
        port = int(served.stdout.readline().split()[2])
        with socket.create_connection(("127.0.0.1", port), timeout=10) as client:
            client.sendall(bytes.fromhex("0111 8005 00000000"))
            assert client.recv(12, socket.MSG_WAITALL) == bytes.fromhex("0111 0005 00000000 00000001")
        served.terminate()


class KeepsNothing(bytearray):
    """The EEPROM of a board without one: writes have no effect."""

    def __setitem__(self, place: object, value: object) -> None:
        pass
