"""Makes the manual page from the commands: `python -m unity_link.cli.manual > unity-link.1`.

It has the same texts as `--help`, so it is always up to date.
"""

from __future__ import annotations

import re
import sys
from typing import TYPE_CHECKING, Any

from typer.main import get_group

import unity_link
from unity_link.cli import app
from unity_link.cli.families import Commands

if TYPE_CHECKING:
    from collections.abc import Iterator

NAME = "unity-link"
_FILES = (
    ("~/.local/state/unity-link/urls", "URLs that were used with success, for completion"),
    (
        "/etc/udev/rules.d/70-ft232h.rules",
        "lets a user open an FT232H or FT2232H; unity-link doctor prints its contents",
    ),
)
_ENVIRONMENT = (
    ("UNITY_LINK_SPEC", "the spec of get, set and watch if none is given"),
    ("UNITY_LINK_SNOOP", "a file for the traffic of links whose URL names none"),
    ("UNITY_LINK_TOKEN", "the token of serve and live"),
    ("UNITY_LINK_MEMORY", "the file with the URLs for completion; empty for none"),
    ("NO_COLOR", "no colours"),
)
_EXITS = (
    ("0", "done"),
    ("1", "the operation failed, or doctor found something wrong; one sentence on standard error says why"),
    ("2", "wrong use: an unknown option or URL, a value that does not fit"),
    ("128+n", "ended by signal n, such as 130 by Ctrl-C"),
)


def page() -> str:
    """Return the manual page in man(7) format."""
    group: Any = get_group(app)
    context = group.make_context(NAME, [], resilient_parsing=True)
    assert isinstance(group, Commands)
    lines = [
        f'.TH UNITY-LINK 1 "" "unity-link {unity_link.__version__}" "User Commands"',
        ".SH NAME",
        f"{_escaped(NAME)} \\- connect to an FPGA: read, write and watch its bus",
        ".SH SYNOPSIS",
        f".B {_escaped(NAME)}",
        ".I COMMAND",
        "[\\fIOPTIONS\\fR]",
        ".SH DESCRIPTION",
        _text(group.help),
        ".PP",
        _text(group.epilog),
        ".SH OPTIONS",
        *_options(group, context),
        ".SH COMMANDS",
    ]
    for name in group.list_commands(context):
        lines += _command(group.get_command(context, name), name, context)
    for heading, rows in (("EXIT STATUS", _EXITS), ("ENVIRONMENT", _ENVIRONMENT), ("FILES", _FILES)):
        lines.append(f".SH {heading}")
        lines += [line for term, meaning in rows for line in (".TP", f".B {_escaped(term)}", _text(meaning))]
    return "\n".join(lines) + "\n"


def _command(command: Any, name: str, above: Any) -> Iterator[str]:
    context = command.context_class(command, info_name=name, parent=above, resilient_parsing=True)
    if hasattr(command, "list_commands"):
        for below in command.list_commands(context):
            yield from _command(command.get_command(context, below), f"{name} {below}", context)
        return
    arguments = [p.metavar or p.name for p in command.get_params(context) if p.param_type_name == "argument"]
    yield f".SS {_escaped(' '.join([name, *arguments, '[OPTIONS]']))}"
    yield _text(command.help)
    yield from _options(command, context)


def _options(command: Any, context: Any) -> Iterator[str]:
    for parameter in command.get_params(context):
        record = parameter.get_help_record(context)
        if record is not None and "--help" not in parameter.opts:
            term = parameter.metavar if parameter.param_type_name == "argument" else record[0]
            yield from (".TP", f".B {_escaped(term)}", _text(record[1]) or "\\&")


def _text(text: str | None) -> str:
    """Return a text with its paragraphs as man(7) paragraphs."""
    paragraphs = re.split(r"\n\s*\n", (text or "").strip())
    return "\n.PP\n".join(_escaped(" ".join(paragraph.split())) for paragraph in paragraphs)


def _escaped(text: str) -> str:
    safe = text.replace("\\", "\\e").replace("-", "\\-")
    return f"\\&{safe}" if safe[:1] in {".", "'"} else safe


if __name__ == "__main__":
    sys.stdout.write(page())
