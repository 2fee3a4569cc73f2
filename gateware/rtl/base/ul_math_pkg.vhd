-- SPDX-License-Identifier: BSD-3-Clause
--
-- Sizes of counters and pointers, worked out when the design is elaborated; nothing here becomes logic.

package ul_math_pkg is

  -- Bits that count from 0 to value - 1: log2_ceil(1) = 0, log2_ceil(8) = 3, log2_ceil(9) = 4. 0 is
  -- as 1, so that a generic which is too small ends with the sentence of its assertion, not before.
  function log2_ceil (value : natural) return natural;

  function is_power_of_two (value : positive) return boolean;

  -- Cycles of a clock that a duration takes, rounded up: cycles_of(1510, 1_000_000_000, 10_000_000) = 16. A second has
  -- `per_second` units of the duration, at most 1_000_000_000. More than 2 ** 30 cycles are natural'high.
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

    -- Long multiplication by the duration, its highest bit first; `rest` is what is below a cycle.
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
