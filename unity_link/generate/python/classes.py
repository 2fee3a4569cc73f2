"""The declarations of an interface as Python classes.

A component is one class, even if it is used several times. If its uses differ by their arguments, an annotation holds
for all of them: a value that is scaled in one use only is annotated as float.
"""

from __future__ import annotations

import enum
import keyword
import sys
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from unity_link.cores import RobotVerbs, Verbs, classes_of, names_of, robot_verbs_of
from unity_link.data.robot import MODULE_TYPES, class_name, proxy_type, python_names
from unity_link.spec import ComponentArray, ComponentSpec, KindName

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from unity_link.spec import EnumValue, Interface, Kind, Signal

IMPORTED = ("ClassVar", "Component", "Link", "Literal", "Mapping", "NamedNumber", "Robot")
"""Names that every module defines or imports, besides those of proxies and modules."""


_IMPORTED_PACKAGES = {"anyio", "jinja2", "lark", "msgspec", "numpy", "unity_link"}
_SHOWN = 4
"""Most addresses of a signal in its docstring."""


class Attribute(NamedTuple):
    """A member of a class, with annotation and docstring."""

    name: str
    annotation: str
    doc: str


class Class(NamedTuple):
    """A generated class: a component, or the robot."""

    declaration: str
    """Name of the component in the spec."""
    name: str
    doc: str
    attributes: tuple[Attribute, ...]
    verbs: tuple[str, ...]
    """Names of the core API classes, which are its first base classes."""


class EnumClass(NamedTuple):
    """The class of an enumeration."""

    declaration: str
    name: str
    doc: str
    members: tuple[tuple[str, int, str], ...]
    """Name, number and doc string of each value."""
    given: str
    """Name of the type of values that can be written: a member, a number, or a name."""
    names: tuple[str, ...]
    """Names of the values in the spec."""


class Described(NamedTuple):
    """Values for the template."""

    robot: Class
    components: tuple[Class, ...]
    enumerations: tuple[EnumClass, ...]
    parameters: tuple[tuple[str, str], ...]
    """Parameters that a program supplies: the Python argument and the name in the spec."""
    proxies: tuple[str, ...]
    """Names to import from `unity_link.data`."""
    modules: tuple[tuple[str, tuple[str, ...]], ...]
    """Packages and the module classes to import from each."""
    verbs: tuple[tuple[str, tuple[str, ...]], ...]
    """Python modules of cores, and the names to import from each."""


def module_name(interface: Interface) -> str:
    """Return the Python module name of an interface; it must not hide a module that the program needs."""
    is_taken = keyword.iskeyword(interface.name) or interface.name in sys.stdlib_module_names | _IMPORTED_PACKAGES
    return interface.name + "_" * is_taken


def core_modules(interface: Interface) -> dict[str, str]:
    """Return the modules with core APIs, as a generated module imports them, by `Core.python`.

    For a core whose API is a file beside the spec, that is the copy beside the generated module.
    """
    made: dict[str, str] = {}
    for component in interface.cores:
        assert component.core is not None
        python = component.core.python
        if python:
            made[python] = f"{module_name(interface)}_{Path(python).stem}" if python.endswith(".py") else python
    return made


def describe(interface: Interface) -> Described:
    """Return the values for the template of an interface."""
    uses: dict[str, list[ComponentSpec]] = {}
    for part in interface.root.walk():
        if part is not interface.root:
            uses.setdefault(part.type, []).append(part)
    proxies = sorted({proxy_type(signal).__name__ for signal in interface.signals.values()})
    modules, verbs = _modules(interface), _verbs(interface)
    namer = _Names([*IMPORTED, *proxies, *(name for _, names in (*modules, *verbs) for name in names)])
    robot_name = namer.take(interface.name)
    names = {declaration: namer.take(declaration) for declaration in uses}
    enumerations = {known.name: namer.take(known.name) for known in interface.enumerations}
    given = {known.name: namer.take(f"{known.name}_given") for known in interface.enumerations}
    maker = _Maker(interface, names, enumerations, given)
    return Described(
        robot=maker.make(interface.name, robot_name, [interface.root]),
        components=tuple(
            maker.make(declaration, names[declaration], uses[declaration]) for declaration in reversed(uses)
        ),
        enumerations=tuple(
            EnumClass(
                known.name,
                enumerations[known.name],
                known.doc or f"The enumeration {known.name} of the spec.",
                _members(known.values),
                given[known.name],
                tuple(value.name for value in known.values),
            )
            for known in interface.enumerations
        ),
        parameters=_arguments([parameter.name for parameter in interface.parameters if parameter.value is None]),
        proxies=tuple(proxies),
        modules=modules,
        verbs=verbs,
    )


def _verbs(interface: Interface) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Return the Python modules of cores, and the names of the core API classes in each."""
    modules = core_modules(interface)
    names: dict[str, set[str]] = {}
    for component in interface.cores:
        core = component.core
        for kind in (*classes_of(core, Verbs), *classes_of(core, RobotVerbs)):
            assert core is not None
            names.setdefault(modules[core.python], set()).add(kind.__name__)
    return tuple((module, tuple(sorted(given))) for module, given in sorted(names.items()))


class _Names:
    """Gives unique names to classes."""

    def __init__(self, taken: Iterable[str]) -> None:
        self._taken = set(taken)

    def take(self, declaration: str) -> str:
        name = class_name(declaration)
        while name in self._taken or keyword.iskeyword(name):
            name += "_"
        self._taken.add(name)
        return name


class _Maker:
    """Makes the classes of components."""

    def __init__(
        self, interface: Interface, names: dict[str, str], enumerations: dict[str, str], given: dict[str, str]
    ) -> None:
        self._interface = interface
        self._names = names
        self._enumerations = enumerations
        self._given = given

    def make(self, declaration: str, name: str, uses: list[ComponentSpec]) -> Class:
        """Return the class of a declaration from all its uses."""
        attributes = [attribute for attributes in self._members(uses) for attribute in attributes]
        is_robot = uses[0] is self._interface.root
        verbs = robot_verbs_of(self._interface) if is_robot else classes_of(uses[0].core, Verbs)
        free = python_names((attribute.name for attribute in attributes), names_of(verbs))
        named = (attribute._replace(name=name) for name, attribute in zip(free, attributes, strict=True))
        # A component without a doc string gets the doc string of its placement, if there is only one.
        docs = {use.type_doc or use.doc for use in uses}
        doc = docs.pop() if len(docs) == 1 else ""
        doc = doc or f"The component {declaration} of the spec."
        return Class(declaration, name, doc, tuple(named), tuple(kind.__name__ for kind in verbs))

    def _members(self, uses: list[ComponentSpec]) -> Iterator[Iterable[Attribute]]:
        first = uses[0]
        places = zip(*(use.rows.values() for use in uses), strict=True)
        yield (self._signal([signal for row in rows for signal in row]) for rows in places)
        yield (self._part(part) for part in first.parts)
        yield self._modules(first)

    def _signal(self, signals: list[Signal]) -> Attribute:
        first = signals[0]
        types = list(dict.fromkeys(self._value_type(signal.kind) for signal in signals))
        # The annotation float also accepts ints.
        value = "float" if "float" in types else " | ".join(types)
        if first.access.writes and first.kind.enumeration is not None:
            value += f", {self._given[first.kind.enumeration.name]}"
        doc = "\n".join([*_text(first.doc), *_properties(signals)])
        proxy = f"{proxy_type(first).__name__}[{value}]"
        return Attribute(first.name, proxy if first.index is None else f"tuple[{proxy}, ...]", doc)

    def _value_type(self, kind: Kind) -> str:
        if kind.enumeration is not None:
            # A number without a name is a valid value too.
            return f"{self._enumerations[kind.enumeration.name]} | int"
        if kind.is_float:
            return "float"
        return "bool" if kind.name is KindName.BOOL else "int"

    def _part(self, part: ComponentSpec | ComponentArray) -> Attribute:
        if isinstance(part, ComponentArray):
            return Attribute(part.name, f"tuple[{self._names[part.items[0].type]}, ...]", part.doc)
        return Attribute(part.name, self._names[part.type], part.doc)

    def _modules(self, component: ComponentSpec) -> Iterable[Attribute]:
        made: dict[str, Attribute] = {}
        for number in component.modules:
            module = self._interface.modules[number]
            assert module.name is not None
            known = MODULE_TYPES[module.type].__name__
            is_array = module.path is not None and module.path.endswith("]")
            annotation = f"tuple[{known}, ...]" if is_array else known
            made[module.name] = Attribute(module.name, annotation, module.doc or f"{module.type} at {module.base:#x}.")
        return made.values()


def _modules(interface: Interface) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Return the classes of the named modules, by the packages that define them."""
    packages: dict[str, set[str]] = {}
    for kind in {MODULE_TYPES[module.type] for module in interface.modules if module.name is not None}:
        packages.setdefault(".".join(kind.__module__.split(".")[:2]), set()).add(kind.__name__)
    return tuple((package, tuple(sorted(names))) for package, names in sorted(packages.items()))


def _text(doc: str) -> list[str]:
    return [doc, ""] if doc else []


def _properties(signals: list[Signal]) -> list[str]:
    """Return the properties that are the same in all uses of a signal's component, as sentences."""
    first = signals[0]
    addresses = ", ".join(f"{signal.address:#x}" for signal in signals[:_SHOWN])
    if len(signals) > _SHOWN:
        addresses += f" and {len(signals) - _SHOWN} more"
    bits = "" if first.width == first.word_bits * first.words else f", bits {_bits(first)}"
    lines = [f"{first.kind if len({signal.kind for signal in signals}) == 1 else first.kind.name} at {addresses}{bits}"]
    if len({signal.unit for signal in signals}) == 1 and first.unit:
        lines.append(f"Unit: {first.unit}")
    if first.access.writes and len({signal.limits for signal in signals}) == 1:
        low, high = first.limits
        lines.append(f"Limits: {low:.12g} to {high:.12g}")
    if first.group is not None:
        lines.append(f"Published by group {first.group}")
    if first.poll_hz is not None:
        lines.append(f"Polled at {first.poll_hz:g} Hz")
    return [line + "." for line in lines]


def _bits(signal: Signal) -> str:
    high = signal.lowest_bit + signal.width - 1
    return str(high) if signal.width == 1 else f"{high} to {signal.lowest_bit}"


def _arguments(names: list[str]) -> tuple[tuple[str, str], ...]:
    taken = {"self", "link"}
    made = []
    for name in names:
        free = name
        while keyword.iskeyword(free) or free in taken:
            free += "_"
        taken.add(free)
        made.append((free, name))
    return tuple(made)


_OF_ENUMERATIONS = frozenset(dir(enum.IntEnum)) | {"name", "value"}
"""Names that a member of a Python enumeration cannot have."""


def _members(values: Iterable[EnumValue]) -> tuple[tuple[str, int, str], ...]:
    given = list(values)
    taken = {value.name for value in given}
    made = []
    for value in given:
        name = value.name
        while keyword.iskeyword(name) or name in _OF_ENUMERATIONS or (name != value.name and name in taken):
            name += "_"
        taken.add(name)
        made.append((name, value.value, value.doc))
    return tuple(made)
