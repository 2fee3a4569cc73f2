"""`unity-link build SPEC --board NAME`: makes a bitstream from a spec, and programs the board."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import msgspec
import typer

from unity_link.cli.arguments import Json, Overwrite
from unity_link.cli.completion import complete_board
from unity_link.cli.output import may_overwrite, print_note, print_result
from unity_link.cli.spec import Name, SpecFile, compile_or_exit
from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from unity_link.boards.board import Board


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(build)


def build(
    spec: SpecFile,
    *,
    board: Annotated[
        str,
        typer.Option(
            "--board",
            metavar="NAME",
            help="The board: a name, or a file NAME.toml.",
            autocompletion=complete_board,
            show_default=False,
        ),
    ],
    output: Annotated[
        Path, typer.Option("--output", "-o", metavar="DIR", help="Where to write; created if it does not exist.")
    ] = Path(),
    program: Annotated[
        bool, typer.Option("--program", help="Then program the board with it, by openFPGALoader.")
    ] = False,
    top: Annotated[
        Path | None,
        typer.Option(
            "--top",
            metavar="FILE.vhd",
            help="VHDL of your own, an entity of this name, around NAME_gateway of the spec.",
        ),
    ] = None,
    vhdl: Annotated[
        list[Path] | None,
        typer.Option(
            "--vhdl",
            metavar="FILE.vhd",
            help="Other files that the top needs, or entities of the spec; may be repeated, in compile order.",
        ),
    ] = None,
    unchecked: Annotated[
        bool,
        typer.Option(
            "--unchecked", help="Do not compare your VHDL with what GHDL makes of it, if that cannot be done."
        ),
    ] = False,
    mac: Annotated[
        str | None,
        typer.Option(metavar="MAC", help="Of an Ethernet port: its MAC address, such as 02:55:4c:00:00:02."),
    ] = None,
    ip: Annotated[
        str | None, typer.Option(metavar="ADDRESS", help="Of an Ethernet port: its IP address after a reset.")
    ] = None,
    interface: Name = None,
    overwrite: Overwrite = False,
    json: Json = False,
) -> None:
    """Build a bitstream from a spec: gateway, registers and cores at the pins of a board.

    Signals that neither a core nor a pin uses are connected to a chain of shift registers at four further pins.
    With --top, VHDL of your own is at the pins: its ports have the names of the board's LEDs, buttons and headers.
    Prints the bitstream and its report of size, speed and pins. Takes a minute or two. Needs pip install
    "unity-link[build]", and GHDL 4 or later. For a board that needs Vivado or Quartus it writes a project, and prints
    the file to open.
    """
    from unity_link.boards.build import build as make
    from unity_link.boards.build import loader
    from unity_link.boards.build import program as put
    from unity_link.boards.loading import load_board
    from unity_link.boards.projects import VENDORS, make_project
    from unity_link.gateware.own_vhdl import read_own

    name, chosen = load_board(board)
    chosen = _addressed(name, chosen, mac, ip)
    compiled = compile_or_exit(spec)
    files = [*map(Path, compiled.vhdl), *(vhdl or [])]
    own = read_own(top, files)._replace(unchecked=unchecked) if files or top is not None else None
    replaces = may_overwrite(overwrite)
    vendor = VENDORS.get(chosen.family)
    if vendor is not None:
        if program:
            raise ArgumentError(f"--program needs a bitstream, and that of {name} is made by {vendor.tool}")
        opened = make_project(compiled, name, chosen, output, interface, own=own, overwrite=replaces, note=_warn)
        print_result("file", opened, json=json)
        print_note(f"for {vendor.tool}: {vendor.opens} {opened}")
        return
    if program:
        loader()
    built = make(compiled, name, chosen, output, interface, own=own, overwrite=replaces, note=_warn)
    for path in built:
        print_result("file", path, json=json)
    if program:
        put(chosen, built.bitstream)
        print_note(f"{chosen.title} is programmed")


def _addressed(name: str, board: Board, mac: str | None, ip: str | None) -> Board:
    """Return a board with the given addresses of its Ethernet port."""
    from unity_link.gateware.limits import ETHERNET
    from unity_link.protocol.wire.discovery import parse_ip, parse_mac

    given = {"mac": mac, "ip": ip}
    for key, parse in (("mac", parse_mac), ("ip", parse_ip)):
        text = given[key]
        if text is None:
            continue
        if board.medium not in ETHERNET:
            raise ArgumentError(f"--{key} is for a board with an Ethernet port, and {name} has {board.medium}")
        try:
            parse(text)
        except ArgumentError as error:
            raise ArgumentError(f"--{key}: {error}") from None
    return msgspec.structs.replace(board, **{key: text for key, text in given.items() if text is not None})


def _warn(remark: str) -> None:
    print_note(f"warning: {remark}")
