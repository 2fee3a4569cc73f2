"""The groups of all clients, on the groups of the one gateway.

Every client has all group numbers to itself. A `ClientGroup` is what one client has set up; it keeps the settings here,
and holds a group of the gateway, a `Slot`, from when it is started or published first. A slot whose group has stopped
stays with it until another needs it. So a client may set up as many groups as it likes, and only those that run at the
same time have to fit into the gateway.

A slot changes hands only when no request names it and it does not publish. Its samples go to a group from the answer to
the group's `GS` on, behind which a gateway sends no sample of what the slot was before, and to none from the moment at
which the group gives it up.

The sequence number that a client sees is the gateway's plus an offset: the gateway's begins anew when a slot changes
hands or the gateway was lost, the client's goes on. Samples that the client does not take are not sent, and their
numbers are missing, as if the gateway had found no room for them.
"""

from __future__ import annotations

from collections import deque
from functools import partial
from typing import TYPE_CHECKING, Protocol

from unity_link.protocol.wire.messages import SAMPLE_HEAD, TIMESTAMP_DIGITS, GroupFlag

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.protocol.host.group_table import GroupTable
    from unity_link.protocol.wire.messages import Codec

_SEQUENCE = slice(3, 5)


class Taker(Protocol):
    """A consumer of samples."""

    def sample(self, frame: bytes) -> None:
        """Take the frame of a publish."""


class GroupSettings:
    """A client's settings of a group, and the form of the group's samples under them.

    The gateway publishes checked frames in any case; a plain one would reach the server without protection.
    """

    __slots__ = ("_framing", "_is_plain", "fields", "has_trigger", "seconds_each", "size")

    def __init__(self, codec: Codec, flags: int, divisor: int, addresses: list[int]) -> None:
        layout = codec.fields("GS", 0, flags & ~GroupFlag.PLAIN, divisor, len(addresses), addresses)
        self.fields = layout[2:]
        """Fields of `GS` behind the number, as the gateway gets them."""
        self._is_plain = bool(flags & GroupFlag.PLAIN)
        self._framing = codec.framing
        self.has_trigger = bool(flags & GroupFlag.TRIGGER)
        stamp = TIMESTAMP_DIGITS if flags & GroupFlag.TIMESTAMP else 0
        self.size = SAMPLE_HEAD + stamp + codec.info.data_digits * len(addresses)
        """Characters of the body of a sample."""
        self.seconds_each = divisor / codec.info.base_frequency_hz if flags & GroupFlag.PERIODIC else None

    def frame(self, body: bytes, seed: int) -> bytes:
        """Return the frame of a sample for the client, in whose session it has a seed."""
        return self._framing.plain_reply(body) if self._is_plain else self._framing.checked(body, seed)


class ClientGroup:
    """A group as its client has set it up.

    Args:
        number: the client's number of it.
        taker: the client.
        settings: what it is set up to first.
    """

    def __init__(self, number: int, taker: Taker, settings: GroupSettings) -> None:
        self.number = number
        self.settings = settings
        """Settings that the client asked for last."""
        self.seed = 0
        """Seed of its samples: that of the session in which it was set up, started or published last."""
        self.slot: Slot | None = None
        self._head = b"P%02X" % number
        self._taker = taker
        self._begun: GroupSettings | None = None
        self._offset = 0
        self._next = 0

    def begin(self, settings: GroupSettings, seconds_missed: float) -> None:
        """Take the samples of settings that the gateway has just stored, where its sequence stands at 00.

        The client's sequence begins anew with new settings; otherwise it goes on, and what was due in the seconds
        missed was lost.
        """
        if settings is not self._begun:
            self._begun, self._next = settings, 0
        elif seconds_missed and settings.seconds_each is not None:
            self._next += max(1, int(seconds_missed / settings.seconds_each))
        self._offset = self._next

    def receive(self, body: bytes) -> None:
        """Hand on a publish of the gateway under the client's numbers."""
        settings = self._begun
        if settings is None or len(body) != settings.size:
            return
        try:
            sequence = int(body[_SEQUENCE], 16) + self._offset & 0xFF
        except ValueError:
            return
        self._next = sequence + 1
        self._taker.sample(settings.frame(b"%b%02X%b" % (self._head, sequence, body[SAMPLE_HEAD:]), self.seed))


class Slot:
    """A group of the gateway.

    `settings` and `running` are what the gateway has confirmed: requests on their way change nothing, so what a new
    session has to set up again is known at any time.
    """

    __slots__ = ("busy", "changes", "group", "lost_at", "number", "running", "settings", "stopping", "text")

    def __init__(self, number: int) -> None:
        self.number = number
        self.text = b"%02X" % number
        self.group: ClientGroup | None = None
        """The group that holds it; None also where its client has left and it may still publish."""
        self.settings: GroupSettings | None = None
        """Settings that the gateway has stored for the group."""
        self.running = False
        """True if the gateway publishes it, or did when it was lost."""
        self.lost_at: float | None = None
        """Instant at which the gateway was lost while this was running; None once it is set up again."""
        self.busy = 0
        """Requests that name it and are not over."""
        self.changes: deque[Callable[[], None]] = deque()
        """Changes that requests of the client make once they are known to be executed, in their order."""
        self.stopping = False
        """True if the server is stopping it on its own account."""

    def idle(self) -> bool:
        """Return whether it can change hands: nothing is under way, and it does not publish."""
        return not self.busy and not self.stopping and not self.running

    def change(self, *, running: bool) -> None:
        """Note that the gateway publishes it from now on, or does not."""
        self.running, self.lost_at = running, None


class Slots:
    """All groups of the gateway, and the holder of each. The one that was let go longest ago is taken first.

    Args:
        table: of the link's session, which tells whose a sample is.
        count: how many groups the gateway has.
    """

    def __init__(self, table: GroupTable, count: int) -> None:
        self._table = table
        self._free = deque(Slot(number) for number in range(count))
        self.held: list[Slot] = []
        """Slots that are not free."""

    def take(self, group: ClientGroup) -> Slot | None:
        """Return a slot to a group, if there is one left that does not publish for another.

        A trigger is that of one group of the gateway, so a group that has one gets the slot of its own number.
        """
        wanted = group.number if group.settings.has_trigger else None
        slot = next((slot for slot in self._free if wanted in (None, slot.number)), None)
        if slot is None:
            slot = next((slot for slot in self.held if slot.idle() and wanted in (None, slot.number)), None)
            if slot is None:
                return None
            self.let_go(slot)
        self._free.remove(slot)
        slot.group, group.slot = group, slot
        self.held.append(slot)
        return slot

    def storing(self, slot: Slot) -> Callable[[], None]:
        """Return what is to be called as soon as the gateway is known to have stored settings for a slot's group.

        From then on its samples are of the new settings: those that come in the same read, too.
        """
        return partial(self._table.deliver, slot.text, slot.group)

    def begin(self, slot: Slot, settings: GroupSettings, seconds_missed: float = 0.0) -> None:
        """Hand the publishes of a slot to its group, for which the gateway has just stored settings."""
        assert slot.group is not None
        slot.settings = settings
        slot.group.begin(settings, seconds_missed)
        self._table.deliver(slot.text, slot.group)

    def abandon(self, slot: Slot) -> None:
        """Take a slot from its group; what it publishes from now on is dropped."""
        self._table.drop(slot.text)
        slot.settings = None
        slot.change(running=False)
        if slot.group is not None:
            slot.group.slot = None
            slot.group = None

    def forget(self, group: ClientGroup) -> None:
        """Take its slot from a group that the gateway has forgotten; it is free when no request names it any more."""
        slot = group.slot
        if slot is not None:
            self.abandon(slot)
            self.settle(slot)

    def let_go(self, slot: Slot) -> None:
        """Make an idle slot free."""
        self.abandon(slot)
        self.held.remove(slot)
        self._free.append(slot)

    def let_go_idle(self) -> None:
        """Make all idle slots free: a gateway that was lost may have forgotten what they are set up to."""
        for slot in list(self.held):
            if slot.idle():
                self.let_go(slot)

    def settle(self, slot: Slot) -> None:
        """Make a slot free as soon as it is idle and there is nothing that a group holds it for."""
        if slot.settings is None and slot.idle() and slot in self.held:
            self.let_go(slot)

    def interrupted(self, now: float) -> None:
        """Note that the gateway was lost, and publishes nothing."""
        for slot in self.held:
            if slot.running and slot.lost_at is None:
                slot.lost_at = now
