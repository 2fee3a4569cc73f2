"""Finds, checks and configures an FT232H, or a port of an FT2232H, by pyftdi, for both drivers.

pyftdi cannot select the FIFO mode: only the EEPROM sets the mode of the pins. The EEPROM is therefore checked first;
otherwise a chip that is a UART, or has a blank EEPROM, would open without an error and never transfer a byte.

pyftdi's errors are hard to understand: they have no number, and a missing permission is reported as a missing language.
`find_errno` finds the operating system's error that caused them, and `explain` describes it.
"""

from __future__ import annotations

import asyncio
import errno
import logging
import threading
from typing import TYPE_CHECKING, Any, Literal, Protocol, cast, get_args

import msgspec

from unity_link.errors import ArgumentError, ConnectError
from unity_link.quoting import one_line
from unity_link.transport import load_stand_in
from unity_link.transport.ft232h.eeprom_image import BLANK, ChannelType, channel_type, is_valid
from unity_link.transport.ft232h.kinds import (
    FT232H,
    KINDS,
    PORT_A,
    PORT_B,
    ChipKind,
    in_endpoint,
    out_endpoint,
    port_letter,
)

if TYPE_CHECKING:
    from unity_link.transport import DriverUrl

ChipMode = Literal["ft245", "ft245-sync", "uart"]
SendImmediate = Literal["off", "always", "adaptive"]
SCHEMES = ("ftdi", "ftdi-async")
OPTIONS = frozenset({"mode", "latency", "event_char", "baud"})
PACKET_SIZE = 512
STATUS_SIZE = 2
ERROR_BITS = 0x8E
"""Bits of the second status byte: overrun, parity, framing and FIFO errors (the line status of a 16550 UART)."""
LATENCIES = range(1, 256)
DEFAULT_BAUD = 115_200
CONTROL_TIMEOUT_MS = 1000
"""Time limit in milliseconds for requests to the chip; a working chip takes less than one."""
UDEV_RULE = "/etc/udev/rules.d/70-ft232h.rules"
UDEV_LINE = (
    'SUBSYSTEM=="usb", ATTR{idVendor}=="0403", ATTR{idProduct}=="6010|6014", '
    'MODE="0660", GROUP="plugdev", TAG+="uaccess"'
)
_NO_PYFTDI = "an FT232H needs pyftdi, which is not installed: pip install 'unity-link[ftdi]'"
_SUPPORTED = " or ".join(f"an {kind.name}" for kind in KINDS.values())
_opened: list[Any] = []
"""pyftdi's object of each open port of a real chip."""

WRITE_PATIENCE = 5.0
"""Seconds without progress after which a write fails, because the gateware does not read from the chip."""

log = logging.getLogger("unity_link.ft232h")


class StandIn(Protocol):
    """Interface of the module of a simulated chip."""

    OPTIONS: frozenset[str]
    """URL options in addition to those of all chips."""

    def open_ftdi(self, url: DriverUrl, mode: ChipMode) -> Any:
        """Return an open `pyftdi.ftdi.Ftdi`."""


def options_of(url: DriverUrl) -> frozenset[str]:
    """Return the names of the options that a URL of this chip may have."""
    stand_in: StandIn | None = load_stand_in(url.host)
    return OPTIONS if stand_in is None else OPTIONS | stand_in.OPTIONS


LATENCY: dict[SendImmediate, int] = {"off": 16, "always": 1, "adaptive": 1}
"""Latency timer in ms for each send-immediate mode.

In mode `off` full packets are sent, for the highest throughput. In the other modes SIWU# sends urgent bytes at once,
and the timer sends the remaining bytes soon after.
"""


class ChipSettings(msgspec.Struct, frozen=True):
    """Settings of the chip from a URL; None for a setting that the driver chooses."""

    mode: ChipMode
    latency: int | None
    event_character: int | None
    baud: int


def settings_of(url: DriverUrl) -> ChipSettings:
    """Return the settings in a URL.

    Raises:
        ArgumentError: if a value is not possible on any chip or on this port.
    """
    mode = url.options.get("mode", "ft245")
    if mode not in get_args(ChipMode):
        raise ArgumentError(f"mode={mode} in {url.text} is not one of {', '.join(get_args(ChipMode))}")
    if mode == "ft245-sync" and url.path.strip("/") == str(PORT_B):
        raise ArgumentError(f"mode=ft245-sync in {url.text} is on port A alone, which is /1, and not /2")
    latency = url.integer("latency", 0) if "latency" in url.options else None
    if latency is not None and latency not in LATENCIES:
        raise ArgumentError(f"latency={latency} in {url.text} is not from 1 to 255 (ms)")
    character = url.integer("event_char", 0) if "event_char" in url.options else None
    if character is not None and not 0 <= character <= 0xFF:
        raise ArgumentError(f"event_char={character} in {url.text} is not the number of a character, 0 to 255")
    baud = url.integer("baud", DEFAULT_BAUD)
    if "baud" in url.options and mode != "uart":
        raise ArgumentError(f"baud={baud} in {url.text} has no meaning in mode={mode}, only in mode=uart")
    if not 184 <= baud <= 12_000_000:
        raise ArgumentError(f"baud={baud} in {url.text} is not from 184 to 12000000")
    return ChipSettings(cast("ChipMode", mode), latency, character, baud)


def asked_baud(url: DriverUrl) -> int | None:
    """Return the baud rate in the URL of a chip that is a UART; None for other URLs."""
    is_uart = url.scheme in SCHEMES and url.options.get("mode") == "uart"
    return url.integer("baud", DEFAULT_BAUD) if is_uart else None


def describe_baud(baud: int) -> str:
    """Return a sentence about the actual baud rate of a chip and its deviation from a requested rate."""
    made = made_of(baud)
    difference = f", not at {baud:,} ({made / baud - 1:+.2%})" if made != baud else ""
    return f"the chip runs at {made:,} baud{difference}"


def made_of(baud: int) -> int:
    """Return the actual baud rate, rounded, of a chip of the H series for a requested one.

    The chip divides a clock of 12 MHz (below 1200 baud, of 3 MHz) by a multiple of 1/8 (FTDI's AN232B-05).
    """
    clock = 12_000_000 if baud >= 1200 else 3_000_000
    return round(8 * clock / round(8 * clock / baud))


class OpenChip:
    """An open and configured port of a chip. All methods block, and may be called from any thread.

    Transfers use pyusb's `device`, because pyftdi's own calls wait a latency tick longer for each answer, check the
    status of the first packet only, and lose the number of written bytes if a write times out.
    """

    def __init__(self, ftdi: Any, kind: ChipKind, settings: ChipSettings, url: DriverUrl) -> None:
        self.ftdi = ftdi
        self.device = ftdi.usb_dev
        self.kind = kind
        self.port: int = ftdi.port_index
        self.interface = self.port - 1
        self.in_endpoint, self.out_endpoint = in_endpoint(self.port), out_endpoint(self.port)
        self.settings = settings
        self.url = url
        self.latency = 0
        """Latency timer in ms."""

    def check_channel(self) -> None:
        """Check that the EEPROM sets the pins to the mode in the URL.

        Raises:
            ConnectError: if the pins have another mode.
        """
        wanted: ChannelType = "UART" if self.settings.mode == "uart" else "FIFO"
        image = self.ftdi.read_eeprom()
        if channel_type(image, self.kind, self.port) != wanted:
            raise ConnectError(
                f"{self.describe_channel(image)}, but mode={self.settings.mode} needs {wanted}: "
                f"run `unity-link ft232h configure {base_url(self.url)} --mode {wanted.lower()}`, "
                f"then unplug the {self.kind.name} and plug it in again"
            )

    def describe_channel(self, image: bytes) -> str:
        """Return a sentence about the mode that an EEPROM's contents set for the port's pins."""
        name = self.kind.name
        name = f"the {name}" if self.kind.ports == 1 else f"port {port_letter(self.port)} of the {name}"
        if image == BLANK[: len(image)]:
            return f"the EEPROM is blank or missing, which makes {name} a UART"
        if not is_valid(image):
            return f"the EEPROM has a wrong checksum, which makes {name} a UART"
        return f"the EEPROM makes {name} a {channel_type(image, self.kind, self.port)}"

    def configure(self) -> None:
        """Set baud rate, bit mode, flow control, event character and latency timer, and empty the buffers."""
        from pyftdi.ftdi import Ftdi

        ftdi = self.ftdi
        if self.settings.mode == "uart":
            ftdi.set_baudrate(self.settings.baud)
            ftdi.set_line_property(8, 1, "N")
            ftdi.set_flowctrl("")
        elif self.settings.mode == "ft245-sync":
            ftdi.set_bitmode(0xFF, Ftdi.BitMode.SYNCFF)
            # With this flow control the chip stops transfers by itself when its FIFOs are full.
            ftdi.set_flowctrl("hw")
        character = self.settings.event_character
        ftdi.set_event_char(character or 0, character is not None)
        self.tune("adaptive")
        ftdi.purge_buffers()

    def tune(self, mode: SendImmediate) -> None:
        """Set the latency timer for a send-immediate mode, unless the URL sets the timer."""
        self.latency = LATENCY[mode] if self.settings.latency is None else self.settings.latency
        self.ftdi.set_latency_timer(self.latency)

    def close(self, *, gone: bool = False) -> None:
        """Close the port; if the chip is `gone`, send no requests to it."""
        _close(self.ftdi, gone=gone)


def _close(ftdi: Any, *, gone: bool) -> None:
    from pyftdi.usbtools import UsbTools
    from usb.util import dispose_resources

    device = ftdi.usb_dev
    with UsbTools.Lock:
        try:
            ftdi.close(freeze=gone)
        except OSError:
            # The kernel cannot take back the interface of an unplugged chip; pyftdi then stops before the release.
            UsbTools.release_device(device)
        if ftdi in _opened:
            _opened.remove(ftdi)
        # pyftdi disposes only of devices that it found itself. Keep the device while the other port is open.
        if not any(device is other for other, _ in UsbTools.Devices.values()):
            dispose_resources(device)


def base_url(url: DriverUrl) -> str:
    """Return the URL of the chip without options, in pyftdi's form."""
    return f"ftdi://{url.host}{url.path or '/1'}"


def open_chip(url: DriverUrl, *, check: bool = True) -> OpenChip:
    """Find a chip, open it exclusively, check and configure it. Blocks for about 50 ms.

    Args:
        url: URL of the chip.
        check: False to only open the chip, for access to its EEPROM.

    Raises:
        ArgumentError: if the URL is not that of a chip.
        ConnectError: if the chip is not found or cannot be used; the message has the reason.
    """
    settings = settings_of(url)
    try:
        from pyftdi.ftdi import FtdiError
        from pyftdi.usbtools import UsbToolsError
        from usb.core import USBError
        from usb.util import claim_interface
    except ImportError as error:
        raise ConnectError(
            f"{url.scheme}: needs pyftdi, which is not installed: pip install 'unity-link[ftdi]'"
        ) from error
    ftdi: Any = None
    try:
        stand_in: StandIn | None = load_stand_in(url.host)
        ftdi = _open_real(url) if stand_in is None else stand_in.open_ftdi(url, settings.mode)
        chip = OpenChip(ftdi, _kind_of(ftdi, url), settings, url)
        claim_interface(chip.device, chip.interface)
        if check:
            chip.check_channel()
            chip.configure()
    except (FtdiError, UsbToolsError, USBError, OSError, ValueError) as error:
        if ftdi is not None:
            _close(ftdi, gone=True)
        raise ConnectError(explain_opening(error)) from error
    except ConnectError:
        if ftdi is not None:
            _close(ftdi, gone=False)
        raise
    return chip


def _kind_of(ftdi: Any, url: DriverUrl) -> ChipKind:
    kind = KINDS.get(ftdi.device_version)
    if kind is None:
        name = ftdi.ic_name.upper()
        raise ConnectError(f"{base_url(url)} is an {name}, which has no high-speed FIFO: {_SUPPORTED} was expected")
    return kind


def list_chips() -> list[tuple[str, str]]:
    """Return URL and description of each port of the connected chips. Blocks.

    Raises:
        ConnectError: if the chips cannot be read.
    """
    try:
        from pyftdi.ftdi import Ftdi
        from pyftdi.usbtools import UsbTools, UsbToolsError
    except ImportError as error:
        raise ConnectError(_NO_PYFTDI) from error
    UsbTools.flush_cache()
    try:
        devices = Ftdi.list_devices()
    except (UsbToolsError, OSError, ValueError) as error:
        raise ConnectError(explain_opening(error)) from error
    names = {Ftdi.FTDI_VENDOR: {kind.url_name: kind.product_id for kind in KINDS.values()}}
    places = {(device.bus, device.address) for device in _find_devices()}
    chips = [device for device in devices if (device[0].bus, device[0].address) in places]
    found: list[tuple[str, str]] = UsbTools.build_dev_strings("ftdi", Ftdi.VENDOR_IDS, names, chips)
    return [(one_line(url), one_line(description)) for url, description in found]


def _find_devices() -> list[Any]:
    """Return pyusb's devices of the connected chips, without sending requests to them."""
    from pyftdi.ftdi import Ftdi
    from pyftdi.usbtools import UsbTools
    from usb.core import find

    found = find(True, UsbTools.find_backend(), idVendor=Ftdi.FTDI_VENDOR)  # noqa: FBT003
    products = {kind.release: kind.product_id for kind in KINDS.values()}
    return [device for device in found if products.get(device.bcdDevice) == device.idProduct]


async def open_in_thread(url: DriverUrl) -> OpenChip:
    """Open a chip in a thread, as `open_chip` does.

    If the call is cancelled, the chip is closed once it is open.
    """
    opening = asyncio.get_running_loop().run_in_executor(None, open_chip, url)
    try:
        return await asyncio.shield(opening)
    except asyncio.CancelledError:
        opening.add_done_callback(_close_unwanted)
        raise


def _close_unwanted(opening: asyncio.Future[OpenChip]) -> None:
    if not opening.cancelled() and opening.exception() is None:
        threading.Thread(target=opening.result().close, name="ft232h close").start()


def _open_real(url: DriverUrl) -> Any:
    from pyftdi.ftdi import Ftdi
    from pyftdi.usbtools import UsbTools

    if not url.path.strip("/").isdecimal():
        raise ArgumentError(
            f"{url.text} names no port of a chip: ftdi://ftdi:232h/1, ftdi://ftdi:2232h/2 or ftdi://ftdi:232h:SERIAL/1"
        )
    # pyftdi's list of devices is outdated after chips are plugged in or unplugged.
    UsbTools.flush_cache()
    ftdi = Ftdi()
    ftdi.timeouts = (CONTROL_TIMEOUT_MS, CONTROL_TIMEOUT_MS)
    description, interface = Ftdi.get_identifiers(base_url(url))
    with UsbTools.Lock:
        device = _get_free_device(description, interface or PORT_A)
        try:
            ftdi.open_from_device(device, interface)
        except BaseException:
            UsbTools.release_device(device)
            raise
        _opened.append(ftdi)
    return ftdi


def _get_free_device(description: Any, port: int) -> Any:
    """Return pyusb's device of a chip, if this program has not opened the port yet.

    pyftdi would allow opening the same port twice in one program, and mix up the bytes.

    Raises:
        OSError: EBUSY if this program has the port open.
    """
    from pyftdi.usbtools import UsbTools

    held, _ = UsbTools.Devices.get((description.bus, description.address, description.vid, description.pid), (None, 0))
    if held is not None and (
        description.pid == FT232H.product_id
        or any(ftdi.usb_dev is held and ftdi.port_index == port for ftdi in _opened)
    ):
        raise OSError(errno.EBUSY, "open in this program")
    return UsbTools.get_device(description)


# Errors


def find_errno(error: BaseException | None) -> int | None:
    """Return the number of the operating system's error that caused an error of pyftdi or pyusb."""
    while error is not None:
        if isinstance(error, OSError) and error.errno is not None:
            return error.errno
        error = error.__cause__ or error.__context__
    return None


def _find_reason() -> int | None:
    """Return the errno for which strings of a chip cannot be read, by sending a simpler request to all chips."""
    from usb.core import USBError

    for device in _find_devices():
        try:
            device.get_active_configuration()
        except USBError as error:
            return find_errno(error)
    return None


_CAUSES: dict[int, str] = {
    errno.ENODEV: "the FTDI chip is gone: it was unplugged, or lost its power",
    errno.ETIMEDOUT: "the FTDI chip does not answer (timed out)",
    errno.EACCES: f"no permission for the FTDI chip: write the udev rule {UDEV_RULE} as docs/how-to/ft232h.md gives "
    "it, then unplug it and plug it in again",
    errno.EBUSY: "the FTDI chip is in use by another program: close that, or share the link",
    errno.EPIPE: "the FTDI chip refuses (an endpoint is stalled): unplug it and plug it in again",
    errno.EIO: "the transfer to the FTDI chip failed: look at the cable and the hub",
}
_NO_LANGUAGE = "langid"


def stuck() -> OSError:
    """Return the error of a write without progress."""
    return OSError(errno.ETIME, f"the gateware has not read from the FTDI chip for {WRITE_PATIENCE:g} s")


def explain(error: BaseException) -> str:
    """Return a sentence about the cause of an error of an open chip."""
    if isinstance(error, OSError) and error.errno == errno.ETIME:
        return str(error.strerror)
    number = find_errno(error)
    return _CAUSES.get(number or 0, f"the FTDI chip failed ({error})")


def explain_opening(error: BaseException) -> str:
    """Return a sentence about the reason why a chip cannot be opened."""
    text = str(error)
    number = find_errno(error)
    if number is None and _NO_LANGUAGE in text:
        # pyusb reports this for any failure to read the strings of a device.
        number = _find_reason()
    if number is None and "No backend" in text:
        return "libusb is not installed (Debian, Ubuntu: apt install libusb-1.0-0)"
    if number in _CAUSES:
        return _CAUSES[number]
    if "No USB device" in text or "not found" in text or "No such device" in text:
        return f"there is no such FTDI chip ({text}): is it plugged in? `unity-link ft232h info` lists those that are"
    return f"the FTDI chip can't be opened ({text})"
