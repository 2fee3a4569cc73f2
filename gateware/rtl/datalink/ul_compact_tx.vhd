-- SPDX-License-Identifier: BSD-3-Clause
--
-- Converts the frames of a session to compact form (docs/protocol.md, "The compact form"), and passes all others
-- through.
--
-- One byte per cycle leaves; text leaves in the cycle in which it arrives.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_compact_pkg.all;
  use work.unity_link_pkg.all;

entity ul_compact_tx is
  generic (
    -- Number of digits of an ID.
    id_digits : positive := 3;
    -- Node number on a shared medium, 0 to 254; -1 if the medium is not shared.
    node : integer := -1
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- The compact form was requested and the frame is checked; evaluated when its first character is accepted.
    compact   : in    std_logic;
    in_data   : in    std_logic_vector(7 downto 0);
    in_mark   : in    flush_mark_t;
    in_valid  : in    std_logic;
    in_ready  : out   std_logic;
    out_data  : out   std_logic_vector(7 downto 0);
    out_mark  : out   flush_mark_t;
    out_valid : out   std_logic;
    out_ready : in    std_logic;
    -- Accepted characters have not been output completely.
    busy : out   std_logic
  );
end entity ul_compact_tx;

architecture rtl of ul_compact_tx is

  constant filled : std_logic_vector(0 to 15)    := filled_answers(id_digits);
  constant number : std_logic_vector(7 downto 0) := std_logic_vector(to_unsigned(maximum(node, 0), 8));

  constant lf : std_logic_vector(7 downto 0) := x"0A";
  constant cr : std_logic_vector(7 downto 0) := x"0D";

  -- Kind of the next character: prefix; first letter; second letter or first digit; upper and lower digit of a pair;
  -- rest of a text line.

  type state_t is (at_prefix, at_letter, at_second, at_high, at_low, in_text);

  -- Bytes to output, one after the other, before the next character is accepted. For a compact frame: the node number,
  -- a byte, the byte after an escape, and on a shared medium a line end for receivers without the compact form. For a
  -- text frame: its prefix, and up to two letters.

  type rest_t is (
    nothing, of_node, of_node_escaped, of_byte, escaped, of_line_end, of_z, of_digit_high, of_digit_low, of_first,
    of_second
  );

  function first_state return state_t is
  begin

    if node >= 0 then
      return at_prefix;
    else
      return at_letter;
    end if;

  end function first_state;

  function first_of_text return rest_t is
  begin

    if node >= 0 then
      return of_z;
    else
      return of_first;
    end if;

  end function first_of_text;

  -- Return the number of a command that exists; the result for others is undefined. The comparisons are made in
  -- parallel, because a chain of them is too slow.
  function number_of (first, second : std_logic_vector(7 downto 0)) return std_logic_vector is

    variable letters : std_logic_vector(15 downto 0);
    variable result  : std_logic_vector(3 downto 0);

  begin

    result := "0000";

    for place in 0 to 15 loop

      letters := compact_letter(place, false) & compact_letter(place, true);
      result  := result or (std_logic_vector(to_unsigned(place, 4))
                            and (3 downto 0 => to_std_logic(letters(12 downto 8) = first(4 downto 0)
                                                            and letters(4 downto 0) = second(4 downto 0))));

    end loop;

    return result;

  end function number_of;

  signal state : state_t;
  signal rest  : rest_t;
  -- Number of prefix characters accepted.
  signal taken : unsigned(1 downto 0);
  signal first : std_logic_vector(7 downto 0);
  -- value: a whole byte, or the second letter of a text frame. is_whole: value is valid.
  signal value     : std_logic_vector(7 downto 0);
  signal is_whole  : std_logic;
  signal nibble    : std_logic_vector(3 downto 0);
  signal held      : std_logic;
  signal held_data : std_logic_vector(7 downto 0);
  signal held_mark : flush_mark_t;
  signal mark      : flush_mark_t;
  signal advance   : std_logic;
  -- No byte is held, and the next character belongs to text.
  signal passes : std_logic;

begin

  advance  <= out_ready or not held;
  passes   <= to_std_logic(rest = nothing and (state = in_text or (state = first_state and compact = '0'))) and not held;
  in_ready <= out_ready when passes = '1' else
              advance when rest = nothing else
              '0';

  out_data  <= in_data when passes = '1' else
               held_data;
  out_mark  <= in_mark when passes = '1' else
               held_mark;
  out_valid <= in_valid when passes = '1' else
               held;
  busy      <= held or to_std_logic(state /= first_state or rest /= nothing);

  main : process (clk) is

    variable digit   : std_logic_vector(3 downto 0);
    variable second  : std_logic_vector(7 downto 0);
    variable command : std_logic_vector(3 downto 0);
    variable found   : boolean;
    variable is_end  : boolean;

    procedure give (data : std_logic_vector(7 downto 0)) is
    begin

      held_data <= data;
      held      <= '1';

    end procedure give;

    -- Output a byte of a compact frame, with an escape before it if necessary; `behind` is the next step after an
    -- escape.

    procedure stuff (data : std_logic_vector(7 downto 0); behind : rest_t; otherwise : rest_t) is
    begin

      give(data);
      rest <= otherwise;
      if is_reserved(data) then
        give(compact_escape);
        rest <= behind;
      end if;

    end procedure stuff;

    -- Return the next step after the node number or the start byte.
    impure function behind_start return rest_t is
    begin

      if is_whole = '1' then
        return of_byte;
      else
        return nothing;
      end if;

    end function behind_start;

  begin

    if rising_edge(clk) then
      digit  := hex_value(in_data);
      is_end := in_data = lf or in_data = cr;

      if passes = '1' then
        if in_valid = '1' and out_ready = '1' then
          state <= in_text;
          if is_end then
            state <= first_state;
          end if;
        end if;
      elsif advance = '1' then
        held      <= '0';
        held_mark <= flush_none;

        case rest is

          when of_node =>
            stuff(number, of_node_escaped, behind_start);

          when of_node_escaped =>
            give(number xor compact_stuffed);
            rest <= behind_start;

          when of_byte =>
            stuff(value, escaped, nothing);

          when escaped =>
            give(value xor compact_stuffed);
            rest <= nothing;

          when of_z =>
            give(character_z);
            rest <= of_digit_high;

          when of_digit_high =>
            give(hex_character(number(7 downto 4)));
            rest <= of_digit_low;

          when of_digit_low =>
            give(hex_character(number(3 downto 0)));
            rest <= of_first;

          when of_first =>
            give(first);
            rest <= nothing;
            if is_whole = '1' then
              rest <= of_second;
            end if;

          when of_second =>
            give(value);
            rest <= nothing;

          when of_line_end =>
            give(lf);
            held_mark <= mark;
            rest      <= nothing;

          when nothing =>
            if in_valid = '1' then

              case state is

                when at_prefix =>
                  taken <= taken + 1;
                  if compact = '0' or is_end then
                    give(in_data);
                    held_mark <= in_mark;
                    taken     <= (others => '0');
                    if not is_end then
                      state <= in_text;
                    end if;
                  elsif taken = 2 then
                    taken <= (others => '0');
                    state <= at_letter;
                  end if;

                when at_letter =>
                  first    <= in_data;
                  is_whole <= '0';
                  if is_end then
                    give(in_data);
                    held_mark <= in_mark;
                  elsif (compact or to_std_logic(node >= 0)) = '1' and (in_data(5) = '1' or in_data = x"50") then
                    state <= at_second;
                  else
                    state <= in_text;
                    rest  <= first_of_text;
                  end if;

                when at_second =>
                  second := x"00";
                  if in_data(6 downto 5) = "11" then
                    second := in_data;
                  end if;
                  command := number_of(first, second);
                  found   := first /= x"67" or second /= x"73";

                  state    <= at_high;
                  is_whole <= '1';
                  nibble   <= command;
                  value    <= command & digit;
                  if not found then
                    state <= in_text;
                    rest  <= first_of_text;
                    value <= in_data;
                  else
                    give(compact_start);
                    rest <= of_byte;
                    if filled(to_integer(unsigned(command))) = '1' then
                      value(3 downto 0) <= x"0";
                      if second = x"00" then
                        nibble <= digit;
                        state  <= at_low;
                      end if;
                    elsif second /= x"00" then
                      is_whole <= '0';
                      rest     <= nothing;
                      state    <= at_low;
                    end if;
                    if node >= 0 then
                      rest <= of_node;
                    end if;
                  end if;

                when at_high =>
                  nibble <= digit;
                  state  <= at_low;
                  if is_end then
                    give(compact_end);
                    state <= first_state;
                    if node >= 0 then
                      mark <= in_mark;
                      rest <= of_line_end;
                    else
                      held_mark <= in_mark;
                    end if;
                  end if;

                when at_low =>
                  value <= nibble & digit;
                  stuff(nibble & digit, escaped, nothing);
                  state <= at_high;

                when in_text =>
                  give(in_data);
                  held_mark <= in_mark;
                  if is_end then
                    state <= first_state;
                  end if;

              end case;

            end if;

        end case;

      end if;

      if rst = '1' then
        state     <= first_state;
        rest      <= nothing;
        taken     <= (others => '0');
        first     <= (others => '0');
        value     <= (others => '0');
        is_whole  <= '0';
        nibble    <= (others => '0');
        held      <= '0';
        held_data <= (others => '0');
        held_mark <= flush_none;
        mark      <= flush_none;
      end if;
    end if;

  end process main;

end architecture rtl;
