-- SPDX-License-Identifier: BSD-3-Clause
--
-- Functions for the sizes of counters and pointers, evaluated at elaboration; none of them becomes logic.

package ul_math_pkg is

  -- Number of bits that count from 0 to value - 1: log2_ceil(1) = 0, log2_ceil(8) = 3, log2_ceil(9) = 4. The result for
  -- 0 is 0, so that a generic that is too small fails in its own assertion and not in this function.
  function log2_ceil (value : natural) return natural;

  function is_power_of_two (value : positive) return boolean;

  -- Clock cycles that a duration takes, rounded up: cycles_of(1510, 1_000_000_000, 10_000_000) = 16. `per_second` is
  -- the number of units of the duration in a second, at most 1_000_000_000. The result is natural'high above 2 ** 30
  -- cycles.
  function cycles_of (duration : natural; per_second : positive; clock_hz : positive) return natural;

end package ul_math_pkg;

package body ul_math_pkg is

  function log2_ceil (value : natural) return natural is

    variable remaining : natural := maximum(value, 1) - 1;
    variable bits      : natural := 0;

  begin

    while remaining > 0 loop

      remaining := remaining / 2;
      bits      := bits + 1;

    end loop;

    return bits;

  end function log2_ceil;

  function is_power_of_two (value : positive) return boolean is
  begin

    return 2 ** log2_ceil(value) = value;

  end function is_power_of_two;

  function cycles_of (duration : natural; per_second : positive; clock_hz : positive) return natural is

    constant whole  : natural := clock_hz / per_second;
    constant part   : natural := clock_hz mod per_second;
    variable cycles : natural := 0;
    variable rest   : natural := 0;

  begin

    -- Long multiplication by the duration, highest bit first; `rest` is the remainder below one cycle.
    for bit_number in 30 downto 0 loop

      cycles := 2 * cycles;
      rest   := 2 * rest;
      if rest >= per_second then
        cycles := cycles + 1;
        rest   := rest - per_second;
      end if;
      if (duration / 2 ** bit_number) mod 2 = 1 then
        cycles := cycles + whole;
        rest   := rest + part;
      end if;
      if rest >= per_second then
        cycles := cycles + 1;
        rest   := rest - per_second;
      end if;
      if cycles > 2 ** 29 and bit_number > 0 then
        return natural'high;
      end if;

    end loop;

    return cycles + minimum(rest, 1);

  end function cycles_of;

end package body ul_math_pkg;
