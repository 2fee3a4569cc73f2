"""The pages of a register map: complete, well-formed, self-contained, and with all contents of the spec."""

# ruff: noqa: RUF001  (the pages have the signs of mathematics)

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import given, settings
from markdown_it import MarkdownIt

from generate.every_kind import WORD_BITS, every_kind
from support.searching import examples
from support.spec_examples import FIGURE_1, specs
from unity_link.generate import generate
from unity_link.generate.docs.pages import Page, number
from unity_link.quoting import markdown
from unity_link.spec import Spec, compile_file, compile_text
from unity_link.spec.printer import print_file

if TYPE_CHECKING:
    from unity_link.spec.syntax import File

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
FIELDS = """\
/// What it does.
enum mode {
  off,
  /// By hand.
  manual = 4
}
/// Slow things.
group slow(3, 1000, ON_CHANGE, TIMESTAMPS);
group later;
/// A robot of <all> & "sundry" | kinds.
public robot(ctrl, base=0x40) {
  GATEWAY(ADDRESS_BITS=12);
  net: TOSNET(CTRL=ctrl, BASE=0x800, NODES=2);
  pool: MEMORY(BASE=0x100, SIZE=256);
  /// How it <moves> | or not.
  @mode = 1[3:0]: mode READWRITE();
  @enable = 1[4]: bool READWRITE();
  @level = 1[31:24]: signed READ(PUBLISH(slow));
  @state = 2[7:0]: READ();
  @command = 2[3:0]: WRITE();
  @clock = 4: unsigned 64 READ(UNIT="us", POLL(5), GROUP(later));
  @speed = 8: signed 16 READWRITE(SCALE=0.00001, OFFSET=-2.5, UNIT="m/s", MIN=-2.7, MAX=-2.3, ID="the speed");
  @log = 9: READ(FIFO(16));
}
"""
VOID = {"meta", "input", "col"}


class Checker(HTMLParser):
    """Parses a page, and checks that each opened element is closed."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.ids: list[str] = []
        self.links: list[str] = []
        self.sources: list[str] = []
        self.cells: list[str] = []
        self.feed(page)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in VOID:
            self.open.append(tag)
        if tag == "td":
            self.cells.append("")
        for name, value in attrs:
            if name == "id":
                self.ids.append(value or "")
            elif name == "href":
                self.links.append(value or "")
            elif name == "src":
                self.sources.append(value or "")

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if "td" in self.open:
            self.cells[-1] += data


def pages(spec: Spec) -> tuple[str, str]:
    html, text = generate("docs", spec)
    assert (Path(html.name).suffix, Path(text.name).suffix) == (".html", ".md")
    return html.text, text.text


def check(spec: Spec) -> None:
    """Check that the pages of a spec are well-formed, and have all signals with their addresses."""
    html, text = pages(spec)
    checker = Checker(html)
    assert checker.sources == []
    assert all(link.startswith("#") for link in checker.links)
    assert len(set(checker.ids)) == len(checker.ids)
    assert {link[1:] for link in checker.links} <= set(checker.ids)
    interface = spec.interface()
    digits = -(-interface.address_bits // 4)
    tables = [row for row in text.splitlines() if row.startswith("| `")]
    for signal in interface.signals.values():
        assert f"s-{signal.path}" in checker.ids
        assert any(
            row.startswith(f"| `{signal.address:0{digits}X}") and f"| {signal.access} |" in row for row in tables
        )
    assert len(tables) == len(interface.signals)
    tokens = MarkdownIt("commonmark").enable("table").parse(text)
    rows = sum(token.type == "tr_open" for token in tokens)
    assert rows == sum(line.startswith("|") and not re.fullmatch(r"[|-]+", line) for line in text.splitlines())


@pytest.mark.parametrize("spec", [compile_file(path) for path in sorted(EXAMPLES.glob("*.ul"))], ids=str)
def test_pages_of_the_examples_are_whole(spec: Spec) -> None:
    check(spec)


@pytest.mark.parametrize("bits", WORD_BITS)
def test_pages_of_every_kind_are_whole(bits: int) -> None:
    check(every_kind(bits))


@pytest.mark.slow
@settings(max_examples=examples(20))
@given(file=specs())
def test_pages_of_any_spec_are_whole(file: File) -> None:
    check(compile_text(print_file(file)))


def test_the_paper_s_figure_has_its_four_joints() -> None:
    html, text = pages(compile_text(FIGURE_1))
    for joint in range(1, 5):
        assert f'id="c-j{joint}"' in html
        assert f"### j{joint}\n\njoint(name = joint {joint})" in text


def test_texts_of_a_spec_cannot_break_the_page() -> None:
    html, text = pages(compile_text(FIELDS))
    assert "A robot of &lt;all&gt; &amp; &#34;sundry&#34; | kinds." in html
    assert "How it \\<moves\\> \\| or not." in text


def test_page_has_every_property_of_a_signal() -> None:
    html, text = pages(compile_text(FIELDS))
    (row,) = (line for line in text.splitlines() if line.startswith("| `008`"))
    assert row == (
        "| `008` | 15:0 | speed | READWRITE | signed 16 | −2.7 … −2.3; 1 × 10⁻⁵ × number − 2.5 | m/s | ID the speed |"
    )
    (row,) = (line for line in text.splitlines() if line.startswith("| `004"))
    assert row == "| `004…005` |  | clock | READ | unsigned 64 | 0 … 1.844674 × 10¹⁹ | us | in later; polled at 5 Hz |"
    assert "FIFO port, 16 words deep" in html
    assert "1 × 10⁻⁵ × number − 2.5" in Checker(html).cells[Checker(html).cells.index("speed") + 3]


def test_fields_are_drawn_with_separate_lanes_if_read_and_write_differ() -> None:
    page = Page(compile_text(FIELDS).interface())
    shared, differing, narrow = page.parts[0].words
    assert [(field.high, field.low, field.signal and field.signal.name) for field in shared.lanes[0][1]] == [
        (31, 24, "level"),
        (23, 5, None),
        (4, 4, "enable"),
        (3, 0, "mode"),
    ]
    assert [title for title, _ in differing.lanes] == ["read", "written"]
    assert [[field.width for field in fields] for _, fields in differing.lanes] == [[24, 8], [28, 4]]
    assert narrow.address == "008"


def test_groups_modules_and_enumerations_have_their_tables() -> None:
    _, text = pages(compile_text(FIELDS))
    assert "| 3 | slow | base frequency / 1000, only when a word has changed, with timestamps | 1 | level |" in text
    assert "|  | later | not published | 2 | clock |" in text
    assert "| 800…87F | TOSNET | net | CTRL=ctrl, NODES=2 |" in text
    assert "| 100…1FF | MEMORY | pool |" in text
    assert "| 4 | manual | By hand. |" in text
    assert "| parameters | ctrl, base = 64 |" in text


CORES = """\
public lamp() {
  dimmers[2]: dimmer(8 + i) @(0x20 + i, lamp="gp" + i, key=none);
  beat: beat() @();
  @on = 0x28[0]: bool READWRITE(PIN="led1", RESET=true);
}
/// Fades.
dimmer(WIDTH): @(BASE) {
  ENTITY("dimmer", TICK, TIME, width=WIDTH, name="<b> | &");
  @level = BASE: unsigned WIDTH READWRITE(RESET=200);
  @lamp: PIN(OUT);
  @key: PIN(IN);
}
beat(): @() { ENTITY("beat"); @pulse: TRIGGER(state); @sound: PIN(OUT); }
group state(TRIGGER);
"""


def test_a_component_with_an_entity_has_it_with_its_generics_and_pins() -> None:
    spec = compile_text(CORES)
    check(spec)
    html, text = pages(spec)
    assert (
        "Entity: " + markdown('work.dimmer(width => 9, name => "<b> | &")') + " with tick, now of the gateway" in text
    )
    assert "| lamp | OUT | gp1 |\n| key | IN | not wired |\n" in text
    assert "| pulse | TRIGGER | group state |" not in text.split("### beat")[0]
    assert "| sound | OUT | no pin of a board yet |\n| pulse | TRIGGER | group state |\n" in text.split("### beat")[1]
    assert "200 after a reset" in text
    assert "true after a reset; at led1" in text
    cells = Checker(html).cells
    assert [cells[cells.index("lamp") + place] for place in range(6)] == [
        "lamp",
        "OUT",
        "gp0",
        "key",
        "IN",
        "not wired",
    ]
    assert "work.dimmer(width =&gt; 8, name =&gt; &#34;&lt;b&gt; | &amp;&#34;)" in html
    assert '<a href="#c-beat">beat</a>' in html


def test_documents_have_safe_values_with_their_lease_schedules_and_pins() -> None:
    spec = compile_text("""
    public arm() {
      GATEWAY(ADDRESS_BITS=12);
      drive: LEASE(TIMEOUT=0.5) @(0x80, enable="gp8");
      plan: SCHEDULE() @(0xA0);
      @angle = 0x10: signed 16 READWRITE(SCALE=0.1, UNIT="deg", SAFE(90, drive), TIMED(plan));
      @key = 0x13[0]: bool READ(PIN="sw0");
    }
    """)
    check(spec)
    html, text = pages(spec)
    notes = ("90 deg after a reset and while drive is not armed", "TIMED by plan")
    assert "; ".join(notes) in text
    assert all(f"<span>{note}</span>" in html for note in notes)
    assert "| sw0 | IN | key |\n| gp8 | OUT | drive.enable |\n" in text
    cells = Checker(html).cells
    place = cells.index("sw0")
    assert cells[place : place + 6] == ["sw0", "IN", "key", "gp8", "OUT", "drive.enable"]


def test_the_map_of_the_largest_memory_is_as_short_as_that_of_any_other() -> None:
    (memory, _, end) = Page(
        compile_text("public x() { GATEWAY(ADDRESS_BITS=32); m: MEMORY(SIZE=0x100000000); }").interface()
    ).map
    assert (memory[0], end[0]) == ("00000000", "FFFFFFF0")


def test_the_map_skips_the_middle_of_a_large_module() -> None:
    page = Page(compile_text(FIELDS).interface())
    assert [first for first, _ in page.map] == ["000", "100", "⋮", "1F0", "800", "⋮", "870"]
    ways = {cell.address: cell.way for _, cells in page.map for cell in cells}
    assert [ways[address] for address in ("001", "002", "004", "003", "100")] == [
        "readwrite",
        "readwrite",
        "read",
        "unused",
        "module",
    ]


@pytest.mark.parametrize(
    ("value", "text"),
    [(0, "0"), (-3, "−3"), (2.5, "2.5"), (1e-05, "1 × 10⁻⁵"), (2**64, "1.844674 × 10¹⁹"), (-1e300, "−1 × 10³⁰⁰")],
)
def test_numbers_are_written_for_people(value: float, text: str) -> None:
    assert number(value) == text


def test_markdown_shows_text_as_it_is() -> None:
    assert markdown("a_b | *c*\n [d]") == r"a\_b \| \*c\* \[d\]"
