"""`unity-link read` and `unity-link write`: words by address."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from unity_link.cli.arguments import DEFAULT_TIMEOUT, Address, Json, Timeout, Url, number
from unity_link.cli.output import print_json, print_line, print_parts
from unity_link.cli.running import run
from unity_link.cli.words import to_word
from unity_link.protocol.wire.numbers import Format, address_text, as_decimal, in_form, to_signed

if TYPE_CHECKING:
    from unity_link.protocol.wire.configuration import GatewayInfo


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(read)
    # A negative value looks like an option.
    app.command(context_settings={"ignore_unknown_options": True})(write)


def read(
    url: Url,
    address: Address,
    count: Annotated[int | None, typer.Argument(metavar="[COUNT]", parser=number, help="Number of words.")] = None,
    *,
    form: Annotated[
        Format | None, typer.Option("--format", help="Print the values alone, one a line, in this form.")
    ] = None,
    json: Json = False,
    timeout: Timeout = DEFAULT_TIMEOUT,
) -> None:
    """Read words from an address on, each with its address.

    Under --json, --format signed gives numbers in two's complement; the other forms give them unsigned.
    """
    run(_read(url, address, 1 if count is None else count, form=form, json=json, timeout=timeout))


async def _read(
    url: str,
    address: int,
    count: int,
    *,
    form: Format | None,
    json: bool,
    timeout: float,
) -> None:
    from unity_link.link.connecting import connect

    async with connect(url, timeout=timeout) as link:
        words = (await link.read_block(address, count)).tolist() if count != 1 else [await link.read(address)]
        bits = link.gateway.data_bits
    if json:
        values = [to_signed(word, bits) for word in words] if form is Format.SIGNED else words
        print_json({"url": url, "address": address, "values": values})
    elif form is not None:
        print_line("\n".join(in_form(word, bits, form) for word in words))
    else:
        _print_words(address, words, link.gateway)


def write(
    url: Url,
    address: Address,
    values: Annotated[
        list[int],
        typer.Argument(metavar="VALUE...", parser=number, help="What to write, -1 for example.", show_default=False),
    ],
    *,
    json: Json = False,
    timeout: Timeout = DEFAULT_TIMEOUT,
) -> None:
    """Write words from an address on. A negative value is written in two's complement."""
    run(_write(url, address, values, json=json, timeout=timeout))


async def _write(
    url: str,
    address: int,
    values: list[int],
    *,
    json: bool,
    timeout: float,
) -> None:
    from unity_link.link.connecting import connect

    async with connect(url, timeout=timeout) as link:
        words = [to_word(value, link.gateway.data_bits) for value in values]
        if len(words) == 1:
            await link.write(address, words[0])
        else:
            await link.write_block(address, words)
    if json:
        print_json({"url": url, "address": address, "values": words})
    else:
        _print_words(address, words, link.gateway)


def _print_words(first: int, words: list[int], gateway: GatewayInfo) -> None:
    bits = gateway.data_bits
    for offset, word in enumerate(words):
        address, text = address_text(first + offset, gateway), in_form(word, bits, Format.HEX)
        print_parts((address, "cyan"), "  ", (text, "bold"), "  ", as_decimal(word, bits))
