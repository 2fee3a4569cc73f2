"""Live pictures in a browser: what it shows, and what it may write."""

from __future__ import annotations

import re
import shutil
import socket
from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING, Any

import pytest
from playwright.sync_api import expect, sync_playwright

from bridge_programs import PATIENCE, wait_until
from live_page import COUNTS_PER_DEGREE, POSITION_SET_POINT, SPEC, TOKEN, gateway, live
from unity_link import blocking

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from playwright.sync_api import Browser, Page

    from live_page import Live

CHROMIUM = shutil.which("chromium")

needs_chromium = pytest.mark.skipif(CHROMIUM is None, reason="needs Chromium: apt install chromium")


@pytest.fixture
def token(monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setenv("UNITY_LINK_TOKEN", TOKEN)
    return TOKEN


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield opened
        opened.close()


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """A page that may not complain."""
    context = browser.new_context(viewport={"width": 1280, "height": 900})
    context.set_default_timeout(1000 * PATIENCE)
    expect.set_options(timeout=1000 * PATIENCE)
    opened = context.new_page()
    complaints: list[str] = []
    opened.on("pageerror", lambda error: complaints.append(str(error)))
    # A server that has gone is a complaint of the browser's own, which no page can avoid.
    opened.on(
        "console",
        lambda said: (
            complaints.append(said.text)
            if said.type in {"error", "warning"} and "net::ERR_CONNECTION_" not in said.text
            else None
        ),
    )
    yield opened
    context.close()
    assert complaints == []


@contextmanager
def shown(page: Page, *arguments: str, fragment: str | None = None, begins: str = "\0") -> Iterator[Live]:
    """Run `unity-link live`, and look at it; the page leaves first, as a file on its way would be cut off otherwise."""
    with live(*arguments, begins=begins) as running:
        page.goto(running.url if fragment is None else f"{running.address}#{fragment}")
        yield running
        page.goto("about:blank")


@needs_chromium
def test_the_page_shows_a_robot_that_it_moves(page: Page) -> None:
    with shown(page, "sim:scara", SPEC, "--allow-writes"):
        expect(page.locator("#robot")).to_have_text("scara")
        expect(page.locator("#state")).to_have_text("connected")
        expect(page.get_by_label("pos_sp", exact=True).first).to_be_enabled()

        page.locator("#write-j1\\.pos_sp").fill("40")
        page.keyboard.press("Enter")

        expect(page.locator('[data-signal="j1.cpos"] output')).to_have_text("40.000")
        expect(page.locator('[data-signal="j1.cpos"] .unit')).to_have_text("deg")
        expect(page.locator('[data-signal="j2.cpos"] output')).to_have_text("0.000")
        assert colors_in(page, "article >> nth=0") >= 2
        wait_until(lambda: page.locator("#histogram canvas").count() == 1)


def colors_in(page: Page, card: str) -> int:
    """Count the colours that are saturated, as those of curves are, in the canvas of a card."""
    found: int = page.locator(f"{card} >> canvas").evaluate(
        """canvas => {
          const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
          const hues = new Set();
          for (let i = 0; i < data.length; i += 4) {
            const [low, high] = [Math.min(...data.slice(i, i + 3)), Math.max(...data.slice(i, i + 3))];
            if (data[i + 3] === 255 && high - low > 120) hues.add(data.slice(i, i + 3).indexOf(high));
          }
          return hues.size;
        }"""
    )
    return found


@needs_chromium
def test_a_slider_is_moved_by_the_keyboard_and_writes_within_the_limits(page: Page, tmp_path: Path) -> None:
    with gateway(tmp_path / "shared", "serve", "sim:scara") as url, shown(page, url, SPEC, "--allow-writes"):
        slider = page.get_by_label("j1.pos_sp, slider")
        expect(slider).to_be_enabled()

        slider.focus()
        page.keyboard.press("End")

        with blocking.connect(url) as link:
            wait_until(lambda: link.read(POSITION_SET_POINT) == round(130 * COUNTS_PER_DEGREE))
        number = page.locator("#write-j1\\.pos_sp")
        expect(number).to_have_value("130")

        number.fill("131")
        page.keyboard.press("Enter")

        answer = page.locator(".control", has=number).locator(".answer")
        expect(answer).to_contain_text("j1.pos_sp: 131 is outside of its limits, -130 to 130 deg")
        with blocking.connect(url) as link:
            assert link.read(POSITION_SET_POINT) == round(130 * COUNTS_PER_DEGREE)


@needs_chromium
def test_without_leave_to_write_the_page_has_nothing_to_write_with(page: Page) -> None:
    with shown(page, "sim:scara", SPEC) as running:
        assert "#" not in running.url
        expect(page.locator("#state")).to_have_text("connected")
        expect(page.locator('[data-signal="j1.pos_sp"] output')).to_have_text("0.000")
        assert page.locator("main input, main select").count() == 0
        assert page.locator("#notice").is_hidden()


@needs_chromium
def test_a_page_with_a_wrong_token_says_so_and_is_only_for_looking(page: Page) -> None:
    with shown(page, "sim:scara", SPEC, "--allow-writes", fragment="token=wrong"):
        expect(page.locator("#notice")).to_contain_text("Open the link that unity-link live printed")
        expect(page.locator("#write-j1\\.pos_sp")).to_be_disabled()


@needs_chromium
def test_every_frame_of_the_browser_shows_another_picture(page: Page) -> None:
    with shown(page, "sim:scara", SPEC):
        wait_until(lambda: page.evaluate("unityLink.samples") > 500)
        frames, plots, cards, samples = page.evaluate(
            """async () => {
              const { plots: before, samples: then } = unityLink;
              let frames = 0;
              while (unityLink.samples < then + 1000) {
                await new Promise(requestAnimationFrame);
                frames++;
              }
              const cards = document.querySelectorAll("main .plot").length;
              return [frames, unityLink.plots - before, cards, unityLink.samples - then];
            }"""
        )
        # In each of them each plot that can be seen, of which there are at least two.
        assert 2 * (frames - 2) <= plots <= cards * (frames + 2)
        assert samples >= 1000


@needs_chromium
@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_page_fits_a_screen_and_a_phone_in_light_and_dark(browser: Browser, width: int, scheme: Any) -> None:
    with live("sim:scara", SPEC, "--allow-writes") as running:
        context = browser.new_context(viewport={"width": width, "height": 844}, color_scheme=scheme)
        page = context.new_page()
        page.goto(running.url)
        expect(page.locator("#state")).to_have_text("connected")
        expect(page.locator("canvas").first).to_be_visible()
        assert page.evaluate("document.documentElement.scrollWidth") == width
        assert page.evaluate("[...document.querySelectorAll('article')].every(e => e.scrollWidth <= e.clientWidth)")
        red, *_ = page.evaluate("getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)")
        assert (red > 200) == (scheme == "light")
        context.close()


@needs_chromium
def test_the_page_says_when_the_gateway_is_away_and_goes_on_when_it_is_back(page: Page, tmp_path: Path) -> None:
    place = tmp_path / "gateway"
    simulate = ("simulate", "--robot", "scara")
    with ExitStack() as stack:
        with gateway(place, *simulate) as url:
            stack.enter_context(shown(page, url, SPEC, "--allow-writes"))
            expect(page.locator("#state")).to_have_text("connected")
        expect(page.locator("#state")).to_have_text("gateway away")
        page.locator("#write-j1\\.pos_sp").fill("5")
        page.keyboard.press("Enter")
        expect(page.locator("main .answer").first).to_have_text("the link is away: nothing was written")

        with gateway(place, *simulate):
            expect(page.locator("#state")).to_have_text("connected")
            page.locator("#write-j1\\.pos_sp").fill("9")
            page.keyboard.press("Enter")
            expect(page.locator('[data-signal="j1.cpos"] output')).to_have_text("9.000")


@needs_chromium
def test_the_page_says_what_a_shared_link_answers_while_its_gateway_is_away(page: Page, tmp_path: Path) -> None:
    simulate = ("simulate", "--robot", "scara")
    with ExitStack() as stack:
        with gateway(tmp_path / "gateway", *simulate) as behind:
            shared = stack.enter_context(gateway(tmp_path / "shared", "serve", behind))
            stack.enter_context(shown(page, shared, SPEC, begins="read at 0x"))
            expect(page.locator("#state")).to_have_text("connected")
        expect(page.locator("#state")).to_have_text(re.compile("read at 0x.*: nothing on the bus answered"))

        stack.enter_context(gateway(tmp_path / "gateway", *simulate))
        expect(page.locator("#state")).to_have_text("connected")


@needs_chromium
def test_the_page_comes_back_when_the_program_does(page: Page, token: str) -> None:
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = str(free.getsockname()[1])
    with live("sim:scara", SPEC, "--allow-writes", "--port", port) as running:
        page.goto(running.url)
        expect(page.locator("#state")).to_have_text("connected")
    expect(page.locator("#state")).to_have_text("unity-link live has ended")

    with live("sim:scara", SPEC, "--allow-writes", "--port", port):
        expect(page.locator("#state")).to_have_text("connected")
        page.locator("#write-j2\\.pos_sp").fill("-9")
        page.keyboard.press("Enter")
        expect(page.locator('[data-signal="j2.cpos"] output')).to_have_text("-9.000")


@needs_chromium
def test_words_without_a_spec_have_a_plot_each(page: Page) -> None:
    with shown(page, "sim:scara", "--watch", "0x88", "--watch", "0x8C"):
        expect(page.locator('[data-signal="word_8C"] output')).to_have_text("0")
        assert page.locator("main .plot").count() == 2
        expect(page.locator("main h2").first).to_have_text("0x88")


@needs_chromium
def test_a_whole_number_that_is_wider_than_a_double_is_written_and_shown_exactly(page: Page) -> None:
    with shown(page, "sim:?data_bits=64", "--watch", "0x10", "--allow-writes"):
        number = page.locator("#write-word_10")
        expect(number).to_be_enabled()

        number.fill("-9007199254740993")
        page.keyboard.press("Enter")

        expect(page.locator('[data-signal="word_10"] output')).to_have_text("-9007199254740993")
        expect(number).to_have_value("-9007199254740993")


@needs_chromium
def test_plots_keep_every_peak_in_a_bounded_number_of_rows(page: Page) -> None:
    with shown(page, "sim:scara", SPEC):
        rows, high, low, ascending = page.evaluate(
            """async () => {
              const { History } = await import("/history.js");
              const stream = { rate: 50000, latest: [null] };
              const history = new History([{ stream, column: 0 }]);
              const count = 500_000;
              const [at, lost, values] = [1, 2, 3].map(() => new Float64Array(count));
              for (let i = 0; i < count; i++) at[i] = 1e9 + i / 50000;
              values[count - 77] = 5;
              values[count - 1234] = -7;
              history.take(stream, { count, at, lost, columns: [values] }, 10);
              history.flush();
              const [x, y] = history.rows;
              return [x.length, Math.max(...y), Math.min(...y), x.every((one, i) => i === 0 || one >= x[i - 1])];
            }"""
        )
        assert rows <= 8192
        assert (high, low, ascending) == (5, -7, True)


SWITCHES = """
enum mode { idle, running = 3, recovering = 5 }
group state(1, 10);
joint(): @(base) {
  @pos = base: READ(PUBLISH(state), UNIT="rad");
  @speed = base + 1: READ(PUBLISH(state), UNIT="rad/s");
}
public rover() {
  @enabled = 0x10[0]: bool READWRITE(PUBLISH(state));
  @mode = 0x11[2:0]: mode READ(PUBLISH(state));
  @count = 0x12: READ(PUBLISH(state));
  left: joint() @(0x20);
}
"""


@needs_chromium
def test_switches_and_enumerations_have_names_at_their_axis_and_cards_of_a_part_their_unit(
    page: Page, tmp_path: Path
) -> None:
    spec = tmp_path / "rover.ul"
    spec.write_text(SWITCHES)
    # What is drawn on a canvas is told to it as text.
    page.add_init_script("""
      window.drawn = new Set();
      const fillText = CanvasRenderingContext2D.prototype.fillText;
      CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
        const card = this.canvas.closest("article");
        if (card) window.drawn.add(`${card.querySelector("h2").textContent}: ${text}`);
        return fillText.call(this, text, ...rest);
      };
    """)
    url = f"sim:{spec}?base_frequency_millihertz=1000000"
    with shown(page, url, str(spec)):
        expect(page.locator('[data-signal="enabled"] output')).to_have_text("off")
        page.wait_for_function("[...window.drawn].some((text) => text.startsWith('count: 0'))")
        drawn = page.evaluate("[...window.drawn]")
        axes = {
            name: {text.partition(": ")[2] for text in drawn if text.startswith(f"{name}: ")}
            for name in ("enabled", "mode")
        }
        assert {text for text in axes["enabled"] if not text.endswith((" s", "now"))} == {"on", "off"}
        assert {text for text in axes["mode"] if not text.endswith((" s", "now"))} == {"idle", "running", "recove…"}
        assert page.locator("main h2").all_text_contents() == ["enabled", "mode", "count", "left, rad", "left, rad/s"]
