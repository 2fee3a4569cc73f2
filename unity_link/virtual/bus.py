"""The bus behind the virtual gateway: plain memory everywhere, and devices at the addresses that they are attached to.

A device is the one way to put behaviour behind an address: a robot, a queue, an address that fails. It sees offsets in
the addresses it was attached to, and the time of each access, so that a simulation can move on by exactly that much.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from unity_link.protocol.configuration import GatewayInfo
    from unity_link.protocol.messages import ErrorCode


class AccessError(Exception):
    """An access that the bus ends with an error; `code` is `ErrorCode.BUS_ERROR` or `ErrorCode.BUS_TIMEOUT`."""

    def __init__(self, code: ErrorCode) -> None:
        super().__init__(code.name)
        self.code = code


class Device(Protocol):
    """What can stand behind addresses of a gateway.

    `offset` counts the addresses that the device was attached to, `now` is the time of the access in seconds; it never
    goes back. Raise `AccessError` to end an access with an error.
    """

    def read(self, offset: int, now: float) -> int:
        """Give the word; a negative number is put on the bus in two's complement."""

    def write(self, offset: int, value: int, now: float) -> None:
        """Take a word, an unsigned number."""


class Memory(dict[int, int]):
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


class Bus:
    """Memory and devices of one gateway. Addresses and words given to its methods are in range."""

    def __init__(self, info: GatewayInfo) -> None:
        self.memory = Memory(info)
        self.devices: dict[int, tuple[Device, int]] = {}
        """Device and offset by address; every other address is memory."""
        self._word_mask = (1 << info.data_bits) - 1
        self._address_mask = (1 << info.address_bits) - 1

    def attach(self, device: Device, addresses: Iterable[int]) -> None:
        """Put a device behind addresses, in place of what was there; the first is its offset 0.

        Raises:
            ArgumentError: for an address that does not fit.
        """
        places = list(addresses)
        for address in places:
            if not 0 <= address <= self._address_mask:
                raise ArgumentError(f"address {address:#x} does not fit in {self._address_mask.bit_length()} bits")
        self.devices.update((address, (device, offset)) for offset, address in enumerate(places))

    def detach(self, addresses: Iterable[int]) -> None:
        """Make addresses plain memory again."""
        for address in addresses:
            self.devices.pop(address, None)

    def read(self, address: int, now: float) -> int:
        """Read one word.

        Raises:
            AccessError: where the device behind the address refuses.
        """
        place = self.devices.get(address)
        if place is None:
            return self.memory[address]
        device, offset = place
        return device.read(offset, now) & self._word_mask

    def write(self, address: int, value: int, now: float) -> None:
        """Write one word.

        Raises:
            AccessError: where the device behind the address refuses.
        """
        place = self.devices.get(address)
        if place is None:
            dict.__setitem__(self.memory, address, value)
        else:
            device, offset = place
            device.write(offset, value, now)

    def block(self, address: int, count: int) -> Sequence[int]:
        """Give the addresses of a block, which wraps at the end of the address space."""
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
