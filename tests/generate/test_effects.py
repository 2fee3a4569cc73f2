"""Signals with an effect in generated clients: no event is lost with an answer, and no write changes a neighbour.

Each program does the same on a robot that counts: it makes, reads and clears events, and makes pulses. The answer to
its first read that clears events is lost.
"""

from __future__ import annotations

import contextlib
import re
from typing import TYPE_CHECKING

import pytest

from generate.octave import Octave, doubles
from generate.peers import FaultyLine, lose, serve
from generate.programs import CPP, SANITIZED, C, compiled, generated, linked, output
from support.effects import ALL, SPEC, effects_gateway, events
from unity_link.generate import generate
from unity_link.protocol.wire.configuration import Feature

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

FIRST, SECOND, ALARMS = events(seen=0xA5, hit=1), events(seen=1), events(alarm=3, lost=0xFF)
EXPECTED = "165 1 0 0 1 0 1 255 0 1 240 0 1 240 1 0 6 1"
"""Output of each program: see `C_PROGRAM`."""
REFUSED = "seen{where}: each read clears it, which takes the queue commands that the gateway was built without"

C_PROGRAM = f"""\
#include "robot.h"
#include <inttypes.h>
#include <stdio.h>
static ul_link the_link;
static void check(ul_status status) {{ if (status) printf("%s\\n", ul_error(&the_link)); }}
static void show(const ul_unsigned *signal)
{{
    uint64_t value = 99;
    check(ul_get_unsigned(&the_link, signal, &value));
    printf("%" PRIu64 " ", value);
}}
static void show_bool(const ul_bool *signal)
{{
    bool value;
    check(ul_get_bool(&the_link, signal, &value));
    printf("%d ", value);
}}
static void show_word(void)
{{
    show_bool(&robot.alarm[0]);
    show_bool(&robot.alarm[1]);
    show(&robot.lost);
}}
int main(int count, char **arguments)
{{
    if (ul_connect(&the_link, arguments[1], 5.0)) return puts(ul_error(&the_link));
    check(ul_set_unsigned(&the_link, &robot.make, {FIRST}));
    show(&robot.seen);
    if (count > 2) return (int)ul_close(&the_link);
    show_bool(&robot.hit);
    show(&robot.seen);
    show_bool(&robot.hit);
    check(ul_set_unsigned(&the_link, &robot.make, {SECOND}));
    show(&robot.seen);
    check(ul_set_unsigned(&the_link, &robot.make, {ALARMS}));
    check(ul_set_bool(&the_link, &robot.alarm[0], true));
    show_word();
    check(ul_set_unsigned(&the_link, &robot.lost, 0x0F));
    check(ul_post_bool(&the_link, &robot.alarm[1], false));
    show_word();
    check(ul_set_bool(&the_link, &robot.shoot, true));
    show_word();
    show(&robot.shots);
    check(ul_set_unsigned(&the_link, &robot.mode, 5));
    check(ul_set_bool(&the_link, &robot.start, true));
    show_bool(&robot.start);
    check(ul_set_unsigned(&the_link, &robot.mode, 6));
    show(&robot.mode);
    show(&robot.starts);
    return (int)ul_close(&the_link);
}}
"""
CPP_PROGRAM = f"""\
#include "robot.hpp"
#include <iostream>
template <class T> void show(const T &signal) {{ std::cout << +signal.get() << " "; }}
int main(int count, char **arguments) try {{
    unity_link::Link link{{arguments[1]}};
    Robot the_robot{{link}};
    auto show_word = [&] {{ show(the_robot.alarm[0]); show(the_robot.alarm[1]); show(the_robot.lost); }};
    the_robot.make.set({FIRST}u);
    show(the_robot.seen);
    if (count > 2) return 0;
    show(the_robot.hit);
    show(the_robot.seen);
    show(the_robot.hit);
    the_robot.make.set({SECOND}u);
    show(the_robot.seen);
    the_robot.make.set({ALARMS}u);
    the_robot.alarm[0].set(true);
    show_word();
    the_robot.lost.set(0x0Fu);
    the_robot.alarm[1].post(false);
    show_word();
    the_robot.shoot.set(true);
    show_word();
    show(the_robot.shots);
    the_robot.mode.set(5u);
    the_robot.start.set(true);
    show(the_robot.start);
    the_robot.mode.set(6u);
    show(the_robot.mode);
    show(the_robot.starts);
}} catch (const unity_link::Error &error) {{
    std::cout << error.what() << std::endl;
}}
"""
OCTAVE = f"""\
robot = robot('{{url}}');
robot.make.set({FIRST});
values = [robot.seen.get(), robot.hit.get(), robot.seen.get(), robot.hit.get()];
robot.make.set({SECOND});
values(end + 1) = robot.seen.get();
word = @() [robot.alarm{{{{1}}}}.get(), robot.alarm{{{{2}}}}.get(), robot.lost.get()];
robot.make.set({ALARMS});
robot.alarm{{{{1}}}}.set(true);
values = [values, word()];
robot.lost.set(15);
robot.alarm{{{{2}}}}.post(false);
robot.link.fence();
values = [values, word()];
robot.shoot.set(true);
values = [values, word(), robot.shots.get()];
robot.mode.set(5);
robot.start.set(true);
values(end + 1) = robot.start.get();
robot.mode.set(6);
show('values', [values, robot.mode.get(), robot.starts.get()]);
plan = struct('rate_hz', 10, 'divisor', [], 'trigger', false);
group = unity_link.Group(robot.link, 'made', {{{{robot.seen}}}}, plan);
attempt('together', @() group.get());
attempt('sampled', @() group.subscribe());
"""


@contextlib.contextmanager
def losing_line() -> Iterator[FaultyLine]:
    """Yield a line to the robot that loses the first answer to a read that clears; check the requests at the end."""
    with serve(effects_gateway()) as url, FaultyLine(url, "tcp", [lose(r"^rq")]) as line:
        yield line
    numbers = [frame[2:5] for frame in line.requests if frame.startswith("rq")]
    assert len(numbers) > len(set(numbers)), "the client did not repeat the request whose answer was lost"
    # No other request reads these words, and only the plain field needs a masked write.
    assert not any(re.match(r"r[0-9A-F]{3}1[01]", frame) for frame in line.requests)
    assert {frame[5:7] for frame in line.requests if frame.startswith("wk")} == {"13"}


@pytest.mark.slow
def test_c_loses_no_event_and_touches_no_neighbour(tmp_path: Path) -> None:
    program = c_program(tmp_path)
    with losing_line() as line:
        assert output(program, line.url).split() == EXPECTED.split()


@pytest.mark.slow
def test_cpp_loses_no_event_and_touches_no_neighbour(tmp_path: Path) -> None:
    program = cpp_program(tmp_path)
    with losing_line() as line:
        assert output(program, line.url).split() == EXPECTED.split()


@pytest.mark.slow
@pytest.mark.parametrize("language", ["c", "cpp"])
def test_c_and_cpp_refuse_clear_on_read_signals_without_queue_commands(language: str, tmp_path: Path) -> None:
    program = (c_program if language == "c" else cpp_program)(tmp_path)
    with serve(effects_gateway(ALL & ~Feature.QUEUE_COMMANDS)) as url:
        said = output(program, url, "seen alone").splitlines()[0]
    assert said == REFUSED.format(where=" at 0x10"), said


def c_program(folder: Path) -> Path:
    sources = [path for path in generated("c", SPEC, folder) if path.suffix == ".c"]
    (folder / "program.c").write_text(C_PROGRAM)
    return linked(C, compiled(C, [*sources, folder / "program.c"], folder, *SANITIZED), folder / "program", *SANITIZED)


def cpp_program(folder: Path) -> Path:
    objects = compiled(C, [one for one in generated("cpp", SPEC, folder) if one.suffix == ".c"], folder, *SANITIZED)
    (folder / "program.cc").write_text(CPP_PROGRAM)
    objects += compiled(CPP, [folder / "program.cc"], folder, *SANITIZED)
    return linked(CPP, objects, folder / "program", *SANITIZED)


@pytest.mark.slow
def test_matlab_loses_no_event_and_refuses_such_signals_in_groups(octave: Octave) -> None:
    octave.generate(SPEC)
    with losing_line() as line:
        shown = octave.run(OCTAVE.format(url=line.url))
    assert shown["values"] == doubles(*map(float, EXPECTED.split()))
    sentence = "unity_link:argumentError seen is cleared by each read: it is read by its get alone"
    assert (shown["together"], shown["sampled"]) == (sentence, sentence)


def test_matlab_refuses_clear_on_read_signals_without_queue_commands(octave: Octave) -> None:
    octave.generate(SPEC)
    with serve(effects_gateway(ALL & ~Feature.QUEUE_COMMANDS)) as url:
        shown = octave.run(f"robot = robot('{url}');\nattempt('seen', @() robot.seen.get());\n")
    assert shown["seen"] == (
        "unity_link:unsupported seen is cleared by each read, which takes the queue commands that the gateway was "
        "built without"
    )


def test_documents_state_the_effect_of_each_signal() -> None:
    (page,) = [file.text for file in generate("docs", SPEC) if file.name.endswith(".md")]
    for path, told in (
        ("seen", "cleared by each read"),
        ("lost", "cleared by writing 1"),
        ("start", "a pulse of one clock cycle"),
    ):
        rows = [line for line in page.splitlines() if line.startswith("|") and f" {path} |" in line.replace("`", "")]
        assert any(told in row for row in rows), path
