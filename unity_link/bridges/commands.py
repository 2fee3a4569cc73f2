"""Values from other threads, such as those of ROS, on their way to the robot: in order, each once.

All values that have arrived together are checked one by one and posted together. Values of one message, such as those
of all joints, are written together; if one of them is wrong, none is written. While the gateway is away, values are
discarded: a value that was meant for now must not move the robot a minute later.
"""

from __future__ import annotations

import asyncio
import contextlib
import functools
import logging
import sys
from typing import TYPE_CHECKING, Any, Protocol

from unity_link.bridges.log_once import Faults
from unity_link.bridges.merged_writes import Objects, Value, write_in_order
from unity_link.errors import ArgumentError, UnityLinkError
from unity_link.transport.inbox import Inbox

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from unity_link.data import Writable
    from unity_link.link.link import Link

MOST_WAITING = 4096
"""Most values that wait for the link; with more, the calling thread blocks, and so does the sender."""
LOOK_EVERY = 0.5
"""Seconds between checks whether the gateway is away."""
AWAY = "the gateway is away: values that come meanwhile are not written"
BACK = "the gateway is back: values are written again"

Command = tuple["Writable[Any]", Any]


class LevelledLog(Protocol):
    """Logs a sentence for people."""

    def __call__(self, text: str, /, *, level: int) -> None:
        """Log a sentence at a level of `logging`."""


def check_number(name: str, value: float) -> None:
    """Check a floating-point set point.

    rclpy serialises an int in a ``Float64`` as the bits of another object, which are a subnormal number.

    Args:
        name: name of the signal or the topic.
        value: value in the message.

    Raises:
        ArgumentError: if the value is subnormal.
    """
    if 0 < abs(value) < sys.float_info.min:
        raise ArgumentError(
            f"{name}: {value} is subnormal, as rclpy sends an int in the place of a float: give a float such as 20.0, "
            "and set ROS_PYTHON_CHECK_FIELDS=1 in the sender for an error there"
        )


class SignalCommands:
    """Writes values to signals, as posted writes.

    Args:
        link: link to the gateway of the signals.
        report: called with a sentence and its level about a value that cannot be written, once for each signal and kind
            of fault.
        check_allowed: called before each write; raises an ArgumentError if the signal may not be written now.
        accept: called with the values that were written.
    """

    def __init__(
        self,
        link: Link,
        report: LevelledLog,
        check_allowed: Callable[[Writable[Any]], None] = lambda _: None,
        accept: Callable[[Sequence[Value]], None] = lambda _: None,
    ) -> None:
        self.written = 0
        """Number of values that were posted."""
        self._link = link
        self._report = report
        self._check_allowed = check_allowed
        self._accept = accept
        self._faults = Faults(functools.partial(report, level=logging.ERROR))
        self._inbox: Inbox[Sequence[Command]] = Inbox(self._take, MOST_WAITING)
        self._taken: list[Sequence[Command]] = []
        self._woken = asyncio.Event()
        self._ended = False
        self._away = self._posted = False
        self._limit: asyncio.Timeout | None = None

    def give(self, *commands: Command) -> None:
        """Write values. Call it from another thread: it blocks while too many values are waiting."""
        self._inbox.give(*((command,) for command in commands))

    def give_together(self, commands: Sequence[Command]) -> None:
        """Write values together; otherwise as `give`."""
        if commands:
            self._inbox.give(commands)

    async def run(self) -> None:
        """Write the given values until it is cancelled. Values given before are still written then."""
        working, looking = asyncio.ensure_future(self._work()), asyncio.ensure_future(self._look())
        try:
            await asyncio.shield(working)
        finally:
            self._ended = True
            self._taken += self._inbox.close()
            self._woken.set()
            await working
            looking.cancel()
            while self._posted and self._link.connected:
                await self._learn()

    def _take(self, commands: list[Sequence[Command]]) -> None:
        # The inbox collects further values until these are written; if it is full, a sender that is too fast blocks.
        self._inbox.hold()
        self._taken = commands
        self._woken.set()

    async def _work(self) -> None:
        while not self._ended or self._taken:
            await self._woken.wait()
            self._woken.clear()
            commands, self._taken = self._taken, []
            # Run the writes in a task of their own: the fence of `_look` also raises errors of tasks that are over.
            await asyncio.create_task(self._write(commands))
            self._inbox.release()

    async def _write(self, commands: list[Sequence[Command]]) -> None:
        objects = [] if self._away else self._check(commands)
        if objects:
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(None) as self._limit:
                    await self._post(objects)
            self._limit = None

    def _check(self, commands: list[Sequence[Command]]) -> Objects:
        objects = []
        for together in commands:
            try:
                for proxy, value in together:
                    if isinstance(value, float):
                        check_number(proxy.path, value)
                    self._check_allowed(proxy)
                objects.append([Value.of(proxy, value) for proxy, value in together])
            except ArgumentError as error:
                self._faults.tell(str(error))
        return objects

    async def _post(self, objects: Objects) -> None:
        errors = await write_in_order(objects, posted=True)
        values = [value for together in objects for value in together]
        self.written += len(values) - len(errors)
        self._posted = True
        self._accept(values if not errors else [])
        for error in errors:
            self._faults.tell(str(error))
        for proxy, _, words in {value.proxy: value for value in values}.values():
            proxy.see(proxy.decode(words))

    async def _look(self) -> None:
        """Check repeatedly for errors of posted values, and whether the gateway is away."""
        was_connected = True
        while True:
            connected = self._link.connected
            if self._away and connected:
                self._away = False
                self._report(BACK, level=logging.INFO)
            # Ignore an interruption that is shorter than the time between two checks: the link then goes on.
            elif not (self._away or connected or was_connected):
                self._away = True
                self._report(AWAY, level=logging.WARNING)
                if self._limit is not None:
                    # Cancel the writes that were not sent yet: they must never be sent.
                    self._limit.reschedule(0)
            if connected:
                await self._learn()
            was_connected = connected
            await asyncio.sleep(LOOK_EVERY)

    async def _learn(self) -> None:
        """Report the errors of posted values; try again later if that takes too long."""
        if not self._posted:
            return
        self._posted = False
        try:
            async with asyncio.timeout(LOOK_EVERY):
                await self._link.fence()
        except TimeoutError:
            self._posted = True
        except UnityLinkError as error:
            self._faults.tell(str(error))
