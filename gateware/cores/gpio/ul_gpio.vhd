-- SPDX-License-Identifier: BSD-3-Clause
--
-- General purpose pins: each is read with its bounces taken out, its edges are counted, and it may be driven.
--
-- A level counts once the pin has differed from the last one for so many cycles in a row; each cycle in which it does
-- not begins the count anew. What is read is always the pin itself, also where it is driven.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_gpio is
  generic (
    -- At least 1: pins.
    axes : positive := 1;
    -- At least 1: Hz of clk.
    clock_hz : positive := 50_000_000;
    -- 0 to what takes 2 ** 30 cycles: microseconds for which a new level has to stand before it counts.
    debounce_us : natural := 0
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- Cycles of clk, as the gateway counts them; the lower half is used.
    now : in    std_logic_vector(63 downto 0);
    -- '0': the pin of this axis is not driven from the next cycle on.
    armed : in    std_logic_vector(axes - 1 downto 0) := (others => '1');
    -- The level of the pin.
    level : out   std_logic_vector(axes - 1 downto 0);
    -- The level that is driven.
    output : in    std_logic_vector(axes - 1 downto 0);
    -- Not needed.
    output_written : in    std_logic_vector(axes - 1 downto 0) := (others => '0');
    -- '1': the pin is driven.
    drive : in    std_logic_vector(axes - 1 downto 0);
    -- Not needed.
    drive_written : in    std_logic_vector(axes - 1 downto 0) := (others => '0');
    -- Changes of the level since the reset, of both kinds, modulo 65,536.
    edges : out   std_logic_vector(axes * 16 - 1 downto 0);
    -- The lower half of now in the cycle before the level changed last.
    last : out   std_logic_vector(axes * 32 - 1 downto 0);
    -- '1' for one cycle: the first one with a new level.
    edge : out   std_logic_vector(axes - 1 downto 0);
    -- The pin as it comes. Clock: none.
    pin_in : in    std_logic_vector(axes - 1 downto 0);
    -- The level for the pin.
    pin_out : out   std_logic_vector(axes - 1 downto 0);
    -- '1': the pin is driven.
    pin_oe : out   std_logic_vector(axes - 1 downto 0)
  );
end entity ul_gpio;

architecture rtl of ul_gpio is

  -- Cycles for which a new level has to stand.
  constant stands : positive := maximum(cycles_of(debounce_us, 1_000_000, clock_hz), 1);

  -- Below 0 in the last one.
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

        -- The level of a reset is that of the pin: it has changed in no cycle that counts.
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
