"""A lease that ROS arms: the conditions for arming, for a kick, and for the end.

DDS and ROS 1 authenticate nobody, and a service call names no client. So arming is off unless it is allowed, and one
program alone may publish set points of guarded signals. Each accepted set point kicks; silence ends the lease.
"""

from __future__ import annotations

import asyncio
import contextlib
import functools
import logging
from typing import TYPE_CHECKING, Any

from unity_link.cores.lease import LeaseRegisters
from unity_link.errors import ArgumentError, NotArmedError, UnityLinkError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from unity_link.bridges.commands import LevelledLog
    from unity_link.bridges.merged_writes import Value
    from unity_link.cores.lease import Lease, LeaseVerbs
    from unity_link.data import Proxy

LOOK_EVERY = 0.1
"""Seconds between looks at the state of a lease and at the publishers of its set points."""
ANSWERS_WITHIN = 5.0
"""Seconds for which a service call waits for the gateway."""
NOT_ALLOWED = "arming from ROS is off: start the bridge with --allow-arm, or with the parameter allow_arm"


class RosLease:
    """A lease, as ROS has it.

    Args:
        verbs: of the lease.
        path: of the lease.
        allowed: whether ROS may arm it.
        timeout: seconds from a set point to the end that it asks for; None for the most.
        log: logs a sentence.

    Raises:
        ArgumentError: for a time-out that the spec does not allow.
    """

    def __init__(self, verbs: LeaseVerbs, path: str, *, allowed: bool, timeout: float | None, log: LevelledLog) -> None:
        self.registers = LeaseRegisters.of(verbs)
        self.path = path
        self.allowed = allowed
        self.show: Callable[[bool], None] = lambda _: None
        """Publishes whether the lease is armed."""
        self.programs: Callable[[], set[str]] = set
        """Returns the names of the programs that publish set points of guarded signals."""
        self._new = functools.partial(verbs.armed, timeout=timeout)
        self._new()
        self._why = f"nothing on ROS has armed {path}"
        """Reason for which ROS does not hold the lease."""
        self._log = log
        self.held: Lease | None = None
        """The lease while ROS holds it."""
        self._holding: asyncio.Task[None] | None = None
        self._accepted = asyncio.Event()
        self._shown: bool | None = None
        self._loop: asyncio.AbstractEventLoop | None = None

    def guards(self, proxies: Iterable[Proxy[Any] | None]) -> bool:
        """Return whether the lease guards one of some signals."""
        guarded = self.registers.guarded
        return any(proxy is not None and not guarded.isdisjoint(proxy.signal.addresses) for proxy in proxies)

    def check_allowed(self, proxy: Proxy[Any]) -> None:
        """Check that ROS may write a signal now.

        Raises:
            ArgumentError: if the lease guards it, and ROS does not hold the lease.
        """
        if self.allowed and self.guards([proxy]):
            self.check_held(f"{proxy.path} is not written")

    def check_held(self, refusal: str) -> None:
        """Check that ROS holds the lease.

        Raises:
            ArgumentError: if it does not, which begins with the refusal.
        """
        if self.held is None:
            raise ArgumentError(f"{refusal}, because {self._why}")

    def disarm_soon(self) -> None:
        """Disarm, without waiting for it; to be called in the event loop."""
        self._disarming = asyncio.ensure_future(self._disarm())

    def accept(self, values: Iterable[Value]) -> None:
        """Kick, if values were written to guarded signals."""
        if self.held is not None and self.guards(value.proxy for value in values):
            self._accepted.set()

    def ask(self, armed: bool) -> tuple[bool, str]:  # noqa: FBT001  (a message contains the bool)
        """Arm or disarm; to be called from a thread of ROS, which waits. Return whether it is done, and a sentence."""
        if self._loop is None:
            return False, f"{self.path}: the bridge has not begun"
        asked = asyncio.run_coroutine_threadsafe(self._arm() if armed else self._disarm(), self._loop)
        try:
            done, message = asked.result(ANSWERS_WITHIN)
        except UnityLinkError as error:
            done, message = False, str(error)
        except TimeoutError:
            asked.cancel()
            done, message = False, f"{self.path}: no answer came within {ANSWERS_WITHIN:g} s"
        self._log(message, level=logging.INFO if done else logging.ERROR)
        return done, message

    async def run(self) -> None:
        """Show whether the lease is armed, until it is cancelled; then it is disarmed, if ROS has armed it."""
        self._loop = asyncio.get_running_loop()
        try:
            while True:
                self._show_now(armed=await self._is_armed())
                await asyncio.sleep(LOOK_EVERY)
        finally:
            self._loop = None
            await asyncio.shield(self._let_go())
            self._show_now(armed=False)

    async def _is_armed(self) -> bool:
        """Return whether any program has armed it; False if the gateway does not answer."""
        if self.registers.link.connected:
            with contextlib.suppress(UnityLinkError, TimeoutError):
                async with asyncio.timeout(10 * LOOK_EVERY):
                    return (await self.registers.condition()).armed
        return False

    def _show_now(self, *, armed: bool) -> None:
        if armed != self._shown:
            self._shown = armed
            self.show(armed)

    async def _arm(self) -> tuple[bool, str]:
        if not self.allowed:
            return False, NOT_ALLOWED
        if self._holding is not None:
            return False, f"{self.path} is armed already"
        programs = self.programs()
        if len(programs) != 1:
            found = ", ".join(sorted(programs)) or "none"
            return False, f"{self.path} is armed for one program that publishes set points, and there are: {found}"
        armed = asyncio.get_running_loop().create_future()
        self._holding = asyncio.create_task(self._hold(programs, armed))
        await armed
        return True, f"{self.path} is armed for {next(iter(programs))}"

    async def _disarm(self) -> tuple[bool, str]:
        await self._let_go()
        await self.registers.disarm.set(1)
        self._why = f"{self.path} was disarmed"
        self._show_now(armed=False)
        return True, f"{self.path} is disarmed"

    async def _let_go(self) -> None:
        if (holding := self._holding) is not None:
            holding.cancel()
            await asyncio.wait([holding])

    async def _hold(self, programs: set[str], armed: asyncio.Future[None]) -> None:
        """Arm, and kick with each set point, until the lease or its program ends."""
        try:
            async with self._new() as lease:
                self.held = lease
                self._accepted.clear()
                self._show_now(armed=True)
                armed.set_result(None)
                await self._kick(lease, programs)
        except UnityLinkError as error:
            self._why = str(error)
            if armed.done():
                self._log(self._why, level=logging.ERROR)
            else:
                armed.set_exception(error)
        finally:
            self.held = self._holding = None
            armed.cancel()
            self._show_now(armed=False)

    async def _kick(self, lease: Lease, programs: set[str]) -> None:
        loop = asyncio.get_running_loop()
        look_at = loop.time()
        while True:
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout_at(look_at):
                    await self._accepted.wait()
                self._accepted.clear()
                await lease.kick()
            if loop.time() < look_at:
                continue
            look_at = loop.time() + LOOK_EVERY
            if (found := self.programs()) != programs:
                how = (
                    f"is published by {', '.join(sorted(found))} too" if found > programs else "has lost its publisher"
                )
                raise NotArmedError(f"{self.path} is disarmed: a topic of its set points {how}", "disarmed")
            condition = await self.registers.condition()
            if not lease.is_of(condition):
                raise lease.ended() or await self.registers.fault(condition)
