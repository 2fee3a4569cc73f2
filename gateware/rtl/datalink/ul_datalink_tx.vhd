-- SPDX-License-Identifier: BSD-3-Clause
--
-- Datalink layer, transmitter: adds the prefix before a body (on a shared medium), and the CRC and the line end after
-- it.
--
-- It outputs one character per cycle, line ends included; while the CRC of a frame is sent, the frame writer prepares
-- the next body. The send-immediate mark of a frame accompanies its very last character.
--
-- The seed of the session is in the CRC of samples and of all frames that begin with a small letter.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_crc_pkg.all;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_datalink_tx is
  generic (
    crc_bits       : positive                      := 16;
    crc_polynomial : std_logic_vector(31 downto 0) := x"00001021";
    -- Node number on a shared medium, 0 to 254; -1 if the medium is not shared.
    node : integer := -1
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- Bodies; in_plain and in_mark are valid with in_last.
    in_data  : in    std_logic_vector(7 downto 0);
    in_valid : in    std_logic;
    in_ready : out   std_logic;
    in_last  : in    std_logic;
    in_plain : in    std_logic;
    in_mark  : in    flush_mark_t;
    -- The current session, 0 if there is none; evaluated when the first letter of a body is accepted.
    session    : in    std_logic_vector(4 * session_digits_of(crc_bits) - 1 downto 0);
    in_session : in    std_logic;
    -- The answer belongs to no session: only samples have the seed in their CRC.
    no_session : in    std_logic := '0';
    out_data   : out   std_logic_vector(7 downto 0);
    out_mark   : out   flush_mark_t;
    out_valid  : out   std_logic;
    out_ready  : in    std_logic;
    -- Accepted characters have not been output completely.
    busy : out   std_logic
  );
end entity ul_datalink_tx;

architecture rtl of ul_datalink_tx is

  constant crc_digits : positive := crc_bits / 4;

  type state_t is (state_prefix, state_body, state_check, state_cr, state_lf);

  function first_state return state_t is
  begin

    if node >= 0 then
      return state_prefix;
    else
      return state_body;
    end if;

  end function first_state;

  type registers_t is record
    state : state_t;
    left  : unsigned(log2_ceil(crc_digits + 1) - 1 downto 0);
    crc   : std_logic_vector(crc_bits - 1 downto 0);
    -- A character after the prefix was accepted.
    text_begun : std_logic;
    mark       : flush_mark_t;
    out_data   : std_logic_vector(7 downto 0);
    out_mark   : flush_mark_t;
    out_valid  : std_logic;
  end record registers_t;

  constant after_reset : registers_t :=
  (
    state      => first_state,
    left       => (others => '0'),
    crc        => (others => '0'),
    text_begun => '0',
    mark       => flush_none,
    out_data   => (others => '0'),
    out_mark   => flush_none,
    out_valid  => '0'
  );

  signal r       : registers_t;
  signal advance : std_logic;

  function prefix_character (place : natural) return std_logic_vector is

    constant number : std_logic_vector(7 downto 0) := std_logic_vector(to_unsigned(maximum(node, 0), 8));

  begin

    case place is

      when 0 =>
        return character_z;

      when 1 =>
        return hex_character(number(7 downto 4));

      when others =>
        return hex_character(number(3 downto 0));

    end case;

  end function prefix_character;

begin

  advance  <= not r.out_valid or out_ready;
  in_ready <= advance and to_std_logic(r.state = state_body);

  out_data  <= r.out_data;
  out_mark  <= r.out_mark;
  out_valid <= r.out_valid;
  busy      <= r.out_valid or to_std_logic(r.state /= first_state);

  main : process (clk) is

    variable v          : registers_t;
    variable of_session : std_logic;

    -- Output a character that the CRC covers.

    procedure put_covered (code : std_logic_vector(7 downto 0); seeded : std_logic) is

      variable begun : std_logic_vector(crc_bits - 1 downto 0);

    begin

      begun := r.crc;
      if seeded = '1' then
        begun := r.crc xor seed_of(session, in_session, crc_bits);
      end if;
      v.out_data  := code;
      v.out_valid := '1';
      v.crc       := crc_after(begun, code, crc_polynomial);

    end procedure put_covered;

  begin

    if rising_edge(clk) then
      v := r;
      if advance = '1' then
        v.out_valid := '0';
        v.out_mark  := flush_none;

        case r.state is

          when state_prefix =>
            if in_valid = '1' then
              put_covered(prefix_character(to_integer(r.left)), '0');
              v.left := r.left + 1;
              if r.left = 2 then
                v.state := state_body;
              end if;
            end if;

          when state_body =>
            if in_valid = '1' then
              -- Of the first letters of bodies, only P (x"50") has 0 in its four low bits.
              of_session   := (in_data(5) and not no_session) or to_std_logic(unsigned(in_data(3 downto 0)) = 0);
              put_covered(in_data, of_session and not r.text_begun);
              v.text_begun := '1';
            end if;
            v.left := to_unsigned(crc_digits, v.left'length);
            v.mark := in_mark;
            if in_valid = '1' and in_last = '1' then
              v.state := state_check;
              if in_plain = '1' then
                v.state := state_cr;
              end if;
            end if;

          when state_check =>
            -- Output both digits of the highest byte, then move the next byte to its place. The CRC logic does the
            -- move: a CRC updated with its own highest byte is that CRC shifted by eight bits.
            v.out_data  := hex_character(r.crc(crc_bits - 1 downto crc_bits - 4));
            v.out_valid := '1';
            if r.left(0) = '1' then
              v.out_data := hex_character(r.crc(crc_bits - 5 downto crc_bits - 8));
              v.crc      := crc_after(r.crc, r.crc(crc_bits - 1 downto crc_bits - 8), crc_polynomial);
            end if;
            v.left := r.left - 1;
            if r.left = 1 then
              v.state := state_lf;
            end if;

          when state_cr =>
            v.out_data  := character_cr;
            v.out_valid := '1';
            v.state     := state_lf;

          when state_lf =>
            v.out_data   := character_lf;
            v.out_valid  := '1';
            v.out_mark   := r.mark;
            v.crc        := (others => '0');
            v.text_begun := '0';
            v.left       := (others => '0');
            v.state      := first_state;

        end case;

      end if;
      r <= v;

      if rst = '1' then
        r <= after_reset;
      end if;
    end if;

  end process main;

end architecture rtl;
