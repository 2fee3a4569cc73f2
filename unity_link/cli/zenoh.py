"""`unity-link zenoh`: shares a robot with a Zenoh network."""

from __future__ import annotations

import threading
from typing import Annotated

import typer

from unity_link.cli.arguments import check_poll
from unity_link.cli.output import print_note
from unity_link.cli.ros import BridgeUrl, LinkUrl, Poll, run_and_sum_up
from unity_link.cli.running import run
from unity_link.cli.spec import Given, Name, SpecOrBoard, compile_or_exit, url_and_spec
from unity_link.errors import ArgumentError


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(zenoh)


def zenoh(
    url: BridgeUrl = None,
    spec: SpecOrBoard = None,
    *,
    link: LinkUrl = None,
    prefix: Annotated[
        str, typer.Option("--prefix", metavar="KEY", help="Before all keys, such as robot/1.", show_default=False)
    ],
    connect: Annotated[
        list[str] | None, typer.Option("--connect", metavar="ENDPOINT", help="Connect to it: tcp/router:7447.")
    ] = None,
    listen: Annotated[
        list[str] | None,
        typer.Option("--listen", metavar="ENDPOINT", help="Listen there: tcp/0.0.0.0:7447 is for other machines."),
    ] = None,
    mode: Annotated[str | None, typer.Option("--mode", metavar="MODE", help="peer, or client of one router.")] = None,
    config: Annotated[
        str | None, typer.Option("--config", metavar="FILE", help="Configuration of Zenoh: TLS, access control.")
    ] = None,
    every: Annotated[
        float, typer.Option("--every", metavar="SECONDS", help="Publish samples no more often, more at a time.")
    ] = 0.0,
    poll: Poll = None,
    interface: Name = None,
    given: Given = None,
) -> None:
    """Share a gateway with a Zenoh network: samples as publications, reads and writes as queries, and whole links.

    Other machines can connect only with --connect, --listen or --config. Needs pip install "unity-link[zenoh]".
    """
    from unity_link.bridges.zenoh import Network, ZenohBridge
    from unity_link.data import load

    check_poll(poll)
    if not 0 <= every < threading.TIMEOUT_MAX:
        raise ArgumentError(f"--every {every:g}: 0 or more seconds were expected")
    network = Network(connect=tuple(connect or ()), listen=tuple(listen or ()), mode=mode, config=config)
    url, spec = url_and_spec(url, spec, link)
    robot_type = load(compile_or_exit(spec, interface=interface, given=given), interface)
    bridge = ZenohBridge(robot_type, url, prefix, network=network, poll_hz=poll, every=every, report=print_note)
    run(run_and_sum_up(bridge))
