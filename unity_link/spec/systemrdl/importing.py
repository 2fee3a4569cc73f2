"""Import: converts an address map to a tree of components, and that to the text of a spec."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from subprocess import TimeoutExpired
from typing import TYPE_CHECKING, Any, NamedTuple

from unity_link.errors import UnsupportedError
from unity_link.spec.arguments import ADDRESS_BITS, DATA_BITS
from unity_link.spec.diagnostics import Diagnostic, Span, SpecError
from unity_link.spec.kinds import MOST_BITS, KindName
from unity_link.spec.model import Access, Effect
from unity_link.spec.modules import MODULES
from unity_link.spec.placing import GATEWAY_WORD, MOST_ITEMS
from unity_link.spec.systemrdl.comparing import compare
from unity_link.spec.systemrdl.effects import cleared_together, effect_of, effects, warnings
from unity_link.spec.systemrdl.naming import doc_lines, unique_name, values_text
from unity_link.spec.systemrdl.numbers import PEAKRDL, declare, number_of, reset_of
from unity_link.spec.systemrdl.perl import first_perl
from unity_link.spec.systemrdl.places import about, diagnostic, flat_path

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from systemrdl.node import AddressableNode, AddrmapNode, FieldNode, MemNode, Node, RegNode, RootNode
    from systemrdl.rdltypes.user_enum import UserEnum
    from systemrdl.source_ref import SourceRefBase

_RESERVED = {"import", "enum", "group", "public"}
_PERL_REFUSED = "this is Perl, a program: it is run only by `import rdl --perl`"
_KINDS = {kind.value for kind in KindName}
"""Words for kinds, which cannot be names of enumerations."""


@dataclass
class _Field:
    name: str
    address: int
    """Word address relative to the part that contains the field."""
    bits: str
    kind: str
    access: Access
    arguments: list[str]
    doc: str = ""


@dataclass
class _Part:
    """A component of the spec to be written."""

    type_name: str
    members: list[_Field | _Placed] = field(default_factory=list)
    memories: list[_Memory] = field(default_factory=list)
    doc: str = ""
    taken: set[str] = field(default_factory=set)
    """Names of its members, in lower case."""


@dataclass
class _Placed:
    name: str
    part: _Part
    address: int
    count: int | None = None
    stride: int = 0


@dataclass
class _Memory:
    name: str
    address: int
    words: int
    entries: _Placed | None = None
    """The registers that are declared inside the memory."""
    doc: str = ""


class Imported(NamedTuple):
    """A spec that was made from SystemRDL."""

    text: str
    warnings: tuple[Diagnostic, ...] = ()
    """Renamed nodes, and side effects that the spec cannot express, with their places in the SystemRDL."""


def import_file(*paths: Path, top: str | None = None, include: Sequence[Path] = (), perl: bool = False) -> Imported:
    """Convert a SystemRDL description to a spec, and compare the compiled spec with the tree of the SystemRDL compiler.

    Time and memory are not limited here: macros of a few lines can use any amount of both. The command `import rdl`
    therefore runs this function in a process of its own.

    Args:
        paths: one file, or several if later ones use declarations of earlier ones.
        top: name of the address map to convert; None converts the last one.
        include: folders that are searched for included files.
        perl: execute the Perl in the files, in the compiler's sandbox, for at most 5 seconds.

    Raises:
        SpecError: with the errors of the compiler; or if the files contain something that a spec cannot express, or
            Perl that must not be executed.
        UnsupportedError: if the extra ``rdl`` is not installed.
    """
    root = _compiled(paths, top, include, perl=perl)
    importer = _Importer(root.top)
    text = importer.text()
    errors = importer.faults or compare(text, root.top, importer.names)
    if errors:
        raise SpecError(dict.fromkeys(errors))
    return Imported(text, tuple(dict.fromkeys(importer.warnings)))


def _compiled(paths: Sequence[Path], top: str | None, include: Sequence[Path], *, perl: bool) -> RootNode:
    undeclared: list[str] = []
    while True:
        try:
            return _elaborated(paths, top, include, undeclared, perl=perl)
        except SpecError as error:
            # The compiler stops at the first undeclared property, so declare PeakRDL's properties one by one.
            more = [name for name in PEAKRDL if name not in undeclared and f"property '{name}'" in str(error)]
            if not more:
                raise
            undeclared += more


def _elaborated(
    paths: Sequence[Path], top: str | None, include: Sequence[Path], declared: Sequence[str], *, perl: bool
) -> RootNode:
    try:
        from systemrdl.compiler import RDLCompiler
        from systemrdl.messages import MessagePrinter, RDLCompileError, Severity
    except ImportError:
        raise UnsupportedError("SystemRDL needs its compiler: pip install 'unity-link[rdl]'") from None
    found: list[Diagnostic] = []
    path = paths[-1]

    class Collector(MessagePrinter):
        def print_message(self, severity: Severity, text: str, src_ref: SourceRefBase | None) -> None:
            # A fatal message after others only repeats that there were errors.
            if severity < Severity.ERROR or (severity is Severity.FATAL and found):
                return
            found.append(diagnostic("error", "systemrdl", text, src_ref, str(path)))

    compiler = RDLCompiler(message_printer=Collector())
    declare(compiler, declared)
    folders = [str(folder) for folder in include]
    perl_at: tuple[Span, str] | None = None
    try:
        for path in paths:
            perl_at = first_perl(compiler.env, path, folders)
            if perl_at is not None and not perl:
                raise SpecError([Diagnostic("error", "systemrdl", _PERL_REFUSED, *perl_at)])
            compiler.compile_file(str(path), incl_search_paths=folders)
        return compiler.elaborate(top_def_name=top)
    except (RDLCompileError, OSError, ValueError, RecursionError, TimeoutExpired) as error:
        if not found:
            place: tuple[Span, str] = (Span(str(path), 1, 1, 1, 1), "")
            if isinstance(error, TimeoutExpired):
                message, place = f"the Perl of this file does not end within {error.timeout:g} s", perl_at or place
            else:
                too_deep = "it is nested too deeply" if isinstance(error, RecursionError) else None
                message = getattr(error, "strerror", None) or too_deep or str(error)
            found.append(Diagnostic("error", "systemrdl", message, *place))
        raise SpecError(found) from None


class _Importer:
    """Makes a spec from one address map. Parts that a spec cannot express are collected in `faults`."""

    def __init__(self, top: AddrmapNode) -> None:
        from systemrdl.node import MemNode, RegNode

        self._top = top
        nodes = list(top.descendants())
        registers = [node for node in nodes if isinstance(node, RegNode)]
        self._bits = _word_bits(registers, [node for node in nodes if isinstance(node, MemNode)])
        self._enumerations: dict[str, str] = {}
        """Text between the braces of each enumeration, by name."""
        self._components: dict[str, str] = {}
        """Names of components, by the text of their bodies."""
        self._docs: dict[str, str] = {}
        self._names: set[str] = set()
        self.is_ours = self._ours(top, "address_bits") is not None
        self.names: dict[str, str] = {}
        """Names of nodes in the spec, by flat path; empty for a field that is the only signal of its register."""
        self.faults: list[Diagnostic] = []
        self.warnings: list[Diagnostic] = []

    def text(self) -> str:
        """Return the spec in its canonical layout."""
        from unity_link.spec import format_text

        top = self._top
        part = self._part_of_paths() if self.is_ours else self._part(top)
        name = unique_name(_name(top.inst_name), self._names)
        groups = self._ours(top, "groups") or ""
        self._names |= {
            word.lower() for word in (*MODULES, GATEWAY_WORD, *re.findall(r"^group (\w+)", groups, re.MULTILINE))
        }
        body = self._body(part, "")
        highest = max(top.size * 8 // self._bits - 1, 1)
        bits = self._ours(top, "address_bits") or max(ADDRESS_BITS[0], highest.bit_length())
        if bits > ADDRESS_BITS[1]:
            self._fault(top, f"it has {highest + 1:#x} words, and a gateway has at most {1 << ADDRESS_BITS[1]:#x}")
        public = f"public {name}() {{\nGATEWAY(ADDRESS_BITS={bits}, DATA_BITS={self._bits});\n{body}}}\n"
        enumerations = [f"enum {name} {{ {values} }}\n" for name, values in self._enumerations.items()]
        components = [f"{doc_lines(self._docs[name])}{name}(){body}" for body, name in self._components.items()]
        pieces = [doc_lines(part.doc) + public, groups, *enumerations, *components]
        return format_text("\n".join(piece for piece in pieces if piece))

    def _fault(self, node: Node, message: str) -> None:
        self.faults.append(about("error", "unsupported", f"{flat_path(node)}: {message}", node))

    # From the hierarchy of other SystemRDL

    def _part(self, node: AddressableNode) -> _Part:
        from systemrdl.node import AddressableNode, AddrmapNode, MemNode, RegfileNode, RegNode

        part = _Part(node.type_name or node.inst_name, doc=_desc(node))
        if isinstance(node, AddrmapNode) and node.get_property("bridge"):
            self._fault(node, "the maps of a bridge lie over each other: choose one, declared by itself, with --top")
            return part
        for child in node.children(unroll=False):
            if isinstance(child, AddressableNode) and child.is_array and child.n_elements > MOST_ITEMS:
                self._fault(child, f"an array of {child.n_elements} was found, and at most {MOST_ITEMS} was expected")
            elif isinstance(child, RegNode):
                self._add_register(part, child)
            elif isinstance(child, MemNode):
                self._add_memory(part, child)
            elif isinstance(child, RegfileNode | AddrmapNode):
                inner = self._part(child)
                if inner.members or inner.memories:
                    part.members.append(self._placed(child, inner, self._call(child, part)))
        return part

    def _call(self, node: Node, part: _Part) -> str:
        """Return the name of a node in its part: its own, changed if a spec does not allow it or it is taken."""
        name = self.names[flat_path(node)] = unique_name(_name(node.inst_name), part.taken)
        if name != node.inst_name:
            message = f"{flat_path(node)} is called {name}: names of specs differ by more than case, and some are words"
            self.warnings.append(about("warning", "renamed", message, node))
        return name

    def _placed(self, node: AddressableNode, part: _Part, name: str) -> _Placed:
        address = self._word(node.raw_address_offset, node)
        if node.array_stride is None:
            return _Placed(name, part, address)
        return _Placed(name, part, address, node.n_elements, self._word(node.array_stride, node))

    def _word(self, byte_address: int, node: Node) -> int:
        """Return the word address for a byte address; report one that is not aligned."""
        address, rest = divmod(byte_address, self._bits // 8)
        if rest:
            self._fault(node, f"byte {byte_address:#x} is not at the beginning of a word of {self._bits} bits")
        return address

    def _add_memory(self, part: _Part, node: MemNode) -> None:
        size = -(-node.total_size * 8 // self._bits)
        memory = _Memory(self._call(node, part), self._word(node.raw_address_offset, node), size, doc=_desc(node))
        inner = self._part(node)
        if inner.members:
            entries = unique_name(f"{memory.name}_entries", part.taken)
            self.names[flat_path(node)] = entries
            memory.entries = self._placed(node, inner, entries)
            memory.entries.address = 0
        part.memories.append(memory)

    def _add_register(self, part: _Part, node: RegNode) -> None:
        if not self._has_words(node):
            return
        inner = _Part(node.type_name or node.inst_name, doc=_desc(node))
        if len(cleared_together(node, self._bits)) > 1:
            self._add_cleared(part, inner, node)
            return
        kept = [one for one in node.fields() if one.is_sw_readable or one.is_sw_writable]
        has_names = node.is_array or len(kept) > 1
        for one in kept:
            self.warnings += warnings(one, effect_of(one, self._bits))
            found = self._field(one)
            if found is not None:
                inner.members.append(found)
                found.name = self._call(one, inner) if has_names else ""
        if has_names:
            part.members.append(self._placed(node, inner, self._call(node, part)))
        elif inner.members:
            (only,) = inner.members
            assert isinstance(only, _Field)
            self.names[flat_path(kept[0])] = ""
            only.name = self._call(node, part)
            only.address += self._word(node.raw_address_offset, node)
            only.doc = "\n".join(filter(None, (_desc(node), only.doc)))
            part.members.append(only)

    def _add_cleared(self, part: _Part, inner: _Part, node: RegNode) -> None:
        """Add a register whose fields are all cleared by a read as one signal: reading one field clears the others."""
        fields = cleared_together(node, self._bits)
        low, high = min(one.low for one in fields), max(one.high for one in fields)
        first, width = low % self._bits, high - low + 1
        bits = "" if width == self._bits else f"[{first + width - 1}:{first}]"
        described = [f"{_bits_of(one, low)}: {one.inst_name}. {_desc(one)}".rstrip() for one in fields]
        doc = "\n".join(filter(None, (_desc(node), *described)))
        arguments = [f"EFFECT={Effect.CLEAR_ON_READ}"]
        name = self._call(node, part)
        for one in fields:
            self.names[flat_path(one)] = "bits" if node.is_array else ""
        only = _Field(name, low // self._bits, bits, f"unsigned {width}", Access.READ, arguments, doc)
        message = f"{flat_path(node)}: a read clears all of its fields, which are one signal of the spec, {name}"
        self.warnings.append(about("warning", "one-signal", message, node))
        if node.is_array:
            only.name = "bits"
            inner.members.append(only)
            part.members.append(self._placed(node, inner, name))
        else:
            only.address += self._word(node.raw_address_offset, node)
            part.members.append(only)

    def _has_words(self, node: RegNode) -> bool:
        """Return whether a gateway can access the bits of a register as its words; report the reason otherwise."""
        width, access = node.get_property("regwidth"), node.get_property("accesswidth")
        if node.is_msb0_order and any(node.fields()):
            self._fault(node, "its fields count bits from the most significant one (msb0): write them as [high:low]")
        elif access > DATA_BITS[1]:
            message = f"it is accessed {access} bits at a time (accesswidth), and a gateway's words have at most"
            self._fault(node, f"{message} {DATA_BITS[1]}")
        elif width > self._bits and _map_around(node).get_property("bigendian"):
            message = f"its {width} bits are several words of {self._bits}, the highest first (bigendian)"
            self._fault(node, f"{message}: a signal has the lowest first")
        else:
            if access > self._bits:
                message = f"{flat_path(node)}: its accesswidth is {access}, and it is read and written in words of"
                self.warnings.append(about("warning", "accesswidth", f"{message} {self._bits} bits", node))
            return True
        return False

    def _field(self, node: FieldNode) -> _Field | None:
        """Return a readable or writable field of a register; None if a signal cannot represent it."""
        reads, writes = node.is_sw_readable, node.is_sw_writable
        if not reads and not writes:
            return None
        access = Access.READWRITE if reads and writes else Access.READ if reads else Access.WRITE
        address, low = divmod(node.low, self._bits)
        if node.width > MOST_BITS:
            self._fault(node, f"it has {node.width} bits, and a signal has at most {MOST_BITS}")
            return None
        if low + node.width > self._bits and low:
            self._fault(node, f"it goes over the end of a word of {self._bits} bits")
            return None
        try:
            kind, arguments = self._kind(node)
        except ValueError as error:
            self._fault(node, str(error))
            return None
        if writes and (reset := reset_of(node)):
            arguments = [*arguments, f"RESET={reset}"]
        if effect := effect_of(node, self._bits):
            arguments = [*arguments, f"EFFECT={effect}"]
        whole = low == 0 and node.width >= self._bits
        bits = "" if whole else f"[{low}]" if node.width == 1 else f"[{low + node.width - 1}:{low}]"
        doc = "\n".join(filter(None, (_desc(node), *effects(node, effect))))
        return _Field(node.inst_name, address, bits, kind, access, arguments, doc)

    def _kind(self, node: FieldNode) -> tuple[str, list[str]]:
        """Return the kind of a field and the arguments that belong to the kind."""
        number, width = number_of(node), node.width
        encode = node.get_property("encode")
        if encode is not None:
            return f"{self._enumeration(encode)} {width}", []
        if number.fraction is not None and 0 <= number.fraction <= width:
            return f"{'fixed' if number.signed else 'ufixed'} {width - number.fraction}.{number.fraction}", []
        scale = [] if number.fraction is None else [f"SCALE={math.ldexp(1, -number.fraction)!r}"]
        is_bit = width == 1 and not number.signed and not scale
        return "bool" if is_bit else f"{'signed' if number.signed else 'unsigned'} {width}", scale

    def _enumeration(self, encode: type[UserEnum]) -> str:
        numbers = [member.value for member in encode]
        twice = next((number for number in numbers if numbers.count(number) > 1), None)
        if twice is not None:
            raise ValueError(f"the enumeration {encode.type_name} has several names for {twice}")
        taken: set[str] = set()
        values = values_text(
            (unique_name(_value_name(member.name), taken), member.value, member.rdl_desc or "") for member in encode
        )
        name = _name(encode.type_name.removesuffix("_e") or encode.type_name)
        return self._named(f"{name}_" if name in _KINDS or name in MODULES else name, values)

    def _named(self, name: str, values: str) -> str:
        """Return the name of the enumeration with these values; underscores are appended if the name is taken."""
        while self._enumerations.setdefault(name, values) != values:
            name += "_"
        self._names.add(name.lower())
        return name

    # From the `ul_path` properties of an exported map

    def _part_of_paths(self) -> _Part:
        from systemrdl.node import FieldNode, MemNode

        whole = _Part("top", doc=_desc(self._top))
        fields = [node for node in self._top.descendants() if isinstance(node, FieldNode)]
        # The signals of groups are in the exported order; the others follow, sorted by address.
        last = len(fields)
        for node in sorted(fields, key=lambda node: last if (place := self._ours(node, "order")) is None else place):
            path = self._ours(node, "path")
            found = self._field(node) if path else None
            if path is None or found is None:
                continue
            part, found.name = _part_at(whole, path)
            self._complete(found, node, path)
            found.address += self._word(node.parent.absolute_address, node.parent)
            part.members.append(found)
        for memory in self._top.descendants():
            if isinstance(memory, MemNode):
                part, name = _part_at(whole, self._ours(memory, "path") or memory.inst_name)
                address = self._word(memory.absolute_address, memory)
                part.memories.append(_Memory(name, address, memory.total_size * 8 // self._bits, doc=_desc(memory)))
        _rebase(whole)
        return whole

    def _complete(self, found: _Field, node: FieldNode, path: str) -> None:
        """Complete a field from the `ul_` properties of its node."""
        kind, values = self._ours(node, "kind"), self._ours(node, "values")
        if kind is not None and node.get_property("encode") is None:
            word, _, bits = kind.partition(" ")
            found.kind = kind if values is None else f"{self._named(word, values)} {bits}"
            width = sum(int(part) for part in re.findall(r"\d+", bits)) or 1
            # A signal of several words has the width of its kind; its field is only the first word.
            if width > self._bits:
                found.bits = ""
        arguments = self._ours(node, "arguments")
        # The port of a queue is a whole word, whatever the width of its values.
        if arguments is not None and re.search(r"(^|, )FIFO", arguments):
            found.bits = ""
        identity, unit = self._ours(node, "id"), self._ours(node, "unit")
        # The exported arguments repeat RESET and EFFECT, and have them for signals of several words too.
        found.arguments = [one for one in found.arguments if not one.startswith(("RESET=", "EFFECT="))]
        if identity is not None and identity != path:
            found.arguments.append(f"ID={_quoted(identity)}")
        found.arguments += filter(None, [arguments])
        if unit is not None:
            found.arguments.append(f"UNIT={_quoted(unit)}")
        found.doc = _desc(node)

    def _ours(self, node: Node, name: str) -> Any:
        """Return a `ul_` property of a node; None if the node does not have it."""
        name = f"ul_{name}"
        return node.get_property(name) if name in node.list_properties() else None

    # Writing

    def _body(self, part: _Part, base: str) -> str:
        members = (
            self._signal(one, base) if isinstance(one, _Field) else self._placement(one, base) for one in part.members
        )
        return "".join([*(self._memory(one, base) for one in part.memories), *members])

    def _memory(self, one: _Memory, base: str) -> str:
        # Members of a module have addresses relative to its base.
        entries = ";\n" if one.entries is None else f" {{\n{self._placement(one.entries, '')}}}\n"
        module = f"MEMORY(BASE={base}{one.address:#x}, SIZE={one.words})"
        return f"{doc_lines(one.doc)}{one.name}: {module}{entries}"

    def _signal(self, one: _Field, base: str) -> str:
        address = f"{base}{one.address:#x}" if not base or one.address else "base"
        declaration = f"{one.kind} {one.access}({', '.join(one.arguments)})"
        return f"{doc_lines(one.doc)}@{one.name} = {address}{one.bits}: {declaration};\n"

    def _placement(self, placed: _Placed, base: str) -> str:
        type_name = self._component(placed.part)
        address = f"{base}{placed.address:#x}"
        count = "" if placed.count is None else f"[{placed.count}]"
        step = "" if placed.count is None else f" + {placed.stride:#x} * i"
        return f"{placed.name}{count}: {type_name}() @({address}{step});\n"

    def _component(self, part: _Part) -> str:
        body = f": @(base) {{\n{self._body(part, 'base + ')}}}\n"
        found = self._components.get(body)
        if found is None:
            found = self._components[body] = unique_name(_name(part.type_name), self._names)
            self._docs[found] = part.doc
        return found


def _bits_of(node: FieldNode, lowest: int) -> str:
    """Return the position of a field within a signal as a phrase; bits count from 0."""
    high, low = node.high - lowest, node.low - lowest
    return f"bit {low}" if high == low else f"bits {high}:{low}"


def _part_at(whole: _Part, path: str) -> tuple[_Part, str]:
    """Return the part that contains a path, and the name in that part; ``legs[2]`` becomes ``legs_2``."""
    *components, name = re.sub(r"\[(\d+)\]", r"_\1", path).split(".")
    for component in components:
        whole = _part_named(whole, component)
    return whole, name


def _part_named(around: _Part, name: str) -> _Part:
    """Return the part with a name inside another part; it is added if it does not exist."""
    for one in around.members:
        if isinstance(one, _Placed) and one.name == name:
            return one.part
    made = _Placed(name, _Part(name), 0)
    around.members.append(made)
    return made.part


def _rebase(part: _Part) -> None:
    """Make absolute addresses relative: each part gets the lowest address inside it, its members the distance to it."""
    for placed in part.members:
        if isinstance(placed, _Placed):
            _rebase(placed.part)
            inner = [*placed.part.members, *placed.part.memories]
            placed.address = min(one.address for one in inner)
            for one in inner:
                one.address -= placed.address


def _desc(node: Node) -> str:
    desc: str | None = node.get_property("desc")
    return desc or ""


def _map_around(node: Node) -> AddrmapNode:
    from systemrdl.node import AddrmapNode

    while not isinstance(node, AddrmapNode):
        assert node.parent is not None
        node = node.parent
    return node


def _word_bits(registers: Sequence[RegNode], memories: Sequence[MemNode]) -> int:
    """Return the word width in bits for a gateway: of the narrowest register, or without registers of the memories.

    A register that is wider than the widest gateway word counts with its accesswidth.
    """
    widths: list[int] = [node.get_property("regwidth") for node in registers]
    narrow: list[int] = [
        width if width <= DATA_BITS[1] else min(node.get_property("accesswidth"), DATA_BITS[1])
        for node, width in zip(registers, widths, strict=True)
    ]
    entries: list[int] = [1 << max(3, (node.get_property("memwidth") - 1).bit_length()) for node in memories]
    return min(narrow or [DATA_BITS[1], *(entries or [32])])


def _name(name: str) -> str:
    return f"{name}_" if name in _RESERVED else name


def _value_name(name: str) -> str:
    """Return a name for a value of an enumeration that is allowed in Python's enumerations too."""
    return f"v{name}" if name.startswith("_") else f"{name}_" if name == "mro" else _name(name)


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t")
    return f'"{escaped}"'
