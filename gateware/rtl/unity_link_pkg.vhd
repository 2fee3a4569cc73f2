-- SPDX-License-Identifier: BSD-3-Clause
--
-- Constants of the protocol for the gateware: command codes, error codes, and widths that depend on the generics.
-- `unity_link/protocol/wire/configuration.py` computes the same widths for the host; both follow docs/protocol.md.
--
-- A command code has four bits, chosen so that single bits answer frequent questions: bit 3 low is a bus access (with
-- bit 2 high for a write), and "10xx" is a command about groups. Messages from the gateway have three more codes, with
-- bit 4 high, that no request uses.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

package unity_link_pkg is

  subtype command_t is std_logic_vector(3 downto 0);

  constant command_r  : command_t := "0000";
  constant command_rm : command_t := "0001";
  constant command_rq : command_t := "0010";
  constant command_wk : command_t := "0011";
  constant command_w  : command_t := "0100";
  constant command_wm : command_t := "0101";
  constant command_wq : command_t := "0110";
  constant command_ws : command_t := "0111";
  constant command_gs : command_t := "1000";
  constant command_gn : command_t := "1001";
  constant command_gx : command_t := "1010";
  constant command_gp : command_t := "1011";
  constant command_i  : command_t := "1100";
  constant command_h  : command_t := "1101";
  constant command_q  : command_t := "1110";
  constant command_k  : command_t := "1111";

  -- Kind of a frame from the gateway: '0' and the command that it answers, or one of the codes below.
  subtype message_t is std_logic_vector(4 downto 0);

  constant message_error           : message_t := "10000";
  constant message_out_of_sequence : message_t := "10001";
  constant message_publish         : message_t := "10010";

  -- Error codes (docs/protocol.md, "Errors"). They have two digits on the wire; the upper one is always 0.
  subtype error_t is std_logic_vector(3 downto 0);

  constant error_none      : error_t := x"0";
  constant error_crc       : error_t := x"1";
  constant error_command   : error_t := x"2";
  constant error_malformed : error_t := x"3";
  constant error_bus       : error_t := x"4";
  constant error_timeout   : error_t := x"5";
  constant error_range     : error_t := x"6";
  constant error_too_long  : error_t := x"7";
  constant error_overflow  : error_t := x"9";
  constant error_session   : error_t := x"A";
  constant error_under_way : error_t := x"B";

  constant character_lf : std_logic_vector(7 downto 0) := x"0A";
  constant character_cr : std_logic_vector(7 downto 0) := x"0D";
  constant character_z  : std_logic_vector(7 downto 0) := x"5A";

  -- Group flags (docs/protocol.md, "Groups"), by bit number.
  constant flag_periodic  : natural := 0;
  constant flag_trigger   : natural := 1;
  constant flag_immediate : natural := 2;
  constant flag_timestamp : natural := 3;
  constant flag_on_change : natural := 4;
  constant flag_plain     : natural := 5;

  -- Features (docs/protocol.md, "Configuration"), by bit number.
  constant feature_groups            : natural := 0;
  constant feature_external_triggers : natural := 1;
  constant feature_timestamps        : natural := 2;
  constant feature_send_immediate    : natural := 3;
  constant feature_flow_control      : natural := 4;
  constant feature_masked_write      : natural := 5;
  constant feature_queue_commands    : natural := 6;
  constant feature_addressed         : natural := 7;
  constant feature_fingerprint       : natural := 8;
  constant feature_half_duplex       : natural := 9;
  constant feature_description       : natural := 10;
  constant feature_compact           : natural := 11;

  -- Mark for send-immediate at the end of a frame; it passes the transmit FIFO beside each byte.
  subtype flush_mark_t is std_logic_vector(1 downto 0);

  constant flush_none      : flush_mark_t := "00";
  constant flush_when_idle : flush_mark_t := "01";
  constant flush_now       : flush_mark_t := "10";

  -- Operations that the subscription manager executes on a group.
  subtype group_operation_t is std_logic_vector(2 downto 0);

  constant group_set      : group_operation_t := "000";
  constant group_start    : group_operation_t := "001";
  constant group_stop     : group_operation_t := "010";
  constant group_publish  : group_operation_t := "011";
  constant group_stop_all : group_operation_t := "100";
  -- No operation; reports done between two samples.
  constant group_nothing : group_operation_t := "101";

  -- Number of hex digits of a field with `bits` bits.
  function digits_of (bits : positive) return positive;

  -- Number of hex digits of a session number, with a CRC of `crc_bits` bits.
  function session_digits_of (crc_bits : positive) return positive;

  -- Bits of the field that holds divisors, session numbers and CRC residues.
  function number_bits_of (crc_bits : positive; groups : natural) return positive;

  -- Maximum number of characters before LF in a valid checked request, with its CRC. A longer one is rejected with X07.
  function longest_request (
    data_bits, address_bits, id_digits, crc_bits, block_words, groups, group_words : natural;
    masked_write                                                                   : boolean
  ) return positive;

  -- ASCII code of a hex digit, in upper case.
  function hex_character (nibble : std_logic_vector(3 downto 0)) return std_logic_vector;

  -- '1' for 0-9, A-F, a-f.
  function is_hex (code : std_logic_vector(7 downto 0)) return std_logic;

  -- Value of a character for which is_hex is '1'.
  function hex_value (code : std_logic_vector(7 downto 0)) return std_logic_vector;

  function to_std_logic (condition : boolean) return std_logic;

  -- Bit `number` of a vector, '0' after the last one.
  function bit_at (vector : std_logic_vector; number : unsigned) return std_logic;

end package unity_link_pkg;

package body unity_link_pkg is

  function digits_of (bits : positive) return positive is
  begin

    return (bits + 3) / 4;

  end function digits_of;

  function session_digits_of (crc_bits : positive) return positive is
  begin

    if crc_bits = 8 then
      return 2;
    end if;
    return 4;

  end function session_digits_of;

  function number_bits_of (crc_bits : positive; groups : natural) return positive is
  begin

    if crc_bits < 16 and groups > 0 then
      return 16;
    end if;
    return crc_bits;

  end function number_bits_of;

  function longest_request (
    data_bits, address_bits, id_digits, crc_bits, block_words, groups, group_words : natural;
    masked_write                                                                   : boolean
  ) return positive is

    constant head   : positive := 2 + id_digits;
    variable length : positive := head + digits_of(address_bits) + 2;

  begin

    length := maximum(length, head + digits_of(address_bits) + digits_of(data_bits) * block_words);
    if masked_write then
      length := maximum(length, head + digits_of(address_bits) + 2 * digits_of(data_bits));
    end if;
    if groups > 0 then
      length := maximum(length, head + 10 + digits_of(address_bits) * group_words);
    end if;
    return length + crc_bits / 4;

  end function longest_request;

  function hex_character (nibble : std_logic_vector(3 downto 0)) return std_logic_vector is
  begin

    if unsigned(nibble) > 9 then
      return std_logic_vector(x"37" + resize(unsigned(nibble), 8));
    else
      return x"3" & nibble;
    end if;

  end function hex_character;

  function is_hex (code : std_logic_vector(7 downto 0)) return std_logic is

    variable low : natural range 0 to 15;

  begin

    low := to_integer(unsigned(code(3 downto 0)));

    case code(7 downto 4) is

      when x"3" =>
        return to_std_logic(low <= 9);

      when x"4" | x"6" =>
        return to_std_logic(low >= 1 and low <= 6);

      when others =>
        return '0';

    end case;

  end function is_hex;

  function hex_value (code : std_logic_vector(7 downto 0)) return std_logic_vector is
  begin

    if code(6) = '1' then
      return std_logic_vector(unsigned(code(3 downto 0)) + 9);
    else
      return code(3 downto 0);
    end if;

  end function hex_value;

  function to_std_logic (condition : boolean) return std_logic is
  begin

    if condition then
      return '1';
    else
      return '0';
    end if;

  end function to_std_logic;

  function bit_at (vector : std_logic_vector; number : unsigned) return std_logic is

    -- Padded to the full range of the index, because vendors' tools reject an index that may exceed the vector.
    variable padded : std_logic_vector(2 ** number'length - 1 downto 0) := (others => '0');

  begin

    padded(vector'length - 1 downto 0) := vector;
    return padded(to_integer(number));

  end function bit_at;

end package body unity_link_pkg;
