"""Counts phrases that a reader of the field has to translate: ``python -m support.plain_english``, for `make lint`.

`plain_english.toml` has the phrases and the limits: phrases per 1,000 words for each folder, the number of tests with
long names, and the number of lines in `unity_link` that switch off a check (`suppressions.py`). The check fails above a
limit, and if a limit is higher than at the merge base with `main`.

    python -m support.plain_english            check all files
    python -m support.plain_english PATH...    list the phrases in files and folders, one a line
    python -m support.plain_english --lower    lower the limits to the counts of today
"""

from __future__ import annotations

import math
import re
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from support.prose import pieces_of
from support.suppressions import suppressions
from support.tracked import tracked_files

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

ROOT = Path(__file__).parents[2]
TABLE = "tests/support/plain_english.toml"
_WORST_FILES = 5
_TEST = re.compile(r"^\s*(?:async )?def (test_\w+)", re.MULTILINE)
# A docstring states the task of a function or the meaning of a value: "Return ...", "Seconds until ...".
_QUESTION = re.compile(r"(?:What|Who|Whose|Whether|Where|How|When|Of|Have|Say|Tell|Give)\b")


class Found(NamedTuple):
    """A phrase in a file."""

    line: int
    """Line in which the docstring, comment or page of the phrase begins."""
    name: str
    text: str
    """The phrase and the words around it."""


class Folder:
    """Counts of the files that share one limit."""

    def __init__(self) -> None:
        self.words = 0
        self.phrases: dict[str, int] = {}
        """Number of phrases in each file, by its path."""

    @property
    def rate(self) -> float:
        """Phrases per 1,000 words."""
        return 1000 * sum(self.phrases.values()) / max(self.words, 1)


class Rules:
    """The phrases and limits of a table.

    Args:
        table: contents of `plain_english.toml`.
    """

    def __init__(self, table: Mapping[str, Any]) -> None:
        self.ceilings: dict[str, float] = table["ceilings"]
        self.longest_test_name: int = table["longest_test_name"]
        self.long_test_names: int = table["long_test_names"]
        self.suppressions: dict[str, int] = table.get("suppressions", {})
        self._vendored = [Path(name) for name in table["vendored"]]
        self._phrases = re.compile("|".join(f"({_pattern(phrase)})" for phrase in table["phrases"]))
        self.reasons = {phrase["name"]: phrase["reason"] for phrase in table["phrases"]}

    def found_in(self, path: Path) -> Iterator[Found]:
        """Yield the phrases in a file."""
        for piece in pieces_of(path):
            yield from self._found_in_text(piece.line, piece.text)

    def _found_in_text(self, line: int, text: str) -> Iterator[Found]:
        names = list(self.reasons)
        for match in self._phrases.finditer(text):
            around = text[max(0, match.start() - 30) : match.end() + 30]
            yield Found(line, names[(match.lastindex or 1) - 1], around)

    def count(self, paths: Iterable[Path], root: Path) -> dict[str, Folder]:
        """Return the counts of the files for each limit."""
        folders = {name: Folder() for name in self.ceilings}
        for path in paths:
            inside = path.relative_to(root)
            if any(inside.is_relative_to(folder) for folder in self._vendored):
                continue
            names = [parent.as_posix() for parent in (inside, *inside.parents)]
            folder = folders[next(name for name in names if name in folders)]
            for piece in pieces_of(path):
                folder.words += piece.text.count(" ") + 1
                if number := sum(1 for _ in self._phrases.finditer(piece.text)):
                    folder.phrases[names[0]] = folder.phrases.get(names[0], 0) + number
        return folders


def _pattern(phrase: Mapping[str, str]) -> str:
    then = f" (?:{'|'.join(phrase['then'].split())})\\b" if "then" in phrase else ""
    return phrase["pattern"] + then


def read_rules(text: str) -> Rules:
    """Return the rules of a table.

    Args:
        text: in TOML.
    """
    return Rules(tomllib.loads(text))


def above(folders: Mapping[str, Folder], rules: Rules) -> Iterator[str]:
    """Yield a sentence for each folder with more phrases than its limit, and its worst files."""
    for name, folder in folders.items():
        if folder.rate > rules.ceilings[name]:
            yield f"{name}: {folder.rate:.2f} phrases per 1,000 words, at most {rules.ceilings[name]}; most of them in"
            worst = sorted(folder.phrases.items(), key=lambda item: -item[1])[:_WORST_FILES]
            yield from (f"    {count:4} {path}" for path, count in worst)


def raised(rules: Rules, before: Rules) -> Iterator[str]:
    """Yield a sentence for each limit that is higher in the new table."""
    for name, ceiling in rules.ceilings.items():
        if ceiling > before.ceilings.get(name, math.inf):
            yield f"{TABLE}: the ceiling of {name} is {ceiling}, and was {before.ceilings[name]}; it may only fall"
    numbers, numbers_before = (
        {"longest_test_name": one.longest_test_name, "long_test_names": one.long_test_names, **one.suppressions}
        for one in (rules, before)
    )
    for name, now in numbers.items():
        if now > numbers_before.get(name, math.inf):
            yield f"{TABLE}: {name} is {now}, and was {numbers_before[name]}; it may only fall"


def at_merge_base(root: Path) -> Rules | None:
    """Return the rules at the commit where the branch left `main`, or None without such a commit."""
    for branch in ("main", "origin/main"):
        base = _git(root, "merge-base", "HEAD", branch).strip()
        if base and (text := _git(root, "show", f"{base}:{TABLE}")):
            return read_rules(text)
    return None


def _git(root: Path, *arguments: str) -> str:
    if not (root / ".git").exists():
        return ""
    return subprocess.run(["git", *arguments], cwd=root, check=False, capture_output=True, text=True).stdout


def long_names(paths: Iterable[Path], longest: int) -> dict[str, Path]:
    """Return the names of tests that have more characters than `longest`, with their files."""
    sources = [path for path in paths if path.suffix == ".py"]
    names = {name: path for path in sources for name in _TEST.findall(path.read_text(encoding="utf-8"))}
    return {name: path for name, path in names.items() if len(name) > longest}


def questions(folder: Path) -> Iterator[str]:
    """Yield a sentence for each docstring of a folder that begins as a question or an order."""
    for path in sorted(folder.rglob("*.py")):
        for piece in pieces_of(path):
            if piece.is_summary and _QUESTION.match(piece.text):
                yield f"{path}:{piece.line}: docstring asks or orders, write what it is: {piece.text}"


def lowered(text: str, folders: Mapping[str, Folder], names: int, switched_off: Mapping[str, int]) -> str:
    """Return a table with limits as low as the counts allow, rates rounded up to one decimal."""
    rules = read_rules(text)
    for name, folder in folders.items():
        rate = min(rules.ceilings[name], math.ceil(10 * folder.rate) / 10)
        text = re.sub(rf'(?m)^"{re.escape(name)}" = .*$', f'"{name}" = {rate}', text)
    for name, limit in rules.suppressions.items():
        text = re.sub(rf'(?m)^"{re.escape(name)}" = .*$', f'"{name}" = {min(limit, switched_off[name])}', text)
    return re.sub(r"(?m)^long_test_names = .*$", f"long_test_names = {min(rules.long_test_names, names)}", text)


def _list(rules: Rules, paths: Iterable[Path]) -> None:
    """Print the phrases of files and folders."""
    for path in paths:
        for file in [path] if path.is_file() else sorted(file for file in path.rglob("*") if file.is_file()):
            for found in rules.found_in(file):
                print(f"{file}:{found.line}: {found.name}: ...{found.text}... {rules.reasons[found.name]}")  # noqa: T201


def too_many(switched_off: Mapping[str, int], rules: Rules) -> Iterator[str]:
    """Yield a sentence for each way to switch off a check that more lines use than its limit allows."""
    for name, limit in rules.suppressions.items():
        if switched_off[name] > limit:
            yield f"{switched_off[name]} lines of unity_link/ have `{name}`, at most {limit} may"


def _faults(
    rules: Rules, folders: Mapping[str, Folder], names: Mapping[str, Path], switched_off: Mapping[str, int]
) -> Iterator[str]:
    yield from above(folders, rules)
    yield from too_many(switched_off, rules)
    if len(names) > rules.long_test_names:
        limit = f"{len(names)} names of tests have more than {rules.longest_test_name} characters"
        yield f"{limit}, at most {rules.long_test_names} may; the longest are"
        yield from (
            f"    {path.relative_to(ROOT)} {name}" for name, path in sorted(names.items(), key=_length)[:_WORST_FILES]
        )
    yield from questions(ROOT / "unity_link")
    if before := at_merge_base(ROOT):
        yield from raised(rules, before)


def _length(item: tuple[str, Path]) -> int:
    return -len(item[0])


def main(arguments: list[str]) -> int:
    """Check the files of the project, list phrases, or lower limits; return 1 if a limit is exceeded."""
    table = ROOT / TABLE
    rules = read_rules(table.read_text(encoding="utf-8"))
    if arguments and arguments != ["--lower"]:
        _list(rules, [Path(argument) for argument in arguments])
        return 0
    paths = tracked_files(ROOT)
    folders, names = rules.count(paths, ROOT), long_names(paths, rules.longest_test_name)
    switched_off = suppressions(paths, ROOT / "unity_link")
    if arguments:
        text = lowered(table.read_text(encoding="utf-8"), folders, len(names), switched_off)
        table.write_text(text, encoding="utf-8")
        return 0
    faults = list(_faults(rules, folders, names, switched_off))
    print(*faults, sep="\n", end="\n" if faults else "")  # noqa: T201  (a command for people)
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
