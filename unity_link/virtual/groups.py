"""Groups of the virtual gateway (docs/protocol.md, "Groups"): the times and contents of samples.

Base tick k is at k / base frequency after the gateway's start. A periodic group is due at multiples of its divisor
after its first tick. A sample is read and stamped for the time at which it is due, even if `advance` is called later.
It is sent, or waits in the ring of `unity_link.virtual.sample_ring`. If the ring is full as well, the sample is an
overrun: it only increments the group's sequence number.
"""

from __future__ import annotations

import math
from collections import deque
from heapq import heapify, heapreplace
from typing import TYPE_CHECKING

from unity_link.protocol.wire.messages import GroupFlag
from unity_link.virtual.bus import AccessError, ModelBus
from unity_link.virtual.sample_ring import SampleRing

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.protocol.wire.configuration import GatewayInfo

_TIMESTAMP_MASK = 0xFFFFFFFF
_SEQUENCE_MASK = 0xFF
_SLACK_TICKS = 1e-3
"""Tolerance in clock ticks: a time in seconds may be this much below the tick that it represents."""
_PAUSE = 0.001
"""Seconds between two checks for room while samples are pending."""


class BaseClock:
    """The gateway's time: base ticks and clock ticks since its start, which is the first time that it gets."""

    def __init__(self, info: GatewayInfo) -> None:
        self._base_hz = info.base_frequency_millihertz / 1000
        self._stamp_factor = info.clock_hz * 1000
        self._stamp_divisor = info.base_frequency_millihertz
        self._clock_hz = info.clock_hz
        self._start: float | None = None

    def restart(self) -> None:
        """Start again at the next time that the clock gets."""
        self._start = None

    def start(self, now: float) -> float:
        """Return the time of tick 0 in seconds; `now`, if the clock has not started."""
        if self._start is None:
            self._start = now
        return self._start

    def time_of(self, tick: int) -> float:
        """Return the time of a base tick in seconds."""
        return (self._start or 0.0) + tick / self._base_hz

    def tick_before(self, now: float) -> int:
        """Return the last base tick that is not after `now`."""
        tick = int((now - self.start(now)) * self._base_hz)
        while self.time_of(tick + 1) <= now:
            tick += 1
        while self.time_of(tick) > now:
            tick -= 1
        return tick

    def stamp_of(self, tick: int) -> int:
        """Return the timestamp of a base tick."""
        return tick * self._stamp_factor // self._stamp_divisor & _TIMESTAMP_MASK

    def ticks_at(self, now: float) -> int:
        """Return the number of clock ticks at a time."""
        return int((now - self.start(now)) * self._clock_hz + _SLACK_TICKS)

    def stamp_at(self, now: float) -> int:
        """Return the timestamp of a time."""
        return self.ticks_at(now) & _TIMESTAMP_MASK


class PublishGroup:
    """Settings and state of one group."""

    __slots__ = ("addresses", "divisor", "due", "flags", "form", "last", "running", "sequence", "words")

    def __init__(self, flags: int, divisor: int, addresses: list[int], form: bytes) -> None:
        self.flags = GroupFlag(flags)
        self.divisor = divisor
        self.addresses = addresses
        self.words = SampleRing.words_of(len(addresses), stamped=GroupFlag.TIMESTAMP in self.flags)
        """Number of words that a sample takes in the ring."""
        self.form = form
        """%-format of a sample's body, with sequence number, optional timestamp, and words."""
        self.sequence = 0
        self.running = False
        self.due = 0
        """Base tick at which a running periodic group is due next."""
        self.last: list[int] | None = None
        """Words of the last published sample since GS or GN."""


class PublishGroups:
    """All groups of one gateway.

    Args:
        info: the gateway's configuration.
        bus: the bus from which samples are read.
        frame: returns the frame of a body; its second argument is True for a plain frame.
    """

    def __init__(self, info: GatewayInfo, bus: ModelBus, frame: Callable[[bytes, bool], bytes]) -> None:
        self.clock = BaseClock(info)
        self.overruns = 0
        """Number of overruns of all groups."""
        self.ring = SampleRing(info.group_words)
        self._word_form = b"%%0%dX" % info.data_digits
        self._bus = bus
        self._frame = frame
        self._groups: dict[int, PublishGroup] = {}
        self._schedule: list[tuple[int, int]] = []
        """Heap of all running periodic groups: next base tick, and number of the group."""
        self._triggers: deque[tuple[float, int | None]] = deque()
        """Pending trigger edges: time, and number of the group or None for all groups."""
        self._advanced_to = 0.0

    def reset(self) -> None:
        """Delete all groups, and restart the clock."""
        self._groups.clear()
        self._triggers.clear()
        self._schedule.clear()
        self.ring.reset()
        self.clock.restart()

    def is_set(self, number: int) -> bool:
        """Return True if a group was set since the reset."""
        return number in self._groups

    def set(self, number: int, flags: int, divisor: int, addresses: list[int]) -> None:
        """Store the settings of a group; the group stops, and its sequence number becomes 0."""
        stamp = b"%08X" if flags & GroupFlag.TIMESTAMP else b""
        form = b"P%02X%%02X%b%b" % (number, stamp, self._word_form * len(addresses))
        self._groups[number] = PublishGroup(flags, divisor, addresses, form)
        self._reschedule()

    def start(self, number: int, now: float) -> None:
        """Start a group; a periodic group is first due at the next base tick."""
        group = self._groups[number]
        group.running = True
        group.last = None
        group.due = self.clock.tick_before(now) + 1
        self._reschedule()

    def stop(self, number: int) -> None:
        """Stop a group."""
        self._groups[number].running = False
        self._reschedule()

    def stop_all(self) -> None:
        """Stop all groups; they keep their settings and sequence numbers."""
        for group in self._groups.values():
            group.running = False
        self._schedule.clear()

    def _reschedule(self) -> None:
        self._schedule = [
            (group.due, number)
            for number, group in self._groups.items()
            if group.running and group.flags & GroupFlag.PERIODIC
        ]
        heapify(self._schedule)

    def trigger(self, now: float, number: int | None = None) -> None:
        """Record a rising edge of the external trigger of a group, or of all groups."""
        self._triggers.append((now, number))

    @property
    def next_due(self) -> float | None:
        """Time at which `advance` has something to do next; while samples are pending, at most `_PAUSE` later."""
        due = self.clock.time_of(self._schedule[0][0]) if self._schedule else math.inf
        if self._triggers:
            due = min(due, self._triggers[0][0])
        if self.ring.waiting:
            due = min(due, self._advanced_to + _PAUSE)
        return None if due == math.inf else due

    def publish_now(self, number: int, now: float) -> None:
        """Publish a group once, even if it is stopped or no value has changed."""
        group = self._groups[number]
        if self.ring.takes(group.words):
            self._publish(group, now, self.clock.stamp_at(now), unchanged=True)
        else:
            self._count_overruns(group, 1)

    def advance(self, now: float, room: float) -> bytes:
        """Take all samples that are due up to `now`, and return the frames to send.

        Args:
            now: the time in seconds.
            room: number of bytes after which no further sample is sent.
        """
        self._advanced_to = now
        self.ring.open(room)
        while self._triggers and self._triggers[0][0] <= now:
            edge, number = self._triggers.popleft()
            self._advance_periodic(edge)
            self._advance_triggered(edge, number)
        self._advance_periodic(now)
        return self.ring.take()

    def _advance_periodic(self, now: float) -> None:
        schedule, groups, time_of, stamp_of = self._schedule, self._groups, self.clock.time_of, self.clock.stamp_of
        takes = self.ring.takes
        while schedule:
            tick, number = schedule[0]
            instant = time_of(tick)
            if instant > now:
                break
            group = groups[number]
            missed = 0 if takes(group.words) else self._count_missed(group, tick, now)
            group.due = tick + (missed or 1) * group.divisor
            heapreplace(schedule, (group.due, number))
            if not missed:
                self._publish(group, instant, stamp_of(tick))

    def _advance_triggered(self, edge: float, triggered: int | None) -> None:
        stamp = self.clock.stamp_at(edge)
        for number, group in sorted(self._groups.items()):
            if not (group.running and group.flags & GroupFlag.TRIGGER and triggered in (None, number)):
                continue
            if self.ring.takes(group.words):
                self._publish(group, edge, stamp)
            else:
                self._count_overruns(group, 1)

    def _count_missed(self, group: PublishGroup, tick: int, now: float) -> int:
        """Count the samples from `tick` to `now` as overruns, for which there is no room; return their number."""
        missed = (self.clock.tick_before(now) - tick) // group.divisor + 1
        self._count_overruns(group, missed)
        return missed

    def _count_overruns(self, group: PublishGroup, count: int) -> None:
        group.sequence = group.sequence + count & _SEQUENCE_MASK
        self.overruns += count

    def _publish(self, group: PublishGroup, instant: float, stamp: int, *, unchanged: bool = False) -> None:
        """Publish a due sample. Skip it after a bus error, or if the group has ON_CHANGE and no value has changed."""
        sequence = group.sequence
        try:
            words = self._bus.read_words(group.addresses, instant)
        except AccessError:
            group.sequence = sequence + 1 & _SEQUENCE_MASK
            return
        flags = group.flags._value_
        if flags & 16:
            if words == group.last and not unchanged:
                return
            group.last = words
        group.sequence = sequence + 1 & _SEQUENCE_MASK
        body = group.form % ((sequence, stamp, *words) if flags & 8 else (sequence, *words))
        self.ring.put(self._frame(body, flags & 32 != 0), group.words, immediate=flags & 4 != 0)
