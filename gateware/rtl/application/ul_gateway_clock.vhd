-- SPDX-License-Identifier: BSD-3-Clause
--
-- The time of the gateway: a counter of clock cycles since the reset, and the base tick of periodic groups.
--
-- Both run freely. If the base frequency is more than half the clock frequency, there is no base tick: the subscription
-- manager rejects such a frequency, but a gateway without groups may have any.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity ul_gateway_clock is
  generic (
    -- clock_hz in Hz, base_frequency_millihertz in mHz.
    clock_hz                  : positive := 50_000_000;
    base_frequency_millihertz : positive := 100_000_000
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- base_tick is '1' for one cycle. timestamp counts cycles.
    base_tick : out   std_logic;
    timestamp : out   std_logic_vector(63 downto 0)
  );
end entity ul_gateway_clock;

architecture rtl of ul_gateway_clock is

  constant has_tick : boolean := real(clock_hz) * 1.0e3 >= 2.0 * real(base_frequency_millihertz);

  signal cycles : unsigned(63 downto 0);

begin

  with_tick : if has_tick generate

    base_tick_inst : entity work.ul_base_tick
      generic map (
        clock_hz                  => clock_hz,
        base_frequency_millihertz => base_frequency_millihertz
      )
      port map (
        clk  => clk,
        rst  => rst,
        tick => base_tick
      );

  end generate with_tick;

  without_tick : if not has_tick generate

    base_tick <= '0';

  end generate without_tick;

  timestamp <= std_logic_vector(cycles);

  count : process (clk) is
  begin

    if rising_edge(clk) then
      cycles <= cycles + 1;

      if rst = '1' then
        cycles <= (others => '0');
      end if;
    end if;

  end process count;

end architecture rtl;
