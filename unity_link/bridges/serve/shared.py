"""The one link, and all who share it.

While the gateway is away, requests wait `PATIENCE` seconds for it; then they are answered by error 05, and so is every
further one until it is back. So a short interruption is not seen, a longer one does not end any client, and no write is
executed long after it was asked for. A reset of the gateway ends the sessions of all clients.
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
"""Seconds that requests wait for a gateway that is away: less than what a host waits in silence."""
PAUSES = Reconnect(longest_pause=2.0)
_OFF, _ALWAYS, _ADAPTIVE = range(3)
_MODE_NAMES = ("off", "always", "adaptive")


class Sharer(Protocol):
    """A client, as far as the link has to know it."""

    queue: ClientQueue
    groups: dict[int, ClientGroup]
    mode: int | None
    """The send-immediate mode that it asks for; None before it has said anything that could be understood."""

    def hang_up(self) -> None:
        """End the connection."""

    def refuse_all(self) -> None:
        """Answer every waiting request with an error."""

    def lose_session(self) -> None:
        """Answer for a reset of the gateway."""


class SharedLink(Connection):
    """A link whose requests are those of clients.

    Args:
        target: the URL of a gateway, or one of this process.
        report: is told in a sentence when the gateway comes and goes.
        interface: the map of the gateway; None for the one that it carries, if it carries any.
    """

    def __init__(
        self, target: DriverUrl | Medium, report: Callable[[str], None], interface: Interface | None = None
    ) -> None:
        super().__init__(target, PAUSES)
        self.loop = asyncio.get_running_loop()
        self.codec: Codec | None = None
        """The messages towards clients; None before the gateway has said for the first time what it is."""
        self.away = True
        """True if requests are refused because the gateway has been away too long."""
        self.turns = Turns(self._flow.submit)
        self.slots: Slots
        self._report = report
        self.leases = self._leases_of(interface)
        """Leases of the gateway; None where its map is not known, or has none."""
        self._has_map = interface is not None
        self.clients: set[Sharer] = set()
        self.strangers: dict[asyncio.Transport, None] = {}
        """Connections that have not been let in yet, the oldest first."""
        self.ended: asyncio.Future[None] = self.loop.create_future()
        """Raises when the link has ended for good."""
        self.tried = asyncio.Event()
        """True if the first attempt to reach the gateway is over."""
        self._mode = _ADAPTIVE
        """The gateway's send-immediate mode."""
        self._changing_mode: asyncio.Task[None] | None = None
        self._last_words = ""
        self._patience: asyncio.TimerHandle | None = None
        self._errands: set[asyncio.Task[None]] = set()

    def _happened(self, event: UnsolicitedEvent) -> None:
        if isinstance(event, Sampled):
            event.owner.receive(event.body)
        elif isinstance(event, GroupEvent | PostedFailure):
            # It holds no groups, which the clients set up, and posts nothing by itself.
            pass
        else:
            self._take_change(event)

    @property
    def to_gateway(self) -> HostCodec:
        """The messages towards the gateway, which may be one node of several."""
        return self._session.codec

    # Clients

    def join(self, client: Sharer) -> None:
        """Take in a client."""
        self.clients.add(client)

    def leave(self, client: Sharer) -> None:
        """Let a client go, and free what it has set up."""
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
        """Read the map that the gateway carries, where none was given; another gateway never comes behind it.

        Raises:
            LinkLostError: where the session has ended meanwhile.
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
        """Write a word of the gateway, as `write_at` does."""
        await self.write_at(address, value)

    async def read_block(self, address: int, count: int) -> list[int]:
        """Read words of the gateway one by one; nobody else has it meanwhile."""
        return await asyncio.gather(*(self.word_at(address + index) for index in range(count)))

    async def word_at(self, address: int) -> int:
        """Read a word of the gateway; ends with an error where the session does."""
        codec = self._session.codec
        request = Request(codec, "R", codec.fields("R", address), codec.data_digits, of_session=True)
        word: int = await self._flow.answer(request)
        return word

    async def write_at(self, address: int, word: int) -> None:
        """Write a word of the gateway; ends with an error where the session does."""
        await self._do("W", self._session.codec.fields("W", address, word))

    async def others_have_written(self, client: Sharer) -> None:
        """Wait until the writes of other clients that are here have been sent."""
        await self.turns.written(other.queue for other in self.clients if other is not client)

    def settle_arm(self, arming: Coroutine[Any, Any, None]) -> None:
        """Settle whose a lease is, while the client that arms is held."""
        self._run(arming)

    # Groups

    def naming(self, slot: Slot, command: str, settings: GroupSettings | None = None) -> Callable[[bool], None]:
        """Keep a slot for its group as long as a request of the client names it.

        Args:
            slot: the slot.
            command: ``GS``, ``GN``, ``GX`` or ``GP``.
            settings: those of a ``GS``.

        Returns:
            What is to be called when the request is over, with whether the gateway has executed it.
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
            # What was asked for before it was executed before it, also where that is answered later.
            while executed and change in slot.changes:
                earlier = slot.changes.popleft()
                # The client may have left meanwhile.
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
        """Stop publication of a slot, also where its client could not stop it."""
        slot.change(running=False)
        slot.stopping = True
        self._run(self._stop_in_this_session(slot))

    async def _stop_in_this_session(self, slot: Slot) -> None:
        # A new session has stopped all groups.
        if self.connected:
            with contextlib.suppress(UnityLinkError):
                await self._do("GX", slot.text)
        slot.stopping = False
        self.slots.settle(slot)

    # Send-immediate

    def settle_mode(self) -> None:
        """Set the gateway to the send-immediate mode that its clients want.

        It has one mode for all: whoever wants answers at once gets them.
        """
        if self._changing_mode is None or self._changing_mode.done():
            self._changing_mode = self._run(self._change_mode())

    async def _change_mode(self) -> None:
        while self._flow.stream is not None and (mode := self._wanted_mode()) != self._mode:
            self._mode = mode
            with contextlib.suppress(UnityLinkError):
                await self._do("I", b"%02X" % mode)
                # A new session, in which it was executed, may have begun meanwhile.
                self._mode = mode
            if self._flow.stream is not None:
                await self._flow.stream.choose_send_immediate(_MODE_NAMES[mode])

    def _wanted_mode(self) -> int:
        modes = {client.mode for client in self.clients} - {None} or {_ADAPTIVE}
        return next(mode for mode in (_ALWAYS, _ADAPTIVE, _OFF) if mode in modes)

    # The gateway

    async def _do(self, command: str, fields: bytes) -> None:
        """Submit a request of the server's own."""
        await self._flow.answer(Request(self._session.codec, command, fields, 0, of_session=True))

    def _run(self, errand: Coroutine[Any, Any, None]) -> asyncio.Task[None]:
        """Do something that no request waits for; a connection that fails it tells so itself."""
        task = self.loop.create_task(errand)
        self._errands.add(task)
        task.add_done_callback(self._forget)
        return task

    def _forget(self, task: asyncio.Task[None]) -> None:
        self._errands.discard(task)
        if not task.cancelled():
            task.exception()

    def _begin(self, codec: HostCodec) -> None:
        """Take the description of the gateway for clients, but for what is between it and here."""
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
        """End for good where the gateway has another map than the spec that was given."""
        try:
            check_gateway(interface, self)
        except UnsupportedError as error:
            if not self.ended.done():
                self.ended.set_exception(ConnectError(str(error)))
                self.ended.exception()

    async def _restore(self) -> None:
        """Set up groups and mode in a new session; then let requests through.

        Clients come, leave and ask meanwhile. What they ask for waits, so that it is executed behind all this.
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
        """Set up a slot in a new session as it was in the one before, as far as its client wants it to the end."""
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
        """Execute a request without which the session is of no use.

        Raises:
            LinkLostError: where it was not executed; the session has ended.
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
            self._patience = self.loop.call_later(PATIENCE, self._lose_patience)
        self._say(f"the gateway is away: {reason}")

    def _gateway_was_reset(self, event: Interrupted) -> None:
        """End the session of every client, and forget their groups.

        What was sent has ended before, or is kept to be sent again, and the next session is not open yet.
        """
        for client in list(self.clients):
            client.lose_session()
        if self.leases is not None:
            self.leases.reset()
        super()._gateway_was_reset(event)

    def _unreachable(self, error: BaseException | None) -> None:
        self.tried.set()
        self._say(f"waiting for the gateway: {error}")

    def _lose_patience(self) -> None:
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
        """Report, the same thing once."""
        if text != self._last_words:
            self._last_words = text
            self._report(text)

    async def finish(self) -> None:
        """Hang up on all clients, leave the gateway as it is without them, and end."""
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
