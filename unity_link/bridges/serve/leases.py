"""The leases of the gateway among the clients: what one has armed no other moves, and its lease ends with it.

The server is the gateway's only host, so it knows which client began a lease: arms are executed one at a time, and the
state is read behind each. Whether a lease still lasts is the gateway's to say: where its owner's has ended, the gateway
refuses writes of anybody. So nothing is asked of it but when another client wants to arm.
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
"""Owner of a lease that is over for its client, and goes on in the gateway: no client writes what it guards."""
PATIENCE = 2.0
"""Seconds that an arm waits for the gateway."""
_ONE_WORD = frozenset({"W", "WS", "WQ", "WK"})


class Tenant(Protocol):
    """A client, as far as leases know it."""

    queue: ClientQueue

    @property
    def gone(self) -> bool:
        """Return whether its connection has ended."""

    def hold(self) -> None:
        """Look at none of its further requests."""

    def go_on(self) -> None:
        """Look at them again."""


class Host(Protocol):
    """The link to the gateway, as far as leases know it."""

    async def word_at(self, address: int) -> int:
        """Read a word."""

    async def write_at(self, address: int, word: int) -> None:
        """Write a word."""

    async def others_have_written(self, client: Any) -> None:
        """Wait until the writes of other clients that are here have been sent."""


class ArmRequest(NamedTuple):
    """A client's request that would arm."""

    client: Tenant
    finishes: bool
    """True if it wants what is scheduled to go on when it is silent."""
    relay: Callable[[Callable[[bool], None]], None]
    """Hands it on; takes a function that is called when it is over, with whether it was executed."""
    refuse: Callable[[ErrorCode], None]
    """Answers it by an error."""


class ClientLease:
    """One lease, and the client that has it.

    Args:
        interface: with its registers.
        path: of the lease.
    """

    def __init__(self, interface: Interface, path: str) -> None:
        signals = interface.signals
        self.arm = tuple(signals[f"{path}.arm"].addresses)
        self.disarm = signals[f"{path}.disarm"].address
        self.armed = signals[f"{path}.armed"]
        self.owned = interface.written_under(path)
        """Addresses that its owner alone writes: the kick, what it guards, and its schedules."""
        self.owner: object = None
        """Client that began the last lease, which may have ended since; None for no client, or `NOBODY`."""
        self.finishes = False
        """As its owner's `ArmRequest` has it."""
        self.is_owed = False
        """True if it is to be disarmed, which the gateway has not been told."""
        self._choice = (64 - 1) % signals[f"{path}.arm"].word_bits
        self.lock = asyncio.Lock()

    def is_to_finish(self, request: DecodedRequest, highest: int) -> bool:
        """Return what a request that arms says of silence, by the highest bit of the value."""
        return any(address == self.arm[-1] and word >> self._choice & 1 for address, word in _written(request, highest))


class Leases:
    """All leases of a gateway.

    Args:
        interface: the map of the gateway.
        host: the link to it.
    """

    def __init__(self, interface: Interface, host: Host) -> None:
        self.interface = interface
        self._leases = [ClientLease(interface, path) for path in interface.leases]
        self._host = host
        self._closed: dict[object, frozenset[bytes]] = {}

    def __bool__(self) -> bool:
        """Return whether there are any."""
        return bool(self._leases)

    # Requests of clients

    def closed_to(self, client: Tenant, codec: Codec) -> frozenset[bytes]:
        """Return the addresses, as hex digits, at which a write of a client is to be looked at before it goes on."""
        found = self._closed.get(client)
        if found is None:
            numbers = set[int]()
            for lease in self._leases:
                numbers |= set(lease.arm) if lease.owner is client else {*lease.arm, *lease.owned}
            found = self._closed[client] = frozenset(codec.fields("R", number) for number in numbers)
        return found

    def refuses(self, client: Tenant, request: DecodedRequest, highest: int) -> bool:
        """Return whether a request is a write to what another client's lease keeps for that one."""
        written = {address for address, _ in _written(request, highest)}
        return any(
            lease.owner not in {None, client} and not written.isdisjoint(lease.owned.union(lease.arm))
            for lease in self._leases
            # An arm as a whole is settled by `arm`.
            if lease.arm[-1] not in written
        )

    def armed_by(self, request: DecodedRequest, highest: int) -> ClientLease | None:
        """Return the lease that a request would arm: it writes the last word of that register."""
        written = {address for address, _ in _written(request, highest)}
        return next((lease for lease in self._leases if lease.arm[-1] in written), None)

    async def arm(self, lease: ClientLease, request: ArmRequest) -> None:
        """Hand an arm on, unless another client has the lease, and record whose it is then.

        The client is held meanwhile: what it asks for behind an arm is looked at when that has been settled.
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
                # From here on no write of another client is let through, and those that were are executed before it.
                self._own(lease, client)
                lease.finishes = request.finishes
                await self._host.others_have_written(client)
                executed = await self._relay(request)
                with contextlib.suppress(UnityLinkError, TimeoutError):
                    if not await self._is_armed(lease):
                        self._own(lease, None)
                    elif executed:
                        # Another session may have begun before it was sent.
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

    # Clients and gateways that go

    def left_by(self, client: object) -> list[Coroutine[Any, Any, None]]:
        """Return what disarms the leases of a client that has gone, but for those that finish what is scheduled.

        Such a one stays its own, so that nobody writes to what it guards, until another client arms.
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
        """Return the addresses at which a gateway that is back is to be told to disarm, once."""
        owed = [lease for lease in self._leases if lease.is_owed]
        for lease in owed:
            lease.is_owed = False
        return [lease.disarm for lease in owed]

    def interrupted(self) -> None:
        """End all leases for their clients: the session with the gateway is over.

        The next session begins with their disarming, but for those that finish what is scheduled.
        """
        for lease in self._leases:
            if lease.owner is not None:
                lease.is_owed |= not lease.finishes
                self._own(lease, NOBODY)

    def reset(self) -> None:
        """Forget all: the gateway was reset, which disarms."""
        for lease in self._leases:
            self._own(lease, None)
            lease.is_owed = False


def _written(request: DecodedRequest, highest: int) -> Iterator[tuple[int, int]]:
    """Return the addresses that a request writes to, each with the last word for it."""
    command, values = request.command, request.values
    if command in _ONE_WORD:
        words = values[-1]
        yield values[0], words[-1] if isinstance(words, list) else words
    elif command == "WM":
        yield from ((values[0] + index & highest, word) for index, word in enumerate(values[1]))
