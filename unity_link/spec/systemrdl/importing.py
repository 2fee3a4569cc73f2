"""In: an address map as the text of a spec, by way of a tree of components to be."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from subprocess import TimeoutExpired
from typing import TYPE_CHECKING, Any

from unity_link.errors import UnsupportedError
from unity_link.spec.diagnostics import Diagnostic, Span, SpecError
from unity_link.spec.kinds import KindName
from unity_link.spec.model import Access
from unity_link.spec.modules import MODULES
from unity_link.spec.placing import GATEWAY_WORD

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

from unity_link.spec.systemrdl.naming import doc_lines, unique_name, values_text
from unity_link.spec.systemrdl.perl import first_perl

_RESERVED = {"import", "enum", "group", "public"}
_PERL_REFUSED = "this is Perl, a program: it is run only by `import rdl --perl`"
_KINDS = {kind.value for kind in KindName}
"""Names that no enumeration can have."""


@dataclass
class _Field:
    name: str
    address: int
    """Relative to the part that it stands in."""
    bits: str
    kind: str
    access: Access
    arguments: list[str]
    doc: str = ""


@dataclass
class _Part:
    """A component to be."""

    type_name: str
    members: list[_Field | _Placed] = field(default_factory=list)
    memories: list[str] = field(default_factory=list)
    doc: str = ""


@dataclass
class _Placed:
    name: str
    part: _Part
    address: int
    count: int | None = None
    stride: int = 0


def import_file(path: Path, top: str | None = None, *, perl: bool = False) -> str:
    """Write a SystemRDL description as a spec.

    Neither time nor memory is bounded: macros of a few lines can ask for any amount of both, and the command
    `import rdl` runs in a process of its own for that.

    Args:
        path: the file.
        top: name of the address map to take; None takes the last one of the file.
        perl: runs the Perl in it, in the compiler's compartment, for 5 seconds at most.

    Raises:
        SpecError: where the file is no SystemRDL, with what its compiler says; or has Perl, which is not to be run.
        UnsupportedError: where it has what no gateway has, or the extra ``rdl`` is not installed.
    """
    root = _compiled(path, top, perl=perl)
    return _Importer(root.top).text()


def _compiled(path: Path, top: str | None, *, perl: bool) -> Any:
    try:
        from systemrdl.compiler import RDLCompiler
        from systemrdl.messages import MessagePrinter, RDLCompileError, Severity
    except ImportError:
        raise UnsupportedError("SystemRDL needs its compiler: pip install 'unity-link[rdl]'") from None
    found: list[Diagnostic] = []

    class Collector(MessagePrinter):
        def print_message(self, severity: Severity, text: str, src_ref: Any) -> None:
            # The last one only says that there were errors.
            if severity < Severity.ERROR or (severity is Severity.FATAL and found):
                return
            line, (first, last) = getattr(src_ref, "line", 1), getattr(src_ref, "line_selection", (0, 0))
            span = Span(str(getattr(src_ref, "path", path)), line, first + 1, line, last + 2)
            found.append(Diagnostic("error", "systemrdl", text, span, getattr(src_ref, "line_text", "").rstrip()))

    compiler = RDLCompiler(message_printer=Collector())
    perl_at: tuple[Span, str] | None = None
    try:
        perl_at = first_perl(compiler.env, path)
        if perl_at is not None and not perl:
            raise SpecError([Diagnostic("error", "systemrdl", _PERL_REFUSED, *perl_at)])
        compiler.compile_file(str(path))
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
    """Makes a spec of one address map."""

    def __init__(self, top: Any) -> None:
        self._top = top
        registers = [node for node in top.descendants() if type(node).__name__ == "RegNode"]
        self._bits = min((node.get_property("regwidth") for node in registers), default=32)
        self._enumerations: dict[str, str] = {}
        """Text between the braces of each, by their names."""
        self._components: dict[str, str] = {}
        """Names of components by what stands in them."""
        self._docs: dict[str, str] = {}
        self._names: set[str] = set()
        self._is_ours = any(self._ours(node, "path") for register in registers for node in register.fields())

    def text(self) -> str:
        """Return the spec, in its canonical layout."""
        from unity_link.spec import format_text

        top = self._top
        part = self._part_of_paths() if self._is_ours else self._part(top)
        name = unique_name(_name(top.inst_name), self._names)
        groups = self._ours(top, "groups") or ""
        self._names |= {*MODULES, GATEWAY_WORD, *re.findall(r"^group (\w+)", groups, re.MULTILINE)}
        body = self._body(part, "")
        highest = max(top.size * 8 // self._bits - 1, 1)
        bits = self._ours(top, "address_bits") or max(8, highest.bit_length())
        public = f"public {name}() {{\nGATEWAY(ADDRESS_BITS={bits}, DATA_BITS={self._bits});\n{body}}}\n"
        enumerations = [f"enum {name} {{ {values} }}\n" for name, values in self._enumerations.items()]
        components = [f"{doc_lines(self._docs[name])}{name}(){body}" for body, name in self._components.items()]
        pieces = [doc_lines(part.doc) + public, groups, *enumerations, *components]
        return format_text("\n".join(piece for piece in pieces if piece))

    # From SystemRDL's own tree

    def _part(self, node: Any) -> _Part:
        part = _Part(node.type_name or node.inst_name, doc=_desc(node))
        for child in node.children(unroll=False):
            kind = type(child).__name__
            if kind == "RegNode":
                self._add_register(part, child)
            elif kind == "MemNode":
                self._add_memory(part, child)
            elif kind in {"RegfileNode", "AddrmapNode"}:
                part.members.append(self._placed(child, self._part(child)))
        return part

    def _placed(self, node: Any, part: _Part) -> _Placed:
        address = self._word(node.raw_address_offset, node)
        if not node.is_array:
            return _Placed(node.inst_name, part, address)
        count = node.n_elements
        return _Placed(node.inst_name, part, address, count, self._word(node.array_stride, node))

    def _word(self, byte_address: int, node: Any) -> int:
        """Return the word address of a byte address."""
        address, rest = divmod(byte_address, self._bits // 8)
        if rest:
            where = f"byte {byte_address:#x}, which is not at the beginning of a word of {self._bits} bits"
            raise UnsupportedError(f"{node.get_path()} is at {where}")
        return address

    def _add_memory(self, part: _Part, node: Any) -> None:
        address = self._word(node.raw_address_offset, node)
        size = max(1, node.total_size * 8 // self._bits)
        part.memories.append(
            f"{doc_lines(_desc(node))}{_name(node.inst_name)}: MEMORY(BASE={address:#x}, SIZE={size});\n"
        )

    def _add_register(self, part: _Part, node: Any) -> None:
        fields = [found for one in node.fields() if (found := self._field(one)) is not None]
        if node.is_array or len(fields) > 1:
            inner = _Part(node.type_name or node.inst_name, [*fields], doc=_desc(node))
            part.members.append(self._placed(node, inner))
        elif fields:
            (only,) = fields
            only.name = node.inst_name
            only.address += self._word(node.raw_address_offset, node)
            only.doc = "\n".join(filter(None, (_desc(node), only.doc)))
            part.members.append(only)

    def _field(self, node: Any) -> _Field | None:
        reads, writes = node.is_sw_readable, node.is_sw_writable
        if not reads and not writes:
            return None
        access = Access.READWRITE if reads and writes else Access.READ if reads else Access.WRITE
        address, low = divmod(node.lsb, self._bits)
        if low + node.width > self._bits and low:
            raise UnsupportedError(f"{node.get_path()} goes over the end of a word of {self._bits} bits")
        whole = low == 0 and node.width >= self._bits
        bits = "" if whole else f"[{low}]" if node.width == 1 else f"[{low + node.width - 1}:{low}]"
        doc = "\n".join(filter(None, (_desc(node), *_effects(node))))
        return _Field(node.inst_name, address, bits, self._kind(node), access, [], doc)

    def _kind(self, node: Any) -> str:
        encode = node.get_property("encode")
        if encode is not None:
            return f"{self._enumeration(encode)} {node.width}"
        properties = node.list_properties(list_all=True)
        signed = "is_signed" in properties and node.get_property("is_signed")
        fraction = node.get_property("fracwidth") if "fracwidth" in properties else None
        if fraction is not None and 0 <= fraction <= node.width:
            return f"{'fixed' if signed else 'ufixed'} {node.width - fraction}.{fraction}"
        if signed:
            return f"signed {node.width}"
        return "bool" if node.width == 1 else f"unsigned {node.width}"

    def _enumeration(self, encode: Any) -> str:
        values = values_text((_name(member.name), member.value, member.rdl_desc or "") for member in encode)
        name = _name(encode.type_name.removesuffix("_e") or encode.type_name)
        return self._named(f"{name}_" if name in _KINDS else name, values)

    def _named(self, name: str, values: str) -> str:
        """Return the name of the enumeration of these values, where that name is free."""
        while self._enumerations.setdefault(name, values) != values:
            name += "_"
        self._names.add(name)
        return name

    # From the paths of our own export

    def _part_of_paths(self) -> _Part:
        whole = _Part("top", doc=_desc(self._top))
        registers = [node for node in self._top.descendants() if type(node).__name__ == "RegNode"]
        fields = [node for register in registers for node in register.fields()]
        # The signals of groups have the order that their groups have, and the others follow by their addresses.
        last = len(fields)
        for node in sorted(fields, key=lambda node: last if (place := self._ours(node, "order")) is None else place):
            path = self._ours(node, "path")
            found = self._field(node) if path else None
            if path is None or found is None:
                continue
            *components, found.name = re.sub(r"\[(\d+)\]", r"_\1", path).split(".")
            part = whole
            for name in components:
                part = _part_named(part, name)
            self._complete(found, node, path)
            found.address += self._word(node.parent.absolute_address, node.parent)
            part.members.append(found)
        _rebase(whole)
        return whole

    def _complete(self, found: _Field, node: Any, path: str) -> None:
        """Add to a field what our own properties tell of it."""
        kind, values = self._ours(node, "kind"), self._ours(node, "values")
        if kind is not None and node.get_property("encode") is None:
            word, _, bits = kind.partition(" ")
            found.kind = kind if values is None else f"{self._named(word, values)} {bits}"
            width = sum(int(part) for part in re.findall(r"\d+", bits)) or 1
            # A signal of several words is as wide as its kind; its field is only the first of them.
            if width > self._bits:
                found.bits = ""
        arguments = self._ours(node, "arguments")
        # The port of a queue has the whole word, however wide its values are.
        if arguments is not None and re.search(r"(^|, )FIFO", arguments):
            found.bits = ""
        identity, unit = self._ours(node, "id"), self._ours(node, "unit")
        if identity is not None and identity != path:
            found.arguments.append(f"ID={_quoted(identity)}")
        found.arguments += filter(None, [arguments])
        if unit is not None:
            found.arguments.append(f"UNIT={_quoted(unit)}")
        found.doc = _desc(node)

    def _ours(self, node: Any, name: str) -> Any:
        """Return one of our own properties; None where the node has it not."""
        name = f"ul_{name}"
        return node.get_property(name) if name in node.list_properties(list_all=True) else None

    # Writing

    def _body(self, part: _Part, base: str) -> str:
        members = (
            self._signal(one, base) if isinstance(one, _Field) else self._placement(one, base) for one in part.members
        )
        return "".join([*part.memories, *members])

    def _signal(self, one: _Field, base: str) -> str:
        address = f"{base}{one.address:#x}" if not base or one.address else "base"
        declaration = f"{one.kind} {one.access}({', '.join(one.arguments)})"
        return f"{doc_lines(one.doc)}@{_name(one.name)} = {address}{one.bits}: {declaration};\n"

    def _placement(self, placed: _Placed, base: str) -> str:
        type_name = self._component(placed.part)
        address = f"{base}{placed.address:#x}"
        count = "" if placed.count is None else f"[{placed.count}]"
        step = "" if placed.count is None else f" + {placed.stride:#x} * i"
        return f"{_name(placed.name)}{count}: {type_name}() @({address}{step});\n"

    def _component(self, part: _Part) -> str:
        body = f": @(base) {{\n{self._body(part, 'base + ')}}}\n"
        found = self._components.get(body)
        if found is None:
            found = self._components[body] = unique_name(_name(part.type_name), self._names)
            self._docs[found] = part.doc
        return found


def _part_named(around: _Part, name: str) -> _Part:
    """Return the part of a name, which is put into the part around where it is not there yet."""
    for one in around.members:
        if isinstance(one, _Placed) and one.name == name:
            return one.part
    made = _Placed(name, _Part(name), 0)
    around.members.append(made)
    return made.part


def _rebase(part: _Part) -> None:
    """Make the absolute addresses in a part's parts relative to the lowest one of each."""
    for placed in part.members:
        if isinstance(placed, _Placed):
            _rebase(placed.part)
            inner = placed.part.members
            placed.address = min(one.address for one in inner)
            for one in inner:
                one.address -= placed.address


def _effects(node: Any) -> Iterator[str]:
    """Yield the side effects of reading or writing, which UL-spec has no word for."""
    for word, name in (("Reading", "onread"), ("Writing", "onwrite")):
        effect = node.get_property(name)
        if effect is not None:
            yield f"{word} it has an effect: {effect.name}."


def _desc(node: Any) -> str:
    desc: str | None = node.get_property("desc")
    return desc or ""


def _name(name: str) -> str:
    return f"{name}_" if name in _RESERVED else name


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t")
    return f'"{escaped}"'
