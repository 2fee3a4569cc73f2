"""The signs of loss, and the patience with them.

A loss brings many signs (``X01`` for the damaged request, ``n`` for the one behind it). So when the window has gone
back for one, it takes no further sign before something has arrived that was sent since: the answer to the `K` that is
sent ahead of the repetition, or to a request. What brings no sign, or had its `K` lost, the time out finds. From
`MOST_SIGNS` on for the same request it is left to the time, so that what is damaged each time is given up.
"""

from __future__ import annotations

from unity_link.protocol.window.constants import (
    FEWEST_SILENT_TRIES,
    LONGEST_SILENCE,
    MOST_REFUSALS,
    MOST_SIGNS,
    MOST_TRIES,
)
from unity_link.protocol.window.retransmission import NEVER


class LossDetection:
    """Tries of the oldest request, and what was heard of them."""

    __slots__ = ("_gave_up", "_refusals", "_silent_since", "_silent_tries", "_tries", "gone_back", "heard", "lost",
                 "place", "timed_out")  # fmt: skip

    def __init__(self) -> None:
        self.heard = False
        """Something that can be about a request has arrived since the last time out, be it damaged: set by the reader.
        """
        self.place = NEVER
        """Place of the first sending since the window went back."""
        self.gone_back = 0
        """Number of times that it has gone back to this oldest request."""
        self.timed_out = False
        """True if it went back last because the time had run out."""
        self.lost = False
        """The gateway does not answer any more: too many time outs in silence, or not even an ``h`` comes through."""
        self._refusals = self._tries = self._silent_tries = 0
        self._silent_since = 0.0
        self._gave_up = False

    def takes(self, arrived: int) -> bool:
        """Return whether a sign is followed, given the place of the last sending that has arrived."""
        return self.place <= arrived and not self.are_left_to_the_time()

    def are_left_to_the_time(self) -> bool:
        """Return whether the window has gone back so often to this request that no further sign counts."""
        return self.gone_back >= MOST_SIGNS

    def go_back(self, sent: int) -> None:
        """Record that the window goes back, given the number of sendings."""
        self.place = sent
        self.gone_back = min(self.gone_back + 1, MOST_SIGNS)

    def refused(self) -> bool:
        """Record that the gateway refused the oldest request; return whether it is given up."""
        self._refusals += 1
        given_up = self._refusals == MOST_REFUSALS
        self.lost = self.lost or (given_up and self._gave_up)
        return given_up

    def time_out(self, now: float, since: float) -> bool:
        """Record that the time has run out; return whether the oldest request is given up."""
        self._tries += 1
        given_up = False
        if self.heard:
            self._silent_tries = 0
            given_up = self._tries > MOST_TRIES
            self.lost = self.lost or (given_up and self._gave_up)
        else:
            if not self._silent_tries:
                self._silent_since = since
            self._silent_tries += 1
            silent = self._silent_tries >= FEWEST_SILENT_TRIES and now - self._silent_since >= LONGEST_SILENCE
            self.lost = self.lost or silent
        self.heard = False
        self.timed_out = True
        return given_up

    def give_up(self) -> None:
        """Record that another request stands in for the oldest."""
        self._tries = self._refusals = self.gone_back = 0
        self._gave_up = True

    def news(self) -> None:
        """Record that something was executed."""
        self._tries = self._silent_tries = 0

    def moved(self) -> None:
        """Begin anew with another oldest request."""
        self._gave_up = False
        self.gone_back = self._refusals = self._tries = self._silent_tries = 0
