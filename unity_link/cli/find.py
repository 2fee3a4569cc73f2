"""`unity-link find`: lists the boards on the network, and assigns addresses to them."""

from __future__ import annotations

import socket
from collections import defaultdict
from typing import TYPE_CHECKING, Annotated

import typer

from unity_link.cli.arguments import Json
from unity_link.cli.output import print_json, print_note, print_parts
from unity_link.cli.running import run
from unity_link.errors import ArgumentError, ConnectError
from unity_link.protocol.wire.discovery import DEFAULT_PORT, parse_ip, parse_mac

if TYPE_CHECKING:
    from unity_link.transport.finding import FoundBoard

_MOST_NAMED = 4
"""Most boards of one address that a note names."""
_EXAMPLE = "02:55:4c:00:00:01=192.168.1.101"


def add_to(app: typer.Typer) -> None:
    """Add the command of this file."""
    app.command("find")(find)


def find(
    where: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="ADDRESS",
            help="Where to search: the broadcast address of a network, such as 192.168.1.255, or one machine. All "
            "networks of this machine, and itself, without.",
            show_default=False,
        ),
    ] = None,
    *,
    assign: Annotated[
        list[str] | None,
        typer.Option(
            metavar="MAC=ADDRESS", help=f"Give a board an address until its reset: {_EXAMPLE}. May be repeated."
        ),
    ] = None,
    port: Annotated[
        int, typer.Option(metavar="PORT", min=1, max=65535, help="The UDP port of the boards.")
    ] = DEFAULT_PORT,
    wait: Annotated[
        float, typer.Option(metavar="SECONDS", min=0.01, max=60.0, help="How long answers may take.")
    ] = 1.0,
    json: Json = False,
) -> None:
    """List the boards with an Ethernet port that answer on the network.

    Prints for each its URL, MAC address, name and the fingerprint of its map, and whether a program has opened a
    session with it since its reset. Boards with the same address are reported.
    """
    wanted = _wanted(assign or [])
    run(_find(where or [], port, wanted, patience=wait, json=json))


def _wanted(texts: list[str]) -> dict[bytes, bytes]:
    """Return the addresses to assign, by MAC."""
    wanted: dict[bytes, bytes] = {}
    for text in texts:
        mac, equals, address = text.partition("=")
        if not equals:
            raise ArgumentError(f"--assign {text}: MAC=ADDRESS was expected, such as {_EXAMPLE}")
        try:
            known, ip = parse_mac(mac), parse_ip(address)
        except ArgumentError as error:
            raise ArgumentError(f"--assign {text}: {error}") from None
        if known in wanted or ip in wanted.values():
            raise ArgumentError(f"--assign {text}: each board and each address can be named once")
        wanted[known] = ip
    return wanted


async def _find(places: list[str], port: int, wanted: dict[bytes, bytes], *, patience: float, json: bool) -> None:
    from unity_link.transport.finding import find

    boards = await find(places, port, patience=patience)
    if wanted:
        addresses = {mac: socket.inet_ntoa(ip) for mac, ip in wanted.items()}
        for mac, address in addresses.items():
            _check_free(boards, mac, address)
        for mac, ip in wanted.items():
            await find(places, port, patience=patience, mac=mac, ip=ip)
        # Search again: this shows which boards accepted an address, and whether other boards have the same one.
        boards = await find(places, port, patience=patience)
        for mac, address in addresses.items():
            _check_free(boards, mac, address)
        boards = [_taken(boards, mac, address, port) for mac, address in addresses.items()]
    if not boards:
        raise ConnectError(
            f"no board has answered at port {port}: is a board on the network, and does a firewall drop its packets? "
            "With rp_filter 1, Linux drops packets from addresses that are in none of its networks; --assign gives a "
            "board an address in one of them"
        )
    if json:
        for board in boards:
            print_json(_fields(board))
    else:
        _print(boards)
    for note in _notes(boards):
        print_note(note)


def _check_free(boards: list[FoundBoard], mac: bytes, address: str) -> None:
    """Check that an address can be assigned.

    Raises:
        ConnectError: if another board has it, or several boards have the MAC.
    """
    meant = [board for board in boards if board.found.mac == mac]
    if any(board.doubled for board in meant) or len({board.found.name for board in meant}) > 1:
        raise ConnectError(f"two boards have the MAC address {mac.hex(':')}: build one of them with another")
    for board in boards:
        if board.address == address and board.found.mac != mac:
            raise ConnectError(f"{address} is the address of {_called(board)} already: give another one")


def _taken(boards: list[FoundBoard], mac: bytes, address: str, port: int) -> FoundBoard:
    """Return the board that accepted an address.

    Raises:
        ConnectError: if no board did.
    """
    meant = [board for board in boards if board.found.mac == mac]
    if not meant:
        raise ConnectError(f"no board with the MAC address {mac.hex(':')} has answered at port {port}")
    for board in meant:
        if board.address == address:
            return board
    raise ConnectError(f"{_called(meant[0])} has answered, but its address is still {meant[0].address}")


def _called(board: FoundBoard) -> str:
    return f"{board.mac} ({board.found.name})" if board.found.name else board.mac


def _fields(board: FoundBoard) -> dict[str, object]:
    found = board.found
    return {
        "url": board.url,
        "address": board.address,
        "port": board.port,
        "mac": board.mac,
        "name": found.name,
        "build_id": found.build_id,
        "has_fingerprint": found.has_fingerprint,
        "session_open": found.session_open,
    }


def _print(boards: list[FoundBoard]) -> None:
    rows = [
        (
            board.url,
            board.mac,
            board.found.name or "-",
            f"{'map' if board.found.has_fingerprint else 'build'} 0x{board.found.build_id:08X}",
            "session open" if board.found.session_open else "no session",
        )
        for board in boards
    ]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for url, *rest in rows:
        texts = [f"{text:<{width}}" for text, width in zip(rest, widths[1:], strict=True)]
        print_parts((f"{url:<{widths[0]}}", "bold"), "  ", "  ".join(texts).rstrip())


def _notes(boards: list[FoundBoard]) -> list[str]:
    """Return notes on boards that share a MAC or IP address."""
    by_address, by_mac = defaultdict(list), defaultdict(list)
    for board in boards:
        by_address[board.address].append(board)
        by_mac[board.mac].append(board)
    notes = []
    for mac, those in by_mac.items():
        if any(board.doubled for board in those) or len({board.found.name for board in those}) > 1:
            notes.append(f"two boards have the MAC address {mac}: build one of them with another")
    for address, those in by_address.items():
        if len({board.mac for board in those}) > 1:
            names = " and ".join(map(_called, those[:_MOST_NAMED]))
            if len(those) > _MOST_NAMED:
                names += f" and {len(those) - _MOST_NAMED} more"
            notes.append(
                f"{address} is the address of {names}: give each another one, by unity-link find --assign MAC=ADDRESS"
            )
    return notes
