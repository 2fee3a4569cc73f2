"""The events of a session: what has come of a call of it, in the order in which it happened.

`Event` is the closed set of them. Who takes events names every class, so that mypy reports one that is forgotten.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from unity_link.errors import GatewayResetError, LinkLostError, UnityLinkError
    from unity_link.protocol.wire.configuration import GatewayInfo


class Awaited:
    """Event: something that a call awaits has ended, or is on its way where that is all that is awaited."""

    __slots__ = ()
    answer: Any
    error: UnityLinkError | None
    waiter: Any
    """Future of the call, if there is one; the session does not look at it."""

    def settle(self) -> None:
        """Set the result or the error of what a call awaits."""
        waiter = self.waiter
        if waiter is None or waiter.done():
            return
        if self.error is None:
            waiter.set_result(self.answer)
        else:
            waiter.set_exception(self.error)


class PostedFailure(NamedTuple):
    """Event: posted writes have failed that no call waits for any more."""

    error: UnityLinkError
    writes: int
    """Number of writes."""
    poster: object
    """Task or thread that has posted them."""


# Of groups


class Sampled(NamedTuple):
    """Event: a sample has come."""

    owner: Any
    """Object that was named when the group was set up; so in all events of groups."""
    body: bytes
    arrived: float
    """On the clock of the session."""


class SampledRows(NamedTuple):
    """Event: samples of one group have come, side by side."""

    owner: Any
    bodies: NDArray[np.uint8]
    """Shape (n, length)."""
    arrived: float


class SampledTogether(NamedTuple):
    """Event: samples of several groups have come, side by side."""

    owners: list[Any]
    """Owners of the samples, in their order."""
    parts: list[tuple[NDArray[np.intp], NDArray[np.uint8]]]
    """Samples of each length: their places among all, and their bodies, shape (n, length)."""
    arrived: float


class GroupBegun(NamedTuple):
    """Event: the gateway has stored the settings of a group, and its sequence stands at 00."""

    owner: Any


# Of sessions


class Opened(NamedTuple):
    """Event: a session has begun with a gateway."""

    info: GatewayInfo


class GroupsRestored(NamedTuple):
    """Event: every group that is held is set up again in a new session, or could not be."""

    error: UnityLinkError | None


class Interrupted(NamedTuple):
    """Event: the gateway was reset, in a session or between two; the next is being opened on the same connection."""

    error: GatewayResetError


class Unusable(NamedTuple):
    """Event: the connection is of no more use."""

    error: UnityLinkError


class Taken(NamedTuple):
    """Event: another program has begun a session with the gateway, which is left to it."""

    error: LinkLostError


GroupEvent = Sampled | SampledRows | SampledTogether | GroupBegun
SessionEvent = Opened | GroupsRestored | Interrupted | Unusable | Taken
UnsolicitedEvent = GroupEvent | SessionEvent | PostedFailure
"""Events that are nothing a call awaits."""
Event = Awaited | UnsolicitedEvent
Events = list[Event]
