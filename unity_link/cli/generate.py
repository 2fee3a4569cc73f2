"""`unity-link generate TARGET SPEC`: generates clients in other languages, gateware and documents from a spec."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated

import typer

from unity_link.cli.arguments import Json, Overwrite
from unity_link.cli.output import may_overwrite, print_note, print_result
from unity_link.cli.spec import Given, Name, SpecFile, compile_or_exit
from unity_link.errors import ArgumentError
from unity_link.generate import TargetName


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(generate)


def generate(
    target: Annotated[TargetName, typer.Argument(metavar="TARGET", help="What to make.", show_default=False)],
    spec: SpecFile,
    *,
    output: Annotated[
        Path, typer.Option("--output", "-o", metavar="DIR", help="Where to write; created if it does not exist.")
    ] = Path(),
    interface: Name = None,
    given: Given = None,
    maintainer: Annotated[
        str | None,
        typer.Option(metavar="'NAME <EMAIL>'", help="For a ROS package: its maintainer.", show_default=False),
    ] = None,
    licence: Annotated[
        str | None, typer.Option(metavar="NAME", help="For a ROS package: its licence.", show_default=False)
    ] = None,
    clock_hz: Annotated[
        int | None,
        typer.Option("--clock-hz", metavar="HZ", help="For verilog: of clk; 50000000 if not said.", show_default=False),
    ] = None,
    baud: Annotated[
        int | None,
        typer.Option(
            "--baud", metavar="RATE", help="For verilog: of the UART; 1000000 if not said.", show_default=False
        ),
    ] = None,
    unchecked: Annotated[
        bool,
        typer.Option(
            "--unchecked", help="For verilog: do not compare VHDL of cores of your own with what GHDL makes of it."
        ),
    ] = False,
    with_gateware: Annotated[
        bool,
        typer.Option(
            "--with-gateware", help="For vhdl: add the gateware and a script for each tool, so the folder is whole."
        ),
    ] = False,
    overwrite: Overwrite = False,
    json: Json = False,
) -> None:
    """Generate code from a spec: typed proxies, clients in C, C++ and MATLAB, VHDL, ROS packages, documents."""
    from unity_link.generate import generate as make
    from unity_link.generate import write

    if with_gateware and target != "vhdl":
        raise ArgumentError(f"--with-gateware belongs to vhdl, and {target} was asked for")
    given_options = {"licence": licence, "clock_hz": clock_hz, "baud": baud, "unchecked": unchecked or None}
    options = {name: value for name, value in given_options.items() if value is not None}
    if maintainer is not None:
        found = re.fullmatch(r"\s*([^<>]*[^<>\s])\s*<([^<>@\s]+@[^<>@\s]+)>\s*", maintainer)
        if found is None:
            raise ArgumentError(
                f"--maintainer {maintainer!r}: a name and an address were expected, as 'Ada <ada@lab.org>'"
            )
        options |= {"maintainer": found[1], "email": found[2]}
    compiled = compile_or_exit(spec, interface=interface, given=given)
    if clock_hz is not None:
        compiled.interface(interface).check_clock(clock_hz)
    files = make(target, compiled, interface, **options)
    if with_gateware:
        from unity_link.generate.vhdl.folder import with_gateware as complete

        files = list(complete(files, map(Path, compiled.vhdl)))
    for path in write(files, output, overwrite=may_overwrite(overwrite)):
        print_result("file", path, json=json)
    if target == "vhdl":
        from unity_link.generate.vhdl import left_open

        if note := left_open(compiled.interface(interface)):
            print_note(f"no ..._on_uart and the like: {note}")
