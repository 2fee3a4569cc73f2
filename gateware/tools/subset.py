"""Reads VHDL-2008 with another parser than GHDL's, and reports constructs that vendors' synthesis tools do not support.

The references are the tables of supported constructs in UG901 (Vivado) and in the help of Quartus Prime Standard; if
they differ, the stricter one applies. The parser is the grammar of tree-sitter-vhdl. An expression counts as variable
if it mentions a signal, a variable or a port of its file.

    python -m gateware.tools.subset [FILE ...]        the gateware, or files
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from gateware.tools import parser_of
from gateware.tools.syntax import child, is_within, nodes, parse, text_of
from unity_link.gateware.cache import GATEWARE, vhdl_sources

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tree_sitter import Node

_REFUSED = {
    "else_generate": "an `else generate` (write a second `if generate`)",
    "elsif_generate": "an `elsif generate` (write a second `if generate`)",
    "case_generate_statement": "a `case generate` (write `if generate`)",
    "external_signal_name": "an external name",
    "external_constant_name": "an external name",
    "external_variable_name": "an external name",
    "simple_force_assignment": "a `force`",
    "simple_release_assignment": "a `release`",
    "conditional_signal_assignment": "a conditional assignment in a process: write `if`",
    "selected_waveform_assignment": "a selected assignment in a process: write `case`",
    "selected_variable_assignment": "a selected assignment of a variable: write `case`",
    "guard_condition": "a guarded block",
    "disconnection_specification": "a `disconnect`",
    "wait_statement": "a `wait` (registers are described by `rising_edge`)",
    "entity_body": "statements in an entity",
    "protected_type_declaration": "a protected type",
    "file_declaration": "a file",
    "access_type_definition": "an access type",
    "physical_type_definition": "a physical type",
    "context_declaration": "a context declaration",
    "context_reference": "a context",
    "interface_package_declaration": "a generic package",
    "package_instantiation_declaration": "an instance of a package",
    "subprogram_instantiation_declaration": "an instance of a subprogram",
    "block_comment": "a comment of `/*`",
    "condition_conversion": "a `??`",
    "delay_mechanism": "a delay",
    "library_constant_unit": "a time",
    "mode_view_declaration": "a view of VHDL-2019",
}
_DIVIDING = ("mod", "rem", "/")
# Conversions of a vector to another type, without logic; VHDL-93 permits them in port maps.
_CONVERSIONS = ("std_logic_vector", "unsigned", "signed")
_MOVING = ("signal_declaration", "variable_declaration", "interface_variable_declaration")
_OPERATORS = ("adding_operator", "multiplying_operator", "unary_operator", "logical_operator", "relational_operator")


class Fault(NamedTuple):
    """Construct that a tool does not support."""

    line: int
    sentence: str


def faults(text: str) -> list[Fault]:
    """Return the unsupported constructs of a VHDL file, in the order of its lines; none if every tool reads it."""
    root = parse(text)
    broken = [Fault(_line(node), "it is no VHDL-2008") for node in nodes(root) if node.is_error or node.is_missing]
    moving = set(_moving(root))
    functions = {
        text_of(name).lower()
        for node in nodes(root)
        if node.type == "function_specification" and (name := child(node, "identifier")) is not None
    }
    found = [fault for node in nodes(root) for fault in _of(node, moving, functions)]
    return sorted({*broken, *found})


def _of(node: Node, moving: set[str], functions: set[str]) -> Iterator[Fault]:
    line = _line(node)
    if node.type in _REFUSED:
        yield Fault(line, f"not every tool reads {_REFUSED[node.type]}")
    yield from (Fault(line, sentence) for sentence in (*_arithmetic(node, moving), *_of_2008(node)))
    if node.type == "simple_range" and _is_slice(node):
        bounds = [part for part in node.named_children if part.type == "simple_expression"]
        if len(bounds) == 2 and all(_moves(bound, moving) for bound in bounds):
            yield Fault(line, f"both ends of the slice ({text_of(node)}) move")
    if node.type == "when_element" and node.parent is not None and node.parent.type == "case_statement_alternative":
        for choice in node.named_children:
            if any(part.type in (*_OPERATORS, "parenthesis_group") for part in nodes(choice)):
                yield Fault(_line(choice), f"the choice {text_of(choice)} is an expression: name a constant")
    if node.type == "port_map_aspect":
        yield from _actuals(node, functions)


def _arithmetic(node: Node, moving: set[str]) -> Iterator[str]:
    whole = node.parent
    if whole is None or not _moves(whole, moving):
        return
    left, right = text_of(whole.children[0]), text_of(whole.children[-1])
    if node.type == "multiplying_operator" and text_of(node).lower() in _DIVIDING and not _is_power_of_two(right):
        yield f"{text_of(node)} by {right}, which is no power of two as a number"
    if node.type == "exponentiate" and left != "2":
        yield f"{text_of(whole)} is a power of another number than 2"


def _of_2008(node: Node) -> Iterator[str]:
    if node.type in ("case_expression", "with_expression") and "?" in text_of(node):
        yield "not every tool reads a `case?`"
    if node.type == "relational_operator" and text_of(node).startswith("?"):
        yield f"not every tool reads {text_of(node)}"
    if node.type == "simple_variable_assignment" and any(part.type == "when_expression" for part in nodes(node)):
        yield "not every tool reads a conditional assignment in a process (write `if`)"


def _actuals(node: Node, functions: set[str]) -> Iterator[Fault]:
    for element in (part for part in nodes(node) if part.type == "association_element"):
        actual = element.named_children[-1]
        if is_within(element, "parenthesis_group", node) or actual.type != "conditional_expression":
            continue
        named = re.match(r"(\w+)\s*\(", text_of(actual))
        is_call = any(
            part.type == "library_function" or text_of(part).lower() in functions
            for part in nodes(actual)
            if part.next_named_sibling is not None and part.next_named_sibling.type == "parenthesis_group"
        )
        is_conversion = named is not None and named[1].lower() in _CONVERSIONS
        is_expression = any(part.type in _OPERATORS for part in _outside_indices(actual))
        if (is_call or is_expression) and not is_conversion:
            yield Fault(_line(element), f"the actual {text_of(actual)} is an expression: name a signal")


def _moving(root: Node) -> Iterator[str]:
    """Yield the names of objects whose value can change: signals, variables, ports, and parameters of those classes."""
    for node in nodes(root):
        is_port = node.type in ("interface_declaration", "interface_signal_declaration") and is_within(
            node, "port_clause", root
        )
        if node.type in _MOVING or is_port:
            names = child(node, "identifier_list")
            yield from (text_of(name).lower() for name in (names.named_children if names is not None else ()))


def _moves(node: Node, moving: set[str]) -> bool:
    """Return whether an expression mentions a variable object, other than its length or bounds."""
    text = re.sub(r"\w+'(length|high|low|left|right|range)\b", "", re.sub(r"\.\w+", "", text_of(node)))
    return any(word.lower() in moving for word in re.findall(r"[a-z]\w*", text, re.IGNORECASE))


def _is_slice(node: Node) -> bool:
    return node.parent is not None and node.parent.type == "association_or_range_list"


def _is_power_of_two(text: str) -> bool:
    number = text.replace("_", "")
    return number.isdigit() and int(number).bit_count() == 1


def _outside_indices(node: Node) -> Iterator[Node]:
    yield node
    for part in node.children:
        if part.type != "parenthesis_group":
            yield from _outside_indices(part)


def _line(node: Node) -> int:
    return int(node.start_point[0]) + 1


def main() -> int:
    """Check files, and return the exit status."""
    parser = parser_of(__doc__)
    parser.add_argument("files", nargs="*", type=Path, help="default: the gateware")
    chosen = parser.parse_args().files
    status = 0
    for path in chosen or [*vhdl_sources(), *sorted((GATEWARE / "boards").rglob("*.vhd"))]:
        try:
            text = path.read_text()
        except (OSError, UnicodeDecodeError) as error:
            sys.stderr.write(f"{path} cannot be read: {error}\n")
            status = 1
            continue
        for fault in faults(text):
            sys.stderr.write(f"{path}:{fault.line}: {fault.sentence}\n")
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
