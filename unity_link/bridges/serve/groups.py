"""The groups of all clients, mapped to the groups of the one gateway.

Each client can use all group numbers. A `ClientGroup` has the settings of one group of one client. It gets a group of
the gateway, a `Slot`, when it is first started or published. After the group has stopped, it keeps the slot until
another group needs it. So a client may set up any number of groups, and only those that run at the same time must fit
into the gateway.

A slot gets another holder only if no request names it and it does not publish. Samples of a slot belong to a group from
the answer to the group's `GS` on, because after this answer a gateway sends no samples of earlier settings. As soon as
the group gives up the slot, its samples are dropped.

The sequence number that a client sees is the gateway's plus an offset: the gateway's begins again when a slot gets
another holder or the gateway was lost, the client's continues. Samples that the client does not read are not sent.
Their numbers are missing, as if the gateway had had no room for them.
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
        """Send the frame of a sample."""


class GroupSettings:
    """A client's settings of a group, and the form of its samples.

    The gateway always publishes checked frames: a plain one would reach the server without a CRC.
    """

    __slots__ = ("_framing", "_is_plain", "fields", "has_trigger", "seconds_each", "size")

    def __init__(self, codec: Codec, flags: int, divisor: int, addresses: list[int]) -> None:
        layout = codec.fields("GS", 0, flags & ~GroupFlag.PLAIN, divisor, len(addresses), addresses)
        self.fields = layout[2:]
        """Fields of `GS` after the number, as they are sent to the gateway."""
        self._is_plain = bool(flags & GroupFlag.PLAIN)
        self._framing = codec.framing
        self.has_trigger = bool(flags & GroupFlag.TRIGGER)
        stamp = TIMESTAMP_DIGITS if flags & GroupFlag.TIMESTAMP else 0
        self.size = SAMPLE_HEAD + stamp + codec.info.data_digits * len(addresses)
        """Length of the body of a sample, in characters."""
        self.seconds_each = divisor / codec.info.base_frequency_hz if flags & GroupFlag.PERIODIC else None

    def frame(self, body: bytes, seed: int) -> bytes:
        """Return the frame of a sample for the client; `seed` is the CRC seed of the client's session."""
        return self._framing.plain_reply(body) if self._is_plain else self._framing.checked(body, seed)


class ClientGroup:
    """A group as one client has set it up.

    Args:
        number: number of the group for the client.
        taker: the client.
        settings: first settings of the group.
    """

    def __init__(self, number: int, taker: Taker, settings: GroupSettings) -> None:
        self.number = number
        self.settings = settings
        """Latest settings from the client."""
        self.seed = 0
        """CRC seed of its samples: that of the session in which the group was last set up, started or published."""
        self.slot: Slot | None = None
        self._head = b"P%02X" % number
        self._taker = taker
        self._begun: GroupSettings | None = None
        self._offset = 0
        self._next = 0

    def begin(self, settings: GroupSettings, seconds_missed: float) -> None:
        """Begin to pass on samples with settings that the gateway has just stored, with its sequence at 00.

        With new settings the client's sequence begins again, too. Otherwise it continues after the samples that were
        lost in `seconds_missed`.
        """
        if settings is not self._begun:
            self._begun, self._next = settings, 0
        elif seconds_missed and settings.seconds_each is not None:
            self._next += max(1, int(seconds_missed / settings.seconds_each))
        self._offset = self._next

    def receive(self, body: bytes) -> None:
        """Pass on a sample of the gateway, with the client's group and sequence numbers."""
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

    `settings` and `running` have the state that the gateway has confirmed. Requests in flight do not change them, so
    the server always knows the state that it must restore in a new session.
    """

    __slots__ = ("busy", "changes", "group", "lost_at", "number", "running", "settings", "stopping", "text")

    def __init__(self, number: int) -> None:
        self.number = number
        self.text = b"%02X" % number
        self.group: ClientGroup | None = None
        """Group that holds the slot; None also if its client has left, though the slot may still publish."""
        self.settings: GroupSettings | None = None
        """Settings that the gateway has stored for `group`."""
        self.running = False
        """True if the gateway publishes the slot, or did so when it was lost."""
        self.lost_at: float | None = None
        """Instant at which the gateway was lost while it published the slot; None after it was set up again."""
        self.busy = 0
        """Number of requests in flight that name the slot."""
        self.changes: deque[Callable[[], None]] = deque()
        """Changes to make, in order, when the client's requests are known to be executed."""
        self.stopping = False
        """True while the server itself is stopping the slot."""

    def idle(self) -> bool:
        """Return whether the slot can get another holder: no request names it, and it does not publish."""
        return not self.busy and not self.stopping and not self.running

    def change(self, *, running: bool) -> None:
        """Note that the gateway publishes the slot from now on, or no longer."""
        self.running, self.lost_at = running, None


class Slots:
    """All groups of the gateway, with their holders. The slot that was freed first is taken first.

    Args:
        table: group table of the link's session, which has the receiver of each group's samples.
        count: number of groups of the gateway.
    """

    def __init__(self, table: GroupTable, count: int) -> None:
        self._table = table
        self._free = deque(Slot(number) for number in range(count))
        self.held: list[Slot] = []
        """Slots with a holder, and those that are still stopping."""

    def take(self, group: ClientGroup) -> Slot | None:
        """Return a slot for a group: a free one, or one whose group does not run; None if there is none.

        A trigger belongs to one group of the gateway, so a group with a trigger must get the slot of its own number.
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
        """Return a function to call as soon as the gateway is known to have stored settings for a slot's group.

        From then on samples have the new settings, even those in the same read.
        """
        return partial(self._table.deliver, slot.text, slot.group)

    def begin(self, slot: Slot, settings: GroupSettings, seconds_missed: float = 0.0) -> None:
        """Pass the samples of a slot to its group, for which the gateway has just stored settings."""
        assert slot.group is not None
        slot.settings = settings
        slot.group.begin(settings, seconds_missed)
        self._table.deliver(slot.text, slot.group)

    def abandon(self, slot: Slot) -> None:
        """Take a slot from its group; later samples of the slot are dropped."""
        self._table.drop(slot.text)
        slot.settings = None
        slot.change(running=False)
        if slot.group is not None:
            slot.group.slot = None
            slot.group = None

    def forget(self, group: ClientGroup) -> None:
        """Take the slot from a group that the gateway no longer has; free the slot when no request names it."""
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
        """Free all idle slots, because a gateway that was lost may have lost their settings."""
        for slot in list(self.held):
            if slot.idle():
                self.let_go(slot)

    def settle(self, slot: Slot) -> None:
        """Free a slot if it is idle and has no settings."""
        if slot.settings is None and slot.idle() and slot in self.held:
            self.let_go(slot)

    def interrupted(self, now: float) -> None:
        """Note that the gateway was lost at an instant, and does not publish."""
        for slot in self.held:
            if slot.running and slot.lost_at is None:
                slot.lost_at = now
