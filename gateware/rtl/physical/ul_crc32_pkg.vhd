-- SPDX-License-Identifier: BSD-3-Clause
--
-- The frame check sequence of Ethernet (IEEE 802.3, 3.2.9): CRC-32 over the bits in the order of the line, lowest bit
-- of a byte first. The initial value is all ones, and the complement of the result is sent.

library ieee;
  use ieee.std_logic_1164.all;

package ul_crc32_pkg is

  -- Residue of the CRC after a frame and its frame check sequence, if the frame is intact.
  constant crc32_right : std_logic_vector(31 downto 0) := x"DEBB20E3";

  -- CRC after further bits, lowest bit first.
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
