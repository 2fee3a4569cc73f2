"""Finds the gateways in a network by broadcast questions (docs/protocol.md, "Finding boards")."""

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
"""Number of times that a question is sent, because datagrams can be lost."""
PATIENCE = 1.0
"""Seconds within which answers usually arrive."""
_ALL_STATIONS = "255.255.255.255"
_FROM_ANY = ""
_SIOCGIFADDR = 0x8915
_ADDRESS_OF_IFREQ = slice(20, 24)
"""Position of an interface's IPv4 address in the result of Linux' ioctl SIOCGIFADDR."""


class FoundBoard(NamedTuple):
    """A gateway that answered."""

    found: Found
    address: str
    port: int
    doubled: bool
    """True if each question had two equal answers: two gateways have the same MAC address and IP address."""

    @property
    def mac(self) -> str:
        """MAC address with colons."""
        return self.found.mac.hex(":")

    @property
    def url(self) -> str:
        """URL that opens a link to the gateway."""
        return f"udp://{self.address}:{self.port}"


async def find(
    places: Sequence[str], port: int, *, patience: float = PATIENCE, mac: bytes = EVERYBODY, ip: bytes = NOWHERE
) -> list[FoundBoard]:
    """Ask for gateways, and return those that answered, sorted by address.

    Args:
        places: addresses to ask, each of a network or of one machine; empty for all networks of this machine, and for
            the machine itself.
        port: UDP port of the gateways.
        patience: seconds to wait for answers.
        mac: MAC address of a single gateway to ask; its first answer ends the search.
        ip: IP address that this gateway is to use from now on.

    Raises:
        ConnectError: if the question cannot be sent to any address.
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
                    f"the question cannot be sent to port {port}: {'; '.join(dict.fromkeys(map(str, refusals)))}"
                )
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(enough.wait(), patience / (2 if number == QUESTIONS - 1 else 4))
                break
    return _boards(askers, port)


class _Asker(asyncio.DatagramProtocol):
    """Asks one network, and counts its answers.

    Args:
        opened: the socket.
        place: address and port to ask.
        mac: MAC address of the gateway that is asked; answers of other gateways are ignored, unless all are asked.
        enough: event that is set by an answer of that gateway.
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
        """Send a question; return the reason if that fails, otherwise an empty string."""
        try:
            self.socket.sendto(question, self._place)
        except (OSError, UnicodeError) as error:
            return f"{self._place[0]}: {getattr(error, 'strerror', None) or error}"
        return ""


def _ways(places: Sequence[str]) -> list[tuple[str, str]]:
    """Return pairs of a local address to send from and an address to send to."""
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
    # The network of the address may just have gone down; sending then fails and gives the reason.
    with contextlib.suppress(OSError):
        opened.bind((source, 0))
    return opened


def _own_addresses() -> list[str]:
    """Return this machine's IPv4 address in each network: a broadcast goes to the network of its source address."""
    if sys.platform != "linux":
        with contextlib.suppress(OSError):
            return [str(each[4][0]) for each in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)]
        return []
    # Windows does not have this module.
    import fcntl

    found = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asked:
        for _, name in socket.if_nameindex():
            # Skip interfaces without an IPv4 address.
            with contextlib.suppress(OSError):
                told = fcntl.ioctl(asked.fileno(), _SIOCGIFADDR, struct.pack("256s", name.encode()))
                found.append(socket.inet_ntoa(told[_ADDRESS_OF_IFREQ]))
    return found


def _boards(askers: list[_Asker], port: int) -> list[FoundBoard]:
    """Return each gateway once, even if it answered in several networks."""
    boards: dict[tuple[object, ...], FoundBoard] = {}
    for asker in askers:
        times: Counter[tuple[object, ...]] = Counter()
        for (found, address), count in asker.answers.items():
            # Ignore `session_open` in the comparison: a session may have begun between two answers.
            key = (found._replace(session_open=False), address)
            times[key] += count
            doubled = times[key] >= 2 * QUESTIONS or (key in boards and boards[key].doubled)
            boards[key] = FoundBoard(found, address, port, doubled)
    return sorted(boards.values(), key=lambda board: (socket.inet_aton(board.address), board.found))
