"""Reads and changes the EEPROM of a chip, which sets the mode of each port's pins when the chip is plugged in.

In a valid EEPROM pyftdi changes only this mode. A blank or invalid EEPROM gets new contents.
"""

from __future__ import annotations

import secrets
from typing import TYPE_CHECKING

import msgspec

from unity_link.errors import ConnectError
from unity_link.transport.ft232h.chip import explain_opening
from unity_link.transport.ft232h.eeprom_image import ChannelType, build_eeprom, channel_type, is_valid, strings
from unity_link.transport.ft232h.kinds import port_letter

if TYPE_CHECKING:
    from unity_link.transport.ft232h.chip import OpenChip


class EepromInfo(msgspec.Struct, frozen=True):
    """Settings of a port in an EEPROM."""

    chip: str
    """Name of the chip, FT232H or FT2232H."""
    port: int
    channel_type: ChannelType
    is_valid: bool
    manufacturer: str
    product: str
    serial: str
    description: str
    """A sentence about the mode of the pins."""


def read_info(chip: OpenChip) -> EepromInfo:
    """Read the EEPROM. Blocks.

    Raises:
        ConnectError: if the chip does not answer.
    """
    image = _read(chip)
    kind, port = chip.kind, chip.port
    texts = strings(image, kind)
    return EepromInfo(
        kind.name, port, channel_type(image, kind, port), is_valid(image), *texts, chip.describe_channel(image)
    )


def write_channel_type(chip: OpenChip, wanted: ChannelType) -> None:
    """Write the mode of the port's pins from the next plug-in on, and read it back. Blocks.

    Raises:
        ConnectError: if the chip does not answer, or the EEPROM did not store the mode.
    """
    from pyftdi.eeprom import FtdiEeprom
    from pyftdi.ftdi import FtdiError

    try:
        if is_valid(_read(chip)):
            memory = FtdiEeprom()
            memory.connect(chip.ftdi)
            memory.set_property(f"channel_{port_letter(chip.port).lower()}_type", wanted)
            memory.commit(dry_run=False)
        else:
            serial = f"UL{secrets.token_hex(3).upper()}"
            image = build_eeprom(wanted, serial, "FTDI", chip.kind.name, kind=chip.kind, ports=[chip.port])
            chip.ftdi.overwrite_eeprom(image, dry_run=False)
    except (FtdiError, OSError) as error:
        raise ConnectError(f"the EEPROM could not be written: {explain_opening(error)}") from error
    if channel_type(_read(chip), chip.kind, chip.port) != wanted:
        raise ConnectError(
            "the EEPROM did not keep the new mode: the board has none, or one of 128 bytes, which FTDI's FT_PROG can "
            "write"
        )


def _read(chip: OpenChip) -> bytes:
    from pyftdi.ftdi import FtdiError

    try:
        return bytes(chip.ftdi.read_eeprom())
    except (FtdiError, OSError) as error:
        raise ConnectError(explain_opening(error)) from error
