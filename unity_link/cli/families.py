"""The commands of `unity-link`, each imported only when it is used: `read` does not wait for the imports of `live`.

A family is a module with commands, which its ``add_to`` adds to an app. `PANELS` lists the commands of each family:
one family is imported to run a command, and all of them to show the help.
"""

from __future__ import annotations

import functools
import importlib
from typing import TYPE_CHECKING, Any

import typer
from typer.core import TyperGroup
from typer.main import get_group

if TYPE_CHECKING:
    from collections.abc import Callable

MARKUP: Any = "markdown"
"""Markup of help texts; "rich" would interpret the brackets of unity-link[zenoh] as markup."""
PANELS = {
    "Robots": {
        "demo": "demo",
        "example": "example",
        "get": "signals",
        "set": "signals",
        "stop": "stop",
        "watch": "watch",
        "live": "live",
    },
    "Gateways and boards": {
        "info": "info",
        "doctor": "doctor",
        "find": "find",
        "read": "access",
        "write": "access",
        "terminal": "terminal",
        "ft232h": "ft232h",
    },
    "Simulation, sharing and bridges": {
        "simulate": "simulate",
        "serve": "serve",
        "ros1": "ros",
        "ros2": "ros",
        "zenoh": "zenoh",
    },
    "Recordings and snoops": {
        "record": "recording",
        "replay": "recording",
        "export": "export",
        "explain": "snoop",
        "retrace": "snoop",
    },
    "Specs and gateware": {
        "check": "spec",
        "fmt": "spec",
        "show": "spec",
        "import": "spec",
        "generate": "generate",
        "build": "build",
        "gateware": "gateware",
    },
}
"""The panels of the help, and for each the commands with their families, in the order of the help."""
FAMILIES = {name: family for commands in PANELS.values() for name, family in commands.items()}
"""The family of each command."""


class Commands(TyperGroup):
    """The group of all commands. Before a command is used, typer has only its name."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(**settings)
        self.commands: Any = dict.fromkeys(FAMILIES)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        """Return a command, created at its first use; None for an unknown name."""
        if cmd_name in FAMILIES and self.commands[cmd_name] is None:
            made = _commands_of(FAMILIES[cmd_name])
            for name, command in made.items():
                _convert_sparingly(command, ctx)
                command.rich_help_panel = next(panel for panel, commands in PANELS.items() if name in commands)
            self.commands |= made
        return super().get_command(ctx, cmd_name)

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Parse the options before the command."""
        _convert_sparingly(self, ctx)
        return super().parse_args(ctx, args)


def _commands_of(family: str) -> dict[str, Any]:
    """Import a family and return its commands by name."""
    app = typer.Typer(rich_markup_mode=MARKUP)
    importlib.import_module(f"unity_link.cli.{family}").add_to(app)
    return {**get_group(app).commands}


def _convert_sparingly(command: Any, ctx: Any) -> None:
    """Create typer's converters only for values that need them.

    They are from pydantic, whose import takes a third of the time of a read. typer requests one even if there is
    nothing to convert: for a missing option, or for text. If a later version of typer uses other attributes, this
    function has no effect.
    """
    for parameter in command.get_params(ctx):
        parameter.get_runtime_param = functools.partial(_Converter, parameter.get_runtime_param)


class _Converter:
    """Converts a value of a parameter like typer, but loads typer's converter only if it is needed."""

    def __init__(self, usual: Callable[[], Any]) -> None:
        self._usual = usual

    def coerce(self, value: Any, param: Any, ctx: Any) -> Any:
        """Return a value converted for the command."""
        kind, parse = param.type_descriptor.annotation, param.type_descriptor.parameter_info.parser
        several = param.multiple or param.nargs != 1
        if not several and (value is None or (kind is str and isinstance(value, str))):
            return value
        if isinstance(value, float) and value is param.default:
            return value
        if parse is not None and isinstance(value, str):
            return parse(value)
        if parse is not None and several and value is not None:
            return [parse(text) for text in value]
        return self._usual().coerce(value, param=param, ctx=ctx)
