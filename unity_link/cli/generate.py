"""`unity-link generate TARGET SPEC`: clients in other languages, gateware and documents from a spec."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from unity_link.cli.output import print_line
from unity_link.cli.spec import Given, Name, SpecFile, compile_or_exit
from unity_link.generate import TargetName  # noqa: TC001  (typer reads the annotations)


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(generate)


def generate(
    target: Annotated[TargetName, typer.Argument(metavar="TARGET", help="What to make.", show_default=False)],
    spec: SpecFile,
    *,
    output: Annotated[
        Path, typer.Option("--output", "-o", metavar="DIR", help="Where to write; made where it is not there.")
    ] = Path(),
    interface: Name = None,
    given: Given = None,
) -> None:
    """Generate code from a spec: typed proxies, clients in C, C++ and MATLAB, VHDL, packages of ROS, documents."""
    from unity_link.generate import generate as make
    from unity_link.generate import write

    for path in write(make(target, compile_or_exit(spec, interface=interface, given=given), interface), output):
        print_line(str(path))
