"""Line arbiter: slots for links to nodes that share a half-duplex line (docs/protocol.md, "Half-duplex").

Each link of a program has a `Seat` on the `Line`, and requests a slot before each frame that has an answer. The link
returns the slot once the answer has arrived, and the arbiter gives it to the seat that has waited longest. If no answer
arrives, if the program is busy, or if a link is closed in its slot, the slot ends by itself once no answer can arrive
any more.

Links of one line may run in different threads. The arbiter has no thread and no timer: a waiting link requests its slot
again after `Seat.patience` seconds.
"""

from __future__ import annotations

import math
import threading
import time
from collections import deque
from typing import TYPE_CHECKING

from unity_link.errors import ConnectError

if TYPE_CHECKING:
    from collections.abc import Callable

MOST_HESITATION = 0.1
"""Seconds within which a link must begin the slot that it got."""


class Line:
    """The arbiter of a line that several nodes share.

    Args:
        name: name of the line in messages.
        clock: returns the time in seconds.
        free_at: time at which the first slot may begin.
    """

    def __init__(self, name: str, clock: Callable[[], float] = time.monotonic, free_at: float = -math.inf) -> None:
        self.name = name
        self.clock = clock
        self.lock = threading.RLock()
        self.seats: dict[int, Seat] = {}
        """Seat of each node, by node number."""
        self.holder: Seat | None = None
        """Seat that has the slot; None between slots."""
        self.last: Seat | None = None
        """Seat that has the slot, or had the last one."""
        self.free_at = free_at
        """Time at which the current slot ends by itself."""
        self.waiting: deque[Seat] = deque()

    @property
    def owed_until(self) -> float:
        """Time until which a late answer may arrive; only then may slots begin if the port is opened again."""
        # A permanent slot ends when the line is closed.
        return -math.inf if self.free_at == math.inf else self.free_at

    def join(self, node: int) -> Seat:
        """Return a seat for a new link to a node.

        Raises:
            ConnectError: if there is a link to this node already, or a node that keeps the line permanently.
        """
        with self.lock:
            if node in self.seats:
                raise ConnectError(f"this program has a link to node {node} of {self.name} already: use that link")
            if self.free_at == math.inf and self.holder is not None:
                raise ConnectError(f"{self.name} is in use: {_not_shared(self.holder.node)}")
            seat = self.seats[node] = Seat(self, node)
            return seat

    def give_to(self, seat: Seat) -> None:
        """Assign the slot to a seat, which must begin it within `MOST_HESITATION`."""
        if seat in self.waiting:
            self.waiting.remove(seat)
        self.holder = self.last = seat
        seat.has_begun = False
        self.free_at = self.clock() + MOST_HESITATION

    def pass_on(self) -> Seat | None:
        """Assign the slot to the seat that has waited longest, and return it; the caller must call its `on_turn`."""
        self.holder, self.free_at = None, -math.inf
        if not self.waiting:
            return None
        seat = self.waiting[0]
        self.give_to(seat)
        return seat


def _not_shared(node: int) -> str:
    return f"the gateway of node {node} sends without being asked (it was not built half-duplex)"


class Seat:
    """One link's place on a line; created by `Line.join`."""

    def __init__(self, line: Line, node: int) -> None:
        self.node = node
        self.on_turn: Callable[[], object] = lambda: None
        """Is called in any thread when a requested slot was given to this seat."""
        self._line = line
        self.has_begun = False
        """True if the link has sent a frame in the slot."""

    @property
    def listens(self) -> bool:
        """True if this link reads received bytes: in its slot, and after it until the next slot of another link."""
        line = self._line
        return line.last is self

    @property
    def has_turn(self) -> bool:
        """True if this link may send."""
        return self._line.holder is self

    @property
    def is_kept(self) -> bool:
        """True if this link has a permanent slot."""
        return self.has_turn and self._line.free_at == math.inf

    @property
    def patience(self) -> float:
        """Seconds after which to request the slot again, if `on_turn` was not called before."""
        return max(0.0, self._line.free_at - self._line.clock())

    def ask(self) -> bool:
        """Request a slot; return True if the link has it now. Otherwise the link waits for it from now on."""
        line = self._line
        next_seat = None
        with line.lock:
            if line.holder is self and line.free_at > line.clock():
                return True
            if self not in line.waiting:
                line.waiting.append(self)
            if line.free_at <= line.clock():
                next_seat = line.pass_on()
            given = line.holder is self
        if next_seat is not None and next_seat is not self:
            next_seat.on_turn()
        return given

    def begin(self, seconds: float) -> None:
        """Begin the slot.

        Args:
            seconds: time within which an answer arrives, if it arrives at all.
        """
        with self._line.lock:
            if self.has_turn:
                self.has_begun = True
                self._line.free_at = self._line.clock() + seconds

    def give_back(self) -> None:
        """End the slot, if the link has it: no answer is pending any more."""
        line = self._line
        with line.lock:
            if line.holder is not self:
                return
            next_seat = line.pass_on()
        if next_seat is not None:
            next_seat.on_turn()

    def keep(self) -> None:
        """Make the slot permanent, for a node that sends unsolicited frames.

        Raises:
            ConnectError: if the line has links to other nodes.
        """
        line = self._line
        with line.lock:
            others = [node for node in line.seats if node != self.node]
            if others:
                raise ConnectError(f"{line.name} is shared with node {others[0]}, but {_not_shared(self.node)}")
            line.give_to(self)
            line.free_at = math.inf

    def leave(self) -> None:
        """Leave the line. If an answer is pending, the next slot begins only after the answer's time limit."""
        line = self._line
        with line.lock:
            if line.seats.get(self.node) is not self:
                return
            del line.seats[self.node]
            if self in line.waiting:
                line.waiting.remove(self)
            if line.holder is not self:
                return
            line.holder = None
            next_seat = None if self.has_begun and line.free_at < math.inf else line.pass_on()
        if next_seat is not None:
            next_seat.on_turn()
