"""Runs `unity-link demo` on a link and records the results; `demo_view` draws them."""

from __future__ import annotations

import asyncio
import statistics
import time
from collections import deque
from typing import TYPE_CHECKING

import msgspec

from unity_link.cli.words import signed_words, to_word
from unity_link.errors import first_error

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.link.link import Link

RATE_HZ = 100
FRAMES_PER_SECOND = 20
BATCH = 10_000
"""Number of requests in the batch that shows pipelining."""
ROUND_TRIPS = 30
"""Number of reads in one measurement, one after the other."""
PAUSE = 0.05
"""Seconds between measurements; measuring without a pause would only load the processor."""
HISTORY = 6.0
"""Seconds of motion that are stored for the plots."""
STEP = 0.7
"""Seconds from one set point to the next."""
POSES = (
    # Shoulder and elbow in degrees, z in mm, wrist in degrees: pick at the right, place at the left, twice.
    (55.0, 65.0, 20.0, 0.0),
    (55.0, 65.0, 130.0, 0.0),
    (55.0, 65.0, 20.0, 0.0),
    (-40.0, -60.0, 20.0, 180.0),
    (-40.0, -60.0, 130.0, 180.0),
    (-40.0, -60.0, 20.0, 180.0),
    (20.0, 110.0, 60.0, -90.0),
    (100.0, -80.0, 60.0, 45.0),
    (100.0, -80.0, 140.0, 45.0),
    (100.0, -80.0, 20.0, 45.0),
    (-75.0, 100.0, 20.0, -180.0),
    (-75.0, 100.0, 120.0, -180.0),
    (-75.0, 100.0, 20.0, -180.0),
    (0.0, 0.0, 0.0, 0.0),
)


class DemoStep(msgspec.Struct):
    """One call of the library, and a text for its result."""

    code: str
    result: str = ""


class Summary(msgspec.Struct, kw_only=True):
    """Results of a run of the demo; times in seconds."""

    duration_s: float
    requests: int
    repetitions: int
    samples: int
    samples_lost: int
    round_trip_median_s: float | None
    """None if the run ended before the first measurement."""
    round_trip_99_percent_s: float | None

    def describe(self) -> list[tuple[str, str]]:
        """Return the results as pairs of a name and a text."""
        pairs = [
            ("requests", f"{self.requests:,} executed exactly once, {self.repetitions:,} of them sent again"),
            ("samples", f"{self.samples:,} at {RATE_HZ} Hz, {self.samples_lost:,} lost"),
        ]
        if self.round_trip_median_s is not None and self.round_trip_99_percent_s is not None:
            median, most = 1e6 * self.round_trip_median_s, 1e6 * self.round_trip_99_percent_s
            pairs.append(("round trip", f"median {median:.0f} µs, 99 % within {most:.0f} µs"))
        return pairs


class Demo:
    """A run of the demo on a link, and its results so far."""

    def __init__(self, url: str, link: Link, duration: float) -> None:
        self.url = url
        self.gateway = link.gateway
        self.duration = duration
        self.steps: list[DemoStep] = []
        self.history: deque[tuple[float, list[int]]] = deque(maxlen=int(HISTORY * RATE_HZ))
        """Seconds from the start of the motion to the arrival of a sample, and the positions in counts."""
        self.targets: list[tuple[float, tuple[float, ...]]] = []
        """Seconds from the start of the motion to the write of a set point, and the pose."""
        self.began: float | None = None
        self._link = link
        self._round_trips: list[float] = []
        self._say: Callable[[str], None] | None = None
        self._picture: Callable[[], None] | None = None

    @property
    def elapsed(self) -> float:
        """Seconds since the motion began."""
        return 0.0 if self.began is None else time.monotonic() - self.began

    async def run(self, say: Callable[[str], None] | None = None, picture: Callable[[], None] | None = None) -> None:
        """Run the whole demo.

        Args:
            say: called with each line of text, for output without a picture.
            picture: called after a change of the results, about `FRAMES_PER_SECOND` times a second.
        """
        self._say, self._picture = say, picture
        await self._take_steps()
        await self._move()

    def summary(self) -> Summary:
        """Return the results."""
        seen = self._link.statistics
        times = self._round_trips
        # Quantiles need at least two values.
        cuts = statistics.quantiles(times, n=100) if len(times) > 1 else None
        return Summary(
            duration_s=self.elapsed,
            requests=seen.requests,
            repetitions=seen.repetitions,
            samples=seen.samples,
            samples_lost=seen.samples_lost,
            round_trip_median_s=statistics.median(times) if cuts else None,
            round_trip_99_percent_s=cuts[98] if cuts else None,
        )

    @property
    def counts(self) -> tuple[int, int, int, float | None]:
        """Requests, samples, lost samples and the median round trip in seconds so far."""
        seen = self._link.statistics
        median = statistics.median(self._round_trips) if self._round_trips else None
        return seen.requests, seen.samples, seen.samples_lost, median

    async def _take_steps(self) -> None:
        from unity_link.virtual import scara

        link = self._link
        self._begin_step(f"await link.read({scara.POSITION:#x})")
        position = await link.read(scara.POSITION)
        self._end_step(f"the shoulder is at {position} counts")

        speeds = [joint.most_speed // 2 for joint in scara.JOINTS]
        self._begin_step(f"await link.write_block({scara.SPEED_SET_POINT:#x}, speeds)")
        await link.write_block(scara.SPEED_SET_POINT, speeds)
        self._end_step("four joints, in one bus transaction")

        self._begin_step(f"await link.read_many({BATCH:,} addresses)")
        start = time.perf_counter()
        await link.read_many([scara.POSITION + number % 4 for number in range(BATCH)])
        taken = time.perf_counter() - start
        self._end_step(f"{BATCH / taken:,.0f} reads/s, each with an answer of its own")

    def _begin_step(self, code: str) -> None:
        self.steps.append(DemoStep(code))
        self._draw()

    def _end_step(self, result: str) -> None:
        self.steps[-1].result = result
        self._print(f"{self.steps[-1].code}: {result}")
        self._draw()

    def _print(self, line: str) -> None:
        if self._say is not None:
            self._say(line)

    def _draw(self) -> None:
        if self._picture is not None:
            self._picture()

    async def _move(self) -> None:
        from unity_link.virtual import scara

        addresses = [scara.POSITION + number for number in range(len(scara.JOINTS))]
        self._begin_step(f"link.subscribe(positions, rate_hz={RATE_HZ})")
        async with self._link.subscribe(addresses, rate_hz=RATE_HZ, callback=self._take):
            self.began = time.monotonic()
            self._end_step("four positions, sampled by the gateway's clock")
            with first_error():
                async with asyncio.TaskGroup() as tasks:
                    helpers = [tasks.create_task(work()) for work in (self._command, self._measure, self._report)]
                    await asyncio.sleep(self.duration)
                    for helper in helpers:
                        helper.cancel()

    def _take(self, sample: object) -> None:
        from unity_link.link.publishing import Sample

        assert isinstance(sample, Sample)
        self.history.append((self.elapsed, signed_words(sample.values, self.gateway.data_bits)))

    async def _command(self) -> None:
        """Write the poses as set points, one after the other."""
        from unity_link.virtual import scara

        number = 0
        while True:
            pose = POSES[number % len(POSES)]
            counts = [round(value * joint.counts_per_unit) for value, joint in zip(pose, scara.JOINTS, strict=True)]
            self.targets.append((self.elapsed, pose))
            await self._link.write_block(
                scara.POSITION_SET_POINT, [to_word(count, self.gateway.data_bits) for count in counts]
            )
            number += 1
            await asyncio.sleep(STEP)

    async def _measure(self) -> None:
        """Measure round trips of single reads, and draw after each measurement."""
        from unity_link.virtual import scara

        while True:
            for _ in range(ROUND_TRIPS):
                start = time.perf_counter()
                await self._link.read(scara.POSITION)
                self._round_trips.append(time.perf_counter() - start)
            self._draw()
            await asyncio.sleep(PAUSE)

    async def _report(self) -> None:
        """Print the positions of the joints once a second."""
        from unity_link.virtual import scara

        while True:
            await asyncio.sleep(1.0)
            if self.history:
                positions = zip(scara.JOINTS, self.history[-1][1], strict=True)
                text = ", ".join(
                    f"{joint.name} {count / joint.counts_per_unit:+.1f} {joint.unit}" for joint, count in positions
                )
                self._print(f"{self.elapsed:4.1f} s: {text}")
