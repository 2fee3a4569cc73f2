"""The description of an interface: the compressed text that a board carries, so that programs need no spec file.

It is UL-spec without comments and without declarations that the interface does not use: first the files of the spec as
one text, then for each core a form feed, its word, a line end and its map. The whole text is deflated (RFC 1951).
"""

from __future__ import annotations

import dataclasses
import zlib
from typing import TYPE_CHECKING, Any

from unity_link.spec.diagnostics import Reporter, SourceText, SpecError
from unity_link.spec.entity import LIMIT_WORDS
from unity_link.spec.parser import parse
from unity_link.spec.printer import print_file
from unity_link.spec.syntax import (
    BlockStatement,
    ComponentDeclaration,
    File,
    GroupDeclaration,
    Import,
    KindSpecifier,
    Node,
    Placement,
    Statement,
)
from unity_link.spec.tokens import tokenize

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping, Sequence

    from unity_link.spec.syntax import Item

MOST_BYTES = 1 << 20
"""Most bytes of the text of a description that is read; a spec of the largest allowed size has far fewer."""
MOST_EFFORT = 1_150_000
"""Most work for a description, by `Reporter.spend`: 65,536 signals of one row, or 25,000 with five arguments."""
_EFFORT_OF_A_TOKEN = 4
_RAW = -15
"""Value of zlib's `wbits` for a raw deflated stream without a header."""
_NEXT = "\f"


class DescriptionReporter(Reporter):
    """Reporter that ends the compilation of a description early, because anybody may have written it.

    Args:
        texts: all texts of the description; their length counts as work.

    Raises:
        ValueError: by the constructor and by `spend`, if the work exceeds `MOST_EFFORT`.
        SpecError: by `error`, with the reported error.
    """

    def __init__(self, texts: Iterable[str]) -> None:
        super().__init__()
        self._effort = 0
        for text in texts:
            self.spend(len(text))
            for _ in tokenize(text):
                self.spend(_EFFORT_OF_A_TOKEN)

    def spend(self, effort: int) -> None:
        """Add work, in units of about 1 µs."""
        self._effort += effort
        if self._effort > MOST_EFFORT:
            raise ValueError("it has more signals, words or expressions than are read from a board")

    def error(self, *args: Any, **options: Any) -> None:
        """Report an error and raise it."""
        super().error(*args, **options)
        raise SpecError(found for found in self.diagnostics if found.severity == "error")


def describe(interface: str, texts: Mapping[str, Sequence[str]]) -> bytes:
    """Return the description of an interface.

    Args:
        interface: name of a public interface.
        texts: texts of the files of the spec, under the key "", and of the files of each core, under its word.
    """
    parts = [_text(texts[""], interface)]
    parts += [f"{word}\n{_text(texts[word], word)}" for word in sorted(texts) if word]
    packer = zlib.compressobj(9, zlib.DEFLATED, _RAW)
    return packer.compress(_NEXT.join(parts).encode()) + packer.flush()


def unpack(description: bytes) -> tuple[str, dict[str, str]]:
    """Return the text of the spec in a description, and the maps of its cores by their words.

    Raises:
        ValueError: if the bytes are not a description.
    """
    unpacker = zlib.decompressobj(_RAW)
    try:
        text = unpacker.decompress(description, MOST_BYTES).decode()
    except (zlib.error, UnicodeDecodeError) as error:
        raise ValueError(f"the description cannot be unpacked: {error}") from None
    if not unpacker.eof:
        raise ValueError(f"the description is cut short, or has more than {MOST_BYTES:,} characters")
    spec, *maps = text.split(_NEXT)
    return spec, {word: map_ for word, _, map_ in (one.partition("\n") for one in maps)}


def _text(texts: Sequence[str], name: str) -> str:
    """Return the text of a component and of all declarations that it uses."""
    files = [parse(SourceText("", text), Reporter()) for text in texts]
    items = [item for file in files if file is not None for item in file.items if not isinstance(item, Import)]
    wanted = _used({str(item.name): item for item in items}, name)
    kept: list[Item] = [item for item in items if isinstance(item, GroupDeclaration) or str(item.name) in wanted]
    for item in kept:
        _strip(item)
        if isinstance(item, ComponentDeclaration):
            # Limits of parameters were checked when the board was generated.
            item.members = [one for one in item.members if getattr(one, "type", None) not in LIMIT_WORDS]
    return print_file(File(kept))


def _used(declared: Mapping[str, Node], name: str) -> set[str]:
    """Return the names of a component and of all declarations that it uses, directly or indirectly."""
    names = {name}
    pending = [name]
    while pending:
        for node in _nodes(declared.get(pending.pop())):
            if isinstance(node, Placement | KindSpecifier):
                used = str(node.type if isinstance(node, Placement) else node.name)
                pending += [used] * (used not in names)
                names.add(used)
    return names


def _nodes(node: object) -> Iterator[object]:
    """Yield all nodes of a tree, the tree itself first."""
    yield node
    if isinstance(node, Node | KindSpecifier):
        for field in dataclasses.fields(node):
            value = getattr(node, field.name)
            for inner in value if isinstance(value, list) else [value]:
                yield from _nodes(inner)


def _strip(item: Statement) -> None:
    """Remove all comments of a statement and of the statements inside it."""
    for node in _nodes(item):
        if isinstance(node, Statement):
            node.doc, node.leading, node.trailing, node.blank_before = [], [], [], False
        if isinstance(node, BlockStatement):
            node.dangling = []
