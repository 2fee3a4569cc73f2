"""Programs: they execute the steps of a plan through the public API of a link; each call is recorded for the oracle."""

from __future__ import annotations

import asyncio
import contextlib
import re
from typing import TYPE_CHECKING, Any

import unity_link
from simulation.oracle import LinkLog, Listening, RuleError
from unity_link import (
    BusTimeoutError,
    ConnectError,
    Link,
    OutOfRangeError,
    Reconnect,
    SamplesLostError,
    UnityLinkError,
    UnsupportedError,
)
from unity_link.errors import LinkClosedError, UnansweredError

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Iterator

    from simulation.oracle import Ask, Tap
    from simulation.plan import Life, ProgramPlan, Step
    from unity_link.transport import Medium

_FOR_GOOD = ("the reconnection failed", "unity-link serve")
"""Parts of the errors of links that cannot return."""
_MORE = re.compile(r"(\d+) more posted writes failed")
PAUSES = Reconnect(first_pause=0.02, longest_pause=1.0)
CONNECT_TRIES = 40
PATIENCE = 30.0
"""Seconds within which a lost link and its groups must work again."""


_WORDS: dict[str, Callable[..., Any]] = {
    "read": lambda address: ((address, 0),),
    "write": lambda address, word: ((address, word),),
    "write_masked": lambda address, word, _: ((address, word),),
    "post": lambda address, word: ((address, word),),
    "read_block": lambda first, count: tuple((first + place, 0) for place in range(count)),
    "write_block": lambda first, words: tuple((first + place, word) for place, word in enumerate(words)),
    "read_queue": lambda address, count: ((address, 0),) * count,
    "write_queue": lambda address, words: tuple((address, word) for word in words),
    "read_many": lambda addresses: tuple((address, 0) for address in addresses),
    "write_many": lambda addresses, words: tuple(zip(addresses, words, strict=True)),
    "post_many": lambda addresses, words: tuple(zip(addresses, words, strict=True)),
}


def words_of(step: Step) -> tuple[tuple[int, int], ...]:
    """Return the addresses of a call, each with the word to write, or 0."""
    words: tuple[tuple[int, int], ...] = _WORDS[step.kind](*step.args) if step.kind in _WORDS else ()
    return words


@contextlib.asynccontextmanager
async def _entered(subscription: unity_link.Subscription, *, in_haste: bool) -> AsyncIterator[None]:
    """Enter a subscription; with `in_haste` its exit does not wait until the group has been stopped."""
    async with contextlib.AsyncExitStack() as stack:
        await subscription.__aenter__()

        async def leave(*error: Any) -> None:
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(0 if in_haste else None):
                    await subscription.__aexit__(*error)

        stack.push_async_exit(leave)
        yield


class Program:
    """One program.

    Args:
        name: name in traces.
        plan: its steps.
        target: URL or medium that it opens.
        tap: observer of its gateway.
        logs: receives its calls.
        trace: receives its events.
    """

    def __init__(
        self,
        name: str,
        plan: ProgramPlan,
        target: str | Medium,
        tap: Tap,
        logs: list[LinkLog],
        trace: list[Any],
    ) -> None:
        self.name = name
        self.links: list[Link] = []
        self.line = plan.line
        self._plan = plan
        self._target = target
        self._tap = tap
        self._all_logs = logs
        self.logs: list[LinkLog] = []
        """Logs of its links."""
        self._trace = trace
        self._loop = asyncio.get_running_loop()
        self._mine: dict[int, int] = {}

    def listenings(self) -> Iterator[Listening]:
        """Return all subscriptions that the program has had."""
        for log in self.logs:
            yield from log.listenings

    async def run(self) -> None:
        """Run the planned links one after another."""
        for life in self._plan.lives:
            await self._live(life)

    async def _live(self, life: Life) -> None:
        link = await self._connect(life)
        self.links.append(link)
        log = LinkLog(
            f"{self.name} link {len(self.links)}",
            self._tap.recorder,
            shared=".server" in self.line,
            reconnect=life.reconnect,
            block_words=link.gateway.block_words,
        )
        self._all_logs.append(log)
        self.logs.append(log)
        self._mine = {}
        leaving = None
        try:
            async with link:
                tasks = [self._loop.create_task(self._task(link, log, steps)) for steps in life.tasks]
                if life.close_after is not None and tasks:
                    await asyncio.wait(tasks, timeout=life.close_after)
                    log.closed = True
                    await link.aclose()
                for task in tasks:
                    await task
                leaving = log.ask("exit", (), self._loop.time())
        except UnityLinkError as error:
            if leaving is not None:
                self._fail(log, leaving, error, ended=False)
        else:
            if life.close_after is None:
                leaving.told = self._loop.time()

    async def _connect(self, life: Life) -> Link:
        for _ in range(CONNECT_TRIES):
            try:
                return await unity_link.connect(self._target, timeout=3, reconnect=PAUSES if life.reconnect else False)
            except ConnectError as error:
                self._note("not connected", str(error))
                await asyncio.sleep(0.25)
        raise RuleError("no connection", f"{self.name} was refused {CONNECT_TRIES} times")

    async def _task(self, link: Link, log: LinkLog, steps: tuple[Step, ...]) -> None:
        for step in steps:
            await self._step(link, log, step)

    async def _step(self, link: Link, log: LinkLog, step: Step) -> None:
        if step.kind == "sleep":
            await asyncio.sleep(step.args[0])
        elif step.kind == "burst":
            tasks = [self._loop.create_task(self._call(link, log, inner)) for inner in step.args[0]]
            for task in tasks:
                await task
        elif step.kind == "cancel":
            tasks = [self._loop.create_task(self._call(link, log, inner)) for inner in step.args[1]]
            await asyncio.wait(tasks, timeout=step.args[0])
            for task in tasks:
                task.cancel()
            await asyncio.wait(tasks)
            for task in tasks:
                if not task.cancelled():
                    await task
        elif step.kind == "listen":
            await self._listen(link, log, *step.args)
        else:
            await self._call(link, log, step)

    # Calls

    async def _call(self, link: Link, log: LinkLog, step: Step) -> None:
        coroutine = getattr(link, step.kind)(*step.args)
        ask = log.ask(step.kind, words_of(step), self._loop.time())
        self._remember(ask)
        self._note("ask", ask.number, step.kind, step.args)
        try:
            answer = await coroutine
        except asyncio.CancelledError:
            ask.cancelled = True
            self._note("cancelled", ask.number)
            raise
        except UnityLinkError as error:
            self._fail(log, ask, error, ended=log.ended(link))
        else:
            ask.told = self._loop.time()
            if answer is not None:
                ask.answer = [answer] if isinstance(answer, int) else answer.tolist()
            self._note("told", ask.number, ask.answer)

    def _fail(self, log: LinkLog, ask: Ask, error: UnityLinkError, *, ended: bool) -> None:
        ask.told, ask.error = self._loop.time(), error
        log.refused |= any(reason in str(error) for reason in _FOR_GOOD)
        ask.ended = ended or log.refused or isinstance(error, LinkClosedError)
        self._note("failed", ask.number, repr(error))
        if ask.kind in ("fence", "exit"):
            notes = "".join(getattr(error, "__notes__", ()))
            more = _MORE.search(notes)
            log.post_failures.append((ask.told, 1 + (int(more[1]) if more else 0), ask.task))

    def _remember(self, ask: Ask) -> None:
        """Record the last value that this program wrote, for its later reads."""
        if ask.kind == "write":
            self._mine[ask.words[0][0]] = ask.words[0][1]
        elif ask.kind == "read":
            ask.after = dict(self._mine)

    # Subscriptions

    async def _listen(
        self,
        link: Link,
        log: LinkLog,
        addresses: tuple[int, ...],
        arguments: tuple[tuple[str, Any], ...],
        seconds: float,
        pace: float,
        publishes: int,
        manner: tuple[str, ...],
    ) -> None:
        by_callback, in_haste = "by callback" in manner, "in haste" in manner
        keywords = dict(arguments)
        listening = Listening(log, self._tap.published, addresses, keywords | {"digits": link.gateway.data_digits})
        callback = listening.samples.append if by_callback else None
        subscription = link.subscribe(list(addresses), callback=callback, **keywords)
        listening.rate = subscription.rate_hz
        self._note("subscribe", addresses, arguments)
        asking: list[asyncio.Task[None]] = []
        try:
            async with _entered(subscription, in_haste=in_haste):
                log.listenings.append(listening)
                asking += [self._loop.create_task(self._publish(subscription, pace)) for _ in range(publishes)]
                with contextlib.suppress(TimeoutError):
                    async with asyncio.timeout(seconds):
                        if by_callback:
                            await asyncio.sleep(seconds + 1)
                        async for sample in subscription:
                            listening.samples.append(sample)
                            await asyncio.sleep(pace)
                if subscription.rate_hz is not None and not keywords["on_change"]:
                    await self._follow(link, log, subscription, listening, by_callback=by_callback)
            if not by_callback:
                async for sample in subscription:
                    listening.samples.append(sample)
            listening.lost = subscription.lost
        except (UnsupportedError, SamplesLostError, UnansweredError, OutOfRangeError, BusTimeoutError) as error:
            self._note("no samples", repr(error))
            if isinstance(error, OutOfRangeError | BusTimeoutError) and not log.shared:
                # A server may have no group left; a gateway has one, because the link assigned a free one.
                raise RuleError("a group that was refused", f"{log.name}, {addresses}: {error!r}") from error
        else:
            self._note("samples", addresses, len(listening.samples), listening.lost)
        for task in asking:
            await task

    async def _follow(
        self, link: Link, log: LinkLog, samples: unity_link.Subscription, listening: Listening, *, by_callback: bool
    ) -> None:
        """Listen until a sample of the link's last session arrives, which must happen if groups are set up again."""
        until = self._loop.time() + PATIENCE
        while listening.samples and listening.samples[-1].epoch < link.statistics.reconnections:
            if not by_callback:
                with contextlib.suppress(TimeoutError):
                    async with asyncio.timeout_at(until):
                        listening.samples.append(await anext(samples))
            else:
                await asyncio.sleep(0.1)
            if log.ended(link):
                return
            if self._loop.time() >= until:
                raise RuleError("a group that was not set up again", f"{log.name}, {listening.addresses}")

    async def _publish(self, subscription: unity_link.Subscription, pace: float) -> None:
        await asyncio.sleep(pace)
        try:
            await subscription.publish()
        except UnityLinkError as error:
            self._note("not published", repr(error))

    def _note(self, *what: Any) -> None:
        self._trace.append((self._loop.time(), self.name, *what))
