"""Many signals at once: one pipelined batch, even for several robots and gateways."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import unity_link
from support.recorded_bus import RecordedBus
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError, BusError, GatewayInfo
from unity_link.data import Group
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway

EXAMPLES = Path(__file__).parents[2] / "examples"
WALKER = unity_link.load(EXAMPLES / "walker.ul")
ROBOT = unity_link.load(
    compile_text("""
    group arm;
    public robot() {
      @enable = 0x10[0]: bool READWRITE();
      @level = 0x10[7:1]: signed READWRITE(GROUP(arm));
      @angle = 0x12: signed 16 READWRITE(SCALE=0.5, MIN=-10, MAX=10, GROUP(arm));
      @clock = 0x13: unsigned 64 READWRITE(GROUP(arm));
      @command = 0x15: WRITE();
      @actual = 0x15: READ();
      @queue = 0x16: READWRITE(FIFO(16));
      tools[2]: tool() @(0x18 + i);
    }
    tool(): @(force) { @force: unsigned 8 READWRITE(); }
    """)
)


@on_simulated_time
async def test_72_values_of_the_walker_in_a_row_take_one_request() -> None:
    gateway = VirtualGateway()
    bus = RecordedBus(gateway)
    bus.words.update({address: address for address in range(256)})
    async with unity_link.connect(gateway) as link:
        walker = WALKER(link)
        group = Group(walker)
        assert len(group) == 72
        before = link.statistics
        values = await group.get()
        after = link.statistics
    assert after.requests - before.requests == 1
    assert bus.reads == list(range(0x10, 0x10 + 72))
    assert [values[proxy] for proxy in walker.signals] == [
        pytest.approx(address * 2 * np.pi / 65536) for address in range(0x10, 0x10 + 72)
    ]


@on_simulated_time
async def test_many_set_points_are_written_in_one_batch_in_order() -> None:
    gateway = VirtualGateway()
    bus = RecordedBus(gateway)
    async with unity_link.connect(gateway) as link:
        walker = WALKER(link)
        targets = Group(*(proxy for proxy in walker.signals if proxy.path.endswith("pos_sp")))
        before = link.statistics.requests
        await targets.set(np.linspace(-1, 1, 18))
        assert link.statistics.requests == before + 18
        assert [address for address, _ in bus.writes] == list(range(0x12, 0x10 + 72, 4))
        np.testing.assert_allclose(list((await targets.get()).values()), np.linspace(-1, 1, 18), atol=1e-4)


@on_simulated_time
async def test_posted_values_return_at_once_and_a_fence_raises_their_errors() -> None:
    gateway = VirtualGateway()
    bus = RecordedBus(gateway, failing=frozenset({0x19}))
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        group = Group(robot.angle, robot.level, robot.tools[0], robot.tools[1])
        responses = link.statistics.responses
        await group.post([1, 2, 3, 4])
        with pytest.raises(BusError, match=r"posted write of tools\[1\].force at 0x19"):
            await link.fence()
        assert link.statistics.responses == responses + 3, (
            "responses to the masked write, the failed write and the fence"
        )
        assert (bus.words, robot.tools[0].force.value) == ({0x10: 4, 0x12: 2, 0x18: 3}, 3)
        with pytest.raises(ArgumentError, match="outside of its limits"):
            await group.post([11, 0, 0, 0])


@on_simulated_time
async def test_no_request_is_sent_if_one_value_is_wrong() -> None:
    gateway = VirtualGateway()
    bus = RecordedBus(gateway)
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        arm = robot.groups["arm"]
        with pytest.raises(ArgumentError, match="angle: 11 is outside of its limits, -10 to 10"):
            await arm.set({robot.level: 1, robot.angle: 11})
        with pytest.raises(ArgumentError, match="arm has 3 signals, and 2 values were given"):
            await arm.set([1, 2])
        with pytest.raises(ArgumentError, match=r"command is not in arm"):
            await arm.set({robot.command: 1})
        with pytest.raises(ArgumentError, match="actual can only be read"):
            await Group(robot.actual).set([1])
    assert bus.writes == []


@on_simulated_time
async def test_invalid_values_of_a_group_are_refused() -> None:
    wrong: tuple[Any, ...] = (5, None)
    async with unity_link.connect(VirtualGateway()) as link:
        group = ROBOT(link).groups["arm"]
        for values in wrong:
            for write in (group.set, group.post):
                with pytest.raises(ArgumentError, match=r"^arm takes values in order or by"):
                    await write(values)


@on_simulated_time
async def test_signals_that_cannot_be_in_a_group_are_named() -> None:
    async with unity_link.connect(VirtualGateway()) as link:
        robot = ROBOT(link)
        for proxy, message in (
            (robot.command, "command can only be written"),
            (robot.queue, "queue is the port of a queue"),
        ):
            with pytest.raises(ArgumentError, match=message):
                await Group(robot.angle, proxy).get()
        with pytest.raises(ArgumentError, match="queue is the port of a queue"):
            await Group(robot.queue).set([1])
        with pytest.raises(ArgumentError, match="angle is in it twice"):
            Group(robot.angle, robot.angle)
        with pytest.raises(ArgumentError, match="it has no signals"):
            Group()


@on_simulated_time
async def test_fields_of_a_group_that_fill_a_word_are_written_as_one_word() -> None:
    gateway = VirtualGateway()
    bus = RecordedBus(gateway)
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        await Group(robot.enable, robot.level).set([True, 5])
        assert (bus.reads, bus.writes) == ([], [(0x10, 0b1011)])
        await Group(robot.level, robot.angle).set([-1, 1])
        assert sorted(bus.writes[1:]) == [(0x10, 0xFF), (0x12, 2)], "the word of the field is read and written back"
        assert bus.reads == [0x10]


@on_simulated_time
async def test_values_of_several_words_in_a_group_are_transferred_whole() -> None:
    gateway = VirtualGateway()
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        arm = robot.groups["arm"]
        before = link.statistics.requests
        await arm.set([1, 2, 0xFEDC_BA98_7654_3210])
        assert link.statistics.requests == before + 3, "one write of a word, one masked write, one block"
        assert list((await arm.get()).values()) == [1, 2, 0xFEDC_BA98_7654_3210]
        assert robot.clock.value == 0xFEDC_BA98_7654_3210


@on_simulated_time
async def test_a_group_spans_robots_on_several_gateways_and_on_the_same() -> None:
    first, second = VirtualGateway(), VirtualGateway()
    async with unity_link.connect(first) as left, unity_link.connect(second) as right:
        a, b, c = ROBOT(left), ROBOT(right), WALKER(right)
        group = Group(a.angle, b.angle, c.legs[1].coxa.pos_sp, a.tools[1])
        await group.set([1, 2, 0.5, 9])
        values = await group.get()
        assert (values[a.angle], values[b.angle], values[a.tools[1].force]) == (1, 2, 9)
        assert values[c.legs[1].coxa.pos_sp] == pytest.approx(0.5, abs=1e-4)
        assert (first.memory[0x12], second.memory[0x12]) == (2, 4)


@on_simulated_time
async def test_one_bus_error_is_raised_and_the_other_writes_are_done() -> None:
    gateway = VirtualGateway()
    bus = RecordedBus(gateway, failing=frozenset({0x12}))
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        with pytest.raises(BusError, match="write of angle at 0x12"):
            await Group(robot.angle, robot.tools[0].force).set([1, 2])
        assert bus.words == {0x18: 2}
        with pytest.raises(BusError, match="read of angle at 0x12"):
            await Group(robot.angle, robot.tools[0].force).get()


@on_simulated_time
async def test_a_queue_checks_each_value_and_stores_the_last_one() -> None:
    kinds = unity_link.load(
        compile_text("""
        enum mode { off, manual }
        public robot() {
          @limited = 0: float WRITE(FIFO, MIN=-1, MAX=1);
          @plain = 1: float WRITE(FIFO);
          @mode = 2: mode 4 WRITE(FIFO);
          @half = 3: signed 16 WRITE(FIFO, SCALE=0.5);
        }
        """)
    )
    async with unity_link.connect(VirtualGateway()) as link:
        robot = kinds(link)
        for port, values, words in (
            (robot.limited, [0, math.nan], "limited: nan is outside of its limits, -1 to 1"),
            (robot.limited, "x", "limited: 'x' is no value of float 32: a number was expected"),
            (robot.half, [math.nan], "half: nan is outside of"),
            (robot.half, ["0.5"], "half: '0.5' is no value of signed 16: a number was expected"),
            (robot.mode, ["manuel"], "mode: 'manuel' is no value of mode: off, manual are"),
        ):
            with pytest.raises(ArgumentError) as caught:
                await port.append(values)
            assert str(caught.value).startswith(words)
        await robot.plain.append([math.nan, math.inf])
        await robot.mode.set("manual")
        await robot.half.set(0.7)
        assert robot.mode.value is kinds.enumerations["mode"]["manual"]
        assert robot.half.value == 0.5


@on_simulated_time
async def test_queues_are_written_and_read_with_values_of_their_kind() -> None:
    kinds = unity_link.load(
        compile_text("""
        enum mode { off, on }
        public robot() {
          @both = 0: signed 16 READWRITE(FIFO(16), SCALE=0.5, MIN=-4, MAX=4);
          @from = 1: mode 4 READ(FIFO);
          @to = 2: WRITE(FIFO);
        }
        """)
    )
    gateway = VirtualGateway()

    class Queue:
        def __init__(self) -> None:
            self.words: list[int] = []

        def read(self, offset: int, now: float) -> int:
            return self.words.pop(0)

        def write(self, offset: int, value: int, now: float) -> None:
            self.words.append(value)

    queues = [Queue(), Queue(), Queue()]
    for address, queue in enumerate(queues):
        gateway.attach(queue, [address])
    async with unity_link.connect(gateway) as link:
        robot = kinds(link)
        changes: list[float] = []
        robot.both.on_change(changes.append)
        await robot.both.append([1, -2.5, 4])
        assert queues[0].words == [2, 0xFFFB, 8]
        assert (robot.both.value, changes) == (4, [4]), "the last value that was written"
        for count in (None, "2", 2.0):
            with pytest.raises(ArgumentError, match="a number of words is a whole number, not"):
                await robot.both.take(count)
        await robot.both.set(0.5)
        assert (await robot.both.take(3)).tolist() == [1, -2.5, 4]
        assert await robot.both.get() == 0.5
        with pytest.raises(ArgumentError, match=r"both: 4\.5 is outside of its limits, -4 to 4"):
            await robot.both.append([1, 4.5])
        assert queues[0].words == []
        queues[1].words = [1, 0]
        assert await robot["from"].get() is kinds.enumerations["mode"]["on"]  # type: ignore[attr-defined]
        await robot.to.append(range(300))
        assert queues[2].words == list(range(300)), "more words than one request holds"


@on_simulated_time
async def test_a_list_of_large_integers_is_appended_exactly() -> None:
    kinds = unity_link.load(
        compile_text("""
        public robot() {
          GATEWAY(DATA_BITS=64);
          @large = 1: WRITE(FIFO);
          @limited = 2: WRITE(FIFO, MAX=9223372036854775809);
        }
        """)
    )
    gateway = VirtualGateway(GatewayInfo(data_bits=64))
    bus = RecordedBus(gateway)
    exact: list[list[Any]] = [[1, 2**63 + 1], [2**64 - 1, 0], [1.0, 2**53 + 1], [np.uint64(2**63 + 1), np.int64(1)]]
    async with unity_link.connect(gateway) as link:
        robot = kinds(link)
        for values in exact:
            await robot.large.append(values)
        assert [word for _, word in bus.writes] == [int(value) for values in exact for value in values]
        await robot.limited.append([1, 2**63 + 1])
        for port, values, message in (
            (robot.limited, [1, 2**63 + 2], "limited: 9223372036854775810 is outside of its limits, 0 to"),
            (robot.large, [-1, 2**63 + 1], "large: -1 is outside of 0 to"),
            (robot.large, [0.5, 2**63], "large: 0.5 is no value of unsigned 64: a whole number was expected"),
        ):
            with pytest.raises(ArgumentError, match=message):
                await port.append(values)


@on_simulated_time
async def test_the_last_value_of_a_field_that_two_robots_share_is_written() -> None:
    fields = unity_link.load(compile_text("public r() { @low = 1[3:0]: READWRITE(); @high = 1[7:4]: READWRITE(); }"))
    gateway = VirtualGateway()
    async with unity_link.connect(gateway) as link:
        one, other = fields(link), fields(link)
        await Group(one.low, other.low).set([1, 2])
        assert gateway.memory[1] == 2
        await Group(one.low, one.high, other.low).set([1, 7, 4])
        assert gateway.memory[1] == 0x74
