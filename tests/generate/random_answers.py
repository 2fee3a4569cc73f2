"""A gateway that answers at random, and a client in C that writes, posts and reads through it.

``python -m generate.random_answers SECONDS [SEED]``, from the directory of the tests, builds the client with sanitizers
and runs scenarios, each with its own seed, on simulated time. The gateway executes the requests that it receives
undamaged. Its answers arrive right, damaged, lost, late, twice, or replaced by others, and it is reset at times. It
never
reports falsely that a write was executed, or was not: no client could detect that.

The guarantee that is checked: every write is executed once, or the client reports that it failed or was lost; and the
sanitizers find no error.
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
"""Commands of a client in one scenario."""
MOST_AT_ONCE = 30_000
"""Most bytes that arrive at once: `driver.c` accepts no more."""
INFO = GatewayInfo(crc_bits=32, crc_polynomial=0x04C11DB7)


class RandomAnswers:
    """A gateway that executes undamaged requests, and answers at random."""

    def __init__(self, chance: random.Random) -> None:
        self.observed = ObservedGateway(INFO)
        self.did: Counter[str] = Counter()
        self._chance = chance
        self._crc = Crc(INFO.crc_bits, INFO.crc_polynomial)
        self._late, self._late_until = b"", 0.0
        trouble = chance.choice((0.0, 0.01, 0.05, 0.3))
        self._outcomes: dict[Callable[[bytes], bytes], float] = {
            self._right: 1 - trouble,
            self._damaged: trouble / 5,
            self._lost: trouble / 5,
            self._twice: trouble / 5,
            self._other: trouble / 5,
            self._behind_noise: trouble / 5,
        }
        self._damage, self._reset, self._pause = trouble / 10, trouble / 40, trouble / 4

    def __call__(self, data: bytes, now: float) -> bytes:
        """Pass bytes to the gateway; return the bytes that arrive."""
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
        outcome = self._chance.choices(list(self._outcomes), list(self._outcomes.values()))[0]
        self.did[outcome.__name__.strip("_")] += 1
        return outcome(frame)

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
        """Replace the answer to an executed request: by an error, another word, too many or too few words."""
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


class Scenario:
    """A client that writes, posts and reads, and the outcomes of its writes."""

    def __init__(self, program: Path, seed: int) -> None:
        self.chance = random.Random(seed)
        self.gateway = RandomAnswers(self.chance)
        self.writes: Counter[str] = Counter()
        self._program = program
        self._word = 0
        self._seen = 0

    def play(self) -> None:
        """Run the scenario; raise an AssertionError if the guarantee is violated."""
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
        """Return the words written since the last call; check that each was written once, in order."""
        log = self.gateway.observed.bus_log.writes
        words, self._seen = [word for _, word in log[self._seen :]], len(log)
        assert words == sorted(set(words)), f"words were written twice, or not in order: {words}"
        return words

    def _told(self, told: list[tuple[int, int]]) -> None:
        """Compare the statuses that the client reports for words with the writes that the bus saw."""
        executed = self._executed()
        assert set(executed) <= {word for word, _ in told}, "an earlier write was executed late"
        for word, status in told:
            self.writes[str(status)] += 1
            if status in (OK, LOST_EXECUTED):
                assert word in executed, f"{word} was reported as written, with status {status}, but was not"
            if status == LOST_NOT_EXECUTED:
                assert word not in executed, f"{word} was reported as not written, but was"

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
    """Return the client, built with sanitizers."""
    generated("c", compile_text(FIGURE_1), folder)
    sources = [folder / "unity_link.c", folder / "unity_link_posix.c", HERE / "driver.c"]
    return linked(C, compiled(C, sources, folder, *SANITIZED), folder / "driver", *SANITIZED)


def play(program: Path, seed: int) -> Scenario:
    """Run a scenario; return it.

    Raises:
        AssertionError: if the guarantee is violated; the text names the seed.
    """
    scenario = Scenario(program, seed)
    try:
        scenario.play()
    except AssertionError as error:
        raise AssertionError(f"in scenario {seed}: {error}") from error
    return scenario


def main() -> int:
    """Run scenarios for some seconds; return the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m generate.random_answers", description="Run random scenarios, one for each seed."
    )
    parser.add_argument("seconds", type=float, help="time to run")
    parser.add_argument("seed", type=int, nargs="?", default=0, help="the first seed")
    options = parser.parse_args()
    seed = options.seed
    did: Counter[str] = Counter()
    writes: Counter[str] = Counter()
    scenarios = 0
    with tempfile.TemporaryDirectory() as folder:
        program = build(Path(folder))
        until = time.monotonic() + options.seconds
        while time.monotonic() < until:
            scenario = play(program, seed + scenarios)
            scenarios += 1
            did.update(scenario.gateway.did)
            writes.update(scenario.writes)
    sys.stdout.write(f"{scenarios} scenarios from seed {seed}: every write is executed once, or reported\n")
    sys.stdout.write(f"answers: {dict(did.most_common())}\nwrites by status: {dict(writes.most_common())}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
