"""Names of a spec as identifiers of VHDL: in lower case, not reserved, and unique in their scope.

Words of SystemVerilog are avoided too, because names of ports become names in Verilog.
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
"""Reserved words of VHDL, up to VHDL-2019."""
TYPES = frozenset({"std_logic", "std_logic_vector", "unsigned", "signed"})
"""Types that an element of a record would hide from later elements; generated types end in ``_t``."""


def identifier(text: str) -> str:
    """Return a name or path as an identifier of VHDL in lower case: ``legs[2].__Pos`` becomes ``legs_2_pos``.

    A reserved word of VHDL or SystemVerilog, or a name of a type, gets ``_x`` appended.
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
        """Add names to the taken ones, unchanged."""
        self._taken.update(names)

    def unique(self, text: str, *endings: str) -> str:
        """Return a unique name for a text, numbered if it is taken, and add it to the taken ones.

        Args:
            text: a name or a path of a spec.
            endings: endings that are appended to the name where it is used; "" if it is also used without one.
        """
        endings = endings or ("",)
        name = first = identifier(text) if "" in endings else _letters(text)
        number = 1
        while any(name + ending in self._taken for ending in endings):
            number += 1
            name = f"{first}_{number}"
        self._taken.update(name + ending for ending in endings)
        return name
