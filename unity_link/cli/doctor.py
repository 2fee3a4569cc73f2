"""`unity-link doctor`: finds slow or wrong settings, and gives advice."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from unity_link.cli.arguments import Json, Timeout
from unity_link.cli.output import print_json, print_note, print_parts
from unity_link.cli.running import run
from unity_link.cli.spec import Name, compile_or_exit
from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from unity_link.doctor import Finding
    from unity_link.spec.model import Interface

WRONG = 1
_WIDTH = 12
_ANSWER_WITHIN = 2.5
_MEASURED = 1.0


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(doctor)


def doctor(
    url: Annotated[
        str | None, typer.Argument(metavar="[URL]", help="Where the gateway is; without it, this computer alone.")
    ] = None,
    spec: Annotated[
        Path | None, typer.Argument(metavar="[SPEC]", help="The spec that programs use for the gateway.")
    ] = None,
    *,
    interface: Name = None,
    json: Json = False,
    timeout: Timeout = _ANSWER_WITHIN,
    duration: Annotated[
        float,
        typer.Option("--duration", metavar="SECONDS", min=0.001, help="How long pauses of this computer are measured."),
    ] = _MEASURED,
) -> None:
    """Find slow or wrong settings of this computer, the port, the line and the gateway, and give advice.

    Nothing on the gateway's bus is read or written, except that the spec of the board is read if SPEC is a different
    one. Exits with 1 if something is wrong. Under --json each finding is an object: "check", "text", and if
    something is wrong its name as "fault", and "advice".
    """
    expected: Interface | None = None
    if spec is not None:
        expected = compile_or_exit(spec).interface(interface)
    elif interface is not None:
        raise ArgumentError("--interface goes with a SPEC alone")
    faults: list[Finding] = []
    run(_doctor(url, expected, timeout, duration, faults, json=json))
    if faults:
        raise typer.Exit(WRONG)


async def _doctor(
    url: str | None,
    interface: Interface | None,
    timeout: float,
    duration: float,
    faults: list[Finding],
    *,
    json: bool,
) -> None:
    from unity_link.doctor import examine

    async for finding in examine(url, interface, timeout=timeout, duration=duration):
        if finding.fault is not None:
            faults.append(finding)
        if json:
            print_json(finding)
        else:
            _print(finding)
    print_note(f"wrong: {', '.join(dict.fromkeys(f.fault or '' for f in faults))}" if faults else "nothing is wrong")


def _print(finding: Finding) -> None:
    mark = ("ok     ", "green") if finding.fault is None else ("WRONG  ", "bold red")
    name = "" if finding.fault is None else f"{finding.fault}: "
    print_parts(mark, (f"{finding.check:<{_WIDTH}}", "cyan"), "  ", (name, "bold"), finding.text)
    if finding.advice:
        print_parts(" " * (7 + _WIDTH), "  ", ("do: ", "bold"), finding.advice)
