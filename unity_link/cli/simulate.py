"""`unity-link simulate`: serves a virtual gateway, with a simulated robot, to other programs.

While it runs, lines on its standard input switch faults on and off and fire triggers (`Console`).
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import stat
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from unity_link.cli.arguments import Json
from unity_link.cli.completion import complete_simulated
from unity_link.cli.output import print_error, print_note, print_result
from unity_link.cli.running import run
from unity_link.cli.words import parse_number
from unity_link.errors import ArgumentError, did_you_mean
from unity_link.transport.listening import LOOPBACK

if TYPE_CHECKING:
    from collections.abc import Iterator
    from contextlib import AbstractAsyncContextManager

    from unity_link.virtual import BareGateway, Gateway
    from unity_link.virtual.build import Wanted

_PANEL = "Where it is served (one of them; a free TCP port without)"
_ROBOT_PANEL = "What the robot of a spec does"
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


def simulate(
    robot: Annotated[
        str,
        typer.Argument(
            metavar="[ROBOT]",
            help="The simulated robot: a spec, such as robot.ul, or scara, walker or tosnet; plain memory without.",
            show_default=False,
            autocompletion=complete_simulated,
        ),
    ] = "",
    *,
    model: Annotated[
        str | None,
        typer.Option(
            metavar="FILE:CLASS", help="How it moves: my.py:Rover. Memory without.", rich_help_panel=_ROBOT_PANEL
        ),
    ] = None,
    interface: Annotated[
        str | None,
        typer.Option(help="Which public interface, where there are several.", rich_help_panel=_ROBOT_PANEL),
    ] = None,
    faults: Annotated[
        list[str] | None,
        typer.Option(
            "--fault",
            metavar="FAULT",
            help="A fault from the beginning: one of the model, or left.speed:timeout (:error, :frozen). "
            "May be repeated.",
            rich_help_panel=_ROBOT_PANEL,
        ),
    ] = None,
    triggers: Annotated[
        list[str] | None,
        typer.Option(
            "--trigger",
            metavar="GROUP:HZ",
            help="Fire the trigger of a group so often. May be repeated.",
            rich_help_panel=_ROBOT_PANEL,
        ),
    ] = None,
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
    robot_option: Annotated[str, typer.Option("--robot", hidden=True)] = "",
    rtl: Annotated[
        bool,
        typer.Option("--rtl", help="The gateware itself, compiled, instead of a model: needs a C++ compiler once."),
    ] = False,
    unchecked: Annotated[
        bool,
        typer.Option(
            "--unchecked", help="Of --rtl: do not compare VHDL of cores of your own with what GHDL makes of it."
        ),
    ] = False,
    settings: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="NAME=NUMBER", help="Build it otherwise: --set data_bits=16. May be repeated."),
    ] = None,
    nodes: Annotated[
        list[int] | None,
        typer.Option(
            "--node",
            metavar="N",
            min=0,
            max=254,
            help="A node on an RS-485 line, for each that there is: half-duplex gateways of plain memory. May be "
            "repeated; two that send at the same time are reported.",
        ),
    ] = None,
    baud: Annotated[
        int, typer.Option(metavar="N", min=1, help="Of --node: the rate of the line, in bits per second.")
    ] = 115_200,
    loss: Annotated[float, _chance("lost")] = 0.0,
    flip: Annotated[float, _chance("damaged")] = 0.0,
    double: Annotated[float, _chance("doubled")] = 0.0,
    seed: Annotated[
        int, typer.Option(metavar="N", help="Chooses which; the same seed, the same.", rich_help_panel=_NOISE_PANEL)
    ] = 0,
    json: Json = False,
) -> None:
    """Serve a virtual gateway to any program.

    Prints one line, its URL, when it is ready: give that to a program or to another command. For --usbip the line is
    the command that attaches the device, to be run as root. Ctrl-C ends it.

    While it runs, it accepts lines on standard input: trigger GROUP, fault NAME and mend NAME.
    """
    from unity_link.virtual.build import Wanted, build_bare, compile_gateway, parse_trigger, put_behind_line

    chances = {name: chance for name, chance in (("loss", loss), ("flip", flip), ("double", double)) if chance}
    wanted = Wanted(
        robot=robot or robot_option,
        model=model,
        interface=interface,
        configuration=_configuration(settings or []),
        rtl=rtl,
        unchecked=unchecked,
        faults=tuple(faults or ()),
        triggers=dict(map(parse_trigger, triggers or ())),
    )
    if rtl and not nodes:
        run(compile_gateway(wanted))
    console = None
    if nodes:
        gateway = _line(nodes, baud, wanted, chances, seed)
    else:
        bare = build_bare(wanted)
        console = Console(bare)
        gateway = put_behind_line(bare, chances=chances, seed=seed)
    if link is not None and not pty:
        raise ArgumentError("--link goes with --pty alone")
    ways: list[AbstractAsyncContextManager[str]] = []
    if pty:
        ways.append(_serving("pty", gateway, link))
    if unix is not None:
        ways.append(_serving("unix", gateway, unix))
    if udp is not None:
        ways.append(_serving("udp", gateway, udp, host, name=Path(wanted.robot).stem))
    if usbip is not None:
        ways.append(_serving_chip(gateway, usbip, host))
    if tcp is not None or not ways:
        ways.append(_serving("tcp", gateway, tcp or 0, host))
    if len(ways) != 1:
        raise ArgumentError(f"one of --pty, --tcp, --unix, --udp and --usbip was expected, not {len(ways)} of them")
    run(_simulate(ways[0], console, json=json))


def _line(nodes: list[int], baud: int, wanted: Wanted, chances: dict[str, float], seed: int) -> Gateway:
    from unity_link.virtual.build import build_nodes

    if wanted.robot or wanted.faults or wanted.triggers:
        raise ArgumentError("--node goes with gateways of plain memory: leave out the robot and its options")
    return build_nodes(
        nodes, baud, wanted.configuration, chances=chances, seed=seed, on_collision=print_note, rtl=wanted.rtl
    )


def _serving(way: str, gateway: Gateway, *place: Any, **options: str) -> AbstractAsyncContextManager[str]:
    from unity_link.virtual import serving

    manager: AbstractAsyncContextManager[str] = getattr(serving, f"serve_{way}")(gateway, *place, **options)
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


async def _simulate(way: AbstractAsyncContextManager[str], console: Console | None, *, json: bool) -> None:
    async with way as url:
        print_result("url", url, json=json)
        with contextlib.nullcontext() if console is None else console.reading():
            await asyncio.get_running_loop().create_future()


class Console:
    """Commands of a user or program to a simulated robot, as lines on the standard input."""

    def __init__(self, gateway: BareGateway) -> None:
        self._gateway = gateway
        self._rest = b""

    @contextlib.contextmanager
    def reading(self) -> Iterator[None]:
        """Execute lines while the block runs, if the standard input is a terminal or a pipe."""
        loop = asyncio.get_running_loop()
        descriptor = _console_descriptor()
        if descriptor is None:
            yield
            return
        loop.add_reader(descriptor, self._read, descriptor)
        try:
            yield
        finally:
            loop.remove_reader(descriptor)

    def _read(self, descriptor: int) -> None:
        in_background = os.isatty(descriptor) and os.tcgetpgrp(descriptor) != os.getpgrp()
        data = b"" if in_background else os.read(descriptor, 4096)
        if not data:
            asyncio.get_running_loop().remove_reader(descriptor)
            return
        *lines, self._rest = (self._rest + data).split(b"\n")
        for line in lines:
            words = line.decode(errors="replace").split()
            if not words:
                continue
            try:
                print_note(self.take(words))
            except ArgumentError as error:
                print_error(str(error))

    def take(self, words: list[str]) -> str:
        """Execute the command in a line; return a sentence for its effect.

        Raises:
            ArgumentError: for an unknown command or name.
        """
        from unity_link.virtual.simulated import parse_fault
        from unity_link.virtual.simulating import SimulatedGateway

        gateway = self._gateway
        match words:
            case ["trigger", group]:
                number = int(group) if group.isdecimal() else None
                if isinstance(gateway, SimulatedGateway):
                    gateway.fire(group)
                elif number is not None and number < gateway.info.groups:
                    gateway.trigger(asyncio.get_running_loop().time(), number)
                else:
                    raise ArgumentError(f"there is no group {group!r} here: a number was expected")
                return f"the trigger of {group} was fired"
            case [("fault" | "mend") as word, fault]:
                if not isinstance(gateway, SimulatedGateway) or gateway.robot is None:
                    raise ArgumentError("faults are of the robot of a spec, such as robot.ul")
                name, how = parse_fault(fault)
                gateway.robot.set_fault(name, how, on=word == "fault")
                return f"{name} {'is broken' if word == 'fault' else 'is mended'}"
        raise ArgumentError(f"{' '.join(words)}: trigger GROUP, fault NAME[:HOW] or mend NAME was expected")


def _console_descriptor() -> int | None:
    """Return the descriptor of a standard input that an event loop can watch, a terminal or a pipe; otherwise None."""
    try:
        descriptor = sys.stdin.fileno()
        is_console = os.isatty(descriptor) or stat.S_ISFIFO(os.fstat(descriptor).st_mode)
    except (OSError, ValueError, AttributeError):
        return None
    return descriptor if is_console and os.name == "posix" else None
