-- SPDX-License-Identifier: BSD-3-Clause
--
-- Application layer, first half: decodes requests. Parses the body of a frame, one character per cycle, and checks its
-- command and form.
--
-- The command is found by a walk through a tree of the letters of all commands; the fields after it follow the table of
-- `next_field`. Words (and the addresses of GS) are written to the request memory as soon as each is complete, all
-- other fields to registers. At the end of the frame the request is valid, together with the result of the checks:
-- `request_error` if the frame is damaged or malformed, `request_out_of_range` if a value does not exist in this
-- gateway.
--
-- The executor does not copy the fields: `hold` keeps them stable until the answer has begun. During `hold`, the
-- decoder already accepts the command letters and the ID of the next request, which take as long as a short request
-- takes to execute.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_request_decoder is
  generic (
    data_bits      : positive := 32;
    address_bits   : positive := 8;
    id_digits      : positive := 3;
    crc_bits       : positive := 16;
    block_words    : positive := 255;
    groups         : natural  := 16;
    group_words    : natural  := 32;
    masked_write   : boolean  := true;
    queue_commands : boolean  := true;
    compact        : boolean  := false;
    timestamps     : boolean  := true;
    triggers       : boolean  := true;
    send_immediate : boolean  := true;
    half_duplex    : boolean  := false
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- Characters and frame ends from the datalink layer.
    in_data   : in    std_logic_vector(7 downto 0);
    in_valid  : in    std_logic;
    in_ready  : out   std_logic;
    in_last   : in    std_logic;
    in_plain  : in    std_logic;
    in_error  : in    error_t;
    in_silent : in    std_logic;
    -- Valid with in_last: the CRC residue of the frame.
    in_residue : in    std_logic_vector(crc_bits - 1 downto 0);
    -- in_session: a session exists. for_program: a checked frame began it.
    in_session  : in    std_logic;
    for_program : in    std_logic;
    -- A request. request_valid is '1' until request_accept is '1' for one cycle; the fields are then stable while
    -- `hold` is '1'.
    request_valid  : out   std_logic;
    request_accept : in    std_logic;
    hold           : in    std_logic;
    -- '1' together with hold: accept no character of the next frame, not even a letter.
    hold_letters         : in    std_logic;
    request_command      : out   command_t;
    request_has_id       : out   std_logic;
    request_plain        : out   std_logic;
    request_silent       : out   std_logic;
    request_error        : out   error_t;
    request_out_of_range : out   std_logic;
    request_id           : out   std_logic_vector(4 * id_digits - 1 downto 0);
    request_address      : out   std_logic_vector(4 * digits_of(address_bits) - 1 downto 0);
    -- request_count: number of words to read or write, or of addresses of GS. request_group: group of GS, GN, GX and GP,
    -- or mode of I. request_flags: flags of GS.
    request_count : out   std_logic_vector(7 downto 0);
    request_group : out   std_logic_vector(7 downto 0);
    request_flags : out   std_logic_vector(5 downto 0);
    -- '1' for a K without fields.
    request_asks : out   std_logic;
    -- The divisor of GS, the session of K, or, for a request with an ID outside of a session, its CRC residue.
    -- number_shift, used during hold, shifts it left by one digit; the highest digit of a session enters again at the
    -- lowest place.
    request_number : out   std_logic_vector(number_bits_of(crc_bits, groups) - 1 downto 0);
    number_shift   : in    std_logic;
    -- The last word of the request.
    request_word : out   std_logic_vector(data_bits - 1 downto 0);
    -- Write port of the request memory.
    store       : out   std_logic;
    store_index : out   std_logic_vector(7 downto 0);
    store_word  : out   std_logic_vector(maximum(data_bits, address_bits) - 1 downto 0);
    -- A frame has begun that was not accepted as a request yet.
    busy : out   std_logic
  );
end entity ul_request_decoder;

architecture rtl of ul_request_decoder is

  constant address_digits : positive := digits_of(address_bits);
  constant data_digits    : positive := digits_of(data_bits);
  constant word_digits    : positive := maximum(address_digits, data_digits);
  constant session_digits : positive := session_digits_of(crc_bits);
  constant number_bits    : positive := number_bits_of(crc_bits, groups);

  -- '0' and a command, or one of the nodes below.
  subtype node_t is std_logic_vector(4 downto 0);

  constant node_r       : node_t := '0' & command_r;
  constant node_w       : node_t := '0' & command_w;
  constant node_start   : node_t := "10000";
  constant node_g       : node_t := "10001";
  constant node_unknown : node_t := "11111";

  type field_t is (
    field_command, field_id, field_address, field_count, field_words,
    field_group, field_flags, field_divisor, field_list_count, field_list, field_session, field_none
  );

  function offered (is_built_in : boolean; command : command_t) return node_t is
  begin

    if is_built_in then
      return '0' & command;
    end if;
    return node_unknown;

  end function offered;

  -- Compared with one more bit, because the number 256 of groups does not fit into eight bits (GHDL converts such a
  -- comparison wrongly).
  function is_no_group (number : std_logic_vector(7 downto 0)) return boolean is
  begin

    return resize(unsigned(number), 9) >= groups;

  end function is_no_group;

  -- The tree of commands. `letter` has the five low bits of a letter's code, which are equal for both cases.
  function next_node (node : node_t; letter : std_logic_vector(4 downto 0)) return node_t is

    subtype letter_t is std_logic_vector(4 downto 0);

    constant letter_g : letter_t := "00111";
    constant letter_h : letter_t := "01000";
    constant letter_i : letter_t := "01001";
    constant letter_k : letter_t := "01011";
    constant letter_m : letter_t := "01101";
    constant letter_n : letter_t := "01110";
    constant letter_p : letter_t := "10000";
    constant letter_q : letter_t := "10001";
    constant letter_r : letter_t := "10010";
    constant letter_s : letter_t := "10011";
    constant letter_w : letter_t := "10111";
    constant letter_x : letter_t := "11000";

  begin

    case node is

      when node_start =>

        case letter is

          when letter_r =>
            return node_r;

          when letter_w =>
            return node_w;

          when letter_h =>
            return '0' & command_h;

          when letter_q =>
            return '0' & command_q;

          when letter_k =>
            return '0' & command_k;

          when letter_i =>
            return offered(send_immediate, command_i);

          when letter_g =>
            if groups > 0 then
              return node_g;
            end if;

          when others =>
            null;

        end case;

      when node_r =>

        case letter is

          when letter_m =>
            return '0' & command_rm;

          when letter_q =>
            return offered(queue_commands, command_rq);

          when others =>
            null;

        end case;

      when node_w =>

        case letter is

          when letter_m =>
            return '0' & command_wm;

          when letter_s =>
            return '0' & command_ws;

          when letter_q =>
            return offered(queue_commands, command_wq);

          when letter_k =>
            return offered(masked_write, command_wk);

          when others =>
            null;

        end case;

      when node_g =>

        case letter is

          when letter_s =>
            return '0' & command_gs;

          when letter_n =>
            return '0' & command_gn;

          when letter_x =>
            return '0' & command_gx;

          when letter_p =>
            return '0' & command_gp;

          when others =>
            null;

        end case;

      when others =>
        null;

    end case;

    return node_unknown;

  end function next_node;

  -- The field after the command letters and the ID.
  function field_behind_id (command : command_t) return field_t is
  begin

    if command(3) = '0' then
      return field_address;
    elsif command(2) = '0' or command = command_i then
      return field_group;
    else
      return field_none;
    end if;

  end function field_behind_id;

  function first_field (command : command_t; has_id : std_logic) return field_t is
  begin

    if has_id = '1' or command = command_k then
      return field_id;
    end if;
    return field_behind_id(command);

  end function first_field;

  function next_field (field : field_t; command : command_t) return field_t is
  begin

    case field is

      when field_id =>
        if command = command_k then
          return field_session;
        end if;
        return field_behind_id(command);

      when field_address =>
        if command = command_rm or command = command_rq then
          return field_count;
        elsif command = command_r then
          return field_none;
        end if;
        return field_words;

      when field_words =>
        return field_words;

      when field_group =>
        if command = command_gs then
          return field_flags;
        end if;
        return field_none;

      when field_flags =>
        return field_divisor;

      when field_divisor =>
        return field_list_count;

      when field_list_count | field_list =>
        return field_list;

      when others =>
        return field_none;

    end case;

  end function next_field;

  -- Number of digits of a field after its first digit.
  function further_digits (field : field_t) return unsigned is
  begin

    case field is

      when field_id =>
        return to_unsigned(id_digits - 1, 4);

      when field_address | field_list =>
        return to_unsigned(address_digits - 1, 4);

      when field_words =>
        return to_unsigned(data_digits - 1, 4);

      when field_divisor =>
        return to_unsigned(3, 4);

      when field_session =>
        return to_unsigned(session_digits - 1, 4);

      when others =>
        return to_unsigned(1, 4);

    end case;

  end function further_digits;

  -- Whether a value in whole digits has a bit set that this gateway's width does not have.
  function exceeds (value : std_logic_vector; bits : positive) return std_logic is

    variable excess : std_logic := '0';

  begin

    for place in value'range loop

      if place >= bits then
        excess := excess or value(place);
      end if;

    end loop;

    return excess;

  end function exceeds;

  -- Group flags that this gateway does not support.
  function missing_flags return std_logic_vector is

    variable missing : std_logic_vector(7 downto 0) := "11000000";

  begin

    missing(flag_periodic)  := to_std_logic(half_duplex);
    missing(flag_trigger)   := to_std_logic(half_duplex or not triggers);
    missing(flag_immediate) := to_std_logic(not send_immediate);
    missing(flag_timestamp) := to_std_logic(not timestamps);
    return missing;

  end function missing_flags;

  type registers_t is record
    node         : node_t;
    has_id       : std_logic;
    lower_seen   : std_logic;
    upper_seen   : std_logic;
    field        : field_t;
    left         : unsigned(3 downto 0);
    bad          : std_logic;
    id           : std_logic_vector(4 * id_digits - 1 downto 0);
    address      : std_logic_vector(4 * address_digits - 1 downto 0);
    count        : std_logic_vector(7 downto 0);
    group_number : std_logic_vector(7 downto 0);
    flags        : std_logic_vector(7 downto 0);
    number       : std_logic_vector(number_bits - 1 downto 0);
    -- At least one digit of the divisor or session is not 0.
    some_number : std_logic;
    word        : std_logic_vector(4 * word_digits - 1 downto 0);
    -- Number of whole words; 256 means more than a count field can express.
    words         : unsigned(8 downto 0);
    partial       : std_logic;
    word_exceeds  : std_logic;
    store         : std_logic;
    store_index   : unsigned(7 downto 0);
    flushed       : std_logic;
    valid         : std_logic;
    plain         : std_logic;
    silent        : std_logic;
    error         : error_t;
    out_of_range  : std_logic;
    request_count : std_logic_vector(7 downto 0);
  end record registers_t;

  signal r            : registers_t;
  signal take         : std_logic;
  signal letter       : std_logic;
  signal digit        : std_logic;
  signal field        : field_t;
  signal left         : unsigned(3 downto 0);
  signal touches_held : std_logic;
  signal word_excess  : std_logic;

begin

  -- A character can be a command letter only before the first digit of a field.
  letter <= to_std_logic(r.field = field_command) and in_data(6) and not in_data(7) and
            to_std_logic(unsigned(in_data(4 downto 0)) >= 7 and unsigned(in_data(4 downto 0)) <= 26);
  digit  <= is_hex(in_data);

  -- The field to which the present digit belongs; for the first digit, the command determines it.
  field        <= first_field(r.node(3 downto 0), r.has_id) when r.field = field_command else
                  r.field;
  left         <= further_digits(first_field(r.node(3 downto 0), r.has_id)) when r.field = field_command else
                  r.left;
  touches_held <= in_last or (not letter and to_std_logic(field /= field_id)) or hold_letters;

  take <= in_valid and not r.valid and not (hold and touches_held);
  -- A plain end after a part of a word takes two cycles: the word is completed first.
  in_ready <= not r.valid and not (hold and touches_held) and not (in_last and in_plain and not r.flushed);

  word_excess <= exceeds(r.word(4 * address_digits - 1 downto 0), address_bits) when r.field = field_list else
                 exceeds(r.word(4 * data_digits - 1 downto 0), data_bits);

  request_valid        <= r.valid;
  request_command      <= r.node(3 downto 0);
  request_has_id       <= r.has_id;
  request_plain        <= r.plain;
  request_silent       <= r.silent;
  request_error        <= r.error;
  request_out_of_range <= r.out_of_range;
  request_id           <= r.id;
  request_address      <= r.address;
  request_count        <= r.request_count;
  request_group        <= r.group_number;
  request_flags        <= r.flags(5 downto 0);
  request_asks         <= to_std_logic(r.field = field_command);
  request_number       <= r.number;
  request_word         <= r.word(data_bits - 1 downto 0);
  store                <= r.store;
  store_index          <= std_logic_vector(r.store_index);
  store_word           <= r.word(maximum(data_bits, address_bits) - 1 downto 0);
  busy                 <= r.valid or to_std_logic(r.node /= node_start or r.field /= field_command);

  main : process (clk) is

    variable v : registers_t;

    procedure begin_frame is
    begin

      v.node        := node_start;
      v.has_id      := '0';
      v.lower_seen  := '0';
      v.upper_seen  := '0';
      v.field       := field_command;
      v.bad         := '0';
      v.flushed     := '0';
      v.some_number := '0';

    end procedure begin_frame;

    procedure take_letter is
    begin

      v.node       := next_node(r.node, in_data(4 downto 0));
      v.has_id     := in_data(5);
      v.lower_seen := r.lower_seen or in_data(5);
      v.upper_seen := r.upper_seen or not in_data(5);

    end procedure take_letter;

    procedure complete_word is
    begin

      v.store       := '1';
      v.store_index := r.words(7 downto 0);
      v.partial     := '0';
      if r.words(8) = '0' then
        v.words := r.words + 1;
      end if;

    end procedure complete_word;

    procedure take_digit is

      variable nibble : std_logic_vector(3 downto 0);

    begin

      nibble := hex_value(in_data);

      case field is

        when field_id =>
          v.id := r.id(r.id'high - 4 downto 0) & nibble;

        when field_address =>
          v.address := r.address(r.address'high - 4 downto 0) & nibble;

        when field_count | field_list_count =>
          v.count := r.count(3 downto 0) & nibble;

        when field_group =>
          v.group_number := r.group_number(3 downto 0) & nibble;

        when field_flags =>
          v.flags := r.flags(3 downto 0) & nibble;

        when field_divisor | field_session =>
          v.number      := r.number(r.number'high - 4 downto 0) & nibble;
          v.some_number := r.some_number or to_std_logic(unsigned(nibble) /= 0);

        when field_words | field_list =>
          v.word := r.word(r.word'high - 4 downto 0) & nibble;
          if r.partial = '0' then
            v.word               := (others => '0');
            v.word(nibble'range) := nibble;
          end if;
          v.partial := '1';

        when others =>
          v.bad := '1';

      end case;

      if field = field_address or field = field_group then
        -- R and WK access one word and have no count field.
        v.count        := x"01";
        v.words        := (others => '0');
        v.partial      := '0';
        v.word_exceeds := '0';
      end if;

      v.field := field;
      v.left  := left - 1;
      if left = 0 then
        v.field := next_field(field, r.node(3 downto 0));
        v.left  := further_digits(v.field);
        if field = field_words or field = field_list then
          complete_word;
        end if;
      end if;

    end procedure take_digit;

    impure function is_well_formed return boolean is

      variable ended : field_t;

    begin

      ended := field;
      if r.bad = '1' then
        return false;
      end if;

      case ended is

        when field_none =>
          return true;

        when field_id =>
          return r.field = field_command and r.has_id = '0';

        when field_words =>
          if r.field = field_command or r.partial = '1' or r.words = 0 or r.words(8) = '1' then
            return false;
          elsif masked_write and r.node(3 downto 0) = command_wk then
            return r.words = 2;
          elsif r.node(3 downto 0) = command_w or r.node(3 downto 0) = command_ws then
            return r.words = 1;
          end if;
          return true;

        when field_list =>
          return groups > 0 and r.partial = '0' and r.words = unsigned(r.count);

        when others =>
          return false;

      end case;

    end function is_well_formed;

    impure function is_known return boolean is
    begin

      return r.node(4) = '0' and (r.lower_seen and r.upper_seen) = '0' and
             not (r.has_id = '1' and (r.node(3 downto 0) = command_q or r.node(3 downto 0) = command_k));

    end function is_known;

    impure function is_out_of_range return boolean is

      variable command : command_t;

    begin

      command := r.node(3 downto 0);

      if command(3) = '0' and exceeds(r.address, address_bits) = '1' then
        return true;
      end if;

      case command is

        when command_rm | command_rq =>
          return unsigned(r.count) = 0 or unsigned(r.count) > block_words;

        when command_w | command_wm | command_wq | command_ws | command_wk =>
          return (r.words > block_words and command /= command_wk) or v.word_exceeds = '1';

        when command_gs =>
          return is_no_group(r.group_number) or (r.flags and missing_flags) /= x"00" or r.some_number = '0'
                 or (r.flags(flag_plain) and for_program) = '1'
                 or unsigned(r.count) = 0 or unsigned(r.count) > group_words or v.word_exceeds = '1';

        when command_gn | command_gx | command_gp =>
          return is_no_group(r.group_number);

        when command_i =>
          return unsigned(r.group_number) > 2;

        when command_k =>
          return r.field /= field_command and
                 (unsigned(r.number(4 * session_digits - 2 downto 0)) = 0 or
                  (r.number(4 * session_digits - 1) = '1' and not compact));

        when others =>
          return false;

      end case;

    end function is_out_of_range;

    procedure take_end is
    begin

      v.valid         := '1';
      v.plain         := in_plain;
      v.silent        := in_silent;
      v.out_of_range  := to_std_logic(is_out_of_range);
      v.request_count := r.count;
      if r.node(2) = '1' then
        v.request_count := std_logic_vector(r.words(7 downto 0));
      end if;
      if r.has_id = '1' and in_session = '0' then
        v.number(crc_bits - 1 downto 0) := in_residue;
        if in_plain = '1' then
          v.number := (others => '0');
        end if;
      end if;

      if in_error /= error_none then
        v.error := in_error;
      elsif not is_known then
        v.error := error_command;
      elsif not is_well_formed then
        v.error := error_malformed;
      else
        v.error := error_none;
      end if;

    end procedure take_end;

  begin

    if rising_edge(clk) then
      v       := r;
      v.store := '0';
      if r.store = '1' then
        v.word_exceeds := r.word_exceeds or word_excess;
      end if;

      if take = '1' then
        if in_last = '0' then
          if letter = '1' then
            take_letter;
          elsif digit = '1' then
            take_digit;
          else
            v.field := field;
            v.left  := left;
            v.bad   := '1';
          end if;
        elsif in_plain = '1' and r.flushed = '0' then
          v.flushed := '1';
          if r.field = field_words and r.partial = '1' and r.words = 0 and r.lower_seen = '0' and
             (r.node(3 downto 0) = command_w or r.node(3 downto 0) = command_ws) then
            complete_word;
          end if;
        else
          take_end;
        end if;
      end if;

      if number_shift = '1' then
        v.number             := r.number(r.number'high - 4 downto 0) & "0000";
        v.number(3 downto 0) := r.number(4 * session_digits - 1 downto 4 * session_digits - 4);
      end if;

      if r.valid = '1' and request_accept = '1' then
        v.valid := '0';
        begin_frame;
      end if;
      r <= v;

      if rst = '1' then
        begin_frame;
        v.left          := (others => '0');
        v.id            := (others => '0');
        v.address       := (others => '0');
        v.count         := (others => '0');
        v.group_number  := (others => '0');
        v.flags         := (others => '0');
        v.number        := (others => '0');
        v.word          := (others => '0');
        v.words         := (others => '0');
        v.partial       := '0';
        v.word_exceeds  := '0';
        v.store         := '0';
        v.store_index   := (others => '0');
        v.valid         := '0';
        v.plain         := '0';
        v.silent        := '0';
        v.error         := error_none;
        v.out_of_range  := '0';
        v.request_count := (others => '0');
        r               <= v;
      end if;
    end if;

  end process main;

end architecture rtl;
