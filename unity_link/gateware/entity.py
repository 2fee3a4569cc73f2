"""Reads entities and operators from the syntax tree that GHDL writes in XML."""

from __future__ import annotations

from typing import NamedTuple
from xml.etree import ElementTree as ET


class Generic(NamedTuple):
    """A generic of an entity."""

    has_default: bool
    base: str
    """Base type, such as integer."""


class PortType(NamedTuple):
    """A port of an entity."""

    base: str
    """Base type, such as std_ulogic_vector or unresolved_unsigned; empty for a type without a name."""
    bounds: ET.Element | None
    """Range of a vector; None for other ports."""

    def indexes(self, count: int) -> tuple[int, ...] | None:
        """Return the indexes of a vector, rightmost element first.

        None for other ports, and for a range whose ends are not numbers.

        Args:
            count: number of elements.
        """
        if self.bounds is None:
            return None
        step = -1 if self.bounds.get("direction") == "to" else 1
        for end in ("right", "left"):
            limit = self.bounds.find(f"{end}_limit_expr")
            if limit is not None and limit.get("kind") == "integer_literal":
                right = int(str(limit.get("value"))) - (step * (count - 1) if end == "left" else 0)
                return tuple(right + step * place for place in range(count))
        return None


class Entity(NamedTuple):
    """Generics and ports of an entity, by name in small letters."""

    generics: dict[str, Generic]
    ports: dict[str, PortType]


class SyntaxTree:
    """The syntax tree of some files, as GHDL writes it in XML."""

    def __init__(self, text: str) -> None:
        self._tree = ET.fromstring(text)  # noqa: S314  (of GHDL's own writing)
        self._by_id = {element.get("id"): element for element in self._tree.iter() if element.get("id")}

    def entities(self) -> dict[str, Entity]:
        """Return the entities by name in small letters."""
        return {
            str(unit.get("identifier")): Entity(
                {
                    str(one.get("identifier")): Generic(one.find("default_value") is not None, self._base_of(one))
                    for one in unit.iterfind("generic_chain/el")
                },
                {str(one.get("identifier")): self._port_of(one) for one in unit.iterfind("port_chain/el")},
            )
            for unit in self._tree.iter("library_unit")
            if unit.get("kind") == "entity_declaration"
        }

    def operators(self, function: str) -> set[tuple[str, str, str]]:
        """Return file, line and column of each operator that GHDL resolves to one of its predefined functions.

        Args:
            function: GHDL's name of the function.
        """
        return {
            (str(element.get("file")), str(element.get("line")), str(element.get("col")))
            for element in self._tree.iter()
            if str(element.get("kind")).endswith("_operator")
            and (declared := self._referred(element, "implementation")) is not None
            and declared.get("implicit_definition") == function
        }

    def _referred(self, element: ET.Element, tag: str) -> ET.Element | None:
        reference = element.find(tag)
        return None if reference is None else self._by_id.get(reference.get("ref"))

    def _base_of(self, declared: ET.Element) -> str:
        kind, base = self._referred(declared, "type"), ""
        while kind is not None:
            declarator = self._referred(kind, "type_declarator")
            base = base if declarator is None else str(declarator.get("identifier"))
            kind = self._referred(kind, "parent_type")
        return base

    def _port_of(self, port: ET.Element) -> PortType:
        kind = self._referred(port, "type")
        bounds = None if kind is None else kind.find("index_constraint_list/el/range_constraint")
        return PortType(self._base_of(port), bounds)
