"""The plan of a scenario, drawn from a seed before it runs: gateways, servers, lines, programs and faults.

No random numbers are drawn later. If parts of a plan are left out, the remaining parts behave as before; `story` uses
this to find the shortest plan that still fails.
"""

from __future__ import annotations

import random
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from simulation.medium import HIGH, TEXTS, Fault, Line
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.virtual.rtl import configurations

if TYPE_CHECKING:
    from collections.abc import Sequence

T = TypeVar("T")

# The addresses of every gateway, by their behaviour.
PLAIN = range(0x40)
"""Words that keep their written value."""
MASKED = range(0x40, 0x50)
"""Words that keep their written value, for masked writes."""
QUEUE_IN = range(0x50, 0x58)
"""Queues that are written."""
QUEUE_OUT = range(0x58, 0x60)
"""Queues that are read: each read takes the next number."""
LIVE = range(0x60, 0x80)
"""Words that contain the number of the access, and so its instant."""
BURSTS = range(0x80, 0x90)
"""As `LIVE`, but odd and even addresses change alternately: one half is constant while the other changes."""
FAILING = range(0xE0, 0xE8)
"""Addresses at which every access ends in a bus error."""
BURST = 0.05
"""Seconds of such an alternation."""

ADDRESS_SHIFT = 24
FIRST_VALUE = 16
"""Smaller words are initial values, or counted by the device."""
LONG_CRC = 32
"""Bits of a CRC that finds all faults of the line; a shorter CRC finds one fault in a frame."""


class GatewayPlan(NamedTuple):
    """One gateway."""

    info: GatewayInfo
    bytes_per_second: float | None
    """Rate of the line, with the FIFOs at its end; None for a line without a limit."""
    triggers: tuple[float, ...]
    """Instants at which the external trigger rises."""
    datagrams: bool
    """True if the gateway is reached by datagrams instead of a stream."""
    build: str
    """Name of a build of the compiled gateware; empty for the model."""


class Step(NamedTuple):
    """One step of a task of a program."""

    kind: str
    args: tuple[Any, ...] = ()

    def requests(self) -> int:
        """Return the smallest number of requests that the step makes."""
        if self.kind in ("burst", "cancel"):
            return sum(step.requests() for step in self.args[-1])
        if self.kind in ("read_many", "write_many", "post_many"):
            return len(self.args[0])
        return 0 if self.kind == "sleep" else 1


class Life(NamedTuple):
    """A link of a program from its opening to its end."""

    reconnect: bool
    tasks: tuple[tuple[Step, ...], ...]
    close_after: float | None
    """Seconds after which the link is closed in any state; None: after all tasks."""


class ProgramPlan(NamedTuple):
    """One program."""

    line: str
    lives: tuple[Life, ...]


class Mishap(NamedTuple):
    """Event at a gateway, a server or a line, at an instant, independent of the bytes on the line."""

    at: float
    """Seconds since the start; for ``hang up``, latencies since the server's line was connected again."""
    whom: str
    kind: str
    """``reset``: the gateway is reset and its connections are cut; ``away``: it is also unreachable for a time;
    ``reset in place``: its connections stay, but the bytes that it has sent and that have not arrived are lost. A
    gateway that is reached by datagrams has no connections, and its datagrams on the way still arrive. ``hang up``:
    the connection of a client is cut each time when its server has its gateway back. ``second program`` and
    ``person``: another host on the line of a gateway opens a session."""
    amount: float
    """Seconds that it is unreachable; for another host the number of its session."""


class Plan(NamedTuple):
    """The plan of a whole scenario."""

    seed: int
    gateways: tuple[GatewayPlan, ...]
    servers: tuple[int, ...]
    """The gateway of each server."""
    lines: tuple[Line, ...]
    programs: tuple[ProgramPlan, ...]
    faults: tuple[Fault, ...]
    mishaps: tuple[Mishap, ...]
    baud: int | None = None
    """Bit rate of the half-duplex line that all gateways share as nodes; None: each gateway has its own line."""

    def url(self, line: str) -> str:
        """Return the URL of the listener at the end of a line."""
        by_datagrams = not _is_of_server(line) and gateway_of(line, self.gateways, self.servers).datagrams
        return f"{'udp' if by_datagrams else 'tcp'}://{line}:1"

    def is_never_cut(self, line: str) -> bool:
        """Return true if gateway and connections of a line are never cut, reset or mute for long."""
        cuts = {fault.line for fault in self.faults if fault.kind == "cut" or fault.amount in _AMOUNTS["mute"]}
        cuts |= {mishap.whom for mishap in self.mishaps}
        return not _is_of_server(line) and cuts.isdisjoint((line, line.rpartition(".")[2]))

    def is_swift(self, line: str) -> bool:
        """Return true if the gateway of a line receives and answers without delay, as a model does."""
        gateway = gateway_of(line, self.gateways, self.servers)
        return gateway.bytes_per_second is None and not gateway.build

    def path(self, line: str) -> list[str]:
        """Return the lines from a program to its gateway."""
        server = int(line[-1])
        return [line, f"server{server}.gateway{self.servers[server]}"] if _is_of_server(line) else [line]

    def behind_servers(self) -> dict[str, GatewayInfo]:
        """Return the gateway's configuration for each line to a server; such a line loses no bytes."""
        return {
            line.name: gateway_of(line.name, self.gateways, self.servers).info
            for line in self.lines
            if _is_of_server(line.name)
        }

    def requests(self) -> int:
        """Return the smallest number of requests that the programs make."""
        return sum(
            step.requests()
            for program in self.programs
            for life in program.lives
            for task in life.tasks
            for step in task
        )


def _is_of_server(line: str) -> bool:
    return line.rpartition(".")[2].startswith("server")


def gateway_of(line: str, gateways: Sequence[T], servers: Sequence[int]) -> T:
    """Return the gateway at the end of a line, or that of the server there."""
    number = int(line[-1])
    return gateways[servers[number] if _is_of_server(line) else number]


def node_of(gateway: int) -> int:
    """Return the node number of a gateway."""
    return gateway + 1


WIRE = "wire"
"""The name of the line that nodes share."""
_POLYNOMIALS = {8: 0x07, 16: 0x1021, 32: 0x04C11DB7}
_SPACING = 1_500
"""Bytes between two faults of a direction, so that at most one fault hits a frame with a short CRC."""


class Draw:
    """Draws a plan from a seed.

    Args:
        seed: determines the whole plan.
        builds: names of builds of the compiled gateware for the gateways; empty for models.
        nodes: if true, the gateways are nodes that share a half-duplex line.
    """

    def __init__(self, seed: int, builds: Sequence[str] = (), *, nodes: bool = False) -> None:
        self._random = random.Random(seed)
        self._builds = builds
        self._nodes = nodes
        self._seed = seed
        self._value = FIRST_VALUE
        self._listened: set[tuple[str, tuple[int, ...]]] = set()

    def plan(self) -> Plan:
        """Return the plan."""
        draw = self._random
        count = draw.choice((2, 2, 3, 4) if self._nodes else (1, 1, 1, 2, 2, 3))
        gateways = tuple(self._gateway() for _ in range(count))
        servers = tuple(number for number in range(count) if draw.random() < 0.4)
        lines = [self._line(f"server{place}.gateway{gateway}") for place, gateway in enumerate(servers)]
        programs = []
        listeners = [f"gateway{number}" for number in range(count) if number not in servers]
        # Each listener has at least one program; only a server has several, because a gateway has one host.
        listeners += [f"server{place}" for place in range(len(servers))]
        if servers:
            more = draw.choice((0, 1, 1, 2, 2, 3, 5))
            listeners += [f"server{draw.randrange(len(servers))}" for _ in range(more)]
        for number, listener in enumerate(listeners[:8]):
            line = f"p{number}.{listener}"
            lines.append(self._line(line))
            programs.append(self._program(line, gateway_of(line, gateways, servers).info, len(listeners)))
        if self._nodes:
            return self._shared(Plan(self._seed, gateways, servers, tuple(lines), tuple(programs), (), ()))
        faults = [fault for line in lines for fault in self._faults(line.name, gateways, servers)]
        mishaps = self._mishaps(count, len(servers))
        mishaps += self._hang_ups(mishaps, servers, [program.line for program in programs])
        plan = Plan(self._seed, gateways, servers, tuple(lines), tuple(programs), tuple(faults), tuple(mishaps))
        return self._with_others(plan)

    def _shared(self, plan: Plan) -> Plan:
        """Return a plan with its gateways on one line, and the faults of that line."""
        draw = self._random
        baud = draw.choice((115_200, 1_000_000, 3_000_000))
        faults = self._course(WIRE, _WIRE_FAULTS, _SPACING, HIGH) if draw.random() < _BAD_WIRES else []
        faults += [fault for line in plan.lines if _is_of_server(line.name) for fault in self._of_socket(line.name)]
        mishaps = self._mishaps(len(plan.gateways), 0) if draw.random() < _BAD_WIRES else []
        lines = (*plan.lines, Line(WIRE, 0.0, HIGH, HIGH))
        return plan._replace(lines=lines, faults=tuple(faults), mishaps=tuple(mishaps), baud=baud)

    def _with_others(self, plan: Plan) -> Plan:
        """Return a plan with other senders on the lines of gateways: hosts, boot loaders, noise and echoes."""
        # A separate generator keeps all other choices the same as without these senders.
        draw = random.Random(f"others {self._seed}")
        lines, faults, mishaps = list(plan.lines), list(plan.faults), list(plan.mishaps)
        for place, line in enumerate(plan.lines):
            gateway = gateway_of(line.name, plan.gateways, plan.servers)
            echoes, texts, seconds = (draw.random() < odds for odds in (_ECHOES, _TALKERS, _SECOND_HOSTS))
            if _is_of_server(line.name) or gateway.datagrams:
                continue
            lines[place] = line._replace(echoes=echoes)
            if texts and gateway.info.crc_bits > 8:
                for _ in range(draw.choice((1, 1, 2, 4))):
                    at, text = int(draw.expovariate(1 / 800)), draw.randrange(len(TEXTS))
                    faults.append(Fault(line.name, draw.random() < 0.5, at, "text", text))
            if texts and not seconds and not any(mishap.whom == line.name.rpartition(".")[2] for mishap in mishaps):
                at = _OPENED + int(draw.expovariate(1 / 800))
                faults.append(Fault(line.name, False, at, "typed", 0))
            if seconds and not line.name.startswith("server"):
                kind, number = draw.choice(("second program", "second program", "person")), draw.randrange(1, 0x80)
                mishaps.append(Mishap(draw.uniform(0.005, 0.6), line.name, kind, number))
        return plan._replace(lines=tuple(lines), faults=tuple(faults), mishaps=tuple(mishaps))

    # Gateways, lines and faults

    def _gateway(self) -> GatewayPlan:
        draw = self._random
        # If two nodes send at once, a frame is damaged in many places.
        crc_bits = LONG_CRC if self._nodes else draw.choice((8, 16, 32))
        features = GatewayInfo().features
        slow = draw.random() < 0.15
        fifo = draw.choice((64, 256))
        if draw.random() < (0.6 if slow else 0.1) or self._nodes:
            features &= ~Feature.FLOW_CONTROL
        if self._nodes:
            features |= Feature.HALF_DUPLEX | Feature.ADDRESSED
        data_bits = draw.choice((32, 32, 36))
        # A separate generator keeps all other choices the same as without the compact form.
        if data_bits % 8 == 0 and random.Random(f"form {self._seed}").random() < _COMPACT:
            features |= Feature.COMPACT
        info = GatewayInfo(
            data_bits=data_bits,
            id_digits=2 if draw.random() < 0.93 else 3,
            crc_bits=crc_bits,
            crc_polynomial=_POLYNOMIALS[crc_bits],
            block_words=draw.choice((4, 255, 255)),
            groups=draw.choice((1, 2, 3, 4, 16)),
            group_words=16,
            base_frequency_millihertz=draw.choice((200_000, 200_000, 1_000_000)),
            receive_fifo_bytes=fifo,
            transmit_fifo_bytes=fifo,
            features=features,
        )
        triggers = tuple(sorted(draw.uniform(0, 3) for _ in range(draw.choice((0, 0, 5, 20)))))
        rate = draw.choice((50_000.0, 200_000.0)) if slow else None
        datagrams, build = draw.random() < 0.2, ""
        if self._builds:
            build = draw.choice(self._builds)
            info, rate = configurations()[build].info, None
        if self._nodes:
            rate, datagrams = None, False
        return GatewayPlan(info, rate, triggers, datagrams, build)

    def _line(self, name: str) -> Line:
        draw = self._random
        latency, piece = draw.choice((0.0, 2e-5, 2e-4, 1e-3, 5e-3, 2e-2)), draw.choice((HIGH, HIGH, HIGH, 64, 13))
        return Line(name, latency, piece, draw.choice((HIGH, HIGH, HIGH, 300)))

    def _faults(self, line: str, gateways: tuple[GatewayPlan, ...], servers: tuple[int, ...]) -> list[Fault]:
        draw = self._random
        if draw.random() < 0.1:
            return []
        kinds: tuple[str, ...] = _FAULTS
        gateway, spacing = gateway_of(line, gateways, servers), _SPACING
        if _is_of_server(line):
            kinds = _SOCKET_FAULTS
        elif gateway.datagrams:
            kinds, spacing = _DATAGRAM_FAULTS, 0
        most = 1000 if gateway.info.crc_bits == LONG_CRC or gateway.datagrams else 1
        return self._course(line, kinds, spacing, most)

    def _of_socket(self, line: str) -> list[Fault]:
        return self._course(line, _SOCKET_FAULTS, _SPACING, 1)

    def _course(self, line: str, kinds: tuple[str, ...], spacing: int, most: int) -> list[Fault]:
        draw = self._random
        faults: list[Fault] = []
        for back in (False, True):
            place = 0
            for _ in range(draw.choice((0, 1, 2, 4, 8))):
                place += int(draw.expovariate(1 / 250)) + (spacing if faults and faults[-1].back == back else 0)
                faults.append(self._fault(line, draw.choice(kinds), place, back=back, most=most))
        return faults

    def _fault(self, line: str, kind: str, at: int, *, back: bool, most: int) -> Fault:
        draw = self._random
        amount = 1 << draw.randrange(8) if kind == "flip" else draw.choice(_AMOUNTS[kind])
        if kind in ("lose", "double", "mute"):
            amount = min(most, amount)
        return Fault(line, back, at, "lose" if kind == "mute" else kind, amount)

    def _mishaps(self, gateways: int, servers: int) -> list[Mishap]:
        draw = self._random
        mishaps = []
        for number in range(gateways):
            for _ in range(draw.choice((0, 0, 1, 1, 2))):
                kind = draw.choice(("reset", "reset in place", "away"))
                mishaps.append(Mishap(draw.uniform(0.005, 0.6), f"gateway{number}", kind, draw.choice((0.1, 0.6, 3.0))))
        mishaps += [
            Mishap(draw.uniform(0.01, 0.6), f"server{number}", "away", draw.choice((0.1, 0.6)))
            for number in range(servers)
            if draw.random() < 0.2
        ]
        return mishaps

    def _hang_ups(self, mishaps: list[Mishap], servers: tuple[int, ...], lines: list[str]) -> list[Mishap]:
        """Draw the clients that a server loses while it sets up their groups again, after three requests."""
        draw = self._random
        lost = {mishap.whom for mishap in mishaps}
        return [
            Mishap(draw.uniform(6.0, 9.0), line, "hang up", 0.0)
            for line in lines
            if _is_of_server(line) and f"gateway{servers[int(line[-1])]}" in lost and draw.random() < 0.6
        ]

    # The programs

    def _program(self, line: str, info: GatewayInfo, programs: int) -> ProgramPlan:
        draw = self._random
        lives = []
        for _ in range(draw.choice((1, 1, 1, 2))):
            tasks = []
            for _ in range(draw.choice((1, 2, 2, 3))):
                size = draw.choice((3, 6, 10, 14)) // (1 if programs < 3 else 2)
                tasks.append(tuple(self._step(info) for _ in range(size + 1)))
            close_after = draw.uniform(0.01, 0.5) if draw.random() < 0.2 else None
            lives.append(Life(draw.random() < 0.8, tuple(tasks), close_after))
        return ProgramPlan(line, tuple(lives))

    def _step(self, info: GatewayInfo) -> Step:
        kind = self._random.choices(_STEPS, _STEP_WEIGHTS)[0]
        if kind == "listen":
            return self._listen(info)
        if kind == "burst":
            return Step("burst", (tuple(self._call() for _ in range(self._random.choice((4, 8, 16)))),))
        if kind == "cancel":
            # A later cancel hits the calls that the line has lost or delays.
            after, count = self._random.choice((0.0, 1e-3, 0.01, 0.04, 0.04)), self._random.choice((1, 4, 8))
            return Step("cancel", (after, tuple(self._call() for _ in range(count))))
        if kind == "sleep":
            return Step("sleep", (self._random.choice((0.0, 0.001, 0.02, 0.1)),))
        return self._call()

    def _call(self) -> Step:
        kind = self._random.choices(_CALLS, _CALL_WEIGHTS)[0]
        step: Step = getattr(self, f"_{kind}")()
        return step

    def _next(self, address: int) -> int:
        self._value += 1
        return address << ADDRESS_SHIFT | self._value

    def _plain(self) -> int:
        draw = self._random
        roll = draw.random()
        if roll < 0.7:
            return draw.choice(PLAIN)
        return draw.choice(LIVE) if roll < 0.95 else draw.choice(FAILING)

    def _target(self) -> int:
        draw = self._random
        return draw.choice(PLAIN) if draw.random() < 0.95 else draw.choice(FAILING)

    def _read(self) -> Step:
        return Step("read", (self._plain(),))

    def _write(self) -> Step:
        address = self._target()
        return Step("write", (address, self._next(address)))

    def _write_masked(self) -> Step:
        address = self._random.choice(MASKED)
        return Step("write_masked", (address, self._next(address), (1 << ADDRESS_SHIFT) - 1))

    def _post(self) -> Step:
        address = self._target()
        return Step("post", (address, self._next(address)))

    def _fence(self) -> Step:
        return Step("fence")

    def _send_immediate(self) -> Step:
        return Step("send_immediate", (self._random.choice(("off", "always", "adaptive")),))

    def _read_block(self) -> Step:
        count = self._random.choice((1, 2, 5, 20))
        return Step("read_block", (self._random.randrange(0x40 - count), count))

    def _write_block(self) -> Step:
        count = self._random.choice((1, 2, 5, 20))
        first = self._random.randrange(0x40 - count)
        return Step("write_block", (first, tuple(self._next(first + place) for place in range(count))))

    def _read_queue(self) -> Step:
        return Step("read_queue", (self._random.choice(QUEUE_OUT), self._random.choice((1, 2, 5))))

    def _write_queue(self) -> Step:
        address = self._random.choice(QUEUE_IN)
        return Step("write_queue", (address, tuple(self._next(address) for _ in range(self._random.choice((1, 2, 5))))))

    def _read_many(self) -> Step:
        return Step("read_many", (tuple(self._plain() for _ in range(self._many())),))

    def _write_many(self) -> Step:
        addresses = tuple(self._target() for _ in range(self._many()))
        return Step("write_many", (addresses, tuple(self._next(address) for address in addresses)))

    def _post_many(self) -> Step:
        addresses = tuple(self._target() for _ in range(self._many()))
        return Step("post_many", (addresses, tuple(self._next(address) for address in addresses)))

    def _many(self) -> int:
        return self._random.choice((3, 12, 40, 40))

    def _listen(self, info: GatewayInfo) -> Step:
        draw = self._random
        kind = draw.choice(("asked",) if self._nodes else _GROUPS)
        while True:
            # Words that change alternately are taken from one half only.
            pool = BURSTS[draw.randrange(2) :: 2] if kind == "changed" else LIVE
            addresses = tuple(draw.sample(pool, draw.choice((1, 1, 2)))) + tuple(
                draw.sample(PLAIN, draw.choice((0, 0, 1, 3)))
            )
            if (kind, addresses) not in self._listened:
                break
        self._listened.add((kind, addresses))
        base = info.base_frequency_hz
        quick = max(1, round(base / _QUICK))
        arguments: dict[str, Any] = {}
        if kind in ("periodic", "changed"):
            divisors = (1, 2, 5) if base <= _SLOW or kind == "changed" else (5, 20)
            arguments["divisor"] = quick * draw.choice(divisors)
        arguments["on_change"] = kind == "changed"
        arguments["trigger"] = kind == "triggered"
        arguments["timestamps"] = draw.random() < 0.6
        if draw.random() < 0.3:
            arguments["buffer"] = draw.choice((1, 4, 16))
            arguments["overflow"] = draw.choice(("drop_oldest", "drop_oldest", "fail"))
        pace = draw.choice((0.0, 0.0, 0.0, 0.03))
        publishes = draw.choice((1, 3, 12)) if kind == "asked" else draw.choice((0, 0, 0, 2))
        publishes = 0 if kind == "changed" else publishes
        seconds = draw.choice((0.02, 0.1, 0.3))
        manner = tuple(how for how, chance in _MANNERS.items() if draw.random() < chance)
        return Step("listen", (addresses, tuple(sorted(arguments.items())), seconds, pace, publishes, manner))


_GROUPS = ("periodic", "periodic", "periodic", "asked", "changed", "triggered")
"""Causes of publication of groups."""
_OPENED = 500
"""Bytes after which most hosts have opened a session; a person types nothing before that."""
_ECHOES, _TALKERS, _SECOND_HOSTS = 0.1, 0.5, 0.3
"""Probabilities that a gateway's line echoes, that texts are sent on it, and that another host uses it."""
_COMPACT = 0.6
"""Probability that a gateway has the compact form, if its words permit it."""
_BAD_WIRES = 0.7
"""Probability of faults of nodes, and of faults of their line."""
_WIRE_FAULTS = ("lose", "lose", "flip", "flip", "double")
_FAULTS = ("lose", "lose", "flip", "flip", "double", "stall", "cut", "mute")
_DATAGRAM_FAULTS = ("lose", "lose", "flip", "copy", "copy", "late", "late", "mute")
_SOCKET_FAULTS = ("stall", "stall", "cut")
"""Faults of a socket between a server and its clients."""
_SLOW, _QUICK = 200, 1_000
"""In Hz: up to the first base frequency a group may publish at each tick; the second limits the rates of all groups."""
_AMOUNTS: dict[str, tuple[float, ...]] = {
    "lose": (1, 1, 1, 2, 30),
    "double": (1, 1, 2, 40),
    "mute": (100, 300, 1000),
    "stall": (0.005, 0.05, 0.3),
    "cut": (0.0, 0.0, 0.001, 0.05),
    "copy": (0.0, 0.001, 0.01, 0.1, 0.4, 2.0),
    "late": (0.0, 0.001, 0.01, 0.1, 0.4, 2.0),
}
"""Amounts that a `Fault` may have."""
_CALL_ODDS = {
    "read": 20,
    "write": 20,
    "write_masked": 4,
    "post": 12,
    "fence": 4,
    "send_immediate": 1,
    "read_block": 6,
    "write_block": 6,
    "read_queue": 4,
    "write_queue": 4,
    "read_many": 4,
    "write_many": 4,
    "post_many": 3,
}
_MANNERS = {"by callback": 0.2, "in haste": 0.3}
"""Ways in which a program listens, with their frequencies: by a callback, and without waiting for the end of its group
when it leaves.
"""
_STEP_ODDS = {"call": 60, "burst": 12, "cancel": 12, "sleep": 8, "listen": 12}
_CALLS, _CALL_WEIGHTS = list(_CALL_ODDS), list(_CALL_ODDS.values())
_STEPS, _STEP_WEIGHTS = list(_STEP_ODDS), list(_STEP_ODDS.values())
