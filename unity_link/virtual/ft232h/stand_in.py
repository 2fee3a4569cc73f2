"""``ftdi://virtual`` and ``ftdi-async://virtual``: a simulated FT232H with a virtual gateway at its pins.

The path is the robot, as in ``ftdi://virtual/scara`` or ``ftdi://virtual/robot.ul``; an absolute path has one more
slash. The options are those of ``sim:``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.transport.ft232h.eeprom_image import build_eeprom
from unity_link.virtual.build import CHANCES, CONFIGURATION, ROBOT_OPTIONS, Wanted, build_gateway

if TYPE_CHECKING:
    from unity_link.transport import DriverUrl
    from unity_link.transport.ft232h.chip import ChipMode

OPTIONS = frozenset({*CONFIGURATION, *CHANCES, *ROBOT_OPTIONS, "seed"})


def open_ftdi(url: DriverUrl, mode: ChipMode) -> Any:
    """Return an open `pyftdi.ftdi.Ftdi` of a new simulated chip.

    Raises:
        ArgumentError: if the robot or an option does not exist, or no gateway can have one of the values.
    """
    from pyftdi.ftdi import Ftdi

    from unity_link.virtual.ft232h.board import GatewayBoard
    from unity_link.virtual.ft232h.bus import DEFAULT_SERIAL, VirtualFt232h
    from unity_link.virtual.ft232h.port import Mode
    from unity_link.virtual.ft232h.pyusb_backend import find

    wanted = Wanted.of_url(url, url.path.removeprefix("/").rstrip("/"))
    if mode == "uart":
        wanted.configuration.setdefault("features", GatewayInfo().features & ~Feature.FLOW_CONTROL)
    gateway = build_gateway(
        wanted,
        chances={name: url.number(name) for name in CHANCES if name in url.options},
        seed=url.integer("seed", 0),
    )
    image = build_eeprom("UART" if mode == "uart" else "FIFO", DEFAULT_SERIAL)
    ftdi = Ftdi()
    ftdi.open_from_device(find(VirtualFt232h(GatewayBoard(gateway, Mode(mode)), image=image)))
    return ftdi
