"""A simulated FT232H or FT2232H: the chip, the USB, and a gateway at the chip's pins.

- `descriptors`: USB descriptors of the chip
- `port`: a port of the chip, with two FIFOs and the rules for packets
- `chip`: the ports, the EEPROM, and the requests of the driver
- `board`: a gateway at the pins of a port; `rtl_board`: compiled gateware at the pins, cycle by cycle
- `timing`: all figures of the model, each with its source
- `host`: the host controller, which transfers packets in simulated time
- `bus`: a chip with a clock, and its faults, such as unplugging
- `pyusb_backend`, `libusb1`, `usbip`: access to the chip by pyusb, by python-libusb1, and by USB/IP for other programs
- `stand_in`: the simulated chip of ``ftdi://virtual``

The model advances only to times that its callers pass. A test can therefore simulate a minute in a second, and examine
the model between any two packets.
"""

from unity_link.virtual.ft232h.bus import VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.chip import Chip
from unity_link.virtual.ft232h.timing import Timing

__all__ = ["Chip", "Timing", "VirtualBus", "VirtualFt232h"]
