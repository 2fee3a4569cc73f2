"""The USB descriptors of the chip (USB 2.0, section 9.6): one configuration.

Each port is an interface with two bulk endpoints. The attributes have the names of the standard, as pyusb expects.
"""
# ruff: noqa: N815

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, ClassVar

import msgspec

from unity_link.transport.ft232h.kinds import in_endpoint, out_endpoint

if TYPE_CHECKING:
    from unity_link.transport.ft232h.kinds import ChipKind

VENDOR = 0x0403
PACKET_SIZE = 512
HIGH_SPEED = 3
DEVICE, CONFIGURATION, STRING, INTERFACE, ENDPOINT, QUALIFIER = 1, 2, 3, 4, 5, 6
ENGLISH = 0x0409


class Descriptor(msgspec.Struct, frozen=True, kw_only=True):
    """A descriptor with its fields in the order of transmission."""

    LAYOUT: ClassVar[str]
    extra_descriptors: ClassVar[list[int]] = []

    def encode(self) -> bytes:
        """Return the bytes of the descriptor."""
        return struct.pack(self.LAYOUT, *(getattr(self, name) for name in self.__struct_fields__))


class DeviceDescriptor(Descriptor, frozen=True, kw_only=True):
    """Descriptor of the device."""

    LAYOUT: ClassVar[str] = "<BBHBBBBHHHBBBB"
    bLength: int = 18
    bDescriptorType: int = DEVICE
    bcdUSB: int = 0x0200
    bDeviceClass: int = 0
    bDeviceSubClass: int = 0
    bDeviceProtocol: int = 0
    bMaxPacketSize0: int = 64
    idVendor: int = VENDOR
    idProduct: int
    bcdDevice: int
    iManufacturer: int = 1
    iProduct: int = 2
    iSerialNumber: int = 3
    bNumConfigurations: int = 1


class ConfigurationDescriptor(Descriptor, frozen=True, kw_only=True):
    """Descriptor of the device's only configuration."""

    LAYOUT: ClassVar[str] = "<BBHBBBBB"
    bLength: int = 9
    bDescriptorType: int = CONFIGURATION
    wTotalLength: int
    bNumInterfaces: int
    bConfigurationValue: int = 1
    iConfiguration: int = 0
    bmAttributes: int = 0x80
    bMaxPower: int = 45


class InterfaceDescriptor(Descriptor, frozen=True, kw_only=True):
    """Descriptor of the interface of a port."""

    LAYOUT: ClassVar[str] = "<BBBBBBBBB"
    bLength: int = 9
    bDescriptorType: int = INTERFACE
    bInterfaceNumber: int
    bAlternateSetting: int = 0
    bNumEndpoints: int = 2
    bInterfaceClass: int = 0xFF
    bInterfaceSubClass: int = 0xFF
    bInterfaceProtocol: int = 0xFF
    iInterface: int = 2


class EndpointDescriptor(Descriptor, frozen=True, kw_only=True):
    """Descriptor of a bulk endpoint."""

    LAYOUT: ClassVar[str] = "<BBBBHB"
    bRefresh: ClassVar[int] = 0
    bSynchAddress: ClassVar[int] = 0
    bLength: int = 7
    bDescriptorType: int = ENDPOINT
    bEndpointAddress: int
    bmAttributes: int = 2
    wMaxPacketSize: int = PACKET_SIZE
    bInterval: int = 0


def interfaces(kind: ChipKind) -> list[InterfaceDescriptor]:
    """Return the interfaces, in the order of the ports."""
    return [InterfaceDescriptor(bInterfaceNumber=number) for number in range(kind.ports)]


def endpoints(port: int) -> tuple[EndpointDescriptor, EndpointDescriptor]:
    """Return the endpoints of a port."""
    return (
        EndpointDescriptor(bEndpointAddress=in_endpoint(port)),
        EndpointDescriptor(bEndpointAddress=out_endpoint(port)),
    )


def configuration(kind: ChipKind) -> ConfigurationDescriptor:
    """Return the configuration descriptor."""
    return ConfigurationDescriptor(wTotalLength=9 + len(_encode_interfaces(kind)), bNumInterfaces=kind.ports)


def encode_configuration(kind: ChipKind) -> bytes:
    """Return the configuration descriptor, followed by those of interfaces and endpoints."""
    return configuration(kind).encode() + _encode_interfaces(kind)


def _encode_interfaces(kind: ChipKind) -> bytes:
    return b"".join(
        descriptor.encode()
        for interface in interfaces(kind)
        for descriptor in (interface, *endpoints(interface.bInterfaceNumber + 1))
    )


def encode_qualifier() -> bytes:
    """Return the device qualifier descriptor: the device's properties at full speed."""
    return struct.pack("<BBHBBBBBB", 10, QUALIFIER, 0x0200, 0, 0, 0, 64, 1, 0)


def encode_string(text: str) -> bytes:
    """Return a string descriptor."""
    encoded = text.encode("utf-16-le")
    return bytes([len(encoded) + 2, STRING]) + encoded


def encode_languages() -> bytes:
    """Return string descriptor 0, the languages of the strings."""
    return struct.pack("<BBH", 4, STRING, ENGLISH)
