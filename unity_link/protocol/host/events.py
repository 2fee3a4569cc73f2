"""The events that the methods of a `Session` return, in the order in which they happened.

`Event` is the closed set of event classes. Code that handles events matches every class and ends in `assert_never`, so
mypy reports a missing one.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from unity_link.errors import GatewayResetError, LinkLostError, UnityLinkError
    from unity_link.protocol.wire.configuration import GatewayInfo


class Awaited:
    """Event: a request, batch or group set-up that a call awaits has ended; a posted write has been sent."""

    __slots__ = ()
    answer: Any
    error: UnityLinkError | None
    waiter: Any
    """Future of the call, or None; the session does not use it."""

    def settle(self) -> None:
        """Set the result or the error of the call's future."""
        waiter = self.waiter
        if waiter is None or waiter.done():
            return
        if self.error is None:
            waiter.set_result(self.answer)
        else:
            waiter.set_exception(self.error)


class PostedFailure(NamedTuple):
    """Event: posted writes have failed, or their outcome is unknown; their calls have returned."""

    error: UnityLinkError
    writes: int
    """Number of posted writes."""
    poster: object
    """Task or thread that has posted them."""


# Events of groups


class Sampled(NamedTuple):
    """Event: a sample arrived."""

    owner: Any
    """Receiver of the samples, as given when the group was set up."""
    body: bytes
    arrived: float
    """Instant of arrival, on the clock of the session."""


class SampledRows(NamedTuple):
    """Event: consecutive samples of one group arrived."""

    owner: Any
    """Receiver of the samples, as given when the group was set up."""
    bodies: NDArray[np.uint8]
    """Bodies of the samples in order; shape (n, length)."""
    arrived: float
    """Instant of arrival, on the clock of the session."""


class SampledTogether(NamedTuple):
    """Event: consecutive samples of several groups arrived."""

    owners: list[Any]
    """Receiver of each sample, in order of arrival."""
    parts: list[tuple[NDArray[np.intp], NDArray[np.uint8]]]
    """For each length: the positions of its samples in `owners`, and their bodies, shape (n, length)."""
    arrived: float
    """Instant of arrival, on the clock of the session."""


class GroupBegun(NamedTuple):
    """Event: the gateway has stored the settings of a group; its next sample has the sequence number 00."""

    owner: Any
    """Receiver of the samples, as given when the group was set up."""


# Events of sessions


class Opened(NamedTuple):
    """Event: a session has begun with a gateway."""

    info: GatewayInfo


class GroupsRestored(NamedTuple):
    """Event: all held groups are set up in a new session; or the first failure among them."""

    error: UnityLinkError | None


class Interrupted(NamedTuple):
    """Event: the gateway was reset; the next session is being opened on the same connection."""

    error: GatewayResetError


class Unusable(NamedTuple):
    """Event: the connection cannot be used any more, and should be closed."""

    error: UnityLinkError


class Taken(NamedTuple):
    """Event: another program has begun a session with the gateway, so this link ends."""

    error: LinkLostError


GroupEvent = Sampled | SampledRows | SampledTogether | GroupBegun
SessionEvent = Opened | GroupsRestored | Interrupted | Unusable | Taken
UnsolicitedEvent = GroupEvent | SessionEvent | PostedFailure
"""Events that no call awaits."""
Event = Awaited | UnsolicitedEvent
Events = list[Event]
