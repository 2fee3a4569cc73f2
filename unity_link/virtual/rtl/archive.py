"""The C++ of all builds of the gateware in an installation: an archive, and an index of its contents.

The builds are similar, so that all of them, compressed with a common dictionary, take little more space than one.
"""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from unity_link.errors import ArgumentError
from unity_link.files import write_files

if TYPE_CHECKING:
    from collections.abc import Mapping

    from unity_link.protocol.wire.configuration import GatewayInfo

GENERATED = Path(__file__).parent / "generated"
_INDEX = "models.json"
_ARCHIVE = "models.tar.xz"
_ADVICE = "install unity-link anew, or run make rtl"


class Entry(msgspec.Struct, frozen=True, omit_defaults=True):
    """Entry of one build in the index."""

    origin: str
    """Hash of the inputs from which the build was made."""
    answers: str
    """Answer of the build to `Q`, in hex."""
    digest: str
    """Hash of its C++."""
    node: int | None = None

    @classmethod
    def of(cls, origin: str, text: bytes, info: GatewayInfo, node: int | None) -> Entry:
        """Return the entry of a build."""
        return cls(origin, info.to_hex().decode(), digest_of(text), node)


def digest_of(text: bytes) -> str:
    """Return the first 16 hex digits of the SHA-256 of a build's C++."""
    return hashlib.sha256(text).hexdigest()[:16]


def text_of(name: str, digest: str) -> bytes:
    """Return the C++ of a build.

    Raises:
        ArgumentError: if this installation does not have it.
    """
    text = read_texts(GENERATED).get(name, b"")
    if digest_of(text) != digest:
        raise ArgumentError(f"{GENERATED / _ARCHIVE} does not hold the gateware {name!r}: {_ADVICE}")
    return text


def read_index(folder: Path) -> dict[str, Entry]:
    """Return the entries of the index in a folder, by name; an empty dict if there is no index.

    Raises:
        ArgumentError: if the index cannot be read.
    """
    path = folder / _INDEX
    if not path.exists():
        return {}
    try:
        return msgspec.json.decode(path.read_bytes(), type=dict[str, Entry])
    except (OSError, msgspec.DecodeError) as error:
        raise ArgumentError(f"{path} is no index of the gateware ({error}): {_ADVICE}") from error


def read_texts(folder: Path) -> dict[str, bytes]:
    """Return the C++ of all builds in the archive of a folder, by name; an empty dict if there is no archive.

    Raises:
        ArgumentError: if the archive cannot be read.
    """
    # Imported here because it is not needed if the library is compiled already.
    import tarfile

    path = folder / _ARCHIVE
    if not path.exists():
        return {}
    try:
        with tarfile.open(path, "r:xz") as archive:
            opened = {Path(member.name).stem: archive.extractfile(member) for member in archive}
            return {name: file.read() for name, file in opened.items() if file is not None}
    except (OSError, EOFError, tarfile.TarError) as error:
        raise ArgumentError(f"{path} cannot be unpacked ({error}): {_ADVICE}") from error


def write(folder: Path, index: Mapping[str, Entry], texts: Mapping[str, bytes]) -> None:
    """Write the index and the archive into a folder; the same texts always make the same archive."""
    import io
    import lzma
    import tarfile

    packed = io.BytesIO()
    # Compress all together, because the builds have most of their text in common.
    with tarfile.open(fileobj=packed, mode="w") as archive:
        for name, text in sorted(texts.items()):
            member = tarfile.TarInfo(f"{name}.cc")
            member.size = len(text)
            archive.addfile(member, io.BytesIO(text))
    rows = b",\n".join(b'"%s": %s' % (name.encode(), msgspec.json.encode(index[name])) for name in sorted(index))
    write_files(
        {
            folder / _ARCHIVE: lzma.compress(packed.getvalue(), preset=9 | lzma.PRESET_EXTREME),
            folder / _INDEX: b"{\n%s\n}\n" % rows,
        },
        overwrite=True,
    )
