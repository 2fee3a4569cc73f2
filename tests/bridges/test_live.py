"""Live pictures in a browser: the values that a page shows, and those that it may write."""

from __future__ import annotations

import json
import re
import socket
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from playwright.sync_api import expect

from support.bridge_programs import wait_until
from support.live_page import COUNTS_PER_DEGREE, POSITION_SET_POINT, SPEC, TOKEN, gateway, live, needs_chromium
from unity_link import blocking

if TYPE_CHECKING:
    from collections.abc import Iterator

    from playwright.sync_api import Browser, Page

    from support.live_page import Live

EXAMPLES = Path(SPEC).parent


@pytest.fixture
def token(monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setenv("UNITY_LINK_TOKEN", TOKEN)
    return TOKEN


@contextmanager
def shown(page: Page, *arguments: str, fragment: str | None = None, begins: str = "\0") -> Iterator[Live]:
    """Run `unity-link live`, and open its page; leave the page before the end, which would cut off open requests."""
    with live(*arguments, begins=begins) as running:
        page.goto(running.url if fragment is None else f"{running.address}#{fragment}")
        yield running
        page.goto("about:blank")


@pytest.mark.slow
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


@pytest.mark.slow
@needs_chromium
def test_cards_of_a_users_robot_have_different_headings_and_it_moves(page: Page) -> None:
    spec = f"{EXAMPLES}/rover.ul"
    own = f"sim:{spec}?model={EXAMPLES}/rover.py:Rover"
    # On a busy machine the robot reports that it is slower than real time.
    with shown(page, own, spec, "--allow-writes", begins="<Rover of rover> is slower than time"):
        page.locator("#write-left\\.duty").fill("0.5")
        page.keyboard.press("Enter")
        expect(page.locator('[data-signal="left.speed"] output')).to_have_text(re.compile(r"^2\.9"))
        headings = page.locator("article h2").all_inner_texts()
    assert len(headings) == len(set(headings)) > 5
    assert "left.speed" in headings


def colors_in(page: Page, card: str) -> int:
    """Return the number of saturated colours, as curves have, in the canvas of a card."""
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


UNKNOWN = """
enum mode { idle = 0, run = 1, stop = 5 }
public m() {
  drive: LEASE(TIMEOUT=1) @(0x00, enable=none, estop=none);
  @volts = 0x20: signed 12 WRITE(SCALE=12 / 2047, UNIT="V", MIN=-12, MAX=12);
  @amps = 0x21: signed 12 WRITE(UNIT="A", MIN=5, MAX=12, SAFE(5, drive));
  @brake = 0x22[0]: bool WRITE();
  @mode = 0x23[2:0]: mode WRITE();
  @fire = 0x24[0]: bool WRITE(EFFECT=PULSE);
}
"""


@needs_chromium
@pytest.mark.slow
def test_controls_of_unknown_values_show_none_and_no_single_key_writes_one(page: Page, tmp_path: Path) -> None:
    spec = tmp_path / "m.ul"
    spec.write_text(UNKNOWN)
    # This gateway has words at all addresses, so that the test can read the written values.
    with gateway(tmp_path / "gateway", "serve", "sim:") as url, shown(page, url, str(spec), "--allow-writes"):
        volts, mode, brake = (page.locator(f"#write-{name}") for name in ("volts", "mode", "brake"))
        expect(volts).to_be_enabled()
        for name, place in (("volts", "0"), ("amps", "5")):
            slider = page.get_by_label(f"{name}, slider")
            expect(slider).to_be_disabled()
            expect(slider).to_have_value(place)
        assert page.locator("main .control input[type=checkbox]").count() == 0
        for control in (volts, page.locator("#write-amps"), mode, brake, page.locator("#write-fire")):
            expect(control).to_have_value("")
            for key in ("ArrowUp", "ArrowDown", "PageUp", "Home", "End"):
                control.press(key)
            expect(control).to_have_value("")

        volts.fill("-3")
        volts.press("Enter")
        mode.select_option("stop")
        brake.select_option("off")
        page.locator("#write-fire").select_option("on")
        slider = page.get_by_label("volts, slider")
        expect(slider).to_be_enabled()
        assert float(slider.input_value()) == pytest.approx(-3, abs=0.01)
        with blocking.connect(url) as link:
            # A value written by one of the keys would have been written before the chosen values.
            wait_until(lambda: (link.read(0x20) % 2**12, link.read(0x23)) == (2**12 - 512, 5))
            assert [link.read(address) for address in (0x21, 0x22)] == [0, 0]
            page.locator("#write-amps").fill("7")
            page.locator("#write-amps").press("Enter")
            wait_until(lambda: link.read(0x21) == 7)

        # A page that is opened later knows the same values; a pulse and a guarded value have none.
        page.reload()
        expect(volts).to_have_value(re.compile(r"^-3\.00"))
        expect(mode).to_have_value("5")
        expect(brake).to_have_value("0")
        for name in ("amps", "fire"):
            expect(page.locator(f"#write-{name}")).to_have_value("")


@needs_chromium
@pytest.mark.slow
def test_a_control_of_a_sampled_signal_is_disabled_until_its_value_is_known(page: Page) -> None:
    with shown(page, "sim:scara", SPEC):
        states = page.evaluate(
            """async () => {
              const { Control } = await import("/controls.js");
              const about = { path: "a", name: "a", unit: "V", doc: "", step: 1, low: -45, high: 45, stream: 0 };
              const state = (control) => {
                const { input, slider } = control;
                const value = input.type === "checkbox" ? !input.indeterminate && input.checked : input.value;
                return [input.disabled, value, input.indeterminate, slider?.disabled, slider?.value];
              };
              const names = [[0, "idle"], [3, "run"]];
              return ["signed", "float", "bool", "enum"].map((kind) => {
                const step = kind === "float" ? null : 1;
                const control = new Control({ ...about, kind, names, step, limited: true }, () => null);
                control.enable(true);
                const states = [null, 3, NaN, null].map((value) => {
                  control.see(value);
                  return state(control);
                });
                control.enable(false);
                return [...states, state(control)];
              });
            }"""
        )
    unknown, known, away = [True, "", False, True, "0"], [False, "3", False, False, "3"], [False, "", False, True, "0"]
    number = [unknown, known, away, unknown, unknown]
    switch = [True, False, True, None, None]
    choice = [True, "", None, None, None]
    assert states[0] == states[1] == number
    assert states[2] == [switch, [False, True, False, None, None], [False, False, True, None, None], switch, switch]
    assert states[3] == [choice, [False, "3", None, None, None], [False, "", None, None, None], choice, choice]


@needs_chromium
def test_page_without_permission_to_write_has_no_controls(page: Page) -> None:
    with shown(page, "sim:scara", SPEC) as running:
        assert "#" not in running.url
        expect(page.locator("#state")).to_have_text("connected")
        expect(page.locator('[data-signal="j1.pos_sp"] output')).to_have_text("0.000")
        assert page.locator("main input, main select").count() == 0
        assert page.locator("#notice").is_hidden()


@needs_chromium
def test_page_with_a_wrong_token_reports_it_and_cannot_write(page: Page) -> None:
    with shown(page, "sim:scara", SPEC, "--allow-writes", fragment="token=wrong"):
        expect(page.locator("#notice")).to_contain_text("Open the link that unity-link live printed")
        expect(page.locator("#write-j1\\.pos_sp")).to_be_disabled()


@pytest.mark.slow
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
        # Each frame draws all visible plots, at least two.
        assert 2 * (frames - 2) <= plots <= cards * (frames + 2)
        assert samples >= 1000


@pytest.mark.slow
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


@pytest.mark.slow
@needs_chromium
def test_page_reports_an_absent_gateway_and_continues_when_it_returns(page: Page, tmp_path: Path) -> None:
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


@pytest.mark.slow
@needs_chromium
def test_page_shows_the_error_of_a_shared_link_without_its_gateway(page: Page, tmp_path: Path) -> None:
    simulate = ("simulate", "--robot", "scara")
    with ExitStack() as stack:
        with gateway(tmp_path / "gateway", *simulate) as behind:
            shared = stack.enter_context(gateway(tmp_path / "shared", "serve", behind))
            stack.enter_context(shown(page, shared, SPEC, begins="read of j"))
            expect(page.locator("#state")).to_have_text("connected")
        expect(page.locator("#state")).to_have_text(re.compile("read of j.* at 0x.*: nothing on the bus answered"))

        stack.enter_context(gateway(tmp_path / "gateway", *simulate))
        expect(page.locator("#state")).to_have_text("connected")


@pytest.mark.slow
@needs_chromium
def test_page_reconnects_when_the_program_restarts(page: Page, token: str) -> None:
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
def test_whole_number_wider_than_a_double_is_written_and_shown_exactly(page: Page) -> None:
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
              const [at, missing, values] = [1, 2, 3].map(() => new Float64Array(count));
              for (let i = 0; i < count; i++) at[i] = 1e9 + i / 50000;
              values[count - 77] = 5;
              values[count - 1234] = -7;
              history.take(stream, { count, at, missing, columns: [values] }, 10);
              history.flush();
              const [x, y] = history.rows;
              return [x.length, Math.max(...y), Math.min(...y), x.every((one, i) => i === 0 || one >= x[i - 1])];
            }"""
        )
        assert rows <= 8192
        assert (high, low, ascending) == (5, -7, True)


@pytest.mark.slow
@needs_chromium
@pytest.mark.parametrize("rate", [10, 50000], ids=["each sample is a row", "a row has many samples"])
def test_a_curve_has_a_gap_before_a_sample_that_others_are_missing_before(page: Page, rate: int) -> None:
    with shown(page, "sim:scara", SPEC):
        values = page.evaluate(
            """async (rate) => {
              const { History } = await import("/history.js");
              const stream = { rate, latest: [null] };
              const history = new History([{ stream, column: 0 }]);
              const at = [1, 2, 7, 8].map((second) => 1e9 + second);
              history.take(stream, { count: 4, at, missing: [0, 0, 1, 0], columns: [[5, 6, 7, 8]] }, 10);
              history.flush();
              return history.rows[1];
            }""",
            rate,
        )
    assert values == [5, 6, None, 7, 8]


@pytest.mark.slow
@needs_chromium
@pytest.mark.parametrize(
    ("began", "polled", "shown_then"),
    [(1.02, [], [7, 7]), (9.0, [], [None, None]), (9.0, [8.9], [8, 8]), (9.0, [1.1], [None, None])],
    ids=["one was lost", "the gateway was away", "polled before the others went on", "polled after the others stopped"],
)
def test_plot_of_several_streams_holds_no_value_from_before_an_absence(
    page: Page, began: float, polled: list[float], shown_then: list[float | None]
) -> None:
    with shown(page, "sim:scara", SPEC):
        rows = page.evaluate(
            """async ({ began, polled }) => {
              const { History } = await import("/history.js");
              const { Stream } = await import("/streams.js");
              const [quick, slow] = [100, 2].map((rate) => new Stream({ name: "", rate_hz: rate }, 1));
              const history = new History([{ stream: quick, column: 0 }, { stream: slow, column: 0 }]);
              quick.cards.push({ history });
              const take = (stream, at, value, gap) =>
                stream.take({ count: 1, at: [at], missing: [gap], columns: [[value]] }, 1);
              take(slow, 0.9, 7, 0);
              take(quick, 1, 1, 0);
              for (const at of polled) take(slow, at, 8, 0);
              take(quick, began, 2, 1);
              take(quick, began + 0.01, 3, 0);
              take(slow, began + 0.015, 9, 0);
              take(quick, began + 0.02, 4, 0);
              history.flush();
              return history.rows[2];
            }""",
            {"began": began, "polled": polled},
        )
    # Each sample of the quick stream is a row, and the gap is a row too.
    assert rows == [7, None, *shown_then, 9]


@pytest.mark.slow
@needs_chromium
def test_states_keep_their_places_in_a_plot_and_have_their_names_there(page: Page) -> None:
    with shown(page, "sim:scara", SPEC):
        low, high, numbers, names = page.evaluate(
            """async () => {
              const { makePlot } = await import("/plots.js");
              const { stateNumbers, text } = await import("/values.js");
              const mode = { kind: "enum", names: [[0, "idle"], [1, "run"], [5, "stop"]] };
              const element = document.body.appendChild(document.createElement("div"));
              element.style.cssText = "width: 400px; height: 200px";
              const name = (state) => text(mode, state);
              const plot = makePlot(element, [{ label: "mode", stepped: true }], stateNumbers(mode), name);
              plot.setData([[0, 1], [1, 1]]);
              await new Promise((drawn) => setTimeout(drawn, 100));
              return [plot.scales.y.min, plot.scales.y.max, plot.axes[1]._splits, plot.axes[1]._values];
            }"""
        )
    assert -1 < low < 0
    assert 5 < high < 6
    assert (numbers, names) == ([0, 1, 5], ["idle", "run", "stop"])


@pytest.mark.slow
@needs_chromium
def test_single_sample_between_gaps_is_a_point(page: Page) -> None:
    with shown(page, "sim:scara", SPEC):
        colored = page.evaluate(
            """async () => {
              const { makePlot, show } = await import("/plots.js");
              const element = document.createElement("div");
              element.style.cssText = "width: 400px; height: 200px";
              document.body.append(element);
              const colored = [];
              const no = null;
              for (const values of [[no, no, 1, no, no], [no, no, no, no, no], [no, 1, 1, 1, no]]) {
                element.replaceChildren();
                const curve = { label: "one", stepped: false };
                const plot = makePlot(element, [curve], null);
                show(plot, [[1, 2, 3, 4, 5], values], 6, 6);
                await new Promise((done) => setTimeout(done, 100));
                const canvas = element.querySelector("canvas");
                const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
                let found = 0;
                for (let i = 0; i < data.length; i += 4) {
                  const color = data.slice(i, i + 3);
                  found += data[i + 3] > 200 && Math.max(...color) - Math.min(...color) > 100;
                }
                colored.push(found);
              }
              element.remove();
              return colored;
            }"""
        )
    alone, none, line = colored
    assert none == 0
    assert 4 < alone < line


@pytest.mark.slow
@needs_chromium
def test_plot_window_matches_its_list_when_the_browser_returns_to_the_page(page: Page) -> None:
    with shown(page, "sim:scara", SPEC):
        page.locator("#window").select_option("60")
        page.goto("about:blank")
        page.go_back()
        expect(page.locator("#state")).to_have_text("connected")
        assert page.locator("#window").input_value() == "60"
        assert page.evaluate("window.unityLink.window") == 60


@pytest.mark.slow
@needs_chromium
def test_open_page_accepts_the_address_of_a_restarted_program(page: Page) -> None:
    with shown(page, "sim:scara", SPEC, "--allow-writes", fragment="token=old") as running:
        expect(page.locator("#state")).to_have_text("connected")
        expect(page.get_by_label("pos_sp", exact=True).first).to_be_disabled()
        page.evaluate(f"location.hash = {json.dumps(running.url.partition('#')[2])}")
        expect(page.get_by_label("pos_sp", exact=True).first).to_be_enabled()
