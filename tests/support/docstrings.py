"""Finds docstrings that begin as a question or an order: ``python -m support.docstrings``, for `make lint`.

A docstring states what a function does or what a value is: "Return ...", "Seconds until ...".
"""

from __future__ import annotations

import ast
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

ROOT = Path(__file__).parents[2]
_QUESTION = re.compile(r"(What|Who|Whose|Whether|Where|How|When|Of|Have|Say|Tell|Give)\b")


def questions(folder: Path) -> Iterator[tuple[Path, int, str]]:
    """Yield file, line and first line of each such docstring, those below attributes and constants included."""
    for path in sorted(folder.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text())):
            match node:
                case ast.Expr(value=ast.Constant(value=str(text))) if _QUESTION.match(text.strip()):
                    yield path, node.lineno, text.strip().splitlines()[0]


def main() -> int:
    """Print what is found in the package, and return 1 where there is any."""
    found = list(questions(ROOT / "unity_link"))
    for path, line, text in found:
        print(f"{path.relative_to(ROOT)}:{line}: docstring asks or orders, write what it is: {text}")  # noqa: T201
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
