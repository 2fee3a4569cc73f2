"""Export: writes an interface as one flat address map."""

from __future__ import annotations

import itertools
import re
from graphlib import TopologicalSorter
from typing import TYPE_CHECKING

from unity_link.errors import UnsupportedError
from unity_link.files import MARK
from unity_link.spec.model import Access, Effect, GroupSpec, Interface, Joint, ModuleSpec, Signal

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

from unity_link.spec.systemrdl.naming import doc_lines, unique_name, values_text

_FIELD_PROPERTIES = ("id", "kind", "values", "unit", "arguments")
_EFFECTS = {
    Effect.CLEAR_ON_READ: ("stickybit", "onread = rclr"),
    Effect.WRITE_1_TO_CLEAR: ("stickybit", "onwrite = woclr"),
    Effect.PULSE: ("singlepulse", "reset = 0"),
}
_SW = {Access.READ: ("r", "w"), Access.WRITE: ("w", "r"), Access.READWRITE: ("rw", "r")}
_KEYWORDS = frozenset(
    """abstract accesstype addressingtype addrmap alias all alternate bit boolean bothedge byte compact component
    componentwidth constraint default encode enum external false field fullalign hw inside int internal level
    longint mem na negedge nonsticky number onreadtype onwritetype posedge precedencetype property r rclr real
    ref reg regalign regfile rset ruser rw rw1 shortint shortreal signal signed string struct sw this true type
    unsigned w w1 wclr with within woclr woset wot wr wset wuser wzc wzs wzt""".split()  # noqa: SIM905  (a line for each word would be a page)
)
"""Keywords of SystemRDL 2.0; as a name, a keyword is written with a backslash."""


def export_text(interface: Interface) -> str:
    """Return an interface as SystemRDL.

    Raises:
        UnsupportedError: if SystemRDL does not support the width of its words, or it has neither signals nor memories.
    """
    bits = interface.data_bits
    if bits & (bits - 1):
        raise UnsupportedError(f"SystemRDL knows registers of 8, 16, 32 or 64 bits, and {interface.name} has {bits}")
    memories = list(_memories(interface))
    if not interface.signals and not memories:
        message = "SystemRDL knows no map without registers and memories"
        raise UnsupportedError(f"{message}, and {interface.name} has neither signals nor MEMORY with a SIZE")
    words: dict[int, list[Signal]] = {}
    for signal in interface.signals.values():
        for address in signal.addresses:
            words.setdefault(address, []).append(signal)
    lines = [
        f"// {MARK} export rdl`: the interface {interface.name} of a UL-spec.",
        "property ul_path { component = field | mem; type = string; };",
        *(f"property ul_{name} {{ component = field; type = string; }};" for name in _FIELD_PROPERTIES),
        "property ul_order { component = field; type = longint unsigned; };",
        "property ul_groups { component = addrmap; type = string; };",
        "property ul_address_bits { component = addrmap; type = longint unsigned; };",
        "",
    ]
    for enumeration in interface.enumerations:
        lines.append(f"enum {_identifier(enumeration.name, '_e')} {{")
        for value in enumeration.values:
            desc = f" {{ desc = {_string(value.doc)}; }}" if value.doc else ""
            lines.append(f"  {_identifier(value.name)} = {value.value}{desc};")
        lines += ["};", ""]
    lines.append(f"addrmap {_identifier(interface.name)} {{")
    lines += [f"  desc = {_string(interface.doc)};"] if interface.doc else []
    lines += [f"  default regwidth = {bits};", f"  default accesswidth = {bits};"]
    lines.append(f"  ul_address_bits = {interface.address_bits};")
    groups = "\n".join(doc_lines(group.doc) + _group(group) for group in interface.groups)
    lines += [f"  ul_groups = {_string(groups)};"] if groups else []
    registers: set[str] = set()
    order = {path: place for place, path in enumerate(_in_order(interface))}
    for address in sorted(words):
        lines += _register(address, words[address], bits, registers, order)
    for memory in memories:
        lines += _memory(memory, bits, registers)
    return "\n".join([*lines, "};", ""])


def _memories(interface: Interface) -> Iterator[ModuleSpec]:
    """Yield the memories of known size that contain no signals and no modules."""
    taken = {address for signal in interface.signals.values() for address in signal.addresses}
    around = {module.parent for module in interface.modules}
    for index, module in enumerate(interface.modules):
        if module.type != "MEMORY" or not module.words or index in around:
            continue
        if not any(module.base <= address < module.base + module.words for address in taken):
            yield module


def _memory(memory: ModuleSpec, bits: int, names: set[str]) -> Iterator[str]:
    path = memory.path or f"memory_{memory.base:x}"
    yield "  external mem {"
    yield from [f"    desc = {_string(memory.doc)};"] if memory.doc else []
    yield f"    mementries = {memory.words}; memwidth = {bits}; sw = rw; ul_path = {_string(path)};"
    yield f"  }} {unique_name(_identifier(path), names)} @ {memory.base * bits // 8:#x};"


def _in_order(interface: Interface) -> list[str]:
    """Return the paths of the signals of groups in one order that agrees with the order in each group.

    The signals of a component are adjacent, because a spec declares a component in one place.
    """
    before: dict[str, dict[str, None]] = {}
    rows = [*(group.signals for group in interface.groups), [group.signals[0] for group in interface.groups]]
    for row in rows:
        for one, other in itertools.pairwise(row):
            # Compare the two members of a common component at which the paths differ.
            levels = zip(_levels(one), _levels(other), strict=False)
            for first, second in levels:
                if first != second:
                    before.setdefault(second, {})[first] = None
                    break
    places = {member: place for place, member in enumerate(TopologicalSorter(before).static_order())}
    paths = dict.fromkeys(path for group in interface.groups for path in group.signals)
    return sorted(paths, key=lambda path: [places.get(level, 0) for level in _levels(path)])


def _levels(path: str) -> list[str]:
    """Return the paths of a signal and of the components around it, the outermost first."""
    return list(itertools.accumulate(path.split("."), "{}.{}".format))


def _register(
    address: int, signals: list[Signal], bits: int, registers: set[str], order: Mapping[str, int]
) -> Iterator[str]:
    fields: set[str] = set()
    yield "  reg {"
    for signal in signals:
        part = address - signal.address
        low = signal.lowest_bit if part == 0 else 0
        high = min(signal.lowest_bit + signal.width - part * bits, bits) - 1
        software, hardware = _SW[signal.access]
        yield "    field {"
        yield f"      sw = {software}; hw = {'w' if signal.has_events else hardware};"
        if signal.effect is not None:
            yield from (f"      {name};" for name in _EFFECTS[signal.effect])
        if reset := signal.reset >> max(part * bits - signal.lowest_bit, 0) & (1 << high - low + 1) - 1:
            yield f"      reset = {reset:#x};"
        yield from (f"      {name} = {value};" for name, value in _properties(signal, part))
        if part == 0 and signal.path in order:
            yield f"      ul_order = {order[signal.path]};"
        name = unique_name(_identifier(signal.path, f"_part{part}" if part else ""), fields)
        yield f"    }} {name}[{high}:{low}];"
    is_one = len(signals) == 1 and signals[0].words == 1
    name = unique_name(_identifier(signals[0].path) if is_one else f"word_{address:x}", registers)
    yield f"  }} {name} @ {address * bits // 8:#x};"


def _properties(signal: Signal, part: int) -> Iterator[tuple[str, str]]:
    if signal.doc:
        yield "desc", _string(signal.doc)
    if part:
        return
    enumeration = signal.kind.enumeration
    if enumeration is not None and signal.words == 1:
        yield "encode", _identifier(enumeration.name, "_e")
    yield "ul_path", _string(signal.path)
    yield "ul_id", _string(signal.id)
    yield "ul_kind", _string(str(signal.kind))
    if enumeration is not None and signal.words > 1:
        # A field of one word is too narrow for the values, so `encode` cannot be used.
        yield "ul_values", _string(values_text((one.name, one.value, one.doc) for one in enumeration.values))
    if signal.unit:
        yield "ul_unit", _string(signal.unit)
    arguments = ", ".join(_arguments(signal))
    if arguments:
        yield "ul_arguments", _string(arguments)


def _arguments(signal: Signal) -> Iterator[str]:
    """Yield the arguments of a signal that are not strings."""
    if signal.kind.scale != 1:
        yield f"SCALE={_number(signal.kind.scale)}"
    if signal.kind.offset != 0:
        yield f"OFFSET={_number(signal.kind.offset)}"
    if signal.minimum is not None:
        yield f"MIN={_number(signal.minimum)}"
    if signal.maximum is not None:
        yield f"MAX={_number(signal.maximum)}"
    if signal.reset and signal.safe is None:
        yield f"RESET={_value(signal)}"
    if signal.fifo:
        yield "FIFO" if signal.fifo_words is None else f"FIFO({signal.fifo_words})"
    if signal.effect is not None:
        yield f"EFFECT={signal.effect}"
    if signal.poll_hz is not None:
        yield f"POLL({_number(signal.poll_hz)})"
    if signal.group is not None:
        yield f"PUBLISH({signal.group})"
    yield from (f"GROUP({group})" for group in signal.groups if group != signal.group)


def _value(signal: Signal) -> str:
    """Return the value of a signal after a reset in the syntax of a spec."""
    value = signal.kind.decode(signal.reset)
    if isinstance(value, bool):
        return str(value).lower()
    return _number(int(value) if isinstance(value, int) else value)


def _group(group: GroupSpec) -> str:
    joints: dict[str, str] = {}
    for joint in group.joints:
        for part in Joint.__struct_fields__[1:]:
            path: str | None = getattr(joint, part)
            if path is not None:
                joints[part.upper()] = path.rpartition(".")[2]
    arguments = [
        f"NUMBER={group.number}" if group.number is not None else "",
        f"DIVISOR={group.divisor}" if group.divisor is not None else "",
        f"RATE={_number(group.rate_hz)}" if group.rate_hz is not None else "",
        *(name.upper() for name in ("trigger", "on_change", "immediate", "timestamps") if getattr(group, name)),
        f"JOINTS({', '.join(f'{part}={name}' for part, name in joints.items())})" if joints else "",
        *_sensors(group),
    ]
    return f"group {group.name}({', '.join(filter(None, arguments))});"


def _sensors(group: GroupSpec) -> Iterator[str]:
    """Yield the clauses for the sensors of a group, one for each word."""
    for word in dict.fromkeys(sensor.word for sensor in group.sensors):
        sensors = [sensor for sensor in group.sensors if sensor.word == word]
        parts = {part: paths[0] for sensor in sensors for part, paths in sensor.signals.items()}
        clause = [f"{part}={path.rpartition('.')[2].partition('[')[0]}" for part, path in parts.items()]
        if sensors[0].field_of_view:
            clause.append(f"FIELD_OF_VIEW={_number(sensors[0].field_of_view)}")
        yield f"{word}({', '.join([*clause, *(['INFRARED'] if sensors[0].infrared else [])])})"


def _number(value: float) -> str:
    """Format a number so that reading it gives the same number."""
    return repr(value)


def _identifier(path: str, suffix: str = "") -> str:
    name = re.sub(r"\W", "_", path.replace("]", "")) + suffix
    return f"\\{name}" if name in _KEYWORDS else name


def _string(text: str) -> str:
    # A control character would end the string.
    text = "".join(character for character in text if character >= " " or character in "\n\t")
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
