"""The parts of datasheets that are derived from the sources, and their pictures: written by `make datasheets`.

The page of an entity is in docs/reference/gateware, the page of a core is the `README.md` of its folder. A page is
written by hand, except the parts between comments that name their contents: the tables of generics and ports, from the
VHDL; size and speed, from `gateware/RESULTS.md` and `gateware/mapped.json`; the files of constraints. Pictures are
drawn from simulations (`gateware.bench.datasheets`). Tests compare both with the sources of today.

The pages of generated entities show those of one example spec (`gateware.tools.generated`).

    python -m gateware.tools.datasheets
"""

from __future__ import annotations

import re
import sys
from typing import TYPE_CHECKING

from gateware.tools import generated, mapped, parser_of
from gateware.tools.cores import cores
from gateware.tools.entity import Entity, Group, read_entity
from gateware.tools.synth import CONFIGURATIONS, DEVICES, rows
from unity_link.gateware.cache import GATEWARE, board_sources, vhdl_sources

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence
    from pathlib import Path

PAGES = GATEWARE.parent / "docs" / "reference" / "gateware"
_PART = re.compile(r"(<!-- Written by `make datasheets`, (\w+)((?: \w+)*): begin -->\n).*?(<!-- end -->)", re.DOTALL)
# # A literal, or a name that no English sentence contains: with an underscore, or of a clock.
_CODE = re.compile(r"""'[01]'|"\w+"|\b[a-z\d]+_[a-z\d_]+|\bclk(?:out)?\b""")
_WHOLE_TEXT = re.MULTILINE | re.DOTALL
_ALL = re.compile(r"^\(others => (.+)\)$")
_CONSTRAINTS = GATEWARE / "constraints"
_WHOLE = {
    "Quartus": ["quartus/unity_link.sdc"],
    "Gowin EDA": ["gowin/unity_link.sdc"],
    "Diamond": ["lattice/unity_link.lpf"],
    "Radiant": ["lattice/unity_link.pdc"],
    "Efinity": ["efinity/unity_link.sdc"],
}
"""Files for all entities, for tools that have one file each."""
_PINS_OF_PHY = {
    "Quartus": "quartus/MEDIUM_pins.sdc",
    "Gowin EDA": "gowin/MEDIUM_pins.sdc",
    "Diamond": "lattice/MEDIUM_pins.lpf",
    "Radiant": "lattice/MEDIUM_pins.pdc",
    "Efinity": "efinity/MEDIUM_pins.sdc",
}
"""The files for the pins of a PHY, for each of `rmii`, `mii` and `rgmii`."""


def entity(name: str) -> Entity:
    """Return an entity of the gateware, of its boards, or of the generated VHDL.

    Raises:
        ValueError: if there is no entity of this name, or a generic or port of it has no comment.
    """
    return read_entity(_text_of(name), name, entity)


def _text_of(name: str) -> str:
    """Return the text of the file of an entity.

    Raises:
        ValueError: if there is no file of its name.
    """
    if name in generated.ENTITIES:
        return generated.texts()[name]
    for source in [*vhdl_sources(), *board_sources()]:
        if source.stem == name:
            return source.read_text()
    raise ValueError(f"{name} is in no file of its name")


def sheets() -> dict[str, Path]:
    """Return the page of each entity that has one, by its name; the page of a core is the `README.md` in its folder."""
    by_hand = {path.stem: path for path in sorted(PAGES.glob("*.md")) if path.stem != "index"}
    return by_hand | {core.entity: core.folder / "README.md" for core in cores()}


def filled(name: str) -> str:
    """Return the page of an entity with its derived parts written anew."""
    return _PART.sub(lambda part: _written(name, part), sheets()[name].read_text())


def _written(name: str, part: re.Match[str]) -> str:
    write = _PARTS[part[2]]
    lines = write(name, part[3].split())
    return "\n".join([part[1], *lines, "", part[4]]).replace("\n\n\n", "\n\n")


def _generics(name: str, _: Sequence[str]) -> list[str]:
    rows = [
        (
            _stacked([*(f"`{generic.name}`" for generic in group.declarations), group.declarations[0].type]),
            _marked(group.range),
            _stacked(f"`{generic.default}`" if generic.default else "" for generic in group.declarations),
            _marked(group.meaning),
        )
        for group in entity(name).generics
    ]
    return _table(("generic and its type", "range", "default", "meaning"), rows)


def _ports(name: str, _: Sequence[str]) -> list[str]:
    groups = entity(name).ports
    rows = [
        (
            _stacked(f"`{port.name}`" for port in group.declarations),
            _stacked(port.direction for port in group.declarations),
            _stacked(port.width for port in group.declarations),
            f"`{group.clock}`" if group.clock else "-",
            _with_defaults(group),
        )
        for group in groups
    ]
    return _table(("port", "direction", "bits", "clock", "meaning"), rows)


def _with_defaults(group: Group) -> str:
    """Return the meaning of ports, and the values of inputs that are left open."""
    defaults = sorted({_ALL.sub(r"\1", port.default) for port in group.declarations if port.default})
    return _marked(group.meaning) + (
        f" Left open: {', '.join(f'`{default}`' for default in defaults)}." if defaults else ""
    )


def _marked(text: str) -> str:
    """Return a sentence with the VHDL in it marked as code."""
    return _CODE.sub(lambda found: f"`{found[0]}`", text)


def _resources(_: str, configurations: Sequence[str]) -> list[str]:
    placed, lines = rows(), []
    for name, device in DEVICES.items():
        for configuration in configurations:
            if (row := placed.get((configuration, name))) is not None:
                logic = f"{row.result.logic} {device.logic_title}"
                figures = logic, str(row.result.memory), f"{row.result.slowest:.1f} MHz"
                lines.append((f"`{configuration}`", device.title, *figures))
    lines += _mapped(configurations)
    chosen = [
        f"- `{name}`: {', '.join(f'`{generic}` {_plain(value)}' for generic, value in generics.items())}"
        for name in configurations
        if (generics := CONFIGURATIONS[name].generics)
    ]
    return [*_table(("configuration", "family", "logic", "RAM blocks", "Fmax"), lines), "", *chosen]


def _mapped(configurations: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Yield a row for each family that is mapped but not placed, and each configuration that was mapped."""
    found = mapped.results()
    for name, target in mapped.TARGETS.items():
        for configuration in configurations:
            if configuration in found:
                cells = dict(found[configuration].cells[name])
                blocks = cells.pop(mapped.RAM_BLOCKS)
                logic = ", ".join(f"{count} {kind}" for kind, count in cells.items() if count)
                yield f"`{configuration}`", target.title, logic, str(blocks), "mapped, not placed"


def _plain(value: object) -> str:
    if not isinstance(value, str):
        return str(value).lower()
    return f'x"{int(value, 2):08X}"' if set(value) <= {"0", "1"} else f'"{value}"'


def _constraints(name: str, _: Sequence[str]) -> list[str]:
    below = sorted(_with_all_below(name))
    scoped = [f"`vivado/{part}.xdc`" for part in below if (_CONSTRAINTS / "vivado" / f"{part}.xdc").exists()]
    pins = [
        f"`vivado/{entity}_pins.xdc` once for the top"
        for entity, chip in (("ul_ft245_sync", "ul_ft245_sync"), ("ul_mac_MEDIUM", "ul_mac"))
        if chip in below
    ]

    def of_phy(tool: str) -> list[str]:
        return [_PINS_OF_PHY[tool]] if "ul_mac" in below else []

    if not scoped:
        return ["Only the period of its clock: it has no clock domain crossing."]
    rows = [
        ("Vivado", ", ".join([*scoped, *pins])),
        *((tool, ", ".join(f"`{path}`" for path in (*paths, *of_phy(tool)))) for tool, paths in _WHOLE.items()),
    ]
    return [
        "The period of each clock, and these files of `gateware/constraints`. Its `README.md` describes them; they are",
        "untested with the vendors' tools." + " MEDIUM is `rmii`, `mii` or `rgmii`." * ("ul_mac" in below),
        "",
        *_table(("tool", "files"), rows),
    ]


def _records(*_: object) -> list[str]:
    """Return the records for the hardware's side of a generated entity."""
    found = re.findall(
        r"^  (type \w+ is record\n.*?end record \w+;)$", generated.texts()[generated.PACKAGE], _WHOLE_TEXT
    )
    return ["```vhdl", *"\n\n".join(found).replace("\n  ", "\n").split("\n"), "```"]


_PARTS: dict[str, Callable[[str, Sequence[str]], list[str]]] = {
    "generics": _generics,
    "ports": _ports,
    "records": _records,
    "resources": _resources,
    "constraints": _constraints,
}


def _with_all_below(name: str) -> set[str]:
    """Return the names of an entity and of all entities below it."""
    found: set[str] = set()
    waiting = [name]
    while waiting:
        part = waiting.pop()
        if part not in found:
            found.add(part)
            waiting += entity_names(part)
    return found


def entity_names(name: str) -> list[str]:
    """Return the names of the entities that an entity instantiates."""
    return re.findall(r"\bentity (?:work|unity_link)\.(\w+)", _text_of(name))


def _stacked(lines: Iterable[str]) -> str:
    return "<br>".join(lines)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    return ["| " + " | ".join(cells) + " |" for cells in (head, ["---"] * len(head), *rows)]


def main() -> int:
    """Write all pages and pictures, and return the exit status."""
    parser_of(__doc__).parse_args()
    from gateware.bench.datasheets.stories import PICTURES, pictures

    for name, page in sheets().items():
        page.write_text(filled(name))
        sys.stdout.write(f"{name}\n")
    PICTURES.mkdir(parents=True, exist_ok=True)
    for name, text in pictures().items():
        (PICTURES / name).write_text(text)
        sys.stdout.write(f"{name}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
