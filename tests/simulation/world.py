"""A world: a plan that is run on simulated time, and judged."""

from __future__ import annotations

import asyncio
import contextlib
import hashlib
import random
from collections import Counter
from typing import Any

from simulation.clock import SimulatedLoop
from simulation.medium import Network
from simulation.oracle import LinkLog, Oracle, Tap, WorldError
from simulation.plan import Draw, Mishap, Plan
from simulation.programs import Program
from unity_link.bridges.serve import serve
from unity_link.virtual import VirtualGateway
from unity_link.virtual.line import SlowLine
from unity_link.virtual.modelled_time import DeadlockError
from unity_link.virtual.serving import serve_tcp

KNOWN = frozenset({
    "fences behind batches",
    "exits of lost links",
    "fences that fail",
    "samples that are asked for while a group is set up",
})
"""Features of worlds that today's code has known defects in."""
CALM_AFTER = 10.0
"""Seconds after which nothing goes wrong any more."""
SETTLED_AFTER = 90.0
"""Seconds after which everything must have come to its end."""


class Outcome:
    """What became of a world."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.trace: list[Any] = []
        self.error: WorldError | None = None
        self.injected: Counter[str] = Counter()
        self.requests = 0
        self.sessions = 0
        self.seconds = 0.0

    @property
    def digest(self) -> str:
        """Return a hash of all that happened."""
        return hashlib.blake2b(repr(self.trace).encode(), digest_size=16).hexdigest()


class World:
    """One run of a plan."""

    def __init__(self, plan: Plan, without: frozenset[str] = KNOWN) -> None:
        self.outcome = Outcome(plan)
        self._plan = plan
        self._without = without
        self._trace = self.outcome.trace
        self._faults: list[str] = []
        """What raised where nothing waits for it."""

    def run(self) -> Outcome:
        """Run, and judge."""
        # The pauses of reconnections are drawn from the module's generator.
        random.seed(self._plan.seed)
        loop = SimulatedLoop()
        loop.set_exception_handler(lambda _, context: self._faults.append(_describe(context)))
        self._network = Network(loop, self._plan.lines, self._plan.faults, self._trace)
        loop.network = self._network
        try:
            loop.run_until_complete(self._live(loop))
            left = asyncio.all_tasks(loop)
            if left:
                raise WorldError("a task that does not end", str(left))
            if self._faults:
                raise WorldError("an error in a callback", self._faults[0])
        except WorldError as error:
            self.outcome.error = error
        except DeadlockError as error:
            self.outcome.error = WorldError("everything waits", str(error))
        finally:
            self.outcome.seconds = loop.time()
            self._count()
            loop.close()
        return self.outcome

    async def _live(self, loop: SimulatedLoop) -> None:
        plan, logs = self._plan, list[LinkLog]()
        async with contextlib.AsyncExitStack() as stack:
            taps = []
            for number, gateway in enumerate(plan.gateways):
                bare = VirtualGateway(gateway.info)
                tap = Tap(bare, self._trace, f"gateway{number}")
                taps.append(tap)
                served: Any = tap if gateway.bytes_per_second is None else SlowLine(tap, gateway.bytes_per_second)  # type: ignore[arg-type]
                await stack.enter_async_context(serve_tcp(served, 1, f"gateway{number}"))
                for at in gateway.triggers:
                    loop.call_at(at, lambda bare=bare: bare.trigger(loop.time()))
            for place, number in enumerate(plan.servers):
                url = f"tcp://server{place}.gateway{number}:1"
                await stack.enter_async_context(serve(url, tcp=1, host=f"server{place}"))
            for mishap in plan.mishaps:
                loop.call_at(mishap.at, self._befall, mishap, taps)
            loop.call_at(CALM_AFTER, self._network.calm)
            programs = []
            for program in plan.programs:
                listener = program.line.rpartition(".")[2]
                number = int(listener[-1])
                tap = taps[plan.servers[number] if listener.startswith("server") else number]
                programs.append(Program(program.line.partition(".")[0], program, tap, logs, self._trace, self._without))
            tasks = [loop.create_task(program.run()) for program in programs]
            self._links = [program.links for program in programs]
            self._taps = taps
            if tasks:
                _, pending = await asyncio.wait(tasks, timeout=SETTLED_AFTER)
                if pending:
                    await self._give_up(tasks, logs)
                for task in tasks:
                    error = task.exception()
                    if error is not None:
                        raise error if isinstance(error, WorldError) else WorldError("an exception", repr(error))
        self._logs = logs
        Oracle(self._without).judge([tap.recorder for tap in taps], logs)

    async def _give_up(self, tasks: list[asyncio.Task[None]], logs: list[LinkLog]) -> None:
        waiting = [str(ask) for log in logs for ask in log.asks if ask.told is None and not ask.cancelled]
        for task in asyncio.all_tasks():
            if task is not asyncio.current_task():
                task.cancel()
        await asyncio.wait(tasks, timeout=10)
        raise WorldError("a program that waits for ever", "; ".join(waiting[:3]) or "no call")

    def _befall(self, mishap: Mishap, taps: list[Tap]) -> None:
        self._trace.append((asyncio.get_running_loop().time(), mishap.whom, "mishap", mishap.kind))
        self.outcome.injected[mishap.kind] += 1
        network = self._network
        network.cut(mishap.whom)
        if mishap.whom.startswith("gateway"):
            taps[int(mishap.whom[-1])].gateway.reset()
        if mishap.kind == "away":
            network.away.add(mishap.whom)
            network.loop.call_later(mishap.seconds, network.away.discard, mishap.whom)

    def _count(self) -> None:
        outcome = self.outcome
        for entry in self._trace:
            if entry[2] == "fault":
                outcome.injected[entry[3].partition(" ")[0]] += 1
        outcome.requests = sum(link.statistics.requests for links in self._links for link in links)
        outcome.sessions = sum(max(0, count - 1) for count in self._network.connections.values())


def _describe(context: dict[str, Any]) -> str:
    error = context.get("exception")
    return f"{context.get('message')}: {error!r}"


def run_seed(seed: int, without: frozenset[str] = KNOWN) -> Outcome:
    """Draw the plan of a seed and run it."""
    return World(Draw(seed, without).plan(), without).run()
