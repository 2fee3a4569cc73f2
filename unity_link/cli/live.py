"""`unity-link live`: shows signals as live plots on a web page of this computer."""

from __future__ import annotations

import contextlib
import math
import os
import secrets
import sys
import threading
import time
from typing import TYPE_CHECKING, Annotated
from urllib.parse import quote

import typer

from unity_link.cli.arguments import DEFAULT_TIMEOUT, Json, Timeout, Url, number
from unity_link.cli.output import print_note, print_result
from unity_link.cli.running import run
from unity_link.cli.spec import Given, Name, SpecOrBoard, compile_or_exit, spec_behind
from unity_link.errors import ArgumentError, ConnectError

if TYPE_CHECKING:
    import socket

    from unity_link.bridges.live import LivePage
    from unity_link.bridges.sampled import SampledGroup
    from unity_link.data import Robot
    from unity_link.link.link import Link
    from unity_link.spec import Spec

PORT = 8421
FOXGLOVE_PORT = 8765
"""Default port of the Foxglove app."""
_FOXGLOVE = "Foxglove"


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(live)


def live(
    url: Url,
    spec: SpecOrBoard = None,
    *,
    watch: Annotated[
        list[int] | None,
        typer.Option(
            "--watch", metavar="ADDRESS", parser=number, help="Without a spec: a word to show; again for each word."
        ),
    ] = None,
    rate: Annotated[float, typer.Option("--rate", metavar="HZ", help="Of --watch: samples a second.")] = 100.0,
    poll: Annotated[
        float,
        typer.Option(
            "--poll", metavar="HZ", help="Rate at which signals that no group samples are read; 0: not at all."
        ),
    ] = 10.0,
    allow_writes: Annotated[
        bool, typer.Option("--allow-writes", help="Let the page that knows the printed token write signals.")
    ] = False,
    port: Annotated[
        int, typer.Option("--port", metavar="PORT", min=0, max=65535, help="Of the page; 0 for any free one.")
    ] = PORT,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Whether to open the page.")] = True,
    foxglove: Annotated[
        bool, typer.Option("--foxglove", help="Also serve the samples to the Foxglove app.", rich_help_panel=_FOXGLOVE)
    ] = False,
    foxglove_port: Annotated[
        int | None,
        typer.Option(
            "--foxglove-port",
            metavar="PORT",
            min=1,
            max=65535,
            help=f"Of --foxglove; without it {FOXGLOVE_PORT}.",
            rich_help_panel=_FOXGLOVE,
        ),
    ] = None,
    interface: Name = None,
    given: Given = None,
    json: Json = False,
    timeout: Timeout = DEFAULT_TIMEOUT,
) -> None:
    """Show signals as live plots on a web page of this machine.

    Prints the address of the page and opens it. Gateway and browser may disconnect and come back. Ctrl-C ends it.
    """
    if spec is not None and watch:
        raise ArgumentError("a SPEC was expected, or words by --watch ADDRESS, not both")
    for name, hertz in (("--rate", rate), ("--poll", poll)):
        if not 0 <= hertz < math.inf or (name == "--rate" and hertz == 0):
            raise ArgumentError(
                f"{name} {hertz:g}: {'more than 0' if name == '--rate' else '0 or more'} Hz was expected"
            )
    if foxglove_port is not None and not foxglove:
        raise ArgumentError("--foxglove-port is of --foxglove: give both")
    compiled = None if watch else compile_or_exit(spec_behind(url, spec), interface=interface, given=given)
    chosen = _Shown(compiled, interface, watch or [], rate, poll or None)
    token = _token() if allow_writes else None
    app_port = foxglove_port or FOXGLOVE_PORT if foxglove else None
    run(_live(url, chosen, token, port, app_port, browser=browser, json=json, timeout=timeout))


class _Shown:
    """Signals and groups to show."""

    def __init__(
        self, spec: Spec | None, interface: str | None, words: list[int], rate: float, poll: float | None
    ) -> None:
        self._spec = spec
        self._interface = interface
        self._words = words
        self._rate = rate
        self._poll = poll

    async def behind(self, link: Link) -> tuple[Robot, list[SampledGroup]]:
        """Return the robot of a link, and the groups to show."""
        if self._spec is None:
            from unity_link.bridges.live import robot_of_words

            return robot_of_words(link, self._words, self._rate)
        from unity_link.bridges.sampled import sampled_groups
        from unity_link.data import load
        from unity_link.data.describing import robot_behind

        robot = await robot_behind(link, load(self._spec, self._interface))
        return robot, sampled_groups(robot, self._poll)


def _token() -> str:
    return os.environ.get("UNITY_LINK_TOKEN") or secrets.token_urlsafe(16)


async def _live(
    url: str,
    shown: _Shown,
    token: str | None,
    port: int,
    foxglove_port: int | None,
    *,
    browser: bool,
    json: bool,
    timeout: float,
) -> None:
    try:
        from unity_link.bridges.live import LivePage, bind
        from unity_link.bridges.live.foxglove import FoxgloveServer
    except ModuleNotFoundError:
        raise ConnectError(
            "the page needs a web server, which is not installed: pip install 'unity-link[live]'"
        ) from None
    from unity_link.link.connecting import connect

    async with contextlib.AsyncExitStack() as stack:
        link = await stack.enter_async_context(connect(url, timeout=timeout, reconnect=True))
        robot, groups = await shown.behind(link)
        foxglove = None
        if foxglove_port is not None:
            foxglove = stack.enter_context(FoxgloveServer(robot, groups, foxglove_port))
        listener = stack.enter_context(bind(port))
        page = LivePage(robot, groups, gateway=url, token=token, foxglove=foxglove, report=print_note)
        _announce(listener, token, foxglove, browser=browser, json=json)
        began = time.monotonic()
        try:
            await page.run(listener)
        finally:
            print_note(_summary(page, time.monotonic() - began))


def _announce(listener: socket.socket, token: str | None, foxglove: object, *, browser: bool, json: bool) -> None:
    host, port = listener.getsockname()
    address = f"http://{host}:{port}/" + ("" if token is None else f"#token={quote(token, safe='')}")
    print_result("page", address, json=json)
    if foxglove is not None:
        print_result("foxglove", foxglove, json=json)
    if browser and _has_screen():
        import webbrowser

        # Open it in a thread: some browsers block their caller until they end, and the command may end before.
        threading.Thread(target=webbrowser.open, args=(address,), daemon=True).start()


def _has_screen() -> bool:
    """Return whether a browser can open a window; a browser in the terminal would disturb the output."""
    return sys.platform in {"darwin", "win32"} or any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY"))


def _summary(page: LivePage, seconds: float) -> str:
    rate = page.samples / max(seconds, 1e-9)
    text = f"{page.samples:,} samples in {seconds:.1f} s ({rate:,.0f} Hz), {page.lost:,} lost"
    return text + (f", {page.written:,} values written" if page.written else "")
