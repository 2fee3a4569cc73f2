-- SPDX-License-Identifier: BSD-3-Clause
--
-- Converts frames in compact form to text, and passes text through (docs/protocol.md, "The compact form"). The text of
-- a frame that was cut off ends with the byte compact_end, which is not a hex digit, so `ul_datalink_rx` reports a CRC
-- error.
--
-- One character per cycle leaves; in_ready is '0' while the second character of a byte is output.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_compact_pkg.all;
  use work.unity_link_pkg.all;

entity ul_compact_rx is
  generic (
    -- Number of digits of an ID and of an address.
    id_digits      : positive := 3;
    address_digits : natural  := 2;
    -- Node number on a shared medium, 0 to 254; -1 if the medium is not shared.
    node : integer := -1
  );
  port (
    clk     : in    std_logic;
    rst     : in    std_logic;
    in_data : in    std_logic_vector(7 downto 0);
    -- '1' if bytes before this one were lost.
    in_lost   : in    std_logic;
    in_valid  : in    std_logic;
    in_ready  : out   std_logic;
    out_data  : out   std_logic_vector(7 downto 0);
    out_lost  : out   std_logic;
    out_valid : out   std_logic;
    out_ready : in    std_logic
  );
end entity ul_compact_rx;

architecture rtl of ul_compact_rx is

  constant filled : std_logic_vector(0 to 15) := filled_requests(id_digits, address_digits);

  constant lf : std_logic_vector(7 downto 0) := x"0A";
  constant cr : std_logic_vector(7 downto 0) := x"0D";

  -- Characters still to output for the last byte: the second letter; two digits; one digit; a line end.

  type rest_t is (nothing, letter, high, low, line_end);

  -- Kind of the next byte of a frame.

  type place_t is (at_node, at_command, at_digits);

  function first_place return place_t is
  begin

    if node >= 0 then
      return at_node;
    else
      return at_command;
    end if;

  end function first_place;

  signal rest    : rest_t;
  signal place   : place_t;
  signal value   : std_logic_vector(7 downto 0);
  signal framed  : std_logic;
  signal escaped : std_logic;
  -- Characters of a text line have arrived, but not its line end.
  signal in_line : std_logic;
  signal lost    : std_logic;
  signal held    : std_logic;
  signal advance : std_logic;

begin

  advance   <= out_ready or not held;
  in_ready  <= advance when rest = nothing else
               '0';
  out_valid <= held;

  main : process (clk) is

    variable content : std_logic_vector(7 downto 0);
    variable command : natural range 0 to 15;
    variable is_end  : boolean;

    procedure give (data : std_logic_vector(7 downto 0)) is
    begin

      out_data <= data;
      held     <= '1';

    end procedure give;

    procedure cut is
    begin

      give(compact_end);
      rest <= line_end;

    end procedure cut;

  begin

    if rising_edge(clk) then
      command := to_integer(unsigned(value(7 downto 4)));

      if advance = '1' then
        held     <= '0';
        out_lost <= '0';

        case rest is

          when letter =>
            give(compact_letter(command, true));
            rest <= low;
            if filled(command) = '1' then
              rest <= nothing;
            end if;

          when high =>
            give(hex_character(value(7 downto 4)));
            rest <= low;

          when low =>
            give(hex_character(value(3 downto 0)));
            rest <= nothing;

          when line_end =>
            give(lf);
            rest <= nothing;

          when nothing =>
            if in_valid = '1' then
              content := in_data;
              if escaped = '1' then
                content := in_data xor compact_stuffed;
              end if;
              command  := to_integer(unsigned(content(7 downto 4)));
              is_end   := in_data = lf or in_data = cr;
              value    <= content;
              escaped  <= '0';
              lost     <= '0';
              out_lost <= lost or in_lost;
              if in_data = compact_start then
                if (framed or in_line) = '1' then
                  cut;
                else
                  lost <= lost or in_lost;
                end if;
                framed  <= '1';
                in_line <= '0';
                place   <= first_place;
              elsif framed = '0' then
                give(in_data);
                in_line <= to_std_logic(not is_end);
                if in_data = compact_end then
                  in_line <= '0';
                  cut;
                end if;
              elsif is_end or (in_data = compact_end and escaped = '1') then
                cut;
                framed <= '0';
              elsif in_data = compact_end then
                give(lf);
                framed <= '0';
              elsif in_data = compact_escape and escaped = '0' then
                escaped <= '1';
                lost    <= lost or in_lost;
              else

                case place is

                  when at_node =>
                    give(character_z);
                    rest  <= high;
                    place <= at_command;

                  when at_command =>
                    give(compact_letter(command, false));
                    place <= at_digits;
                    if compact_letter(command, true) /= x"20" then
                      rest <= letter;
                    elsif filled(command) = '0' then
                      rest <= low;
                    end if;

                  when at_digits =>
                    give(hex_character(content(7 downto 4)));
                    rest <= low;

                end case;

              end if;
            end if;

        end case;

      end if;

      if rst = '1' then
        rest     <= nothing;
        place    <= first_place;
        value    <= (others => '0');
        framed   <= '0';
        escaped  <= '0';
        in_line  <= '0';
        lost     <= '0';
        held     <= '0';
        out_data <= (others => '0');
        out_lost <= '0';
      end if;
    end if;

  end process main;

end architecture rtl;
