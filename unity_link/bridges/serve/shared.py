"""The one link, and all who share it.

While the gateway is away, requests wait `PATIENCE` seconds for it; then they are answered by error 05, and so is every
further one until it is back. So a short interruption is not seen, a longer one does not end any client, and no write is
executed long after it was asked for.
"""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

import msgspec

from unity_link.bridges.serve.groups import Slots
from unity_link.bridges.serve.turns import Turns
from unity_link.errors import ArgumentError, ConnectError, GatewayError, LinkLostError, UnansweredError
from unity_link.link.connection import Connection, Reconnect
from unity_link.link.requests import Request
from unity_link.protocol.configuration import Feature
from unity_link.protocol.messages import Codec

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.bridges.serve.client import Client
    from unity_link.bridges.serve.door import Door
    from unity_link.bridges.serve.groups import ClientGroup, Slot
    from unity_link.transport import DriverUrl, Medium

PATIENCE = 2.0
"""Seconds that requests wait for a gateway that is away: less than what a host waits in silence."""
PAUSES = Reconnect(longest_pause=2.0)
_OFF, _ALWAYS, _ADAPTIVE = range(3)
_MODE_NAMES = ("off", "always", "adaptive")


class SharedLink(Connection):
    """A link whose requests are those of clients.

    Args:
        target: the URL of a gateway, or one of this process.
        report: is told in a sentence when the gateway comes and goes.
    """

    def __init__(self, target: DriverUrl | Medium, report: Callable[[str], None]) -> None:
        super().__init__(target, PAUSES)
        self.loop = asyncio.get_running_loop()
        self.codec: Codec | None = None
        """The messages towards clients; None before the gateway has said for the first time what it is."""
        self.away = True
        """Whether requests are refused because the gateway has been away too long."""
        self.turns = Turns(self._exchange)
        self.slots: Slots
        self.clients: set[Client] = set()
        self.callers: set[Door] = set()
        """Connections that have not been let in yet."""
        self.ended: asyncio.Future[None] = self.loop.create_future()
        """Raises when the link has ended for good."""
        self._report = report
        self._mode = _ADAPTIVE
        self._lost_at = 0.0
        self._last_words = ""
        self._patience: asyncio.TimerHandle | None = None
        self._errands: set[asyncio.Future[None]] = set()

    # Clients

    def join(self, client: Client) -> None:
        """Take in a client."""
        self.clients.add(client)

    def leave(self, client: Client) -> None:
        """Let a client go, and free what it has set up."""
        self.clients.discard(client)
        for group in client.conversation.groups.values() if client.conversation is not None else ():
            self._end_group(group)
        mode = self.change_mode()
        if mode is not None and not self._exchange.suspended:
            self._errand("I", mode)

    def change_mode(self) -> int | None:
        """Give the send-immediate mode that the gateway must have, where that is another than before.

        The gateway has one mode for all: whoever wants answers at once gets them.
        """
        modes = {client.conversation.mode for client in self.clients if client.conversation} or {_ADAPTIVE}
        mode = next(mode for mode in (_ALWAYS, _ADAPTIVE, _OFF) if mode in modes)
        if mode == self._mode:
            return None
        self._mode = mode
        if self._stream is not None:
            self._keep(self.loop.create_task(self._stream.choose_send_immediate(_MODE_NAMES[mode])))
        return mode

    def _end_group(self, group: ClientGroup) -> None:
        slot = group.slot
        if slot is None:
            return
        slots, running = self.slots, group.running
        slots.abandon(slot)
        if (running or slot.busy) and not self._exchange.suspended:
            slot.stopping = True
            self._errand("GX", int(slot.text, 16)).add_done_callback(lambda _: self._stopped(slot))
        else:
            slots.settle(slot)

    def _stopped(self, slot: Slot) -> None:
        slot.stopping = False
        self.slots.settle(slot)

    # The gateway

    def _errand(self, command: str, *values: int) -> asyncio.Future[None]:
        """Have a request of the server's own done."""
        request = Request(self._codec, command, self._codec.fields(command, *values), 0, self.loop)
        self._exchange.submit(request)
        self._keep(request.future)
        return request.future

    def _keep(self, errand: asyncio.Future[None]) -> None:
        """Hold something that nobody waits for until it is over, however it ends."""
        self._errands.add(errand)
        errand.add_done_callback(self._forget)

    def _forget(self, errand: asyncio.Future[None]) -> None:
        self._errands.discard(errand)
        if not errand.cancelled():
            errand.exception()

    def _begin(self, codec: Codec) -> None:
        """Say to clients what the gateway says, but for what is between it and here."""
        if self.codec is None:
            features = codec.info.features & ~Feature.ADDRESSED | Feature.FLOW_CONTROL
            self.codec = Codec(msgspec.structs.replace(codec.info, features=features))
            self.slots = Slots(self._exchange, codec.info.groups)

    async def _restore(self) -> None:
        """Set up the groups that run, and the mode, in a new session; then let requests through."""
        missed = self.loop.time() - self._lost_at
        for slot in list(self.slots.held):
            group = slot.group
            slot.stopping = False
            if slot.idle():
                self.slots.let_go(slot)
            elif group is not None:
                await self._ask("GS", slot.text + group.settings)
                group.begin_anew(missed)
                if group.running:
                    self.slots.listen(slot)
                    await self._ask("GN", slot.text)
        if self._mode != _ADAPTIVE:
            await self._ask("I", b"%02X" % self._mode)
        self.away = False
        self.turns.release()
        if self._patience is not None:
            self._patience.cancel()
            self._patience = None
        self._say(f"the gateway answers: {self.gateway.data_bits} data bits, {self.gateway.address_bits} address bits")

    async def _ask(self, command: str, fields: bytes) -> None:
        request = Request(self._codec, command, fields, 0, self.loop)
        self._exchange.submit(request)
        try:
            await request.future
        except GatewayError as error:
            raise LinkLostError(f"the groups of the clients could not be set up again ({error})") from error
        except UnansweredError as error:
            raise LinkLostError(error.reason) from error

    def _interrupted(self, reason: str) -> None:
        self.turns.hold()
        if not self.away and self._patience is None:
            self._lost_at = self.loop.time()
            self._patience = self.loop.call_later(PATIENCE, self._lose_patience)
        self._say(f"the gateway is away: {reason}")

    def _unreachable(self, error: BaseException | None) -> None:
        self._say(f"waiting for the gateway: {error}")

    def _lose_patience(self) -> None:
        self.away = True
        for client in self.clients:
            client.refuse_all()

    def _ended(self, error: LinkLostError) -> None:
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
        for caller in list(self.callers):
            caller.hang_up()
        for client in list(self.clients):
            client.hang_up()
            self.leave(client)
        if self._errands and not self._exchange.suspended:
            await asyncio.wait(self._errands, timeout=1.0)
        if self._patience is not None:
            self._patience.cancel()
        await self.aclose()
