"""The groups of a gateway, and their holders in this host (docs/protocol.md, "Groups: samples without asking").

1. A group is set up by ``gs`` and started by ``gn``, in each session as long as it is held.
2. Samples belong to the holder from the answer to its ``gs`` on. Earlier samples were taken for a former holder.
3. A released group can be held again at once, because the request that stops it precedes the new ``gs`` in the order of
   requests.
"""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any

from unity_link.errors import LinkLostError, UnityLinkError, UnsupportedError
from unity_link.protocol.host.events import Awaited, GroupBegun, GroupsRestored
from unity_link.protocol.host.requests import SessionRequest

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.protocol.host.events import Events
    from unity_link.protocol.host.host_codec import HostCodec
    from unity_link.protocol.wire.path import Path


class HeldGroup(Awaited):
    """A held group with its settings; also the event that it was started for the first time, or refused.

    Args:
        number: number of the group in the gateway.
        settings: hex digits of the fields of ``gs`` after the number.
        length: characters of the body of a sample.
        owner: receiver of its samples; the session only passes it on in events.
    """

    __slots__ = ("error", "length", "number", "owner", "settings", "started", "text", "waiter")
    answer = None

    def __init__(self, number: int, settings: bytes, length: int, owner: Any) -> None:
        self.number = number
        self.text = b"%02X" % number
        self.settings = settings
        self.length = length
        self.owner = owner
        self.waiter: Any = None
        self.error: UnityLinkError | None = None
        """Reason why the group was not set up and is not held any more; None otherwise."""
        self.started = False
        """True if the group was started in this session or an earlier one."""


class GroupTable:
    """All groups of a gateway.

    Args:
        count: number of groups of the gateway.
        submit: submits a request to the session.
    """

    def __init__(self, count: int, submit: Callable[[SessionRequest, Events], None]) -> None:
        self.begun: dict[bytes, HeldGroup] = {}
        """The groups that the gateway has set up in this session, by their number as two hex digits."""
        self.path: Path | None = None
        """Longest datagram of the network; None if frames are not in datagrams."""
        self._count = count
        self._free = deque(range(count))
        self._held: dict[int, HeldGroup] = {}
        self._submit = submit
        self._restoring: set[int] | None = None

    def hold(self, settings: bytes, length: int, owner: Any, number: int | None = None) -> HeldGroup:
        """Hold a free group: the one with `number`, or the one that was released first.

        Args:
            settings: hex digits of the fields of ``gs`` after the number.
            length: characters of the body of a sample.
            owner: receiver of its samples.
            number: number of the group, None for any.

        Raises:
            UnsupportedError: if no group is free, or the group `number` is not.
        """
        if number is not None:
            self._take_out(number)
        elif not self._free:
            raise UnsupportedError(
                f"all {self._count} groups of the gateway are in use: end a subscription first, "
                "or put its addresses into one"
            )
        chosen = self._free.popleft() if number is None else number
        group = HeldGroup(chosen, settings, length, owner)
        self._held[group.number] = group
        return group

    @property
    def sample_bytes(self) -> int:
        """Characters of one sample of each held group, together."""
        return sum(group.length for group in self._held.values())

    def _take_out(self, number: int) -> None:
        if not 0 <= number < self._count:
            raise UnsupportedError(
                f"group {number} was asked for, and the gateway has those from 0 to {self._count - 1}"
            )
        try:
            self._free.remove(number)
        except ValueError:
            raise UnsupportedError(
                f"group {number} of the gateway, whose trigger was asked for, is in use by another subscription: begin "
                "this one first, or end that one"
            ) from None

    def release(self, group: HeldGroup) -> bool:
        """Release a group; return whether it was held."""
        if self._held.get(group.number) is not group:
            return False
        del self._held[group.number]
        self.begun.pop(group.text, None)
        self._free.append(group.number)
        return True

    def deliver(self, text: bytes, owner: Any) -> None:
        """Pass the samples of a group that is not held to `owner`, until the session ends."""
        self.begun[text] = HeldGroup(int(text, 16), b"", 0, owner)

    def drop(self, text: bytes) -> None:
        """Drop the samples of a group from now on, after `deliver`."""
        self.begun.pop(text, None)

    # Sessions

    def start(self, codec: HostCodec, events: Events) -> None:
        """Set up all held groups in a new session, whose beginning has stopped them."""
        self.begun.clear()
        self._restoring = {*self._held}
        for group in list(self._held.values()):
            self.set_up(codec, group, events)
        self._settle(None, None, events)

    def set_up(self, codec: HostCodec, group: HeldGroup, events: Events) -> None:
        """Set up a group and start it; it fails if its frames are longer than the network's datagrams."""
        path = self.path
        request = codec.head_sizes["GS"] + len(group.text) + len(group.settings)
        size = max(codec.framing.overhead + group.length, request)
        if path is not None and path.is_short and size > path.longest_frame:
            message = f"group {group.number} has frames of {size} bytes, {path.bound}: subscribe to fewer words"
            self._failed(group, UnsupportedError(message), events)
            return

        def stored(error: UnityLinkError | None, events: Events) -> None:
            if self._held.get(group.number) is not group:
                self._settle(group, None, events)
            elif error is not None:
                self._failed(group, error, events)
            else:
                self.begun[group.text] = group
                events.append(GroupBegun(group.owner))
                self._submit(SessionRequest(codec, "GN", group.text, started), events)

        def started(error: UnityLinkError | None, events: Events) -> None:
            if error is not None and self._held.get(group.number) is group:
                self._failed(group, error, events)
                return
            if error is None and not group.started:
                group.started = True
                events.append(group)
            self._settle(group, None, events)

        self._submit(SessionRequest(codec, "GS", group.text + group.settings, stored), events)

    def _failed(self, group: HeldGroup, error: UnityLinkError, events: Events) -> None:
        if isinstance(error, LinkLostError):
            # The next session sets it up again.
            self._restoring = None
        elif group.started:
            self._settle(group, error, events)
        else:
            self._settle(group, None, events)
            self.release(group)
            group.error = error
            events.append(group)

    def _settle(self, group: HeldGroup | None, error: UnityLinkError | None, events: Events) -> None:
        """Record that the set-up of a group in a new session has ended, with an error or None."""
        if self._restoring is None:
            return
        if group is not None:
            self._restoring.discard(group.number)
        if error is not None or not self._restoring:
            self._restoring = None
            events.append(GroupsRestored(error))

    def interrupted(self) -> None:
        """Record that the session has ended: drop all samples until the next session has set up their groups."""
        self.begun.clear()
        self._restoring = None

    def end(self) -> list[HeldGroup]:
        """Release all groups and return them, because the session has ended finally."""
        held = list(self._held.values())
        for group in held:
            self.release(group)
        return held
