"""A pyusb backend for simulated chips, so that an unmodified pyftdi can open them.

`installed` replaces the machine's USB by a simulated bus in a block: programs then find the chip by its usual URL.
`find` returns pyusb's device for one chip; the rest of the program still uses the real USB.
"""

from __future__ import annotations

import errno
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import usb.core
from usb.backend import IBackend

from unity_link.transport.ft232h.kinds import port_of
from unity_link.virtual.ft232h import descriptors
from unity_link.virtual.ft232h.bus import BUS_NUMBER, VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.chip import StallError
from unity_link.virtual.ft232h.host import Transfer, TransferStatus

if TYPE_CHECKING:
    from array import array
    from collections.abc import Iterator

_LIBUSB_ERROR_IO, _LIBUSB_ERROR_ACCESS, _LIBUSB_ERROR_NO_DEVICE = -1, -3, -4
_LIBUSB_ERROR_BUSY, _LIBUSB_ERROR_TIMEOUT, _LIBUSB_ERROR_OVERFLOW, _LIBUSB_ERROR_PIPE = -6, -7, -8, -9
_ERRORS = {
    _LIBUSB_ERROR_ACCESS: ("Access denied (insufficient permissions)", errno.EACCES),
    _LIBUSB_ERROR_NO_DEVICE: ("No such device (it may have been disconnected)", errno.ENODEV),
    _LIBUSB_ERROR_BUSY: ("Resource busy", errno.EBUSY),
    _LIBUSB_ERROR_OVERFLOW: ("Overflow", errno.EOVERFLOW),
    _LIBUSB_ERROR_PIPE: ("Pipe error", errno.EPIPE),
}
_DIRECTION_IN = 0x80


class OpenDevice:
    """Handle of an open device."""

    def __init__(self, device: VirtualFt232h) -> None:
        self.device = device
        self._times_plugged = device.times_plugged

    @property
    def gone(self) -> bool:
        """True if the device was unplugged after it was opened."""
        return not self.device.host.plugged or self.device.times_plugged != self._times_plugged


class Backend(IBackend):  # type: ignore[misc]  # pyusb has no types
    """The backend for one bus; methods and arguments have pyusb's names."""

    def __init__(self, bus: VirtualBus) -> None:
        super().__init__()
        self._bus = bus

    def device_at(self, address: int) -> VirtualFt232h:
        """Return the chip with an address on the bus."""
        return next(device for device in self._bus.devices if device.address == address)

    def open_for_transfers(self, bus: int, address: int, interface: int) -> tuple[Any, Any]:
        """Return the replacements for libusb's context and handle of a chip, for overlapped transfers."""
        from unity_link.virtual.ft232h.libusb1 import Context

        context = Context(self.device_at(address))
        handle = context.open_chip()
        handle.claimInterface(interface)
        return context, handle

    # Descriptors

    def enumerate_devices(self) -> Iterator[VirtualFt232h]:
        """Yield the devices on the bus."""
        yield from self._bus.devices

    def get_parent(self, dev: VirtualFt232h) -> None:
        """Return None: there is no hub."""

    def get_device_descriptor(self, dev: VirtualFt232h) -> _Device:
        """Return the device descriptor, with the place of the device on the bus."""
        return _Device(dev)

    def get_configuration_descriptor(self, dev: VirtualFt232h, config: int) -> descriptors.ConfigurationDescriptor:
        """Return a configuration descriptor; raise IndexError if it does not exist."""
        return [descriptors.configuration(dev.chip.kind)][config]

    def get_interface_descriptor(
        self, dev: VirtualFt232h, intf: int, alt: int, config: int
    ) -> descriptors.InterfaceDescriptor:
        """Return an interface descriptor; raise IndexError if it does not exist."""
        if alt:
            raise IndexError(alt)
        self.get_configuration_descriptor(dev, config)
        return descriptors.interfaces(dev.chip.kind)[intf]

    def get_endpoint_descriptor(
        self, dev: VirtualFt232h, ep: int, intf: int, alt: int, config: int
    ) -> descriptors.EndpointDescriptor:
        """Return an endpoint descriptor; raise IndexError if it does not exist."""
        self.get_interface_descriptor(dev, intf, alt, config)
        return descriptors.endpoints(intf + 1)[ep]

    # Opening and closing

    def open_device(self, dev: VirtualFt232h) -> OpenDevice:
        """Open a device, and return its handle."""
        if dev.denied:
            raise _error(_LIBUSB_ERROR_ACCESS)
        if not dev.host.plugged:
            raise _error(_LIBUSB_ERROR_NO_DEVICE)
        return OpenDevice(dev)

    def close_device(self, dev_handle: OpenDevice) -> None:
        """Close a handle, and release its interfaces."""
        for interface in list(dev_handle.device.claims):
            dev_handle.device.release(interface, dev_handle)

    def get_configuration(self, dev_handle: OpenDevice) -> int:
        """Return the number of the configuration; a host sets the only configuration when a device is plugged in."""
        return dev_handle.device.chip.configuration or 1

    def set_configuration(self, dev_handle: OpenDevice, config_value: int) -> None:
        """Set the configuration; Linux refuses this while any handle, even this one, has claimed an interface."""
        if dev_handle.device.claims:
            raise _error(_LIBUSB_ERROR_BUSY)
        self.ctrl_transfer(dev_handle, 0x00, 0x09, config_value, 0, None, 0)

    def claim_interface(self, dev_handle: OpenDevice, intf: int) -> None:
        """Claim an interface for this handle."""
        if not dev_handle.device.claim(intf, dev_handle):
            raise _error(_LIBUSB_ERROR_BUSY)

    def release_interface(self, dev_handle: OpenDevice, intf: int) -> None:
        """Release an interface."""
        if dev_handle.gone:
            raise _error(_LIBUSB_ERROR_NO_DEVICE)
        dev_handle.device.release(intf, dev_handle)

    def is_kernel_driver_active(self, dev_handle: OpenDevice, intf: int) -> bool:
        """Return False: no kernel driver uses the device."""
        return False

    def reset_device(self, dev_handle: OpenDevice) -> None:
        """Reset the device."""
        for port in dev_handle.device.chip.ports:
            self.ctrl_transfer(dev_handle, 0x40, 0, 0, port.number, None, 0)

    def clear_halt(self, dev_handle: OpenDevice, ep: int) -> None:
        """Clear the halt of an endpoint."""
        self.ctrl_transfer(dev_handle, 0x02, 0x01, 0, ep, None, 0)

    # Transfers

    def ctrl_transfer(
        self,
        dev_handle: OpenDevice,
        bmRequestType: int,
        bRequest: int,
        wValue: int,
        wIndex: int,
        data: array[int] | None,
        timeout: int,
    ) -> int:
        """Execute a control request, and return the number of transferred bytes."""
        device = dev_handle.device
        if dev_handle.gone:
            raise _error(_LIBUSB_ERROR_NO_DEVICE)
        try:
            if not bmRequestType & _DIRECTION_IN:
                device.control_out(bmRequestType, bRequest, wValue, wIndex)
                return 0 if data is None else len(data)
            answer = device.control_in(bmRequestType, bRequest, wValue, wIndex)
        except StallError:
            raise _error(_LIBUSB_ERROR_PIPE) from None
        except ConnectionError:
            raise _error(_LIBUSB_ERROR_NO_DEVICE) from None
        return _fill(data, answer)

    def bulk_read(self, dev_handle: OpenDevice, ep: int, intf: int, buff: array[int], timeout: int) -> int:
        """Read into `buff`, and return the number of received bytes; `timeout` is in ms, 0 for no limit."""
        transfer = Transfer(ep, size=len(buff))
        self._run(dev_handle, transfer, timeout)
        return _fill(buff, transfer.data)

    def bulk_write(self, dev_handle: OpenDevice, ep: int, intf: int, data: array[int], timeout: int) -> int:
        """Write bytes, and return the number of sent bytes; `timeout` is in ms, 0 for no limit."""
        transfer = Transfer(ep, data=data.tobytes())
        self._run(dev_handle, transfer, timeout)
        return transfer.sent

    def _run(self, handle: OpenDevice, transfer: Transfer, timeout: int) -> None:
        if handle.gone:
            raise _error(_LIBUSB_ERROR_NO_DEVICE)
        if handle.device.claims.get(port_of(transfer.endpoint) - 1) is not handle:
            raise _error(_LIBUSB_ERROR_BUSY)
        try:
            handle.device.run(transfer, timeout / 1000 if timeout else None)
        except ConnectionError:
            raise _error(_LIBUSB_ERROR_NO_DEVICE) from None
        status = transfer.status
        if status is TransferStatus.CANCELLED and not transfer.moved:
            raise usb.core.USBTimeoutError("Operation timed out", _LIBUSB_ERROR_TIMEOUT, errno.ETIMEDOUT)
        if status is TransferStatus.STALLED:
            raise _error(_LIBUSB_ERROR_PIPE)
        if status is TransferStatus.OVERFLOW:
            raise _error(_LIBUSB_ERROR_OVERFLOW)
        if status is TransferStatus.GONE:
            raise _error(_LIBUSB_ERROR_NO_DEVICE)


class _Device:
    """The device descriptor with further attributes that pyusb needs."""

    def __init__(self, device: VirtualFt232h) -> None:
        self._descriptor = device.chip.device_descriptor
        self.bus = BUS_NUMBER
        self.address = device.address
        self.port_number = device.address
        self.port_numbers = (device.address,)
        self.speed = descriptors.HIGH_SPEED

    def __getattr__(self, name: str) -> Any:
        return getattr(self._descriptor, name)


def _fill(buffer: array[int] | None, data: bytes | bytearray) -> int:
    if buffer is None:
        return 0
    count = min(len(buffer), len(data))
    memoryview(buffer)[:count] = data[:count]
    return count


def _error(code: int) -> usb.core.USBError:
    text, number = _ERRORS[code]
    return usb.core.USBError(text, code, number)


def find(device: VirtualFt232h) -> usb.core.Device:
    """Return pyusb's device for a chip that is not attached to a bus."""
    return usb.core.Device(device, Backend(VirtualBus(device)))


_installed: list[Backend] = []


def get_backend() -> Backend | None:
    """Return the backend of the installed bus, or None; pyftdi calls this function of the module."""
    return _installed[-1] if _installed else None


@contextmanager
def installed(bus: VirtualBus) -> Iterator[VirtualBus]:
    """Replace the machine's USB by `bus` for pyftdi in the block."""
    from pyftdi.usbtools import UsbTools

    before = UsbTools.BACKENDS
    _installed.append(Backend(bus))
    UsbTools.BACKENDS = (__name__,)
    UsbTools.flush_cache()
    try:
        yield bus
    finally:
        UsbTools.release_all_devices()
        UsbTools.flush_cache()
        UsbTools.BACKENDS = before
        _installed.pop()
