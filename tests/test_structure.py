"""The package keeps its structure: each concept has one name, and imports have one direction."""

import ast
from collections import defaultdict
from pathlib import Path

from support.import_circles import circles

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "unity_link"
MOST_SHARED_NAMES = 10
"""Most class names that may occur in two files; the package makes the meaning of each clear."""


def shared_class_names(package: Path) -> dict[str, list[str]]:
    """Return the public class names that occur in several files, with the files."""
    files = defaultdict(set)
    for path in package.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                files[node.name].add(path.relative_to(package).as_posix())
    return {name: sorted(places) for name, places in sorted(files.items()) if len(places) > 1}


def test_few_classes_share_their_name_with_one_of_another_file() -> None:
    shared = shared_class_names(PACKAGE)
    listing = "\n".join(f"{name}: {', '.join(places)}" for name, places in shared.items())
    assert len(shared) <= MOST_SHARED_NAMES, f"more than {MOST_SHARED_NAMES} class names occur in two files:\n{listing}"


def test_a_class_name_in_two_files_is_found(tmp_path: Path) -> None:
    (tmp_path / "room").mkdir()
    (tmp_path / "a.py").write_text("class Batch:\n    class _Part: ...\nclass Alone: ...\n")
    (tmp_path / "room" / "b.py").write_text("def make():\n    class Batch: ...\nclass _Part: ...\n")
    assert shared_class_names(tmp_path) == {"Batch": ["a.py", "room/b.py"]}


def test_no_modules_import_each_other_for_types_or_in_functions_either() -> None:
    found = circles(PACKAGE)
    assert found == [], "\n".join(" - ".join(circle) for circle in found)


def test_a_circle_of_imports_is_found_through_types_functions_and_packages(tmp_path: Path) -> None:
    package = tmp_path / "package"
    package.mkdir()
    (package / "__init__.py").write_text("def late():\n    from package import a\n")
    (package / "a.py").write_text("import package.b\n")
    (package / "b.py").write_text("if TYPE_CHECKING:\n    from package.c import C\n")
    (package / "c.py").write_text("def late():\n    from package import a, missing\n")
    (package / "d.py").write_text("from package import c\n")
    assert circles(package) == [["package", "package.a", "package.b", "package.c"]]
