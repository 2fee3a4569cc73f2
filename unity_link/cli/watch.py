"""`unity-link watch`: addresses as they change, sampled by the gateway at its own clock.

On a terminal, a live table with a curve for each address; in a pipe, a line for each sample.
"""

from __future__ import annotations

import asyncio
import time
from typing import TYPE_CHECKING, Annotated

import typer

from unity_link.cli.arguments import DEFAULT_TIMEOUT, Json, Timeout, Url, number
from unity_link.cli.output import is_live, print_json, print_line, print_note
from unity_link.cli.running import run
from unity_link.errors import ArgumentError, first_error
from unity_link.protocol.numbers import Format, address_text, in_form, to_signed

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable

    from unity_link.link.link import Link
    from unity_link.link.subscription import Sample, Subscription

FRAMES_PER_SECOND = 15


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(watch)


def watch(
    url: Url,
    addresses: Annotated[
        list[int],
        typer.Argument(metavar="ADDRESS...", parser=number, help="Word addresses, such as 0x88.", show_default=False),
    ],
    *,
    rate: Annotated[float, typer.Option("--rate", metavar="HZ", help="Samples a second.")] = 20.0,
    count: Annotated[
        int | None, typer.Option("--count", metavar="SAMPLES", min=1, help="End after so many samples.")
    ] = None,
    duration: Annotated[
        float | None, typer.Option("--duration", metavar="SECONDS", min=0.0, help="End after so long.")
    ] = None,
    form: Annotated[Format, typer.Option("--format", help="How values are written.")] = Format.SIGNED,
    json: Json = False,
    timeout: Timeout = DEFAULT_TIMEOUT,
) -> None:
    """Watch addresses change, all sampled at the same instant; q or Ctrl-C ends it with a summary.

    A gateway that goes away is waited for.

    In a pipe, each sample is a line: its time in seconds, how many were lost before it, and the values, between tabs.
    Under --json the values are numbers, in two's complement for --format signed and unsigned for the others.
    """
    if not rate > 0:
        raise ArgumentError(f"a rate of {rate:g} Hz was asked for, expected more than 0")
    run(_watch(url, addresses, rate, count, duration, form, json=json, timeout=timeout))


async def _watch(
    url: str,
    addresses: list[int],
    rate: float,
    count: int | None,
    duration: float | None,
    form: Format,
    *,
    json: bool,
    timeout: float,  # noqa: ASYNC109  (an option of the command)
) -> None:
    from unity_link.link.link import connect

    async with (
        connect(url, timeout=timeout, reconnect=True) as link,
        link.subscribe(addresses, rate_hz=rate) as samples,
    ):
        start = time.monotonic()
        try:
            async with asyncio.timeout(duration):
                show = _show_live if is_live() and not json else _show_lines
                await show(url, link, samples, count, _Writer(link, form, json=json))
        except TimeoutError:
            if duration is None:
                raise
        finally:
            print_note(_summary(samples, count, time.monotonic() - start))


def _summary(samples: Subscription, count: int | None, seconds: float) -> str:
    # More may have come by the time at which as many as were asked for have been written.
    shown = samples.received if count is None else min(count, samples.received)
    # The first comes at the beginning, so there is one period less than samples.
    rate = f" ({(samples.received - 1) / seconds:,.1f} Hz)" if samples.received > 1 else ""
    return f"{shown:,} samples in {seconds:.1f} s{rate}, {samples.lost:,} lost"


async def _first(count: int | None, samples: Subscription) -> AsyncIterator[Sample]:
    """Return the first `count` samples, or all."""
    number = 0
    async for sample in samples:
        yield sample
        number += 1
        if number == count:
            return


class _Writer:
    """Writes the values of samples as the user asked for."""

    def __init__(self, link: Link, form: Format, *, json: bool) -> None:
        self.gateway = link.gateway
        self.bits = link.gateway.data_bits
        self.form = form
        self.json = json

    def text(self, word: int) -> str:
        """Write a word."""
        return in_form(word, self.bits, self.form)

    def number(self, word: int) -> int:
        """Return the number that a word stands for."""
        return to_signed(word, self.bits) if self.form is Format.SIGNED else word

    def from_number(self, value: int) -> str:
        """Write a number that `number` gave."""
        return self.text(value & (1 << self.bits) - 1)


async def _follow(
    samples: Subscription, count: int | None, take: Callable[[Sample], None], look: Callable[[], None]
) -> None:
    """Pass the first `count` samples to `take`, or all, and look beside that how things stand."""
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


async def _show_lines(url: str, link: Link, samples: Subscription, count: int | None, writer: _Writer) -> None:  # noqa: ARG001
    names = [address_text(address, link.gateway) for address in samples.schedule.addresses]
    if not writer.json:
        print_line("\t".join(["time", "lost", *names]))

    def take(sample: Sample) -> None:
        words = sample.values.tolist()
        at = sample.arrived if sample.time is None else sample.time
        if writer.json:
            values = {name: writer.number(word) for name, word in zip(names, words, strict=True)}
            print_json(
                {
                    "sequence": sample.sequence,
                    "time": sample.time,
                    "arrived": sample.arrived,
                    "lost": sample.lost,
                    "values": values,
                }
            )
        else:
            print_line("\t".join([f"{at:.6f}", str(sample.lost), *map(writer.text, words)]))

    away = False

    def look() -> None:
        nonlocal away
        if away == link.connected:
            away = not away
            print_note("the gateway has gone away: it is waited for" if away else "the gateway is back")

    await _follow(samples, count, take, look)


async def _show_live(url: str, link: Link, samples: Subscription, count: int | None, writer: _Writer) -> None:
    from unity_link.cli.full_screen import full_screen
    from unity_link.cli.watch_view import WatchView

    view = WatchView(url, link, samples, [address_text(a, link.gateway) for a in samples.schedule.addresses], writer)
    async with full_screen(view.render) as draw:
        await _follow(samples, count, view.take, draw)
