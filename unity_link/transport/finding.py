"""Gateways of a network, found by a question to all (docs/protocol.md, "Finding boards")."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import struct
import sys
from collections import Counter
from typing import TYPE_CHECKING, Any, NamedTuple

from unity_link.errors import ConnectError
from unity_link.protocol.wire.discovery import EVERYBODY, NOWHERE, Found, ask, read_answer
from unity_link.transport.listening import LOOPBACK

if TYPE_CHECKING:
    from collections.abc import Sequence

QUESTIONS = 3
"""Times that each question is asked: a datagram can be lost."""
PATIENCE = 1.0
"""Seconds in which answers come, usually."""
_ALL_STATIONS = "255.255.255.255"
_FROM_ANY = ""
_SIOCGIFADDR = 0x8915
_ADDRESS_OF_IFREQ = slice(20, 24)
"""Linux: the IPv4 address of an interface, and where it stands."""


class FoundBoard(NamedTuple):
    """A gateway that has answered."""

    found: Found
    address: str
    port: int
    doubled: bool
    """True if two answers came to each question: of two gateways that tell the same of themselves."""

    @property
    def mac(self) -> str:
        """Return its MAC address, as people write it."""
        return self.found.mac.hex(":")

    @property
    def url(self) -> str:
        """Return the URL that opens it."""
        return f"udp://{self.address}:{self.port}"


async def find(
    places: Sequence[str], port: int, *, patience: float = PATIENCE, mac: bytes = EVERYBODY, ip: bytes = NOWHERE
) -> list[FoundBoard]:
    """Ask who is there; returns those that have answered, by their addresses.

    Args:
        places: addresses to ask, of a whole network or of one machine; none for all networks that this machine is in,
            and itself.
        port: of the gateways.
        patience: seconds until the last answer counts.
        mac: of the gateway that is asked alone; the first answer of it is enough.
        ip: the address of IP that this one is to take.

    Raises:
        ConnectError: where nobody can be asked.
    """
    enough = asyncio.Event()
    async with contextlib.AsyncExitStack() as stack:
        askers: list[_Asker] = []
        for source, place in _ways(places):
            asker = _Asker(_open(source), (place, port), mac, enough)
            await asyncio.get_running_loop().create_datagram_endpoint(lambda asker=asker: asker, sock=asker.socket)  # type: ignore[misc]
            stack.callback(asker.close)
            askers.append(asker)
        for number in range(QUESTIONS):
            refusals = [asker.ask(ask(mac, ip)) for asker in askers]
            if all(refusals):
                raise ConnectError(
                    f"nobody can be asked at port {port}: {'; '.join(dict.fromkeys(map(str, refusals)))}"
                )
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(enough.wait(), patience / (2 if number == QUESTIONS - 1 else 4))
                break
    return _boards(askers, port)


class _Asker(asyncio.DatagramProtocol):
    """Asks one network, and counts its answers.

    Args:
        opened: the socket.
        place: the address and port to ask.
        mac: of the gateway that is asked; only its answers count, unless all gateways are asked.
        enough: is set at an answer of that gateway.
    """

    def __init__(self, opened: socket.socket, place: tuple[str, int], mac: bytes, enough: asyncio.Event) -> None:
        self.socket = opened
        self.answers: Counter[tuple[Found, str]] = Counter()
        self._place = place
        self._mac = mac
        self._enough = enough

    def connection_made(self, transport: Any) -> None:
        self.close = transport.close

    def datagram_received(self, data: bytes, addr: tuple[Any, ...]) -> None:
        found = read_answer(data)
        if found is None or addr[1] != self._place[1] or self._mac not in (EVERYBODY, found.mac):
            return
        self.answers[found, addr[0] if found.ip == NOWHERE else socket.inet_ntoa(found.ip)] += 1
        if found.mac == self._mac:
            self._enough.set()

    def ask(self, question: bytes) -> str:
        """Send a question; returns why that can't be done, nothing where it could."""
        try:
            self.socket.sendto(question, self._place)
        except (OSError, UnicodeError) as error:
            return f"{self._place[0]}: {getattr(error, 'strerror', None) or error}"
        return ""


def _ways(places: Sequence[str]) -> list[tuple[str, str]]:
    """Return from which address each place is asked."""
    if places:
        return [(_FROM_ANY, place) for place in places]
    return [
        (address, address if address == LOOPBACK else _ALL_STATIONS)
        for address in sorted({LOOPBACK, *_own_addresses()})
    ]


def _open(source: str) -> socket.socket:
    opened = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    opened.setsockopt(socket.SOL_SOCKET, socket.SO_BROADCAST, 1)
    opened.settimeout(0)
    # Of a network that goes down in this moment: what is sent to it is refused.
    with contextlib.suppress(OSError):
        opened.bind((source, 0))
    return opened


def _own_addresses() -> list[str]:
    """Return IPv4 addresses of this machine, one of each network: a question goes to the network that it is from."""
    if sys.platform != "linux":
        with contextlib.suppress(OSError):
            return [str(each[4][0]) for each in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)]
        return []
    # Not there on Windows.
    import fcntl

    found = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asked:
        for _, name in socket.if_nameindex():
            # One without an address is none to ask by.
            with contextlib.suppress(OSError):
                told = fcntl.ioctl(asked.fileno(), _SIOCGIFADDR, struct.pack("256s", name.encode()))
                found.append(socket.inet_ntoa(told[_ADDRESS_OF_IFREQ]))
    return found


def _boards(askers: list[_Asker], port: int) -> list[FoundBoard]:
    """Return the gateways, each once, whichever networks it has answered in."""
    boards: dict[tuple[object, ...], FoundBoard] = {}
    for asker in askers:
        times: Counter[tuple[object, ...]] = Counter()
        for (found, address), count in asker.answers.items():
            # A session may have begun between two answers.
            key = (found._replace(session_open=False), address)
            times[key] += count
            doubled = times[key] >= 2 * QUESTIONS or (key in boards and boards[key].doubled)
            boards[key] = FoundBoard(found, address, port, doubled)
    return sorted(boards.values(), key=lambda board: (socket.inet_aton(board.address), board.found))
