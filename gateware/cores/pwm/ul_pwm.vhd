-- SPDX-License-Identifier: BSD-3-Clause
--
-- Pulse width modulation: signed values as pulses of two pins each, on one time base.
--
-- A value is compared with a ramp that goes through its whole range in one period, so its pulse is proportional to it,
-- to the nearest cycle, at any frequency and with no multiplication. With `full` for the largest value, `period` for the
-- cycles of a period and k for the number of a cycle in it, the ramp is (k * full + full / 2) / period, rounded down:
-- exactly round(value * period / full) of its cycles are below the value. It is made without a division: `ramp` takes
-- the whole steps, `rest` what is left of them.
--
-- With `centre` the ramp is gone through twice in a period, in half a period each: first mirrored, so that it falls,
-- then rising. They are a quarter and three quarters of a step off, so that both together round as one does.
--
-- What a value is compared with is kept inverted, for a comparison is an addition: a > b where a + not b has a carry. A
-- negative value is compared by its complement, which is one less than its size: a carry goes in. So the most negative
-- number is beyond the ramp as its successor is, and both are full pulses.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_pwm is
  generic (
    -- At least 1: values, each with pins of its own, on one time base.
    axes : positive := 1;
    -- At least 1: Hz of clk.
    clock_hz : positive := 50_000_000;
    -- 2 to 24: bits of a value.
    width : positive := 12;
    -- 1 to clock_hz / 4: periods a second. One takes an even number of cycles, the nearest.
    frequency_hz : positive := 20_000;
    -- Whether a pulse lies in the middle of its period instead of at its beginning.
    centre : boolean := false;
    -- "sign", "up_down", "offset": what the pins are. The size and the sign; pulses for positive values and pulses for
    -- negative ones; the high and the low side of a half bridge, which are in turn on and take equal parts for 0.
    mode : string := "sign";
    -- Less than half a period, and 0 for "sign": nanoseconds for which both pins stay off before another one is on.
    dead_time_ns : natural := 0
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- '0': both pins of this axis are '0' from the next cycle on, to the beginning of the first period behind it.
    armed : in    std_logic_vector(axes - 1 downto 0) := (others => '1');
    -- Signed; one is taken at the beginning of each period.
    value : in    std_logic_vector(axes * width - 1 downto 0);
    -- Not needed.
    value_written : in    std_logic_vector(axes - 1 downto 0) := (others => '0');
    -- The pulse; that of positive values; the high side.
    pwm : out   std_logic_vector(axes - 1 downto 0);
    -- '1' for negative values; the pulse of negative values; the low side.
    dir : out   std_logic_vector(axes - 1 downto 0)
  );
end entity ul_pwm;

architecture rtl of ul_pwm is

  function chosen (condition : boolean; yes, no : natural) return natural is
  begin

    if condition then
      return yes;
    end if;
    return no;

  end function chosen;

  constant is_offset  : boolean := mode = "offset";
  constant is_up_down : boolean := mode = "up_down";

  -- A generic that is not allowed ends with the sentence of its assertion, not before.
  constant bits : positive := minimum(maximum(width, 2), 24);

  -- Cycles of half a period, and of a ramp.
  constant half  : natural := (clock_hz + minimum(frequency_hz, clock_hz)) / (2 * minimum(frequency_hz, clock_hz));
  constant steps : natural := chosen(centre, half, 2 * half);

  -- The largest value, in "offset" counted from the smallest.
  constant full      : positive := chosen(is_offset, 2, 1) * (2 ** (bits - 1) - 1);
  constant ramp_bits : positive := chosen(is_offset, bits, bits - 1);

  -- What a ramp begins with, in units of 1 / steps. One that falls is the complement of one that rises from one more; in
  -- "offset" all is one more, for the most negative number is 0 there.
  constant falls_from : natural := full - 1 - full / 4 + steps;
  constant rises_from : natural := chosen(centre, 3 * full / 4, full / 2) + chosen(is_offset, steps, 0);

  -- By what it rises in each step.
  constant whole : natural := full / steps;
  constant part  : natural := full mod steps;

  -- Cycles for which both pins are off.
  constant dead : natural := cycles_of(dead_time_ns, 1_000_000_000, clock_hz);

  subtype ramp_t is unsigned(ramp_bits - 1 downto 0);

  -- Below 0 while the next step is `whole`, and else that and one more.
  subtype rest_t is signed(log2_ceil(steps) downto 0);

  -- Below 0 in the last step.
  subtype left_t is signed(log2_ceil(steps) downto 0);

  signal left      : left_t;
  signal is_second : std_logic;
  signal begins    : std_logic;
  signal ramp      : ramp_t;
  signal ramp_step : ramp_t;
  signal rest      : rest_t;
  signal rest_step : rest_t;
  signal beyond    : ramp_t;

begin

  assert width >= 2 and width <= 24
    report "ul_pwm: width is " & integer'image(width) & ": 2 to 24 was expected"
    severity failure;

  assert frequency_hz <= clock_hz / 4
    report "ul_pwm: frequency_hz is " & integer'image(frequency_hz) & ": at most a quarter of a clock of "
           & integer'image(clock_hz) & " Hz was expected"
    severity failure;

  assert mode = "sign" or is_up_down or is_offset
    report "ul_pwm: mode is " & mode & ": sign, up_down or offset was expected"
    severity failure;

  assert dead = 0 or (dead < half and (is_up_down or is_offset))
    report "ul_pwm: dead_time_ns is " & integer'image(dead_time_ns) & ": 0 was expected for the mode sign, and for"
           & " others less than half a period"
    severity failure;

  ramp_step <= to_unsigned(whole, ramp'length) when rest < 0 else
               to_unsigned(whole + 1, ramp'length);
  rest_step <= to_signed(part, rest'length) when rest < 0 else
               to_signed(part - steps, rest'length);

  time_base : process (clk) is
  begin

    if rising_edge(clk) then
      begins <= '0';
      left   <= left - 1;
      ramp   <= ramp + ramp_step;
      rest   <= rest + rest_step;
      if left < 0 then
        left <= to_signed(steps - 2, left'length);
        if centre and is_second = '1' then
          is_second <= '0';
          ramp      <= to_unsigned(falls_from / steps, ramp'length);
          rest      <= to_signed(falls_from mod steps + part - steps, rest'length);
        else
          is_second <= '1';
          ramp      <= to_unsigned(rises_from / steps, ramp'length);
          rest      <= to_signed(rises_from mod steps + part - steps, rest'length);
        end if;
        begins <= is_second;
      end if;

      -- What a value is compared with; inverted, as the comparison needs it.
      beyond <= ramp;
      if is_second = '1' then
        beyond <= not ramp;
      end if;

      if rst = '1' then
        begins    <= '0';
        left      <= (others => '1');
        is_second <= '1';
        ramp      <= (others => '0');
        rest      <= (others => '1');
        beyond    <= (others => '0');
      end if;
    end if;

  end process time_base;

  all_axes : for axis in 0 to axes - 1 generate

    signal given       : unsigned(bits - 1 downto 0);
    signal signs       : unsigned(bits - 2 downto 0);
    signal size        : ramp_t;
    signal is_negative : std_logic;
    signal runs        : std_logic;
    signal sum         : unsigned(ramp_bits + 1 downto 0);
    signal is_above    : std_logic;
    signal may_pulse   : std_logic;
    signal wants_pwm   : std_logic;
    signal wants_dir   : std_logic;

  begin

    given <= resize(unsigned(value(axis * width + width - 1 downto axis * width)), bits);
    signs <= (others => given(bits - 1));

    take : process (clk) is
    begin

      if rising_edge(clk) then
        if begins = '1' then
          runs        <= '1';
          is_negative <= given(bits - 1);
          size        <= resize(given(bits - 2 downto 0) xor signs, ramp_bits);
          if is_offset then
            is_negative <= '0';
            size        <= resize(not given(bits - 1) & given(bits - 2 downto 0), ramp_bits);
          end if;
        end if;
        if armed(axis) = '0' or rst = '1' then
          runs <= '0';
        end if;
      end if;

    end process take;

    -- The lowest bit makes the carry that goes in, the highest is the one that comes out.
    sum       <= ('0' & size & '1') + ('0' & beyond & is_negative);
    is_above  <= sum(sum'high);
    may_pulse <= runs and armed(axis);

    wants_pwm <= may_pulse and is_above and not is_negative when is_up_down else
                 may_pulse and is_above;
    wants_dir <= may_pulse and is_above and is_negative when is_up_down else
                 may_pulse and not is_above when is_offset else
                 may_pulse and is_negative;

    without_dead_time : if dead = 0 generate

      drive : process (clk) is
      begin

        if rising_edge(clk) then
          pwm(axis) <= wants_pwm and not rst;
          dir(axis) <= wants_dir and not rst;
        end if;

      end process drive;

    end generate without_dead_time;

    with_dead_time : if dead > 0 generate

      subtype wait_t is signed(log2_ceil(dead) downto 0);

      signal was_pwm : std_logic;
      signal waits   : wait_t;

    begin

      -- A pin is on again at once, the other one once `waits` has gone below 0.
      drive : process (clk) is
      begin

        if rising_edge(clk) then
          pwm(axis) <= '0';
          dir(axis) <= '0';
          if waits >= 0 then
            waits <= waits - 1;
          end if;
          if wants_pwm = '1' and (was_pwm = '1' or waits < 0) then
            pwm(axis) <= '1';
            was_pwm   <= '1';
            waits     <= to_signed(dead - 1, waits'length);
          end if;
          if wants_dir = '1' and (was_pwm = '0' or waits < 0) then
            dir(axis) <= '1';
            was_pwm   <= '0';
            waits     <= to_signed(dead - 1, waits'length);
          end if;

          if rst = '1' then
            pwm(axis) <= '0';
            dir(axis) <= '0';
            waits     <= to_signed(dead - 1, waits'length);
          end if;
        end if;

      end process drive;

    end generate with_dead_time;

  end generate all_axes;

end architecture rtl;
