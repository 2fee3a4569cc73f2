"""A queue that its group's trigger publishes: each word once, in order; lost words are counted with the samples."""

from __future__ import annotations

import asyncio
from collections import deque
from typing import TYPE_CHECKING

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import unity_link
from generate.peers import serve
from generate.programs import SANITIZED, C, compiled, generated, linked, output
from support.searching import examples
from support.simulated_time import run_simulated
from unity_link import ArgumentError
from unity_link.data import Group
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.spec import compile_text
from unity_link.virtual import AccessError, VirtualGateway
from unity_link.virtual.faults import Noise, NoisyLine

if TYPE_CHECKING:
    from pathlib import Path

SPEC = compile_text("""
group words(3, TRIGGER);
public logger() {
  @value = 0x20: signed 32 READ(FIFO(512), PUBLISH(words));
  @level = 0x21: unsigned READ();
  @make = 0x22: unsigned WRITE();
}
""")
Logger = unity_link.load(SPEC)


class Queue:
    """A queue of words 0, -1, -2, ...: a write adds as many as its value, and each word triggers the groups."""

    def __init__(self, gateway: VirtualGateway) -> None:
        self._gateway = gateway
        self._words: deque[int] = deque()
        self.made = 0
        gateway.attach(self, range(0x20, 0x23))

    def read(self, offset: int, _: float) -> int:
        if offset == 0 and not self._words:
            raise AccessError(ErrorCode.BUS_ERROR)
        return len(self._words) if offset else self._words.popleft()

    def write(self, _: int, value: int, now: float) -> None:
        for _ in range(value):
            self._words.append(-self.made)
            self.made += 1
            self._gateway.trigger(now)


def logger() -> tuple[VirtualGateway, Queue]:
    gateway = VirtualGateway()
    return gateway, Queue(gateway)


@settings(max_examples=examples(20))
@given(bursts=st.lists(st.integers(1, 30), min_size=1, max_size=8), loss=st.sampled_from([0, 0.002]))
def test_each_word_arrives_once_and_in_order_and_lost_ones_are_counted(bursts: list[int], loss: float) -> None:
    async def check() -> None:
        gateway, queue = logger()
        line = NoisyLine(gateway, Noise(1), Noise(2, loss=loss)) if loss else gateway
        async with unity_link.connect(line) as link:
            robot = Logger(link)
            seen: list[int] = []
            sequences: list[int] = []
            async with robot.groups["words"].subscribe() as samples:
                for burst in bursts:
                    await robot.make.set(burst)
                    await asyncio.sleep(0.1)
                await robot.make.set(1)
                last = queue.made - 1
                while not sequences or sequences[-1] != last:
                    try:
                        batch = await asyncio.wait_for(samples.take(), 1)
                    except TimeoutError:
                        break
                    seen += batch[robot.value].tolist()
                    sequences += [sample.sequence for sample in batch]
            # A sample's number is the number of its word, so the missing words are those of lost samples.
            assert seen == [-number for number in sequences]
            assert sequences == sorted(set(sequences))
            if not loss:
                assert sequences == list(range(queue.made))
            assert await robot.level.get() == 0

    run_simulated(check())


def test_a_loop_over_the_port_returns_the_words_and_wrong_uses_are_refused() -> None:
    async def check() -> None:
        gateway, _ = logger()
        async with unity_link.connect(gateway) as link:
            robot = Logger(link)
            # While no group runs, the level is the number of words in the queue.
            await robot.make.set(7)
            assert (await robot.value.take(await robot.level.get())).tolist() == [-number for number in range(7)]
            asyncio.get_running_loop().call_later(0.1, lambda: asyncio.ensure_future(robot.make.set(40)))
            seen = []
            async for value in robot.value:
                seen.append(value)
                if len(seen) == 40:
                    break
            assert seen == [-number for number in range(7, 47)]
            for group in (robot.groups["words"], Group(robot.value, rate_hz=10)):
                with pytest.raises(ArgumentError, match="value is the port of a queue"):
                    await group.get()
            with pytest.raises(ArgumentError, match="value is the port of a queue"):
                robot.groups["words"].subscribe(rate_hz=10)

    run_simulated(check())


PROGRAM = """
#include "logger.h"
#include <stdio.h>

int main(int count, char **arguments)
{
    static ul_link link;
    static logger_words_subscription feed;
    logger_words words;
    ul_sample sample;
    long expected = 0;
    ul_status status = ul_connect(&link, arguments[count - 1], 5.0);
    if (!status) status = logger_words_subscribe(&link, &feed);
    for (uint64_t burst = 1; burst <= 8 && !status; burst++) {
        status = ul_set_unsigned(&link, &logger.make, burst);
        for (uint64_t word = 0; word < burst && !status; word++) {
            status = logger_words_next(&link, &feed, &words, &sample, 5.0);
            if (!status && (words.value != -expected || sample.lost != 0)) return 2;
            expected++;
        }
    }
    printf("%ld %llu %s\\n", expected, (unsigned long long)feed.base.lost, status ? ul_error(&link) : "");
    ul_close(&link);
    return status != UL_OK;
}
"""


@pytest.mark.slow
def test_a_client_in_c_receives_each_word_once_and_in_order(tmp_path: Path) -> None:
    (tmp_path / "program.c").write_text(PROGRAM)
    files = [path for path in generated("c", SPEC, tmp_path) if path.suffix == ".c"]
    objects = compiled(C, [*files, tmp_path / "program.c"], tmp_path, *SANITIZED)
    program = linked(C, objects, tmp_path / "program", *SANITIZED)
    assert "logger_words_read" not in (tmp_path / "logger.h").read_text()
    with serve(logger()[0]) as url:
        assert output(program, url).split() == ["36", "0"]
