"""The syntax tree of a VHDL-2008 file, by the grammar of tree-sitter-vhdl: a parser independent of GHDL."""

from __future__ import annotations

from typing import TYPE_CHECKING

import tree_sitter_vhdl
from tree_sitter import Language, Parser

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tree_sitter import Node

_PARSER = Parser(Language(tree_sitter_vhdl.language()))


def parse(text: str) -> Node:
    """Return the root of a file's tree; text that is not VHDL is an error node in it."""
    return _PARSER.parse(text.encode()).root_node


def nodes(node: Node) -> Iterator[Node]:
    """Yield a node and all below it, in the order of the text."""
    yield node
    for below in node.children:
        yield from nodes(below)


def child(node: Node, kind: str) -> Node | None:
    """Return the first child of a node that has this kind, or None."""
    return next((below for below in node.named_children if below.type == kind), None)


def is_within(node: Node, kind: str, end: Node) -> bool:
    """Return whether an ancestor of a node, up to but without `end`, has this kind."""
    parent = node.parent
    while parent is not None and parent != end:
        if parent.type == kind:
            return True
        parent = parent.parent
    return False


def text_of(node: Node) -> str:
    """Return the text of a node in the file."""
    return (node.text or b"").decode()
