"""The groups of all clients, on the groups of the one gateway.

Every client has all group numbers to itself. A `ClientGroup` is what one client has set up; it keeps the settings here,
and holds a group of the gateway, a `Slot`, from when it is started or published first. A slot whose group has stopped
stays with it until another needs it. So a client may set up as many groups as it likes, and only those that run at the
same time have to fit into the gateway.

The sequence number that a client sees is the gateway's plus an offset: the gateway's begins anew when a slot changes
hands or the gateway was lost, the client's goes on. Samples that the client does not take are not sent, and their
numbers are missing, as if the gateway had found no room for them.
"""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Protocol

from unity_link.protocol.messages import GroupFlag

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.link.exchange import Exchange
    from unity_link.protocol.messages import Codec

_SEQUENCE = slice(3, 5)
_HEAD = 5
_TIMESTAMP_DIGITS = 8


class Taker(Protocol):
    """Who takes samples."""

    def sample(self, frame: bytes) -> None:
        """Take the frame of a publish."""


class ClientGroup:
    """A group as its client has set it up.

    Args:
        number: the client's number of it.
        taker: the client.
    """

    def __init__(self, number: int, taker: Taker) -> None:
        self.running = False
        self.slot: Slot | None = None
        self.settings = b""
        """Fields of `GS` behind the number, as the gateway gets them."""
        self._head = b"P%02X" % number
        self._taker = taker
        self._frame: Callable[[bytes], bytes]
        self._size = 0
        self._offset = 0
        self._next = 0
        self._seconds_each: float | None = None

    def set_up(self, codec: Codec, flags: int, divisor: int, addresses: list[int]) -> None:
        """Take new settings: the group stops, and its sequence begins anew.

        The gateway publishes checked frames in any case; a plain one would reach the server without protection.
        """
        layout = codec.fields("GS", 0, flags & ~GroupFlag.PLAIN, divisor, len(addresses), addresses)
        self.settings = layout[2:]
        self.running = False
        self._frame = codec.framing.plain_reply if flags & GroupFlag.PLAIN else codec.framing.checked
        stamp = _TIMESTAMP_DIGITS if flags & GroupFlag.TIMESTAMP else 0
        self._size = _HEAD + stamp + codec.info.data_digits * len(addresses)
        self._seconds_each = divisor / codec.info.base_frequency_hz if flags & GroupFlag.PERIODIC else None
        self._offset = self._next = 0

    def begin_anew(self, seconds_missed: float = 0.0) -> None:
        """Go on with the client's sequence where the gateway's begins at 00; what was due meanwhile was lost."""
        missed = 0
        if seconds_missed and self._seconds_each is not None:
            missed = max(1, int(seconds_missed / self._seconds_each))
        self._offset = self._next + missed & 0xFF

    def receive(self, body: bytes, _: float) -> None:
        """Hand on a publish of the gateway under the client's numbers."""
        if len(body) != self._size:
            return
        try:
            sequence = int(body[_SEQUENCE], 16) + self._offset & 0xFF
        except ValueError:
            return
        self._next = sequence + 1
        self._taker.sample(self._frame(b"%b%02X%b" % (self._head, sequence, body[_HEAD:])))


class Slot:
    """A group of the gateway."""

    __slots__ = ("busy", "group", "stopping", "text")

    def __init__(self, number: int) -> None:
        self.text = b"%02X" % number
        self.group: ClientGroup | None = None
        """Who holds it; None also where its client has left and it may still publish."""
        self.busy = 0
        """Requests of its client that name it and are not over."""
        self.stopping = False
        """Whether it is being stopped for a client that has left."""

    def idle(self) -> bool:
        """Say whether it can change hands: nothing is under way, and it does not publish."""
        return not self.busy and not self.stopping and (self.group is None or not self.group.running)


class Slots:
    """All groups of the gateway, and who holds each. The one that was let go longest ago is taken first.

    Args:
        exchange: of the link, which hands publishes out.
        count: how many groups the gateway has.
    """

    def __init__(self, exchange: Exchange, count: int) -> None:
        self._publishes = exchange.publishes
        self._free = deque(Slot(number) for number in range(count))
        self.held: list[Slot] = []
        """Slots that are not free."""

    def take(self, group: ClientGroup) -> Slot | None:
        """Give a slot to a group, if there is one left that does not publish for another."""
        if not self._free:
            idle = next((slot for slot in self.held if slot.idle()), None)
            if idle is None:
                return None
            self.let_go(idle)
        slot = self._free.popleft()
        slot.group, group.slot = group, slot
        self.held.append(slot)
        return slot

    def abandon(self, slot: Slot) -> None:
        """Take a slot from its group, whose client has left."""
        self.silence(slot)
        if slot.group is not None:
            slot.group.slot = None
            slot.group = None

    def let_go(self, slot: Slot) -> None:
        """Make an idle slot free."""
        self.abandon(slot)
        self.held.remove(slot)
        self._free.append(slot)

    def settle(self, slot: Slot) -> None:
        """Make a slot free as soon as it is idle and nobody holds it."""
        if slot.group is None and slot.idle() and slot in self.held:
            self.let_go(slot)

    def listen(self, slot: Slot) -> None:
        """Hand the publishes of a slot to its group."""
        assert slot.group is not None
        self._publishes[slot.text] = slot.group.receive

    def silence(self, slot: Slot) -> None:
        """Hand the publishes of a slot to nobody."""
        self._publishes.pop(slot.text, None)
