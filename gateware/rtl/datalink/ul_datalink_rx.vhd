-- SPDX-License-Identifier: BSD-3-Clause
--
-- Datalink layer, receiver: separates frames and checks their CRC (docs/protocol.md, "Frames" and "Addressed frames").
--
-- The body of a frame is output character by character. The result of the check follows as a separate event,
-- `out_last`, without a character. The application layer must not act on a frame before that event.
--
-- The last `crc_bits / 4` characters of a frame are its CRC if the frame ends in LF, and part of its body if it ends in
-- CR; only the end distinguishes the two. So characters pass a delay line of that length. At LF the delay line contains
-- exactly the CRC, which is compared while the event is valid; at CR its contents are output as part of the body. The
-- CRC is computed over the characters that leave this entity (and over the prefix of a shared medium, which does not
-- enter the delay line). So a first letter that was not accepted yet is not in the CRC either: if the application layer
-- does not accept it before a session has begun, that session's seed is in the CRC.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_crc_pkg.all;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_datalink_rx is
  generic (
    crc_bits       : positive                      := 16;
    crc_polynomial : std_logic_vector(31 downto 0) := x"00001021";
    -- Maximum number of characters before the end, without the prefix.
    longest : positive := 2048;
    -- Node number on a shared medium, 0 to 254; -1 if the medium is not shared.
    node : integer := -1
  );
  port (
    clk      : in    std_logic;
    rst      : in    std_logic;
    in_data  : in    std_logic_vector(7 downto 0);
    in_lost  : in    std_logic;
    in_valid : in    std_logic;
    in_ready : out   std_logic;
    -- The current session, 0 if there is none; evaluated when a first letter is accepted.
    session    : in    std_logic_vector(4 * session_digits_of(crc_bits) - 1 downto 0);
    in_session : in    std_logic;
    -- A character of a body; with out_last, the end of the frame.
    out_data  : out   std_logic_vector(7 downto 0);
    out_valid : out   std_logic;
    out_ready : in    std_logic;
    out_last  : out   std_logic;
    -- Valid with out_last: out_plain is '1' for a plain frame; out_error is 09, 07, 01 or none; out_silent is '1' if
    -- the frame is addressed to all nodes and must not be answered.
    out_plain  : out   std_logic;
    out_error  : out   error_t;
    out_silent : out   std_logic;
    -- Valid with out_last, for a checked frame: XOR of the received CRC and the computed one. If no session exists and
    -- the first letter is small, a residue other than 0 is not an error.
    out_residue : out   std_logic_vector(crc_bits - 1 downto 0);
    -- A frame has begun, and its end has not been output yet.
    busy : out   std_logic
  );
end entity ul_datalink_rx;

architecture rtl of ul_datalink_rx is

  constant crc_digits    : positive := crc_bits / 4;
  constant prefix_length : natural  := 3;

  type line_t is array (0 to crc_digits - 1) of std_logic_vector(7 downto 0);

  type registers_t is record
    delayed : line_t;
    filled  : std_logic_vector(0 to crc_digits - 1);
    crc     : std_logic_vector(crc_bits - 1 downto 0);
    -- text_begun: a letter was accepted. small: the first letter is small.
    text_begun : std_logic;
    small      : std_logic;
    -- Number of characters that may still arrive before the frame is too long.
    left     : unsigned(log2_ceil(longest + 1) - 1 downto 0);
    too_long : std_logic;
    lost     : std_logic;
    begun    : std_logic;
    draining : std_logic;
    -- Number of prefix characters received, and whether they address this node or all nodes.
    prefix     : unsigned(1 downto 0);
    to_me      : std_logic;
    to_all     : std_logic;
    out_data   : std_logic_vector(7 downto 0);
    out_valid  : std_logic;
    out_last   : std_logic;
    out_plain  : std_logic;
    out_error  : error_t;
    out_silent : std_logic;
  end record registers_t;

  constant after_reset : registers_t :=
  (
    delayed    => (others => (others => '0')),
    filled     => (others => '0'),
    crc        => (others => '0'),
    text_begun => '0',
    small      => '0',
    left       => to_unsigned(longest, log2_ceil(longest + 1)),
    too_long   => '0',
    lost       => '0',
    begun      => '0',
    draining   => '0',
    prefix     => (others => '0'),
    to_me      => '1',
    to_all     => to_std_logic(node >= 0),
    out_data   => (others => '0'),
    out_valid  => '0',
    out_last   => '0',
    out_plain  => '0',
    out_error  => error_none,
    out_silent => '0'
  );

  signal r       : registers_t;
  signal advance : std_logic;
  signal residue : std_logic_vector(crc_bits - 1 downto 0);
  signal damaged : std_logic;

  -- The number in the delay line, as hex digits of either case.
  function number_in (line : line_t) return std_logic_vector is

    variable number : std_logic_vector(crc_bits - 1 downto 0);

  begin

    for digit in line'range loop

      number(4 * digit + 3 downto 4 * digit) := hex_value(line(digit));

    end loop;

    return number;

  end function number_in;

  function all_hex (line : line_t) return std_logic is

    variable result : std_logic := '1';

  begin

    for digit in line'range loop

      result := result and is_hex(line(digit));

    end loop;

    return result;

  end function all_hex;

  -- Whether a letter is a small one.
  function is_small (code : std_logic_vector(7 downto 0)) return std_logic is
  begin

    return to_std_logic(unsigned(code) >= x"61" and unsigned(code) <= x"7A");

  end function is_small;

  -- Whether a character is the first or the second hex digit of a node's number.
  function is_digit_of (code : std_logic_vector(7 downto 0); number : natural; first : boolean) return std_logic is

    constant digits : std_logic_vector(7 downto 0) := std_logic_vector(to_unsigned(number, 8));

  begin

    if first then
      return is_hex(code) and to_std_logic(hex_value(code) = digits(7 downto 4));
    end if;
    return is_hex(code) and to_std_logic(hex_value(code) = digits(3 downto 0));

  end function is_digit_of;

  function is_end (code : std_logic_vector(7 downto 0)) return boolean is
  begin

    return code = character_lf or code = character_cr;

  end function is_end;

begin

  advance  <= not r.out_valid or out_ready;
  in_ready <= advance and not r.draining;

  out_data   <= r.out_data;
  out_valid  <= r.out_valid;
  out_last   <= r.out_last;
  out_plain  <= r.out_plain;
  out_silent <= r.out_silent;
  -- Errors with priority over a CRC error (01) have bit 0 set too, so OR-ing that bit does not change them.
  out_error <= r.out_error(3 downto 1) & (r.out_error(0) or damaged);

  residue     <= number_in(r.delayed) xor r.crc;
  damaged     <= not r.out_plain and (not all_hex(r.delayed) or
                                      (to_std_logic(unsigned(residue) /= 0) and (in_session or not r.small)));
  out_residue <= residue;
  busy        <= r.begun or r.out_valid;

  assert crc_bits = 8 or crc_bits = 16 or crc_bits = 32
    report "ul_datalink_rx: crc_bits is " & integer'image(crc_bits) & ", expected 8, 16 or 32"
    severity failure;

  assert node >= -1 and node <= 254
    report "ul_datalink_rx: node is " & integer'image(node) & ", expected 0 to 254, or -1"
    severity failure;

  main : process (clk) is

    variable v : registers_t;

    -- Shift the delay line; its oldest character goes into the body.

    procedure step_line (newest : std_logic_vector(7 downto 0); newest_valid : std_logic) is
    begin

      v.out_data := r.delayed(crc_digits - 1);
      if r.filled(crc_digits - 1) = '1' then
        v.out_valid := '1';
      end if;
      v.delayed := newest & r.delayed(0 to crc_digits - 2);
      v.filled  := newest_valid & r.filled(0 to crc_digits - 2);

    end procedure step_line;

    -- The application layer has accepted a character: include it in the CRC.

    procedure count_character is

      variable begun : std_logic_vector(crc_bits - 1 downto 0);

    begin

      begun := r.crc;
      if r.text_begun = '0' then
        v.small := is_small(r.out_data);
        if v.small = '1' then
          begun := r.crc xor seed_of(session, '0', crc_bits);
        end if;
      end if;
      v.crc        := crc_after(begun, r.out_data, crc_polynomial);
      v.text_begun := '1';

    end procedure count_character;

    procedure forget_text is
    begin

      v.crc        := (others => '0');
      v.text_begun := '0';
      v.small      := '0';

    end procedure forget_text;

    procedure finish_frame (plain : std_logic) is
    begin

      v.out_valid  := '1';
      v.out_last   := '1';
      v.out_plain  := plain;
      v.out_silent := to_std_logic(node >= 0) and r.to_all;
      if v.lost = '1' then
        v.out_error := error_overflow;
      elsif r.too_long = '1' then
        v.out_error := error_too_long;
      elsif plain = '0' and r.filled(crc_digits - 1) = '0' then
        v.out_error := error_crc;
      else
        v.out_error := error_none;
      end if;

    end procedure finish_frame;

    procedure forget_frame is
    begin

      v.filled   := (others => '0');
      v.left     := after_reset.left;
      v.too_long := '0';
      v.lost     := '0';
      v.begun    := '0';
      v.draining := '0';
      v.prefix   := (others => '0');
      v.to_me    := '1';
      v.to_all   := after_reset.to_all;

    end procedure forget_frame;

    procedure take_prefix is

      variable begun : std_logic_vector(crc_bits - 1 downto 0);

    begin

      begun := r.crc;
      if r.prefix = 0 then
        begun := (others => '0');
      end if;
      v.crc    := crc_after(begun, in_data, crc_polynomial);
      v.prefix := r.prefix + 1;
      if r.prefix = 0 then
        v.to_me  := to_std_logic(in_data = character_z);
        v.to_all := v.to_me;
      else
        v.to_me  := r.to_me and is_digit_of(in_data, maximum(node, 0), r.prefix = 1);
        v.to_all := r.to_all and is_digit_of(in_data, 255, r.prefix = 1);
      end if;

    end procedure take_prefix;

    procedure take_character is
    begin

      if r.to_me = '0' and r.to_all = '0' then
        return;
      end if;
      step_line(in_data, '1');
      if r.left = 0 then
        v.too_long := '1';
      else
        v.left := r.left - 1;
      end if;

    end procedure take_character;

    procedure take_end is

      variable for_us : boolean;

    begin

      for_us := node < 0 or (r.prefix = prefix_length and (r.to_me = '1' or r.to_all = '1'));
      -- An empty frame (two ends in succession, apart from the prefix) is ignored.
      if not for_us or (v.lost = '0' and r.left = longest) then
        forget_frame;
      elsif in_data = character_cr then
        v.draining := '1';
      else
        finish_frame('0');
        forget_frame;
      end if;

    end procedure take_end;

  begin

    if rising_edge(clk) then
      v := r;
      if advance = '1' then
        v.out_valid := '0';
        v.out_last  := '0';
        if r.out_valid = '1' and r.out_last = '1' then
          forget_text;
        elsif r.out_valid = '1' then
          count_character;
        end if;
        if r.draining = '1' then
          if unsigned(r.filled) = 0 then
            finish_frame('1');
            forget_frame;
          else
            step_line(r.delayed(0), '0');
          end if;
        elsif in_valid = '1' then
          v.begun := '1';
          v.lost  := r.lost or in_lost;
          if is_end(in_data) then
            take_end;
          elsif node >= 0 and r.prefix /= prefix_length then
            take_prefix;
          else
            take_character;
          end if;
        end if;
      end if;
      r <= v;

      if rst = '1' then
        r <= after_reset;
      end if;
    end if;

  end process main;

end architecture rtl;
