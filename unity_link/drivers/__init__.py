"""Layer 0, device drivers: one file a medium, one URL scheme each, imported only when its scheme is asked for.

A driver module has a coroutine ``connect(url, protocol)`` that opens the medium and gives an `asyncio` transport that
feeds `protocol`, and ``OPTIONS``, the names of the URL options that it takes. It may have a coroutine ``prepare(url)``
for what takes its time once on a machine and says nothing about the gateway: no time-out counts it.

The transport's ``get_extra_info("shortest_timeout")`` are the seconds that the medium may hold an answer back, and some
more; where it says nothing, a socket is quick, and everything else as slow as a USB chip.
"""

from __future__ import annotations

import importlib
import re
from typing import TYPE_CHECKING, Protocol, cast
from urllib.parse import parse_qsl, urlsplit

import msgspec

from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    import asyncio

_MODULES = {
    "serial": "serial",
    "tcp": "tcp",
    "unix": "unix",
    "udp": "udp",
    "sim": "virtual",
    "rtl": "virtual",
    "ftdi": "ft232h",
    "ftdi-async": "ft232h_async",
    "zenoh": "zenoh",
}
_DEVICE_NAMES = frozenset({"ftdi", "ftdi-async"})
"""Schemes whose URLs have a device in a form of its own, such as ``ftdi:232h:SERIAL``, where others have host and port.
"""
COMMON_OPTIONS = frozenset({"node"})
_TOKEN = re.compile(r"(?<=[?&]token=)[^&]*")
"""The value of an option that is a secret."""


class DriverUrl(msgspec.Struct, frozen=True):
    """A parsed URL, such as ``serial:/dev/ttyUSB0?baud=12000000`` or ``tcp://robot:7001``."""

    text: str
    """As it was given, without a token: what messages name."""
    scheme: str
    host: str
    """A computer; or a device, as it stands in the URL."""
    port: int | None
    path: str
    options: dict[str, str]

    def integer(self, option: str, default: int) -> int:
        """Give an option that is a whole number.

        Raises:
            ArgumentError: where it is none.
        """
        text = self.options.get(option)
        if text is None:
            return default
        try:
            return int(text, 0)
        except ValueError:
            raise ArgumentError(f"{option}={text} in {self.text} is not a whole number") from None

    def number(self, option: str) -> float:
        """Give an option that is a number, and is there.

        Raises:
            ArgumentError: where it is none.
        """
        text = self.options[option]
        try:
            return float(text)
        except ValueError:
            raise ArgumentError(f"{option}={text} in {self.text} is not a number") from None

    def flag(self, option: str) -> bool:
        """Give an option that is 0 or 1; 0 where it is not given.

        Raises:
            ArgumentError: where it is something else.
        """
        text = self.options.get(option, "0")
        if text not in ("0", "1"):
            raise ArgumentError(f"{option}={text} in {self.text} is neither 0 nor 1")
        return text == "1"

    @property
    def node(self) -> int | None:
        """Number of the node on a shared medium (protocol section 7), None on a medium of our own."""
        if "node" not in self.options:
            return None
        node = self.integer("node", 0)
        if not 0 <= node <= 0xFE:
            raise ArgumentError(f"node={node} in {self.text} is not from 0 to 254")
        return node


class Driver(Protocol):
    """What a module of this package offers."""

    OPTIONS: frozenset[str]

    async def connect(self, url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
        """Open the medium; raise `ConnectError` where it can't be opened."""


def parse_url(url: str) -> DriverUrl:
    """Take a URL apart.

    Raises:
        ArgumentError: for an unknown scheme, a malformed URL, or an option that the scheme does not know.
    """
    scheme, text = url.partition(":")[0], _TOKEN.sub("...", url)
    if scheme not in _MODULES or ":" not in url:
        known = ", ".join(f"{name}:" for name in _MODULES)
        raise ArgumentError(f"{text!r} is no URL of a gateway: it should begin with one of {known}")
    try:
        parts = urlsplit(url)
        options = dict(parse_qsl(parts.query, keep_blank_values=True, strict_parsing=bool(parts.query)))
        if scheme in _DEVICE_NAMES:
            parsed = DriverUrl(text, scheme, parts.netloc, None, parts.path, options)
        else:
            parsed = DriverUrl(text, scheme, parts.hostname or "", parts.port, parts.path, options)
    except ValueError as error:
        raise ArgumentError(f"{text!r} is malformed: {error}") from None
    allowed = load_driver(scheme).OPTIONS | COMMON_OPTIONS
    for name in options:
        if name not in allowed:
            raise ArgumentError(f"unknown option {name!r} in {text}: {scheme}: takes {', '.join(sorted(allowed))}")
    return parsed


def load_driver(scheme: str) -> Driver:
    """Import the driver of a scheme."""
    return cast("Driver", importlib.import_module(f"unity_link.drivers.{_MODULES[scheme]}"))


async def prepare(url: DriverUrl) -> None:
    """Do what must be done once before a medium of this kind can be opened.

    Raises:
        ArgumentError: for a URL of something that there is not.
        ConnectError: where it can't be done here.
    """
    preparing = getattr(load_driver(url.scheme), "prepare", None)
    if preparing is not None:
        await preparing(url)
