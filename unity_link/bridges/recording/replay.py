"""A gateway that answers as a recorded one did: at each instant, its bus has the words of the last sample."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual.bus import AccessError
from unity_link.virtual.gateway import VirtualGateway

if TYPE_CHECKING:
    from unity_link.bridges.recording.reader import RecordedGroup, Recording

MOST_SPEED = 1e6
"""Largest speed, at which days take a tenth of a second; instants stay far within the precision of a double."""
ONE_INSTANT = 1.0
"""Duration of a recording with a single instant, in seconds, if it is repeated."""


class Player:
    """The recorded words as a device. Time begins at the first access, and stops at the end of the recording.

    The recording runs half a period ahead, so an access between two samples usually gets the earlier one, and a
    subscription with the recorded rate gets each sample once, even though the clocks are not exact.
    """

    def __init__(self, recording: Recording, *, speed: float = 1.0, loop: bool = False) -> None:
        """Make a player.

        Args:
            recording: recording to play.
            speed: factor of the speed.
            loop: whether the recording begins again at its end.

        Raises:
            ArgumentError: for a speed that is not above 0 and at most `MOST_SPEED`, or a recording without samples.
        """
        if not 0 < speed <= MOST_SPEED:
            raise ArgumentError(f"a speed of {speed:g} was asked for, expected more than 0 and at most {MOST_SPEED:g}")
        self.addresses = sorted({address for group in recording.groups for address in group.addresses})
        self.position = 0.0
        """Present position in the recording, in seconds."""
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
        """Return a word as it was recorded at that instant."""
        self._play(now)
        return self._words[self.addresses[offset]]

    def write(self, offset: int, value: int, now: float) -> None:  # noqa: ARG002  (recorded words cannot be changed)
        """Refuse all writes: recorded words cannot be changed."""
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
        """Return the period of a group's samples in seconds; 0 if it is not known."""
        recording, signal = self._recording, group.signals[0] if group.signals else None
        declared = next((known for known in recording.interface.groups if signal and known.name == signal.group), None)
        base = recording.gateway.base_frequency_hz
        if declared is not None and declared.divisor and base:
            return declared.divisor / base
        rate_hz = declared.rate_hz if declared is not None else signal and signal.poll_hz
        if rate_hz:
            return 1 / rate_hz
        # The spec does not have the rate: it was given to the recorder.
        first = next((samples for samples, _ in recording.samples() if samples.group is group), None)
        if first is None or first.sequence[-1] <= first.sequence[0]:
            return 0.0
        return float((first.at[-1] - first.at[0]) / (first.sequence[-1] - first.sequence[0])) * 1e-9


def replay(recording: Recording, *, speed: float = 1.0, loop: bool = False) -> tuple[VirtualGateway, Player]:
    """Return a simulated gateway like the recorded one, and the device that plays the recording on its bus.

    Addresses that were not recorded are memory. A write to a recorded address is a bus error.
    ``unity_link.connect(gateway)`` connects to the gateway, `unity_link.virtual.serving` serves it to other programs.

    Raises:
        ArgumentError: for a speed that is not above 0 and at most `MOST_SPEED`, or a recording without samples.
    """
    player = Player(recording, speed=speed, loop=loop)
    gateway = VirtualGateway(recording.gateway)
    gateway.attach(player, player.addresses)
    return gateway, player
