"""`unity-link stop`: disarms the leases of a spec, whichever program armed them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from unity_link.cli.arguments import DEFAULT_TIMEOUT, Json, Timeout, Url
from unity_link.cli.completion import complete_signal
from unity_link.cli.output import print_json, print_line, print_note
from unity_link.cli.running import run
from unity_link.cli.signals import is_spec, robot_of, split
from unity_link.cli.spec import Name
from unity_link.errors import ArgumentError, UnityLinkError
from unity_link.transport import is_url

if TYPE_CHECKING:
    from unity_link.data.loading import LoadedRobot
    from unity_link.link.link import Link


def add_to(app: typer.Typer) -> None:
    """Add the command of this file."""
    app.command("stop")(stop)


def stop(
    url: Url,
    spec: Annotated[
        str | None,
        typer.Argument(metavar="[SPEC]", help="A spec, such as robot.ul.", autocompletion=complete_signal),
    ] = None,
    *,
    interface: Name = None,
    json: Json = False,
    timeout: Timeout = DEFAULT_TIMEOUT,
) -> None:
    """Disarm all leases of a spec, whichever program armed them: their outputs are safe when the command returns.

    Without a SPEC, the environment variable UNITY_LINK_SPEC names it. URL and SPEC may be given in either order.
    """
    if spec is not None and not is_url(url) and is_url(spec):
        url, spec = spec, url
    if spec is not None and not is_spec(spec):
        raise ArgumentError(f"{spec!r} is no spec: the path of one was expected, such as robot.ul")
    path, _ = split(url, [] if spec is None else [spec])
    robot_type = robot_of(path, interface)
    run(_stop(url, robot_type, json=json, timeout=timeout))


async def _stop(
    url: str,
    robot_type: type[LoadedRobot],
    *,
    json: bool,
    timeout: float,
) -> None:
    from unity_link.cores.lease import LeasedRobot, leases_of
    from unity_link.link.connecting import connect

    if not issubclass(robot_type, LeasedRobot):
        name = robot_type.interface.name
        raise ArgumentError(f"{name} has no lease to disarm: its spec places no LEASE")
    found: dict[str, bool] = {}
    failed: UnityLinkError | None = None
    async with connect(url, timeout=timeout) as link:
        for path, lease in leases_of(await _robot_to_stop(link, robot_type)).items():
            try:
                found[path] = await lease.stop()
            except UnityLinkError as error:
                # Continue with the other leases, so that they do not stay armed.
                failed = failed or error
    if json:
        print_json({"url": url, "leases": {path: {"was_armed": was_armed} for path, was_armed in found.items()}})
    else:
        for path, was_armed in found.items():
            print_line(f"{path}: disarmed" if was_armed else f"{path}: was not armed")
    if failed is not None:
        raise failed


async def _robot_to_stop(link: Link, robot_type: type[LoadedRobot]) -> LoadedRobot:
    """Return the robot of a spec; if the board has another spec, that of the board, because a stop must not fail."""
    from unity_link.data.describing import robot_behind
    from unity_link.errors import SpecMismatchError

    try:
        return await robot_behind(link, robot_type)
    except SpecMismatchError as error:
        if not error.differences:
            raise
        print_note(f"{error.differences[0]}: the leases are those of the board's own spec")
        return await robot_behind(link)
