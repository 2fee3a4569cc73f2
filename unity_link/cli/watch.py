"""`unity-link watch`: shows addresses or signals as they change, sampled by the gateway at its own clock.

On a terminal it shows a live table with curves; in a pipe it prints a line for each sample.
"""

from __future__ import annotations

import asyncio
import functools
import time
from contextlib import AsyncExitStack
from typing import TYPE_CHECKING, Annotated

import typer

from unity_link.bridges.presence import Presence
from unity_link.cli.arguments import DEFAULT_TIMEOUT, Json, Timeout, Url, number
from unity_link.cli.completion import complete_signal
from unity_link.cli.output import is_live, print_json, print_line, print_note
from unity_link.cli.running import run
from unity_link.cli.signals import is_spec, robot_of, split
from unity_link.cli.spec import Name
from unity_link.cli.watched import WatchedSignals, Words
from unity_link.errors import ArgumentError, UnityLinkError, first_error
from unity_link.protocol.wire.numbers import MOST_SECONDS, Format

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable

    from unity_link.cli.watched import Stream, Taken, Watched
    from unity_link.link.link import Link

FRAMES_PER_SECOND = 15


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(watch)


def watch(
    url: Url,
    signals: Annotated[
        list[str],
        typer.Argument(
            metavar="ADDRESS... | [SPEC] SIGNAL...",
            help="Word addresses, such as 0x88; or a spec, such as robot.ul, and signals: j1.position, a part as j1, "
            "a pattern as '*.position'.",
            autocompletion=complete_signal,
            show_default=False,
        ),
    ],
    *,
    rate: Annotated[float, typer.Option("--rate", metavar="HZ", help="Samples a second.")] = 20.0,
    count: Annotated[
        int | None, typer.Option("--count", metavar="SAMPLES", min=1, help="End after so many samples.")
    ] = None,
    duration: Annotated[
        float | None,
        typer.Option("--duration", metavar="SECONDS", min=0.0, max=MOST_SECONDS, help="End after so long."),
    ] = None,
    form: Annotated[
        Format | None, typer.Option("--format", help="How the words at addresses are written: signed without.")
    ] = None,
    interface: Name = None,
    json: Json = False,
    timeout: Timeout = DEFAULT_TIMEOUT,
) -> None:
    """Watch addresses or signals change, all sampled at the same instant; q or Ctrl-C ends it with a summary.

    If the gateway disconnects, the command waits until it is back.

    In a pipe, each sample is a line: its time in seconds, the number of samples lost before it, and the values,
    separated by tabs. Signals are in their units. Under --json the values of addresses are numbers: in two's complement
    for --format signed, otherwise unsigned. Without a SPEC, the environment variable UNITY_LINK_SPEC names it.
    """
    if not rate > 0:
        raise ArgumentError(f"a rate of {rate:g} Hz was asked for, expected more than 0")
    watched: Watched
    if _are_addresses(signals):
        if interface is not None:
            raise ArgumentError("--interface goes with a SPEC and signals")
        watched = Words([number(text) for text in signals], form or Format.SIGNED)
    elif form is not None:
        raise ArgumentError(f"--format {form} goes with addresses: signals are written in their units")
    else:
        spec, names = split(url, signals)
        watched = WatchedSignals(robot_of(spec, interface), names)
    run(_watch(url, watched, rate, count, duration, json=json, timeout=timeout))


def _are_addresses(texts: list[str]) -> bool:
    """Return whether all texts are addresses; each must begin with a digit, and the first must not be a spec."""
    return not is_spec(texts[0]) and all(text[:1].isdigit() for text in texts)


async def _watch(
    url: str,
    watched: Watched,
    rate: float,
    count: int | None,
    duration: float | None,
    *,
    json: bool,
    timeout: float,
) -> None:
    from unity_link.bridges.log_once import Faults
    from unity_link.bridges.waiting import begin_when_there
    from unity_link.link.connecting import connect

    samples: Stream | None = None
    refused = False
    async with connect(url, timeout=timeout, reconnect=True) as link, AsyncExitStack() as stack:
        start = time.monotonic()
        try:
            async with asyncio.timeout(duration):
                subscribe = functools.partial(watched.subscribe, link, rate)
                samples = await begin_when_there(subscribe, stack, Faults(print_note).tell)
                start = time.monotonic()
                show = _show_live if is_live() and not json else _show_lines
                await show(url, link, samples, count, watched, json=json)
        except TimeoutError:
            if duration is None:
                raise
        except UnityLinkError:
            refused = samples is None
            raise
        finally:
            if not refused:
                print_note(_summary(samples, count, time.monotonic() - start))


def _summary(samples: Stream | None, count: int | None, seconds: float) -> str:
    if samples is None:
        return f"0 samples in {seconds:.1f} s, 0 lost"
    # More samples may have arrived since the requested number was printed.
    shown = samples.received if count is None else min(count, samples.received)
    # The first sample is taken at the start, so there is one period less than samples.
    rate = f" ({(samples.received - 1) / seconds:,.1f} Hz)" if samples.received > 1 else ""
    return f"{shown:,} samples in {seconds:.1f} s{rate}, {samples.lost:,} lost"


async def _first(count: int | None, samples: Stream) -> AsyncIterator[Taken]:
    """Yield the first `count` samples, or all if it is None."""
    number = 0
    async for sample in samples:
        yield sample
        number += 1
        if number == count:
            return


async def _follow(samples: Stream, count: int | None, take: Callable[[Taken], None], look: Callable[[], None]) -> None:
    """Pass the first `count` samples to `take`, or all; meanwhile call `look` at regular intervals."""
    with first_error():
        async with asyncio.TaskGroup() as tasks:
            beside = tasks.create_task(_repeat(look))
            try:
                async for sample in _first(count, samples):
                    take(sample)
            finally:
                beside.cancel()


async def _repeat(action: Callable[[], None]) -> None:
    while True:
        await asyncio.sleep(1 / FRAMES_PER_SECOND)
        action()


async def _show_lines(
    url: str,  # noqa: ARG001  (as `_show_live`)
    link: Link,
    samples: Stream,
    count: int | None,
    watched: Watched,
    *,
    json: bool,
) -> None:
    if not json:
        print_line("\t".join(["time", "lost", *watched.names]))

    def take(sample: Taken) -> None:
        values = watched.values(sample)
        at = sample.arrived if sample.time is None else sample.time
        if json:
            print_json(
                {
                    "sequence": sample.sequence,
                    "time": sample.time,
                    "arrived": sample.arrived,
                    "lost": sample.lost,
                    "values": dict(zip(watched.names, map(watched.plain, values), strict=True)),
                }
            )
        else:
            print_line("\t".join([f"{at:.6f}", str(sample.lost), *map(watched.text, values)]))

    presence = Presence(link, time.monotonic())

    def look() -> None:
        was_there = presence.away_since is None
        presence.look(time.monotonic(), samples.received, samples.rate_hz)
        if was_there != (presence.away_since is None):
            print_note("the gateway has disconnected: waiting until it is back" if was_there else "the gateway is back")

    await _follow(samples, count, take, look)


async def _show_live(
    url: str,
    link: Link,
    samples: Stream,
    count: int | None,
    watched: Watched,
    *,
    json: bool,  # noqa: ARG001  (as `_show_lines`)
) -> None:
    from unity_link.cli.full_screen import full_screen
    from unity_link.cli.watch_view import WatchView

    view = WatchView(url, link, samples, watched)
    async with full_screen(view.render) as draw:
        await _follow(samples, count, view.take, draw)
