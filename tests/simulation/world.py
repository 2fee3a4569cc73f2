"""A scenario: a plan that is run on simulated time, and checked."""

from __future__ import annotations

import asyncio
import contextlib
import hashlib
import math
import random
from collections import Counter
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, cast
from unittest.mock import patch

from simulation.answers import judge_answers
from simulation.clock import LivelockError, SimulatedLoop
from simulation.medium import Network
from simulation.nodes import Wire
from simulation.oracle import MOST_WAITING, POSTED, LinkLog, Oracle, RuleError, Tap
from simulation.plan import BURST, WIRE, Draw, GatewayPlan, Mishap, Plan, gateway_of, node_of
from simulation.programs import Program
from simulation.sendings import watched
from unity_link.bridges.serve import Server, serve
from unity_link.errors import UnityLinkError
from unity_link.protocol.gateway import datagrams
from unity_link.protocol.wire.messages import Codec
from unity_link.virtual import VirtualGateway
from unity_link.virtual.line import SlowLine
from unity_link.virtual.modelled_time import DeadlockError
from unity_link.virtual.rtl import RtlGateway
from unity_link.virtual.serving import serve_tcp, serve_udp

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Sequence

    from simulation.medium import Line
    from simulation.sendings import Sendings
    from unity_link.transport import Medium
    from unity_link.virtual import BareGateway, Gateway

CALM_AFTER = 10.0
"""Seconds after which no further faults occur."""
SETTLED_AFTER = 90.0
"""Seconds after which every program must have ended."""
MOST_SENDINGS = 12
"""Largest number of transmissions of a request, without those after a time-out."""
MOST_DOUBT = 1.0
"""Seconds within which a link ends after another host has taken its line."""


class Outcome:
    """Result of a scenario."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.trace: list[Any] = []
        self.error: RuleError | None = None
        self.injected: Counter[str] = Counter()
        self.requests = 0
        self.sessions = 0
        self.seconds = 0.0

    @property
    def digest(self) -> str:
        """Return a hash of all events."""
        return hashlib.blake2b(repr(self.trace).encode(), digest_size=16).hexdigest()


class Scenario:
    """One run of a plan."""

    def __init__(self, plan: Plan) -> None:
        self.outcome = Outcome(plan)
        self._plan = plan
        self._trace = self.outcome.trace
        self._taps: list[Tap] = []
        self._programs: list[Program] = []
        self._logs: list[LinkLog] = []
        self._faults: list[str] = []
        """Errors that no task awaits."""
        self._wire: Wire | None = None
        """The line that the gateways share, if they are nodes."""
        self._taken: dict[str, float] = {}
        """Instants at which another host has opened a session with a gateway, by line."""
        self._anew: dict[str, asyncio.Event] = {}
        """By the names of gateways that are reached by datagrams: set when they must restart."""

    def run(self) -> Outcome:
        """Run the plan, and check the result."""
        # The pauses of reconnections are drawn from the generator of the module `random`.
        random.seed(self._plan.seed)
        loop = SimulatedLoop()
        loop.set_exception_handler(lambda _, context: self._faults.append(_describe(context)))
        self._network = Network(loop, self._plan.lines, self._plan.faults, self._trace)
        loop.network = self._network
        draw = random.Random(self._plan.seed)
        seeds = patch("unity_link.link.connection.choose_seed", lambda: draw.getrandbits(16))
        reports = patch("unity_link.link.connection.report", self._report)
        offers = patch.object(datagrams, "secrets", SimpleNamespace(randbits=draw.getrandbits))
        try:
            with seeds, offers, reports, watched() as sendings:
                loop.run_until_complete(self._live(loop))
            self._look_for_what_is_left(loop)
            self._judge_sendings(sendings)
        except RuleError as error:
            self.outcome.error = error
        except DeadlockError as error:
            self.outcome.error = RuleError("everything waits", str(error))
        except LivelockError as error:
            self.outcome.error = RuleError("callbacks for ever", str(error))
        finally:
            self.outcome.seconds = loop.time()
            self._count()
            loop.close()
        return self.outcome

    def _report(self, message: str, error: BaseException) -> None:
        self._faults.append(f"{message}: {error!r}")

    def _look_for_what_is_left(self, loop: SimulatedLoop) -> None:
        left = asyncio.all_tasks(loop)
        if left:
            raise RuleError("a task that does not end", str(left))
        if self._faults:
            raise RuleError("an error that no task awaits", self._faults[0])

    @staticmethod
    def _judge_sendings(sendings: Sendings) -> None:
        if (most := sendings.most_by_signs) > MOST_SENDINGS:
            raise RuleError("a request sent too often", f"{most} times")

    async def _live(self, loop: SimulatedLoop) -> None:
        plan = self._plan
        async with contextlib.AsyncExitStack() as stack:
            if plan.baud is not None:
                self._wire = Wire(self._nodes(), plan.baud, self._network)
            else:
                for number, gateway in enumerate(plan.gateways):
                    await stack.enter_async_context(self._gateway(loop, number, gateway))
            for place, number in enumerate(plan.servers):
                target = self._target(f"server{place}.gateway{number}")
                server = await stack.enter_async_context(serve(target, tcp=1, host=f"server{place}"))
                stack.callback(loop.create_task(self._watch(place, server)).cancel)
            for mishap in plan.mishaps:
                if mishap.kind != "hang up":
                    loop.call_at(mishap.at, self._befall, mishap)
            self._network.on_return = self._hang_up
            loop.call_at(CALM_AFTER, self._network.calm)
            await self._run_programs(loop)
        for course in self._network.courses.values():
            if course.most_waiting > MOST_WAITING:
                raise RuleError("a buffer that grows", f"{course.most_waiting} bytes waited in {course.name}")
        self._judge_undisturbed()
        if self._wire is not None and self._wire.collisions and not self._was_disturbed(WIRE):
            raise RuleError("simultaneous transmissions", self._wire.collisions[0])
        self._judge_sessions()
        self._judge_losers()
        judge_answers(self._trace, plan.behind_servers())
        Oracle().judge([tap.recorder for tap in self._taps], self._logs)

    def _judge_sessions(self) -> None:
        """Check that no session ends without a cut connection or a reset gateway: the link recovers from losses."""
        for program in self._programs:
            again = sum(link.statistics.reconnections for link in program.links)
            if again and self._plan.is_never_cut(program.line):
                raise RuleError("a session that ended without a cause", f"{program.name}: {again}")

    def _judge_undisturbed(self) -> None:
        """Check that no request is retransmitted and no sample is lost on an undisturbed path to a gateway."""
        for program in self._programs:
            path = self._plan.path(program.line)
            if not self._plan.is_swift(program.line) or any(map(self._was_disturbed, path)):
                continue
            again = sum(link.statistics.repetitions for link in program.links)
            # A client of a server has no estimate of the round trip at first.
            if again and len(path) == 1:
                raise RuleError("requests retransmitted without a loss", f"{program.name}: {again}")
            for listening in program.listenings():
                if listening.lost and "buffer" not in listening.arguments:
                    raise RuleError("samples lost on an undisturbed line", f"{program.name}, {listening.addresses}")

    def _judge_losers(self) -> None:
        """Check that a link ends soon after another host has taken its gateway, unless other faults happen."""
        for program in self._programs:
            line, at = program.line, self._taken.get(program.line, math.inf)
            gateway = line.rpartition(".")[2]
            if self._faults_on(line) or any(mishap.whom == gateway for mishap in self._plan.mishaps):
                continue
            for ask in [ask for log in program.logs if log.opened < at for ask in log.asks]:
                if ask.asked <= at or ask.cancelled or ask.told is None or ask.kind == "exit":
                    continue
                if ask.error is None and ask.kind in POSTED:
                    # The write is in flight; a later call reports its outcome.
                    continue
                if ask.error is None:
                    raise RuleError("a link that continues after another host opened a session", f"{ask}, {at:.6f}")
                if ask.told > ask.asked + MOST_DOUBT:
                    raise RuleError(
                        "a link that ends late after another host opened a session", f"{ask}, ended at {ask.told}"
                    )

    def _faults_on(self, line: str) -> int:
        """Return the number of faults of a line."""
        return sum(self._network.courses[line, back].fired for back in (False, True))

    def _was_disturbed(self, line: str) -> bool:
        """Return true if a fault or mishap has affected a line, or the listener at its end."""
        if self._wire is not None and "server" not in line.rpartition(".")[2]:
            # A fault of one node or of its program may cost the other nodes a turn.
            return bool(self._plan.mishaps) or self._wire.was_disturbed
        whom = line, line.rpartition(".")[2]
        # An echo arrives within the bytes that the gateway sends at the same time.
        echoes = any(other.name == line and other.echoes for other in self._plan.lines)
        return echoes or self._faults_on(line) > 0 or any(mishap.whom in whom for mishap in self._plan.mishaps)

    async def _watch(self, place: int, server: Server) -> None:
        try:
            await server.wait()
        except UnityLinkError as error:
            self._faults.append(f"server{place} ended: {error}")

    def _nodes(self) -> dict[int, Gateway]:
        """Return all gateways as nodes of a line."""
        nodes: dict[int, Gateway] = {}
        for number, gateway in enumerate(self._plan.gateways):
            node = node_of(number)
            tap = Tap(VirtualGateway(gateway.info, node=node), self._trace, f"gateway{number}", node=node)
            self._taps.append(tap)
            nodes[node] = cast("Gateway", tap)
        return nodes

    def _target(self, line: str) -> str | Medium:
        """Return the URL or medium that the program at the beginning of a line opens."""
        if self._wire is None or ".server" in line:
            return self._plan.url(line)
        return self._wire.at(node_of(int(line[-1])))

    def _gateway(
        self, loop: SimulatedLoop, number: int, plan: GatewayPlan
    ) -> contextlib.AbstractAsyncContextManager[str]:
        bare = RtlGateway(plan.build) if plan.build else VirtualGateway(plan.info)
        # The gateware runs ahead of the clock until it is idle.
        tap = Tap(bare, self._trace, f"gateway{number}", loop.time if plan.build else None)
        tap.recorder.reading = BURST if plan.build else 0.0
        self._taps.append(tap)
        for at in plan.triggers:
            loop.call_at(at, lambda: bare.trigger(loop.time()))
        rate, name = plan.bytes_per_second, f"gateway{number}"
        served = cast("Gateway", tap if rate is None else SlowLine(cast("BareGateway", tap), rate))
        return self._serve_datagrams(served, name) if plan.datagrams else serve_tcp(served, 1, name)

    @contextlib.asynccontextmanager
    async def _serve_datagrams(self, gateway: Gateway, name: str) -> AsyncIterator[str]:
        """Serve until the end, and serve again after each reset of the gateway."""
        self._anew[name] = asyncio.Event()
        ready = asyncio.Event()
        task = asyncio.create_task(self._serve_again(gateway, name, ready))
        await ready.wait()
        try:
            yield name
        finally:
            task.cancel()
            await asyncio.wait([task])

    async def _serve_again(self, gateway: Gateway, name: str, ready: asyncio.Event) -> None:
        while True:
            async with serve_udp(gateway, 1, name):
                ready.set()
                await self._anew[name].wait()
                self._anew[name].clear()

    async def _run_programs(self, loop: SimulatedLoop) -> None:
        plan = self._plan
        for program in plan.programs:
            name, tap = program.line.partition(".")[0], gateway_of(program.line, self._taps, plan.servers)
            self._programs.append(Program(name, program, self._target(program.line), tap, self._logs, self._trace))
        tasks = [loop.create_task(program.run()) for program in self._programs]
        _, pending = await asyncio.wait(tasks, timeout=SETTLED_AFTER)
        if self._faults:
            raise RuleError("an error that no task awaits", self._faults[0])
        if pending:
            await self._give_up(tasks)
        for task in tasks:
            error = task.exception()
            if error is not None:
                raise error if isinstance(error, RuleError) else RuleError("an exception", repr(error))

    async def _give_up(self, tasks: list[asyncio.Task[None]]) -> None:
        waiting = [
            str(ask)
            for log in self._logs
            for ask in log.asks
            if ask.told is None and not ask.cancelled and ask.kind != "exit"
        ]
        for task in asyncio.all_tasks():
            if task is not asyncio.current_task():
                task.cancel()
        await asyncio.wait(tasks, timeout=10)
        raise RuleError("a program that waits without end", "; ".join(waiting[:3]) or "no call")

    def _hang_up(self, line: Line) -> None:
        """Disconnect clients after the line of their server was connected again."""
        server, _, gateway = line.name.partition(".")
        for mishap in self._plan.mishaps:
            if mishap.kind == "hang up" and mishap.whom.endswith(f".{server}") and gateway:
                self._network.loop.call_later(mishap.at * line.latency, self._befall, mishap)

    def _befall(self, mishap: Mishap) -> None:
        self._trace.append((asyncio.get_running_loop().time(), mishap.whom, "mishap", mishap.kind))
        self.outcome.injected[mishap.kind] += 1
        network = self._network
        if mishap.whom in self._anew:
            network.unplug((mishap.whom, 1))
            self._anew[mishap.whom].set()
        if mishap.kind in ("second program", "person"):
            tap = gateway_of(mishap.whom, self._taps, self._plan.servers)
            before = tap.openings
            network.intrude(mishap.whom, self._opening(mishap))
            if tap.openings > before:
                self._taken[mishap.whom] = asyncio.get_running_loop().time()
            return
        if mishap.kind == "hang up":
            network.hang_up(mishap.whom)
        elif mishap.kind == "reset in place":
            network.drop(mishap.whom)
        else:
            network.cut(mishap.whom)
        if self._wire is not None and mishap.kind == "away":
            node = node_of(int(mishap.whom[-1]))
            self._wire.gone.add(node)
            network.loop.call_later(mishap.amount, self._wire.gone.discard, node)
        if mishap.whom.startswith("gateway"):
            self._taps[int(mishap.whom[-1])].reset()
        if mishap.kind == "away":
            network.away.add(mishap.whom)
            network.loop.call_later(mishap.amount, network.away.discard, mishap.whom)

    def _opening(self, mishap: Mishap) -> bytes:
        """Return the bytes with which another host opens a session."""
        codec = Codec(gateway_of(mishap.whom, self._plan.gateways, self._plan.servers).info)
        opening = codec.opening(0, int(mishap.amount))
        return b"\n" + (opening + b"\r" if mishap.kind == "person" else codec.framing.checked(opening))

    def _count(self) -> None:
        outcome = self.outcome
        for entry in self._trace:
            if entry[2] == "fault":
                outcome.injected[entry[3].partition(" ")[0]] += 1
        outcome.requests = sum(link.statistics.requests for program in self._programs for link in program.links)
        outcome.sessions = sum(max(0, count - 1) for count in self._network.connections.values())


def _describe(context: dict[str, Any]) -> str:
    error = context.get("exception")
    return f"{context.get('message')}: {error!r}"


def run_seed(seed: int, builds: Sequence[str] = (), *, nodes: bool = False) -> Outcome:
    """Run the plan of a seed, on builds of the compiled gateware, or with gateways as nodes of one line."""
    return Scenario(Draw(seed, builds, nodes=nodes).plan()).run()
