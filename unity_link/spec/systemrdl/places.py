"""Places in SystemRDL for diagnostics, and the paths of its nodes in a spec."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.spec.diagnostics import NOWHERE, Diagnostic, Severity, Span

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from systemrdl.node import AddressableNode, Node
    from systemrdl.source_ref import SourceRefBase


def diagnostic(severity: Severity, code: str, message: str, where: SourceRefBase | None, file: str = "") -> Diagnostic:
    """Return a diagnostic at a place that the SystemRDL compiler reports.

    Args:
        severity: of the diagnostic.
        code: of the rule.
        message: one sentence.
        where: the compiler's reference to a source; None if it has none.
        file: file to name if the compiler names none.
    """
    from systemrdl.source_ref import DetailedFileSourceRef

    if not isinstance(where, DetailedFileSourceRef):
        return Diagnostic(severity, code, message, Span(file, 1, 1, 1, 1) if file else NOWHERE)
    first, last = where.line_selection
    span = Span(str(where.path), where.line, first + 1, where.line, last + 2)
    return Diagnostic(severity, code, message, span, where.line_text.rstrip())


def about(severity: Severity, code: str, message: str, node: Node) -> Diagnostic:
    """Return a diagnostic at the place where a node is instantiated; for the top node, at its declaration."""
    return diagnostic(severity, code, message, node.inst_src_ref or node.def_src_ref)


def chain(node: Node) -> list[Node]:
    """Return a node and the nodes around it without the top node, the outermost first."""
    nodes = []
    while node.parent is not None and node.parent.parent is not None:
        nodes.append(node)
        node = node.parent
    return nodes[::-1]


def flat_path(node: Node) -> str:
    """Return the path of a node without array indices; all elements of an array have the same."""
    path: str = node.get_path(array_suffix="", empty_array_suffix="")
    return path


def spec_path(node: Node, names: Mapping[str, str]) -> str:
    """Return the path of one field in the spec; `names` has the names of the field and the nodes around it."""
    return ".".join(_items(node, names))


def _items(node: Node, names: Mapping[str, str]) -> Iterator[str]:
    from systemrdl.node import AddressableNode

    for one in chain(node):
        name = names[flat_path(one)]
        if not name:
            continue
        yield f"{name}[{_flat_index(one)}]" if isinstance(one, AddressableNode) and one.is_array else name


def _flat_index(node: AddressableNode) -> int:
    """Return the index of an element in the one-dimensional array that replaces an array of several dimensions."""
    index = 0
    for place, size in zip(node.current_idx or (), node.array_dimensions or (), strict=True):
        index = index * size + place
    return index
