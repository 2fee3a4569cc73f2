"""Places in SystemRDL, as diagnostics name them, and the paths that its nodes get in a spec."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.spec.diagnostics import NOWHERE, Diagnostic, Severity, Span

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping


def diagnostic(severity: Severity, code: str, message: str, where: Any, file: str = "") -> Diagnostic:
    """Return a diagnostic about a place that the SystemRDL compiler names.

    Args:
        severity: of the diagnostic.
        code: of the rule.
        message: one sentence.
        where: the compiler's reference to a source; None where it has none.
        file: the file to be named where the compiler names none.
    """
    line = getattr(where, "line", None)
    if line is None:
        return Diagnostic(severity, code, message, Span(file, 1, 1, 1, 1) if file else NOWHERE)
    first, last = where.line_selection
    span = Span(str(where.path), line, first + 1, line, last + 2)
    return Diagnostic(severity, code, message, span, where.line_text.rstrip())


def about(severity: Severity, code: str, message: str, node: Any) -> Diagnostic:
    """Return a diagnostic at the place where a node is put; of the top, which is put nowhere, where it is declared."""
    return diagnostic(severity, code, message, node.inst_src_ref or node.def_src_ref)


def chain(node: Any) -> list[Any]:
    """Return a node and all around it, the outermost below the top first."""
    nodes = []
    while node.parent is not None and node.parent.parent is not None:
        nodes.append(node)
        node = node.parent
    return nodes[::-1]


def flat_path(node: Any) -> str:
    """Return the path of a node without the indices of arrays, which is that of all elements."""
    path: str = node.get_path(array_suffix="", empty_array_suffix="")
    return path


def spec_path(node: Any, names: Mapping[str, str]) -> str:
    """Return the path that a single field has in a spec, where `names` has the names of all around it."""
    return ".".join(_items(node, names))


def _items(node: Any, names: Mapping[str, str]) -> Iterator[str]:
    for one in chain(node):
        name = names[flat_path(one)]
        if not name:
            continue
        yield name if not getattr(one, "is_array", False) else f"{name}[{_flat_index(one)}]"


def _flat_index(node: Any) -> int:
    """Return the index in the one array that SystemRDL's array of several dimensions becomes."""
    index = 0
    for place, size in zip(node.current_idx, node.array_dimensions, strict=True):
        index = index * size + place
    return index
