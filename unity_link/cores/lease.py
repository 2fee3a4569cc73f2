"""A lease: the right of one program to move outputs, for as long as it says so.

`LeaseVerbs.armed` makes a `Lease` for an ``async with`` block. Each kick names the end of the lease as an instant of
the gateway's clock, so what waits in a kernel, a server or a repetition prolongs nothing. Kicks come of the program's
own loop; nothing runs in the background.
"""

from __future__ import annotations

import contextlib
import functools
import logging
import secrets
from collections import deque
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Protocol, Self, TypeVar

from unity_link.cores import AtPins, CoreRegisters, Model, RobotVerbs, Verbs, members_of
from unity_link.cores.clock import TURN, TickBounds
from unity_link.errors import (
    ArgumentError,
    BusError,
    GatewayError,
    LinkLostError,
    NotArmedError,
    Sealed,
    UnityLinkError,
    refusing,
    shown,
)
from unity_link.link.asked import Asked, post_in_session
from unity_link.link.guards import guard, guard_of, release
from unity_link.link.interrupts import whole_exit
from unity_link.link.runtimes.synchronisation import running
from unity_link.protocol.wire.numbers import real_number
from unity_link.spec.kinds import name_of

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Awaitable, Sequence
    from types import TracebackType

    from unity_link.cores import Pins
    from unity_link.link.link import Link
    from unity_link.spec.model import ComponentSpec

T = TypeVar("T")
log = logging.getLogger("unity_link.cores")
TIME_BITS = 40
"""Bits of an end in a word that arms or kicks; the token stands above."""
TOKEN_BITS = 24
FINISHES = 1 << TOKEN_BITS - 1
"""Bit of a token whose owner wants what is scheduled to go on behind the end."""
LONGEST_START = 1.0
"""Seconds for which `Lease.each` kicks while it waits for the first sample of a group."""
NEAREST = 0.98
"""Part of TIMEOUT that a kick asks for at most: what is further ahead is refused, and the clock of a compiled gateway
is ahead by the cycles that its answers took."""
ATTEMPTS = 3
"""Arms of a lease whose end has come before they could take effect."""
MOST_KICKS = 16
"""Kicks that are under way; the next one waits for the first of them."""
BUFFER = 16_384
"""Samples that wait for the body of a loop, as in `unity_link.Link.subscribe`."""
_ENDED = {"disarmed": "was disarmed", "silence": "has run out", "estop": "was stopped by its e-stop"}
MOST_ARMS = 1 << 16
"""Leases after which their count begins again."""
_OPEN = "write `async with` before this lease, and `with` where it is one of a blocking link"


class _LateError(NotArmedError):
    """A lease that was over before it could begin."""


class _Group(Protocol):
    """A group of signals, as far as a lease knows it."""

    name: str
    proxies: tuple[Any, ...]

    @property
    def feed(self) -> Any:
        """Its samples."""


class _Condition(NamedTuple):
    """State of a lease, as its registers tell it."""

    armed: bool
    """True also while it is finishing."""
    state: str
    reason: str
    estop_open: bool
    arms: int
    """Leases that have begun since the reset, modulo 2 ** 16."""


class LeaseRegisters(CoreRegisters):
    """The registers of a lease."""

    def __init__(self, robot: Any, name: str) -> None:
        super().__init__(robot, name)
        find = self.find
        self.most_seconds = float(self.core.generics["most_us"]) / 1e6
        """Most seconds that an end may be ahead."""
        self.finish_seconds = float(self.core.generics.get("finish_us", 0)) / 1e6
        """Most seconds for which what is scheduled may go on behind the end."""
        self.arm, self.kick, self.clock = find("arm"), find("kick"), find("clock")
        self.disarm, self.fault_time = find("disarm"), find("fault_time")
        self._fields = tuple(find(field).signal for field in ("armed", "state", "reason", "estop_open"))
        self._arms = find("arms").signal
        self.address: int = self._fields[0].address
        self.link: Link = self.arm.link

    @functools.cached_property
    def guarded(self) -> frozenset[int]:
        """Addresses that the owner of the lease writes: its kick, what it guards, and the queues of its schedules."""
        addresses: frozenset[int] = self.robot.interface.written_under(self.name)
        return addresses

    @functools.cached_property
    def cancels(self) -> frozenset[int]:
        """Addresses that cancel the schedules of the lease."""
        interface = self.robot.interface
        names = (f"{path}.cancel" for path in interface.schedules_of(self.name))
        return frozenset(interface.signals[name].address for name in names if name in interface.signals)

    def held(self, condition: _Condition) -> Lease | None:
        """Return the lease of this program that the registers describe; None for another program's."""
        lease = guard_of(self.link, self.kick.signal.address)
        return lease if isinstance(lease, Lease) and lease.is_of(condition) else None

    def ask(self) -> Asked:
        """Ask for the words of the state."""
        return Asked(self.link, self.address, 2)

    def condition_of(self, words: Sequence[int]) -> _Condition:
        """Return what the words of the state say."""
        state_word, arms_word = words
        armed, state, reason, estop_open = (signal.decode(state_word) for signal in self._fields)
        arms = int(self._arms.decode(arms_word))
        return _Condition(bool(armed), name_of(state), name_of(reason), bool(estop_open), arms)

    async def condition(self) -> _Condition:
        """Read the state, in one transaction of the bus."""
        return self.condition_of((await self.link.read_block(self.address, 2)).tolist())

    async def fault(self, condition: _Condition) -> NotArmedError:
        """Return the error for a lease that is not armed, or takes nothing any more as it is finishing."""
        if condition.state == "finishing":
            message = f"{self.name} is finishing: no kick came before its end, and what was scheduled by then runs out"
            return NotArmedError(message, "silence")
        if condition.state != "fault":
            how = "nobody has armed it since the reset" if condition.reason == "none_yet" else "it was disarmed"
            return NotArmedError(f"{self.name} is not armed: {how}", condition.reason)
        instant = await self.fault_time.get() / self.link.gateway.clock_hz
        how = "its e-stop was opened" if condition.reason == "estop" else "no kick came before its end"
        message = f"{self.name} is not armed: {how}, at {instant:.6f} s of the gateway's clock"
        return NotArmedError(message, condition.reason, instant)


async def refused(error: BusError, robot: Any, lease: str) -> BusError:
    """Return the error for a write that the bus has refused: another one where the lease that guards it is not armed.

    Args:
        error: of the bus.
        robot: with the lease.
        lease: its path.
    """
    if isinstance(error, NotArmedError) or lease in robot.interface.misfits:
        return error
    registers = LeaseRegisters(robot, lease)
    condition = await registers.condition()
    if condition.state == "armed":
        if registers.held(condition) is not None:
            return error
        # A gateway takes it then: a server between does not.
        return BusError(
            f"{error}: another program has armed {lease}, and it alone may move what that guards", error.code
        )
    fault = await registers.fault(condition)
    return NotArmedError(f"{error}: {fault}", fault.reason, fault.instant)


class LeaseVerbs(Verbs):
    """Verbs of a LEASE."""

    def armed(self, *, timeout: float | None = None, on_silence: Literal["safe", "finish"] = "safe") -> Lease:
        """Return a lease for an ``async with`` block: it is armed where that begins, and disarmed where it ends.

        Args:
            timeout: seconds from each kick to the end that it names; None for the most, which is 98 % of TIMEOUT in the
                spec.
            on_silence: at the end, where no kick came: ``"safe"``: all that it guards is safe at once. ``"finish"``:
                what its schedule has accepted by then acts first, for FINISH seconds of the spec at most.

        Raises:
            ArgumentError: for a time-out that is not above 0, or is above that of the spec; for ``"finish"`` where the
                spec has no FINISH, or no schedule writes what the lease guards.
            UnsupportedError: if the board's LEASE differs from the one of this version.
        """
        registers = LeaseRegisters.of(self)
        most, name = registers.most_seconds, registers.name
        what = f"the time-out of {name} is a number of seconds above 0, and {most:g} s at most as its spec says"
        seconds = most if timeout is None else real_number(timeout, what)
        if not 0 < seconds <= most:
            raise ArgumentError(f"{what}, not {shown(timeout)}")
        if on_silence not in {"safe", "finish"}:
            raise ArgumentError(f"on_silence={on_silence!r:.40}: 'safe' or 'finish' was expected")
        finishes = on_silence == "finish"
        if finishes and not registers.finish_seconds:
            raise ArgumentError(
                f"{name} does not finish what is scheduled: its spec gives it no FINISH, as in LEASE(FINISH=1)"
            )
        if finishes and not registers.robot.interface.schedules_of(name):
            raise ArgumentError(f"{name} has nothing to finish: no signal that it guards is TIMED by a SCHEDULE")
        return Lease(registers, min(seconds, NEAREST * most), finishes=finishes)

    async def stop(self) -> bool:
        """Disarm it, whoever has armed it: all that it guards is safe when this returns.

        Returns:
            True if it was armed.
        """
        registers = LeaseRegisters.of(self)
        # The state is asked for on the way: nothing waits before the write.
        state = registers.ask()
        try:
            await registers.disarm.set(1)
            was_armed = registers.condition_of(await state.words()).armed
        finally:
            state.give_up()
        log.info("%s: lease %s: disarmed by a stop", registers.link.name, registers.name)
        return was_armed


class LeasedRobot(RobotVerbs):
    """Verbs of a robot with a LEASE."""

    def armed(self, *, timeout: float | None = None, on_silence: Literal["safe", "finish"] = "safe") -> Lease:
        """Return the only lease of the robot, as `LeaseVerbs.armed`.

        Raises:
            ArgumentError: where it has several; and as `LeaseVerbs.armed`.
            UnsupportedError: as `LeaseVerbs.armed`.
        """
        leases = leases_of(self)
        if len(leases) != 1:
            robot: Any = self
            calls = " or ".join(f"{path}.armed()" for path in leases)
            raise ArgumentError(
                f"{robot.interface.name} has {len(leases)} leases, and none is meant by itself: {calls}"
            )
        return next(iter(leases.values())).armed(timeout=timeout, on_silence=on_silence)


def leases_of(robot: Any) -> dict[str, LeaseVerbs]:
    """Return the leases of a robot by their paths."""
    return members_of(robot, LeaseVerbs)


class Lease(Sealed):
    """The right to move what a LEASE guards, in an ``async with`` block; `LeaseVerbs.armed` makes it.

    In the block the program kicks: by `each` as its loop comes round, or by `kick`. Where the lease has ended, for want
    of kicks, by an e-stop or because somebody disarmed it, the next of them raises `NotArmedError`.
    """

    def __init__(self, registers: LeaseRegisters, seconds: float, *, finishes: bool) -> None:
        self.timeout = seconds
        """Seconds from each kick to the end that it names."""
        self._finishes = finishes
        self._registers = registers
        self._link = registers.link
        hertz = self._link.gateway.clock_hz
        self._ticks = max(1, int(seconds * hertz))
        self._clock = TickBounds(hertz)
        self._token = 0
        self._end = 0
        self._state: Asked | None = None
        """State that was asked for with the last kick."""
        self._kicks: deque[Asked] = deque()
        """Kicks that are under way."""
        self._arms = 0
        """Count of leases that have begun, with this one."""
        self._session: int | None = None
        """Number of the link's interruptions when it was armed; None before."""
        self._is_on = self._was_on = False
        self._ended: tuple[str, str, float | None] | None = None
        """Message, reason and instant of the end, once it is known: what is armed now is not its own."""

    if not TYPE_CHECKING:  # A type checker refuses them by itself.
        __await__ = __enter__ = __exit__ = __aiter__ = __iter__ = refusing(_OPEN)

    def _called(self) -> str:
        return "a lease"

    def __repr__(self) -> str:
        """Return what it is of, and whether it is in its block."""
        state = "in its block" if self._is_on else "over" if self._was_on else "not begun"
        return f"<lease of {self._registers.name}, {state}: {self.timeout:g} s>"

    async def __aenter__(self) -> Self:
        """Arm, behind all that was asked for before.

        Raises:
            NotArmedError: where it could not be armed.
        """
        if self._was_on:
            raise ArgumentError(
                f"this lease of {self._registers.name} was used before: `armed` makes one for each block"
            )
        self._was_on = True
        await self._link.fence()
        try:
            # A machine that is busy may be late once, with an end that is as near as a time-out.
            for _ in range(ATTEMPTS - 1):
                with contextlib.suppress(_LateError):
                    await self._arm()
                    break
            else:
                await self._arm()
        except BaseException as error:
            await self._let_go(error, arming=True)
            raise
        self._is_on = True
        log.info("%s: lease %s: armed, with a time-out of %g s", self._link.name, self._registers.name, self.timeout)
        guard(self._link, self._registers.guarded, self)
        return self

    async def _read_clock(self) -> None:
        asked = running().steady()
        ticks = await self._in_session(self._registers.clock.get())
        self._clock.read(int(ticks), asked, running().steady())

    async def _arm(self) -> None:
        registers, link = self._registers, self._link
        self._session = self._ended = None
        state = registers.ask()
        try:
            await self._read_clock()
            first = registers.condition_of(await state.words())
        finally:
            state.give_up()
        self._check_free(first)
        self._token = secrets.randbits(TOKEN_BITS - 1) | (FINISHES if self._finishes else 0)
        self._end = self._clock.least(running().steady()) + self._ticks
        self._session, self._arms = link.interruptions, (first.arms + 1) % MOST_ARMS
        signal = registers.arm.signal
        asked = registers.ask(), Asked(link, signal.address, write=signal.encode(self._word())), registers.ask()
        try:
            before = registers.condition_of(await asked[0].words())
            error = await _refusal_of(asked[1])
            after = registers.condition_of(await asked[2].words())
        finally:
            for one in asked:
                one.give_up()
        self._check_session()
        if error is not None and not isinstance(error, BusError):
            # It may have been executed all the same.
            raise error
        self._arms = after.arms
        if after.armed and not before.armed and after.arms == (before.arms + 1) % MOST_ARMS and error is None:
            return
        self._ended = f"{registers.name} was not armed", "taken", None
        self._check_free(before)
        self._check_free(after)
        if error is not None:
            raise error
        if after.estop_open:
            raise NotArmedError(f"{registers.name} cannot be armed: its e-stop is open", "estop")
        message = f"{registers.name} was not armed: its end, {self.timeout:g} s ahead, came before the word did"
        raise _LateError(message, "late")

    def _check_free(self, condition: _Condition) -> None:
        """Check that no program has the lease.

        Raises:
            NotArmedError: if a program has it.
        """
        if not condition.armed:
            return
        is_finishing = condition.state == "finishing"
        if self._registers.held(condition) is not None:
            how = "this program has armed it already, in another block"
            how += ", and what was scheduled there runs out" if is_finishing else ""
        else:
            how = "that of another program is finishing" if is_finishing else "another program has armed it"
        raise NotArmedError(f"{self._registers.name} cannot be armed: {how}", "taken")

    def _word(self) -> int:
        return self._token << TIME_BITS | self._end % (1 << TIME_BITS)

    @whole_exit
    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Disarm.

        Where the link is lost the lease runs out by itself, which a note on the error says.
        """
        self._is_on = False
        for asked in (*self._kicks, *([] if self._state is None else [self._state])):
            asked.give_up()
        try:
            if error is not None:
                await self._let_go(error)
            else:
                await self._disarm()
        finally:
            release(self._link, self)

    # The end

    def ended(self) -> NotArmedError | None:
        """Return the error for a lease that is over for the program; None while the program may have it.

        It is over once the link has begun another session since it was armed. The gateway may have been reset then, and
        the registers may describe a lease that another program has armed since, with the same count.
        """
        if self._ended is None and self._session not in {None, self._link.interruptions}:
            name, why = self._registers.name, self._link.interrupted_by
            self._end_as(f"{name} has ended: the link has begun another session since it was armed ({why})", "reset")
        return None if self._ended is None else NotArmedError(*self._ended)

    def refusal(self, address: int) -> NotArmedError | None:
        """Return the error for a write to an address if the lease is over, or its time-out has passed; None otherwise.

        Another program may have armed the lease after the time-out, and the write would act under that program's lease.
        A kick asks the gateway, whose clock decides: if the lease has not ended there, writes are accepted again. What
        is scheduled may be cancelled while the lease is finishing.
        """
        error = self.ended()
        if error is None and self._has_ended() and not (self._finishes and address in self._registers.cancels):
            more = ", and writes that were scheduled by then may still act" if self._finishes else ""
            message = f"{self._registers.name} has ended: no kick came within {self.timeout:g} s{more}"
            error = NotArmedError(message, "silence")
        return error

    def _end_as(self, message: str, reason: str, instant: float | None = None) -> None:
        """Record why the lease is over, for a call that raises it."""
        self._ended = message, reason, instant
        log.info("%s: lease %s: %s", self._link.name, self._registers.name, message)

    def _log_silence(self) -> None:
        """Log that the lease ran out in a block that has not kicked since, so that no call has raised it."""
        if self._ended is None:
            log.warning("%s: lease %s: it ran out, because no kick came in time", self._link.name, self._registers.name)

    def _check_session(self) -> None:
        """Check that the lease is not known to be over.

        Raises:
            NotArmedError: if it is.
        """
        if (error := self.ended()) is not None:
            raise error

    async def _in_session(self, answer: Awaitable[T]) -> T:
        """Wait for an answer about the lease.

        Raises:
            NotArmedError: if another session has begun: the answer may come from it.
        """
        try:
            answered = await answer
        except LinkLostError:
            self._check_session()
            raise
        self._check_session()
        return answered

    def is_of(self, condition: _Condition) -> bool:
        """Return whether the registers describe this lease, which goes on."""
        return self.ended() is None and condition.armed and condition.arms == self._arms

    def _has_ended(self) -> bool:
        return self.ended() is not None or self._clock.least(running().steady()) >= self._end

    async def _is_finishing(self) -> bool:
        """Return whether its end has come, and what was scheduled goes on; nobody else can have armed it then."""
        if self.ended() is not None or not self._finishes:
            return False
        condition = await self._registers.condition()
        return self.is_of(condition) and condition.state == "finishing"

    async def _disarm(self) -> None:
        try:
            if not self._has_ended() or await self._is_finishing():
                await self._write_disarm()
            else:
                self._log_silence()
        except UnityLinkError as lost:
            lost.add_note(self._note())
            raise
        except BaseException as error:
            # The write may not have been sent when this was cancelled.
            await self._let_go(error, arming=True)
            raise

    async def _let_go(self, error: BaseException, *, arming: bool = False) -> None:
        """Disarm after an error, which is not hidden by one of its own; waits no longer than the lease lasts.

        Args:
            error: of the block.
            arming: whether it is not known that the lease is armed.
        """
        # A coroutine that is closed cannot wait.
        waits = not isinstance(error, GeneratorExit)
        if self._session is None:
            return
        try:
            if arming or self._has_ended():
                if (arming and not waits) or self._session != self._link.interruptions:
                    # The gateway may have it armed.
                    error.add_note(self._note())
                if not waits or not await self._goes_on(arming=arming):
                    if not arming:
                        self._log_silence()
                    return
            if waits:
                async with running().last_timeout(self.timeout):
                    await self._write_disarm()
            else:
                await post_in_session(self._link, self._registers.disarm.signal.address, 1)
                log.info("%s: lease %s: a disarm is posted", self._link.name, self._registers.name)
        except (UnityLinkError, TimeoutError):
            error.add_note(self._note())

    async def _write_disarm(self) -> None:
        """Disarm; in another session than the one under way this could be the lease of another program."""
        signal = self._registers.disarm.signal
        await Asked(self._link, signal.address, write=signal.encode(1)).words()
        log.info("%s: lease %s: disarmed", self._link.name, self._registers.name)

    async def _goes_on(self, *, arming: bool) -> bool:
        """Return whether a lease is to be disarmed that may not be armed; waits no longer than the lease lasts."""
        async with running().last_timeout(self.timeout):
            if not arming:
                return await self._is_finishing()
            # The gateway may have executed the arm, although its answer was not awaited.
            return self.ended() is None and self.is_of(await self._registers.condition())

    def _note(self) -> str:
        name = self._registers.name
        more = f", and finishes what is scheduled, for {self._registers.finish_seconds:g} s at most"
        return (
            f"{name} could not be disarmed for sure: it runs out by itself, {self.timeout:g} s after the last kick"
            f"{more if self._finishes else ''}"
        )

    # Kicks

    async def each(self, group: _Group, *, latest: bool = False) -> AsyncIterator[Any]:
        """Iterate over the samples of a group, and kick with each: as the loop comes round.

        The end of the lease is a time-out behind the instant at which the gateway took the newest sample that has come:
        one that has waited on its way prolongs the lease by that much less.

        Args:
            group: of the robot, published with timestamps.
            latest: keep the newest sample alone, for a controller: a body that is slower than the samples acts on none
                that is old. Otherwise the samples wait for it, and it loses the lease when they have waited too long.

        Raises:
            ArgumentError: for a group of another gateway, or without timestamps.
            NotArmedError: where the lease has ended.
            SamplesLostError: where the loop's body is much too slow.
            LinkLostError: when the link ends.
        """
        self._check_on()
        if any(proxy.link is not self._link for proxy in group.proxies):
            raise ArgumentError(f"{group.name} has signals of another gateway than {self._registers.name} is of")
        await self._read_clock()
        last: int | None = None
        overflow = "drop_oldest" if latest else "fail"
        with group.feed.listen(buffer=1 if latest else BUFFER, overflow=overflow) as listener:
            batch = await self._first(listener)
            while True:
                self._check_on()
                samples = list(batch)
                if samples[-1].time is None:
                    advice = f"declare it with them, as in group {group.name}(RATE=500, TIMESTAMPS)"
                    raise ArgumentError(f"{group.name} has no timestamps, of which kicks are made: {advice}")
                last = self._ticks_of(samples[-1].time, last)
                self._clock.see(last, running().steady())
                for sample in samples:
                    self._check_on()
                    await self._kick(last + self._ticks)
                    yield sample
                batch = await listener.next()

    async def _first(self, listener: Any) -> Any:
        """Wait for the first samples, and kick meanwhile: a group begins more slowly than it goes on."""
        give_up = running().time() + LONGEST_START
        while running().time() < give_up:
            await self.kick()
            with contextlib.suppress(TimeoutError):
                async with running().timeout(self.timeout / 4):
                    return await listener.next()
        return await listener.next()

    def _ticks_of(self, time: float, last: int | None) -> int:
        """Return the gateway's clock at the time of a sample; `last` is that of the one before."""
        timestamp = self._link.timestamp_of(time)
        if last is not None:
            return last + (timestamp - last) % TURN
        return self._clock.nearest(timestamp, running().steady())

    async def kick(self) -> None:
        """Move the end of the lease to a time-out from now.

        The gateway's clock is estimated, never ahead of the truth, and behind it by no more than the answer of its
        reading was on its way and what the clocks drift apart in `clock.READ_AGAIN` seconds; then it is read again,
        which is waited for.

        Raises:
            ArgumentError: outside of the block.
            NotArmedError: where the lease has ended.
            LinkLostError: when the link has ended.
        """
        self._check_on()
        if self._clock.is_old(running().steady()):
            await self._read_clock()
        await self._kick(self._clock.least(running().steady()) + self._ticks)

    def _check_on(self) -> None:
        if not self._is_on:
            raise ArgumentError(f"a lease is kicked in its block: async with {self._registers.name}.armed() as lease")
        self._check_session()

    async def _kick(self, end: int) -> None:
        """Kick, and look at what the gateway has said of the lease since the kick before."""
        registers = self._registers
        if self._state is not None and (self._state.done() or self._has_ended()):
            state, self._state = self._state, None
            await self._check_mine(registers.condition_of(await self._in_session(state.words())))
        while self._kicks and (self._kicks[0].done() or len(self._kicks) == MOST_KICKS):
            await self._take_answer(self._kicks.popleft())
        if self._has_ended():
            await self._check_mine(await self._in_session(registers.condition()))
            # Its clock is behind what was thought of it.
            await self._read_clock()
        if end > self._end:
            self._end = end
            signal = registers.kick.signal
            # The words are one transaction: where they were several, those of another program could come in between.
            self._kicks.append(Asked(self._link, signal.address, write=signal.encode(self._word())))
        if self._state is None:
            self._state = registers.ask()

    async def _take_answer(self, kick: Asked) -> None:
        """Take the answer to a kick: where it was refused, the lease may be another program's."""
        refusal = await self._in_session(_refusal_of(kick))
        if refusal is not None:
            await self._check_mine(await self._in_session(self._registers.condition()), refused=True)

    async def _check_mine(self, condition: _Condition, *, refused: bool = False) -> None:
        """Check that it has not ended.

        Args:
            condition: of the registers.
            refused: whether a kick was refused: a server refuses kicks, a gateway does not.

        Raises:
            NotArmedError: where it has; also where another one has begun since.
        """
        name, is_mine = self._registers.name, condition.arms == self._arms
        if condition.state == "armed" and is_mine and not refused:
            return
        if condition.state != "armed":
            fault = await self._in_session(self._registers.fault(condition))
            self._end_as(str(fault), fault.reason, fault.instant)
        elif is_mine:
            how = "a server has refused its kick, as after another session of the server with the gateway"
            self._end_as(f"{name} has ended: {how}", "reset")
        else:
            how = _ENDED.get(condition.reason, "has ended")
            self._end_as(f"{name} {how}, and another program has armed it since", condition.reason)
        self._check_session()


async def _refusal_of(asked: Asked) -> GatewayError | None:
    """Return the error by which a bus, or a server, has refused a write; None if it was executed."""
    try:
        await asked.words()
    except GatewayError as error:
        return error
    return None


class LeaseModel(Model):
    """A lease on `sim:`, to the cycle as the entity has it, but for the two cycles that a word takes."""

    def __init__(self, component: ComponentSpec, part: Any, around: Any) -> None:
        super().__init__(component, part, around)
        self._token = self._end = 0
        self._emptied: int | None = None

    def reset(self) -> None:
        """Disarm, as if nobody had armed it."""
        self._end_as("disarmed", "none_yet")
        self.part.fault_time = 0
        self.part.arms = 0

    @property
    def due(self) -> int | None:
        """Return the end of the lease."""
        if not self.part.armed:
            return None
        return self._end if self._emptied is None else min(self._end, self._emptied + 1)

    def step(self, dt: float) -> None:  # noqa: ARG002  (the clock says more)
        """End the lease where its end has come, or nothing is left to finish."""
        self.part.clock = now = self.around.now
        if self.part.finishing and self._emptied is None and self.around.is_empty:
            self._emptied = now
        if not self.part.armed:
            return
        if self._emptied is not None and now > self._emptied:
            self._fall("silence", self._emptied)
        elif now >= self._end:
            self._run_out()

    def _run_out(self) -> None:
        part = self.part
        if part.finishing or not self._token & FINISHES or self.around.is_empty:
            self._fall("silence", self._end - 1)
            return
        part.finishing, part.state = True, "finishing"
        self._end += self._cycles("finish_us", 0)

    def written(self, name: str) -> None:
        """Arm, kick, disarm, or look at the e-stop."""
        part = self.part
        if name == "arm":
            self._take(part.arm, is_arm=True)
        elif name == "kick":
            self._take(part.kick, is_arm=False)
        elif name == "disarm" and part.armed:
            self._end_as("disarmed", "disarmed")
        elif name == "estop":
            part.estop_open = not part.estop
            if part.armed and part.estop_open:
                self._fall("estop", self.around.now)

    def _take(self, word: int, *, is_arm: bool) -> None:
        part, now = self.part, self.around.now
        token, ahead = word >> TIME_BITS, (word - now) % (1 << TIME_BITS)
        if part.finishing or (token & FINISHES and not self.generics.get("finish_us")):
            return
        if part.armed and now + 1 >= self._end:
            # The word would act one cycle later, when the lease has ended.
            self._run_out()
            if part.finishing:
                return
        may = token == self._token if part.armed else is_arm
        # It acts two cycles later, and an end that has come by then is none.
        if (
            not may
            or part.estop_open
            or not 3 <= ahead <= self._cycles("most_us", 100_000)
            or (part.armed and now + ahead <= self._end)
        ):
            return
        part.arms = (part.arms + (not part.armed)) % MOST_ARMS
        part.armed, part.state, part.enable = True, "armed", 1
        self._token, self._end = token, now + ahead

    def _cycles(self, generic: str, otherwise: int) -> int:
        return min(-(-int(self.generics.get(generic, otherwise)) * self.around.clock_hz // 1_000_000), 1 << 30)

    def _fall(self, reason: str, instant: int) -> None:
        self._end_as("fault", reason)
        self.part.fault_time = instant

    def _end_as(self, state: str, reason: str) -> None:
        part = self.part
        part.armed, part.finishing, part.state, part.reason, part.enable = False, False, state, reason, 0
        self._emptied = None
        self.around.make_safe()


class LeaseAtPins(AtPins):
    """A lease that a plant sees by its enable pin."""

    def __init__(self, component: ComponentSpec, part: Any, around: Pins) -> None:
        super().__init__(component, part, around)
        if around.has("enable"):
            self.shows = frozenset({"armed"})

    def step(self, dt: float) -> None:  # noqa: ARG002  (the level of now counts)
        """Look at the pin."""
        if self.shows:
            self.around.show("armed", bool(self.part.enable))
