"""`unity-link get` and `unity-link set`: read and write signals by the names of a spec, in their units."""

from __future__ import annotations

import asyncio
import contextlib
import enum
import fnmatch
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from unity_link.cli.arguments import DEFAULT_TIMEOUT, Json, Timeout, Url
from unity_link.cli.completion import complete_signal
from unity_link.cli.output import print_json, print_line, print_parts
from unity_link.cli.running import run
from unity_link.cli.spec import SPEC_VARIABLE, Name, compile_or_exit, spec_behind
from unity_link.errors import ArgumentError, NotArmedError
from unity_link.protocol.wire.numbers import MOST_SECONDS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from unity_link.cores.lease import Lease
    from unity_link.data.loading import LoadedRobot
    from unity_link.data.proxies import Proxy
    from unity_link.link.link import Link
    from unity_link.spec.model import Signal

SUFFIX = ".ul"
_ADDRESS = re.compile("[0-9][0-9A-Fa-f]*")
_TRUTHS = {"true": True, "on": True, "yes": True, "1": True, "false": False, "off": False, "no": False, "0": False}


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command("get")(get)
    # A negative value looks like an option.
    app.command("set", context_settings={"ignore_unknown_options": True})(set_)


def get(
    url: Url,
    names: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[SPEC] [SIGNAL]...",
            help="A spec, such as robot.ul, and signals: j1.position, a part as j1, a pattern as '*.position'; "
            "without one, all readable signals except queues and signals that a read clears.",
            autocompletion=complete_signal,
        ),
    ] = None,
    *,
    values_only: Annotated[bool, typer.Option("--values", help="Print the values alone, one a line.")] = False,
    interface: Name = None,
    json: Json = False,
    timeout: Timeout = DEFAULT_TIMEOUT,
) -> None:
    """Read signals by name, in their units. All are read at once.

    Without a SPEC, the environment variable UNITY_LINK_SPEC names it. Under --json the values are those of the spec:
    numbers, true or false, and for an enumeration its names.
    """
    spec, signals = split(url, names or [])
    run(_get(url, robot_of(spec, interface), signals, values_only=values_only, json=json, timeout=timeout))


async def _get(
    url: str,
    robot_type: type[LoadedRobot],
    names: Sequence[str],
    *,
    values_only: bool,
    json: bool,
    timeout: float,
) -> None:
    from unity_link.data.describing import robot_behind
    from unity_link.data.groups import Group
    from unity_link.link.connecting import connect
    from unity_link.spec.model import Effect

    chosen = choose(robot_type, names, "read")
    async with connect(url, timeout=timeout) as link:
        robot = await robot_behind(link, robot_type)
        proxies: list[Any] = [robot[path] for path in chosen]
        together = [proxy for proxy in proxies if proxy.signal.effect is not Effect.CLEAR_ON_READ]
        read = await Group(*together).get() if together else {}
        values = {proxy: read[proxy] if proxy in read else await proxy.get() for proxy in proxies}
    if json:
        found = {proxy.path: plain(value) for proxy, value in values.items()}
        print_json({"url": url, "values": found, "units": {proxy.path: proxy.unit for proxy in values if proxy.unit}})
        return
    width = max(map(len, chosen))
    for proxy, value in values.items():
        if values_only:
            print_line(text(value))
        else:
            print_value(proxy, value, width)


def set_(
    url: Url,
    assignments: Annotated[
        list[str],
        typer.Argument(
            metavar="[SPEC] SIGNAL=VALUE...",
            help="A spec, such as robot.ul, and signals with values: j1.target=-1.5 mode=RUN, or 'j1.target=5 deg'.",
            autocompletion=complete_signal,
            show_default=False,
        ),
    ],
    *,
    arm: Annotated[
        float | None,
        typer.Option(
            "--arm",
            metavar="SECONDS",
            min=0.001,
            max=MOST_SECONDS,
            help="Arm the leases that guard the signals, and disarm them after this time, at Ctrl-C and at SIGTERM.",
            show_default=False,
        ),
    ] = None,
    interface: Name = None,
    json: Json = False,
    timeout: Timeout = DEFAULT_TIMEOUT,
) -> None:
    """Write signals by name, in their units and within their limits, in the order of the arguments.

    All values are checked before the first one is written. Without a SPEC, the environment variable UNITY_LINK_SPEC
    names it. A signal that a lease guards needs --arm; its outputs are safe again when the command ends.
    """
    spec, given = split(url, assignments)
    robot_type = robot_of(spec, interface)
    if not given:
        raise ArgumentError("no signal was given: SIGNAL=VALUE was expected, such as j1.target=-1.5")
    run(_set(url, robot_type, [_parse(robot_type, text) for text in given], arm=arm, json=json, timeout=timeout))


async def _set(
    url: str,
    robot_type: type[LoadedRobot],
    values: list[tuple[str, Any]],
    *,
    arm: float | None,
    json: bool,
    timeout: float,
) -> None:
    from unity_link.cores.lease import leases_of
    from unity_link.data.describing import robot_behind
    from unity_link.link.connecting import connect

    guards = [] if arm is None else _guards_of(robot_type, [path for path, _ in values])
    async with connect(url, timeout=timeout) as link, contextlib.AsyncExitStack() as block:
        robot = await robot_behind(link, robot_type)
        leases = [await block.enter_async_context(leases_of(robot)[path].armed()) for path in guards]
        written: dict[Proxy[Any], Any] = {}
        try:
            for path, value in values:
                await _kick(leases)
                proxy: Any = robot[path]
                await proxy.set(value)
                written[proxy] = proxy.decode(proxy.encode(value))
        except NotArmedError as error:
            if leases:
                raise
            raise NotArmedError(f"{error}; --arm SECONDS arms it", error.reason, error.instant) from None
        if json:
            print_json({"url": url, "values": {proxy.path: plain(value) for proxy, value in written.items()}})
        else:
            for proxy, value in written.items():
                print_value(proxy, value, max(len(proxy.path) for proxy in written))
        if arm is not None:
            await _hold(link, leases, arm)


def _guards_of(robot_type: type[LoadedRobot], paths: Sequence[str]) -> list[str]:
    """Return the paths of the leases that guard some signals, each once.

    Raises:
        ArgumentError: if no lease guards any of them.
    """
    safe = [robot_type.interface.signals[path].safe for path in paths]
    if not any(safe):
        raise ArgumentError(f"--arm arms the lease of a signal, and no lease guards {', '.join(dict.fromkeys(paths))}")
    return list(dict.fromkeys(one.lease for one in safe if one is not None))


async def _hold(link: Link, leases: Sequence[Lease], seconds: float) -> None:
    """Keep leases armed for some seconds, by a kick each third of the shortest time-out.

    Raises:
        NotArmedError: if a lease ended before.
    """
    loop = asyncio.get_running_loop()
    end = loop.time() + seconds
    every = min(lease.timeout for lease in leases) / 3
    while (left := end - loop.time()) > 0:
        await _kick(leases)
        await asyncio.sleep(min(every, left))
    # Each kick asks for the state, and the next kick checks the answer, which has arrived after the fence.
    await _kick(leases)
    await link.fence()
    await _kick(leases)


async def _kick(leases: Sequence[Lease]) -> None:
    for lease in leases:
        await lease.kick()


# Shared by the commands that take names of signals


def split(url: str, arguments: Sequence[str]) -> tuple[str, list[str]]:
    """Return the spec and the arguments after it.

    The spec is the first argument, otherwise that of the environment or of the URL, otherwise the URL itself: the board
    may carry its spec.

    Raises:
        ArgumentError: if URL and spec are swapped, or an argument is an address instead of a signal.
    """
    if arguments and is_spec(arguments[0]):
        return arguments[0], list(arguments[1:])
    named = os.environ.get(SPEC_VARIABLE) or spec_in(url)
    if named is None and arguments:
        spec_behind(url, arguments[0])
    if named is None and arguments and _ADDRESS.fullmatch(arguments[0]):
        raise ArgumentError(f"{arguments[0]} is no signal: an address is written 0x{arguments[0]}")
    return named or url, list(arguments)


def is_spec(argument: str) -> bool:
    """Return whether an argument is a spec instead of a signal."""
    return argument.endswith(SUFFIX) or argument == "-" or "/" in argument or Path(argument).is_file()


def spec_in(url: str) -> str | None:
    """Return the path of the spec in a URL such as sim:robot.ul; None if the URL has none."""
    path = url.partition(":")[2].partition("?")[0]
    return path if path.endswith(SUFFIX) else None


def robot_of(spec: str, interface: str | None) -> type[LoadedRobot]:
    """Return the robot class of a spec. If the spec has errors, print them and end the command."""
    from unity_link.data.loading import load

    return load(compile_or_exit(spec), interface)


def choose(robot_type: type[LoadedRobot], names: Sequence[str], what: str) -> list[str]:
    """Return the paths of the signals that the names match, each once, in the order of the names.

    Args:
        robot_type: class of the robot.
        names: paths, IDs, parts or patterns; empty for all signals except queues and signals that a read clears.
        what: required access: ``"read"`` or ``"write"``.

    Raises:
        ArgumentError: for a name that matches no signal, or no signal with this access.
    """
    able = {path: signal for path, signal in robot_type.interface.signals.items() if _can(signal, what)}
    chosen = [path for path, signal in able.items() if not signal.access_moves] if not names else []
    for name in names:
        found = _stand_for(robot_type, name)
        fitting = [path for path in found if path in able and (len(found) == 1 or not able[path].access_moves)]
        if not fitting:
            only = robot_type.interface.signals[found[0]].access
            raise ArgumentError(
                f"{found[0]} is a {only} signal, and cannot be {'written' if what == 'write' else what}"
            )
        chosen += fitting
    if not chosen:
        raise ArgumentError(f"{robot_type.interface.name} has no signal that can be {what}")
    return list(dict.fromkeys(chosen))


def _can(signal: Signal, what: str) -> bool:
    return signal.access.reads if what == "read" else signal.access.writes


def _stand_for(robot_type: type[LoadedRobot], name: str) -> list[str]:
    signals = robot_type.interface.signals
    found = [
        path
        for path, signal in signals.items()
        if name in (path, signal.id) or path.startswith((f"{name}.", f"{name}["))
    ]
    # Match brackets literally, as indices of arrays, not as character classes.
    found = found or [path for path in signals if fnmatch.fnmatchcase(path, name.replace("[", "[[]"))]
    if not found:
        from unity_link.spec.diagnostics import did_you_mean

        if group := next((one for one in robot_type.interface.groups if one.name == name), None):
            paths = ", ".join(group.signals)
            raise ArgumentError(f"{name!r} is a group of {robot_type.interface.name}: name its signals, {paths}")
        hint = did_you_mean(name, [*signals, *(signal.id for signal in signals.values())])
        raise ArgumentError(f"{robot_type.interface.name} has no signal {name!r}" + (f": {hint}" if hint else ""))
    return found


def _parse(robot_type: type[LoadedRobot], assignment: str) -> tuple[str, Any]:
    """Return the path and the checked value of an assignment.

    Raises:
        ArgumentError: if it is not an assignment, or the signal does not accept the value.
    """
    name, equals, value = assignment.partition("=")
    if not equals:
        raise ArgumentError(f"{assignment!r} is no SIGNAL=VALUE: write, for example, {assignment}=1")
    (path, *others) = choose(robot_type, [name.strip()], "write")
    if others:
        raise ArgumentError(f"{name!r} matches {len(others) + 1} signals: one was expected, such as {path}")
    signal = robot_type.interface.signals[path]
    parsed = _value(signal, value.strip())
    signal.encode(parsed)
    return path, parsed


def _value(signal: Signal, given: str) -> Any:
    """Parse the text of a value, which may end with the signal's unit."""
    # Try the text with its end first: 0x1A for a signal in A is a number, not 0x1 A.
    texts = [given]
    if signal.unit and given.endswith(signal.unit):
        texts.append(given.removesuffix(signal.unit).strip())
    for number in texts:
        if signal.kind.name == "bool" and number.lower() in _TRUTHS:
            return _TRUTHS[number.lower()]
        for read in (lambda text: int(text, 0), float):
            try:
                return read(number)
            except ValueError:
                continue
    if signal.kind.enumeration is not None:
        return given
    expected = f"a number in {signal.unit}" if signal.unit else "a number"
    raise ArgumentError(f"{signal.path}: {given!r} is no value of {signal.kind}: {expected} was expected")


def plain(value: Any) -> Any:
    """Return a value for JSON; for an enumeration its name."""
    return value.name if isinstance(value, enum.Enum) else value


def text(value: Any) -> str:
    """Format a value for display."""
    known = plain(value)
    if isinstance(known, bool):
        return "true" if known else "false"
    return f"{known:.9g}" if isinstance(known, float) else str(known)


def print_value(proxy: Proxy[Any], value: Any, width: int) -> None:
    """Print a line with the path of a signal, its value and its unit."""
    unit = f" {proxy.unit}" if proxy.unit else ""
    print_parts((f"{proxy.path:<{width}}", "cyan"), "  ", (text(value), "bold"), unit)
