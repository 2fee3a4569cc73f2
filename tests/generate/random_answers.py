"""A gateway that answers at random, and a client in C that writes, posts and reads through it.

``python -m generate.random_answers SECONDS [SEED]``, from the directory of the tests, builds the client under
sanitizers and plays world after world, each by a seed of its own; time is simulated. The gateway executes what it
understands. Its answers come right, damaged, lost, late, twice, or as others than they are, and it is reset now and
then. It never says of a write that it was executed, or was not, where that is untrue: no client could know better.

What must hold: every write is executed once, or the client says that it failed or is lost, and no sanitizer finds
anything.
"""

from __future__ import annotations

import argparse
import random
import re
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

from generate.peers import ObservedGateway
from generate.programs import HERE, SANITIZED, C, Simulated, compiled, generated, linked
from support.spec_examples import FIGURE_1
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from collections.abc import Callable

OK, LOST, LOST_EXECUTED, LOST_NOT_EXECUTED = 0, 32, 33, 34
BUS_ERRORS = (b"04", b"05", b"06", b"0C", b"7F")
COMMANDS = 60
"""Commands of a client in one world."""
MOST_AT_ONCE = 30_000
"""Bytes that arrive at once: `driver.c` takes no more."""
INFO = GatewayInfo(crc_bits=32, crc_polynomial=0x04C11DB7)


class RandomAnswers:
    """A gateway that executes what it understands, and answers as chance says."""

    def __init__(self, chance: random.Random) -> None:
        self.observed = ObservedGateway(INFO)
        self.did: Counter[str] = Counter()
        self._chance = chance
        self._crc = Crc(INFO.crc_bits, INFO.crc_polynomial)
        self._late, self._late_until = b"", 0.0
        trouble = chance.choice((0.0, 0.01, 0.05, 0.3))
        self._fates: dict[Callable[[bytes], bytes], float] = {
            self._right: 1 - trouble,
            self._damaged: trouble / 5,
            self._lost: trouble / 5,
            self._twice: trouble / 5,
            self._other: trouble / 5,
            self._behind_noise: trouble / 5,
        }
        self._damage, self._reset, self._pause = trouble / 10, trouble / 40, trouble / 4

    def __call__(self, data: bytes, now: float) -> bytes:
        """Take bytes at a time, and return what arrives."""
        if self._chance.random() < self._reset:
            self.did["reset"] += 1
            self.observed.reset()
        answers = self._late + self.observed.receive(self._spoiled(data), now)
        if now < self._late_until:
            self._late = answers
            return b""
        self._late = b""
        if answers and self._chance.random() < self._pause:
            self.did["late"] += 1
            self._late, self._late_until = answers, now + self._chance.choice((0.01, 0.1, 1.0, 4.0, 7.0))
            return b""
        return b"".join(self._answered(frame) for frame in re.findall(rb"[^\n]*\n", answers))[:MOST_AT_ONCE]

    def _spoiled(self, data: bytes) -> bytes:
        if data and self._chance.random() < self._damage:
            self.did["request damaged"] += 1
            place = self._chance.randrange(len(data))
            return data[:place] + self._chance.choice((b"", b"\n", b"A", data[place:])) + data[place + 1 :]
        return data

    def _answered(self, frame: bytes) -> bytes:
        fate = self._chance.choices(list(self._fates), list(self._fates.values()))[0]
        self.did[fate.__name__.strip("_")] += 1
        return fate(frame)

    def _right(self, frame: bytes) -> bytes:
        return frame

    def _lost(self, frame: bytes) -> bytes:
        return self._chance.choice((b"", frame[:-1], frame[:3]))

    def _damaged(self, frame: bytes) -> bytes:
        place = self._chance.randrange(len(frame))
        return frame[:place] + bytes([frame[place] ^ 1 << self._chance.randrange(8)]) + frame[place + 1 :]

    def _twice(self, frame: bytes) -> bytes:
        return frame * self._chance.choice((2, 2, 9))

    def _behind_noise(self, frame: bytes) -> bytes:
        noise = self._chance.randbytes(self._chance.choice((1, 40, 9000))).replace(b"\n", b"\r")
        said = (
            noise,
            noise + b"\n",
            self._checked(b"X%02d" % self._chance.randrange(16)),
            self._checked(b"P0" + noise),
        )
        return self._chance.choice(said) + frame

    def _other(self, frame: bytes) -> bytes:
        """Answer a request that was executed by something else: an error, another word, too much, too little."""
        body = frame[: -INFO.crc_bits // 4 - 1]
        found = re.fullmatch(rb"([g-m,o-w]{1,2})([0-9A-F]{3})([0-9A-F]*)", body)
        if found is None:
            return frame
        command, number, words = found.groups()
        far = b"%03X" % (int(number, 16) + 0x800 & 0xFFF)
        bodies = (
            b"x" + number + self._chance.choice(BUS_ERRORS),
            command + number + words[::-1],
            command + number + words + b"0",
            command + number + words[1:],
            b"wk" + number + words,
            command + far + words,
            b"x" + far + b"04",
        )
        return self._checked(self._chance.choice(bodies))

    def _checked(self, body: bytes) -> bytes:
        session = self.observed.session
        bound = session and (body[:1].islower() or body.startswith(b"P"))
        return body + self._crc.text(body, seed_of(session, from_gateway=True) if bound else 0) + b"\n"


class World:
    """A client that writes, posts and reads, and what is known of its writes."""

    def __init__(self, program: Path, seed: int) -> None:
        self.chance = random.Random(seed)
        self.gateway = RandomAnswers(self.chance)
        self.writes: Counter[str] = Counter()
        self._program = program
        self._word = 0
        self._seen = 0

    def play(self) -> None:
        """Play to the end; raises an AssertionError where a rule is broken."""
        with Simulated(self._program, self.gateway) as client:
            self._open(client)
            for _ in range(COMMANDS):
                self._commands(client)[self.chance.randrange(7)](client)
                if client("end") != "0":
                    client("close")
                    self._executed()
                    self._open(client)
            client("close")

    def _commands(self, client: Simulated) -> list[Callable[[Simulated], None]]:
        return [self._apart, self._one, self._post, self._post, self._block, self._read, self._samples]

    def _open(self, client: Simulated) -> None:
        while not client("connect test: 60").startswith("0"):
            client("close")

    def _executed(self) -> list[int]:
        """Return the words written since the last time: each once, and in their order."""
        log = self.gateway.observed.bus_log.writes
        words, self._seen = [word for _, word in log[self._seen :]], len(log)
        assert words == sorted(set(words)), f"written twice, or not in order: {words}"
        return words

    def _told(self, told: list[tuple[int, int]]) -> None:
        """Compare what the client says of words with what was done."""
        executed = self._executed()
        assert set(executed) <= {word for word, _ in told}, "a write of before was executed late"
        for word, status in told:
            self.writes[str(status)] += 1
            if status in (OK, LOST_EXECUTED):
                assert word in executed, f"{word} is told as written, with status {status}, and is not"
            if status == LOST_NOT_EXECUTED:
                assert word not in executed, f"{word} is told as not written, and is"

    def _apart(self, client: Simulated) -> None:
        count = self.chance.choice((1, 5, 60, 200))
        self._executed()
        statuses = client.words(f"apart 20 {count:X}")
        self._told(list(enumerate(statuses)))

    def _one(self, client: Simulated) -> None:
        self._word += 1
        command = self.chance.choice((f"write 30 {self._word:X}", f"masked 30 {self._word:X} FFFFFFFF"))
        self._told([(self._word, int(client(command).split()[0]))])

    def _block(self, client: Simulated) -> None:
        words = [self._word + 1 + index for index in range(self.chance.choice((1, 8, 255, 300)))]
        self._word = words[-1]
        status = int(client(f"wqueue 40 {' '.join(f'{word:X}' for word in words)}").split()[0])
        executed = self._executed()
        self.writes[str(status)] += 1
        assert set(executed) <= set(words)
        assert status not in (OK, LOST_EXECUTED) or executed == words
        assert status != LOST_NOT_EXECUTED or not executed

    def _post(self, client: Simulated) -> None:
        count = self.chance.choice((1, 10, 150))
        words = [self._word + 1 + index for index in range(count)]
        self._word = words[-1]
        for word in words:
            client(f"post 50 {word:X}")
        _, _, _, failed, unknown, not_executed = client.words("posts")
        executed = self._executed()
        self.writes["posted"] += count
        assert set(executed) <= set(words)
        told = f"{len(executed)} of {count} are written; failed {failed}, lost {unknown}, not executed {not_executed}"
        assert count - failed - unknown - not_executed <= len(executed) <= count - not_executed, told

    def _read(self, client: Simulated) -> None:
        client(self.chance.choice(("read 20", "rblock 20 40", "rmany " + "20 " * 100, "rqueue 20 9", "batch 20 0")))
        self._executed()

    def _samples(self, client: Simulated) -> None:
        client("subscribe 0 100 t 10 11")
        for _ in range(self.chance.randrange(5)):
            client("next 0 0.05")
        client("unsubscribe 0")


def build(folder: Path) -> Path:
    """Return the client, under sanitizers."""
    generated("c", compile_text(FIGURE_1), folder)
    sources = [folder / "unity_link.c", folder / "unity_link_posix.c", HERE / "driver.c"]
    return linked(C, compiled(C, sources, folder, *SANITIZED), folder / "driver", *SANITIZED)


def play(program: Path, seed: int) -> World:
    """Play a world; what is wrong in it is raised with its seed.

    Raises:
        AssertionError: says which world it is.
    """
    world = World(program, seed)
    try:
        world.play()
    except AssertionError as error:
        raise AssertionError(f"in world {seed}: {error}") from error
    return world


def main() -> int:
    """Play worlds for so long; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m generate.random_answers", description="Play worlds by seed.")
    parser.add_argument("seconds", type=float, help="for so long")
    parser.add_argument("seed", type=int, nargs="?", default=0, help="the first")
    options = parser.parse_args()
    seed = options.seed
    did: Counter[str] = Counter()
    writes: Counter[str] = Counter()
    worlds = 0
    with tempfile.TemporaryDirectory() as folder:
        program = build(Path(folder))
        until = time.monotonic() + options.seconds
        while time.monotonic() < until:
            world = play(program, seed + worlds)
            worlds += 1
            did.update(world.gateway.did)
            writes.update(world.writes)
    sys.stdout.write(f"{worlds} worlds from seed {seed}: every write is executed once, or reported\n")
    sys.stdout.write(f"answers: {dict(did.most_common())}\nwrites by status: {dict(writes.most_common())}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
