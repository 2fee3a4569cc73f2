"""Notebook displays of links, robots, signals, samples and statistics: tables in which all texts are escaped."""

from __future__ import annotations

import asyncio
from html.parser import HTMLParser
from typing import Any

from hypothesis import given
from hypothesis import strategies as st

import unity_link
from support.recordings import SPEC
from support.simulated_time import on_simulated_time
from unity_link import blocking
from unity_link.data import Group
from unity_link.data.blocking import put
from unity_link.link import html
from unity_link.spec import compile_text

HOSTILE = '<script>alert("1")</script> & <img src=x onerror=alert(1)>'


class Shown(HTMLParser):
    """Parses a page as a browser would: the tags, and the text of each cell."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.tags: set[str] = set()
        self.rows: list[list[str]] = []
        self.title = ""
        self._cell: list[str] | None = None
        self._in_title = False
        self.feed(page)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        assert {name for name, _ in attrs} <= {"style"}
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self._cell = []
        self._in_title = tag == "p"

    def handle_endtag(self, tag: str) -> None:
        if tag in ("td", "th") and self._cell is not None:
            self.rows[-1].append("".join(self._cell))
            self._cell = None
        self._in_title = False

    def handle_data(self, data: str) -> None:
        if self._cell is not None:
            self._cell.append(data)
        elif self._in_title:
            self.title += data

    @property
    def cells(self) -> dict[str, list[str]]:
        """The cells after the first one of each row, by the text of the first one."""
        return {first: rest for first, *rest in self.rows}


def shown(thing: Any) -> Shown:
    return Shown(thing._repr_html_())


@on_simulated_time
async def test_each_object_shows_its_known_values_without_a_request() -> None:
    async with unity_link.connect("sim:scara") as link:
        robot = unity_link.load(SPEC)(link)
        await robot.j1.pos_sp.set(30)
        async with robot.groups["state"].subscribe() as samples:
            batch = await samples.take(40)
        values = await robot.groups["state"].get()
        before = link.statistics

        things = [link, before, robot, robot.j1, robot.j1.pos_sp, robot.groups["state"], Group(robot.j2), batch, values]
        pages = [shown(thing) for thing in things]

        assert link.statistics == before
    assert [page.title for page in pages[2:7]] == [
        *("Scara scara", "Joint j1", "j1.pos_sp", "group state: 8 signals", "group a group: 4 signals")
    ]
    of_link, statistics, of_robot, of_part, of_signal, _, unseen, of_batch, of_values = (page.cells for page in pages)
    assert pages[0].title == "link to sim:scara, connected"
    assert of_link["gateway"][0].startswith("words of 32 bits")
    assert of_link["samples"] == statistics["samples"] == ["40"]
    assert of_robot.keys() == {"signal", *(signal.path for signal in robot.signals)}
    assert of_part["j1.pos_sp"][:2] == of_signal["j1.pos_sp"][:2] == ["30.0006", "deg"]
    assert of_signal["j1.pos_sp"][3:] == ["readwrite", "0x8c", "Position set point."]
    assert unseen["j2.pos_sp"][:3] == ["-", "deg", "never"]
    assert pages[7].rows[0][:2] == ["time [s]", "j1.cpos [deg]"]
    assert len(pages[7].rows) == 1 + 5 + 1 + 5
    assert [f"{sample.time:.6f}" for sample in [*batch][:5]] == [*of_batch][1:6]
    assert of_values["j4.cpos"] == ["0", "deg"]


def test_blocking_links_and_their_robots_have_the_same_displays() -> None:
    with blocking.connect("sim:scara") as link:
        robot = put(unity_link.load(SPEC), link)
        robot.j1.pos_sp.set(30)
        assert shown(robot.j1).cells["j1.pos_sp"][:2] == ["30.0006", "deg"]
        assert shown(link).title == "blocking link to sim:scara, connected"
    assert shown(link).title == "blocking link to sim:scara, closed"
    assert shown(robot.j1.pos_sp).cells["j1.pos_sp"][0] == "30.0006"
    assert robot.groups["state"].subscribe.__name__ == "subscribe"


@given(st.text())
def test_the_content_of_a_cell_is_escaped(text: str) -> None:
    page = Shown(html.table(text, [(text, HOSTILE)], (HOSTILE, text)))

    assert page.tags == {"p", "table", "thead", "tbody", "tr", "th", "td"}
    assert page.rows[0][0] == page.rows[1][1] == HOSTILE
    if "\r" not in text and "\0" not in text and len(text) <= html.LONGEST:
        assert page.rows[1][0] == page.rows[0][1] == page.title == text


def test_texts_of_a_spec_are_escaped_and_long_ones_are_cut() -> None:
    spec = compile_text(f"""
    public robot() {{
      /// {HOSTILE}
      @x = 0x10: READ(UNIT="<i>", ID="<b>");
      /// {"long " * 1000}
      @y = 0x11: READ();
    }}
    """)

    async def show() -> Shown:
        async with unity_link.connect("sim:") as link:
            return shown(unity_link.load(spec)(link))

    page = asyncio.run(show())
    assert page.tags == {"p", "table", "thead", "tbody", "tr", "th", "td"}
    assert page.cells["x"][-1] == HOSTILE
    assert len(page.cells["y"][-1]) == html.LONGEST


@on_simulated_time
async def test_a_robot_of_many_signals_shows_the_first_and_the_last() -> None:
    lines = "".join(f"@s{number} = {number}: READ();" for number in range(200))
    async with unity_link.connect("sim:") as link:
        page = shown(unity_link.load(compile_text(f"public robot() {{ {lines} }}"))(link))
    paths = [row[0] for row in page.rows[1:]]
    assert paths == [*(f"s{number}" for number in range(30)), "…", *(f"s{number}" for number in range(170, 200))]
