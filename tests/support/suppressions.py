"""Counts lines of the package that switch off a check: of types by `Any`, of a line by `noqa` or `type: ignore`."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

PATTERNS = {
    "Any": re.compile(r"\bAny\b(?! [a-z])"),  # not the word of a sentence
    "noqa": re.compile(r"#.*\bnoqa\b"),
    "type: ignore": re.compile(r"#\s*type:\s*ignore\b"),
}
"""Finds the lines of each kind."""


def suppressions(paths: Iterable[Path], package: Path) -> dict[str, int]:
    """Return the number of lines of each kind in the Python sources of a package.

    Args:
        paths: files of the project.
        package: only files in this folder count.
    """
    sources = [path for path in paths if path.suffix == ".py" and path.is_relative_to(package)]
    lines = [line for path in sources for line in path.read_text(encoding="utf-8").splitlines()]
    return {name: sum(bool(pattern.search(line)) for line in lines) for name, pattern in PATTERNS.items()}
