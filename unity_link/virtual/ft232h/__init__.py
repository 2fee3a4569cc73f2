"""The virtual FT232H or FT2232H: the chip, the USB that it hangs on, and the gateway behind it, as a model.

- `eeprom`: what the chip's memory says; `descriptors`: what it tells the USB of itself
- `port`: two FIFOs and the rules for packets; `chip`: one or two of them, and requests; they know no time but what they
  are told
- `board`: a gateway behind the pins of a port; `rtl_board`: the gateware itself, cycle for cycle
- `timing`: all numbers of the model, each with its source
- `host`: the host controller: moves packets between transfers and chip in modelled time
- `bus`: virtual devices on a clock, with what can be done to them; `pyusb_backend` and `libusb1` are two ways to them,
  `usbip` is the third, for other programs and real USB stacks

The model moves on only when it is told the time, so a test can have a minute in a second, and stop it between any two
packets.
"""

from unity_link.virtual.ft232h.bus import VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.chip import Chip
from unity_link.virtual.ft232h.timing import Timing

__all__ = ["Chip", "Timing", "VirtualBus", "VirtualFt232h"]
