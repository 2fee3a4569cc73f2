"""MATLAB: a class of an interface and the package that it uses, for MATLAB from R2020b and GNU Octave from 7.

- ``scara.m``, from `interface.m`: a class with the signals as nested structs, so that programs write
  ``robot.legs(2).coxa.cpos.get()``; arrays begin at 1, as is usual in MATLAB
- ``+unity_link/``, from the folder `runtime`: the link, its subscriptions, and the methods of signals. Only the first
  lines depend on the spec
- ``+unity_link/source/``: the client in C (target ``c``), which does the work, and the MEX file that calls it, from the
  folder `source`; `unity_link.build` compiles them into one file, ``unity_link_mex``
- ``unity_link_mex.m``: raises an error that asks for `unity_link.build`, until the MEX file exists

The code uses only features that both languages have: no ``enumeration`` blocks, no `arguments` blocks, no string
objects, and no extensions of Octave. The package avoids name conflicts with the user's functions.
"""

from __future__ import annotations

import hashlib
import math
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from unity_link.errors import UnsupportedError
from unity_link.generate import GeneratedFile, c
from unity_link.generate.c.layout import GUARD_REGISTERS
from unity_link.generate.matlab.names import FUNCTIONS, MEMBERS, identifiers
from unity_link.network.memories import given_parameters, networks
from unity_link.quoting import matlab_string, one_line
from unity_link.spec import ComponentArray, Effect

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from unity_link.generate import Templates
    from unity_link.spec import ComponentSpec, GroupSpec, Interface, Signal

DOC = "MATLAB and GNU Octave: a class with the signals, and the package that it stands on"
PACKAGE = "unity_link"
MEX = "unity_link_mex"
_RUNTIME = Path(__file__).with_name("runtime")
_SOURCE = Path(__file__).with_name("source")
_LINE_LENGTH = 116
_FLAGS = {False: "false", True: "true"}
_EXACT = 1 << 53
"""Doubles hold all integers up to this one."""


class ConstructorLine(NamedTuple):
    """An assignment in the constructor: to a path in the tree of structs."""

    path: str
    signal: Signal | None
    """Signal at the path; None for a component without signals of its own."""
    copies: int = 1
    """Number of such components in an array."""


class Property(NamedTuple):
    """A property of the generated class."""

    name: str
    doc: str


def files(interface: Interface, templates: Templates) -> Iterator[GeneratedFile]:
    """Yield the class of an interface, and the package."""
    name = identifiers([interface.name], [PACKAGE, MEX, *MEMBERS, *FUNCTIONS])[interface.name]
    lines = list(_lines(interface.root, "", [*MEMBERS, name]))
    paths = {line.signal.path: line.path for line in lines if line.signal is not None}
    given = identifiers(given_parameters(interface))
    # In an example, a variable with the name of the class would hide the class.
    variable = "robot" if name != "robot" else "arm"
    text = templates.render(
        "interface.m",
        interface=interface,
        class_name=name,
        properties=_properties(interface.root, [*MEMBERS, name]),
        lines=lines,
        paths=paths,
        groups=_groups(interface),
        networks=networks(interface),
        guards=[_guard(interface, lease, paths) for lease in interface.leases],
        given=list(given.values()),
        handle=lambda address: _handle(address, given),
        ranges=_ranges,
        variable=variable,
        examples=_examples(lines, variable),
        arguments=_arguments,
        settings=_settings,
        call=_call,
    )
    yield GeneratedFile(f"{name}.m", text)
    yield GeneratedFile(f"{MEX}.m", templates.render(f"{MEX}.m"))
    built_from = _fingerprint()
    for folder, place in ((_RUNTIME, f"+{PACKAGE}"), (_SOURCE, f"+{PACKAGE}/source")):
        for template in sorted(folder.glob("*.jinja")):
            text = templates.render(f"{folder.name}/{template.stem}", fingerprint=built_from, **c.RUNTIME_VALUES)
            yield GeneratedFile(f"{place}/{template.stem}", text)
    client = templates.of("c", c.FILTERS)
    for source in c.RUNTIME:
        yield GeneratedFile(f"+{PACKAGE}/source/{source}", client.render(source, **c.RUNTIME_VALUES))


def _fingerprint() -> str:
    """Return a hash of the C sources, which shows whether a MEX file was built from them; independent of the spec."""
    digest = hashlib.sha256(repr(c.RUNTIME_VALUES).encode())
    folder = Path(c.__file__).parent
    paths = [*folder.glob("unity_link*.jinja"), *folder.glob("runtime/*.c"), *_SOURCE.glob("*.jinja")]
    for path in sorted(paths):
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def _members(part: ComponentSpec) -> list[str]:
    return [*part.rows, *(member.name for member in part.parts)]


def _properties(root: ComponentSpec, taken: list[str]) -> list[Property]:
    names = identifiers(_members(root), taken)
    members = (*(row[0] for row in root.rows.values()), *root.parts)
    return [Property(names[member.name], _comment(member.doc)) for member in members]


def _lines(part: ComponentSpec, path: str, taken: list[str] | None = None) -> Iterator[ConstructorLine]:
    """Yield the constructor lines of a component at a path, which is empty for the root."""
    names = identifiers(_members(part), taken or ())
    before = f"{path}." if path else ""
    for signal in part.signals:
        # Use a cell array, because Octave has no arrays of objects.
        index = "" if signal.index is None else f"{{{signal.index + 1}}}"
        yield ConstructorLine(before + names[signal.name] + index, signal)
    for member in part.parts:
        inside = before + names[member.name]
        items = member.items if isinstance(member, ComponentArray) else (member,)
        if not _members(items[0]):
            yield ConstructorLine(inside, None, len(items))
        for number, item in enumerate(items, 1):
            yield from _lines(item, f"{inside}({number})" if isinstance(member, ComponentArray) else inside)


def _guard(interface: Interface, lease: str, paths: Mapping[str, str]) -> list[str]:
    """Return the arguments of `Guard` for a lease."""
    found = {name: interface.signals[f"{lease}.{name}"] for name in GUARD_REGISTERS}
    registers = [f"'{name}', [{one.address} {one.lowest_bit} {one.width}]" for name, one in found.items()]
    addresses = sorted({address for signal in interface.refused_by(lease) for address in signal.addresses})
    path = paths[f"{lease}.state"].rpartition(".")[0]
    return [matlab_string(path), str(interface.data_bits), _ranges(addresses), *registers]


def _handle(address: int | str | None, given: Mapping[str, str]) -> str:
    """Return the expression for CTRL or COMM: an address, or a parameter of the constructor."""
    if isinstance(address, str):
        return f"given.{given[address]}"
    return "[]" if address is None else str(address)


def _ranges(addresses: Iterable[int]) -> str:
    """Return ascending addresses as an array expression, consecutive ones as a range."""
    runs: list[list[int]] = []
    for address in addresses:
        if runs and address == runs[-1][-1] + 1:
            runs[-1].append(address)
        else:
            runs.append([address])
    texts = [str(run[0]) if len(run) == 1 else f"{run[0]}:{run[-1]}" for run in runs]
    rows = [" ".join(texts[first : first + 8]) for first in range(0, len(texts), 8)]
    return "[" + " ...\n                ".join(rows) + "]"


def _groups(interface: Interface) -> list[tuple[GroupSpec, str]]:
    groups = [group for group in interface.groups if group.signals]
    names = identifiers(group.name for group in groups)
    return [(group, names[group.name]) for group in groups]


def _examples(lines: list[ConstructorLine], variable: str) -> list[str]:
    """Return statements that read and write the first suitable signals."""
    signals = [(line.path, line.signal.access) for line in lines if line.signal is not None]
    read = next((f"value = {variable}.{path}.get();" for path, access in signals if access.reads), None)
    written = next((f"{variable}.{path}.set(0);" for path, access in signals if access.writes), None)
    return [example for example in (read, written) if example]


def _call(beginning: str, arguments: list[str]) -> str:
    """Return a call, wrapped to the length of a line."""
    lines = [beginning]
    for number_, argument in enumerate(arguments):
        piece = argument + (");" if number_ == len(arguments) - 1 else ",")
        if len(lines[-1]) + len(piece) > _LINE_LENGTH and number_:
            lines.append("        ")
        lines[-1] += piece if lines[-1].endswith(("(", "        ")) else f" {piece}"
    return " ...\n".join(lines)


def _settings(group: GroupSpec) -> list[str]:
    """Return the settings of a group's publishing as arguments of `struct`."""
    given: dict[str, str] = {
        "group": _optional(group.number),
        "rate_hz": _optional(group.rate_hz),
        "divisor": _optional(group.divisor),
        "trigger": _FLAGS[group.trigger],
        "on_change": _FLAGS[group.on_change],
        "immediate": _FLAGS[group.immediate],
    }
    if group.timestamps:
        given["timestamps"] = _FLAGS[True]
    return [f"'{name}', {value}" for name, value in given.items()]


def _optional(value: float | None) -> str:
    return "[]" if value is None else number(value)


def _arguments(line: ConstructorLine) -> list[str]:
    """Return the arguments of `Signal`: path, address, kind, width and access, then pairs of a name and a value."""
    signal = line.signal
    assert signal is not None
    kind, access = matlab_string(str(signal.kind)), matlab_string(signal.access.value)
    place = [matlab_string(line.path), str(signal.address), kind, str(signal.width), access]
    return [*place, *(f"'{name}', {value}" for name, value in _options(signal))]


def _options(signal: Signal) -> list[tuple[str, str]]:
    kind = signal.kind
    given = [
        ("id", matlab_string(signal.id), signal.id != signal.path),
        ("lowest_bit", number(signal.lowest_bit), signal.lowest_bit),
        ("scaled", "true", kind.is_scaled),
        ("step", number(kind.step), kind.is_scaled),
        ("offset", number(kind.offset), kind.offset),
        ("unit", matlab_string(signal.unit), signal.unit),
        ("minimum", number(signal.minimum or 0), signal.minimum is not None),
        ("maximum", number(signal.maximum or 0), signal.maximum is not None),
        ("is_field", "true", signal.is_field),
        ("fifo", "true", signal.fifo),
        ("cleared", "true", signal.effect is Effect.CLEAR_ON_READ),
    ]
    if kind.enumeration is not None:
        values = kind.enumeration.values
        given.append(("labels", f"{{{', '.join(matlab_string(value.name) for value in values)}}}", True))
        given.append(("numbers", f"[{' '.join(_numbers([value.value for value in values]))}]", True))
    return [(name, expression) for name, expression, is_given in given if is_given]


def _numbers(values: list[int]) -> list[str]:
    """Return literals of one type: uint64 if a double cannot hold one of the numbers."""
    if max(values) < _EXACT:
        return [number(value) for value in values]
    return [_wide(value, "uint64") for value in values]


def _wide(value: int, kind: str) -> str:
    """Return an expression for a number of 64 bits that a double cannot hold, made of two halves."""
    return f"typecast(uint32([{value & 0xFFFFFFFF} {value >> 32 & 0xFFFFFFFF}]), '{kind}')"


def number(value: float) -> str:
    """Return a literal that MATLAB reads as exactly this number."""
    if isinstance(value, int) and abs(value) >= _EXACT:
        return _wide(value, "uint64" if value > 0 else "int64")
    if not math.isfinite(value):
        raise UnsupportedError(f"{value} is no number that MATLAB code can have here")
    return repr(value)


def _comment(text: str) -> str:
    """Return a doc string in one line."""
    return one_line(" ".join(text.split()))


FILTERS = {"comment": _comment}
