-- SPDX-License-Identifier: BSD-3-Clause
--
-- The compact form of frames (docs/protocol.md, "The compact form"): what its bytes and the numbers of commands are.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

package ul_compact_pkg is

  constant compact_start  : std_logic_vector(7 downto 0) := x"B5";
  constant compact_end    : std_logic_vector(7 downto 0) := x"CA";
  constant compact_escape : std_logic_vector(7 downto 0) := x"D3";
  -- Behind an escape this is xored into a byte.
  constant compact_stuffed : std_logic_vector(7 downto 0) := x"40";

  type command_t is array (0 to 1) of std_logic_vector(7 downto 0);

  type commands_t is array (0 to 15) of command_t;

  -- Letters of the commands; x"00" for none.
  constant compact_commands : commands_t :=
  (
    (x"72", x"00"), (x"72", x"6D"), (x"72", x"71"), (x"77", x"00"),
    (x"77", x"6D"), (x"77", x"71"), (x"77", x"6B"), (x"77", x"73"),
    (x"68", x"00"), (x"67", x"6E"), (x"67", x"78"), (x"67", x"70"),
    (x"69", x"00"), (x"6E", x"00"), (x"78", x"00"), (x"50", x"00")
  );

  constant sample_command : natural := 15;

  -- Commands whose requests name an address are those with a number below this.
  constant addressed_commands : natural := 8;

  -- The byte has an escape before it.
  function is_reserved (data : std_logic_vector(7 downto 0)) return boolean;

  -- For each command '1' where a digit of no meaning stands behind its number. The digits of a CRC are even in number.
  function compact_filled (id_digits, address_digits : natural) return std_logic_vector;

end package ul_compact_pkg;

package body ul_compact_pkg is

  function is_reserved (data : std_logic_vector(7 downto 0)) return boolean is
  begin

    return data = compact_start or data = compact_end or data = compact_escape or data = x"0A" or data = x"0D";

  end function is_reserved;

  function compact_filled (id_digits, address_digits : natural) return std_logic_vector is

    variable digits : natural;
    variable result : std_logic_vector(0 to 15);

  begin

    for number in result'range loop

      digits := 1;
      if number /= sample_command then
        digits := digits + id_digits;
      end if;
      if number < addressed_commands then
        digits := digits + address_digits;
      end if;
      result(number) := '0';
      if digits mod 2 = 1 then
        result(number) := '1';
      end if;

    end loop;

    return result;

  end function compact_filled;

end package body ul_compact_pkg;
