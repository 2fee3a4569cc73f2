"""Layers 0 and 1, the media: one file for each URL scheme, imported when a URL with this scheme is opened.

A program adds a medium by `register`. Its `Driver` has a coroutine ``connect(url, protocol)``, which opens the medium
and returns an `asyncio` transport that feeds `protocol`, and ``OPTIONS``, the names of the supported URL options. A
driver may also have:

- a function ``options_of(url)``, if the options depend on the URL
- a coroutine ``prepare(url)`` for slow work that is done once on a machine, such as compiling; the time limit for
  opening a connection does not include it
- a function ``open_bus(url)``, if the medium is a bus that is mapped into memory and has no frames; it returns a
  `MemoryBus`

docs/reference/media.md has the requirements on the transport.
"""

from __future__ import annotations

import difflib
import importlib
import os
import re
import select
from typing import TYPE_CHECKING, Any, Protocol, TypeGuard, cast
from urllib.parse import parse_qsl, urlsplit

from unity_link.errors import ArgumentError, ConnectError, did_you_mean
from unity_link.transport.channel import refused_as
from unity_link.transport.frame_log import is_wanted
from unity_link.transport.url import DriverUrl

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Callable
    from importlib.metadata import EntryPoints

    from unity_link.protocol.wire.configuration import GatewayInfo
    from unity_link.transport.channel import Channel

__all__ = ["ENTRY_POINTS", "Driver", "DriverUrl", "Medium", "MemoryBus", "WordsByAddress", "register"]

ENTRY_POINTS = "unity_link.transports"
"""Group of entry points by which an installed package adds schemes; each names a driver, a module or an object."""
_DRIVERS: dict[str, str | Driver] = {}
"""Driver of each scheme, or the name of its module."""
_SERIAL_PORT = re.compile(r"/dev/(tty|cu\.|serial/)|COM\d")
_HOST_AND_PORT = re.compile(r"[\w.-]+:\d+|\[[\da-fA-F:]+\]:\d+")
_SCHEME = re.compile(r"[a-z][a-z0-9+.-]*")
_STAND_INS: dict[str, str] = {}
"""Module of the simulated device for each name of a device in a URL."""
_DEVICE_NAMES = frozenset({"ftdi", "ftdi-async"})
"""Schemes whose URLs have the name of a device, such as ``ftdi:232h:SERIAL``, in the place of host and port."""
COMMON_OPTIONS = frozenset({"node", "snoop", "map", "compact", "echo"})
SNOOP_VARIABLE = "UNITY_LINK_SNOOP"
"""Environment variable with the path of the snoop for connections whose URL has no ``snoop=``."""
_OPENING_TIMEOUT = 5.0
"""Seconds that a thread may take to open a shared port, also after its caller was cancelled."""
_TOKEN = re.compile(r"(?<=[?&]token=)[^&]*")
"""Value of the option ``token``, which is secret."""


class Driver(Protocol):
    """Opens the URLs of a scheme; a module or an object."""

    OPTIONS: frozenset[str]
    """Names of the supported URL options."""

    async def connect(self, url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
        """Open the medium, call ``protocol.connection_made``, and return the transport.

        Raises:
            ArgumentError: if the URL is invalid.
            ConnectError: if the medium cannot be opened; callers convert an OSError to a ConnectError.
        """


class Medium(Protocol):
    """An object on which a link can be opened instead of a URL, such as a virtual gateway."""

    async def open(self, protocol: asyncio.Protocol) -> asyncio.Transport:
        """Open the medium; raise `ConnectError` if it cannot be opened."""


class WordsByAddress(Protocol):
    """Words that are read and written in memory by index, such as a `memoryview`."""

    def __len__(self) -> int: ...
    def __getitem__(self, address: int, /) -> int: ...
    def __setitem__(self, address: int, value: int, /) -> None: ...


class MemoryBus(Protocol):
    """A bus that is mapped into memory, returned by a driver's ``open_bus(url)``."""

    @property
    def words(self) -> WordsByAddress:
        """Words by address; each access to an element is one bus access."""

    @property
    def info(self) -> GatewayInfo:
        """Configuration that the link uses for this bus."""

    def close(self) -> None:
        """Unmap the bus."""


def register(scheme: str, driver: str | Driver) -> None:
    """Register the driver that opens the URLs of a scheme.

    Args:
        scheme: part of the URL before the colon: lower-case letters, digits, ``+``, ``-`` and ``.``, a letter first.
        driver: the driver, or the name of a module that is a driver; the module is imported when it is needed.

    Raises:
        ArgumentError: if the scheme has other characters or another driver, or if the object is not a driver.
    """
    if not _SCHEME.fullmatch(scheme):
        raise ArgumentError(
            f"{scheme!r} is no scheme of a URL: lower-case letters, digits, +, - and . were expected, a letter first"
        )
    if not isinstance(driver, str):
        _check(scheme, driver)
    if _DRIVERS.setdefault(scheme, driver) != driver:
        raise ArgumentError(f"{scheme}: is registered already, by {_name(_DRIVERS[scheme])}: choose another scheme")


def _check(scheme: str, driver: object) -> None:
    missing = [name for name in ("connect", "OPTIONS") if not hasattr(driver, name)]
    if missing:
        raise ArgumentError(f"{_name(driver)} is no driver for {scheme}: because it has no {' and no '.join(missing)}")


def _name(driver: object) -> str:
    return driver if isinstance(driver, str) else getattr(driver, "__name__", type(driver).__qualname__)


def _installed() -> EntryPoints:
    # Imported here because it is slow, and few programs use media of other packages.
    from importlib.metadata import entry_points

    return entry_points(group=ENTRY_POINTS)


def _register_installed(scheme: str) -> bool:
    """Register the driver that an installed package has for a scheme; return True if there is one.

    Raises:
        ArgumentError: if several packages have a driver for the scheme, or the object is not a driver.
        ConnectError: if the driver cannot be imported.
    """
    points = _installed().select(name=scheme)
    packages = sorted(point.dist.name for point in points if point.dist)
    if len(points) > 1:
        raise ArgumentError(f"{scheme}: is a medium of several packages ({', '.join(packages)}): uninstall all but one")
    for point in points:
        try:
            driver = point.load()
        except (ImportError, AttributeError) as error:
            raise ConnectError(f"{scheme}: of the package {packages[0]} cannot be imported ({error})") from error
        register(scheme, driver)
    return bool(points)


def register_stand_in(device: str, module: str) -> None:
    """Register the module of a simulated device, such as that of ``ftdi://virtual``."""
    _STAND_INS[device] = module


def load_stand_in(device: str) -> Any:
    """Return the module of a simulated device; None for a real device."""
    return importlib.import_module(_STAND_INS[device]) if device in _STAND_INS else None


def parse_url(url: str) -> DriverUrl:
    """Parse a URL.

    Raises:
        ArgumentError: if the scheme is unknown, the URL is malformed, or the scheme does not have one of the options.
        ConnectError: if the driver of the scheme cannot be imported.
    """
    scheme, text = url.partition(":")[0], _TOKEN.sub("...", url)
    if "\0" in url:
        raise ArgumentError(f"{text!r} is malformed: it has a NUL character")
    if ":" not in url or not (scheme in _DRIVERS or _register_installed(scheme)):
        known = ", ".join(f"{name}:" for name in dict.fromkeys((*_DRIVERS, *_installed().names)))
        likely = _likely_url(text)
        hint = f"did you mean {likely!r}?" if likely else f"it should begin with one of {known}"
        if text.endswith(".ul"):
            hint = f"it is a spec, which `unity_link.load` and SPEC of a command take; a URL begins with one of {known}"
        raise ArgumentError(f"{text!r} is no URL of a gateway: {hint}")
    try:
        # No fragments, and + stays +: a file name may contain #, and a token may contain +.
        parts = urlsplit(url, allow_fragments=False)
        query = parts.query.replace("+", "%2B")
        options = dict(parse_qsl(query, keep_blank_values=True, strict_parsing=bool(query)))
        if scheme in _DEVICE_NAMES:
            parsed = DriverUrl(text, scheme, parts.netloc, None, parts.path, options)
        else:
            parsed = DriverUrl(text, scheme, parts.hostname or "", parts.port, parts.path, options)
    except ValueError as error:
        raise ArgumentError(f"{text!r} is malformed: {error}") from None
    driver = load_driver(scheme)
    options_of = getattr(driver, "options_of", None)
    allowed = (driver.OPTIONS if options_of is None else options_of(parsed)) | COMMON_OPTIONS
    for name in options:
        if name not in allowed:
            hint = "".join(f"; {words}" for words in [did_you_mean(name, allowed)] if words)
            known = f"{scheme}: takes {', '.join(sorted(allowed))}"
            raise ArgumentError(f"unknown option {name!r} in {text}: {known}{hint}")
    return parsed


def is_url(text: str) -> bool:
    """Return True if a text begins with a registered scheme and a colon."""
    scheme, colon, _ = text.partition(":")
    return bool(colon) and (scheme in _DRIVERS or scheme in _installed().names)


def _likely_url(text: str) -> str:
    """Return the URL that a user probably meant by an invalid one; empty if there is no likely URL."""
    scheme, colon, rest = text.partition(":")
    if _SERIAL_PORT.match(text):
        return f"serial:{text}"
    if text.startswith(("/", "./", "~")):
        return f"unix:{text}"
    if _HOST_AND_PORT.fullmatch(text):
        return f"tcp://{text}"
    near = difflib.get_close_matches(scheme.lower(), _DRIVERS, n=1) if colon else []
    return f"{near[0]}:{rest}" if near else ""


def load_driver(scheme: str) -> Driver:
    """Return the driver of a scheme.

    Raises:
        ArgumentError: if the registered module is not a driver.
        ConnectError: if the module cannot be imported.
    """
    driver = _DRIVERS[scheme]
    if not isinstance(driver, str):
        return driver
    try:
        module = importlib.import_module(driver)
    except ImportError as error:
        raise ConnectError(f"{driver}, the driver of {scheme}:, cannot be imported ({error})") from error
    _check(scheme, module)
    return cast("Driver", module)


async def open_medium(target: DriverUrl | Medium, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Connect a protocol to a medium, and return its transport.

    If a snoop or a log of frames is enabled now, a tap between the two records the bytes; otherwise there is no tap.

    Raises:
        ArgumentError: if the snoop cannot be written; the medium is not opened then.
        ConnectError: if the medium cannot be opened.
    """
    import asyncio

    protocol = observed(target, protocol)
    try:
        if not isinstance(target, DriverUrl):
            return await target.open(protocol)
        with refused_as("it cannot be opened"):
            if _is_shared(target):
                return await _open_shared(target, protocol)
            return await load_driver(target.scheme).connect(target, protocol)
    except asyncio.CancelledError as error:
        task = asyncio.current_task()
        if task is None or task.cancelling():
            raise
        raise ConnectError("it cannot be opened (its driver raised CancelledError)") from error


def _is_shared(url: DriverUrl) -> bool:
    """Return True if links to several nodes may share the port of a URL; never on Windows, which has no `poll`."""
    return url.node is not None and getattr(load_driver(url.scheme), "NODES_SHARE", False) and hasattr(select, "poll")


async def _open_shared(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Open a link's part of a shared port, in a thread, because opening may block."""
    import asyncio
    import threading

    from unity_link.transport.channel_transport import LoopWatcher, make_transport

    given_up = threading.Event()
    opening = asyncio.get_running_loop().run_in_executor(None, open_channel, url, _OPENING_TIMEOUT, given_up.is_set)
    try:
        channel = await asyncio.shield(opening)
    except asyncio.CancelledError:
        given_up.set()
        opening.add_done_callback(_close_opened)
        raise
    return make_transport(LoopWatcher(), channel, protocol)


def _close_opened(opening: asyncio.Future[Channel]) -> None:
    if not opening.cancelled() and opening.exception() is None:
        opening.result().close()


def has_channel(target: DriverUrl | Medium) -> TypeGuard[DriverUrl]:
    """Return True if `open_channel` can open a medium."""
    return isinstance(target, DriverUrl) and hasattr(load_driver(target.scheme), "open_channel")


def open_channel(url: DriverUrl, timeout: float | None, is_given_up: Callable[[], bool] = lambda: False) -> Channel:
    """Open a medium without an event loop; on a shared port, the part of one node.

    Args:
        url: URL of a medium whose driver has `open_channel`.
        timeout: time limit in seconds; None for no limit.
        is_given_up: returns True once the caller no longer waits.

    Raises:
        ConnectError: if the medium cannot be opened.
    """
    with refused_as("it cannot be opened"):
        driver = cast("Any", load_driver(url.scheme))
        if _is_shared(url):
            from unity_link.transport.shared_port import open_shared

            settings = getattr(driver, "DEFAULTS", {}) | url.options
            return open_shared(url, settings, lambda: driver.open_channel(url, timeout), is_given_up)
        channel: Channel = driver.open_channel(url, timeout)
        return channel


def has_bus(target: DriverUrl | Medium) -> TypeGuard[DriverUrl]:
    """Return True if `open_bus` can open a target; such a target has no frames."""
    return isinstance(target, DriverUrl) and hasattr(load_driver(target.scheme), "open_bus")


def open_bus(url: DriverUrl) -> MemoryBus:
    """Map a bus into memory.

    Raises:
        ArgumentError: if the URL is invalid.
        ConnectError: if the bus cannot be mapped.
    """
    bus: MemoryBus = cast("Any", load_driver(url.scheme)).open_bus(url)
    return bus


def observed(target: DriverUrl | Medium, protocol: asyncio.Protocol) -> asyncio.Protocol:
    """Return the protocol to connect to a medium: `protocol`, or a tap in front of it if a snoop or log is enabled.

    Raises:
        ArgumentError: if the snoop cannot be written.
    """
    named = target.snoop if isinstance(target, DriverUrl) else None
    snoop = os.environ.get(SNOOP_VARIABLE, "") if named is None else named
    logged = is_wanted()
    if not snoop and not logged:
        return protocol
    from unity_link.transport.tap import tapped

    return tapped(protocol, name_of(target), snoop, logged=logged)


def check_target(target: object) -> None:
    """Raise ArgumentError if an object is neither a URL nor a medium."""
    if isinstance(target, os.PathLike):
        path = os.fspath(target)
        raise ArgumentError(f"a URL is a text, not a path: write {_likely_url(str(path)) or f'unix:{path!s}'!r}")
    if not isinstance(target, str) and (isinstance(target, type) or not callable(getattr(target, "open", None))):
        raise ArgumentError(f"a URL such as 'sim:' was expected, or a virtual gateway, not {target!r:.80}")


def name_of(target: DriverUrl | Medium) -> str:
    """Return the name of a medium for messages."""
    return target.text if isinstance(target, DriverUrl) else "the given gateway"


def node_of(target: DriverUrl | Medium) -> int | None:
    """Return the node number on a medium that several nodes share; None if there is only one gateway."""
    node: int | None = getattr(target, "node", None)
    return node


def takes_compact_form(target: DriverUrl | Medium) -> bool:
    """Return True if frames may have the compact form on a medium."""
    return not isinstance(target, DriverUrl) or target.compact


def has_echo(target: DriverUrl | Medium) -> bool:
    """Return True if the URL declares that the medium echoes all sent bytes."""
    return isinstance(target, DriverUrl) and target.echo


async def prepare(url: DriverUrl) -> None:
    """Do the work that a driver needs once before it can open a URL, such as compiling.

    Raises:
        ArgumentError: if the URL names something that does not exist.
        ConnectError: if the work fails on this machine.
    """
    preparing = getattr(load_driver(url.scheme), "prepare", None)
    if preparing is not None:
        await preparing(url)


for _scheme in ("serial", "tcp", "unix", "udp", "zenoh", "mmio"):
    register(_scheme, f"unity_link.transport.{_scheme}")
register("ftdi", "unity_link.transport.ft232h.with_pyftdi")
register("ftdi-async", "unity_link.transport.ft232h.with_libusb")
