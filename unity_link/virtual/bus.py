"""The bus behind the virtual gateway: plain memory everywhere, and devices at the addresses that they are attached to.

A device is the one way to put behaviour behind an address: a robot, a queue, an address that fails. It sees offsets in
the addresses it was attached to, and the time of each access, so that a simulation can move on by exactly that much.
"""

from __future__ import annotations

import logging
import operator
from typing import TYPE_CHECKING, Protocol

from unity_link.errors import ANY_ERROR, ArgumentError
from unity_link.protocol.wire.messages import ErrorCode

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from unity_link.protocol.wire.configuration import GatewayInfo

_LOG = logging.getLogger("unity_link.virtual")


class AccessError(Exception):
    """An access that the bus ends with an error; `code` is `ErrorCode.BUS_ERROR` or `ErrorCode.BUS_TIMEOUT`."""

    def __init__(self, code: ErrorCode) -> None:
        super().__init__(code.name)
        self.code = code


class Device(Protocol):
    """Interface of devices behind addresses of a gateway.

    `offset` counts the addresses that the device was attached to, `now` is the time of the access in seconds; it never
    goes back. Raise `AccessError` to end an access with an error.
    """

    def read(self, offset: int, now: float) -> int:
        """Return the word; a negative number is put on the bus in two's complement."""

    def write(self, offset: int, value: int, now: float) -> None:
        """Take a word, an unsigned number."""


class PlainMemory(dict[int, int]):
    """Words by address; what was never written is 0."""

    def __init__(self, info: GatewayInfo) -> None:
        super().__init__()
        self._address_bits = info.address_bits
        self._data_bits = info.data_bits

    def __missing__(self, address: int) -> int:
        return 0

    def __setitem__(self, address: int, value: int) -> None:
        if not 0 <= address < 1 << self._address_bits:
            raise ArgumentError(f"address {address:#x} does not fit in {self._address_bits} bits")
        if not 0 <= value < 1 << self._data_bits:
            raise ArgumentError(f"word {value:#x} does not fit in {self._data_bits} bits")
        super().__setitem__(address, value)


class Devices(dict[int, tuple[Device, int]]):
    """Devices and offsets by address.

    A device that raises anything but `AccessError`, or reads as what is no whole number, has a bug: the access ends
    with a bus error, and the log has the traceback, once for each type of exception.
    """

    def __init__(self, address_bits: int) -> None:
        super().__init__()
        self._address_bits = address_bits
        self._told: set[tuple[int, type[BaseException]]] = set()

    def attach(self, device: Device, addresses: Iterable[int]) -> list[int]:
        """Put a device behind addresses, and return these; the first is its offset 0.

        Raises:
            ArgumentError: for an address that does not fit or has a device, or an object that is no device.
        """
        _check(device)
        places = list(addresses)
        for address in places:
            if not 0 <= address < 1 << self._address_bits:
                raise ArgumentError(f"address {address:#x} does not fit in {self._address_bits} bits")
            if dict.__contains__(self, address):
                raise ArgumentError(f"address {address:#x} has a device, {self[address][0]!r}: detach that first")
        self.update((address, (device, offset)) for offset, address in enumerate(places))
        return places

    def read(self, address: int, now: float) -> int:
        """Read a word of a device, which may be negative.

        Raises:
            AccessError: where the device refuses, or has a bug.
        """
        device, offset = self[address]
        try:
            return operator.index(device.read(offset, now))
        except AccessError:
            raise
        except ANY_ERROR as error:
            raise self._bug(device, f"read at {address:#x}", error) from None

    def write(self, address: int, value: int, now: float) -> None:
        """Write a word to a device.

        Raises:
            AccessError: where the device refuses, or has a bug.
        """
        device, offset = self[address]
        try:
            device.write(offset, value, now)
        except AccessError:
            raise
        except ANY_ERROR as error:
            raise self._bug(device, f"write at {address:#x}", error) from None

    def _bug(self, device: Device, what: str, error: BaseException) -> AccessError:
        kind = id(device), type(error)
        if kind not in self._told:
            self._told.add(kind)
            _LOG.error("%r failed in a %s, which is a bus error (told once)", device, what, exc_info=error)
        return AccessError(ErrorCode.BUS_ERROR)


class DevicesEverywhere(Devices):
    """Devices by address, and one behind all other addresses, which are its offsets.

    Args:
        devices: those of addresses of their own.
        elsewhere: the one behind all others.
        address_bits: width of addresses.

    Raises:
        ArgumentError: for an object that is no device.
    """

    def __init__(self, devices: Devices, elsewhere: Device, address_bits: int) -> None:
        super().__init__(address_bits)
        _check(elsewhere)
        self.update(devices)
        self._elsewhere = elsewhere

    def __contains__(self, address: object) -> bool:
        return True

    def __bool__(self) -> bool:
        return True

    def __missing__(self, address: int) -> tuple[Device, int]:
        return self._elsewhere, address


def _check(device: Device) -> None:
    for method in ("read", "write"):
        if not callable(getattr(device, method, None)):
            raise ArgumentError(f"{device!r} has no method {method!r}: a device with read and write was expected")


class ModelBus:
    """Memory and devices of one gateway. Addresses and words given to its methods are in range."""

    def __init__(self, info: GatewayInfo) -> None:
        self.memory = PlainMemory(info)
        self.devices = Devices(info.address_bits)
        """Every other address is memory."""
        self._address_bits = info.address_bits
        self._word_mask = (1 << info.data_bits) - 1
        self._address_mask = (1 << info.address_bits) - 1

    def attach(self, device: Device, addresses: Iterable[int]) -> None:
        """Put a device behind addresses, as `Devices.attach`."""
        self.devices.attach(device, addresses)

    def attach_elsewhere(self, device: Device) -> None:
        """Put a device behind every address that has none, in place of memory; its offsets are the addresses."""
        self.devices = DevicesEverywhere(self.devices, device, self._address_bits)

    def detach(self, addresses: Iterable[int]) -> None:
        """Make addresses plain memory again."""
        for address in addresses:
            self.devices.pop(address, None)

    def read(self, address: int, now: float) -> int:
        """Read one word.

        Raises:
            AccessError: where the device behind the address refuses.
        """
        if address not in self.devices:
            return self.memory[address]
        return self.devices.read(address, now) & self._word_mask

    def write(self, address: int, value: int, now: float) -> None:
        """Write one word.

        Raises:
            AccessError: where the device behind the address refuses.
        """
        if address not in self.devices:
            dict.__setitem__(self.memory, address, value)
        else:
            self.devices.write(address, value, now)

    def block(self, address: int, count: int) -> Sequence[int]:
        """Return the addresses of a block, which wraps at the end of the address space."""
        if address + count - 1 <= self._address_mask:
            return range(address, address + count)
        return [index & self._address_mask for index in range(address, address + count)]

    def read_words(self, addresses: Sequence[int], now: float) -> list[int]:
        """Read words one after the other; stops with `AccessError` at the first that fails."""
        if self.devices:
            return [self.read(address, now) for address in addresses]
        memory = self.memory
        return [memory[address] for address in addresses]

    def write_words(self, addresses: Sequence[int], values: Sequence[int], now: float) -> None:
        """Write words one after the other; stops with `AccessError` at the first that fails."""
        if self.devices:
            for address, value in zip(addresses, values, strict=True):
                self.write(address, value, now)
        else:
            self.memory.update(zip(addresses, values, strict=True))
