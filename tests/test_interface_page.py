"""The page of the Python interface describes each exported name, and each public member of it."""

from __future__ import annotations

import ast
import inspect
import shutil
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from sphinx.util.inventory import InventoryFile

import unity_link

if TYPE_CHECKING:
    from collections.abc import Iterator

DOCS = Path(__file__).parents[1] / "docs"
PAGE = DOCS / "reference" / "api.md"


@pytest.fixture(scope="module")
def shown(tmp_path_factory: pytest.TempPathFactory) -> tuple[str, set[str]]:
    """Return the page as HTML, and all names that it describes."""
    source, made = tmp_path_factory.mktemp("source"), tmp_path_factory.mktemp("made")
    shutil.copy(PAGE, source / "index.md")
    shutil.copy(DOCS / "conf.py", source)
    # The other pages are missing, so links to them lead nowhere.
    options = ["-q", "-D", "suppress_warnings=myst.xref_missing", "-W"]
    subprocess.run([sys.executable, "-m", "sphinx", *options, str(source), str(made)], cwd=DOCS.parent, check=True)
    inventory = InventoryFile.loads((made / "objects.inv").read_bytes(), uri="")
    names = {name for kind, found in inventory.data.items() if kind.startswith("py:") for name in found}
    return (made / "index.html").read_text(encoding="utf-8"), names


def members(kind: type) -> Iterator[str]:
    """Yield the public members that a class has from classes of the package, also the attributes set by `__init__`."""
    for base in kind.__mro__:
        if not base.__module__.startswith("unity_link"):
            continue
        yield from (name for name in (*vars(base), *vars(base).get("__annotations__", {})) if not name.startswith("_"))
        for node in ast.walk(ast.parse(inspect.getsource(base))):
            if (
                isinstance(node, ast.Attribute)
                and isinstance(node.ctx, ast.Store)
                and ast.unparse(node.value) == "self"
            ):
                yield from () if node.attr.startswith("_") else (node.attr,)


@pytest.mark.slow
def test_every_exported_name_is_on_the_page(shown: tuple[str, set[str]]) -> None:
    _, names = shown
    assert {f"unity_link.{name}" for name in unity_link.__all__} - names == set()


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in unity_link.__all__ if isinstance(getattr(unity_link, name), type)])
def test_each_public_member_is_on_the_page(name: str, shown: tuple[str, set[str]]) -> None:
    _, names = shown
    kind = getattr(unity_link, name)
    expected = {f"unity_link.{name}.{member}" for member in members(kind)}
    inherited = {
        f"unity_link.{name}.{member}"
        for base in kind.__mro__[1:]
        if base.__name__ in unity_link.__all__
        for member in members(base)
    }
    assert expected - inherited - names == set()


def test_page_begins_with_open_ends_with_errors_and_has_no_internals(shown: tuple[str, set[str]]) -> None:
    page, names = shown
    order = ("connect", "load", "Link", "Feature", "UnityLinkError")
    places = [page.index(f'id="unity_link.{name}"') for name in order]
    assert places == sorted(places)
    assert not [name for name in names if "__" in name]
