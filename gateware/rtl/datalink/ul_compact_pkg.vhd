-- SPDX-License-Identifier: BSD-3-Clause
--
-- The compact form of frames (docs/protocol.md, "The compact form"): its special bytes, and its command numbers.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

package ul_compact_pkg is

  constant compact_start  : std_logic_vector(7 downto 0) := x"B5";
  constant compact_end    : std_logic_vector(7 downto 0) := x"CA";
  constant compact_escape : std_logic_vector(7 downto 0) := x"D3";
  -- XORed into a byte after an escape.
  constant compact_stuffed : std_logic_vector(7 downto 0) := x"40";

  -- Commands that have a compact form, in the order of their numbers: two letters each, padded with a blank.
  constant compact_commands : string(1 to 32) := "r rmrqw wmwqwkwsh gngxgpi n x P ";

  constant sample_command : natural := 15;
  constant count_command  : natural := 8;

  -- Requests of the commands with a number below this have an address.
  constant addressed_commands : natural := 8;

  -- The first or second letter of the command with this number; x"20" if it has no second letter.
  function compact_letter (number : natural; is_second : boolean) return std_logic_vector;

  -- Whether the byte needs an escape before it.
  function is_reserved (data : std_logic_vector(7 downto 0)) return boolean;

  -- '1' for each command whose number is followed by a padding digit in requests, or in the gateway's frames. The CRC
  -- always has an even number of digits.
  function filled_requests (id_digits, address_digits : natural) return std_logic_vector;

  function filled_answers (id_digits : natural) return std_logic_vector;

end package ul_compact_pkg;

package body ul_compact_pkg is

  function compact_letter (number : natural; is_second : boolean) return std_logic_vector is

    variable place : natural;

  begin

    place := 2 * number + 1;
    if is_second then
      place := place + 1;
    end if;
    return std_logic_vector(to_unsigned(character'pos(compact_commands(place)), 8));

  end function compact_letter;

  function is_reserved (data : std_logic_vector(7 downto 0)) return boolean is
  begin

    return data = compact_start or data = compact_end or data = compact_escape or data = x"0A" or data = x"0D";

  end function is_reserved;

  -- Whether a padding digit is needed in a frame that has this number of digits after the command number.
  function is_filled (digits : natural) return std_logic is
  begin

    if digits mod 2 = 0 then
      return '1';
    else
      return '0';
    end if;

  end function is_filled;

  function filled_requests (id_digits, address_digits : natural) return std_logic_vector is

    variable result : std_logic_vector(0 to 15);

  begin

    for number in result'range loop

      result(number) := is_filled(id_digits);
      if number < addressed_commands then
        result(number) := is_filled(id_digits + address_digits);
      end if;

    end loop;

    result(sample_command) := is_filled(0);
    return result;

  end function filled_requests;

  function filled_answers (id_digits : natural) return std_logic_vector is

    variable result : std_logic_vector(0 to 15);

  begin

    result                 := (others => is_filled(id_digits));
    result(count_command)  := is_filled(2 * id_digits);
    result(sample_command) := is_filled(0);
    return result;

  end function filled_answers;

end package body ul_compact_pkg;
