"""Reads a spec and its imports, and collects their declarations.

All files share one namespace: a name has the same meaning in every file, however the files import each other.
"""

from __future__ import annotations

from pathlib import Path, PurePath
from typing import TYPE_CHECKING, Generic, NamedTuple, TypeVar

from unity_link.spec.diagnostics import Reporter, SourceText, Span
from unity_link.spec.modules import MODULES
from unity_link.spec.parser import MOST_CHARACTERS, parse
from unity_link.spec.syntax import ComponentDeclaration, EnumDeclaration, File, GroupDeclaration, Import

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.spec.syntax import Word

DeclarationT = TypeVar("DeclarationT", ComponentDeclaration, EnumDeclaration, GroupDeclaration)
MOST_FILES = 200


class Declared(NamedTuple, Generic[DeclarationT]):
    """A declaration and its source."""

    source: SourceText
    node: DeclarationT

    @property
    def span(self) -> Span:
        """Place of the declared name."""
        return self.source.span(*self.node.name.place)


class Declarations:
    """The declarations of all files of a spec."""

    def __init__(self) -> None:
        self.sources: list[SourceText] = []
        self.declared: list[SourceText] = []
        """The sources in the order of their declarations: an imported file precedes the file that imports it."""
        self.components: dict[str, Declared[ComponentDeclaration]] = {}
        self.enumerations: dict[str, Declared[EnumDeclaration]] = {}
        self.groups: dict[str, Declared[GroupDeclaration]] = {}
        self.interfaces: list[Declared[ComponentDeclaration]] = []
        """The public components of the first file."""


def read_text(path: Path) -> str:
    """Return the text of a file, without byte order mark and with line ends converted.

    Raises:
        ValueError: if it cannot be read as text; the message gives the reason.
    """
    try:
        with path.open("rb") as file:
            data = file.read(MOST_CHARACTERS + 1)
        if len(data) > MOST_CHARACTERS:
            raise ValueError(f"{path} is too long for a spec: {MOST_CHARACTERS:,} bytes are the most")
        return data.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        raise ValueError(f"{path} is no UTF-8 text: byte {error.start} is 0x{error.object[error.start]:02X}") from None
    except OSError as error:
        from unity_link.transport import is_url

        if is_url(str(path)):
            raise ValueError(f"{path} is the URL of a gateway, and a spec was expected: are the two swapped?") from None
        raise ValueError(f"{path} cannot be read: {error.strerror or error}") from None


def read_import(path: Path) -> str:
    """Return the text of an imported file. Devices and pipes are refused: reading them may never end.

    Raises:
        ValueError: if it is not a regular file, or as `read_text`.
    """
    if path.exists() and not path.is_file() and not path.is_dir():
        raise ValueError(f"{path} is no regular file")
    return read_text(path)


def refuse_import(path: Path) -> str:
    """Refuse an import in a description.

    Raises:
        ValueError: always.
    """
    raise ValueError(f"{path} is not read: a description has no imports")


class Loader:
    """Loads files, each at most once."""

    def __init__(self, reporter: Reporter, read: Callable[[Path], str] = read_import) -> None:
        self.declarations = Declarations()
        self._reporter = reporter
        self._read = read
        self._loading: list[Path] = []
        self._loaded: set[Path] = set()
        self._names: dict[
            str, Declared[ComponentDeclaration] | Declared[EnumDeclaration] | Declared[GroupDeclaration]
        ] = {}

    def load(self, name: str, text: str, path: Path | None) -> None:
        """Load the first file from its text; its imports are relative to the folder of `path`."""
        self._load(SourceText(name, text), path)

    def _load(self, source: SourceText, path: Path | None) -> None:
        self.declarations.sources.append(source)
        is_first = len(self.declarations.sources) == 1
        file = parse(source, self._reporter)
        if file is None:
            return
        resolved = None if path is None else path.resolve()
        if resolved is not None:
            self._loading.append(resolved)
        for item in file.items:
            if isinstance(item, Import):
                self._import(source, path, item)
        self._declare(source, file, is_first=is_first)
        self.declarations.declared.append(source)
        if resolved is not None:
            self._loading.pop()
            self._loaded.add(resolved)

    def _import(self, source: SourceText, path: Path | None, item: Import) -> None:
        wanted = item.path.value
        place = item.path.place
        folder = Path() if path is None else path.parent
        target = folder / wanted
        try:
            resolved = target.resolve()
            if resolved in self._loaded:
                return
            if resolved in self._loading:
                around = [one.name for one in [*self._loading[self._loading.index(resolved) :], resolved]]
                message = f"files import each other in a circle: {' -> '.join(around)}"
                self._reporter.error(source, place, "import-cycle", message)
                return
            if len(self.declarations.sources) >= MOST_FILES:
                message = f"more than {MOST_FILES} files are imported"
                self._reporter.error(source, place, "import", message)
                return
            text = self._read(target)
        except (ValueError, OSError, RuntimeError) as error:
            advice = "an import is relative to the folder of the file that contains it"
            self._reporter.error(source, place, "import", str(error).replace("\0", "\\0"), help=advice)
            return
        # Form the name from that of the importing file, so that the name in messages is a path that opens the file.
        name = str(PurePath(source.name).parent / wanted)
        self._load(SourceText(name, text), target)

    def _declare(self, source: SourceText, file: File, *, is_first: bool) -> None:
        declarations = self.declarations
        for item in file.items:
            if isinstance(item, ComponentDeclaration):
                if item.name in MODULES and not item.public:
                    message = f"{item.name} is the word of a hardware module, and no component can have it"
                    self._reporter.error(source, item.name.place, "module-word", message, help="call it otherwise")
                elif self._is_new(source, item.name, declared := Declared(source, item)):
                    declarations.components[str(item.name)] = declared
                    if item.public and is_first:
                        declarations.interfaces.append(declared)
            elif isinstance(item, EnumDeclaration):
                if self._is_new(source, item.name, enumeration := Declared(source, item)):
                    declarations.enumerations[str(item.name)] = enumeration
            elif isinstance(item, GroupDeclaration) and self._is_new(
                source, item.name, group := Declared(source, item)
            ):
                declarations.groups[str(item.name)] = group

    def _is_new(
        self,
        source: SourceText,
        name: Word,
        declared: Declared[ComponentDeclaration] | Declared[EnumDeclaration] | Declared[GroupDeclaration],
    ) -> bool:
        other = self._names.setdefault(name, declared)
        if other is declared:
            return True
        span = other.span
        note = (span, "it is declared here for the first time", other.source.line(span.line))
        message = f"the name '{name}' is declared twice"
        self._reporter.error(source, name.place, "name-twice", message, notes=[note])
        return False
