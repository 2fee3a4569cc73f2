"""The leases of the gateway and the clients that hold them. A lease ends with its client.

The server is the gateway's only host, so it knows which client has begun a lease: arms are executed one at a time, and
the state is read after each. The gateway determines whether a lease still lasts: after the end of the owner's lease it
refuses the writes of all clients. So the server reads the state only if another client wants to arm.
"""

from __future__ import annotations

import asyncio
import contextlib
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from unity_link.errors import UnityLinkError
from unity_link.protocol.wire.messages import ErrorCode

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Iterator

    from unity_link.bridges.serve.turns import ClientQueue
    from unity_link.protocol.wire.messages import Codec, DecodedRequest
    from unity_link.spec.model import Interface

NOBODY = object()
"""Owner of a lease that has ended for its client but not in the gateway: it bars writes of all clients."""
PATIENCE = 2.0
"""Seconds that an arm waits for the gateway."""
_ONE_WORD = frozenset({"W", "WS", "WQ", "WK"})


class Tenant(Protocol):
    """The attributes of a client that leases use."""

    queue: ClientQueue

    @property
    def gone(self) -> bool:
        """Return whether its connection has ended."""

    def hold(self) -> None:
        """Process no further requests of the client."""

    def go_on(self) -> None:
        """Process the client's requests again."""


class Host(Protocol):
    """The methods of the link to the gateway that leases use."""

    async def word_at(self, address: int) -> int:
        """Read a word."""

    async def write_at(self, address: int, word: int) -> None:
        """Write a word."""

    async def others_have_written(self, client: Any) -> None:
        """Wait until the writes of other clients that the server has received are sent."""


class ArmRequest(NamedTuple):
    """A client's request to arm a lease."""

    client: Tenant
    finishes: bool
    """True if scheduled writes continue after the end of the lease."""
    relay: Callable[[Callable[[bool], None]], None]
    """Passes the request on. Takes a function that is called with whether the request was executed."""
    refuse: Callable[[ErrorCode], None]
    """Answers the request with an error."""


class ClientLease:
    """One lease, and the client that holds it.

    Args:
        interface: interface with the lease.
        path: path of the lease.
    """

    def __init__(self, interface: Interface, path: str) -> None:
        signals = interface.signals
        self.arm = tuple(signals[f"{path}.arm"].addresses)
        self.disarm = signals[f"{path}.disarm"].address
        self.armed = signals[f"{path}.armed"]
        self.owned = interface.written_under(path)
        """Addresses that only the owner may write: the kick, the guarded signals, and their schedules."""
        self.owner: object = None
        """Client that began the last lease, which may have ended since; None for no client, or `NOBODY`."""
        self.finishes = False
        """`ArmRequest.finishes` of the owner's request."""
        self.is_owed = False
        """True if the lease must be disarmed and the gateway has not executed that yet."""
        self._choice = (64 - 1) % signals[f"{path}.arm"].word_bits
        self.lock = asyncio.Lock()

    def is_to_finish(self, request: DecodedRequest, highest: int) -> bool:
        """Return whether a request that arms lets scheduled writes continue, from the highest bit of its token."""
        return any(address == self.arm[-1] and word >> self._choice & 1 for address, word in _written(request, highest))


class Leases:
    """All leases of a gateway.

    Args:
        interface: interface of the gateway.
        host: link to the gateway.
    """

    def __init__(self, interface: Interface, host: Host) -> None:
        self.interface = interface
        self._leases = [ClientLease(interface, path) for path in interface.leases]
        self._host = host
        self._closed: dict[object, frozenset[bytes]] = {}

    def __bool__(self) -> bool:
        """Return whether the gateway has any leases."""
        return bool(self._leases)

    # Requests of clients

    def closed_to(self, client: Tenant, codec: Codec) -> frozenset[bytes]:
        """Return the addresses, in hex digits, at which writes of a client must be checked before they are sent."""
        found = self._closed.get(client)
        if found is None:
            numbers = set[int]()
            for lease in self._leases:
                numbers |= set(lease.arm) if lease.owner is client else {*lease.arm, *lease.owned}
            found = self._closed[client] = frozenset(codec.fields("R", number) for number in numbers)
        return found

    def refuses(self, client: Tenant, request: DecodedRequest, highest: int) -> bool:
        """Return whether a request is a write that only another client may make, because it holds the lease."""
        written = {address for address, _ in _written(request, highest)}
        return any(
            lease.owner not in {None, client} and not written.isdisjoint(lease.owned.union(lease.arm))
            for lease in self._leases
            # `arm` decides about a request that arms.
            if lease.arm[-1] not in written
        )

    def armed_by(self, request: DecodedRequest, highest: int) -> ClientLease | None:
        """Return the lease that a request would arm by writing the last word of its register; else None."""
        written = {address for address, _ in _written(request, highest)}
        return next((lease for lease in self._leases if lease.arm[-1] in written), None)

    async def arm(self, lease: ClientLease, request: ArmRequest) -> None:
        """Pass an arm on, unless another client holds the lease, and record the new owner.

        The client is held meanwhile: its requests after an arm are processed when the owner is known.
        """
        client = request.client
        try:
            async with lease.lock:
                if client.gone:
                    return
                if lease.owner not in {None, client}:
                    try:
                        is_armed = await self._is_armed(lease)
                    except (UnityLinkError, TimeoutError):
                        request.refuse(ErrorCode.BUS_TIMEOUT)
                        return
                    if is_armed:
                        request.refuse(ErrorCode.BUS_ERROR)
                        return
                # From here on no write of another client is passed on, and earlier ones are executed before the arm.
                self._own(lease, client)
                lease.finishes = request.finishes
                await self._host.others_have_written(client)
                executed = await self._relay(request)
                with contextlib.suppress(UnityLinkError, TimeoutError):
                    if not await self._is_armed(lease):
                        self._own(lease, None)
                    elif executed:
                        # Another session may have begun before the arm was sent, and set the owner to `NOBODY`.
                        self._own(lease, client)
        finally:
            client.go_on()

    async def _relay(self, request: ArmRequest) -> bool:
        if request.client.gone:
            return False
        over: asyncio.Future[bool] = asyncio.get_running_loop().create_future()
        request.relay(lambda executed: None if over.done() else over.set_result(executed))
        return await over

    async def _is_armed(self, lease: ClientLease) -> bool:
        async with asyncio.timeout(PATIENCE):
            word = await self._host.word_at(lease.armed.address)
        return bool(lease.armed.decode(word))

    def _own(self, lease: ClientLease, client: object) -> None:
        lease.owner = client
        self._closed.clear()

    # Loss of clients and of the gateway

    def left_by(self, client: object) -> list[Coroutine[Any, Any, None]]:
        """Return coroutines that disarm the leases of a client that has disconnected, except those that finish.

        A lease that finishes keeps its owner until another client arms, and so bars writes of all clients.
        """
        self._closed.pop(client, None)
        ending = [lease for lease in self._leases if lease.owner is client and not lease.finishes]
        return [self._disarm(lease, client) for lease in ending]

    async def _disarm(self, lease: ClientLease, client: object) -> None:
        async with lease.lock:
            if lease.owner is not client:
                return
            self._own(lease, None)
            lease.is_owed = True
            with contextlib.suppress(UnityLinkError, TimeoutError):
                async with asyncio.timeout(PATIENCE):
                    await self._host.write_at(lease.disarm, 1)
                lease.is_owed = False

    def take_owed(self) -> list[int]:
        """Return the addresses to write to for disarming, when the gateway is back; each lease is returned once."""
        owed = [lease for lease in self._leases if lease.is_owed]
        for lease in owed:
            lease.is_owed = False
        return [lease.disarm for lease in owed]

    def interrupted(self) -> None:
        """End all leases for their clients, because the session with the gateway is over.

        The next session begins by disarming them, except those that finish scheduled writes.
        """
        for lease in self._leases:
            if lease.owner is not None:
                lease.is_owed |= not lease.finishes
                self._own(lease, NOBODY)

    def reset(self) -> None:
        """Forget all owners, because the gateway was reset, which disarms its leases."""
        for lease in self._leases:
            self._own(lease, None)
            lease.is_owed = False


def _written(request: DecodedRequest, highest: int) -> Iterator[tuple[int, int]]:
    """Yield the addresses that a request writes to, each with the last word for it."""
    command, values = request.command, request.values
    if command in _ONE_WORD:
        words = values[-1]
        yield values[0], words[-1] if isinstance(words, list) else words
    elif command == "WM":
        yield from ((values[0] + index & highest, word) for index, word in enumerate(values[1]))
