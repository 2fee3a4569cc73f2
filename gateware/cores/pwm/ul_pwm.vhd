-- SPDX-License-Identifier: BSD-3-Clause
--
-- Pulse width modulation: converts signed values to pulses on two pins each, with one common time base.
--
-- A value is compared with a ramp that passes through its whole range in one period. So the pulse is proportional to
-- the value, rounded to the nearest cycle, at any frequency and without a multiplier. With `full` the largest value,
-- `period` the number of cycles of a period, and k the number of a cycle within it, the ramp is floor((k * full + full
-- / 2) / period): exactly round(value * period / full) of its cycles are below the value. It is generated without a
-- division: `ramp` accumulates the whole steps, `rest` the remainder.
--
-- With `centre`, each half of a period has a whole ramp: the first one is mirrored, so that it falls; the second one
-- rises. They are offset by one quarter and three quarters of a step, so that both together round like one ramp.
--
-- The ramp is stored inverted, because a comparison is an addition: a > b if a + not b has a carry. A negative value is
-- compared by its complement, which is its absolute value minus one; the carry input adds the one. So the most negative
-- number lies beyond the ramp like its successor, and both are full pulses.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_pwm is
  generic (
    -- At least 1: number of values, each with pins of its own, on one time base.
    axes : positive := 1;
    -- At least 1: frequency of clk in Hz.
    clock_hz : positive := 50_000_000;
    -- 2 to 24: bits of a value.
    width : positive := 12;
    -- 1 to clock_hz / 4: periods per second. A period is rounded to the nearest even number of cycles.
    frequency_hz : positive := 20_000;
    -- Whether a pulse is in the middle of its period instead of at its beginning.
    centre : boolean := false;
    -- "sign", "up_down", "offset": function of the pins. Absolute value and sign; pulses for positive and pulses for
    -- negative values; high and low side of a half bridge, which alternate with equal parts for 0.
    mode : string := "sign";
    -- Less than half a period, and 0 for "sign": nanoseconds for which both pins stay '0' before the other one becomes
    -- '1'.
    dead_time_ns : natural := 0
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- '0': both pins of this axis are '0' from the next cycle on, until the first period after armed is '1' again.
    armed : in    std_logic_vector(axes - 1 downto 0) := (others => '1');
    -- Signed value, sampled at the beginning of each period.
    value : in    std_logic_vector(axes * width - 1 downto 0);
    -- Unused.
    value_written : in    std_logic_vector(axes - 1 downto 0) := (others => '0');
    -- By mode: the pulse; the pulse of positive values; the high side.
    pwm : out   std_logic_vector(axes - 1 downto 0);
    -- By mode: '1' for negative values; the pulse of negative values; the low side.
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

  -- Clamped, so that elaboration reaches the assertions below even for a width that is not allowed.
  constant bits : positive := minimum(maximum(width, 2), 24);

  -- Cycles of half a period, and of a ramp.
  constant half  : natural := (clock_hz + minimum(frequency_hz, clock_hz)) / (2 * minimum(frequency_hz, clock_hz));
  constant steps : natural := chosen(centre, half, 2 * half);

  -- The largest value; in "offset" counted from the smallest one.
  constant full      : positive := chosen(is_offset, 2, 1) * (2 ** (bits - 1) - 1);
  constant ramp_bits : positive := chosen(is_offset, bits, bits - 1);

  -- Initial values of a ramp in units of 1 / steps. A falling ramp is the complement of one that rises from one more.
  -- In "offset" all are one more, because there the most negative number is 0.
  constant falls_from : natural := full - 1 - full / 4 + steps;
  constant rises_from : natural := chosen(centre, 3 * full / 4, full / 2) + chosen(is_offset, steps, 0);

  -- Increment of the ramp in each step.
  constant whole : natural := full / steps;
  constant part  : natural := full mod steps;

  -- Cycles of dead time.
  constant dead : natural := cycles_of(dead_time_ns, 1_000_000_000, clock_hz);

  subtype ramp_t is unsigned(ramp_bits - 1 downto 0);

  -- Negative while the next step is `whole`; otherwise the next step is one more.
  subtype rest_t is signed(log2_ceil(steps) downto 0);

  -- Negative in the last step.
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

      -- Value of the comparison; inverted, as the comparison needs it.
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

    -- The lowest bit generates the carry input, the highest bit is the carry output.
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

      -- The pin that was '1' last may become '1' again at once, the other one after the dead time (`waits` is
      -- negative).
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
