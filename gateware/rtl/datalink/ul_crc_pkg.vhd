-- SPDX-License-Identifier: BSD-3-Clause
--
-- The CRC of a frame (docs/protocol.md, "Frames"): 8, 16 or 32 bits, not reflected, initial value 0, no final XOR. In a
-- session, the seed of the session is XORed into the CRC before the first letter of some frames.

library ieee;
  use ieee.std_logic_1164.all;

package ul_crc_pkg is

  -- CRC after one more character. `crc` sets the width; `polynomial` has no highest term and is right-aligned.
  function crc_after (
    crc        : std_logic_vector;
    character  : std_logic_vector(7 downto 0);
    polynomial : std_logic_vector(31 downto 0)
  ) return std_logic_vector;

  -- The seed of a session: twice its number plus the direction, aligned to a CRC of crc_bits bits.
  function seed_of (session : std_logic_vector; direction : std_logic; crc_bits : positive) return std_logic_vector;

end package ul_crc_pkg;

package body ul_crc_pkg is

  function crc_after (
    crc        : std_logic_vector;
    character  : std_logic_vector(7 downto 0);
    polynomial : std_logic_vector(31 downto 0)
  ) return std_logic_vector is

    constant width     : positive                             := crc'length;
    constant taps      : std_logic_vector(width - 1 downto 0) := polynomial(width - 1 downto 0);
    variable remainder : std_logic_vector(width - 1 downto 0);
    variable carry     : std_logic;

  begin

    remainder                             := crc;
    remainder(width - 1 downto width - 8) := remainder(width - 1 downto width - 8) xor character;

    for bit_number in 1 to 8 loop

      carry     := remainder(width - 1);
      remainder := remainder(width - 2 downto 0) & '0';
      if carry = '1' then
        remainder := remainder xor taps;
      end if;

    end loop;

    return remainder;

  end function crc_after;

  function seed_of (session : std_logic_vector; direction : std_logic; crc_bits : positive) return std_logic_vector is

    variable seed : std_logic_vector(crc_bits - 1 downto 0) := (others => '0');

  begin

    seed(session'length - 1 downto 0) := session(session'length - 2 downto 0) & direction;
    return seed;

  end function seed_of;

end package body ul_crc_pkg;
