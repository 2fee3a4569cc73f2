"""One signal as a typed value: read, write, stored value, and callbacks."""

from __future__ import annotations

import asyncio
import functools
import math
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given

import unity_link
from generate.every_kind import WORD_BITS, every_kind, good_values
from support.logged import told
from support.recorded_bus import RecordedBus
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError, BusError, Feature, GatewayInfo, UnsupportedError
from unity_link.data import Group, Readable, ReadWrite, Registration, Writable
from unity_link.spec import Access, compile_text
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from unity_link.spec import Signal, Spec, Value

ROBOT = unity_link.load(
    compile_text("""
    enum mode { off, manual = 4, class = 7 }
    public robot() {
      @enable = 0x10[0]: bool READWRITE();
      @level = 0x10[7:1]: signed READWRITE();
      @mode = 0x11: mode 4 READWRITE(ID="the mode");
      @angle = 0x12: signed 16 READWRITE(SCALE=0.5, MIN=-10, MAX=10, UNIT="deg");
      @clock = 0x13: unsigned 64 READWRITE();
      @actual = 0x15: float READ();
      @command = 0x15: float WRITE();
      @class = 0x16: READ();
      @signals = 0x17: READ();
      @signals_ = 0x18: READ();
      @broken = 0x20: READWRITE();
    }
    """)
)
BROKEN = 0x20


KINDS = {bits: unity_link.load(every_kind(bits)) for bits in WORD_BITS}


def values_of(signal: Signal) -> st.SearchStrategy[Value]:
    low, high = signal.limits
    raws = st.integers(0, (1 << signal.width) - 1).map(signal.kind.decode)
    return st.one_of(raws.filter(lambda value: low <= value <= high), st.sampled_from(good_values(signal)))


@pytest.mark.slow
@given(st.sampled_from(WORD_BITS), st.data())
def test_values_of_any_kind_are_read_as_they_were_written(word_bits: int, data: st.DataObject) -> None:
    kind = KINDS[word_bits]
    signals = kind.interface.signals
    paths = [path for path, signal in signals.items() if signal.access is Access.READWRITE]
    chosen = data.draw(st.lists(st.sampled_from(paths), min_size=1, max_size=5, unique=True))
    values = {path: data.draw(values_of(signals[path])) for path in chosen}
    # A limit need not be representable: it is replaced by the nearest representable value.
    exact = {path: signals[path].decode(signals[path].encode(value)) for path, value in values.items()}

    @on_simulated_time
    async def check() -> None:
        async with unity_link.connect(VirtualGateway(GatewayInfo(data_bits=word_bits))) as link:
            one_by_one = kind(link)
            for path, value in values.items():
                await one_by_one[path].set(value)  # type: ignore[attr-defined]
            for path, value in exact.items():
                assert await one_by_one[path].get() == value  # type: ignore[attr-defined]
        async with unity_link.connect(VirtualGateway(GatewayInfo(data_bits=word_bits))) as link:
            robot = kind(link)
            group = Group(*(robot[path] for path in values))
            await group.set({robot[path]: value for path, value in values.items()})
            assert {proxy.path: value for proxy, value in (await group.get()).items()} == exact
            async with group.subscribe(rate_hz=1000) as samples:
                sample = await anext(samples)
            assert {proxy.path: value for proxy, value in sample.values.items()} == exact

    check()


@on_simulated_time
async def test_a_write_of_a_field_does_not_change_the_other_bits_of_its_word() -> None:
    gateway = VirtualGateway()
    gateway.memory[0x10] = 0xABCDEF00
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        await robot.enable.set(np.float64(3) > 2)
        await robot.level.set(np.int8(-2))
        assert gateway.memory[0x10] == 0xABCDEF00 | 1 | 0x7E << 1
        assert (await robot.enable.get(), await robot.level.get()) == (True, -2)


@on_simulated_time
async def test_a_field_needs_a_gateway_with_masked_writes() -> None:
    without = GatewayInfo(features=GatewayInfo().features & ~Feature.MASKED_WRITE)
    async with unity_link.connect(VirtualGateway(without)) as link:
        robot = ROBOT(link)
        with pytest.raises(UnsupportedError, match="without masked write"):
            await robot.enable.set(True)
        # A group may write all fields of a word at once.
        await Group(robot.enable, robot.level).set([True, 3])
        assert await robot.level.get() == 3


@on_simulated_time
async def test_a_value_of_several_words_is_read_and_written_in_one_transaction() -> None:
    gateway = VirtualGateway()
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        requests = link.statistics.requests
        await robot.clock.set(0x1_2345_6789)
        assert (gateway.memory[0x13], gateway.memory[0x14]) == (0x2345_6789, 1)
        assert await robot.clock.get() == 0x1_2345_6789
        assert link.statistics.requests == requests + 2


@on_simulated_time
async def test_limits_are_checked_before_a_request_is_sent() -> None:
    gateway = VirtualGateway()
    bus = RecordedBus(gateway)
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        wrong: list[tuple[Any, Any, str]] = [
            (robot.angle, 10.5, "angle: 10.5 is outside of its limits, -10 to 10 deg"),
            (robot.level, 64, "level: 64 is outside of -64 to 63, the range of signed 7"),
            (robot.mode, "on", "mode: 'on' is no value of mode: off, manual, class are"),
            (robot.angle, math.nan, "angle: nan is no value of signed 16: a finite number was expected"),
        ]
        for proxy, value, message in wrong:
            for write in (proxy.set, proxy.post, lambda v, p=proxy: Group(robot.command, p).set([1.0, v])):
                with pytest.raises(ArgumentError, match=message):
                    await write(value)
        assert robot.angle.limits == (-10, 10)
    assert bus.writes == []


@on_simulated_time
async def test_an_enumeration_is_read_as_members_and_written_as_members_or_names() -> None:
    gateway = VirtualGateway()
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        mode = ROBOT.enumerations["mode"]
        await robot.mode.set("manual")
        assert await robot.mode.get() is mode["manual"]
        await robot.mode.set(mode["class"])
        assert gateway.memory[0x11] == 7
        assert (await Group(robot.mode).get())[robot.mode] is mode["class"]
        gateway.memory[0x11] = 9
        unnamed = await robot.mode.get()
        assert unnamed == 9
        assert not isinstance(unnamed, mode)


@on_simulated_time
async def test_a_proxy_stores_the_last_known_value_and_its_age(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("time.monotonic", lambda: asyncio.get_running_loop().time())
    async with unity_link.connect(VirtualGateway()) as link:
        robot = ROBOT(link)
        angle: ReadWrite[float] = robot.angle
        assert (angle.value, angle.age) == (None, math.inf)
        assert repr(angle) == "<angle: never seen>"
        await angle.set(2.6)
        assert angle.value == 2.5, "the nearest representable value"
        await asyncio.sleep(3)
        assert angle.age == pytest.approx(3, abs=0.1)
        await link.write(0x12, 4)
        assert angle.value == 2.5
        assert await angle.get() == 2
        assert angle.value == 2
        assert angle.age < 0.1
        await link.write(0x12, 6)
        await Group(angle).get()
        assert angle.value == 3
        assert repr(angle).startswith("<angle: 3.0 deg, ")
        await angle.post(1)
        assert angle.value == 1


@on_simulated_time
async def test_errors_of_the_bus_are_those_of_the_link() -> None:
    gateway = VirtualGateway()
    RecordedBus(gateway, failing=frozenset({BROKEN}))
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        with pytest.raises(BusError, match="read of broken at 0x20"):
            await robot.broken.get()
        with pytest.raises(BusError, match="write of broken at 0x20"):
            await robot.broken.set(1)
        assert robot.broken.value is None
        await robot.broken.post(1)
        with pytest.raises(BusError, match="posted write of broken at 0x20"):
            await link.fence()


@on_simulated_time
async def test_a_callback_is_called_for_each_observed_change() -> None:
    async with unity_link.connect(VirtualGateway()) as link:
        robot = ROBOT(link)
        seen: list[float] = []
        registration = robot.angle.on_change(seen.append)
        await robot.angle.set(1)
        await robot.angle.set(1)
        await robot.angle.get()
        await link.write(0x12, 4)
        await robot.angle.get()
        registration.cancel()
        registration.cancel()
        await robot.angle.set(5)
        assert seen == [1, 2]
        with robot.angle.on_change(seen.append):
            await robot.angle.set(6)
        await robot.angle.set(7)
        assert seen == [1, 2, 6]


@on_simulated_time
async def test_a_callback_cancelled_by_another_is_not_called_for_this_change() -> None:
    async with unity_link.connect(VirtualGateway()) as link:
        robot = ROBOT(link)
        seen: list[float] = []
        second: Registration
        robot.angle.on_change(lambda _: second.cancel())
        second = robot.angle.on_change(seen.append)
        await robot.angle.set(1)
        assert seen == []


@on_simulated_time
async def test_a_callback_that_raises_is_logged_and_does_not_affect_others(caplog: pytest.LogCaptureFixture) -> None:
    async with unity_link.connect(VirtualGateway()) as link:
        robot = ROBOT(link)
        seen: list[float] = []
        robot.angle.on_change(lambda _: 1 / 0)
        robot.angle.on_change(seen.append)
        await robot.angle.set(1)
        assert seen == [1]
    ((message, error),) = told(caplog)
    assert message == "a callback of angle raised ZeroDivisionError (told once)"
    assert isinstance(error, ZeroDivisionError)


@on_simulated_time
async def test_a_callback_that_raises_cancelled_error_does_not_affect_others(
    caplog: pytest.LogCaptureFixture,
) -> None:
    async with unity_link.connect(VirtualGateway()) as link:
        robot = ROBOT(link)
        task = asyncio.create_task(asyncio.sleep(9))
        task.cancel()
        await asyncio.sleep(0)
        seen: list[float] = []
        robot.angle.on_change(lambda _: task.result())
        robot.angle.on_change(seen.append)
        await robot.angle.set(1)
        assert seen == [1]
        async with link.subscribe([0], rate_hz=100, callback=lambda _: task.result()) as samples:
            await asyncio.sleep(1)
            assert samples.received > 50
    assert [message for message, _ in told(caplog)] == [
        "a callback of angle raised CancelledError (told once)",
        "a subscription's callback raised CancelledError (told once)",
    ]


@on_simulated_time
async def test_a_callback_that_keeps_raising_is_logged_once_for_each_type(
    caplog: pytest.LogCaptureFixture,
) -> None:
    async with unity_link.connect(VirtualGateway()) as link:
        robot = ROBOT(link)
        robot.angle.on_change(lambda value: 1 / (value % 2) if value < 5 else int("x"))
        for value in range(1, 9):
            await robot.angle.set(value)
    assert [message for message, _ in told(caplog)] == [
        f"a callback of angle raised {name} (told once)" for name in ("ZeroDivisionError", "ValueError")
    ]


class Asynchronous:
    async def __call__(self, value: float) -> None:
        raise AssertionError


@on_simulated_time
async def test_an_asynchronous_callback_is_refused_or_logged(caplog: pytest.LogCaptureFixture) -> None:
    async with unity_link.connect(VirtualGateway()) as link:
        robot = ROBOT(link)
        message = "a callback of angle is an asynchronous function, which would never be awaited: a plain function"
        for callback in (Asynchronous(), Asynchronous().__call__, functools.partial(robot.angle.set)):
            with pytest.raises(ArgumentError, match=message):
                robot.angle.on_change(callback)
        with pytest.raises(ArgumentError, match="a callback of angle is 5: a function was expected"):
            robot.angle.on_change(5)
        robot.angle.on_change(lambda value: Asynchronous()(value + 1))
        await robot.angle.set(1)
    assert [str(error).startswith(message) for _, error in told(caplog)] == [True]


@on_simulated_time
async def test_signals_are_found_by_path_and_id_and_by_attributes() -> None:
    async with unity_link.connect(VirtualGateway()) as link:
        robot = ROBOT(link)
        assert robot["mode"] is robot["the mode"] is robot.mode
        with pytest.raises(ArgumentError, match="no signal 'the mod': did you mean"):
            robot["the mod"]
        assert robot.class_.path == "class"
        # `robot.signals` is the list of all signals.
        assert robot.signals__.path == "signals"
        assert robot.signals_.path == "signals_"
        assert len(robot.signals) == len(ROBOT.interface.signals)
        assert (type(robot.actual), type(robot.command), type(robot.angle)) == (Readable, Writable, ReadWrite)


def test_modules_for_specs_are_imported_when_a_spec_is_loaded() -> None:
    program = (
        "import sys, unity_link; early = {'lark', 'unity_link.data', 'unity_link.spec'} & set(sys.modules);"
        "import unity_link.data; assert not early and 'lark' not in sys.modules, early"
    )
    subprocess.run([sys.executable, "-c", program], check=True)


@pytest.mark.parametrize(
    ("info", "message"),
    [
        (GatewayInfo(data_bits=16), "for words of 32 bits, and the gateway's have 16: its GATEWAY.DATA_BITS=16. is"),
        (GatewayInfo(address_bits=8), "addresses up to 0x100, and those of the gateway end at 0xff"),
    ],
)
def test_a_gateway_of_other_widths_is_refused(info: GatewayInfo, message: str) -> None:
    spec = compile_text("public robot() { GATEWAY(ADDRESS_BITS=12); @x = 0x100: READ(); }")

    @on_simulated_time
    async def check() -> None:
        async with unity_link.connect(VirtualGateway(info)) as link:
            with pytest.raises(UnsupportedError, match=message):
                unity_link.load(spec)(link)

    check()


def generated_from(spec: Spec) -> VirtualGateway:
    """Return a gateway that reports the fingerprint of a spec, as if it was generated from that spec."""
    features = GatewayInfo().features | Feature.FINGERPRINT
    return VirtualGateway(GatewayInfo(features=features, build_id=spec.interface().fingerprint))


@on_simulated_time
async def test_the_error_for_a_gateway_of_another_spec_names_both_maps() -> None:
    ours, other = compile_text("public robot() { @x = 1: READ(); }"), compile_text("public robot() { @x = 2: READ(); }")
    async with unity_link.connect(generated_from(ours)) as link:
        assert await unity_link.load(ours)(link).x.get() == 0
        maps = f"the map {ours.interface().fingerprint:08X}, and .* the map {other.interface().fingerprint:08X}: load"
        with pytest.raises(UnsupportedError, match=maps):
            unity_link.load(other)(link)


@on_simulated_time
async def test_a_build_identifier_that_is_no_fingerprint_is_not_compared() -> None:
    async with unity_link.connect(VirtualGateway(GatewayInfo(build_id=0xCAFE))) as link:
        assert await ROBOT(link).angle.get() == 0


@on_simulated_time
async def test_assignments_to_signals_and_parts_are_refused() -> None:
    spec = compile_text("""
    public rover() { left: wheel() @(0x10); legs[2]: wheel() @(0x20 + 2 * i); }
    wheel(): @(base) { @duty = base: READWRITE(); @speed = base + 1: READ(); }
    """)
    async with unity_link.connect(VirtualGateway()) as link:
        robot: Any = unity_link.load(spec)(link)
        duty = robot.left.duty
        with pytest.raises(ArgumentError, match=r"left\.duty is not assigned to: await left\.duty\.set\(1\) writes it"):
            robot.left.duty = 1
        for part, name in ((robot.left, "speed"), (robot, "left"), (robot, "legs")):
            with pytest.raises(ArgumentError, match=f"'{name}' of .* cannot be assigned to"):
                setattr(part, name, 1)
        assert robot.left.duty is duty
        with pytest.raises(ArgumentError, match=r"left has no 'dutty': did you mean 'duty'\?"):
            robot.left.dutty = 1
        for name in ("link", "groups", "modules"):
            with pytest.raises(ArgumentError, match=f"'{name}' of rover cannot be assigned to"):
                setattr(robot, name, 1)
        robot._note = (1, 2)
        assert robot._note == (1, 2)


@on_simulated_time
async def test_a_subclass_of_robot_has_the_attributes_that_it_declares() -> None:
    class Own(ROBOT):  # type: ignore[misc, valid-type]  # made at run time
        gain: float = 1.0
        offset: float

    async with unity_link.connect(VirtualGateway()) as link:
        own = Own(link)
        own.gain, own.offset = 2.0, 3.0
        assert (own.gain, own.offset) == (2.0, 3.0)
        with pytest.raises(ArgumentError, match="has no 'gian': did you mean 'gain'"):
            own.gian = 2.0


@on_simulated_time
async def test_the_error_for_a_value_beyond_limits_and_bits_has_the_limits() -> None:
    spec = compile_text("public rover() { @duty = 0x10: signed 12 READWRITE(MIN=-1, MAX=1, SCALE=0.00048852); }")
    async with unity_link.connect("sim:") as link:
        duty = unity_link.load(spec)(link)["duty"]
        for value in (2, -2.5, 1e9):
            with pytest.raises(ArgumentError, match=r"^duty: .* is outside of its limits, -1 to 1$"):
                await duty.set(value)  # type: ignore[attr-defined]
