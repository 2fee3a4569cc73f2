"""Target ``cpp``: a client in C++17, as headers that use the client in C.

The class of an interface has its signals as members at their paths, ``robot.legs[2].coxa.cpos``. The type of a member
depends on the signal's value and access. The files of the target ``c`` are generated too, as C.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.generate import GeneratedFile, Templates
from unity_link.generate.c import FILTERS as C_FILTERS
from unity_link.generate.c import files as c_files
from unity_link.generate.c.layout import Layout, PartMember
from unity_link.generate.c.signals import describe
from unity_link.quoting import c_comment

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate.c.layout import GroupMember, GroupType, PartType, SignalMember
    from unity_link.spec import Interface

DOC = "a client in C++17, over the one in C: RAII, exceptions, typed signals"
_SIGNALS = {"READ": "Readable", "WRITE": "Writable", "READWRITE": "ReadWritable"}


def files(interface: Interface, templates: Templates) -> Iterator[GeneratedFile]:
    """Yield the headers of an interface, and the C files that they use."""
    layout = Layout(interface)
    groups = [(layout.group_names[group.group.name], group) for group in layout.groups]
    text = templates.render(
        "interface.hpp",
        layout=layout,
        robot=layout.class_name,
        variable=_variable(layout),
        groups=groups,
        root_initializers=[
            *initializers(layout.root, f"::{layout.prefix}"),
            *(f"{name}(the_link)" for name, _ in groups),
        ],
        networks=layout.networks_member,
        examples=list(_examples(layout, groups)),
    )
    yield GeneratedFile(f"{layout.prefix}.hpp", text)
    yield GeneratedFile("unity_link.hpp", templates.render("unity_link.hpp"))
    yield from c_files(interface, templates.of("c", C_FILTERS))


def declarations(part: PartType) -> list[str]:
    """Return the declarations of a component's members, with comments."""
    signals = [(f"{_member_type(member)} {member.name};", describe(member)) for member in part.signals]
    parts = [(f"{_member_type(member)} {member.name};", member.doc) for member in (*part.parts, *part.modules)]
    return _aligned([*signals, *parts])


def values(group: GroupType) -> list[str]:
    """Return the declarations of a group's values, with their units as comments."""
    return _aligned([(f"{member.type.cpp} {member.name}{{}};", member.signal.unit) for member in group.members])


def _aligned(lines: list[tuple[str, str]]) -> list[str]:
    column = max(len(line) for line, _ in lines) + 2 if lines else 0
    return [f"{line.ljust(column)}{c_comment(beside)}" if beside else line for line, beside in lines]


def converted(member: GroupMember, to: str) -> str:
    """Return an expression that converts a member of `values` to a type of the other language, if they differ."""
    value = f"values.{member.name}"
    is_same = member.type.cpp.removeprefix("std::") == member.type.value
    return value if is_same else f"static_cast<{to}>({value})"


def initializers(part: PartType, place: str = "place") -> list[str]:
    """Return the initializers of a component's members; `place` is an expression for the component in C."""
    members: list[SignalMember | PartMember] = [*part.signals, *part.parts, *part.modules]
    return [
        f"{member.name}(the_link, {place}.{member.name})"
        if member.size is None
        else f"{member.name}(unity_link::each<{_item_type(member)}>(the_link, {place}.{member.name}))"
        for member in members
    ]


def _item_type(member: SignalMember | PartMember) -> str:
    if isinstance(member, PartMember):
        return member.short or "unity_link::Module"
    signal = member.signal
    return f"unity_link::{_SIGNALS[signal.access]}{'Queue' * signal.fifo}<{member.type.cpp}>"


def _member_type(member: SignalMember | PartMember) -> str:
    item = _item_type(member)
    return item if member.size is None else f"std::array<{item}, {member.size}>"


def _examples(layout: Layout, groups: list[tuple[str, GroupType]]) -> Iterator[str]:
    """Yield calls that use the first suitable signals and group, for the comment at the top of the file."""
    signals = layout.interface.signals.values()
    first = next((one for one in signals if one.access.reads), None)
    if first is not None:
        value = layout.value_types[first.path]
        kind = f"{layout.class_name}::{value.cpp}" if value.is_enumeration else value.cpp
        yield f"{kind} value = {_expression(layout, first.path)}.get()"
    written = next((one for one in signals if one.access.writes), None)
    if written is not None:
        yield f"{_expression(layout, written.path)}.set(value)"
    for name, group in groups:
        if group.is_published:
            callback = "[](const auto &values, const auto &sample) { ... }"
            yield f"auto feed = {_variable(layout)}.{name}.subscribe({callback})"
            yield "link.poll(1s)"
            return


def _variable(layout: Layout) -> str:
    """Return the name of the robot in examples; it differs from the constant in C."""
    return "the_robot" if layout.prefix == "robot" else "robot"


def _expression(layout: Layout, path: str) -> str:
    return f"{_variable(layout)}{layout.expressions[path].removeprefix(layout.prefix)}"


FILTERS = C_FILTERS | {
    "converted": converted,
    "declarations": declarations,
    "initializers": initializers,
    "values": values,
}
