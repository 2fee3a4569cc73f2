"""Loss detection: which errors, answers and timeouts make the window go back, and when the link is lost.

1. One loss causes several signs: ``X01`` for the damaged request, ``n`` for the request after it. So after the window
   went back for a sign, it ignores further signs until a frame arrives that was sent since: the answer to the session
   query (`K`) sent ahead of the retransmissions, or an answer to a request.
2. A loss without a sign, or whose query is lost, is found by the timeout.
3. After `MOST_SIGNS` for the same request only the timeout counts, so that a request that is damaged each time is
   given up.
4. After `MOST_TRIES` timeouts, or `MOST_REFUSALS` refusals, the oldest request is given up: an ``h`` replaces it. If
   the ``h`` is given up as well, the link is lost.
5. The link is also lost after `LONGEST_SILENCE` with at least `FEWEST_SILENT_TRIES` timeouts in silence.
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
    """Signs of loss, timeouts and refusals of the oldest request."""

    __slots__ = ("_gave_up", "_refusals", "_silent_since", "_silent_tries", "_tries", "gone_back", "heard", "lost",
                 "place", "timed_out")  # fmt: skip

    def __init__(self) -> None:
        self.heard = False
        """True if bytes that can belong to an answer arrived since the last timeout, damaged ones too.

        The receiver sets it.
        """
        self.place = NEVER
        """Number of the first transmission since the window went back."""
        self.gone_back = 0
        """Number of times that the window went back to this oldest request, at most `MOST_SIGNS`."""
        self.timed_out = False
        """True if the window went back last for a timeout, False for a sign of loss."""
        self.lost = False
        """True if the gateway no longer answers: too many timeouts in silence, or even an ``h`` was given up."""
        self._refusals = self._tries = self._silent_tries = 0
        self._silent_since = 0.0
        self._gave_up = False

    def takes(self, arrived: int) -> bool:
        """Return whether the window goes back for a sign, given the number of the last transmission that arrived."""
        return self.place <= arrived and not self.ignores_signs()

    def ignores_signs(self) -> bool:
        """Return whether the window went back to this request so often that only the timeout counts."""
        return self.gone_back >= MOST_SIGNS

    def go_back(self, sent: int) -> None:
        """Record that the window goes back; `sent` is the number of the next transmission."""
        self.place = sent
        self.gone_back = min(self.gone_back + 1, MOST_SIGNS)

    def refused(self) -> bool:
        """Record that the gateway refused the oldest request; return whether it is given up."""
        self._refusals += 1
        given_up = self._refusals == MOST_REFUSALS
        self.lost = self.lost or (given_up and self._gave_up)
        return given_up

    def time_out(self, now: float, since: float) -> bool:
        """Record a timeout; return whether the oldest request is given up.

        Args:
            now: instant of the timeout.
            since: instant from which the timeout counts.
        """
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
        """Record that an ``h`` replaces the oldest request."""
        self._tries = self._refusals = self.gone_back = 0
        self._gave_up = True

    def news(self) -> None:
        """Record that the gateway has executed a request."""
        self._tries = self._silent_tries = 0

    def moved(self) -> None:
        """Reset the counts for a new oldest request."""
        self._gave_up = False
        self.gone_back = self._refusals = self._tries = self._silent_tries = 0
