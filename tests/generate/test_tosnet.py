"""The paper's figure 1, unchanged, moves the SCARA through the double buffers of a TosNet from generated clients."""

from __future__ import annotations

import subprocess
from typing import TYPE_CHECKING

import pytest

from generate.peers import serve, simulate
from generate.programs import CPP, SANITIZED, C, compiled, generated, linked, output
from support.spec_examples import FIGURE_1
from unity_link.network.memories import networks
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.tosnet import COMM, CTRL, ScaraOnTosnet

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from generate.octave import Octave

SET_POINTS = (1200, -700, 345, 2000)
"""Set points of joints 1 to 4, in counts."""
MODELS = ["", pytest.param("--rtl", marks=pytest.mark.rtl)]

C_PROGRAM = """
#include "scara.h"
#include <stdio.h>

int main(int count, char **arguments)
{
    static const ul_signed *const POSITIONS[] = {
        &scara.j1.pos_sp, &scara.j2.pos_sp, &scara.j3.pos_sp, &scara.j4.pos_sp};
    static const ul_unsigned *const SPEEDS[] = {
        &scara.j1.spd_sp, &scara.j2.spd_sp, &scara.j3.spd_sp, &scara.j4.spd_sp};
    static const int64_t SET_POINTS[] = {1200, -700, 345, 2000};
    static scara_networks networks;
    static scara_group_1_subscription feed;
    static ul_link link;
    scara_group_1 at = {0};
    ul_network_state state = {0};
    ul_status status = ul_connect(&link, arguments[count - 1], 5.0);
    if (!status) status = scara_networks_use(&link, &networks, 0xF0, 0xF4);
    if (!status) status = ul_network_get_state(&link, &networks.networks[0], &state);
    for (int joint = 0; joint < 4 && !status; joint++) {
        status = ul_set_unsigned(&link, SPEEDS[joint], 100000);
        if (!status) status = ul_post_signed(&link, POSITIONS[joint], SET_POINTS[joint]);
    }
    if (!status) status = scara_group_1_subscribe(&link, &feed);
    for (int sample = 0; sample < 100000 && !status; sample++) {
        status = scara_group_1_next(&link, &feed, &at, NULL, 10.0);
        if (at.j1_cpos == 1200 && at.j2_cpos == -700 && at.j3_cpos == 345 && at.j4_cpos == 2000) break;
    }
    printf("%d %ld %ld %ld %ld %s\\n", state.online, (long)at.j1_cpos, (long)at.j2_cpos, (long)at.j3_cpos,
           (long)at.j4_cpos, status ? ul_error(&link) : "");
    ul_close(&link);
    return status != UL_OK;
}
"""
CPP_PROGRAM = """
#include "scara.hpp"
#include <cstdio>

int main(int count, char **arguments)
{
    using namespace std::chrono_literals;
    unity_link::Link link{arguments[count - 1]};
    Scara robot{link, 0xF0, 0xF4};
    const Scara::Joint *const joints[] = {&robot.j1, &robot.j2, &robot.j3, &robot.j4};
    const int set_points[] = {1200, -700, 345, 2000};
    for (int joint = 0; joint < 4; joint++) {
        joints[joint]->spd_sp.post(100000);
        joints[joint]->pos_sp.set(set_points[joint]);
    }
    auto feed = robot.group_1.subscribe();
    while (auto sample = feed.next(10s)) {
        const auto &at = sample->first;
        if (at.j1_cpos != 1200 || at.j2_cpos != -700 || at.j3_cpos != 345 || at.j4_cpos != 2000) continue;
        std::printf("%d %d ", robot.networks[0].state().online, at.j1_cpos);
        std::printf("%d %d %d\\n", at.j2_cpos, at.j3_cpos, at.j4_cpos);
        return 0;
    }
    return 1;
}
"""
OCTAVE_SCRIPT = """
robot = scara('{url}', 'ctrl', 240, 'comm', 244);
names = {{'j1', 'j2', 'j3', 'j4'}};
goals = [1200 -700 345 2000];
state = robot.link.network_state(robot.networks{{1}});
for joint = 1:4
  robot.(names{{joint}}).spd_sp.set(100000);
  robot.(names{{joint}}).pos_sp.post(goals(joint));
end
samples = robot.groups.group_1.subscribe();
for turn = 1:2000
  data = samples.take(50);
  at = cellfun(@(name) data.values.(name).cpos(end), names);
  if all(at == goals), break, end
end
show('at', sprintf('%d ', [state.online at]));
attempt('unknown', @() scara('{url}', 'crtl', 240));
robot.close();
"""


@pytest.fixture(scope="module")
def programs(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    directory = tmp_path_factory.mktemp("figure_1")
    files = generated("cpp", compile_text(FIGURE_1), directory)
    client = compiled(C, [path for path in files if path.suffix == ".c"], directory)
    made = {}
    for target, compiler, text in (("c", C, C_PROGRAM), ("cc", CPP, CPP_PROGRAM)):
        (directory / f"program.{target}").write_text(text)
        objects = compiled(compiler, [directory / f"program.{target}"], directory)
        made[target] = linked(compiler, [*client, *objects], directory / f"{target}_program")
    return made


@pytest.mark.slow
@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("target", ["c", "cc"])
def test_figure_1_moves_the_motors_through_the_network(target: str, model: str, programs: dict[str, Path]) -> None:
    with simulate("tcp", "--robot", "tosnet", *filter(None, [model])) as url:
        assert output(programs[target], url).split() == ["1", *map(str, SET_POINTS)]


@pytest.mark.slow
@pytest.mark.parametrize("model", MODELS)
def test_figure_1_moves_the_motors_from_octave(model: str, octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    with simulate("tcp", "--robot", "tosnet", *filter(None, [model])) as url:
        shown = octave.run(OCTAVE_SCRIPT.format(url=url))
    assert shown["at"].split() == ["1", *map(str, SET_POINTS)]
    assert shown["unknown"].startswith("unity_link:argumentError there is no parameter 'crtl'")


# Fields, values of several words, batches, and a network that has stopped

FIELDS = f"""
group both;
public scara() {{
  net: TOSNET(CTRL={CTRL}, COMM={COMM}, BASE=0, NODES=3);
  @low = 0xA4[7:0]: READWRITE(GROUP(both));
  @high = 0xA4[15:8]: READWRITE(GROUP(both));
  @wide = 0xA5: unsigned 64 WRITE();
  @plain = 0xE0: READWRITE();
}}
"""
FIELDS_IN_C = """
#include "scara.h"
#include <stdio.h>
#define DO(call) tell(&link, call)

static void tell(const ul_link *link, ul_status status)
{
    printf("%d %s\\n", (int)status, status ? ul_error(link) : "");
}

int main(int count, char **arguments)
{
    static scara_networks networks;
    static ul_link link;
    uint64_t low[1] = {0}, high[1] = {0};
    const uint64_t words[] = {0x55, 0x66};
    ul_batch batch = UL_BATCH;
    if (ul_connect(&link, arguments[count - 1], 5.0)) return 1;
    DO(ul_set_unsigned(&link, &scara.low, 1));
    if (scara_networks_use(&link, &networks)) return 1;
    ul_encode_unsigned(&scara.low.signal, 0x11, low);
    ul_encode_unsigned(&scara.high.signal, 0x22, high);
    ul_start_set(&link, &batch, &scara.low.signal, low);
    ul_start_set(&link, &batch, &scara.high.signal, high);
    DO(ul_finish(&link, &batch));
    DO(ul_post_unsigned(&link, &scara.high, 0x33));
    DO(ul_set_unsigned(&link, &scara.wide, UINT64_C(0x0123456789ABCDEF)));
    DO(ul_set_unsigned(&link, &scara.plain, 7));
    DO(scara_both_write(&link, &(scara_both){0x44, 0x33}));
    DO(ul_write_module(&link, scara.net.address + 0xA7, words, 2));
    DO(ul_commit_write(&link, &networks.networks[0]));
    puts("standing");
    fflush(stdout);
    getchar();
    DO(ul_set_unsigned(&link, &scara.low, 0x99));
    DO(ul_set_unsigned(&link, &scara.low, 0x9A));
    DO(ul_close(&link));
    return 0;
}
"""


@pytest.fixture
def network() -> Iterator[tuple[ScaraOnTosnet, str]]:
    gateway = VirtualGateway()
    made = ScaraOnTosnet.attach(gateway)
    with serve(gateway) as url:
        yield made, url


@pytest.mark.slow
def test_fields_and_batches_are_one_commit_and_a_stopped_network_is_an_error(
    tmp_path: Path, network: tuple[ScaraOnTosnet, str]
) -> None:
    made, url = network
    memory = made.memory
    (tmp_path / "program.c").write_text(FIELDS_IN_C)
    sources = [*generated("c", compile_text(FIELDS), tmp_path), tmp_path / "program.c"]
    objects = compiled(C, [path for path in sources if path.suffix == ".c"], tmp_path, *SANITIZED)
    program = linked(C, objects, tmp_path / "program", *SANITIZED)
    with subprocess.Popen([program, url], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as client:
        assert client.stdout is not None
        lines = [client.stdout.readline().strip() for _ in range(9)]
        sent = [(packet.get(0xA4), packet.get(0xA5), packet.get(0xA6)) for packet in memory.sent]
        last = memory.sent[-1]
        # No further packet arrives.
        memory.cycle = 1e9
        rest, _ = client.communicate("\n")
    assert lines == [
        "38 low at 0xA4: the network around it is not in use yet",
        *["0"] * 7,
        "standing",
    ]
    assert sent[:2] == [(0x2211, None, None), (0x3311, None, None)]
    assert sent[2] == (0x3311, 0x89ABCDEF, 0x01234567)
    assert sent[3] == (0x3344, 0x89ABCDEF, 0x01234567)
    assert (last[0xA4], last[0xA7], last[0xA8]) == (0x3344, 0x55, 0x66)
    assert rest.splitlines() == [
        "0 ",
        "40 low at 0xA4: TosNet does not change its buffers: is the network online?",
        "0 ",
    ]


def test_a_network_has_the_words_of_signals_and_of_named_modules() -> None:
    (figure,) = networks(compile_text(FIGURE_1).interface())
    (fields,) = networks(compile_text(FIELDS).interface())
    assert (figure.ctrl, figure.comm, figure.addresses) == ("ctrl", "comm", (*range(0x8C, 0x90), *range(0x94, 0x98)))
    assert (fields.ctrl, fields.comm, fields.addresses) == (CTRL, COMM, tuple(range(192)))
    given = compile_text(FIGURE_1).given({"ctrl": 0xF0}).interface()
    assert (networks(given)[0].ctrl, given.open_parameters) == (0xF0, ("comm",))
