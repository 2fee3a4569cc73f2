-- SPDX-License-Identifier: BSD-3-Clause
--
-- Sizes of counters and pointers, worked out when the design is elaborated; nothing here becomes logic.

package ul_math_pkg is

  -- Bits that count from 0 to value - 1: log2_ceil(1) = 0, log2_ceil(8) = 3, log2_ceil(9) = 4. 0 is
  -- as 1, so that a generic which is too small ends with the sentence of its assertion, not before.
  function log2_ceil (value : natural) return natural;

  function is_power_of_two (value : positive) return boolean;

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

end package body ul_math_pkg;
