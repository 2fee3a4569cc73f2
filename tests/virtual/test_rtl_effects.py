"""Signals with an effect in compiled gateware: those of a model, which acts as hardware, and those of a VHDL core."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.effects import TEXT, Effects, events
from support.simulated_time import on_simulated_time
from unity_link.errors import ArgumentError
from unity_link.spec import compile_file
from unity_link.virtual.build import simulate

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = [pytest.mark.rtl, pytest.mark.slow]

DOER = """\
DOER(): @(BASE) {
  ENTITY("doer");
  @go = BASE[0]: bool WRITE(EFFECT=PULSE);
  @done[2] = BASE[i + 1]: bool READWRITE(EFFECT=WRITE_1_TO_CLEAR);
  @seen = BASE + 1: unsigned 8 READ(EFFECT=CLEAR_ON_READ);
  @cycles = BASE + 2: unsigned 8 READ();
}
"""
VHDL = """\
library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity doer is
  generic (
    axes : positive;
    clock_hz : positive
  );
  port (
    clk : in std_logic;
    rst : in std_logic;
    go : in std_logic_vector(axes - 1 downto 0);
    go_written : in std_logic_vector(axes - 1 downto 0);
    done : out std_logic_vector(2 * axes - 1 downto 0);
    seen : out std_logic_vector(8 * axes - 1 downto 0);
    cycles : out std_logic_vector(8 * axes - 1 downto 0)
  );
end entity doer;

architecture rtl of doer is

  signal counted : unsigned(7 downto 0);

begin

  done   <= go(0) & go(0);
  seen   <= (4 => go(0), others => '0');
  cycles <= std_logic_vector(counted);

  count : process (clk) is
  begin

    if rising_edge(clk) then
      if go(0) = '1' then
        counted <= counted + 1;
      end if;
      if rst = '1' then
        counted <= (others => '0');
      end if;
    end if;

  end process count;

end architecture rtl;
"""


class Curious(Effects):
    def written(self, path: str, value: Any) -> None:
        super().written(path, value)
        if path == "mode" and value == 9:
            self.looked: object = self.lost


@pytest.fixture
def spec(tmp_path: Path) -> Path:
    (tmp_path / "cores" / "doer").mkdir(parents=True)
    (tmp_path / "cores" / "doer" / "doer.ul").write_text(DOER)
    (tmp_path / "cores" / "doer" / "doer.vhd").write_text(VHDL)
    path = tmp_path / "robot.ul"
    path.write_text(TEXT.replace("  /// Events", "  doer: DOER() @(0x30);\n  /// Events"))
    return path


@on_simulated_time
async def test_no_event_is_lost_in_compiled_gateware_and_pulses_last_one_cycle(spec: Path) -> None:
    async with unity_link.connect(simulate(spec, Effects, rtl=True)) as link:
        robot = unity_link.load(compile_file(spec))(link)
        for made in (0x81, 0x01, 0xFF, 0x00):
            await robot.make.set(events(seen=made, hit=made & 1, alarm=2, lost=made))
            assert (await robot.seen.get(), await robot.seen.get()) == (made, 0)
            assert (await robot.hit.get(), await robot.hit.get()) == (bool(made & 1), False)
        assert (await robot.alarm[0].get(), await robot.alarm[1].get(), await robot.lost.get()) == (False, True, 0xFF)
        await robot.alarm[1].set(True)
        await robot.lost.set(0x0F)
        assert (await robot.alarm[1].get(), await robot.lost.get()) == (False, 0xF0)
        for count in (1, 2):
            await robot.shoot.set(True)
            await robot.mode.set(count)
            await robot.start.set(True)
            assert (await robot.mode.get(), await robot.start.get()) == (count, False)
            await robot.doer.go.set(True)
            assert [await one.get() for one in robot.doer.done] == [True, True]
            assert (await robot.doer.seen.get(), await robot.doer.seen.get()) == (16, 0)
            await robot.doer.done[0].set(True)
            assert [await one.get() for one in robot.doer.done] == [False, True]
            assert await robot.doer.cycles.get() == count
        assert (await robot.shots.get(), await robot.starts.get()) == (2, 2)


@on_simulated_time
async def test_a_model_that_reads_bits_stored_by_the_gateware_gets_an_error(
    spec: Path, caplog: pytest.LogCaptureFixture
) -> None:
    gateway = simulate(spec, Curious, rtl=True)
    async with unity_link.connect(gateway) as link:
        robot = unity_link.load(compile_file(spec))(link)
        await robot.mode.set(9)
    with pytest.raises(ArgumentError, match="lost has WRITE_1_TO_CLEAR, and its bits are in a register"):
        _ = gateway.robot.lost
    assert "failed in written('mode')" in caplog.text
    with pytest.raises(ArgumentError, match="frozen"):
        gateway.robot.set_fault("seen", "frozen")
