"""A gateway that answers as the recorded one did: at each instant its bus has the words of the last sample."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual.bus import AccessError
from unity_link.virtual.gateway import VirtualGateway

if TYPE_CHECKING:
    from unity_link.bridges.recording.reader import RecordedGroup, Recording

MOST_SPEED = 1e6
"""Days in a tenth of a second; instants are far from what a double cannot hold."""
ONE_INSTANT = 1.0
"""Seconds that a recording lasts which is of a single instant, where it begins again and again."""


class Player:
    """The recorded words as a device. Time begins with the first access, and stands still at the end.

    An access in the middle between two samples gives the earlier one; so a subscription of the recorded rate gets each
    sample once, though neither clock is exact: the recording runs half a period ahead.
    """

    def __init__(self, recording: Recording, *, speed: float = 1.0, loop: bool = False) -> None:
        """Make a player.

        Args:
            recording: what is played.
            speed: how many times as fast as it was.
            loop: whether it begins again at its end.

        Raises:
            ArgumentError: for a speed that is not more than 0 and at most `MOST_SPEED`, or a recording without samples.
        """
        if not 0 < speed <= MOST_SPEED:
            raise ArgumentError(f"a speed of {speed:g} was asked for, expected more than 0 and at most {MOST_SPEED:g}")
        self.addresses = sorted({address for group in recording.groups for address in group.addresses})
        self.position = 0.0
        """Seconds of the recording that were played."""
        self.ended = False
        self._recording = recording
        self._speed = speed
        self._loop = loop
        self._words = dict.fromkeys(self.addresses, 0)
        self._rows = recording.in_order()
        self._began: float | None = None
        self._next = next(self._rows, None)
        if self._next is None:
            raise ArgumentError(f"{recording.path} has no samples")
        self._first = self._last = self._next.at
        self._ahead = self._half_a_period()

    def read(self, offset: int, now: float) -> int:
        """Return a word as it was."""
        self._play(now)
        return self._words[self.addresses[offset]]

    def write(self, offset: int, value: int, now: float) -> None:  # noqa: ARG002  (nothing changes what has been)
        """Refuse: nothing changes what has been."""
        raise AccessError(ErrorCode.BUS_ERROR)

    def _play(self, now: float) -> None:
        if self._began is None:
            self._began = now
        self.position = (now - self._began) * self._speed
        self._catch_up()
        if self._next is None and self._loop:
            length = (self._last - self._first) * 1e-9 + 2 * self._ahead or ONE_INSTANT
            self.position %= length
            self._began = now - self.position / self._speed
            self._rows = self._recording.in_order()
            self._next = next(self._rows)
            self._catch_up()
        self.ended = self._next is None and not self._loop

    def _catch_up(self) -> None:
        due = self._first + int((self.position + self._ahead) * 1e9)
        while self._next is not None and self._next.at <= due:
            self._last, group, words = self._next
            self._words.update(zip(group.addresses, words.tolist(), strict=True))
            self._next = next(self._rows, None)

    def _half_a_period(self) -> float:
        """Return half the shortest period of the recorded groups, in seconds of the recording."""
        return 0.5 * min(filter(None, map(self._period, self._recording.groups)), default=0.0)

    def _period(self, group: RecordedGroup) -> float:
        """Return how far the samples of a group are apart; 0 where nothing tells."""
        recording, signal = self._recording, group.signals[0] if group.signals else None
        declared = next((known for known in recording.interface.groups if signal and known.name == signal.group), None)
        base = recording.gateway.base_frequency_hz
        if declared is not None and declared.divisor and base:
            return declared.divisor / base
        rate_hz = declared.rate_hz if declared is not None else signal and signal.poll_hz
        if rate_hz:
            return 1 / rate_hz
        # The recorder alone knew.
        first = next((samples for samples, _ in recording.samples() if samples.group is group), None)
        if first is None or first.sequence[-1] <= first.sequence[0]:
            return 0.0
        return float((first.at[-1] - first.at[0]) / (first.sequence[-1] - first.sequence[0])) * 1e-9


def replay(recording: Recording, *, speed: float = 1.0, loop: bool = False) -> tuple[VirtualGateway, Player]:
    """Return a gateway as the recorded one was, and what plays the recording behind it.

    What was not recorded is plain memory; a write to what was is a bus error. ``unity_link.connect(gateway)`` connects
    to it, `unity_link.virtual.serving` gives it to other programs.

    Raises:
        ArgumentError: for a speed that is not more than 0 and at most `MOST_SPEED`, or a recording without samples.
    """
    player = Player(recording, speed=speed, loop=loop)
    gateway = VirtualGateway(recording.gateway)
    gateway.attach(player, player.addresses)
    return gateway, player
