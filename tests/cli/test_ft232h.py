"""`unity-link ft232h` on virtual chips."""

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
from unity_link.transport.ft232h.eeprom_image import BLANK, build_eeprom, channel_type, strings
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
def plugged_in(*images: bytes) -> Iterator[list[VirtualFt232h]]:
    devices = [VirtualFt232h(GatewayBoard(VirtualGateway()), image=image) for image in images]
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


def test_no_chip_is_said_in_words() -> None:
    with plugged_in():
        assert run("info") == (0, "", "no FT232H is plugged in\n")


def test_what_an_eeprom_says_is_shown() -> None:
    with plugged_in(build_eeprom("UART", "S17")):
        code, text, _ = run("info", URL)
        data = msgspec.json.decode(run("info", URL, "--json")[1])
    assert code == 0
    assert "UART" in text
    assert "S17" in text
    assert (data["channel_type"], data["is_valid"], data["serial"]) == ("UART", True, "S17")


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
        assert device.chip.channel_type == "UART"
        device.unplug()
        device.plug_in()
        assert "FIFO" in run("info", URL)[1]


def test_configure_keeps_what_else_a_sound_eeprom_says() -> None:
    image = build_eeprom("UART", "S1", manufacturer="Somebody", product="Something")
    with plugged_in(image) as [device]:
        run("configure", URL, "--mode", "fifo", "--yes")
        assert strings(device.chip.eeprom) == ("Somebody", "Something", "S1")


@pytest.mark.parametrize("answer", ["n\n", ""])
def test_without_a_yes_nothing_is_written(answer: str) -> None:
    with plugged_in(build_eeprom("UART", "S1")) as [device]:
        code, _, notes = run("configure", URL, "--mode", "fifo", answer=answer)
        assert code == 1
        assert "Nothing was written" in notes
        assert device.chip.eeprom == build_eeprom("UART", "S1")


def test_a_chip_that_is_right_already_is_left_alone() -> None:
    with plugged_in(build_eeprom("FIFO", "S1")):
        assert "nothing to do" in run("configure", URL, "--mode", "fifo")[2]


def test_an_eeprom_that_keeps_nothing_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    with plugged_in(BLANK) as [device]:
        monkeypatch.setattr(device.chip, "eeprom", KeepsNothing(BLANK))
        with pytest.raises(ConnectError, match="did not keep"):
            run("configure", URL, "--mode", "fifo", "--yes")


def test_simulate_serves_a_chip_by_usbip_and_says_how_to_attach_it() -> None:
    command = [str(Path(sys.executable).parent / "unity-link"), "simulate", "--usbip", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as served:
        assert served.stdout is not None
        port = int(served.stdout.readline().split()[2])
        with socket.create_connection(("127.0.0.1", port), timeout=10) as client:
            client.sendall(bytes.fromhex("0111 8005 00000000"))
            assert client.recv(12, socket.MSG_WAITALL) == bytes.fromhex("0111 0005 00000000 00000001")
        served.terminate()


class KeepsNothing(bytearray):
    """The memory of a board that has none."""

    def __setitem__(self, place: object, value: object) -> None:
        pass
