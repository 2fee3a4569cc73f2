"""Arguments and options that several commands share."""

from __future__ import annotations

import math
from typing import Annotated

import typer

from unity_link.cli.completion import complete_url, note
from unity_link.cli.words import parse_number
from unity_link.errors import ArgumentError
from unity_link.protocol.wire.numbers import MOST_SECONDS


def number(text: str) -> int:
    """Parse a number of the command line."""
    try:
        return parse_number(text)
    except ValueError as error:
        raise typer.BadParameter(str(error)) from None


Url = Annotated[
    str,
    typer.Argument(
        metavar="URL",
        help="Where the gateway is, such as sim:scara.",
        autocompletion=complete_url,
        callback=note,
        show_default=False,
    ),
]
Address = Annotated[
    int, typer.Argument(metavar="ADDRESS", parser=number, help="Word address, such as 0x88.", show_default=False)
]
Timeout = Annotated[
    float,
    typer.Option(
        "--timeout", metavar="SECONDS", min=0.001, max=MOST_SECONDS, help="How long the gateway may take to connect."
    ),
]
Json = Annotated[bool, typer.Option("--json", help="Print JSON for programs, one object a line.")]
Overwrite = Annotated[bool, typer.Option("--overwrite", help="Replace files that Unity-Link did not make.")]
DEFAULT_TIMEOUT = 5.0


def check_poll(hertz: float | None) -> None:
    """Check the rate of ``--poll``.

    Raises:
        ArgumentError: if it is not a finite number above 0.
    """
    if hertz is not None and not 0 < hertz < math.inf:
        raise ArgumentError(f"--poll {hertz:g}: more than 0 Hz was expected")
