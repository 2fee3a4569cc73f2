"""`unity-link ft232h`: find FT232H and FT2232H chips, and make their pins a FIFO."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from unity_link.cli.arguments import Json
from unity_link.cli.output import is_confirmed, out, print_json, print_note
from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.transport.ft232h.chip import OpenChip

_SCHEMES = ("ftdi", "ftdi-async")
ChipUrl = Annotated[
    str,
    typer.Argument(
        metavar="URL",
        help="The chip, such as ftdi://ftdi:232h/1, or ftdi://ftdi:2232h/2 for port B of an FT2232H.",
        show_default=False,
    ),
]


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    commands = typer.Typer(help="Find FT232H and FT2232H chips, and make their pins a FIFO.", no_args_is_help=True)
    commands.command()(info)
    commands.command()(configure)
    app.add_typer(commands, name="ft232h")


@contextmanager
def _opened(url: str) -> Iterator[OpenChip]:
    from unity_link.transport import parse_url
    from unity_link.transport.ft232h.chip import open_chip

    parsed = parse_url(url)
    if parsed.scheme not in _SCHEMES:
        raise ArgumentError(f"{url} is no URL of an FTDI chip: ftdi://ftdi:232h/1 or ftdi://ftdi:2232h/1 was expected")
    chip = open_chip(parsed, check=False)
    try:
        yield chip
    finally:
        chip.close()


def info(
    url: Annotated[str | None, typer.Argument(metavar="[URL]", help="The chip; without it, all are listed.")] = None,
    *,
    json: Json = False,
) -> None:
    """List the connected chips, or show the EEPROM content of one."""
    if url is None:
        _list(json=json)
        return
    import msgspec

    from unity_link.transport.ft232h.eeprom import read_info
    from unity_link.transport.ft232h.kinds import port_letter

    with _opened(url) as chip:
        content = read_info(chip)
    if json:
        print_json({"url": url, **msgspec.structs.asdict(content)})
        return
    console = out()
    console.print(url, style="bold")
    rows = {
        "chip": content.chip,
        "port": port_letter(content.port),
        "pins": content.channel_type,
        "EEPROM": content.description,
        "manufacturer": content.manufacturer,
        "product": content.product,
        "serial number": content.serial or "none",
    }
    for name, text in rows.items():
        console.print(f"{name:<14}  {text}")


def _list(*, json: bool) -> None:
    from unity_link.transport.ft232h.chip import list_chips

    chips = list_chips()
    for url, description in chips:
        if json:
            print_json({"url": url, "description": description})
        else:
            out().print(f"{url}  {description}")
    if not chips:
        print_note("no FT232H and no FT2232H is plugged in")


def configure(
    url: ChipUrl,
    *,
    mode: Annotated[Literal["fifo", "uart"], typer.Option(help="Function of the pins: FT245 FIFO, or UART.")],
    yes: Annotated[bool, typer.Option("--yes", help="Write without asking.")] = False,
) -> None:
    """Write the function of a port's pins into the chip's EEPROM."""
    from unity_link.transport.ft232h.eeprom import read_info, write_channel_type

    kind: Literal["FIFO", "UART"] = "FIFO" if mode == "fifo" else "UART"
    with _opened(url) as chip:
        before = read_info(chip)
        if before.is_valid and before.channel_type == kind:
            print_note(f"nothing to do: {before.description}")
            return
        print_note(before.description)
        if not before.is_valid:
            print_note("It will be written anew, with a serial number of its own.")
        if not yes and not is_confirmed(f"Make the pins a {kind}?"):
            print_note("Nothing was written.")
            raise typer.Exit(1)
        write_channel_type(chip, kind)
        after = read_info(chip)
    print_note(f"Written: {after.description}. Unplug it and plug it in again for that to take effect.")
