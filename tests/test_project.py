"""Guarantees of the project: the modules that an import loads, the names in the lock files, the targets of links."""

import importlib.metadata
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import typer
from packaging.requirements import Requirement
from typer import Context
from typer.core import TyperGroup
from typer.main import get_group

import unity_link
from docs.images.make import PICTURES
from support.tracked import tracked_files
from unity_link.cli import app
from unity_link.cli.families import FAMILIES

ROOT = Path(__file__).parent.parent
LOCKS = sorted((ROOT / "requirements").glob("*.lock"))
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
PYTHONS = re.findall(r"Python :: (3\.\d+)", "\n".join(PROJECT["classifiers"]))
"""Versions of Python that the project supports; a part of the tests runs on 3.13 if it is installed."""


def test_importing_the_package_loads_no_optional_modules() -> None:
    code = "import sys; before = set(sys.modules); import unity_link; print(*(set(sys.modules) - before))"
    loaded = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout.split()
    third_party = {name.partition(".")[0] for name in loaded} - sys.stdlib_module_names
    third_party = {name for name in third_party if not name.startswith("_")}
    assert third_party <= {"fastcrc", "msgspec", "typing_extensions", "unity_link"}
    assert not {name for name in loaded if re.match(r"unity_link\.(drivers\.|virtual|cli|bridges|generate|spec)", name)}


def test_the_installed_version_is_the_one_of_the_sources() -> None:
    assert importlib.metadata.version("unity-link") == unity_link.__version__


def test_the_command_and_the_changelog_name_the_version_of_the_package() -> None:
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    unreleased, latest = re.split(r"^## ", text, flags=re.MULTILINE)[1:3]
    command = [sys.executable, "-m", "unity_link", "--version"]
    printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()
    assert printed == f"unity-link {unity_link.__version__}"
    assert unreleased.startswith("[Unreleased]\n\n### Breaking\n")
    assert latest.startswith(f"[{unity_link.__version__}]")


def test_the_changelog_describes_the_first_version_in_150_lines() -> None:
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    assert text.partition("## [0.1.0]")[2].partition("\n## ")[0].count("\n") <= 150


def test_everything_public_is_exported_and_documented() -> None:
    for name in unity_link.__all__:
        assert (getattr(unity_link, name).__doc__ or "").strip(), name


@pytest.mark.parametrize("lock", LOCKS, ids=lambda path: path.name)
def test_lock_file_has_only_versions_and_hashes(lock: Path) -> None:
    line = r"[a-z0-9-]+==[\w.]+( ; [\w<>=!.*'() ]+)? \\|    --hash=sha256:[0-9a-f]{64}( \\)?"
    assert [text for text in lock.read_text().splitlines() if not re.fullmatch(line, text)] == []


@pytest.mark.parametrize("python", PYTHONS)
@pytest.mark.parametrize("lock", LOCKS, ids=lambda path: path.name)
def test_a_lock_has_one_version_of_each_package_for_each_python(lock: Path, python: str) -> None:
    here = {"python_version": python, "python_full_version": f"{python}.0", "sys_platform": "linux", "os_name": "posix"}
    pinned = [Requirement(line.removesuffix("\\")) for line in lock.read_text().splitlines() if "==" in line]
    names = [one.name for one in pinned if one.marker is None or one.marker.evaluate(here)]
    assert sorted(names) == sorted(set(names))
    assert {Requirement(one).name for one in PROJECT["dependencies"]} <= set(names)


def test_the_versions_of_both_lock_files_agree() -> None:
    core, whole = (
        set(re.findall(r"^\S+==\S+", (ROOT / "requirements" / f"{name}.lock").read_text(), re.MULTILINE))
        for name in ("core", "all")
    )
    assert core <= whole


def test_lock_file_of_peers_has_the_versions_of_the_main_lock_file() -> None:
    whole, peers = (
        re.findall(r"^(\S+)==(\S+)", (ROOT / "requirements" / f"{name}.lock").read_text(), re.MULTILINE)
        for name in ("all", "peers")
    )
    shared = {name for name, _ in whole} & {name for name, _ in peers}
    assert "numpy" in shared
    assert {pin for pin in peers if pin[0] in shared} <= set(whole)


def test_no_tracked_file_names_a_machine_or_a_registry() -> None:
    places = re.compile(rb"(?<![\w.~}])/(root|work|home/\w+|tmp/\w+|opt/\w+)/|pythonhosted|index-url *=")
    found = {
        f"{path.relative_to(ROOT)}: {match[0].decode()}"
        for path in tracked_files(ROOT)
        if path != Path(__file__) and (match := places.search(path.read_bytes()))
    }
    assert found == set()


def test_no_module_is_a_drawer_for_odds_and_ends() -> None:
    assert [path for path in tracked_files(ROOT) if path.stem in {"util", "utils", "helpers", "misc", "common"}] == []


def test_every_file_begins_with_its_purpose() -> None:
    sources = [path for path in tracked_files(ROOT) if path.suffix in {".py", ".vhd", ".mk", ".sby"}]
    silent = [path for path in sources if not re.match(r'(#!.*\n)?(#|--|r?""")', path.read_text(encoding="utf-8"))]
    assert silent == []


def test_the_first_page_leads_every_user_to_every_tutorial_and_guide() -> None:
    guide, lists = (ROOT / "docs" / "index.md").read_text(encoding="utf-8").split("<!-- {toctree}", 1)
    led_to = set(re.findall(r"\]\(([^)#]+\.md)\)", guide))
    pages = {path.relative_to(ROOT / "docs").as_posix() for path in (ROOT / "docs").glob("[th]*o*/*.md")}
    assert len(pages) > 25
    assert pages - led_to == set()
    assert {page for page in pages if f"\n{page.removesuffix('.md')}\n" not in lists} == set()


def test_the_sidebar_lists_each_guide_under_the_heading_of_the_first_page() -> None:
    guide, lists = (ROOT / "docs" / "index.md").read_text(encoding="utf-8").split("<!-- {toctree}", 1)
    parts = re.split(r"^\*\*I ", guide, flags=re.MULTILINE)[1:]
    headings = [set(re.findall(r"\]\((how-to/[^)#]+)\.md", part)) for part in parts]
    captions = [set(re.findall(r"^how-to/.*", part, re.MULTILINE)) for part in lists.split("{toctree}")]
    assert [pages for pages in captions if pages] == headings


def test_no_page_installs_from_an_index_that_does_not_have_us() -> None:
    pages = [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]
    # In these pages the line adds an extra to an installed package, as messages of commands propose.
    of_commands = {"install.md", "command-line.md"}
    found = {
        page.name
        for page in pages
        if re.search(r"pip install [\"']?unity-link", page.read_text(encoding="utf-8")) and page.name not in of_commands
    }
    assert found == set()


def test_every_picture_of_the_documents_is_shown_and_made_by_a_command() -> None:
    pages = [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]
    shown = {
        Path(name).name
        for page in pages
        for name in re.findall(r"(?:\]\(|src=\")([^)\"]+\.(?:png|svg))", page.read_text())
    }
    made = {path.name for path in (ROOT / "docs" / "images").glob("*.*g")}
    assert made <= shown
    assert made - {"peers.png"} == set(PICTURES)


def test_every_make_target_is_in_the_help() -> None:
    makefile = (ROOT / "Makefile").read_text()
    phony = set(re.search(r"^\.PHONY: (.*)$", makefile, re.MULTILINE)[1].split())  # type: ignore[index]
    described = set(re.findall(r"^([a-z0-9-]+):.*## ", makefile, re.MULTILINE))
    assert phony == described


def test_table_of_commands_has_the_commands_of_each_family() -> None:
    for family in set(FAMILIES.values()):
        alone = typer.Typer()
        importlib.import_module(f"unity_link.cli.{family}").add_to(alone)
        assert sorted(get_group(alone).commands) == sorted(name for name in FAMILIES if FAMILIES[name] == family)


def test_the_reference_of_the_command_line_has_every_command() -> None:
    reference = (ROOT / "docs" / "reference" / "command-line.md").read_text(encoding="utf-8")
    group = get_group(app)
    families = {name for name in FAMILIES if isinstance(group.get_command(Context(group), name), TyperGroup)}
    commands = FAMILIES.keys() - families
    described = set(re.findall(r"^## (.*)$", reference, re.MULTILINE))
    assert commands <= described <= commands | families
    assert {family for family in families if f"unity-link {family} " not in reference} == set()


def test_table_of_files_to_change_names_existing_files() -> None:
    text = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    table = text.partition("## To add something")[2].partition("\n## ")[0]
    paths = {name for name in re.findall(r"`([\w./]+)`", table) if "/" in name or "." in name}
    assert len(paths) > 40
    # An existing medium and an existing target replace NAME in the paths.
    places = [path.replace("NAME", "matlab" if "generate" in path else "udp") for path in sorted(paths)]
    assert [path for path in places if not ((ROOT / path).exists() or (ROOT / "unity_link" / path).exists())] == []


def test_terms_name_items_of_the_code() -> None:
    text = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    rows = [line.split("|") for line in text.partition("## Terms")[2].splitlines() if line.startswith("| ")][1:]
    terms = [row[1].strip() for row in rows]
    assert len(terms) > 50
    assert terms == sorted(set(terms), key=str.lower)
    paths = [path.relative_to(ROOT) for path in tracked_files(ROOT)]
    places = {place.as_posix() for path in paths for place in (path, *path.parents)} | {path.name for path in paths}
    sources = [path for path in paths if path.suffix in {".py", ".vhd"}]
    definition = re.compile(r"^(?: *(?:class|def|entity) |(?=\w+ = ))(\w+)", re.MULTILINE)
    defined = {name for path in sources for name in definition.findall((ROOT / path).read_text(encoding="utf-8"))}
    names = {name for row in rows for name in re.findall(r"`([^`]+)`", row[4])} - places
    assert {part for name in names for part in name.split(".")} - defined == set()
