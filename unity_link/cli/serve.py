"""`unity-link serve`: one link for several programs."""

from __future__ import annotations

import asyncio
import ipaddress
import os
from pathlib import Path
from typing import Annotated

import typer

from unity_link.cli.arguments import Url  # noqa: TC001  (typer reads it)
from unity_link.cli.output import print_line, print_note
from unity_link.cli.running import run
from unity_link.errors import ArgumentError
from unity_link.transport.listening import LOOPBACK

_PANEL = "Where it is served (a Unix socket if nothing is said)"
_DEFAULT_NAME = "unity-link.sock"


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(serve)


def serve(
    url: Url,
    *,
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
            help="Of --tcp: the network address to listen at. Any but this machine's own wants a token.",
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
) -> None:
    """Share one link between several programs.

    Prints a line for each URL under which it is served: give that to programs and to other commands. The gateway may be
    away at first and in between: clients are told, and go on when it is back. Ctrl-C ends it.
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
    run(_serve(url, unix, tcp, host, token))


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


async def _serve(url: str, unix: Path | None, tcp: int | None, host: str, token: str | None) -> None:
    from unity_link.bridges import serve as bridge
    from unity_link.cli.service import Service

    service = Service()
    gateway = "waiting for the gateway"

    def report(text: str) -> None:
        nonlocal gateway
        gateway = text
        print_note(text)
        service.status(status())

    def status() -> str:
        return f"{server.clients} clients; {gateway}"

    async with bridge.serve(url, unix=unix, tcp=tcp, host=host, token=token, report=report) as server:
        # What prints its URL is taken for ready.
        await server.look()
        for place in server.urls:
            print_line(place)
        service.tell("READY=1")
        service.tell(f"STATUS={status()}")
        signs = asyncio.create_task(service.live(status))
        try:
            await server.wait()
        finally:
            signs.cancel()
            service.tell("STOPPING=1")
