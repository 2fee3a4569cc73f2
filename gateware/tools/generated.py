"""The generated entities that the datasheets show: those of `examples/rover.ul`.

That spec uses every kind of hardware interface: registers with inputs, a FIFO port, periodic and triggered groups.
"""

from __future__ import annotations

import functools
from pathlib import Path

from unity_link.gateware.cache import GATEWARE
from unity_link.generate import generate
from unity_link.spec import compile_file

SPEC = GATEWARE.parent / "examples" / "rover.ul"
_PARTS = ("map", "registers", "gateway")
ENTITIES = tuple(f"{SPEC.stem}_{part}" for part in _PARTS[1:])
PACKAGE = f"{SPEC.stem}_{_PARTS[0]}"


@functools.cache
def texts() -> dict[str, str]:
    """Return the text of each file by its entity or package, in compile order."""
    files = {Path(file.name).stem: file.text for file in generate("vhdl", compile_file(SPEC))}
    return {name: files[name] for name in (PACKAGE, *ENTITIES)}


def sources(folder: Path) -> list[Path]:
    """Return the files in a folder; write those that are missing or out of date."""
    folder.mkdir(parents=True, exist_ok=True)
    paths = {folder / f"{name}.vhd": text for name, text in texts().items()}
    for path, text in paths.items():
        if not path.exists() or path.read_text() != text:
            path.write_text(text)
    return list(paths)
