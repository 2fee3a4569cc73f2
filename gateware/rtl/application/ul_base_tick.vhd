-- SPDX-License-Identifier: BSD-3-Clause
--
-- The base tick of periodic groups: '1' for one cycle, at exactly the base frequency on average.
--
-- If the clock frequency is a multiple of the base frequency, a counter is enough. Otherwise an accumulator in units of
-- mHz generates ticks that are less than one cycle away from their ideal times.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_base_tick is
  generic (
    -- clock_hz in Hz, base_frequency_millihertz in mHz.
    clock_hz                  : positive := 50_000_000;
    base_frequency_millihertz : positive := 100_000_000
  );
  port (
    clk  : in    std_logic;
    rst  : in    std_logic;
    tick : out   std_logic
  );
end entity ul_base_tick;

architecture rtl of ul_base_tick is

  -- VHDL integers may have only 32 bits.
  subtype wide_t is unsigned(47 downto 0);

  constant clock_millihertz : wide_t  := resize(to_unsigned(clock_hz, 32) * to_unsigned(1000, 16), 48);
  constant base_millihertz  : wide_t  := to_unsigned(base_frequency_millihertz, 48);
  constant is_whole         : boolean := clock_millihertz mod base_millihertz = 0;
  constant period           : wide_t  := clock_millihertz / base_millihertz;

begin

  assert period >= 2
    report "ul_base_tick: the base frequency is more than half the clock"
    severity failure;

  whole : if is_whole generate

    constant cycles : positive := to_integer(period(30 downto 0));

    signal left : unsigned(log2_ceil(cycles) - 1 downto 0);

  begin

    main : process (clk) is
    begin

      if rising_edge(clk) then
        tick <= '0';
        left <= left - 1;
        if left = 0 then
          tick <= '1';
          left <= to_unsigned(cycles - 1, left'length);
        end if;

        if rst = '1' then
          tick <= '0';
          left <= to_unsigned(cycles - 1, left'length);
        end if;
      end if;

    end process main;

  end generate whole;

  fraction : if not is_whole generate

    signal phase : wide_t;

  begin

    main : process (clk) is
    begin

      if rising_edge(clk) then
        tick  <= '0';
        phase <= phase + base_millihertz;
        if phase >= clock_millihertz - base_millihertz then
          tick  <= '1';
          phase <= phase + base_millihertz - clock_millihertz;
        end if;

        if rst = '1' then
          tick  <= '0';
          phase <= (others => '0');
        end if;
      end if;

    end process main;

  end generate fraction;

end architecture rtl;
