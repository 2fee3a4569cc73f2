"""The turns of nodes that share a medium to send on (docs/protocol.md, "Half-duplex").

Each link of a program has a `Seat` on the `Line`, and asks for a turn before each frame that wants an answer. The turn
is given back with the answer, and passes to whoever has waited longest. Where no answer comes, where a program is busy
with something else, or where a link was closed in its turn, the turn ends by itself: when no answer can come any more.

Links of one line may run in different threads. There is no thread here, and no timer: whoever waits asks again when
`Seat.patience` is over.
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
"""Seconds in which a link must have begun the turn that it was given."""


class Line:
    """A medium that nodes share.

    Args:
        name: what messages call it.
        clock: gives the time in seconds.
        free_at: when the first turn may begin.
    """

    def __init__(self, name: str, clock: Callable[[], float] = time.monotonic, free_at: float = -math.inf) -> None:
        self.name = name
        self.clock = clock
        self.lock = threading.RLock()
        self.seats: dict[int, Seat] = {}
        """Seats by the number of the node."""
        self.holder: Seat | None = None
        """Seat that has the turn."""
        self.last: Seat | None = None
        """Seat that has the turn, or had it last."""
        self.free_at = free_at
        """Instant at which the turn ends by itself."""
        self.waiting: deque[Seat] = deque()

    @property
    def owed_until(self) -> float:
        """Until when an answer may come that is owed: then the first turn may begin of a line in place of this one."""
        # A turn that is kept for good ends with its line.
        return -math.inf if self.free_at == math.inf else self.free_at

    def join(self, node: int) -> Seat:
        """Return the seat of the link to a node.

        Raises:
            ConnectError: where there is one already, or a node that does not take turns.
        """
        with self.lock:
            if node in self.seats:
                raise ConnectError(f"{self.name} has a link to node {node} already, of this program: use that")
            if self.free_at == math.inf and self.holder is not None:
                raise ConnectError(f"{self.name} is in use: {_not_shared(self.holder.node)}")
            seat = self.seats[node] = Seat(self, node)
            return seat

    def give_to(self, seat: Seat) -> None:
        """Pass a turn to a seat, which is to begin it soon."""
        if seat in self.waiting:
            self.waiting.remove(seat)
        self.holder = self.last = seat
        seat.has_begun = False
        self.free_at = self.clock() + MOST_HESITATION

    def pass_on(self) -> Seat | None:
        """Pass the turn to the seat that has waited longest, and return that, which must be told."""
        self.holder, self.free_at = None, -math.inf
        if not self.waiting:
            return None
        seat = self.waiting[0]
        self.give_to(seat)
        return seat


def _not_shared(node: int) -> str:
    return f"the gateway of node {node} sends without being asked (it was not built half-duplex)"


class Seat:
    """The place of one link on a line; made by `Line.join`."""

    def __init__(self, line: Line, node: int) -> None:
        self.node = node
        self.on_turn: Callable[[], object] = lambda: None
        """Is called, in any thread, when a turn that was asked for has come."""
        self._line = line
        self.has_begun = False
        """True if something was sent in the turn."""

    @property
    def listens(self) -> bool:
        """Return whether what arrives is for this link: in its turn; between turns the last one listens."""
        line = self._line
        return line.last is self

    @property
    def has_turn(self) -> bool:
        """Return whether this link may send."""
        return self._line.holder is self

    @property
    def is_kept(self) -> bool:
        """Return whether this link has the turn for good."""
        return self.has_turn and self._line.free_at == math.inf

    @property
    def patience(self) -> float:
        """Seconds after which to ask again, where `on_turn` has not been called."""
        return max(0.0, self._line.free_at - self._line.clock())

    def ask(self) -> bool:
        """Return whether it is this link's turn; otherwise it waits for it from now on."""
        line = self._line
        told = None
        with line.lock:
            if line.holder is self and line.free_at > line.clock():
                return True
            if self not in line.waiting:
                line.waiting.append(self)
            if line.free_at <= line.clock():
                told = line.pass_on()
            given = line.holder is self
        if told is not None and told is not self:
            told.on_turn()
        return given

    def begin(self, seconds: float) -> None:
        """Begin the turn: what is sent now is answered within so many seconds, or never."""
        with self._line.lock:
            if self.has_turn:
                self.has_begun = True
                self._line.free_at = self._line.clock() + seconds

    def give_back(self) -> None:
        """End the turn, if there is one: nothing is on its way any more."""
        line = self._line
        with line.lock:
            if line.holder is not self:
                return
            told = line.pass_on()
        if told is not None:
            told.on_turn()

    def keep(self) -> None:
        """Keep the turn for good, for a node that sends without being asked.

        Raises:
            ConnectError: where there are links to other nodes.
        """
        line = self._line
        with line.lock:
            others = [node for node in line.seats if node != self.node]
            if others:
                raise ConnectError(f"{line.name} is shared with node {others[0]}, but {_not_shared(self.node)}")
            line.give_to(self)
            line.free_at = math.inf

    def leave(self) -> None:
        """Leave the seat. If an answer is owed, its time passes before another turn begins."""
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
            told = None if self.has_begun and line.free_at < math.inf else line.pass_on()
        if told is not None:
            told.on_turn()
