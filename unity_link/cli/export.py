"""`unity-link export`: converts a spec or a recording. `export rdl SPEC`, `export RECORDING --parquet`.

If the first argument is not the name of a format, it is a recording: the most frequent export needs the fewest words.
"""

from __future__ import annotations

from typing import Any

import typer
from typer.core import TyperGroup

from unity_link.cli.recording import export_recording
from unity_link.cli.spec import export_rdl

_RECORDING = "recording"


class _Export(TyperGroup):
    """The group of the formats."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Treat a first argument that is not the name of a format as a recording."""
        if args and args[0] not in self.commands and args[0] not in ctx.help_option_names:
            args = [_RECORDING, *args]
        return super().parse_args(ctx, args)


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    exporting = typer.Typer(
        cls=_Export,
        help="Convert a recording to tables (export RECORDING --parquet or --csv), or a spec to SystemRDL.",
        no_args_is_help=True,
    )
    exporting.command("rdl")(export_rdl)
    exporting.command(_RECORDING)(export_recording)
    app.add_typer(exporting, name="export")
