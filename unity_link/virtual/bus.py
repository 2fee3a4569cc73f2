"""The bus of the virtual gateway: plain memory, and devices at the addresses to which they are attached.

A device gives addresses a behaviour, such as that of a robot, of a queue, or of addresses whose accesses fail. It gets
the offset in its addresses and the time of each access, so that a simulation can advance to exactly that time.
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
    """A failed bus access; `code` is `ErrorCode.BUS_ERROR` or `ErrorCode.BUS_TIMEOUT`."""

    def __init__(self, code: ErrorCode) -> None:
        super().__init__(code.name)
        self.code = code


class Device(Protocol):
    """Interface of devices on the bus of a gateway.

    `offset` is the index of the address among those that the device is attached to. `now` is the time of the access in
    seconds; it never goes back. A device raises `AccessError` if an access fails.
    """

    def read(self, offset: int, now: float) -> int:
        """Return the word; the bus converts a negative number to two's complement."""

    def write(self, offset: int, value: int, now: float) -> None:
        """Write a word, an unsigned number."""


class PlainMemory(dict[int, int]):
    """Words by address; words that were never written are 0."""

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

    If a device raises an exception other than `AccessError`, or returns a word that is not an integer, the access ends
    with a bus error. The traceback is logged once for each device and type of exception.
    """

    def __init__(self, address_bits: int) -> None:
        super().__init__()
        self._address_bits = address_bits
        self._told: set[tuple[int, type[BaseException]]] = set()

    def attach(self, device: Device, addresses: Iterable[int]) -> list[int]:
        """Attach a device to addresses, whose first one has offset 0, and return the addresses as a list.

        Raises:
            ArgumentError: if an address does not fit or has a device, or the object is not a device.
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
        """Return a word of a device, which may be negative.

        Raises:
            AccessError: if the device refuses the access, or fails.
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
            AccessError: if the device refuses the access, or fails.
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
    """Devices by address, and a default device for all other addresses; its offsets are the addresses.

    Args:
        devices: devices that are attached to certain addresses.
        elsewhere: the default device.
        address_bits: width of addresses.

    Raises:
        ArgumentError: if the object is not a device.
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
    """Memory and devices of one gateway. Callers must check that addresses and words are in range."""

    def __init__(self, info: GatewayInfo) -> None:
        self.memory = PlainMemory(info)
        self.devices = Devices(info.address_bits)
        """Devices by address; all other addresses are memory."""
        self._address_bits = info.address_bits
        self._word_mask = (1 << info.data_bits) - 1
        self._address_mask = (1 << info.address_bits) - 1

    def attach(self, device: Device, addresses: Iterable[int]) -> None:
        """Attach a device to addresses, as `Devices.attach` does."""
        self.devices.attach(device, addresses)

    def attach_elsewhere(self, device: Device) -> None:
        """Attach a device to all addresses without one, in place of memory; its offsets are the addresses."""
        self.devices = DevicesEverywhere(self.devices, device, self._address_bits)

    def detach(self, addresses: Iterable[int]) -> None:
        """Make addresses plain memory again."""
        for address in addresses:
            self.devices.pop(address, None)

    def read(self, address: int, now: float) -> int:
        """Return the word at an address.

        Raises:
            AccessError: if the device at the address refuses the access.
        """
        if address not in self.devices:
            return self.memory[address]
        return self.devices.read(address, now) & self._word_mask

    def write(self, address: int, value: int, now: float) -> None:
        """Write a word to an address.

        Raises:
            AccessError: if the device at the address refuses the access.
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
        """Return the words at addresses, read in order; raise `AccessError` at the first access that fails."""
        if self.devices:
            return [self.read(address, now) for address in addresses]
        memory = self.memory
        return [memory[address] for address in addresses]

    def write_words(self, addresses: Sequence[int], values: Sequence[int], now: float) -> None:
        """Write words to addresses in order; raise `AccessError` at the first access that fails."""
        if self.devices:
            for address, value in zip(addresses, values, strict=True):
                self.write(address, value, now)
        else:
            self.memory.update(zip(addresses, values, strict=True))
