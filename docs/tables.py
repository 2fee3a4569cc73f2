"""The tables and listings of pages that follow from the sources: written by `make docs-tables`.

They are in the pages themselves, so that they can be read without building anything, each between a comment that names
its contents and `<!-- end -->`. A test compares each page with the output of this module.

    python -m docs.tables
"""

from __future__ import annotations

import importlib
import inspect
import re
import shlex
import sys
import textwrap
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from docs.walkthrough import PAGES
from unity_link.boards import loading
from unity_link.boards.board import CHAIN
from unity_link.boards.loading import board_names, load_board
from unity_link.cli.families import PANELS
from unity_link.cores import RobotVerbs, Verbs, classes_of
from unity_link.spec import compile_text
from unity_link.spec.cores import core_folders
from unity_link.spec.diagnostics import Reporter
from unity_link.spec.loading import Loader

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence

    from unity_link.spec.model import ComponentSpec

ROOT = Path(__file__).parents[1]
_BOARDS = Path(loading.__file__).with_name("data")
SYMBOL = "core-{}.svg"
"""Name of the picture of a core, by the name of its folder."""
_PART = re.compile(r"(<!-- Written by `make docs-tables`, (\w+)( .*?)?: begin -->\n).*?(<!-- end -->\n)", re.DOTALL)
_DIRECTIVES = re.compile(r"^<!-- \{eval-rst\}\n(.*?)^-->$", re.DOTALL | re.MULTILINE)
_DIRECTIVE = re.compile(r"^\.\. auto(\w+):: ([\w.]+)(?:\(\))?\n((?:   :.*\n)*)", re.MULTILINE)
_WAYS = {"IN": "in", "OUT": "out", "INOUT": "in, out"}
_ACCESS = {"READ": "r", "WRITE": "w", "READWRITE": "rw"}
_INSTALLED = "unity_link"


class CoreEntry(NamedTuple):
    """A core that is installed with the package."""

    word: str
    folder: str
    """Name of its folder in `gateware/cores`."""
    parameters: dict[str, str]
    """Defaults of the parameters, as the map has them; empty for a parameter without one."""
    component: ComponentSpec


class Call(NamedTuple):
    """A public method of a core's Python API."""

    owner: str
    name: str
    code: str
    """The call, as a program writes it."""
    summary: str


def filled(page: Path) -> str:
    """Return the text of a page with its written parts as they should be."""
    text = page.read_text(encoding="utf-8")

    def written(part: re.Match[str]) -> str:
        lines = _PARTS[part[2]](shlex.split(part[3] or ""), text[part.end() :])
        return "\n".join([part[1], *lines, "", part[4]])

    return _PART.sub(written, text)


def installed_cores() -> list[CoreEntry]:
    """Return the cores that are installed with the package, in the order of their words."""
    *_, installed = core_folders(None)
    found = []
    for word, (folder, *_) in sorted(installed.items()):
        loader = Loader(Reporter())
        text = folder.map.read_text(encoding="utf-8")
        loader.load(folder.map.name, text, folder.map)
        parameters = {
            str(one.name): "" if one.default is None else text[one.default.start : one.default.end]
            for one in loader.declarations.components[word].node.parameters
        }
        (component,) = compile_text(f"public one() {{ core: {word}() @(0); }}").interface().cores
        found.append(CoreEntry(word, folder.path.name, parameters, component))
    return found


def calls_of(core: CoreEntry) -> list[Call]:
    """Return the Python API of a core: its methods, those of a robot with it, and those of the objects they return."""
    verbs: list[tuple[str, type]] = [
        (f"robot.{core.word.lower()}", kind) for kind in classes_of(core.component.core, Verbs)
    ]
    verbs += [("robot", kind) for kind in classes_of(core.component.core, RobotVerbs)]
    calls = [call for owner, kind in verbs for call in _methods(owner, kind)]
    returned = dict.fromkeys(_returns(method) for _, kind in verbs for method in vars(kind).values())
    for name in (name for name in returned if name in _RETURNED):
        owner, place, chosen = _RETURNED[name]
        calls += [
            call for call in _methods(owner, getattr(importlib.import_module(place), name)) if call.name in chosen
        ]
    return calls


_RETURNED = {
    "Lease": ("lease", "unity_link.cores.lease", {"each", "kick"}),
    "TickClock": ("clock", "unity_link.cores.clock", {"now", "at", "sampled", "time_of"}),
    "Timeline": ("line", "unity_link.cores.timeline", {"set", "delay", "flush"}),
}
"""The objects that methods of cores return, by their classes: a name in programs, the module, methods for programs."""


def _methods(owner: str, kind: type) -> list[Call]:
    """Return the public methods that a class defines."""
    return [
        Call(owner, name, f"{'await ' * _is_awaited(method)}{owner}.{name}({_given(method)})", _summary(method))
        for name, method in vars(kind).items()
        if inspect.isfunction(method) and not name.startswith("_")
    ]


def _returns(method: object) -> str:
    """Return the annotation of the result of a method; empty for another object."""
    return str(inspect.signature(method).return_annotation) if inspect.isfunction(method) else ""


def _is_awaited(method: object) -> bool:
    return inspect.iscoroutinefunction(method) or _returns(method).startswith("Coroutine")


def _given(method: Callable[..., Any]) -> str:
    """Return the arguments of a method, with their defaults and without their types."""
    given = inspect.signature(method)
    bare = [
        parameter.replace(annotation=inspect.Parameter.empty)
        for name, parameter in given.parameters.items()
        if name != "self"
    ]
    return str(inspect.Signature(bare)).strip("()").replace("'", '"')


def _summary(item: object) -> str:
    """Return the first sentence of a docstring, in one line."""
    paragraph = " ".join((inspect.getdoc(item) or "").partition("\n\n")[0].split())
    return paragraph.replace("``", "`").replace("|", "\\|")


def _cores(_: Sequence[str], __: str) -> list[str]:
    rows = []
    for core in installed_cores():
        component, sheet = core.component, f"../../../gateware/cores/{core.folder}/README.md"
        about = " ".join(component.doc.partition("\n\n")[0].split())
        symbol = f"![{core.word} and its pins](../../images/{SYMBOL.format(core.folder)})"
        assert component.core is not None
        rows.append(
            (
                _stacked([f"[`{core.word}`]({sheet})", about, symbol]),
                _stacked(f"`{signal.label}` {_ACCESS[signal.access]}" for signal in component.signals),
                _stacked(f"`{pin.name}` {_WAYS[pin.way]}" for pin in component.core.pins) or "none",
                _stacked(f"`{name}={default}`" for name, default in core.parameters.items()),
                _stacked(dict.fromkeys(f"`{call.name}`" for call in calls_of(core))) or "none",
            )
        )
    return _table(("core", "signals", "pins", "parameters", "Python"), rows)


def _calls(_: Sequence[str], __: str) -> list[str]:
    rows = [(f"`{core.word}`", f"`{call.code}`", call.summary) for core in installed_cores() for call in calls_of(core)]
    return _table(("core", "call", ""), rows)


def _members(_: Sequence[str], rest: str) -> list[str]:
    """Return the contents of the directives that follow: each name, its meaning, and the names of its members."""
    directives = _DIRECTIVES.search(rest)
    assert directives is not None
    rows = [
        (f"`{name}`", _summary(item), ", ".join(f"`{member}`" for member in members))
        for name, item, members in _described(directives[1])
    ]
    return _table(("name", "", "members"), rows)


def _described(directives: str) -> Iterator[tuple[str, Any, list[str]]]:
    """Yield the objects that directives of autodoc describe: names, objects and the names of their public members."""
    for kind, name, options in _DIRECTIVE.findall(directives):
        left_out = _listed("exclude-members", options)
        if kind != "module":
            item = _object(name)
            yield name, item, _names(item, left_out)
            continue
        module = importlib.import_module(name)
        for member in _listed("members", options) or module.__all__:
            if member not in left_out:
                item = getattr(module, member)
                yield f"{name}.{member}", item, _names(item, left_out)


def _listed(option: str, options: str) -> list[str]:
    found = re.search(rf"^   :{option}: (.*)$", options, re.MULTILINE)
    return re.split(r", *", found[1]) if found is not None else []


def _object(name: str) -> Any:
    """Return an object by its path; one without a module is of `unity_link`."""
    place, _, attribute = name.rpartition(".")
    return getattr(importlib.import_module(place or _INSTALLED), attribute)


def _names(item: object, left_out: Iterable[str]) -> list[str]:
    """Return the names of the public members of a class that the package defines; none for other objects."""
    if not isinstance(item, type):
        return []
    names: dict[str, None] = {}
    for base in item.__mro__:
        if base.__module__.startswith(_INSTALLED):
            names |= dict.fromkeys((*vars(base).get("__annotations__", {}), *vars(base)))
    return sorted(name for name in names if not name.startswith("_") and name not in left_out)


def _io(_: Sequence[str], __: str) -> list[str]:
    """Return the LEDs, buttons and headers of the boards."""
    shared = {name: tomllib.loads((_BOARDS / f"{name}.toml").read_text())["io"] for name in board_names()}
    rows = []
    for base in (name for name in shared if not isinstance(shared[name], str)):
        title = f"`{base}...`" if base in shared.values() else f"`{base}`"
        for name, io in load_board(base)[1].io.items():
            pins = list(io.named(name))
            named = f"`{pins[0]}`" if len(pins) == 1 else f"`{pins[0]}` to `{pins[-1].removeprefix(name)}`"
            pull = f"pulled {io.pull}" if io.pull != "none" else ""
            remarks = "; ".join(filter(None, (io.about, pull)))
            rows.append((title, named, " ".join(io.named(name).values()), remarks))
            title = ""
    return _table(("board", "names", "sites", ""), rows)


def _chain(_: Sequence[str], __: str) -> list[str]:
    """Return the pins of the chain of shift registers of the boards, with their names and sites."""
    boards: dict[tuple[str, ...], list[str]] = {}
    for name in board_names():
        board = load_board(name)[1]
        named = {pin.site: io for io, pin in board.io_pins.items()}
        sites = [board.pins[pin] for pin in CHAIN]
        boards.setdefault(tuple(f"`{named[site]}` ({site})" if site in named else site for site in sites), []).append(
            name
        )
    rows = [(", ".join(f"`{name}`" for name in names), *pins) for pins, names in boards.items()]
    return _table(("board", *(f"`{pin}`" for pin in CHAIN)), rows)


def _commands(_: Sequence[str], rest: str) -> list[str]:
    """Return the commands of each panel of the help, with links to the headings that follow."""
    rows = [
        (panel, ", ".join(f"[`{name}`](#{name})" if f"\n## {name}\n" in rest else f"`{name}`" for name in commands))
        for panel, commands in PANELS.items()
    ]
    return _table(("", "commands"), rows)


def _excerpt(given: Sequence[str], _: str) -> list[str]:
    """Return lines of a file as a listing.

    Args:
        given: language, path, and the beginnings of the first and of the last line; without them, the whole file.
    """
    language, path, *bounds = given
    lines = (ROOT / path).read_text(encoding="utf-8").splitlines()
    if bounds:
        first, last = (next(n for n, line in enumerate(lines) if line.strip().startswith(bound)) for bound in bounds)
        lines = lines[first : last + 1]
    return [f"```{language}", *textwrap.dedent("\n".join(lines)).splitlines(), "```"]


_PARTS: dict[str, Callable[[Sequence[str], str], list[str]]] = {
    "calls": _calls,
    "chain": _chain,
    "commands": _commands,
    "cores": _cores,
    "excerpt": _excerpt,
    "io": _io,
    "members": _members,
}


def _stacked(lines: Iterable[str]) -> str:
    return "<br>".join(lines)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    return ["| " + " | ".join(cells) + " |" for cells in (head, ["---"] * len(head), *rows)]


def main() -> None:
    """Write the parts of all pages."""
    for page in PAGES:
        if (text := filled(page)) != page.read_text(encoding="utf-8"):
            page.write_text(text, encoding="utf-8")
            sys.stdout.write(f"{page.relative_to(ROOT)}\n")


if __name__ == "__main__":
    main()
