"""Names of a spec as VHDL takes them: of any case, never a reserved word, each once in its scope.

A word of SystemVerilog is none either: the names of ports become names in Verilog.
"""

from __future__ import annotations

import re

from unity_link.gateware.words import SYSTEMVERILOG

RESERVED = frozenset(
    """abs access after alias all and architecture array assert assume assume_guarantee attribute begin block body
    buffer bus case component configuration constant context cover default disconnect downto else elsif end entity exit
    fairness file for force function generate generic group guarded if impure in inertial inout is label library linkage
    literal loop map mod nand new next nor not null of on open or others out package parameter port postponed private
    procedure process property protected pure range record register reject release rem report restrict
    restrict_guarantee return rol ror select sequence severity shared signal sla sll sra srl strong subtype then to
    transport type unaffected units until use variable view vmode vprop vunit wait when while with xnor xor""".split()  # noqa: SIM905  (a line for each word would be a page)
)
"""Words of VHDL up to its version of 2019."""
TYPES = frozenset({"std_logic", "std_logic_vector", "unsigned", "signed"})
"""Names that an element of a record would hide from the elements behind it; our own types end with ``_t``."""


def identifier(text: str) -> str:
    """Write a name or a path of a spec in small letters, as VHDL allows: ``legs[2].__Pos`` is ``legs_2_pos``.

    A word of VHDL or of SystemVerilog, or the name of a type, gets ``_x`` behind it.
    """
    name = _letters(text)
    return f"{name}_x" if name in RESERVED | SYSTEMVERILOG | TYPES or name.endswith("_t") else name


def _letters(text: str) -> str:
    name = re.sub(r"[\W_]+", "_", text).strip("_").lower() or "x"
    return name if name[0].isalpha() else f"x_{name}"


class Scope:
    """The names that are taken in one region of VHDL text."""

    def __init__(self, *taken: str) -> None:
        self._taken = set(taken)

    def take(self, *names: str) -> None:
        """Take names as they are."""
        self._taken.update(names)

    def unique(self, text: str, *endings: str) -> str:
        """Return a name for a text, numbered where it is taken.

        Args:
            text: a name or a path of a spec.
            endings: what stands behind the name wherever it is used; an empty one where it is used by itself.
        """
        endings = endings or ("",)
        name = first = identifier(text) if "" in endings else _letters(text)
        number = 1
        while any(name + ending in self._taken for ending in endings):
            number += 1
            name = f"{first}_{number}"
        self._taken.update(name + ending for ending in endings)
        return name
