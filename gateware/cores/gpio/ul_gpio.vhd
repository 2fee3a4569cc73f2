-- SPDX-License-Identifier: BSD-3-Clause
--
-- General purpose pins: each is read with debouncing, its edges are counted, and it may be driven.
--
-- A new level is accepted once the pin has differed from the last level for `debounce_us` without interruption; a cycle
-- in which it does not differ restarts the count. The level is always that of the pin, even if the pin is driven.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_gpio is
  generic (
    -- At least 1: number of pins.
    axes : positive := 1;
    -- At least 1: frequency of clk in Hz.
    clock_hz : positive := 50_000_000;
    -- 0 to a time of 2 ** 30 cycles: microseconds for which a new level must be stable before it is accepted.
    debounce_us : natural := 0
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- Cycles of clk, from the gateway's timestamp counter; the lower half is used.
    now : in    std_logic_vector(63 downto 0);
    -- '0': the pin of this axis is not driven from the next cycle on.
    armed : in    std_logic_vector(axes - 1 downto 0) := (others => '1');
    -- Debounced level of the pin.
    level : out   std_logic_vector(axes - 1 downto 0);
    -- Level to drive.
    output : in    std_logic_vector(axes - 1 downto 0);
    -- Unused.
    output_written : in    std_logic_vector(axes - 1 downto 0) := (others => '0');
    -- '1': drive the pin.
    drive : in    std_logic_vector(axes - 1 downto 0);
    -- Unused.
    drive_written : in    std_logic_vector(axes - 1 downto 0) := (others => '0');
    -- Number of changes of the level since the reset, rising and falling, modulo 65,536.
    edges : out   std_logic_vector(axes * 16 - 1 downto 0);
    -- Lower half of now in the cycle before the last change of the level.
    last : out   std_logic_vector(axes * 32 - 1 downto 0);
    -- '1' in the first cycle with a new level.
    edge : out   std_logic_vector(axes - 1 downto 0);
    -- The pin, asynchronous. Clock: none.
    pin_in : in    std_logic_vector(axes - 1 downto 0);
    -- Level for the output driver.
    pin_out : out   std_logic_vector(axes - 1 downto 0);
    -- '1' enables the output driver.
    pin_oe : out   std_logic_vector(axes - 1 downto 0)
  );
end entity ul_gpio;

architecture rtl of ul_gpio is

  -- Cycles for which a new level must be stable.
  constant stands : positive := maximum(cycles_of(debounce_us, 1_000_000, clock_hz), 1);

  -- Negative in the last cycle of the count.
  subtype left_t is signed(log2_ceil(minimum(maximum(stands, 2), 2 ** 30)) downto 0);

  signal settled : std_logic_vector(axes - 1 downto 0);

begin

  assert stands <= 2 ** 30
    report "ul_gpio: debounce_us is " & integer'image(debounce_us) & ": at most 2 ** 30 cycles of a clock of "
           & integer'image(clock_hz) & " Hz were expected"
    severity failure;

  pins_crossing : entity work.ul_synchroniser
    generic map (
      width => axes
    )
    port map (
      clk => clk,
      d   => pin_in,
      q   => settled
    );

  all_axes : for axis in 0 to axes - 1 generate

    signal left    : left_t;
    signal differs : std_logic;
    signal changes : std_logic;
    signal count   : unsigned(15 downto 0);

  begin

    differs <= settled(axis) xor level(axis);
    changes <= differs and left(left'high);

    edges(16 * axis + 15 downto 16 * axis) <= std_logic_vector(count);

    main : process (clk) is
    begin

      if rising_edge(clk) then
        left       <= to_signed(stands - 2, left'length);
        edge(axis) <= changes;
        if differs = '1' then
          left <= left - 1;
        end if;
        if changes = '1' then
          left                                  <= to_signed(stands - 2, left'length);
          level(axis)                           <= settled(axis);
          count                                 <= count + 1;
          last(32 * axis + 31 downto 32 * axis) <= now(31 downto 0);
        end if;

        pin_out(axis) <= output(axis);
        pin_oe(axis)  <= drive(axis) and armed(axis);

        -- A reset adopts the level of the pin, so that it counts no edge.
        if rst = '1' then
          left                                  <= to_signed(stands - 2, left'length);
          edge(axis)                            <= '0';
          level(axis)                           <= settled(axis);
          count                                 <= (others => '0');
          last(32 * axis + 31 downto 32 * axis) <= (others => '0');
          pin_out(axis)                         <= '0';
          pin_oe(axis)                          <= '0';
        end if;
      end if;

    end process main;

  end generate all_axes;

end architecture rtl;
