"""Two programs, one lease and a gateway that is reset: no write acts under a lease that its program does not hold.

Both programs share the gateway through a server, on simulated time. The gateway checks the result: when a guarded value
acts, the token in the lease identifies one program, and the sign of the value identifies the program that wrote it.
"""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import random
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.searching import seeds
from support.sharing import PipedLink, until
from support.simulated_time import run_simulated
from support.valve import Valve
from unity_link import LinkLostError, NotArmedError, Reconnect, UnityLinkError
from unity_link.bridges.serve.shared import SharedLink
from unity_link.data import Group
from unity_link.spec import compile_text
from unity_link.virtual.build import Wanted, simulated
from unity_link.virtual.line import SlowLine
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from unity_link.spec import Value

TEXT = """
public rover() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=0.5, FINISH=0.1) @(0xE0);
  plan: SCHEDULE(DEPTH=64) @(0x100);
  @speed = 0x10: signed READWRITE(SAFE(0, drive));
  @half = 0x11[15:0]: signed 16 READWRITE(SAFE(0, drive));
  @rest = 0x11[31:16]: signed 16 READWRITE(SAFE(0, drive));
  @duty = 0x12: signed READWRITE(SAFE(0, drive), TIMED(plan));
  @lamp = 0x20: READWRITE();
}
"""
SPECS = {
    "the server knows the lease": compile_text(TEXT),
    # A signal at the top leaves no space for a description of the spec.
    "the server does not": compile_text(TEXT.replace("  @lamp", "  @top = 0xFFF: READ();\n  @lamp")),
}
GUARDED = {"speed", "half", "rest", "duty"}
PROGRAMS = (1, -1)
OPERATIONS = 10_000
LONGEST_WORLD = 125
_program: ContextVar[int] = ContextVar("program")


class Plant(SimulatedRobot):
    """Compares the program of each guarded value that acts with the token in the lease."""

    def start(self) -> None:
        self.world: World | None = None

    def written(self, path: str, value: Value) -> None:
        assert self.world is not None
        if path in GUARDED and value:
            self.world.judge_write(path, int(value))
        elif path == "drive.disarm":
            self.world.judge_disarm()


class Program:
    """One program: its link, and its use of the lease."""

    def __init__(self, world: World, sign: int) -> None:
        self.world = world
        self.sign = sign
        self.values = itertools.count(1)
        self.within: Any = None
        """Lease of the block that the program is in."""
        self.began = 0
        """Number of interruptions of the server's link when that block began."""

    def value(self) -> int:
        return self.sign * (next(self.values) % 30_000 + 1)

    async def run(self) -> None:
        _program.set(self.sign)
        world, pick = self.world, self.world.random
        while not world.is_over():
            # The end of the block raises the remaining errors of posted writes.
            with contextlib.suppress(UnityLinkError):
                async with PipedLink(world.shared, reconnect=pick.choice([None, Reconnect(first_pause=0.001)])) as link:
                    self.robot: Any = unity_link.load(world.spec)(link)
                    while not world.is_over():
                        doing = asyncio.create_task(self.drive())
                        # Sometimes the program is interrupted at an arbitrary point.
                        await asyncio.wait([doing], timeout=pick.choice([None, None, pick.random() * 0.05]))
                        doing.cancel()
                        await asyncio.wait([doing])
                        if not link.connected and link._closed:
                            break

    async def drive(self) -> None:
        world, pick, robot = self.world, self.world.random, self.robot
        try:
            world.count()
            on_silence = pick.choice(["safe", "safe", "finish"])
            async with contextlib.AsyncExitStack() as stack:
                async with world.arming:
                    armed = robot.armed(timeout=pick.uniform(0.005, 0.4), on_silence=on_silence)
                    lease = await stack.enter_async_context(armed)
                self.within, self.began = lease, world.shared.interruptions
                try:
                    for _ in range(pick.randrange(12)):
                        with contextlib.suppress(LinkLostError, NotArmedError):
                            await self.move(lease)
                finally:
                    self.within = None
        except UnityLinkError:
            # A server that finds the lease refuses writes of programs without it.
            if world.knows_lease:
                with contextlib.suppress(UnityLinkError):
                    await robot.speed.set(self.value())
            await asyncio.sleep(pick.random() * 0.01)

    async def move(self, lease: Any) -> None:
        world, pick, robot = self.world, self.world.random, self.robot
        world.count()
        way = pick.randrange(9)
        if way == 0:
            await lease.kick()
        elif way == 1:
            await robot.speed.post(self.value())
        elif way == 2:
            # More writes than the window holds: some of them wait when the gateway is reset.
            await robot.link.post_many([0x10] * 200, [self.value() & 0xFFFFFFFF for _ in range(200)])
        elif way == 3:
            await Group(robot.speed, robot.half).set([self.value(), self.value()])
        elif way == 4:
            await robot.half.set(self.value())
        elif way == 5:
            clock = await robot.plan.clock()
            await robot.duty.set(self.value(), at=clock.now().after(pick.uniform(0, 0.1)))
        elif way == 6:
            async with robot.plan.timeline(lead=0.01, lease=pick.choice([lease, None])) as line:
                for _ in range(pick.randrange(40)):
                    await line.set({robot.duty: self.value()})
                    line.delay(0.001)
        elif way == 7:
            await asyncio.sleep(pick.random() * 0.02)
        else:
            await robot.speed.set(self.value())


class World:
    """A gateway, a server and two programs, driven by a random source."""

    def __init__(self, name: str, seed: str, operations: int) -> None:
        self.spec = SPECS[name]
        self.knows_lease = name == "the server knows the lease"
        self.random = random.Random(seed)
        self.left = operations
        self.pause = self.random.choice([0.002, 0.005, 0.02])
        """Average seconds between two disturbances."""
        # Two programs that arm at the same instant are one program to a gateway, unless the server distinguishes them.
        self.arming = asyncio.Semaphore(len(PROGRAMS) if self.knows_lease else 1)
        self.acted = self.resets = 0
        self.wrong: list[str] = []
        self.programs: dict[int, int] = {}
        """Programs by their tokens."""

    def count(self) -> None:
        self.left -= 1

    def is_over(self) -> bool:
        return self.left <= 0

    def token(self, bits: int) -> int:
        """Return a token for the program that arms."""
        token = self.random.getrandbits(bits)
        self.programs[token] = _program.get()
        return token

    @property
    def holder(self) -> int | None:
        """Program whose token is in the lease; None while the lease is not armed."""
        robot = self.gateway.robot
        token = robot.cores._of_signal["drive.arm"][0]._token
        return self.programs[token & (1 << 23) - 1] if robot.drive.armed else None

    def judge_write(self, path: str, value: int) -> None:
        self.acted += 1
        if self.holder != (1 if value > 0 else -1):
            self.wrong.append(f"{path} = {value} acted under the lease of {self.holder}")

    def judge_disarm(self) -> None:
        # This is called before the lease takes the write. A server disarms leases of an ended session.
        holder = self.holder
        program = None if holder is None else self.two[holder]
        if program is None or program.within is None or program.began != self.shared.interruptions:
            return
        token = self.gateway.robot.cores._of_signal["drive.arm"][0]._token
        if program.within._token == token and program.within.ended() is None:
            self.wrong.append(f"the lease of {holder} was disarmed in its block")

    async def disturb(self) -> None:
        """Reset the gateway, or interrupt the line to it, at random times."""
        while not self.is_over():
            await asyncio.sleep(self.random.expovariate(1 / self.pause))
            if self.random.random() < 0.8:
                self.count()
                self.resets += 1
                self.gateway.reset()
            # There is no line to interrupt between two connections.
            elif self.shared._flow.stream is not None:
                self.valve.go_away(self.shared)
                await asyncio.sleep(self.random.random() * 0.02)
                self.valve.come_back()

    async def run(self) -> None:
        wanted = Wanted(configuration={"id_digits": 2})
        self.gateway: Any = simulated(self.spec.interface(), Plant, wanted)
        self.gateway.robot.world = self
        line = self.gateway if self.random.random() < 0.5 else SlowLine(self.gateway, bytes_per_second=300_000)
        self.valve = Valve(line)
        self.shared = SharedLink(self.valve, lambda _: None)
        self.shared.open_when_there()
        await until(lambda: not self.shared.away)
        self.two = {sign: Program(self, sign) for sign in PROGRAMS}
        running = [asyncio.create_task(program.run()) for program in self.two.values()]
        disturbing = asyncio.create_task(self.disturb())
        try:
            await asyncio.gather(*running)
        finally:
            for task in (disturbing, *running):
                task.cancel()
            await asyncio.wait([disturbing, *running])
            await self.shared.finish()


def drive(name: str, seed: int, operations: int, monkeypatch: pytest.MonkeyPatch) -> tuple[int, int]:
    """Run worlds of some hundred operations each; return the number of writes that acted, and of resets."""
    acted = resets = 0
    for start in range(0, operations, LONGEST_WORLD):
        world = World(name, f"{seed} {start}", min(LONGEST_WORLD, operations - start))
        monkeypatch.setattr("unity_link.cores.lease.secrets.randbits", world.token)
        run_simulated(world.run())
        assert world.wrong == [], f"seed {seed}, world at {start}"
        acted, resets = acted + world.acted, resets + world.resets
    return acted, resets


@pytest.mark.parametrize("name", SPECS)
@pytest.mark.parametrize("seed", seeds(1, 10))
def test_no_write_acts_under_a_lease_of_the_other_program(
    name: str, seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    acted, resets = drive(name, seed, 300, monkeypatch)
    assert acted
    assert resets > 3


@pytest.mark.slow
@pytest.mark.parametrize("name", SPECS)
def test_ten_thousand_resets_arms_and_writes_respect_the_lease(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    acted, resets = drive(name, 0, OPERATIONS, monkeypatch)
    assert acted > 2000
    assert resets > 500
