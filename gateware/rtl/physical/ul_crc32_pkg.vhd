-- SPDX-License-Identifier: BSD-3-Clause
--
-- The check of an Ethernet frame (IEEE 802.3, 3.2.9): CRC-32, taken from the lowest bit on, as the line has them. It
-- begins with ones, and its complement is sent.

library ieee;
  use ieee.std_logic_1164.all;

package ul_crc32_pkg is

  -- Its value behind a frame and its check.
  constant crc32_right : std_logic_vector(31 downto 0) := x"DEBB20E3";

  -- The CRC after some more bits, the lowest first.
  function crc32_after (crc : std_logic_vector(31 downto 0); data : std_logic_vector) return std_logic_vector;

end package ul_crc32_pkg;

package body ul_crc32_pkg is

  function crc32_after (crc : std_logic_vector(31 downto 0); data : std_logic_vector) return std_logic_vector is

    constant taps      : std_logic_vector(31 downto 0)              := x"EDB88320";
    constant bits      : std_logic_vector(data'length - 1 downto 0) := data;
    variable remainder : std_logic_vector(31 downto 0);
    variable carry     : std_logic;

  begin

    remainder := crc;

    for place in 0 to bits'high loop

      carry     := remainder(0) xor bits(place);
      remainder := '0' & remainder(31 downto 1);
      if carry = '1' then
        remainder := remainder xor taps;
      end if;

    end loop;

    return remainder;

  end function crc32_after;

end package body ul_crc32_pkg;
