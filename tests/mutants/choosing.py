"""Chooses the mutants of `protocol` and `capture`: random places, with an operator of Cosmic Ray for each."""

from __future__ import annotations

import ast
import difflib
import random
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
from cosmic_ray.ast import ast_nodes, get_ast
from cosmic_ray.mutating import mutate_code
from cosmic_ray.plugins import get_operator, operator_names

if TYPE_CHECKING:
    from collections.abc import Iterator

ROOT = Path(__file__).parents[2]
PACKAGE = Path("unity_link")
FOLDERS = (PACKAGE / "capture", PACKAGE / "protocol")
Position = tuple[int, int]


class Mutant(msgspec.Struct, frozen=True):
    """One mutant: an occurrence of an operator in a module."""

    module: str
    """Path of the module in the package, without its ending, as ``protocol/wire/crc``."""
    operator: str
    occurrence: int
    line: int
    last_line: int
    is_in_a_function: bool

    @property
    def name(self) -> str:
        """Name in results."""
        return f"{self.module}:{self.line}:{self.operator.removeprefix('core/')}:{self.occurrence}"

    @property
    def path(self) -> Path:
        """Path of the module, relative to the top of the repository."""
        return PACKAGE / f"{self.module}.py"

    def source(self) -> str:
        """Return the source of the module with the mutation."""
        mutated = mutate_code((ROOT / self.path).read_text("utf-8"), get_operator(self.operator)(), self.occurrence)
        assert isinstance(mutated, str)
        return mutated

    def difference(self) -> str:
        """Return the changed lines as a difference."""
        before, after = (text.split("\n") for text in ((ROOT / self.path).read_text("utf-8"), self.source()))
        lines = difflib.unified_diff(before, after, lineterm="", n=0)
        return "\n".join(line for line in lines if not line.startswith(("---", "+++", "@@")))


def choose(count: int, seed: int) -> list[Mutant]:
    """Return `count` mutants, no two at the same place; a larger count keeps the first ones."""
    by_place: dict[tuple[str, Position, Position], list[Mutant]] = {}
    for path in sorted(path for folder in FOLDERS for path in (ROOT / folder).rglob("*.py")):
        for start, end, mutant in _mutants_of(path):
            by_place.setdefault((mutant.module, start, end), []).append(mutant)
    chance = random.Random(seed)
    places = sorted(by_place)
    chance.shuffle(places)
    return [chance.choice(by_place[place]) for place in places][:count]


def module_of(path: Path) -> str:
    """Return the module name of a file of the package, as in `Mutant.module`."""
    return path.relative_to(ROOT / PACKAGE).with_suffix("").as_posix()


def _mutants_of(path: Path) -> Iterator[tuple[Position, Position, Mutant]]:
    text = path.read_text("utf-8")
    tree, nodes = ast.parse(text), list(ast_nodes(get_ast(text)))
    left_alone = list(_left_alone(tree))
    bodies = [_place(node) for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    for name in operator_names():
        if _tells_nothing(name):
            continue
        operator = get_operator(name)()
        places = (place for node in nodes for place in operator.mutation_positions(node))
        for occurrence, (start, end) in enumerate(places):
            if not any(first <= start and end <= last for first, last in left_alone):
                inside = any(head[0] < start[0] and end <= last for head, last in bodies)
                yield start, end, Mutant(module_of(path), name, occurrence, start[0], end[0], inside)


def _tells_nothing(name: str) -> bool:
    """Return true if an operator needs arguments, or compares by identity, which is equality for small numbers."""
    before, _, after = name.removeprefix("core/ReplaceComparisonOperator_").partition("_")
    return bool(get_operator(name).arguments()) or (after.startswith("Is") and not before.startswith("Is"))


def _left_alone(tree: ast.Module) -> Iterator[tuple[Position, Position]]:
    """Yield the places that programs do not execute: texts for people, types, and statements about types."""
    for node in ast.walk(tree):
        match node:
            case ast.Assert():
                yield _place(node)
            case ast.Constant(value=str() as text) if " " in text:
                yield _place(node)
            case ast.JoinedStr():
                yield _place(node)
            case ast.Expr(value=ast.Constant()):
                yield _place(node)
            case ast.AnnAssign():
                yield _place(node.annotation)
            case ast.arg(annotation=ast.expr() as annotation):
                yield _place(annotation)
            case ast.FunctionDef(returns=ast.expr() as returns):
                yield _place(returns)
            case ast.If(test=ast.Name(id="TYPE_CHECKING")):
                yield _place(node)


def _place(node: ast.stmt | ast.expr) -> tuple[Position, Position]:
    assert node.end_lineno is not None
    assert node.end_col_offset is not None
    return (node.lineno, node.col_offset), (node.end_lineno, node.end_col_offset)
