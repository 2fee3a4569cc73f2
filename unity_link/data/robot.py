"""The tree of objects for a program: a robot with components and signals, made from a checked model.

`unity_link.load` makes the classes at run time; `unity_link generate python` writes them into a module for editors and
type checkers. Both make subclasses of `Component` and `Robot` that only have annotations. All methods are here.

Attributes have the names of the spec. A name gets ``_`` appended if it is a keyword of Python (`class`), an attribute
of `Robot` (`link`), or a method of a core API (`armed`).
"""

from __future__ import annotations

import functools
import keyword
from typing import TYPE_CHECKING, Any, ClassVar, Never

from unity_link.cores import RobotVerbs, Verbs, names_of
from unity_link.data.groups import Group
from unity_link.data.ports import Port, ReadPort, WritePort
from unity_link.data.proxies import Proxy, refusal, signals_table
from unity_link.data.signals import Readable, ReadWrite, Writable
from unity_link.errors import (
    ArgumentError,
    OfLink,
    SpecMismatchError,
    UnknownNameError,
    UnsupportedError,
    did_you_mean,
    missing,
)
from unity_link.link.link import NOT_CONNECTED, Link
from unity_link.modules import Fifo, Memory, Module
from unity_link.network import TosnetNetwork, TosnetNode
from unity_link.protocol.wire.configuration import Feature
from unity_link.spec.model import Access, ComponentArray, ParameterReference

if TYPE_CHECKING:
    import enum
    from collections.abc import Iterable, Iterator, Mapping

    from unity_link.link.connection import Connection
    from unity_link.modules import Bus
    from unity_link.spec import model
    from unity_link.spec.kinds import Enumeration

MODULE_TYPES: Mapping[str, type[Module]] = {
    "FIFO": Fifo,
    "MEMORY": Memory,
    "TOSNET": TosnetNetwork,
    "TOSNET_NODE": TosnetNode,
}
"""Classes of hardware modules by the words for them in a spec."""


class Component(OfLink):
    """A part of a robot. Its signals, parts and modules are attributes."""

    _model: model.ComponentSpec
    _members: tuple[Proxy[Any] | Component, ...]

    @property
    def signals(self) -> tuple[Proxy[Any], ...]:
        """All signals of the component and of its parts, in the order of the spec."""
        return tuple(_walk(self._members))

    if not TYPE_CHECKING:  # A type checker knows the names.

        def __setattr__(self, name: str, value: object) -> None:
            """Set an attribute that a subclass declares, or that begins with ``_``.

            Raises:
                ArgumentError: for a signal, a part, a module or a method, which the value would hide, and for a
                    name that no class declares.
            """
            member = self.__dict__.get(name)
            if isinstance(member, Proxy) and member.signal.access.writes:
                raise ArgumentError(f"{member.path} is not assigned to: await {member.path}.set({value!r}) writes it")
            first = member[0] if isinstance(member, tuple) and member else member
            is_own = hasattr(Robot, name) or name in Robot.__annotations__ or callable(getattr(type(self), name, None))
            if not name.startswith("_") and (is_own or isinstance(first, (Proxy, Component, Module))):
                raise ArgumentError(f"{name!r} of {self._called()} cannot be assigned to")
            declared = name in {known for kind in type(self).__mro__ for known in (*vars(kind), *_annotations(kind))}
            if not declared and not name.startswith("_"):
                raise ArgumentError(str(self._missing(name)))
            super().__setattr__(name, value)

        def __getattr__(self, name: str) -> Any:
            raise AttributeError(name) if name.startswith("_") else self._missing(name)

    def _called(self) -> str:
        return self._model.path or self._model.name

    def _missing(self, name: str) -> AttributeError:
        """Return the error for a name that the component does not have."""
        known = [other for other in dir(self) if not other.startswith("_")]
        hint = did_you_mean(name, known) or f"there are {', '.join(sorted(vars(self).keys() & {*known})[:8])}"
        if name in _OF_SIGNALS and self.signals:
            hint = f"a signal such as {self.signals[0].path} has it, and a `unity_link.data.Group` of several"
        return AttributeError(f"{self._called()} has no {name!r}: {hint}", name=name, obj=self)

    def __repr__(self) -> str:
        """Return the path, and the signals with their last values, one a line."""
        name = self._called()
        return "\n".join([f"<{type(self).__name__} {name}>", *(f"  {signal!r}" for signal in self.signals)])

    def _repr_html_(self) -> str:
        """Return the path, and the signals with their last values, as a table."""
        return signals_table(f"{type(self).__name__} {self._called()}", self.signals)


class Robot(Component):
    """A public interface of a spec on a link. `unity_link.load` and generated modules make subclasses."""

    interface: ClassVar[model.Interface]
    """Declaration of the robot in the spec."""
    components: ClassVar[Mapping[str, type[Component]]] = {}
    """Classes of the components by the names of their declarations."""
    enumerations: ClassVar[Mapping[str, type[enum.IntEnum]]] = {}
    """Classes of the enumerations by their names."""

    link: Link
    """The link to the robot's gateway."""
    groups: dict[str, Group]
    """The groups that the spec declares, by their names."""
    modules: tuple[Module, ...]
    """All hardware modules in the order of the spec, including those without a name."""

    def __init__(self, link: Link, /, **parameters: int | None) -> None:
        """Create the robot of the spec on a link.

        Args:
            link: an open link.
            parameters: values of the interface's open parameters; those that are not needed can be left out.

        Raises:
            ArgumentError: for a parameter that the interface does not have.
            UnsupportedError: if the gateway's words differ in size from the spec's, or its addresses are too few.
            SpecMismatchError: if it was generated from another spec; `unity_link.robot` reports the differences.
        """
        interface = self.interface
        check_link(interface, link)
        check_gateway(interface, link)
        interface.check_given(parameters)
        own = vars(self)
        own["link"] = link
        self._given = parameters
        own["modules"] = _make_modules(interface, link, self._given)
        self._by_path: dict[str, Proxy[Any]] = {}
        self._fill(self, interface.root)
        self._by_id = {proxy.id: proxy for proxy in self._by_path.values()}
        link.name_addresses(_names_of_addresses(self._by_path))
        link.explain_refusals(
            {
                address: functools.partial(refusal, proxies=[proxy])
                for proxy in self._by_path.values()
                if proxy.signal.safe is not None
                for address in proxy.signal.addresses
            }
        )
        own["groups"] = _Groups(
            {
                group.name: Group.declared(group, [self._by_path[path] for path in group.signals])
                for group in interface.groups
            }
        )

    def __getitem__(self, name: str) -> Proxy[Any]:
        """Return a signal by its path or its ID.

        Raises:
            ArgumentError: if the robot has no such signal.
        """
        if not isinstance(name, str):
            raise ArgumentError(
                f"{self.interface.name} has signals by path or ID, not {name!r}: `signals` has them all"
            )
        proxy = self._by_path.get(name, self._by_id.get(name))
        if proxy is None:
            hint = did_you_mean(name, [*self._by_path, *self._by_id])
            raise ArgumentError(f"{self.interface.name} has no signal {name!r}" + (f": {hint}" if hint else ""))
        return proxy

    def publishing_group(self, proxy: Proxy[Any]) -> Group | None:
        """Return the group with which the gateway or the host samples a signal; None if the spec has it in none."""
        if proxy.signal.group is not None:
            return self.groups[proxy.signal.group]
        return None if proxy.signal.poll_hz is None else self._polled[proxy.signal.poll_hz]

    @classmethod
    def enumeration(cls, enumeration: Enumeration) -> type[enum.IntEnum]:
        """Return the class of an enumeration."""
        return cls.enumerations.get(enumeration.name) or enumeration.python_type

    @functools.cached_property
    def _polled(self) -> dict[float, Group]:
        by_rate: dict[float, list[Proxy[Any]]] = {}
        for proxy in self._by_path.values():
            signal = proxy.signal
            if signal.poll_hz is not None and signal.group is None and signal.access.reads:
                by_rate.setdefault(signal.poll_hz, []).append(proxy)
        return {rate: Group.polled(rate, proxies) for rate, proxies in by_rate.items()}

    # The tree

    def _fill(self, component: Component, part: model.ComponentSpec) -> None:
        """Assign the members of a component."""
        members: list[Proxy[Any] | Component] = []
        attributes: dict[str, Any] = {}
        for name, signals in part.rows.items():
            proxies = tuple(self._make_proxy(signal) for signal in signals)
            members += proxies
            attributes[name] = proxies[0] if signals[0].index is None else proxies
        for below in part.parts:
            if isinstance(below, ComponentArray):
                items = tuple(self._make_component(item) for item in below.items)
                members += items
                attributes[below.name] = items
            else:
                attributes[below.name] = self._make_component(below)
                members.append(attributes[below.name])
        for number in part.modules:
            _add_module(attributes, self.interface.modules[number], self.modules[number])
        component._model = part  # noqa: SLF001  (it is made here)
        component._members = tuple(members)  # noqa: SLF001
        verbs = names_of(kind for kind in type(component).__mro__ if _is_verbs(kind))
        for name, attribute in zip(python_names(attributes, verbs), attributes.values(), strict=True):
            vars(component)[name] = attribute

    def _make_component(self, part: model.ComponentSpec) -> Component:
        component = self.components.get(part.type, Component)()
        self._fill(component, part)
        return component

    def _make_proxy(self, signal: model.Signal) -> Proxy[Any]:
        bus = self.link if signal.module is None else self.modules[signal.module].bus
        proxy = proxy_type(signal)(signal, self, bus)
        self._by_path[signal.path] = proxy
        return proxy


class _Groups(dict[str, Group]):
    """Groups by their names."""

    def __missing__(self, name: object) -> Never:
        hint = did_you_mean(name, self) or f"there are {', '.join(self) or 'none'}"
        raise UnknownNameError(f"the spec declares no group {name!r}: {hint}")

    if not TYPE_CHECKING:  # A type checker reports unknown attributes by itself.

        def __getattr__(self, name: str) -> Never:
            instead = {known: f"write groups[{known!r}]" for known in self}
            raise AttributeError(name) if name.startswith("_") else missing(self, name, "`groups`", **instead)


def _names_of_addresses(proxies: Mapping[str, Proxy[Any]]) -> dict[int, str]:
    """Return the paths of the signals at each address, for error messages."""
    paths: dict[int, list[str]] = {}
    for path, proxy in proxies.items():
        for address in proxy.signal.addresses:
            paths.setdefault(address, []).append(path)
    return {address: " and ".join(there) for address, there in paths.items()}


def _annotations(kind: type) -> dict[str, Any]:
    """Return the annotations of a class itself, without those of its bases."""
    return dict(vars(kind).get("__annotations__", {}))


def _walk(members: Iterable[Proxy[Any] | Component]) -> Iterator[Proxy[Any]]:
    for member in members:
        if isinstance(member, Proxy):
            yield member
        else:
            yield from member.signals


def proxy_type(signal: model.Signal) -> type[Proxy[Any]]:
    """Return the class of a signal's proxy."""
    if signal.fifo:
        return {Access.READ: ReadPort, Access.WRITE: WritePort, Access.READWRITE: Port}[signal.access]
    return {Access.READ: Readable, Access.WRITE: Writable, Access.READWRITE: ReadWrite}[signal.access]


def class_name(name: str) -> str:
    """Return the class name for the name of a declaration: ``leg_joint`` becomes ``LegJoint``."""
    joined = "".join(word[:1].upper() + word[1:] for word in name.split("_") if word)
    return joined if joined.isidentifier() else f"_{joined}"


def _is_verbs(kind: type) -> bool:
    """Return whether a class is the core API of a core, and not that of a component derived from one."""
    return issubclass(kind, (Verbs, RobotVerbs)) and not issubclass(kind, Component)


def python_names(names: Iterable[str], verbs: frozenset[str] = frozenset()) -> list[str]:
    """Return the names of the attributes for the members of a component, in the same order.

    A name that Python, `Robot` or the component's core API uses gets ``_`` appended, several if necessary.
    """
    given = list(names)
    taken = {*given, *verbs}
    made = []
    for name in given:
        # Python mangles names with two leading underscores in a class body.
        free = "_" + name.lstrip("_") if name.startswith("__") else name
        while (
            keyword.iskeyword(free)
            or hasattr(Robot, free)
            or free in _OWN
            or free in verbs
            or (free != name and free in taken)
        ):
            free += "_"
        taken.add(free)
        made.append(free)
    return made


_OF_SIGNALS = frozenset({"get", "post", "samples", "set", "value"})
"""Methods of signals that programs try on a component by mistake."""
_OWN = frozenset(
    {
        *Robot.__annotations__,
        *Component.__annotations__,
        *("_given", "_by_path", "_by_id"),
        # In a generated class, an attribute of this name would hide the type in later annotations.
        *("bool", "float", "int", "tuple"),
    }
)


def _add_module(attributes: dict[str, Any], described: model.ModuleSpec, module: Module) -> None:
    assert described.name is not None
    if described.path is not None and described.path.endswith("]"):
        attributes[described.name] = (*attributes.get(described.name, ()), module)
    else:
        attributes[described.name] = module


def check_link(interface: model.Interface, link: object) -> None:
    """Raise ArgumentError if an object is no open link."""
    if isinstance(link, Link):
        return
    from unity_link.blocking import BlockingLink

    if isinstance(link, BlockingLink):
        name = class_name(interface.name)
        raise ArgumentError(
            f"a robot on a blocking link is made by `put`, of unity_link.data.blocking: put({name}, link)"
        )
    raise ArgumentError(f"{interface.name} needs an open link, not {link!r:.80}: {NOT_CONNECTED}")


def check_gateway(interface: model.Interface, link: Connection) -> None:
    """Compare the configuration of a link's gateway with a spec.

    Raises:
        SpecMismatchError: if it was generated from another spec.
        UnsupportedError: if its words or addresses differ in size.
    """
    info = link.gateway
    if info.data_bits != interface.data_bits:
        raise UnsupportedError(
            f"the spec of {interface.name} is for words of {interface.data_bits} bits, and the gateway's have "
            f"{info.data_bits}: its GATEWAY(DATA_BITS={info.data_bits}) is missing or wrong"
        )
    highest = max((signal.addresses[-1] for signal in interface.signals.values()), default=0)
    if highest >> info.address_bits:
        raise UnsupportedError(
            f"the spec of {interface.name} has addresses up to {highest:#x}, and those of the gateway end at "
            f"{(1 << info.address_bits) - 1:#x}"
        )
    is_other = Feature.FINGERPRINT in info.features and info.build_id != interface.fingerprint
    if is_other and not link.any_map and interface.fingerprint not in link.compatible_maps:
        advice = "load the spec that the gateway was built from, or build it from this one"
        if isinstance(link, Link) and Feature.DESCRIPTION in info.features:
            advice = f"`await unity_link.robot(link, spec)` reports the differences; {advice}"
        raise SpecMismatchError(
            f"the gateway was built for the map {info.build_id:08X}, and the spec of {interface.name} describes the "
            f"map {interface.fingerprint:08X}: {advice}, or write map=any in the URL if you know what differs"
        )


def _make_modules(interface: model.Interface, link: Link, given: Mapping[str, int | None]) -> tuple[Module, ...]:
    """Create the proxies of all hardware modules. A module inside another one uses the bus of that module."""
    modules: list[Module] = []
    for described in interface.modules:
        bus: Bus = link if described.parent is None else modules[described.parent].bus
        arguments = {
            name.lower(): given.get(value.name) if isinstance(value, ParameterReference) else value
            for name, value in described.arguments.items()
        }
        modules.append(MODULE_TYPES[described.type](bus, described.base, size=described.words, **arguments))
    return tuple(modules)
