"""A lease: the right of one program to move outputs, until an instant that each kick moves ahead.

`LeaseVerbs.armed` makes a `Lease` for an ``async with`` block. Each kick has the end of the lease as an instant of the
gateway's clock, so a kick that is delayed in a kernel, in a server or by a retransmission does not prolong the lease.
Only the program's own loop kicks; no task kicks in the background.
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
"""Bits of an end in a word that arms or kicks; the token is in the bits above."""
TOKEN_BITS = 24
FINISHES = 1 << TOKEN_BITS - 1
"""Bit of a token; if it is set, scheduled writes continue after the end of the lease."""
LONGEST_START = 1.0
"""Seconds for which `Lease.each` kicks while it waits for the first sample of a group."""
NEAREST = 0.98
"""Largest part of TIMEOUT that a kick asks for. The gateway refuses an end that is further ahead than TIMEOUT, and the
clock of a compiled gateway is ahead by the cycles that its answers took."""
ATTEMPTS = 3
"""Attempts to arm a lease, if its end comes before the arm takes effect."""
MOST_KICKS = 16
"""Most kicks in flight; the next kick waits for the first of them."""
BUFFER = 16_384
"""Most samples that wait for the body of a loop, as in `unity_link.Link.subscribe`."""
_ENDED = {"disarmed": "was disarmed", "silence": "has run out", "estop": "was stopped by its e-stop"}
MOST_ARMS = 1 << 16
"""Number of leases after which their count wraps around."""
_OPEN = "write `async with` before this lease, and `with` where it is one of a blocking link"


class _LateError(NotArmedError):
    """The end of the lease came before the lease was armed."""


class _Group(Protocol):
    """The attributes of a group that a lease uses."""

    name: str
    proxies: tuple[Any, ...]

    @property
    def feed(self) -> Any:
        """Shared samples of the group."""


class _Condition(NamedTuple):
    """State of a lease in its registers."""

    armed: bool
    """True also while the lease is finishing."""
    state: str
    reason: str
    estop_open: bool
    arms: int
    """Number of leases that have begun since the reset, modulo 2 ** 16."""


class LeaseRegisters(CoreRegisters):
    """The registers of a lease."""

    def __init__(self, robot: Any, name: str) -> None:
        super().__init__(robot, name)
        find = self.find
        self.most_seconds = float(self.core.generics["most_us"]) / 1e6
        """Most seconds that the end of the lease may be ahead."""
        self.finish_seconds = float(self.core.generics.get("finish_us", 0)) / 1e6
        """Most seconds for which scheduled writes may continue after the end."""
        self.arm, self.kick, self.clock = find("arm"), find("kick"), find("clock")
        self.disarm, self.fault_time = find("disarm"), find("fault_time")
        self._fields = tuple(find(field).signal for field in ("armed", "state", "reason", "estop_open"))
        self._arms = find("arms").signal
        self.address: int = self._fields[0].address
        self.link: Link = self.arm.link

    @functools.cached_property
    def guarded(self) -> frozenset[int]:
        """Addresses that only the owner of the lease writes: its kick, guarded signals, and their schedules' queues."""
        addresses: frozenset[int] = self.robot.interface.written_under(self.name)
        return addresses

    @functools.cached_property
    def cancels(self) -> frozenset[int]:
        """Addresses that cancel the schedules of the lease."""
        interface = self.robot.interface
        names = (f"{path}.cancel" for path in interface.schedules_of(self.name))
        return frozenset(interface.signals[name].address for name in names if name in interface.signals)

    def held(self, condition: _Condition) -> Lease | None:
        """Return this program's lease if the registers describe it; None if they describe another program's."""
        lease = guard_of(self.link, self.kick.signal.address)
        return lease if isinstance(lease, Lease) and lease.is_of(condition) else None

    def ask(self) -> Asked:
        """Request the words of the state."""
        return Asked(self.link, self.address, 2)

    def condition_of(self, words: Sequence[int]) -> _Condition:
        """Decode the words of the state."""
        state_word, arms_word = words
        armed, state, reason, estop_open = (signal.decode(state_word) for signal in self._fields)
        arms = int(self._arms.decode(arms_word))
        return _Condition(bool(armed), name_of(state), name_of(reason), bool(estop_open), arms)

    async def condition(self) -> _Condition:
        """Read the state, in one bus transaction."""
        return self.condition_of((await self.link.read_block(self.address, 2)).tolist())

    async def fault(self, condition: _Condition) -> NotArmedError:
        """Return the error for a lease that is not armed, or is finishing and so accepts no more requests."""
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
    """Return the error for a write that the bus has refused; `error`, if the lease allows the write.

    Args:
        error: error of the bus.
        robot: robot with the lease.
        lease: path of the lease that guards the signal.
    """
    if isinstance(error, NotArmedError) or lease in robot.interface.misfits:
        return error
    registers = LeaseRegisters(robot, lease)
    condition = await registers.condition()
    if condition.state == "armed":
        if registers.held(condition) is not None:
            return error
        # A gateway would execute the write then; a server refuses it.
        return BusError(
            f"{error}: another program has armed {lease}, and it alone may move what that guards", error.code
        )
    fault = await registers.fault(condition)
    return NotArmedError(f"{error}: {fault}", fault.reason, fault.instant)


class LeaseVerbs(Verbs):
    """Core API of a LEASE."""

    def armed(self, *, timeout: float | None = None, on_silence: Literal["safe", "finish"] = "safe") -> Lease:
        """Return a lease for an ``async with`` block, which arms the lease at its beginning and disarms it at its end.

        Args:
            timeout: seconds from each kick to the end of the lease; None for the longest, 98 % of TIMEOUT in the spec.
            on_silence: action if the end comes without a kick. ``"safe"``: all guarded outputs become safe at once.
                ``"finish"``: writes that the schedule has accepted by then are executed first, for at most FINISH
                seconds of the spec.

        Raises:
            ArgumentError: for a time-out that is not above 0, or above that of the spec; for ``"finish"`` if the spec
                has no FINISH, or no schedule writes signals that the lease guards.
            UnsupportedError: if the board's LEASE differs from that of this version.
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
                f"{name} does not finish scheduled writes: its spec has no FINISH, as in LEASE(FINISH=1)"
            )
        if finishes and not registers.robot.interface.schedules_of(name):
            raise ArgumentError(f"{name} has nothing to finish: no signal that it guards is TIMED by a SCHEDULE")
        return Lease(registers, min(seconds, NEAREST * most), finishes=finishes)

    async def stop(self) -> bool:
        """Disarm the lease, whichever program has armed it. All guarded outputs are safe when this returns.

        Returns:
            True if the lease was armed.
        """
        registers = LeaseRegisters.of(self)
        # Request the state without waiting for it, so that the write is not delayed.
        state = registers.ask()
        try:
            await registers.disarm.set(1)
            was_armed = registers.condition_of(await state.words()).armed
        finally:
            state.give_up()
        log.info("%s: lease %s: disarmed by a stop", registers.link.name, registers.name)
        return was_armed


class LeasedRobot(RobotVerbs):
    """Core API of a robot with a LEASE."""

    def armed(self, *, timeout: float | None = None, on_silence: Literal["safe", "finish"] = "safe") -> Lease:
        """Return the only lease of the robot; see `LeaseVerbs.armed`.

        Raises:
            ArgumentError: if the robot has several leases; and as `LeaseVerbs.armed`.
            UnsupportedError: as `LeaseVerbs.armed`.
        """
        leases = leases_of(self)
        if len(leases) != 1:
            robot: Any = self
            calls = " or ".join(f"{path}.armed()" for path in leases)
            raise ArgumentError(f"{robot.interface.name} has {len(leases)} leases: call {calls}")
        return next(iter(leases.values())).armed(timeout=timeout, on_silence=on_silence)


def leases_of(robot: Any) -> dict[str, LeaseVerbs]:
    """Return the leases of a robot by their paths."""
    return members_of(robot, LeaseVerbs)


class Lease(Sealed):
    """The right to move the outputs that a LEASE guards, in an ``async with`` block; `LeaseVerbs.armed` makes it.

    In the block the program kicks: by `each`, once for each sample in its loop, or by `kick`. If the lease has ended,
    because no kick came, an e-stop was opened or another program has disarmed it, the next kick raises `NotArmedError`.
    """

    def __init__(self, registers: LeaseRegisters, seconds: float, *, finishes: bool) -> None:
        self.timeout = seconds
        """Seconds from each kick to the end of the lease."""
        self._finishes = finishes
        self._registers = registers
        self._link = registers.link
        hertz = self._link.gateway.clock_hz
        self._ticks = max(1, int(seconds * hertz))
        self._clock = TickBounds(hertz)
        self._token = 0
        self._end = 0
        self._state: Asked | None = None
        """State that was requested with the last kick."""
        self._kicks: deque[Asked] = deque()
        """Kicks in flight."""
        self._arms = 0
        """Number of leases that had begun when this one was armed, this one included."""
        self._session: int | None = None
        """Number of the link's interruptions when the lease was armed; None before."""
        self._is_on = self._was_on = False
        self._ended: tuple[str, str, float | None] | None = None
        """Message, reason and instant of the end, once it is known. A lease that is armed later is another one."""

    if not TYPE_CHECKING:  # A type checker reports such uses by itself.
        __await__ = __enter__ = __exit__ = __aiter__ = __iter__ = refusing(_OPEN)

    def _called(self) -> str:
        return "a lease"

    def __repr__(self) -> str:
        """Return the name and the state of the lease."""
        state = "in its block" if self._is_on else "over" if self._was_on else "not begun"
        return f"<lease of {self._registers.name}, {state}: {self.timeout:g} s>"

    async def __aenter__(self) -> Self:
        """Arm the lease, after all earlier requests have been executed.

        Raises:
            NotArmedError: if it could not be armed.
        """
        if self._was_on:
            raise ArgumentError(
                f"this lease of {self._registers.name} was used before: `armed` makes one for each block"
            )
        self._was_on = True
        await self._link.fence()
        try:
            # On a busy machine the arm may be late, if its end is only a short time-out ahead: try again.
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
            # The arm may have been executed all the same.
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
        """Check that no program holds the lease.

        Raises:
            NotArmedError: if a program holds it.
        """
        if not condition.armed:
            return
        is_finishing = condition.state == "finishing"
        if self._registers.held(condition) is not None:
            how = "this program has armed it already, in another block"
            how += ", and the writes scheduled there are being executed" if is_finishing else ""
        else:
            how = "that of another program is finishing" if is_finishing else "another program has armed it"
        raise NotArmedError(f"{self._registers.name} cannot be armed: {how}", "taken")

    def _word(self) -> int:
        return self._token << TIME_BITS | self._end % (1 << TIME_BITS)

    @whole_exit
    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Disarm the lease.

        If the link is lost, the lease runs out by itself; a note on the error says so.
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

    # End of the lease

    def ended(self) -> NotArmedError | None:
        """Return the error for a lease that is over for this program; None while the program may hold it.

        The lease is over if the link has begun another session since it was armed: the gateway may have been reset
        then, and the registers may describe a later lease of another program with the same count.
        """
        if self._ended is None and self._session not in {None, self._link.interruptions}:
            name, why = self._registers.name, self._link.interrupted_by
            self._end_as(f"{name} has ended: the link has begun another session since it was armed ({why})", "reset")
        return None if self._ended is None else NotArmedError(*self._ended)

    def refusal(self, address: int) -> NotArmedError | None:
        """Return the error for a write to an address if the lease is over, or its time-out has passed; None otherwise.

        Another program may have armed the lease after the time-out; the write would then be executed under that lease.
        A kick is always sent: it contains the token, and the gateway's clock decides. If the lease has not ended there,
        writes are accepted again. Scheduled writes can still be cancelled while the lease is finishing.
        """
        error, registers = self.ended(), self._registers
        is_sent = address in registers.kick.signal.addresses or (self._finishes and address in registers.cancels)
        if error is None and not is_sent and self._has_ended():
            more = ", and writes that were scheduled by then may still be executed" if self._finishes else ""
            message = f"{registers.name} has ended: no kick came within {self.timeout:g} s{more}"
            error = NotArmedError(message, "silence")
        return error

    def _end_as(self, message: str, reason: str, instant: float | None = None) -> None:
        """Store why the lease is over, for the next call to raise, and log it."""
        self._ended = message, reason, instant
        log.info("%s: lease %s: %s", self._link.name, self._registers.name, message)

    def _log_silence(self) -> None:
        """Log that the lease ran out in a block that did not kick afterwards, so that no call has raised it."""
        if self._ended is None:
            log.warning("%s: lease %s: it ran out, because no kick came in time", self._link.name, self._registers.name)

    def _check_session(self) -> None:
        """Check that the lease is not known to be over.

        Raises:
            NotArmedError: if it is over.
        """
        if (error := self.ended()) is not None:
            raise error

    async def _in_session(self, answer: Awaitable[T]) -> T:
        """Wait for an answer about the lease.

        Raises:
            NotArmedError: if another session has begun, because the answer may belong to that.
        """
        try:
            answered = await answer
        except LinkLostError:
            self._check_session()
            raise
        self._check_session()
        return answered

    def is_of(self, condition: _Condition) -> bool:
        """Return whether the registers describe this lease, and it is still armed."""
        return self.ended() is None and condition.armed and condition.arms == self._arms

    def _has_ended(self) -> bool:
        return self.ended() is not None or self._clock.least(running().steady()) >= self._end

    async def _is_finishing(self) -> bool:
        """Return whether the lease is past its end and finishing. No other program can have armed it then."""
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
        """Disarm after an error, which takes precedence over errors of the disarming. Wait at most for the time-out.

        Args:
            error: error of the block.
            arming: whether it is unknown if the lease is armed.
        """
        # A coroutine that is being closed cannot wait.
        waits = not isinstance(error, GeneratorExit)
        if self._session is None:
            return
        try:
            if arming or self._has_ended():
                if (arming and not waits) or self._session != self._link.interruptions:
                    # The lease may still be armed in the gateway.
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
        """Disarm in the present session only: in another one the lease might be that of another program."""
        signal = self._registers.disarm.signal
        await Asked(self._link, signal.address, write=signal.encode(1)).words()
        log.info("%s: lease %s: disarmed", self._link.name, self._registers.name)

    async def _goes_on(self, *, arming: bool) -> bool:
        """Return whether a lease that may have ended must still be disarmed. Wait at most for the time-out."""
        async with running().last_timeout(self.timeout):
            if not arming:
                return await self._is_finishing()
            # The gateway may have executed the arm, although no answer was received.
            return self.ended() is None and self.is_of(await self._registers.condition())

    def _note(self) -> str:
        name = self._registers.name
        more = f", and finishes scheduled writes, for {self._registers.finish_seconds:g} s at most"
        return (
            f"{name} may not have been disarmed: it runs out by itself, {self.timeout:g} s after the last kick"
            f"{more if self._finishes else ''}"
        )

    # Kicks

    async def each(self, group: _Group, *, latest: bool = False) -> AsyncIterator[Any]:
        """Iterate over the samples of a group, and kick before each one is yielded.

        The end of the lease is a time-out after the instant at which the gateway took the newest sample received. So a
        sample that was delayed on its way prolongs the lease by less.

        Args:
            group: group of the robot, published with timestamps.
            latest: keep only the newest sample, for controllers: a loop body that is slower than the samples never
                gets an old one. Otherwise samples wait for the body, and if they wait too long the lease runs out.

        Raises:
            ArgumentError: for a group of another gateway, or without timestamps.
            NotArmedError: if the lease has ended.
            SamplesLostError: if the loop's body is much too slow.
            LinkLostError: if the link ends.
        """
        self._check_on()
        if any(proxy.link is not self._link for proxy in group.proxies):
            raise ArgumentError(f"{group.name} has signals of another gateway than that of {self._registers.name}")
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
                    raise ArgumentError(f"{group.name} has no timestamps, which kicks need: {advice}")
                last = self._ticks_of(samples[-1].time, last)
                self._clock.see(last, running().steady())
                for sample in samples:
                    self._check_on()
                    await self._kick(last + self._ticks)
                    yield sample
                batch = await listener.next()

    async def _first(self, listener: Any) -> Any:
        """Wait for the first samples, and kick in the meantime: a group may take long to begin."""
        give_up = running().time() + LONGEST_START
        while running().time() < give_up:
            await self.kick()
            with contextlib.suppress(TimeoutError):
                async with running().timeout(self.timeout / 4):
                    return await listener.next()
        return await listener.next()

    def _ticks_of(self, time: float, last: int | None) -> int:
        """Return the ticks of the gateway's clock at the time of a sample; `last` has those of the previous sample."""
        timestamp = self._link.timestamp_of(time)
        if last is not None:
            return last + (timestamp - last) % TURN
        return self._clock.nearest(timestamp, running().steady())

    async def kick(self) -> None:
        """Move the end of the lease to a time-out from now.

        The gateway's clock is estimated, never too late. The estimate is too early by at most the delay of the answer
        to its last reading, plus the drift of the clocks in `clock.READ_AGAIN` seconds. After this time the clock is
        read again, and the call waits for the answer.

        Raises:
            ArgumentError: outside of the block.
            NotArmedError: if the lease has ended.
            LinkLostError: if the link has ended.
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
        """Send a kick, and check the answers that have arrived since the last one."""
        registers = self._registers
        if self._state is not None and (self._state.done() or self._has_ended()):
            state, self._state = self._state, None
            await self._check_mine(registers.condition_of(await self._in_session(state.words())))
        while self._kicks and (self._kicks[0].done() or len(self._kicks) == MOST_KICKS):
            await self._take_answer(self._kicks.popleft())
        if self._has_ended():
            await self._check_mine(await self._in_session(registers.condition()))
            # The lease has not ended, so the estimate of its clock was ahead: read the clock again.
            await self._read_clock()
        if end > self._end:
            self._end = end
            signal = registers.kick.signal
            # Write both words in one transaction: otherwise words of another program could come in between.
            self._kicks.append(Asked(self._link, signal.address, write=signal.encode(self._word())))
        if self._state is None:
            self._state = registers.ask()

    async def _take_answer(self, kick: Asked) -> None:
        """Check the answer to a kick. If the kick was refused, the lease may be another program's."""
        refusal = await self._in_session(_refusal_of(kick))
        if refusal is not None:
            await self._check_mine(await self._in_session(self._registers.condition()), refused=True)

    async def _check_mine(self, condition: _Condition, *, refused: bool = False) -> None:
        """Check that this lease has not ended.

        Args:
            condition: state in the registers.
            refused: whether a kick was refused: servers refuse kicks, gateways do not.

        Raises:
            NotArmedError: if it has ended, also if another lease has begun since.
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
    """Return the error with which a bus or a server has refused a write; None if the write was executed."""
    try:
        await asked.words()
    except GatewayError as error:
        return error
    return None


class LeaseModel(Model):
    """A cycle-accurate lease on `sim:`, except for the two cycles of latency of a word."""

    def __init__(self, component: ComponentSpec, part: Any, around: Any) -> None:
        super().__init__(component, part, around)
        self._token = self._end = 0
        self._emptied: int | None = None

    def reset(self) -> None:
        """Disarm, as before the first arm."""
        self._end_as("disarmed", "none_yet")
        self.part.fault_time = 0
        self.part.arms = 0

    @property
    def due(self) -> int | None:
        """Cycle of the lease's end, or of the end of its finishing; None if it is not armed."""
        if not self.part.armed:
            return None
        return self._end if self._emptied is None else min(self._end, self._emptied + 1)

    def step(self, dt: float) -> None:
        """End the lease if its end has come, or if it is finishing and the schedules are empty."""
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
        """Arm, kick or disarm the lease, or read the e-stop."""
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
            # The word would take effect one cycle later, after the end of the lease.
            self._run_out()
            if part.finishing:
                return
        may = token == self._token if part.armed else is_arm
        # The word takes effect two cycles later, so its end must be later than that.
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
    """Shows a plant whether the lease is armed, by its enable pin."""

    def __init__(self, component: ComponentSpec, part: Any, around: Pins) -> None:
        super().__init__(component, part, around)
        if around.has("enable"):
            self.shows = frozenset({"armed"})

    def step(self, dt: float) -> None:
        """Show the level of the enable pin as `armed`."""
        if self.shows:
            self.around.show("armed", bool(self.part.enable))
