"""`unity-link demo`: shows Unity-Link in ten seconds and without hardware.

The virtual SCARA moves between poses while its positions are streamed at 100 Hz and reads measure the round trip.
`demo_run` runs it and records the results; `demo_view` draws them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from unity_link.cli.arguments import DEFAULT_TIMEOUT, Json
from unity_link.cli.demo_run import Demo
from unity_link.cli.output import is_live, out, print_json, print_line
from unity_link.cli.running import run
from unity_link.cli.words import signed_words
from unity_link.errors import ArgumentError, GatewayError, UnsupportedError
from unity_link.protocol.wire.numbers import MOST_SECONDS

if TYPE_CHECKING:
    from unity_link.link.link import Link


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(demo)


def demo(
    url: Annotated[str, typer.Argument(metavar="[URL]", help="A gateway with the SCARA robot.")] = "sim:scara",
    *,
    duration: Annotated[
        float,
        typer.Option("--duration", metavar="SECONDS", min=1.0, max=MOST_SECONDS, help="How long the robot moves."),
    ] = 10.0,
    json: Json = False,
) -> None:
    """Watch a virtual robot move, read, written and sampled through Unity-Link; needs no hardware.

    Try it on a bad line, too: unity-link demo "sim:scara?flip=0.001" loses nothing.
    """
    run(_demo(url, duration, json=json))


async def _demo(url: str, duration: float, *, json: bool) -> None:
    from unity_link.link.connecting import connect

    async with connect(url, timeout=DEFAULT_TIMEOUT) as link:
        await _check_robot(url, link)
        show = Demo(url, link, duration)
        if json:
            await show.run()
            print_json(show.summary())
        elif is_live():
            await _show_live(show)
        else:
            await _show_lines(show)


async def _check_robot(url: str, link: Link) -> None:
    """Check by the contents of its registers that the robot is a SCARA, before anything is written.

    Raises:
        UnsupportedError: if it is not.
    """
    from unity_link.virtual import scara

    try:
        speeds, positions, limits = [
            signed_words(await link.read_block(first, len(scara.JOINTS)), link.gateway.data_bits)
            for first in (scara.SPEED, scara.POSITION, scara.SPEED_SET_POINT)
        ]
        is_there = all(
            abs(speed) <= joint.most_speed
            and joint.lowest <= position <= joint.highest
            and 0 < limit <= joint.most_speed
            for joint, speed, position, limit in zip(scara.JOINTS, speeds, positions, limits, strict=True)
        )
    except (ArgumentError, GatewayError):
        is_there = False
    if not is_there:
        raise UnsupportedError(
            f"no SCARA for the demo is at {url.partition('?')[0]}, by its registers from {scara.SPEED:#x} on, and "
            "nothing was written: try `unity-link demo`, or `unity-link live` for a robot of your own"
        )


async def _show_lines(show: Demo) -> None:
    try:
        await show.run(print_line)
    finally:
        for name, text in show.summary().describe():
            print_line(f"{name}: {text}")


async def _show_live(show: Demo) -> None:
    from unity_link.cli.demo_view import render, render_summary
    from unity_link.cli.full_screen import full_screen

    try:
        async with full_screen(lambda size: render(show, size)) as draw:
            await show.run(picture=draw)
    finally:
        out().print(render_summary(show.summary()))
