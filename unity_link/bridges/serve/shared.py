"""The shared link and its clients.

While the gateway is away, requests wait for it for `PATIENCE` seconds. Then they are answered with error 05, and so are
later ones until the gateway is back. So clients do not notice a short interruption, a longer one does not disconnect
them, and no write is executed long after it was requested. A reset of the gateway ends the sessions of all clients.
"""

from __future__ import annotations

import asyncio
import contextlib
from typing import TYPE_CHECKING, Any, Protocol

import msgspec

from unity_link.bridges.serve.groups import Slots
from unity_link.bridges.serve.leases import Leases
from unity_link.bridges.serve.turns import Turns
from unity_link.data.describing import read_spec
from unity_link.data.robot import check_gateway
from unity_link.errors import ArgumentError, ConnectError, LinkLostError, UnityLinkError, UnsupportedError, reason_of
from unity_link.link.connection import Connection, Reconnect
from unity_link.protocol.host.events import GroupEvent, PostedFailure, Sampled
from unity_link.protocol.host.requests import Request
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.messages import Codec

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine

    from unity_link.bridges.serve.groups import ClientGroup, GroupSettings, Slot
    from unity_link.bridges.serve.turns import ClientQueue
    from unity_link.protocol.host.events import Interrupted, UnsolicitedEvent
    from unity_link.protocol.host.host_codec import HostCodec
    from unity_link.spec.model import Interface
    from unity_link.transport import DriverUrl, Medium

PATIENCE = 2.0
"""Seconds that requests wait for a gateway that is away; less than the time after which a host gives up."""
PAUSES = Reconnect(longest_pause=2.0)
_OFF, _ALWAYS, _ADAPTIVE = range(3)
_MODE_NAMES = ("off", "always", "adaptive")


class Sharer(Protocol):
    """The attributes of a client that the shared link uses."""

    queue: ClientQueue
    groups: dict[int, ClientGroup]
    mode: int | None
    """Send-immediate mode of the client; None before its first frame."""

    def hang_up(self) -> None:
        """End the connection."""

    def refuse_all(self) -> None:
        """Answer all waiting requests with an error."""

    def lose_session(self) -> None:
        """Report a reset of the gateway to the client."""


class SharedLink(Connection):
    """A link that sends the requests of its clients.

    Args:
        target: URL of the gateway, or a medium in this process.
        report: called with a sentence when the gateway goes away or comes back.
        interface: interface of the gateway; None for the description that it carries, if any.
    """

    def __init__(
        self, target: DriverUrl | Medium, report: Callable[[str], None], interface: Interface | None = None
    ) -> None:
        super().__init__(target, PAUSES)
        self.loop = asyncio.get_running_loop()
        self.codec: Codec | None = None
        """Codec for the clients; None until the gateway has sent its configuration for the first time."""
        self.away = True
        """True if requests are refused, because the gateway has been away for more than `PATIENCE` seconds."""
        self.turns = Turns(self._flow.submit)
        self.slots: Slots
        self._report = report
        self.leases = self._leases_of(interface)
        """Leases of the gateway; None if its interface is not known or has none."""
        self._has_map = interface is not None
        self.clients: set[Sharer] = set()
        self.strangers: dict[asyncio.Transport, None] = {}
        """Connections of unauthenticated clients, the oldest first."""
        self.ended: asyncio.Future[None] = self.loop.create_future()
        """Future that ends with an error when the link has ended for good."""
        self.tried = asyncio.Event()
        """Set when the first attempt to reach the gateway is over."""
        self._mode = _ADAPTIVE
        """Send-immediate mode of the gateway."""
        self._changing_mode: asyncio.Task[None] | None = None
        self._last_report = ""
        self._patience: asyncio.TimerHandle | None = None
        self._errands: set[asyncio.Task[None]] = set()

    def _happened(self, event: UnsolicitedEvent) -> None:
        if isinstance(event, Sampled):
            event.owner.receive(event.body)
        elif isinstance(event, GroupEvent | PostedFailure):
            # The server itself has no groups and posts no writes: clients do.
            pass
        else:
            self._take_change(event)

    @property
    def to_gateway(self) -> HostCodec:
        """Codec for the gateway, which may be one of several nodes."""
        return self._session.codec

    # Clients

    def join(self, client: Sharer) -> None:
        """Add a client."""
        self.clients.add(client)

    def leave(self, client: Sharer) -> None:
        """Remove a client, and free its groups and leases."""
        self.clients.discard(client)
        if self.leases is not None:
            for disarming in self.leases.left_by(client):
                self._run(disarming)
        for group in client.groups.values():
            if group.slot is not None:
                self._free(group.slot)
        self.settle_mode()

    # Leases

    def _leases_of(self, interface: Interface | None) -> Leases | None:
        if interface is None:
            return None
        for part in interface.cores:
            if part.type == "LEASE" and part.path in interface.misfits:
                self._report(f"its leases are not those of clients, since {interface.misfits[part.path]}")
        return Leases(interface, self) or None

    async def _read_leases(self) -> None:
        """Read the description that the gateway carries, if no interface was given. It is read only once.

        Raises:
            LinkLostError: if the session has ended.
        """
        if not self._has_map and Feature.DESCRIPTION in self.gateway.features:
            try:
                self.leases = self._leases_of((await read_spec(self)).interface())
            except LinkLostError:
                raise
            except UnityLinkError as error:
                self._report(f"its leases are not those of clients, since {reason_of(error)}")
        self._has_map = True

    async def post(self, address: int, value: int) -> None:
        """Write a word of the gateway, and wait for the execution, as `write_at` does."""
        await self.write_at(address, value)

    async def read_block(self, address: int, count: int) -> list[int]:
        """Read words of the gateway one by one. No client sends requests at this time."""
        return await asyncio.gather(*(self.word_at(address + index) for index in range(count)))

    async def word_at(self, address: int) -> int:
        """Read a word of the gateway; an error if the session ends."""
        codec = self._session.codec
        request = Request(codec, "R", codec.fields("R", address), codec.data_digits, of_session=True)
        word: int = await self._flow.answer(request)
        return word

    async def write_at(self, address: int, word: int) -> None:
        """Write a word of the gateway; an error if the session ends."""
        await self._do("W", self._session.codec.fields("W", address, word))

    async def others_have_written(self, client: Sharer) -> None:
        """Wait until the writes of other clients that the server has received are sent."""
        await self.turns.written(other.queue for other in self.clients if other is not client)

    def settle_arm(self, arming: Coroutine[Any, Any, None]) -> None:
        """Run the arming of a lease, during which its client is held."""
        self._run(arming)

    # Groups

    def naming(self, slot: Slot, command: str, settings: GroupSettings | None = None) -> Callable[[bool], None]:
        """Reserve a slot for its group while a request of the client names it.

        Args:
            slot: the slot.
            command: ``GS``, ``GN``, ``GX`` or ``GP``.
            settings: settings of a ``GS``.

        Returns:
            A function to call when the request is over, with whether the gateway has executed it.
        """
        slot.busy += 1

        def change() -> None:
            if settings is not None:
                self.slots.begin(slot, settings)
            if command != "GP":
                slot.change(running=command == "GN")

        slot.changes.append(change)

        def over(executed: bool) -> None:  # noqa: FBT001  (its only argument)
            slot.busy -= 1
            # Earlier requests of the client were executed before this one, even if their answers arrive later.
            while executed and change in slot.changes:
                earlier = slot.changes.popleft()
                # The client may have left in the meantime.
                if slot.group is not None:
                    earlier()
            if change in slot.changes:
                slot.changes.remove(change)
                if slot.group is not None and command == "GX":
                    self._stop(slot)
            self.slots.settle(slot)

        return over

    def _free(self, slot: Slot) -> None:
        """Take a slot from a client that has left."""
        in_use = slot.running or slot.busy
        self.slots.abandon(slot)
        if in_use:
            self._stop(slot)
        else:
            self.slots.settle(slot)

    def _stop(self, slot: Slot) -> None:
        """Stop the publication of a slot, also if its client could not stop it."""
        slot.change(running=False)
        slot.stopping = True
        self._run(self._stop_in_this_session(slot))

    async def _stop_in_this_session(self, slot: Slot) -> None:
        # At the beginning of a new session no group runs.
        if self.connected:
            with contextlib.suppress(UnityLinkError):
                await self._do("GX", slot.text)
        slot.stopping = False
        self.slots.settle(slot)

    # Send-immediate

    def settle_mode(self) -> None:
        """Set the gateway to the send-immediate mode that its clients need.

        The gateway has one mode for all clients: if any of them wants answers at once, all get them.
        """
        if self._changing_mode is None or self._changing_mode.done():
            self._changing_mode = self._run(self._change_mode())

    async def _change_mode(self) -> None:
        while self._flow.stream is not None and (mode := self._wanted_mode()) != self._mode:
            self._mode = mode
            with contextlib.suppress(UnityLinkError):
                await self._do("I", b"%02X" % mode)
                # Set it again: a new session, in which the mode was set, may have begun in the meantime.
                self._mode = mode
            if self._flow.stream is not None:
                await self._flow.stream.choose_send_immediate(_MODE_NAMES[mode])

    def _wanted_mode(self) -> int:
        modes = {client.mode for client in self.clients} - {None} or {_ADAPTIVE}
        return next(mode for mode in (_ALWAYS, _ADAPTIVE, _OFF) if mode in modes)

    # The gateway

    async def _do(self, command: str, fields: bytes) -> None:
        """Execute a request of the server's own."""
        await self._flow.answer(Request(self._session.codec, command, fields, 0, of_session=True))

    def _run(self, errand: Coroutine[Any, Any, None]) -> asyncio.Task[None]:
        """Run a task that no request waits for. Errors are ignored: a lost connection is reported anyway."""
        task = self.loop.create_task(errand)
        self._errands.add(task)
        task.add_done_callback(self._forget)
        return task

    def _forget(self, task: asyncio.Task[None]) -> None:
        self._errands.discard(task)
        if not task.cancelled():
            task.exception()

    def _begin(self, codec: HostCodec) -> None:
        """Make the configuration for clients from that of the gateway, without features of the gateway's own line."""
        self.tried.set()
        if self.leases is not None:
            self._check_map(self.leases.interface)
        if self.codec is None:
            left = Feature.ADDRESSED | Feature.HALF_DUPLEX | Feature.COMPACT
            features = codec.info.features & ~left | Feature.FLOW_CONTROL
            words = self._flow.block_words
            self.codec = Codec(msgspec.structs.replace(codec.info, features=features, block_words=words))
            self.slots = Slots(self._session.groups, codec.info.groups)

    def _check_map(self, interface: Interface) -> None:
        """End the link for good if the gateway has another map than the given interface."""
        try:
            check_gateway(interface, self)
        except UnsupportedError as error:
            if not self.ended.done():
                self.ended.set_exception(ConnectError(str(error)))
                self.ended.exception()

    async def _restore(self) -> None:
        """Set up groups and mode in a new session, and then pass requests on.

        Clients may connect, leave and send requests in the meantime; these requests are executed after all this.
        """
        self._mode = _ADAPTIVE
        await self._read_leases()
        for address in self.leases.take_owed() if self.leases is not None else ():
            await self._ask("W", self._session.codec.fields("W", address, 1))
        self.settle_mode()
        self.slots.let_go_idle()
        for slot in list(self.slots.held):
            await self._start_again(slot)
        self.away = False
        self.turns.release()
        if self._patience is not None:
            self._patience.cancel()
            self._patience = None
        self._say(f"the gateway answers: {self.gateway.data_bits} data bits, {self.gateway.address_bits} address bits")

    async def _start_again(self, slot: Slot) -> None:
        """Configure a client's group again in a new session, unless the client has released it."""
        settings = slot.settings
        if settings is None:
            return
        slot.busy += 1
        try:
            await self._ask("GS", slot.text + settings.fields)
            if slot.settings is settings:
                missed = 0.0 if slot.lost_at is None else self.loop.time() - slot.lost_at
                slot.lost_at = None
                self.slots.begin(slot, settings, missed)
            if slot.running:
                await self._ask("GN", slot.text)
        finally:
            slot.busy -= 1
            self.slots.settle(slot)

    async def _ask(self, command: str, fields: bytes) -> None:
        """Execute a request that the session needs.

        Raises:
            LinkLostError: if it was not executed; the session has ended.
        """
        try:
            await self._do(command, fields)
        except UnityLinkError as error:
            reason = f"the groups of the clients could not be set up again ({reason_of(error)})"
            if self.connected:
                self._lose(reason)
            raise LinkLostError(reason) from error

    def _interrupted(self, reason: str) -> None:
        self.turns.hold()
        if self.leases is not None:
            self.leases.interrupted()
        self.slots.interrupted(self.loop.time())
        if not self.away and self._patience is None:
            self._patience = self.loop.call_later(PATIENCE, self._refuse_waiting)
        self._say(f"the gateway is away: {reason}")

    def _gateway_was_reset(self, event: Interrupted) -> None:
        """End the session of each client, and delete its groups.

        At this time, requests in flight have ended or wait for their retransmission, and the next session is not open.
        """
        for client in list(self.clients):
            client.lose_session()
        if self.leases is not None:
            self.leases.reset()
        super()._gateway_was_reset(event)

    def _unreachable(self, error: BaseException | None) -> None:
        self.tried.set()
        self._say(f"waiting for the gateway: {error}")

    def _refuse_waiting(self) -> None:
        self.away = True
        for client in self.clients:
            client.refuse_all()

    def _ended(self, error: LinkLostError) -> None:
        self.tried.set()
        for client in list(self.clients):
            client.hang_up()
        if not self.ended.done():
            cause = error.__cause__
            self.ended.set_exception(cause if isinstance(cause, ArgumentError) else ConnectError(error.reason))
            self.ended.exception()

    def _say(self, text: str) -> None:
        """Report a text, unless it is the same as the last one."""
        if text != self._last_report:
            self._last_report = text
            self._report(text)

    async def finish(self) -> None:
        """Disconnect all clients, free their groups and leases in the gateway, and close the link."""
        for stranger in list(self.strangers):
            stranger.abort()
        for client in list(self.clients):
            client.hang_up()
            self.leave(client)
        if self._errands and self.connected:
            await asyncio.wait(self._errands, timeout=1.0)
        if self._patience is not None:
            self._patience.cancel()
        await self.aclose()
