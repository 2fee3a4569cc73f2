"""The commands of `unity-link`, each made when it is asked for: `read` does not wait for what only `live` needs.

A family is a file of commands, which its ``add_to`` adds to an app. `PANELS` lists the commands of each family, so that
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
"""Markup of help texts; "rich" would take the brackets of unity-link[zenoh] for its own."""
PANELS = {
    "Robots": {
        "demo": "demo",
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
"""The panels of the help, and in each the commands with their families, in the order of the help."""
FAMILIES = {name: family for commands in PANELS.values() for name, family in commands.items()}
"""The family of each command."""


class Commands(TyperGroup):
    """The group of all commands. Until a command is asked for, typer has its name alone."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(**settings)
        self.commands: Any = dict.fromkeys(FAMILIES)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        """Return a command, and make it where it is asked for the first time; None for a name that there is not."""
        if cmd_name in FAMILIES and self.commands[cmd_name] is None:
            made = _commands_of(FAMILIES[cmd_name])
            for name, command in made.items():
                _convert_sparingly(command, ctx)
                command.rich_help_panel = next(panel for panel, commands in PANELS.items() if name in commands)
            self.commands |= made
        return super().get_command(ctx, cmd_name)

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Take the options before the command."""
        _convert_sparingly(self, ctx)
        return super().parse_args(ctx, args)


def _commands_of(family: str) -> dict[str, Any]:
    """Import a family, and return its commands."""
    app = typer.Typer(rich_markup_mode=MARKUP)
    importlib.import_module(f"unity_link.cli.{family}").add_to(app)
    return {**get_group(app).commands}


def _convert_sparingly(command: Any, ctx: Any) -> None:
    """Make typer's converters only for values that need them.

    They are pydantic's, whose import takes a third of the time of a read, and typer asks for one also where there is
    nothing to convert: for an option that was not given, for text. Should a version of it ask in another way, this
    changes nothing.
    """
    for parameter in command.get_params(ctx):
        parameter.get_runtime_param = functools.partial(_Converter, parameter.get_runtime_param)


class _Converter:
    """Converts a value of a parameter as typer does: what is nothing to convert by itself, the rest by typer's own."""

    def __init__(self, usual: Callable[[], Any]) -> None:
        self._usual = usual

    def coerce(self, value: Any, param: Any, ctx: Any) -> Any:
        """Return a value as the command is to have it."""
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
