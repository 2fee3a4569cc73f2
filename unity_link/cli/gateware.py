"""`unity-link gateware`: copies the VHDL of this package."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from unity_link.cli.arguments import Json, Overwrite
from unity_link.cli.output import may_overwrite, print_result


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    commands = typer.Typer(help="Use the gateware's VHDL in a design of your own.", no_args_is_help=True)
    # With a single command, typer would leave out its name, unless there is a callback.
    commands.callback()(lambda: None)
    commands.command()(copy)
    app.add_typer(commands, name="gateware")


def copy(
    folder: Annotated[
        Path,
        typer.Argument(
            metavar="DIR", help="Where to write: a new or empty folder, or an earlier copy.", show_default=False
        ),
    ],
    *,
    overwrite: Overwrite = False,
    json: Json = False,
) -> None:
    """Copy the gateware: VHDL in the library unity_link, pads and constraints of vendors, a script for each tool."""
    from unity_link.gateware.sources import copy_gateware

    print_result("folder", copy_gateware(folder, overwrite=may_overwrite(overwrite)), json=json)
