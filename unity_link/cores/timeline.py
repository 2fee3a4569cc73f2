"""The host's side of a schedule: it sends writes at instants, and determines the outcome of each.

A schedule has one writer at a time, a `ScheduleFeed`. The feed knows which batches are in flight, and reads their
outcomes and the room in the queue from the registers of the schedule. No task runs in the background.
"""

from __future__ import annotations

from collections import deque
from contextlib import suppress
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, Self

from unity_link.cores import CoreRegisters
from unity_link.cores.batches import AHEAD, BEHIND, FATES, FRAME, MOST_WORDS, batch_of
from unity_link.cores.clock import Instant, TickBounds, TickClock, ticks_after
from unity_link.errors import (
    ArgumentError,
    BusError,
    GatewayResetError,
    LateError,
    LinkLostError,
    NotArmedError,
    OfLink,
    Outcome,
    Sealed,
    UnansweredError,
    UnityLinkError,
    refusing,
)
from unity_link.link.asked import Asked, most_words, post_in_session
from unity_link.link.calls import returns_coroutine
from unity_link.link.interrupts import whole_exit
from unity_link.link.runtimes.runtime import raises_now
from unity_link.link.runtimes.synchronisation import Lock, running
from unity_link.modules import caller_on
from unity_link.spec.model import STAGE_BITS

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Generator, Mapping, Sequence
    from types import TracebackType

    from unity_link.cores.lease import Lease
    from unity_link.data.proxies import Proxy
    from unity_link.link.link import Link
    from unity_link.spec.model import Signal

MOST_UNDER_WAY = 64
"""Most unanswered queue writes."""
LOOK_BEHIND = FATES * 2 // 3
"""Number of batches whose instants pass before their outcomes are read."""
SHORTEST_PAUSE = 0.0005
"""Least number of seconds between two reads of the schedule's registers."""
PARTS = 8
"""Part of the queue, as a divisor, that must be free before a full queue is filled again."""
KICKS = 4
"""Least number of kicks in the time-out of a lease."""
_NUMBERS = 1 << 16
"""The number of ended batches is modulo this number."""
_OPEN = "write `async with` before this timeline, and `with` where it is one of a blocking link"


class ScheduleRegisters(CoreRegisters):
    """The registers of a schedule."""

    def __init__(self, robot: Any, name: str) -> None:
        super().__init__(robot, name)
        find = self.find
        self.depth = int(self.core.generics["depth"])
        """Number of words in its queue."""
        self.entry, self.cancel, self.clock, self.fates = (
            find(register) for register in ("entry", "cancel", "clock", "fates")
        )
        self.counters = tuple(find(register).signal for register in ("late", "refused", "room", "slack"))
        """Signals at consecutive addresses."""
        self.link: Link = self.entry.link
        timed = {path: signal for path, signal in robot.interface.signals.items() if signal.timed == name}
        self.places: dict[str, range] = {path: robot.interface.stages[path] for path in timed}
        """Places on the schedule's stage, by the paths of the signals that it can write."""
        self.lease = next((signal.safe.lease for signal in timed.values() if signal.safe is not None), None)
        """Path of the lease that guards the signals that the schedule writes; None without one."""
        self.reach_seconds = AHEAD / self.link.gateway.clock_hz
        """Seconds by which an instant can be ahead of the gateway's clock: half the range of its 40 bits."""

    def timed(self, proxy: Proxy[Any]) -> Signal:
        """Return the declaration of a signal that the schedule can write.

        Raises:
            ArgumentError: for any other signal.
        """
        signal: Signal | None = getattr(proxy, "signal", None)
        if signal is None:
            raise ArgumentError(
                f"{self.name} writes to signals, so the keys of the values are signals, not {proxy!r:.80}"
            )
        if proxy.robot is not self.robot or signal.path not in self.places:
            raise ArgumentError(f"{signal.path} is not timed by {self.name}: its declaration has no TIMED({self.name})")
        return signal

    def words_of(self, values: Mapping[Any, Any]) -> dict[int, int]:
        """Return the words for values, by their places on the stage.

        Raises:
            ArgumentError: for no values, values that signals cannot have, and signals that the schedule cannot write.
        """
        words: dict[int, int] = {}
        for proxy, value in values.items():
            signal = self.timed(proxy)
            encoded = signal.encode(value)
            raw = signal.kind.encode(signal.decode(encoded)) if signal.words > 1 else encoded[0] >> signal.lowest_bit
            for part, place in enumerate(self.places[signal.path]):
                words[place] = raw >> STAGE_BITS * part & (1 << STAGE_BITS) - 1
        if not words:
            raise ArgumentError(f"{self.name} was given no values to write: at least one signal was expected")
        return words


class _Look(NamedTuple):
    """Contents of the registers of a schedule at one time."""

    ended: int
    """Number of batches that have ended, modulo 2 ** 16."""
    failed: int
    """One bit for each of the last 48 ended batches, the newest lowest: 1 if the batch was not executed."""
    late: int
    refused: int
    room: int


class Done(OfLink):
    """A write at an instant. Awaiting it returns the instant after the write has been executed."""

    def __init__(self, feed: ScheduleFeed, instant: Instant, size: int, poster: object) -> None:
        self.instant = instant
        self.size = size
        """Number of words that its batch occupies in the queue."""
        self.acted: bool | None = None
        """True if it was executed, False if it will never be; None if the outcome is not known yet."""
        self.error: UnityLinkError | None = None
        """Reason, if the host knows more than the registers: after a reset, or the loss of a connection."""
        self.is_awaited = False
        """True if a program awaits the write, so that the error is raised there."""
        self.poster = poster
        """Task or thread that has made the write."""
        self._feed = feed

    def __repr__(self) -> str:
        """Return the instant, and the outcome."""
        known = {None: "not known yet", True: "it acted", False: "it did not act"}[self.acted]
        return f"<a write at {self.instant}: {known}>"

    def __await__(self) -> Generator[Any, Any, Instant]:
        """Wait for the write; see `wait`."""
        return self.wait().__await__()

    async def wait(self) -> Instant:
        """Wait until the write has been executed, and return its instant.

        Raises:
            LateError: if it was not executed in time, or was cancelled.
            NotArmedError: if it was not executed because the lease of its signals is not armed.
            GatewayResetError: if the gateway was reset, which empties its schedules.
            LinkLostError: if the link has ended, or the connection was lost while words of the write were in flight.
        """
        self.is_awaited = True
        try:
            await self._feed.wait_for(self)
            error = None if self.acted else await self._feed.failure([self])
        except UnityLinkError:
            raise
        except BaseException:
            self.is_awaited = False
            raise
        if error is not None:
            raise error
        return self.instant


class ScheduleFeed:
    """The only writer of a schedule.

    Args:
        registers: registers of the schedule.
    """

    def __init__(self, registers: ScheduleRegisters) -> None:
        self.registers = registers
        self._link = registers.link
        self._session, self._resets = self._link.interruptions, self._link.resets
        self._bounds = TickBounds(self._link.gateway.clock_hz)
        self.time = TickClock(self._bounds, self._link)
        self.line: object | None = None
        """The open timeline; None if no timeline is open."""
        self.has_begun = False
        """True from `begin` until the batches are cancelled or given up."""
        self._looking = Lock()
        self._is_torn = False
        """True if words that were sent may have been lost."""
        self._pending: deque[Done] = deque()
        """Batches that were sent, and have no outcome yet."""
        self._unsure: list[Done] = []
        """Batches that ended so long ago that only the counters show whether all of them were executed."""
        self._queued: deque[Asked] = deque()
        self._failed: list[Done] = []
        self._ended = self._counted = self._base = 0
        self._late = self._refused = 0
        self._room = 0
        self._sent = 0
        """Number of all words sent so far."""
        self._last: Instant | None = None
        self.acted = 0
        """Number of batches executed since the last flush."""

    # Beginning and end

    async def begin(self) -> None:
        """Cancel all batches in the schedule, and begin."""
        async with self._looking:
            await self._read_clock()
            await self.cancel()
            look = await self._ask()
            while True:
                # Cancelled batches end one in each cycle: wait until the counters do not change any more.
                again = await self._ask()
                if again.ended == look.ended and again.refused == look.refused:
                    break
                look = again
            self._ended, self._base, self._counted = again.ended, again.late + again.refused, 0
            self._late, self._refused, self._room = again.late, again.refused, again.room
            self._last, self.acted = None, 0
            self._is_torn, self.has_begun = False, True

    async def cancel(self) -> None:
        """Cancel the batches that were sent and not executed.

        Raises:
            NotArmedError: if a lease guards the schedule's signals, and this program does not hold it, or no longer.
        """
        self.give_up()
        self._failed.clear()
        await self._empty()

    async def leave(self, error: BaseException) -> None:
        """Cancel writes that were not executed, at the end of a block with an error. A failure becomes a note."""
        has_queued = self.has_begun and self._resets == self._link.resets
        self.give_up()
        self._failed.clear()
        if has_queued:
            try:
                await self._empty()
            except (NotArmedError, GatewayResetError):
                # The end of a lease, and a reset, have cancelled all batches.
                pass
            except UnityLinkError as failed:
                error.add_note(
                    f"writes in the queue of {self.registers.name} may be executed: cancelling them failed ({failed})"
                )

    async def _empty(self) -> None:
        signal = self.registers.cancel.signal
        # The request ends with its session: in the next session it could cancel the schedule of another program.
        await self._executed(Asked(self._link, signal.address, write=signal.encode(1)))

    async def _executed(self, asked: Asked) -> None:
        """Wait for the answer to a write.

        Raises:
            BusError: if a bus, or a server, has refused the write; a NotArmedError, if the lease is the reason.
        """
        try:
            await asked.words()
        except BusError as error:
            lease, robot = self.registers.lease, self.registers.robot
            if lease is None:
                raise
            from unity_link.cores.lease import refused

            raise await refused(error, robot, lease) from None

    def give_up(self, error: Callable[[Done], UnityLinkError] | None = None) -> None:
        """Forget the batches that were sent. They count as not executed; `error` returns the error for each of them."""
        self.has_begun = False
        self.drop_answers()
        for done in (*self._unsure, *self._pending):
            done.acted = False
            if error is not None:
                done.error = error(done)
                self._failed.append(done)
        self._pending.clear()
        self._unsure.clear()

    def drop_answers(self) -> None:
        """Discard the answers to the words that were sent."""
        for queued in self._queued:
            queued.give_up()
        self._queued.clear()

    async def _read_clock(self) -> bool:
        """Read the gateway's clock. Return whether the gateway was reset, which empties its schedules."""
        link, bounds = self._link, self._bounds
        session, asked = link.interruptions, running().steady()
        ticks, now = int(await self.registers.clock.get()), running().steady()
        if session != link.interruptions:
            return await self._read_clock()
        # Behind a server each new connection counts as a reset; the clock shows if the gateway was really reset.
        may_be_reset = link.resets != self._resets and bounds.read_at is not None
        self._session, self._resets = session, link.resets
        was_reset = may_be_reset and ticks < bounds.least(asked)
        # The last cycle in which a batch may have been executed.
        last = bounds.most(now) - (ticks if was_reset else 0)
        if was_reset:
            bounds.forget()
        bounds.read(ticks, asked, now)
        if was_reset:
            self._void(GatewayResetError, "the gateway was reset", last)
        elif await self._has_lost_words():
            # Later words would be matched to the wrong writes, so cancel the queue.
            with suppress(NotArmedError):
                await self._empty()
            self._void(LinkLostError, "words were lost on the way", bounds.most(running().steady()))
        return was_reset

    async def _has_lost_words(self) -> bool:
        """Return whether words are known to be lost."""
        while self._queued and self._queued[0].done() and not self._is_torn:
            with suppress(UnansweredError):
                await self._take_answer()
        return self._is_torn

    def _void(self, kind: type[LinkLostError], reason: str, last: int) -> None:
        def error(done: Done) -> LinkLostError:
            outcome = Outcome.NOT_EXECUTED if done.instant.ticks > last else Outcome.UNKNOWN
            return kind(f"{reason}, and {self.registers.name} has forgotten the write at {done.instant}", outcome)

        self.give_up(error)

    async def _see_session(self) -> bool:
        """Return whether the gateway was reset, which empties its schedules."""
        is_as_before = self._session == self._link.interruptions and not self._is_torn
        return not is_as_before and await self._read_clock()

    async def clock(self) -> TickClock:
        """Read the gateway's clock and return it."""
        await self._read_clock()
        return self.time

    # Feeding

    async def check(self, instant: Instant, poster: object) -> None:
        """Raise the errors of earlier writes of a task or thread, before its next write at an instant.

        Raises:
            LateError: for an earlier write that was not executed, and whose error was not raised.
            NotArmedError: if it was not executed because the lease is not armed.
            GatewayResetError: if the gateway was reset since the last write, and its clock with it.
        """
        was_reset = await self._see_session()
        await self.raise_failures(raises_now(running(), poster))
        if was_reset:
            reason = f"the gateway was reset, and its clock with it: {instant} is an instant of before"
            raise GatewayResetError(reason, Outcome.NOT_EXECUTED)

    async def ready(self) -> None:
        """Begin, if the feed has not begun yet; otherwise read the clock, if its last reading is old."""
        if not self.has_begun:
            await self.begin()
        elif self._bounds.is_old(running().steady()):
            await self._read_clock()

    async def send(
        self, instant: Instant, words: Mapping[int, int], poster: object, lease: Lease | None = None
    ) -> Done:
        """Send a batch, after waiting for room in the queue if it is full.

        Args:
            instant: instant at which the batch is executed.
            words: words by their places on the stage.
            poster: task or thread that makes the write.
            lease: lease to kick while the queue is full.

        Raises:
            ArgumentError: for an instant that is not after the last one, or too far from the gateway's clock, and for a
                batch that is larger than the queue.
        """
        batch = batch_of(instant.ticks, words)
        self._check(instant, batch)
        await self._wait_for_room(instant, len(batch), poster, lease)
        most = most_words(self._link)
        address, queued = self.registers.entry.signal.address, list[Asked]()
        for start in range(0, len(batch), most):
            # The first one raises if this program's lease is over: then no word was sent.
            queued.append(Asked(self._link, address, write=batch[start : start + most], to_queue=True))
        self._last = instant
        self._room -= len(batch)
        self._sent += len(batch)
        done = Done(self, instant, len(batch), poster)
        self._pending.append(done)
        self._queued += queued
        while self._queued and (self._queued[0].done() or len(self._queued) > MOST_UNDER_WAY):
            await self._take_answer()
        return done

    async def _wait_for_room(self, instant: Instant, size: int, poster: object, lease: Lease | None) -> None:
        if self._is_passed(LOOK_BEHIND):
            # The outcomes of batches that ended long ago cannot be distinguished, so read them now.
            await self._look(lease)
        while self.has_begun and self._room < size:
            await self._look(lease)
            if self._room < size:
                await self._pause(max(size - self._room, self.registers.depth // PARTS), lease)
        if not self.has_begun:
            await self.raise_failures(raises_now(running(), poster))
            raise LateError(f"{self.registers.name} was cancelled before the write at {instant}", instant.ticks)

    def _is_passed(self, place: int) -> bool:
        """Return whether the instant of a batch in flight, by its place in the order, has certainly passed."""
        pending = self._pending
        return len(pending) > place and pending[place].instant.ticks < self._bounds.least(running().steady())

    async def _take_answer(self) -> None:
        try:
            await self._executed(self._queued.popleft())
        except UnansweredError:
            self._is_torn = True
            raise

    def _check(self, instant: Instant, batch: Sequence[int]) -> None:
        name = self.registers.name
        if len(batch) > min(self.registers.depth, MOST_WORDS + FRAME):
            most = min(self.registers.depth, MOST_WORDS + FRAME)
            raise ArgumentError(
                f"a write of {len(batch)} words at one instant is too long: {name} takes {most} at most"
            )
        if self._last is not None and instant.ticks <= self._last.ticks:
            raise ArgumentError(f"{name} writes in the order of the instants: {instant} is not after {self._last}")
        # The words of a batch have the instant modulo 2 ** 40: one that is further away would mean another instant.
        ahead, hertz = self.ahead(instant), instant.clock_hz
        if not -BEHIND <= ahead < AHEAD:
            side = "after" if ahead > 0 else "before"
            raise ArgumentError(
                f"{name} takes instants from {BEHIND / hertz:.0f} s before the gateway's clock to "
                f"{AHEAD / hertz:.0f} s after it: {instant} is {abs(ahead) / hertz:.0f} s {side} it"
            )

    def ahead(self, instant: Instant) -> int:
        """Return the ticks by which an instant is ahead of the gateway's clock; negative for a past one."""
        return instant.ticks - self._bounds.least(running().steady())

    async def _pause(self, size: int, lease: Lease | None) -> None:
        """Wait until batches of `size` words, or all, have ended; with a lease, for a part of its time-out at most."""
        pause = SHORTEST_PAUSE
        for done in self._pending:
            size -= done.size
            if size <= 0 or done is self._pending[-1]:
                pause = max(self.time.time_of(done.instant) - running().steady(), pause)
                break
        if lease is not None:
            pause = min(pause, lease.timeout / KICKS)
        await running().sleep(pause)

    # Outcomes

    async def wait_for(self, done: Done) -> None:
        """Wait until the outcome of a batch is known."""
        while done.acted is None:
            left = self.time.time_of(done.instant) - running().steady()
            await running().sleep(max(left, SHORTEST_PAUSE))
            await self._look()

    async def drain(self, lease: Lease | None = None) -> None:
        """Wait until the outcome of each batch is known."""
        while self._queued:
            # The loss is reported below, with the instants of the lost writes.
            with suppress(UnansweredError):
                await self._take_answer()
        while self._pending or self._unsure:
            await self._look(lease)
            if self._pending:
                await self._pause(self.registers.depth, lease)

    async def see(self, is_told: Callable[[object], bool], *, is_connected: bool) -> None:
        """Raise the errors of writes that are known not to be executed and are not awaited, as a fence does.

        Writes whose instants have passed are waited for, later ones are not. While a timeline is open, this raises
        nothing: the timeline raises the errors in its own block.

        Args:
            is_told: returns whether errors of a task or thread are raised by this call.
            is_connected: False if the gateway cannot be read.

        Raises:
            LateError: for a write that came too late.
            NotArmedError: for a write that was refused because its lease is not armed.
            LinkLostError: for a write of unknown outcome, because the connection was lost or the gateway was reset.
        """
        if self.line is not None:
            return
        if is_connected:
            await self._see_session()
            while self._pending or self._unsure:
                await self._look()
                if not self._unsure and not self._is_passed(0):
                    break
                await running().sleep(SHORTEST_PAUSE)
        else:
            self._void(LinkLostError, "the connection was lost", self._bounds.most(running().steady()))
        await self.raise_failures(is_told)

    async def raise_failures(self, is_told: Callable[[object], bool] | None = None) -> None:
        """Raise the error of batches that are known not to be executed and are not awaited.

        Args:
            is_told: returns whether errors of a task or thread are raised by this call; None for all.

        Raises:
            LateError: for a write that came too late.
            NotArmedError: for a write that was refused because its lease is not armed.
            LinkLostError: for a write that was lost with the connection or the session.
        """
        unseen = [done for done in self._failed if not done.is_awaited]
        failed = [done for done in unseen if is_told is None or is_told(done.poster)]
        self._failed = [done for done in unseen if done not in failed]
        if failed:
            raise await self.failure(failed)

    async def failure(self, failed: Sequence[Done]) -> Exception:
        """Return the error for batches that were not executed."""
        first, others = failed[0], len(failed) - 1
        if first.error is not None:
            return first.error
        more = f", and {others} more up to {failed[-1].instant}" if others else ""
        what = f"{self.registers.name} has not made the write at {first.instant}{more}"
        misfits = self.registers.robot.interface.misfits
        if self.registers.lease is not None and self.registers.lease not in misfits and self._refused:
            from unity_link.cores.lease import LeaseRegisters

            lease = LeaseRegisters(self.registers.robot, self.registers.lease)
            condition = await lease.condition()
            if condition.state != "armed":
                fault = await lease.fault(condition)
                return NotArmedError(f"{what}: {fault}", fault.reason, fault.instant)
        return LateError(f"{what}: it came too late, or was cancelled", first.instant.ticks)

    async def _ask(self) -> _Look:
        """Read the registers. The counters are read after the outcomes."""
        registers, link = self.registers, self._link
        fates = Asked(link, registers.fates.signal.address, registers.fates.signal.words)
        counters = Asked(link, registers.counters[0].address, len(registers.counters))
        try:
            ends = int(registers.fates.signal.decode(await fates.words()))
            numbers = zip(registers.counters, await counters.words(), strict=True)
            late, refused, room, _ = (int(signal.decode(word)) for signal, word in numbers)
        finally:
            fates.give_up()
            counters.give_up()
        return _Look(ends % _NUMBERS, ends >> _NUMBERS.bit_length() - 1, late, refused, room)

    async def _look(self, lease: Lease | None = None) -> None:
        """Read which batches have ended, and the room in the queue."""
        if lease is not None:
            await lease.kick()
        async with self._looking:
            sent = self._sent
            try:
                look = await self._ask()
            except GatewayResetError:
                # The link has a new session, in which earlier batches no longer exist.
                look = await self._ask()
            await self._see_session()
            if self.has_begun:
                await self._take(look, sent)

    async def _take(self, look: _Look, sent: int) -> None:
        """Process the contents of the registers, which were requested when `sent` words had been sent."""
        self._room = look.room - (self._sent - sent)
        new = (look.ended - self._ended) % _NUMBERS
        if new > len(self._pending):
            await self.cancel()
            raise ArgumentError(f"another program has written to {self.registers.name}, which has one writer at a time")
        self._ended = look.ended
        self._refused = look.refused
        for age in reversed(range(new)):
            done = self._pending.popleft()
            if age >= FATES:
                self._unsure.append(done)
            else:
                self._end(done, acted=not look.failed >> age & 1)
        self._settle((look.late + look.refused - self._base) % (1 << 32), new)

    def _settle(self, counted: int, new: int) -> None:
        """Determine by the counters whether all batches of a stretch were executed."""
        if not self._unsure:
            return
        if counted == self._counted:
            stretch, acted = self._unsure, True
        elif new:
            # The counters may include failures after the outcomes were read: decide after the next read.
            return
        else:
            stretch, acted = self._unsure, False
            self._counted = counted
        self._unsure = []
        for done in stretch:
            done.acted = acted
            self.acted += acted
        self._failed += [] if acted else stretch

    def _end(self, done: Done, *, acted: bool) -> None:
        done.acted = acted
        self.acted += acted
        self._counted += not acted
        if not acted:
            self._failed.append(done)


async def set_at(poster: object, proxy: Proxy[Any], value: Any, at: Instant) -> Done:
    """Write one signal at an instant, for a task or thread. Errors of its earlier writes are raised here.

    Raises:
        ArgumentError: for a signal that no schedule times, a value that it cannot have, no instant, and while a
            timeline feeds the schedule.
        LateError: if an earlier write was not executed.
        GatewayResetError: if the gateway was reset since the last write, because the instant is of the clock before.
    """
    schedule = proxy.signal.timed
    if schedule is None:
        raise ArgumentError(f"{proxy.path} cannot be written at an instant: its declaration has no TIMED")
    registers = ScheduleRegisters(proxy.robot, schedule)
    feed = feed_of(registers)
    if feed.line is not None:
        raise ArgumentError(f"{schedule} is fed by a timeline of this link: its `set` takes {proxy.path} as well")
    instant, words = feed.time.check(at), registers.words_of({proxy: value})
    await feed.check(instant, poster)
    await feed.ready()
    return await feed.send(instant, words, poster)


def feed_of(registers: ScheduleRegisters) -> ScheduleFeed:
    """Return the only writer of a schedule on its link. Fences of the link raise its errors."""
    told = registers.link.told_by_fence
    address = registers.entry.signal.address
    if address not in told:
        told[address] = ScheduleFeed(registers)
    feed: ScheduleFeed = told[address]
    return feed


class Timeline(Sealed):
    """Writes at instants, in an ``async with`` block; `ScheduleVerbs.timeline` makes it.

    `set` takes values for the present instant of the timeline, `delay` moves that instant. If the queue is full, `set`
    waits for room. At the end of the block all writes have been executed, or `LateError` is raised. If the block ends
    with an error, writes that were not executed are cancelled.
    """

    def __init__(self, registers: ScheduleRegisters, lead: float, lease: Lease | None) -> None:
        self.lead = lead
        """Seconds from the beginning of the block to the first instant."""
        self._registers = registers
        self._feed = feed_of(registers)
        self._lease = lease
        self._kicked_at: float | None = None
        self._is_on = self._was_on = False
        self._at = Fraction(0)
        """Present instant in ticks; writes round it to whole ticks."""

    if not TYPE_CHECKING:  # A type checker reports such uses by itself.
        __await__ = __enter__ = __exit__ = __aiter__ = __iter__ = refusing(_OPEN)

    def _called(self) -> str:
        return "a timeline"

    @property
    def instant(self) -> Instant:
        """The present instant of the timeline."""
        return Instant(round(self._at), self._feed.time.clock_hz)

    def __repr__(self) -> str:
        """Return the schedule's name, and the state or the present instant."""
        state = f"at {self.instant}" if self._is_on else "over" if self._was_on else "not begun"
        return f"<timeline of {self._feed.registers.name}, {state}>"

    async def __aenter__(self) -> Self:
        """Cancel all batches in the schedule, and read the gateway's clock.

        Raises:
            ArgumentError: if another timeline of the link is open.
        """
        name = self._feed.registers.name
        if self._was_on:
            raise ArgumentError(f"this timeline of {name} was used before: `timeline` makes one for each block")
        if self._feed.line is not None:
            raise ArgumentError(f"{name} is fed by another timeline of this link: a schedule has one writer at a time")
        self._feed.line, self._was_on = self, True
        try:
            await self._feed.begin()
            self._at = Fraction(self._feed.time.now().after(self.lead).ticks)
        except BaseException:
            self._feed.line = None
            raise
        self._is_on = True
        return self

    @whole_exit
    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Wait until all writes have been executed; after an error, cancel those that have not.

        Raises:
            LateError: if a write was not executed.
        """
        try:
            if error is None:
                await self.flush()
            elif isinstance(error, Exception):
                await self._feed.leave(error)
            else:
                # Errors that end a program, such as KeyboardInterrupt, must not wait for an answer.
                self._feed.give_up()
                with suppress(NotArmedError):
                    await post_in_session(self._registers.link, self._registers.cancel.signal.address, 1)
        finally:
            self._is_on = False
            self._feed.line = None

    @returns_coroutine
    def set(self, values: Mapping[Any, Any], *, at: Instant | None = None) -> Coroutine[Any, Any, Done]:
        """Write values to signals at an instant, all in one clock cycle.

        Args:
            values: values by their signals, all of them `TIMED` by the schedule.
            at: instant after the last one, which becomes the present instant; None for the present instant.

        Returns:
            An object that can be awaited until the writes have been executed. An error that is not awaited is raised by
            `flush`, by a later `set`, or at the end of the block.

        Raises:
            ArgumentError: for values that signals cannot have, or an instant that is not after the last one; nothing
                was sent.
            LateError: if an earlier write was not executed.
            NotArmedError: if it was not executed because the lease is not armed.
            GatewayResetError: if the gateway was reset, which empties its schedules and ends the timeline.
            LinkLostError: if the link has ended.
        """
        return self._set(caller_on(self._registers.link), values, at)

    async def _set(self, poster: object, values: Mapping[Any, Any], at: Instant | None) -> Done:
        self._check_on()
        instant = self.instant if at is None else self._feed.time.check(at)
        done = await self.put(self._registers.words_of(values), instant, poster)
        if at is not None:
            self._at = Fraction(at.ticks)
        return done

    async def approach(self, at: Instant) -> None:
        """Wait until an instant is near enough for the schedule to accept it."""
        while (beyond := (self._feed.ahead(at) - AHEAD // 2) / at.clock_hz) > 0:
            await self._kick()
            await running().sleep(beyond if self._lease is None else min(beyond, self._lease.timeout / KICKS))

    async def put(self, words: Mapping[int, int], at: Instant, poster: object) -> Done:
        """Write words to places of the stage at an instant, for a task or thread; otherwise as `set`."""
        await self._kick()
        await self._feed.check(at, poster)
        return await self._feed.send(at, words, poster, self._lease)

    def delay(self, seconds: float) -> None:
        """Move the present instant by `seconds`; back, for a negative number.

        Raises:
            ArgumentError: if `seconds` is no finite number, if the ticks of the new instant are out of range, and
                outside of the block.
        """
        self._check_on()
        self._at = ticks_after(self._at, seconds, self._feed.time.clock_hz)

    async def flush(self) -> int:
        """Wait until all writes have been executed.

        Returns:
            The number of instants whose writes were executed since the last flush.

        Raises:
            LateError: if a write was not executed.
            NotArmedError: if it was not executed because the lease is not armed.
        """
        self._check_on()
        await self._feed.drain(self._lease)
        acted, self._feed.acted = self._feed.acted, 0
        await self._feed.raise_failures()
        return acted

    async def _kick(self) -> None:
        lease, now = self._lease, running().time()
        if lease is not None and (self._kicked_at is None or now - self._kicked_at >= lease.timeout / KICKS):
            await lease.kick()
            self._kicked_at = now

    def _check_on(self) -> None:
        if not self._is_on:
            name = self._feed.registers.name
            raise ArgumentError(f"a timeline is used in its block: async with {name}.timeline() as line")
