"""Cores: components in files of their own, which a spec names by a word.

A word in capitals that no file of a spec declares is the word of a core. ``STEPPER`` is the component of that name in
``stepper/stepper.ul``, in the first of these places that contains this file:

1. the folder ``cores`` beside the spec;
2. packages with an entry point of the group ``unity_link.cores`` whose name is the name of the folder;
3. the cores that are installed with Unity-Link.

Only the components of such a file are read. No code of a core is executed to check a spec.
"""

from __future__ import annotations

import importlib.machinery
import importlib.metadata
import os
import re
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from unity_link.spec.context import Context
from unity_link.spec.loading import Declared, Loader, read_text

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from unity_link.spec.diagnostics import Reporter, SourceText
    from unity_link.spec.syntax import ComponentDeclaration, Placement

ENTRY_POINTS = "unity_link.cores"
_PACKAGE = Path(__file__).resolve().parents[1]
_HERE = _PACKAGE / "gateware"
INSTALLED = (_HERE if (_HERE / "rtl").exists() else _PACKAGE.parent / "gateware") / "cores"
"""Folder of the cores that are installed with Unity-Link."""
_NOWHERE = Path(os.devnull, "nowhere")
"""Folder of a core that has no files on this computer."""
_WORD = re.compile(r"[A-Z][A-Z0-9_]*")


class CoreFolder(NamedTuple):
    """The folder of a core, and its files."""

    word: str
    path: Path
    package: str = ""
    """Python package that contains the folder; empty if there is none."""

    @property
    def python(self) -> str:
        """Module to import, or path of a file, with the core API; empty if the core has none. It is not executed."""
        name = self.path.name
        if self.is_installed:
            return f"unity_link.cores.{name}" if (_PACKAGE / "cores" / f"{name}.py").is_file() else ""
        file = self.path / f"{name}.py"
        if not file.is_file():
            return ""
        return f"{self.package}.{name}.{name}" if self.package else str(file.resolve())

    @property
    def map(self) -> Path:
        """The file that declares the core's component."""
        return self.path / f"{self.path.name}.ul"

    @property
    def per_axis(self) -> tuple[str, ...]:
        """Generics that each placement has for itself, from `core.toml` beside the map; empty without that file.

        Raises:
            ValueError: if the file cannot be read, or `per_axis` is not a list of names.
        """
        file = self.path / "core.toml"
        if not file.is_file():
            return ()
        try:
            names = tomllib.loads(read_text(file)).get("per_axis", [])
        except tomllib.TOMLDecodeError as error:
            raise ValueError(f"{file} is no TOML: {error}") from None
        except RecursionError:
            raise ValueError(f"{file} is nested too deeply: per_axis was expected, a list of generics") from None
        if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
            raise ValueError(f'{file}: per_axis is {names!r}, a list of generics was expected, as in ["length"]')
        return tuple(name.lower() for name in names)

    @property
    def is_installed(self) -> bool:
        """Return whether the core is installed with Unity-Link; its VHDL is then in the gateware's library."""
        return self.path.parent == INSTALLED

    @property
    def vhdl(self) -> list[Path]:
        """Paths of the VHDL files, sorted by name."""
        return sorted(self.path.glob("*.vhd"))


class FoundCore(NamedTuple):
    """A core that a spec names: its folder, its declaration, and the declarations and sources of its files."""

    folder: CoreFolder
    declared: Declared[ComponentDeclaration]
    context: Context
    sources: list[SourceText]


def is_word(name: str) -> bool:
    """Return whether a name is written like the word of a core: in capitals."""
    return _WORD.fullmatch(name) is not None


def core_folders(beside: Path | None) -> Iterator[dict[str, list[CoreFolder]]]:
    """Yield the folders of all cores by word: one dictionary for each place, in the order of precedence.

    Args:
        beside: folder of the spec; None if the spec is not a file.
    """
    if beside is not None:
        yield _in(beside / "cores")
    packaged: dict[str, list[CoreFolder]] = {}
    for point in importlib.metadata.entry_points(group=ENTRY_POINTS):
        for path in _package_folders(point.module):
            folder = CoreFolder(point.name.upper(), path / point.name, point.module)
            if folder.map.is_file():
                packaged.setdefault(folder.word, []).append(folder)
    yield packaged
    yield _in(INSTALLED)


def _in(folder: Path) -> dict[str, list[CoreFolder]]:
    try:
        found = [CoreFolder(path.name.upper(), path) for path in sorted(folder.iterdir()) if is_word(path.name.upper())]
    except OSError:
        return {}
    words: dict[str, list[CoreFolder]] = {}
    for one in found:
        if one.map.is_file():
            words.setdefault(one.word, []).append(one)
    return words


def _package_folders(module: str) -> list[Path]:
    """Return the folders of a package, without importing it."""
    top, *inner = module.split(".")
    spec = importlib.machinery.PathFinder.find_spec(top)
    return [] if spec is None else [Path(path, *inner) for path in spec.submodule_search_locations or ()]


class Cores:
    """The cores that one spec can name. Each is read at most once.

    Args:
        reporter: receives the faults.
        beside: folder of the spec; None if the spec is not a file.
        maps: texts of the maps of all cores by word, if they come with the spec, as in a description. The folder of a
            core of the same word on this computer, if there is one, supplies only its Python API.
    """

    def __init__(self, reporter: Reporter, beside: Path | None, maps: Mapping[str, str] | None = None) -> None:
        self._reporter = reporter
        self._beside = beside
        self._maps = maps
        self._ranks: list[dict[str, list[CoreFolder]]] | None = None
        self._found: dict[str, FoundCore | None] = {}
        self.sources: list[SourceText] = []
        """Sources of the cores that the spec names."""

    @property
    def words(self) -> list[str]:
        """Words of all available cores, sorted."""
        return sorted({word for rank in self._folders() for word in rank})

    def _folders(self) -> list[dict[str, list[CoreFolder]]]:
        if self._ranks is None:
            self._ranks = list(core_folders(self._beside))
            if self._maps is not None:
                known = {word: folders for rank in reversed(self._ranks) for word, folders in rank.items()}
                self._ranks = [{word: known.get(word, [CoreFolder(word, _NOWHERE)])[:1] for word in self._maps}]
        return self._ranks

    @property
    def found(self) -> dict[str, FoundCore]:
        """The cores that the spec names, by word."""
        return {word: one for word, one in self._found.items() if one is not None}

    def find(self, source: SourceText, member: Placement) -> FoundCore | None:
        """Return the core that a placement names; None if it does not exist or is faulty, which is reported."""
        word = str(member.type)
        if word not in self._found:
            folders = next((rank[word] for rank in self._folders() if word in rank), [])
            if len(folders) > 1:
                places = " and ".join(str(folder.path) for folder in folders)
                message = f"there are several cores {word}: {places}"
                self._reporter.error(source, member.type.place, "core-twice", message, help="uninstall one of them")
            self._found[word] = self._read(source, member, folders[0]) if len(folders) == 1 else None
        return self._found[word]

    def has(self, word: str) -> bool:
        """Return whether a core of this word exists, even if its files are faulty."""
        return any(word in rank for rank in self._folders())

    def _read(self, source: SourceText, member: Placement, folder: CoreFolder) -> FoundCore | None:
        place = member.type.place
        try:
            text = read_text(folder.map) if self._maps is None else self._maps[folder.word]
        except ValueError as error:
            self._reporter.error(source, place, "core", str(error))
            return None
        loader = Loader(self._reporter)
        # Name installed cores without the folder of the installation, which differs between computers.
        name = f"cores/{folder.path.name}/{folder.map.name}" if folder.is_installed else str(folder.map)
        loader.load(name, text, folder.map)
        self.sources += loader.declarations.sources
        declared = loader.declarations.components.get(folder.word)
        if declared is None or declared.node.public:
            if not self._reporter.failed:
                self._reporter.error(source, place, "core", f"{name} declares no component {folder.word}")
            return None
        for group in loader.declarations.groups.values():
            message = f"the core {folder.word} declares a group, and groups are those of the spec that names a core"
            advice = "take the group as a parameter, as in GROUP=none"
            self._reporter.error(group.source, group.node.name.place, "misplaced", message, help=advice)
        return FoundCore(folder, declared, Context(loader.declarations, self._reporter), loader.declarations.sources)
