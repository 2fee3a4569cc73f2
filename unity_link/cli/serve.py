"""`unity-link serve`: shares one link between several programs."""

from __future__ import annotations

import asyncio
import contextlib
import ipaddress
import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from unity_link.cli.arguments import Json, Url
from unity_link.cli.output import print_json, print_line, print_note, print_result
from unity_link.cli.running import run
from unity_link.cli.signals import spec_in
from unity_link.cli.spec import compile_or_exit
from unity_link.errors import ArgumentError
from unity_link.transport.listening import LOOPBACK

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.bridges import serve as bridge
    from unity_link.spec.model import Interface

_PANEL = "Where it is served (a Unix socket by default)"
_LEASES = "Leases"
_DEFAULT_NAME = "unity-link.sock"


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(serve)


def serve(
    url: Url,
    *,
    nodes: Annotated[
        list[int] | None,
        typer.Option(
            "--node",
            metavar="N",
            min=0,
            max=254,
            help="A node on a port that several share (RS-485), for each that is served. May be repeated: each has a "
            "socket of its own, NAME-N.sock, or a TCP port, from --tcp on.",
        ),
    ] = None,
    unix: Annotated[
        Path | None,
        typer.Option(
            metavar="PATH",
            help="A Unix socket that you alone may open. Default: $XDG_RUNTIME_DIR/unity-link.sock.",
            rich_help_panel=_PANEL,
        ),
    ] = None,
    tcp: Annotated[
        int | None,
        typer.Option(metavar="PORT", min=0, max=65535, help="A TCP port; 0 for any free one.", rich_help_panel=_PANEL),
    ] = None,
    host: Annotated[
        str,
        typer.Option(
            metavar="ADDRESS",
            help="Of --tcp: the network address to listen at. Any but this machine's own needs a token.",
            rich_help_panel=_PANEL,
        ),
    ] = LOOPBACK,
    token_file: Annotated[
        Path | None,
        typer.Option(
            metavar="PATH",
            help="Of --tcp: a file with the token that clients must know: tcp://HOST:PORT?token=TOKEN. "
            "Or set UNITY_LINK_TOKEN.",
            rich_help_panel=_PANEL,
        ),
    ] = None,
    spec: Annotated[
        Path | None,
        typer.Option(
            metavar="SPEC",
            help="The spec of the gateway, such as robot.ul: with it a lease belongs to one client, and ends with it. "
            "Default: the spec that the gateway carries, or the one in a URL such as sim:robot.ul.",
            rich_help_panel=_LEASES,
        ),
    ] = None,
    interface: Annotated[
        str | None,
        typer.Option(help="Of --spec: which public interface, where there are several.", rich_help_panel=_LEASES),
    ] = None,
    json: Json = False,
) -> None:
    """Share one link between several programs.

    Prints a line for each URL under which it is served: give that to programs and to other commands. The gateway may be
    away at first and in between: clients are notified, and continue when it is back. Ctrl-C ends it.
    """
    if tcp is None and (host != LOOPBACK or token_file is not None):
        raise ArgumentError("--host and --token-file go with --tcp alone")
    token = _token(token_file)
    if tcp is not None and token is None and not _is_loopback(host):
        raise ArgumentError(
            f"--host {host} lets other machines in: give a token, by --token-file or in UNITY_LINK_TOKEN"
        )
    if tcp is None and unix is None:
        unix = _default_path()
    described = _map_of(url, spec, interface)
    run(_serve(url, nodes or [], unix, tcp, host, token, described, json=json))


def _map_of(url: str, spec: Path | None, interface: str | None) -> Interface | None:
    """Return the interface of the gateway; None if neither the options nor the URL name a spec."""
    if spec is None and interface is not None:
        raise ArgumentError("--interface goes with --spec alone")
    named = spec or spec_in(url)
    if named is None:
        return None
    from unity_link.transport import parse_url

    chosen = interface if spec is not None else parse_url(url).options.get("interface")
    return compile_or_exit(Path(named), interface=chosen).interface(chosen)


def _token(file: Path | None) -> str | None:
    if file is None:
        return os.environ.get("UNITY_LINK_TOKEN") or None
    try:
        token = file.read_text().strip()
    except (OSError, UnicodeDecodeError) as error:
        raise ArgumentError(f"no token can be read from {file} ({getattr(error, 'strerror', error)})") from error
    if not token:
        raise ArgumentError(f"{file} is empty: a token was expected in its first line")
    return token


def _is_loopback(host: str) -> bool:
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def _default_path() -> Path:
    directory = os.environ.get("XDG_RUNTIME_DIR")
    if not directory:
        raise ArgumentError("XDG_RUNTIME_DIR is not set, so there is no usual place: choose one by --unix PATH")
    return Path(directory) / _DEFAULT_NAME


def _places(
    url: str, nodes: list[int], unix: Path | None, tcp: int | None
) -> list[tuple[int | None, str, Path | None, int | None]]:
    """Return node, URL, Unix socket and TCP port of each server; each node has its own."""
    if not nodes:
        return [(None, url, unix, tcp)]
    from unity_link.transport import parse_url

    if parse_url(url).node is not None:
        raise ArgumentError(f"{url} names a node, and so does --node: leave node= out of the URL")
    if len(set(nodes)) < len(nodes):
        raise ArgumentError("a node is named twice: give each --node once")
    joint = "&" if "?" in url else "?"
    return [
        (
            node,
            f"{url}{joint}node={node}",
            None if unix is None else unix.with_name(f"{unix.stem}-{node}{unix.suffix}"),
            tcp and tcp + place,
        )
        for place, node in enumerate(nodes)
    ]


async def _serve(
    url: str,
    nodes: list[int],
    unix: Path | None,
    tcp: int | None,
    host: str,
    token: str | None,
    described: Interface | None,
    *,
    json: bool,
) -> None:
    from unity_link.bridges import serve as bridge
    from unity_link.cli.service import Service

    service = Service()
    places = _places(url, nodes, unix, tcp)
    gateways = {node: "waiting for the gateway" for node, *_ in places}
    servers: list[bridge.Server] = []

    def name(node: int | None, text: str) -> str:
        return text if node is None else f"node {node}: {text}"

    def reporter(node: int | None) -> Callable[[str], None]:
        def report(text: str) -> None:
            gateways[node] = text
            print_note(name(node, text))
            service.status(status())

        return report

    def status() -> str:
        clients = sum(server.clients for server in servers)
        return "; ".join([f"{clients} clients", *(name(node, text) for node, text in gateways.items())])

    async with contextlib.AsyncExitStack() as stack:
        for node, target, socket, port in places:
            serving = bridge.serve(
                target, unix=socket, tcp=port, host=host, token=token, interface=described, report=reporter(node)
            )
            servers.append(await stack.enter_async_context(serving))
            # Look for the gateway first: when the URL is printed, programs consider the server ready.
            await servers[-1].look()
        for (node, *_), server in zip(places, servers, strict=True):
            for place in server.urls:
                if node is None:
                    print_result("url", place, json=json)
                elif json:
                    print_json({"url": place, "node": node})
                else:
                    print_line(f"{place}\tnode {node}")
        service.tell("READY=1")
        service.tell(f"STATUS={status()}")
        signs = asyncio.create_task(service.live(status))
        try:
            await _first_end(servers)
        finally:
            signs.cancel()
            service.tell("STOPPING=1")


async def _first_end(servers: list[bridge.Server]) -> None:
    """Wait until a link has ended for good, and raise its error."""
    waiting = [asyncio.ensure_future(server.wait()) for server in servers]
    try:
        done, _ = await asyncio.wait(waiting, return_when=asyncio.FIRST_COMPLETED)
        for ended in done:
            ended.result()
    finally:
        for each in waiting:
            each.cancel()
