"""Pages can be read on a forge, which shows Markdown without directives of Sphinx, and copied from there."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from docs.tables import calls_of, filled, installed_cores
from docs.walkthrough import PAGES, files_of
from unity_link import blocking
from unity_link.boards.board import CHAIN
from unity_link.boards.loading import board_names, load_board

ROOT = Path(__file__).parents[1]
SHOWN = [*PAGES, *ROOT.glob("*.md"), *ROOT.glob("gateware/**/README.md"), *ROOT.glob("examples/**/*.md")]
"""Pages that a forge shows; Sphinx builds those in `PAGES` too."""
WRITTEN = [page for page in PAGES if "make docs-tables`" in page.read_text(encoding="utf-8")]
CORES = ROOT / "docs" / "reference" / "cores" / "index.md"


def wrong_fences(text: str) -> list[str]:
    """Return the first lines of listings with syntax of Sphinx, which a forge shows as text."""
    fences = re.findall(r"^ *(?:```|~~~|:::)+([^\n]*)\n([^\n]*)", text, re.MULTILINE)
    return [
        f"{info}: {first}" for info, first in fences if info.startswith("{") or (info and re.match(r" *:\w", first))
    ]


@pytest.mark.parametrize("page", dict.fromkeys(SHOWN), ids=lambda page: str(page.relative_to(ROOT)))
def test_a_forge_shows_no_options_and_no_directives(page: Path) -> None:
    assert wrong_fences(page.read_text(encoding="utf-8")) == []


@pytest.mark.parametrize("text", ["```{code-block} ul\n:caption: a.ul\n", "```ul\n:caption: a.ul\n", ":::{note}\nA\n"])
def test_a_listing_that_begins_with_an_option_is_found(text: str) -> None:
    assert wrong_fences(text) != []


@pytest.mark.parametrize("page", dict.fromkeys(SHOWN), ids=lambda page: str(page.relative_to(ROOT)))
def test_each_relative_link_leads_to_a_file_on_a_forge(page: Path) -> None:
    shown = re.sub(r"```.*?```|`[^`\n]*`", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    links = re.findall(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)", shown)
    assert [link for link in links if not (page.parent / link).exists()] == []


def empty_sections(text: str) -> list[str]:
    """Return the headings without visible text below them; the whole page if it has no heading."""
    shown = re.sub(
        r"<!--.*?-->", "", re.sub(r"^```.*?^```", "code", text, flags=re.DOTALL | re.MULTILINE), flags=re.DOTALL
    )
    before, *sections = re.split(r"^(?=#+ )", shown, flags=re.MULTILINE)
    levels = [section.index(" ") for section in sections] + [0]
    return [before] * (not sections) + [
        section
        for section, level, following in zip(sections, levels, levels[1:], strict=False)
        if following <= level and not section.partition("\n")[2].strip()
    ]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_no_section_is_empty_on_a_forge(page: Path) -> None:
    assert empty_sections(page.read_text(encoding="utf-8")) == []


@pytest.mark.parametrize("text", ["<!-- {include} a.md\n-->\n", "# A\n\n<!-- {eval-rst}\n-->\n\n# B\n\nText.\n"])
def test_a_page_or_section_without_text_is_found(text: str) -> None:
    assert len(empty_sections(text)) == 1


@pytest.mark.parametrize("page", WRITTEN, ids=lambda page: page.stem)
def test_tables_and_listings_are_those_of_the_sources(page: Path) -> None:
    assert page.read_text(encoding="utf-8") == filled(page), "run make docs-tables"


def test_the_page_of_boards_has_the_pins_of_every_chain() -> None:
    text = (ROOT / "docs" / "how-to" / "boards.md").read_text(encoding="utf-8")
    _, _, table = text.partition("make docs-tables`, chain: begin")
    rows = [line for line in table.partition("<!-- end -->")[0].splitlines() if line.startswith("| `")]
    for name in board_names():
        (row,) = [line for line in rows if f"`{name}`" in line.split(" | ")[0]]
        sites = [re.sub(r"`\w+` \((.*)\)", r"\1", cell) for cell in row.strip("| ").split(" | ")[1:]]
        assert sites == [load_board(name)[1].pins[pin] for pin in CHAIN]


def test_one_table_has_all_cores_one_click_from_the_first_pages() -> None:
    text = CORES.read_text(encoding="utf-8")
    rows = dict(re.findall(r"^\| \[`(\w+)`\]\(\S+\)(.*)$", text, re.MULTILINE))
    folders = {path.parent.name.upper() for path in ROOT.glob("gateware/cores/*/*.ul")}
    assert rows.keys() == folders == {core.word for core in installed_cores()}
    methods = {call.name for core in installed_cores() for call in calls_of(core)}
    assert methods >= {"armed", "kick", "each", "move_to", "stop", "play", "timeline"}
    assert {name for name in methods if f"`{name}`" not in text} == set()
    for page in (ROOT / "README.md", ROOT / "docs" / "index.md"):
        assert re.search(r"\]\((?:docs/)?reference/cores/index\.md\)", page.read_text(encoding="utf-8"))


@pytest.mark.parametrize(("option", "clock_hz"), [("", 50_000_000), ("?clock_hz=25000000", 25_000_000)])
def test_the_clock_of_sim_is_that_of_its_url_and_not_of_the_spec(option: str, clock_hz: int, tmp_path: Path) -> None:
    spec = tmp_path / "arm.ul"
    spec.write_text("public arm() { GATEWAY(CLOCK=12000000); @on = 0x10: bool READWRITE(); }")
    with blocking.connect(f"sim:{spec}{option}", timeout=60) as link:
        assert link.gateway.clock_hz == clock_hz


def test_program_on_the_first_page_prints_the_position_of_the_robot(tmp_path: Path) -> None:
    page = ROOT / "README.md"
    program = tmp_path / "move.py"
    program.write_text(files_of(page)["move.py"], encoding="utf-8")
    done = subprocess.run(
        [sys.executable, str(program)], cwd=ROOT, capture_output=True, text=True, check=True, timeout=120
    )
    assert done.stdout
    assert f"It prints `{done.stdout.strip()}`" in page.read_text(encoding="utf-8")
