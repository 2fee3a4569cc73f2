"""Rows of signals: one declaration makes several signals, with the names that all consumers use for elements."""

from __future__ import annotations

import asyncio
import json
import random
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.simulated_time import on_simulated_time
from support.spec_examples import interface_of
from unity_link.bridges.messages import Encoder
from unity_link.data import Group
from unity_link.errors import ArgumentError
from unity_link.spec import SpecError, compile_file, compile_text, format_text
from unity_link.spec.systemrdl import export_text, import_file
from unity_link.virtual.build import simulate
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from pathlib import Path

IMU = """\
imu(axes=3): @(base) {
  @acc[axes] = base + i: signed 16 READ(SCALE=0.5, UNIT="m/s2", PUBLISH(state));
  @led[8] = base + 8[i]: bool READWRITE(RESET=true);
}
group state(RATE=200, TIMESTAMPS);
"""
ROBOT = (
    f"public robot() {{ imu: imu() @(0x10); others[2]: imu(2) @(0x20 + 16 * i); @duty[2] = 0x40 + i: WRITE(); }}\n{IMU}"
)
MIXER = """\
library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity mixer is
  generic ( axes : positive := 1; clock_hz : positive := 50_000_000 );
  port (
    clk, rst : in std_logic;
    gain : in std_logic_vector(axes * 3 * 8 - 1 downto 0);
    gain_written : in std_logic_vector(axes * 3 - 1 downto 0);
    sum : out std_logic_vector(axes * 2 * 16 - 1 downto 0)
  );
end entity;

architecture rtl of mixer is
  signal writes : unsigned(axes * 16 - 1 downto 0);
begin
  each : for axis in 0 to axes - 1 generate
    -- The first is 1 times the first gain, 2 times the second, 4 times the third; the other one counts their writes.
    sum(axis * 32 + 15 downto axis * 32) <= std_logic_vector(
      resize(unsigned(gain(axis * 24 + 7 downto axis * 24)), 16)
      + shift_left(resize(unsigned(gain(axis * 24 + 15 downto axis * 24 + 8)), 16), 1)
      + shift_left(resize(unsigned(gain(axis * 24 + 23 downto axis * 24 + 16)), 16), 2));
    sum(axis * 32 + 31 downto axis * 32 + 16) <= std_logic_vector(writes(axis * 16 + 15 downto axis * 16));
    process (clk) is
    begin
      if rising_edge(clk) then
        if gain_written(axis * 3 + 2) = '1' then
          writes(axis * 16 + 15 downto axis * 16) <= writes(axis * 16 + 15 downto axis * 16) + 1;
        end if;
        if rst = '1' then
          writes(axis * 16 + 15 downto axis * 16) <= (others => '0');
        end if;
      end if;
    end process;
  end generate;
end architecture;
"""
MIXER_MAP = """\
MIXER(): @(BASE) {
  ENTITY("mixer");
  @gain[3] = BASE + i: unsigned 8 READWRITE();
  @sum[2] = BASE + 4 + i: unsigned 16 READ();
}
"""
MIXER_MODEL = """\
from unity_link.cores import Model

class Mixer(Model):
    def reset(self):
        self.part.sum = [0, 0]

    def written(self, name):
        gain, (_, writes) = self.part.gain, self.part.sum
        self.part.sum = [gain[0] + 2 * gain[1] + 4 * gain[2], writes + (name == "gain[2]")]
"""


def test_each_element_of_a_row_is_a_signal_with_its_index() -> None:
    interface = compile_text(ROBOT).interface()
    acc = [signal for path, signal in interface.signals.items() if "acc" in path]
    assert [(one.path, one.address, one.id) for one in acc] == [
        ("imu.acc[0]", 0x10, "imu.acc[0]"), ("imu.acc[1]", 0x11, "imu.acc[1]"), ("imu.acc[2]", 0x12, "imu.acc[2]"),
        ("others[0].acc[0]", 0x20, "others[0].acc[0]"), ("others[0].acc[1]", 0x21, "others[0].acc[1]"),
        ("others[1].acc[0]", 0x30, "others[1].acc[0]"), ("others[1].acc[1]", 0x31, "others[1].acc[1]"),
    ]  # fmt: skip
    assert [(one.address, one.lowest_bit) for path, one in interface.signals.items() if path.startswith("imu.led")] == [
        (0x18, bit) for bit in range(8)
    ]
    assert [*interface.root.rows] == ["duty"]
    assert interface.signals["duty[1]"].label == "duty[1]"


def test_all_expressions_of_a_row_may_use_the_index() -> None:
    interface = interface_of(
        '@a[2] = 8 * i[i + 3:i]: unsigned READWRITE(SCALE=i + 1, MAX=3 * i + 2, PIN="led" + i, ID="a" + i);'
    )
    first, second = interface.signals.values()
    assert (second.address, second.lowest_bit, second.width, second.kind.scale, second.maximum) == (8, 1, 4, 2, 5)
    assert (first.id, second.id, first.pin, second.pin) == ("a0", "a1", "led0", "led1")


def test_a_row_is_formatted_as_it_is_written() -> None:
    text = "public robot() {\n  @acc[3] = 0x10 + i: signed 16 READ();\n  @led[8] = 0x20[i]: bool READWRITE();\n}\n"
    assert format_text(text) == text


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("@a[0] = 1 + i: READ();", "the size of an array is a whole number from 1 to 65536, not the number 0"),
        ("@a[2] = 1: READ();", "a[1] takes bits 31:0 at address 0x1, which a[0] has (bits 31:0)"),
        ("@a[2] = 1 + i: READ(); @a = 5: READ();", "'a' is declared twice in robot"),
        ('@a[2] = 1 + i: READ(ID="a");', "the ID 'a' is that of a[0] and of a[1]"),
        ("@a[70000] = i: READ();", "the size of an array is a whole number from 1 to 65536, not the number 70000"),
    ],
)  # fmt: skip
def test_faults_of_rows_are_reported(text: str, message: str) -> None:
    with pytest.raises(SpecError) as caught:
        interface_of(text)
    assert message in [one.message for one in caught.value.diagnostics]


def test_faults_in_a_row_of_unknown_length_are_found_in_unused_components() -> None:
    with pytest.raises(SpecError, match="there is no kind 'singed'"):
        compile_text("public robot() { }\nunused(n): @(base) { @a[n] = base + i: singed READ(); }")


def test_a_joint_is_no_element_of_a_row() -> None:
    text = "public robot() { @pos[6] = i: READ(PUBLISH(state)); }\ngroup state(RATE=10, JOINTS(POSITION=pos));"
    with pytest.raises(SpecError, match="is in a row of signals, and each joint is a component of its own"):
        compile_text(text)


def test_a_row_of_a_core_has_one_width() -> None:
    text = 'own(): @(BASE) { ENTITY("own"); @a[2] = BASE + i[i:0]: READ(); }'
    with pytest.raises(SpecError, match="the signals in the row a have 1 and 2 bits"):
        interface_of("x: own() @(1);", outside=text)


@pytest.mark.slow
def test_systemrdl_has_each_element_of_a_row(tmp_path: Path) -> None:
    (tmp_path / "robot.rdl").write_text(export_text(compile_text(ROBOT).interface()))
    assert "@acc_1 = " in import_file(tmp_path / "robot.rdl").text


@on_simulated_time
async def test_a_recording_has_rows_as_arrays(tmp_path: Path) -> None:
    (tmp_path / "robot.ul").write_text(
        "public robot() { @a[3] = i: signed READ(PUBLISH(i % 2)); }\ngroup even(0, RATE=100);\ngroup odd(1, RATE=100);"
    )
    robot_type: Any = unity_link.load(tmp_path / "robot.ul")
    async with unity_link.connect(simulate(tmp_path / "robot.ul")) as link:
        robot = robot_type(link)
        for name, values, there in ("even", [0, None, 0], [0, 2]), ("odd", [None, 0], [1]):
            encoder = Encoder([robot.a[place].signal for place in there])
            assert encoder.schema["properties"]["signals"]["properties"]["a"]["items"] == {"type": "integer"}
            async with robot.groups[name].subscribe() as samples:
                message = encoder.encode(await samples.take(1), 32)[0]
            assert json.loads(message)["signals"] == {"a": values}


@on_simulated_time
async def test_a_program_reads_writes_and_subscribes_to_each_element(tmp_path: Path) -> None:
    (tmp_path / "robot.ul").write_text(ROBOT)

    class Shaken(SimulatedRobot):
        imu: Any
        others: Any

        def step(self, dt: float) -> None:
            self.imu.acc[1] = 9.5
            self.others[1].acc = [1, -1]
            assert [*self.imu.acc] == [0, 9.5, 0]
            assert self.imu.acc[1:] == [9.5, 0]

    gateway = simulate(tmp_path / "robot.ul", Shaken)
    robot_type: Any = unity_link.load(tmp_path / "robot.ul")
    async with unity_link.connect(gateway) as link:
        robot = robot_type(link)
        await asyncio.sleep(0.01)
        assert await robot.imu.acc[1].get() == 9.5
        assert await robot.imu.led[3].get() is True
        await robot.imu.led[3].set(False)
        assert [await led.get() for led in robot.imu.led] == [True] * 3 + [False] + [True] * 4
        await robot.duty[1].set(7)
        async for sample in robot.groups["state"]:
            assert (sample[robot.imu.acc[1]], sample[robot.others[1].acc[1]]) == (9.5, -1)
            break
        values = await Group(*robot.imu.acc).get()
        assert [values[one] for one in robot.imu.acc] == [0, 9.5, 0]
        assert robot["imu.acc[2]"] is robot.imu.acc[2]
    with pytest.raises(ArgumentError, match=r"acc\[0\] and the next ones are 3 signals, and 2 values were given"):
        gateway.robot.imu.acc = [1, 2]


@pytest.mark.parametrize("rtl", [False, pytest.param(True, marks=pytest.mark.rtl)], ids=["sim", "rtl"])
def test_a_core_has_one_port_for_a_row_of_all_its_axes(rtl: bool, tmp_path: Path) -> None:
    folder = tmp_path / "cores" / "mixer"
    folder.mkdir(parents=True)
    for name, text in ("mixer.ul", MIXER_MAP), ("mixer.vhd", MIXER), ("mixer.py", MIXER_MODEL):
        (folder / name).write_text(text)
    spec = tmp_path / "robot.ul"
    spec.write_text("public robot() { mixers[2]: MIXER() @(0x10 + 8 * i); }")
    assert compile_file(spec).interface().signals["mixers[1].gain[2]"].address == 0x1A
    chance = random.Random(1)

    async def use() -> None:
        robot_type: Any = unity_link.load(spec)
        async with unity_link.connect(f"{'rtl' if rtl else 'sim'}:{spec}") as link:
            robot = robot_type(link)
            for turn in range(1, 5):
                for mixer in robot.mixers:
                    gains = [chance.randrange(256) for _ in range(3)]
                    for gain, value in zip(mixer.gain, gains, strict=True):
                        await gain.set(value)
                    sums = [await one.get() for one in mixer.sum]
                    assert sums == [gains[0] + 2 * gains[1] + 4 * gains[2], turn]

    asyncio.run(use())
