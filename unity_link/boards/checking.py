"""Checks of a board's file; each fault is reported as a sentence.

The strings of the file are copied into files and options of other programs. They may therefore contain only characters
without a special meaning to these programs.
"""

from __future__ import annotations

import re
import typing
from typing import TYPE_CHECKING, Any, Literal

import msgspec

from unity_link.boards.board import PINS
from unity_link.errors import did_you_mean

if TYPE_CHECKING:
    from unity_link.boards.board import Board

_LONGEST_SHOWN = 60
_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]*")
_PART = re.compile(r"[A-Za-z0-9][A-Za-z0-9/-]*")
_SITE = re.compile(r"[A-Za-z0-9_]+")
_IO_TYPE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")
_IO_TYPE_OF_QUARTUS = re.compile(r"[A-Za-z0-9][A-Za-z0-9. _-]*")
_DEVICES = {
    "ice40": ["lp384", "lp1k", "lp4k", "lp8k", "hx1k", "hx4k", "hx8k", "up3k", "up5k", "u1k", "u2k", "u4k"],
    "ecp5": ["12k", "25k", "45k", "85k", "um-25k", "um-45k", "um-85k", "um5g-25k", "um5g-45k", "um5g-85k"],
}
"""Devices, as the options of a family's nextpnr name them."""
_SPEEDS = (6, 7, 8)
_PORT = re.compile(r"[a-z](?:_?[a-z0-9])*")
_OF_A_TOP = ("clk_ready", "core_clk", "ready", "design", "pll")
"""Names that a board's top uses for other things than pins."""
_ONLY_UP = ("ice40", "cyclonev")
"""Families whose pins have no pull-down resistors."""
_LOADER_VALUES = frozenset(
    {"-b", "--board", "-c", "--cable", "-d", "--device", "--busdev-num", "--freq", "--ftdi-channel", "--ftdi-serial"}
    | {"--fpga-part", "--index-chain", "--ip", "--pid", "--port", "--vid"}
)
_LOADER_FLAGS = frozenset(
    {"-f", "--write-flash", "-m", "--write-sram", "-r", "--reset", "--external-flash", "--invert-read-edge"}
    | {"--unprotect-flash", "--verify", "-v", "--verbose"}
)
"""Options of openFPGALoader that choose a board and a connection to it; other options could read or write files."""
_LOADER_VALUE = re.compile(r"[A-Za-z0-9_/][A-Za-z0-9_./:-]*")


def misuse(data: dict[str, object], kind: type[msgspec.Struct], before: str = "") -> str:
    """Return a sentence about the first entry of a table that does not fit a structure; empty if all entries fit.

    Args:
        data: the table.
        kind: the structure.
        before: prefix of the keys in the sentence, such as ``clock.``.
    """
    hints = typing.get_type_hints(kind)
    for key, value in data.items():
        if key not in hints:
            hint = did_you_mean(key, list(hints))
            return f"there is no key {shown(before + key)}" + (f"; {hint}" if hint else "")
        if fault := _misfit(f"{before}{key}", value, hints[key]):
            return fault
    for field in msgspec.structs.fields(kind):
        if field.required and field.name not in data:
            return f"{before}{field.name} is missing, {_expected(hints[field.name])} was expected"
    return ""


def _misfit(key: str, value: object, hint: Any) -> str:
    try:
        msgspec.convert(value, hint)
    except msgspec.ValidationError:
        return _about(key, value, hint)
    return ""


def _about(key: str, value: object, hint: Any) -> str:
    """Return a sentence about a value that does not have the expected type."""
    if isinstance(value, dict):
        if isinstance(hint, type) and issubclass(hint, msgspec.Struct):
            return misuse(value, hint, f"{key}.")
        if typing.get_origin(hint) is dict:
            _, inner = typing.get_args(hint)
            return next(filter(None, (_misfit(f"{key}.{name}", one, inner) for name, one in value.items())))
    return f"{key} is {shown(value)}, {_expected(hint)} was expected"


def _expected(hint: Any) -> str:
    if typing.get_origin(hint) is Literal:
        return f"one of {', '.join(typing.get_args(hint))}"
    if hint in (int, int | None):
        return "a whole number"
    if hint == str | None:
        return "a text"
    return {str: "a text", tuple: "a list of texts"}.get(typing.get_origin(hint) or hint, "a table")


def shown(value: object) -> str:
    """Return a value for a message, shortened if it is long."""
    text = repr(value)
    return text if len(text) <= _LONGEST_SHOWN else f"{text[:_LONGEST_SHOWN]}...{text[-1]}"


def name_fault(name: str) -> str:
    """Return a sentence about the fault of a board's name, which becomes part of file names; empty if it has none."""
    if _NAME.fullmatch(name):
        return ""
    return f"its name is {shown(name)}, letters, digits, '_', '-' and '.' were expected, as projects are named after it"


def spelling_fault(board: Board) -> str:
    """Return a sentence about the first string of a board that is unsafe for other programs; empty if all are safe."""
    return next(filter(None, _spelling_faults(board)), "")


def _spelling_faults(board: Board) -> typing.Iterator[str]:
    devices = _DEVICES.get(board.family)
    if devices is not None and board.device not in devices:
        hint = did_you_mean(board.device, devices)
        yield (
            f"device is {shown(board.device)}, one of {', '.join(devices)} was expected" + (f"; {hint}" if hint else "")
        )
    yield _unless(_PART, "device", board.device, "letters, digits, '-' and '/'")
    yield _unless(_PART, "package", board.package, "letters, digits, '-' and '/'")
    if board.family == "ecp5" and board.speed not in _SPEEDS:
        yield f"speed is {board.speed}, one of {', '.join(map(str, _SPEEDS))} was expected"
    pattern = _IO_TYPE_OF_QUARTUS if board.family == "cyclonev" else _IO_TYPE
    yield _unless(pattern, "io_type", board.io_type, "a name such as LVCMOS33")
    for pin, site in board.pins.items():
        yield _unless(_SITE, f"pins.{pin}", site, "letters, digits and '_'")
    for name, io in board.io.items():
        for site in io.named(name).values():
            yield _unless(_SITE, f"io.{name}", site, "letters, digits and '_'")
        yield _unless(pattern, f"io.{name}.io_type", io.io_type or board.io_type, "a name such as LVCMOS33")
    yield _loader_fault(board.programmer)


def io_fault(board: Board) -> str:
    """Return a sentence about the first invalid entry of a board's `io`; empty if all are valid."""
    return next(filter(None, _io_faults(board)), "")


def _io_faults(board: Board) -> typing.Iterator[str]:
    names: list[str] = []
    for name, io in board.io.items():
        if not _PORT.fullmatch(name):
            yield f"io has {shown(name)}, a name of small letters, digits and '_', as VHDL has them, was expected"
        if io.site is None and not io.sites:
            yield f"io.{name} is {{}}, site or sites was expected"
        if io.site is not None and io.sites:
            yield f"io.{name} has site and sites, one of both was expected"
        if io.first < 0:
            yield f"io.{name}.first is {io.first}, 0 or more was expected"
        if io.pull == "down" and board.family in _ONLY_UP:
            yield f"io.{name}.pull is 'down', and an {board.device} pulls up alone"
        names += [name, *io.named(name)]
    taken = {*PINS[board.medium], *(pin.partition("[")[0] for pin in PINS[board.medium]), *_OF_A_TOP}
    yield from (f"io.{name} is a pin or a port of each design already" for name in names if name in taken)
    pins = [pin for name, io in board.io.items() for pin in io.named(name)]
    yield from (f"io has {pin} twice" for pin in pins if pins.count(pin) > 1)


def _unless(pattern: re.Pattern[str], key: str, value: str, expected: str) -> str:
    return "" if pattern.fullmatch(value) else f"{key} is {shown(value)}, {expected} were expected"


def _loader_fault(options: tuple[str, ...]) -> str:
    left = list(options)
    while left:
        option, equals, value = left.pop(0).partition("=")
        if option in _LOADER_VALUES:
            value = value if equals else left.pop(0) if left else ""
            if not _LOADER_VALUE.fullmatch(value):
                return f"programmer has {option} with {shown(value)}, a name or a number was expected"
        elif option not in _LOADER_FLAGS or equals:
            return (
                f"programmer has {shown(option)}, options that choose a board and a cable were expected, such as "
                "--board and --cable"
            )
    return ""
