"""`unity-link simulate`: a virtual gateway for other programs."""

from __future__ import annotations

import asyncio
from pathlib import Path  # noqa: TC003  (typer reads it)
from typing import TYPE_CHECKING, Annotated, Any

import typer

from unity_link.cli.output import print_line
from unity_link.cli.running import run
from unity_link.cli.words import parse_number
from unity_link.errors import ArgumentError, did_you_mean
from unity_link.transport.listening import LOOPBACK

if TYPE_CHECKING:
    from contextlib import AbstractAsyncContextManager

    from unity_link.virtual import Gateway

_PANEL = "Where it is served (one of them)"
_NOISE_PANEL = "What the line does to bytes of both directions"


def _place(help_text: str, metavar: str) -> Any:
    return typer.Option(metavar=metavar, help=help_text, rich_help_panel=_PANEL)


def _port(kind: str, remark: str = "") -> Any:
    return typer.Option(
        metavar="PORT", min=0, max=65535, help=f"A {kind} port; 0 for any free one.{remark}", rich_help_panel=_PANEL
    )


def _chance(what: str) -> Any:
    return typer.Option(
        metavar="P", min=0.0, max=1.0, help=f"Probability that a byte is {what}.", rich_help_panel=_NOISE_PANEL
    )


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(simulate)


def simulate(  # noqa: PLR0913  (each is an option)
    *,
    pty: Annotated[
        bool, typer.Option("--pty", help="A pseudo-terminal: looks like a serial port.", rich_help_panel=_PANEL)
    ] = False,
    tcp: Annotated[int | None, _port("TCP")] = None,
    unix: Annotated[Path | None, _place("A Unix socket, removed at the end.", "PATH")] = None,
    udp: Annotated[
        int | None, _port("UDP", " A client that opens a session takes the gateway from the one before.")
    ] = None,
    usbip: Annotated[
        int | None,
        typer.Option(
            metavar="PORT",
            min=0,
            max=65535,
            help="USB/IP, as an FT232H: a Linux with vhci-hcd attaches it. Usually 3240.",
            rich_help_panel=_PANEL,
        ),
    ] = None,
    host: Annotated[
        str, typer.Option(metavar="ADDRESS", help="Of --tcp, --udp and --usbip: the network address to listen at.")
    ] = LOOPBACK,
    link: Annotated[
        Path | None, typer.Option(metavar="PATH", help="Of --pty: a symbolic link to the port, removed at the end.")
    ] = None,
    robot: Annotated[
        str, typer.Option(metavar="NAME", help="What stands behind the bus: scara or walker; or plain memory.")
    ] = "",
    rtl: Annotated[
        bool,
        typer.Option("--rtl", help="The gateware itself, compiled, instead of a model: needs a C++ compiler once."),
    ] = False,
    settings: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="NAME=NUMBER", help="Build it otherwise: --set data_bits=16. May be repeated."),
    ] = None,
    loss: Annotated[float, _chance("lost")] = 0.0,
    flip: Annotated[float, _chance("damaged")] = 0.0,
    double: Annotated[float, _chance("doubled")] = 0.0,
    seed: Annotated[
        int, typer.Option(metavar="N", help="Chooses which; the same seed, the same.", rich_help_panel=_NOISE_PANEL)
    ] = 0,
) -> None:
    """Serve a virtual gateway to any program.

    Prints one line, its URL, when it is ready: give that to a program or to another command. For --usbip it is the
    command that attaches it, for root. Ctrl-C ends it.
    """
    from unity_link.virtual.build import build_gateway, compile_gateway

    chances = {name: chance for name, chance in (("loss", loss), ("flip", flip), ("double", double)) if chance}
    configuration = _configuration(settings or [])
    if rtl:
        run(compile_gateway(configuration))
    gateway = build_gateway(robot, configuration, rtl=rtl, chances=chances, seed=seed)
    if link is not None and not pty:
        raise ArgumentError("--link goes with --pty alone")
    ways: list[AbstractAsyncContextManager[str]] = []
    if pty:
        ways.append(_serving("pty", gateway, link))
    if tcp is not None:
        ways.append(_serving("tcp", gateway, tcp, host))
    if unix is not None:
        ways.append(_serving("unix", gateway, unix))
    if udp is not None:
        ways.append(_serving("udp", gateway, udp, host))
    if usbip is not None:
        ways.append(_serving_chip(gateway, usbip, host))
    if len(ways) != 1:
        raise ArgumentError(
            f"one of --pty, --tcp, --unix, --udp and --usbip was expected, not {len(ways) or 'none'} of them"
        )
    run(_simulate(ways[0]))


def _serving(way: str, gateway: Gateway, *place: Any) -> AbstractAsyncContextManager[str]:
    from unity_link.virtual import serving

    manager: AbstractAsyncContextManager[str] = getattr(serving, f"serve_{way}")(gateway, *place)
    return manager


def _serving_chip(gateway: Gateway, port: int, host: str) -> AbstractAsyncContextManager[str]:
    from unity_link.virtual.ft232h import VirtualFt232h
    from unity_link.virtual.ft232h.board import GatewayBoard
    from unity_link.virtual.ft232h.usbip import serve_usbip

    return serve_usbip(VirtualFt232h(GatewayBoard(gateway)), port, host)


def _configuration(settings: list[str]) -> dict[str, int]:
    from unity_link.virtual.build import CONFIGURATION

    values = {}
    for setting in settings:
        name, equals, text = setting.partition("=")
        if not equals or name not in CONFIGURATION:
            known = did_you_mean(name, CONFIGURATION if equals else ()) or f"names are {', '.join(CONFIGURATION)}"
            raise ArgumentError(f"--set {setting}: NAME=NUMBER was expected; {known}")
        try:
            values[name] = parse_number(text)
        except ValueError as error:
            raise ArgumentError(f"--set {setting}: {error}") from None
    return values


async def _simulate(way: AbstractAsyncContextManager[str]) -> None:
    async with way as url:
        print_line(url)
        await asyncio.get_running_loop().create_future()
