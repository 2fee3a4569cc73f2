-- SPDX-License-Identifier: BSD-3-Clause
--
-- Writes the bodies of all frames that the gateway sends, answers and samples, one character per cycle.
--
-- A body has these parts in order: letters, the head (ID or address), the pair (a number of two digits), the words or
-- the tail; the executor supplies the digits of the tail while they are sent. A sample has only a letter and words,
-- because its number, sequence number and timestamp precede its words in the sample ring, in the order in which they
-- are sent. If both are waiting, answers and samples take turns. Only a sample of an epoch other than the present one
-- always goes first, because the waiting answer belongs to the request that ended that epoch.
--
-- The first word of a sample in the ring has, from the highest bit: group (8 bits), sequence number (8), number of
-- words of the sample in the ring including this one (9), and one bit each for: timestamp follows, plain frame, send
-- immediately, epoch. The words of both rings are aligned to the highest bit; their digits are read there.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_frame_writer is
  generic (
    data_bits    : positive := 32;
    address_bits : positive := 8;
    id_digits    : positive := 3;
    -- Content of the answer to `Q`: 64 digits.
    q_fields : std_logic_vector(255 downto 0) := (others => '0')
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- Answer; its fields are stable until answer_taken is '1'.
    answer_valid       : in    std_logic;
    answer_taken       : out   std_logic;
    answer_message     : in    message_t;
    answer_lower       : in    std_logic;
    answer_plain       : in    std_logic;
    answer_mark        : in    flush_mark_t;
    answer_has_id      : in    std_logic;
    answer_has_address : in    std_logic;
    answer_has_pair    : in    std_logic;
    answer_id          : in    std_logic_vector(4 * id_digits - 1 downto 0);
    answer_address     : in    std_logic_vector(4 * digits_of(address_bits) - 1 downto 0);
    answer_pair        : in    std_logic_vector(7 downto 0);
    answer_words       : in    std_logic_vector(7 downto 0);
    -- tail: the answer accepted last ends in a tail with tail_more digits after the first one. The other signals are as
    -- in `ul_request_executor`.
    tail       : in    std_logic;
    tail_more  : in    unsigned(2 downto 0);
    tail_digit : in    std_logic_vector(3 downto 0);
    tail_left  : out   unsigned(2 downto 0);
    tail_taken : out   std_logic;
    -- Words of answers.
    response_word : in    std_logic_vector(data_bits - 1 downto 0);
    response_pop  : out   std_logic;
    -- Samples.
    sample_available : in    std_logic;
    sample_word      : in    std_logic_vector(maximum(4 * digits_of(data_bits), 32) - 1 downto 0);
    sample_pop       : out   std_logic;
    -- Epoch in which samples are taken at present.
    epoch : in    std_logic;
    -- Bodies, to the datalink layer.
    out_data  : out   std_logic_vector(7 downto 0);
    out_valid : out   std_logic;
    out_ready : in    std_logic;
    out_last  : out   std_logic;
    out_plain : out   std_logic;
    out_mark  : out   flush_mark_t;
    busy      : out   std_logic
  );
end entity ul_frame_writer;

architecture rtl of ul_frame_writer is

  constant address_digits : positive := digits_of(address_bits);
  constant data_digits    : positive := digits_of(data_bits);
  constant head_bits      : positive := 4 * maximum(id_digits, address_digits);
  constant word_bits      : positive := maximum(4 * data_digits, 32);
  constant stamp_digits   : positive := 8;
  constant top_digits     : positive := 4;
  constant config_digits  : positive := 64;

  type state_t is (
    state_idle, state_letter, state_second_letter, state_head, state_pair, state_words, state_tail, state_configuration
  );

  type registers_t is record
    state     : state_t;
    message   : message_t;
    lower     : std_logic;
    has_head  : std_logic;
    has_pair  : std_logic;
    head      : std_logic_vector(head_bits - 1 downto 0);
    head_left : unsigned(3 downto 0);
    pair      : std_logic_vector(7 downto 0);
    -- words: number of words left, with the one being sent. left: number of digits left of the present word or field,
    -- without the one being sent.
    words       : unsigned(8 downto 0);
    word        : std_logic_vector(word_bits - 1 downto 0);
    left        : unsigned(5 downto 0);
    from_sample : std_logic;
    -- The next word is a timestamp.
    stamp_next : std_logic;
    out_data   : std_logic_vector(7 downto 0);
    out_valid  : std_logic;
    out_last   : std_logic;
    out_plain  : std_logic;
    out_mark   : flush_mark_t;
  end record registers_t;

  signal r            : registers_t;
  signal advance      : std_logic;
  signal sample_first : std_logic;
  signal take_answer  : std_logic;
  signal take_sample  : std_logic;
  signal load_word    : std_logic;
  signal sample_kept  : std_logic_vector(word_bits - 1 downto 0);
  signal top          : std_logic_vector(31 downto 0);

  -- Letters of each message as the five low bits of their codes; the second is 0 if there is only one.
  subtype letter_t is std_logic_vector(4 downto 0);

  type digits_t is array (0 to config_digits - 1) of std_logic_vector(3 downto 0);

  -- A table of digits, because not every tool supports a slice with two variable bounds.
  function digits (fields : std_logic_vector(255 downto 0)) return digits_t is

    variable result : digits_t;

  begin

    for index in digits_t'range loop

      result(index) := fields(4 * index + 3 downto 4 * index);

    end loop;

    return result;

  end function digits;

  constant config_table : digits_t := digits(q_fields);

  function letter (code : character) return letter_t is
  begin

    return std_logic_vector(to_unsigned(character'pos(code) mod 32, 5));

  end function letter;

  function first_letter (message : message_t) return letter_t is
  begin

    if message(4) = '1' then

      case message is

        when message_error =>
          return letter('X');

        when message_out_of_sequence =>
          return letter('N');

        when others =>
          return letter('P');

      end case;

    end if;

    case message(3 downto 0) is

      when command_r | command_rm | command_rq =>
        return letter('R');

      when command_w | command_wm | command_wq | command_ws | command_wk =>
        return letter('W');

      when command_i =>
        return letter('I');

      when command_h =>
        return letter('H');

      when command_q =>
        return letter('Q');

      when command_k =>
        return letter('K');

      when others =>
        return letter('G');

    end case;

  end function first_letter;

  function second_letter (message : message_t) return letter_t is
  begin

    if message(4) = '1' then
      return "00000";
    end if;

    case message(3 downto 0) is

      when command_rm | command_wm =>
        return letter('M');

      when command_rq | command_wq =>
        return letter('Q');

      when command_wk =>
        return letter('K');

      when command_gs =>
        return letter('S');

      when command_gn =>
        return letter('N');

      when command_gx =>
        return letter('X');

      when command_gp =>
        return letter('P');

      when others =>
        return "00000";

    end case;

  end function second_letter;

  -- A response word, aligned to the highest bit.
  function from_response (word : std_logic_vector(data_bits - 1 downto 0)) return std_logic_vector is

    variable aligned : std_logic_vector(word_bits - 1 downto 0) := (others => '0');

  begin

    aligned(word_bits - 4 * data_digits + data_bits - 1 downto word_bits - 4 * data_digits) := word;
    return aligned;

  end function from_response;

  function aligned_head (value : std_logic_vector) return std_logic_vector is

    variable aligned : std_logic_vector(head_bits - 1 downto 0) := (others => '0');

  begin

    aligned(head_bits - 1 downto head_bits - value'length) := value;
    return aligned;

  end function aligned_head;

begin

  advance <= not r.out_valid or out_ready;
  -- Alternate: an answer after a sample, a sample after an answer.
  sample_first <= sample_available and (not r.from_sample or (top(3) xor epoch));
  take_answer  <= to_std_logic(r.state = state_idle) and advance and answer_valid and not sample_first;
  take_sample  <= to_std_logic(r.state = state_idle) and advance and sample_available and
                  (sample_first or not answer_valid);
  top          <= sample_kept(word_bits - 1 downto word_bits - 32);

  answer_taken <= take_answer;
  response_pop <= load_word and not r.from_sample;
  tail_left    <= r.left(2 downto 0);
  tail_taken   <= advance and to_std_logic(r.state = state_tail);
  sample_pop   <= take_sample or (load_word and r.from_sample);
  out_data     <= r.out_data;
  out_valid    <= r.out_valid;
  out_last     <= r.out_last;
  out_plain    <= r.out_plain;
  out_mark     <= r.out_mark;
  busy         <= r.out_valid or to_std_logic(r.state /= state_idle);

  -- After this digit, load the next word from its ring.
  load_word <= advance and (
                            (to_std_logic(r.state = state_words and r.left = 0 and r.words /= 1)) or
                            (to_std_logic(r.state = state_head and r.left = 0 and r.has_pair = '0' and r.words /= 0)) or
                            (to_std_logic(r.state = state_pair and r.left = 0 and r.words /= 0)));

  -- A register after the ring's memory, which has a long clock-to-output delay. Words of two digits are too short to
  -- allow the extra cycle.

  short_words : if data_digits <= 2 generate

    sample_kept <= sample_word;

  end generate short_words;

  long_words : if data_digits > 2 generate

    keep : process (clk) is
    begin

      if rising_edge(clk) then
        sample_kept <= sample_word;
      end if;

    end process keep;

  end generate long_words;

  main : process (clk) is

    variable v : registers_t;

    procedure put (code : std_logic_vector(7 downto 0)) is
    begin

      v.out_data  := code;
      v.out_valid := '1';

    end procedure put;

    procedure finish_frame is
    begin

      v.out_last := '1';
      v.state    := state_idle;

    end procedure finish_frame;

    procedure begin_words is
    begin

      v.left  := to_unsigned(data_digits - 1, v.left'length);
      v.state := state_words;
      if tail = '1' then
        v.left  := resize(tail_more, v.left'length);
        v.state := state_tail;
      elsif r.words = 0 then
        finish_frame;
      end if;

    end procedure begin_words;

    procedure begin_pair is
    begin

      v.left  := to_unsigned(1, v.left'length);
      v.state := state_pair;
      if r.has_pair = '0' then
        begin_words;
      end if;

    end procedure begin_pair;

    procedure begin_fields is
    begin

      if r.message = message_publish then
        v.left  := to_unsigned(top_digits - 1, v.left'length);
        v.state := state_words;
      elsif r.message = '0' & command_q then
        v.left  := to_unsigned(config_digits - 1, v.left'length);
        v.state := state_configuration;
      elsif r.has_head = '1' then
        v.left  := resize(r.head_left, v.left'length);
        v.state := state_head;
      else
        begin_pair;
      end if;

    end procedure begin_fields;

    procedure put_letter (code : letter_t) is
    begin

      put("01" & r.lower & code);

    end procedure put_letter;

    procedure put_digit is

      variable nibble : std_logic_vector(3 downto 0);

    begin

      case r.state is

        when state_head =>
          nibble := r.head(head_bits - 1 downto head_bits - 4);

        when state_pair =>
          nibble := r.pair(7 downto 4);

        when state_tail =>
          nibble := tail_digit;

        when state_configuration =>
          nibble := config_table(to_integer(r.left));

        when others =>
          nibble := r.word(word_bits - 1 downto word_bits - 4);

      end case;

      put(hex_character(nibble));
      if r.state = state_head then
        v.head := r.head(head_bits - 5 downto 0) & "0000";
      end if;
      if r.state = state_pair then
        v.pair := r.pair(3 downto 0) & "0000";
      end if;
      v.word := r.word(word_bits - 5 downto 0) & "0000";
      v.left := r.left - 1;

    end procedure put_digit;

    procedure finish_word is
    begin

      v.words      := r.words - 1;
      v.left       := to_unsigned(data_digits - 1, v.left'length);
      v.stamp_next := '0';
      if r.stamp_next = '1' then
        v.left := to_unsigned(stamp_digits - 1, v.left'length);
      end if;
      if r.words = 1 then
        finish_frame;
      end if;

    end procedure finish_word;

    procedure begin_answer is
    begin

      v.state     := state_letter;
      v.message   := answer_message;
      v.lower     := answer_lower;
      v.has_head  := answer_has_id or answer_has_address;
      v.has_pair  := answer_has_pair;
      v.head      := aligned_head(answer_address);
      v.head_left := to_unsigned(address_digits - 1, v.head_left'length);
      if answer_has_id = '1' then
        v.head      := aligned_head(answer_id);
        v.head_left := to_unsigned(id_digits - 1, v.head_left'length);
      end if;
      v.pair        := answer_pair;
      v.words       := resize(unsigned(answer_words), v.words'length);
      v.from_sample := '0';
      v.stamp_next  := '0';
      v.out_plain   := answer_plain;
      v.out_mark    := answer_mark;

    end procedure begin_answer;

    procedure begin_sample is
    begin

      v.state       := state_letter;
      v.message     := message_publish;
      v.lower       := '0';
      v.word        := sample_kept;
      v.words       := unsigned(top(15 downto 7));
      v.stamp_next  := top(6);
      v.from_sample := '1';
      v.out_plain   := top(5);
      v.out_mark    := flush_none;
      if top(4) = '1' then
        v.out_mark := flush_now;
      end if;

    end procedure begin_sample;

  begin

    if rising_edge(clk) then
      v := r;
      if advance = '1' then
        v.out_valid := '0';
        v.out_last  := '0';

        case r.state is

          when state_idle =>
            if take_answer = '1' then
              begin_answer;
            elsif take_sample = '1' then
              begin_sample;
            end if;

          when state_letter =>
            put_letter(first_letter(r.message));
            if second_letter(r.message) /= "00000" then
              v.state := state_second_letter;
            else
              begin_fields;
            end if;

          when state_second_letter =>
            put_letter(second_letter(r.message));
            begin_fields;

          when state_head =>
            put_digit;
            if r.left = 0 then
              begin_pair;
            end if;

          when state_pair =>
            put_digit;
            if r.left = 0 then
              begin_words;
            end if;

          when state_words =>
            put_digit;
            if r.left = 0 then
              finish_word;
            end if;

          when state_tail | state_configuration =>
            put_digit;
            if r.left = 0 then
              finish_frame;
            end if;

        end case;

        if load_word = '1' then
          v.word := from_response(response_word);
          if r.from_sample = '1' then
            v.word := sample_kept;
          end if;
        end if;
      end if;
      r <= v;

      if rst = '1' then
        r <=
        (
          state       => state_idle,
          message     => (others => '0'),
          head        => (others => '0'),
          head_left   => (others => '0'),
          pair        => (others => '0'),
          words       => (others => '0'),
          word        => (others => '0'),
          left        => (others => '0'),
          out_data    => (others => '0'),
          out_mark    => flush_none,
          lower       => '0',
          has_head    => '0',
          has_pair    => '0',
          from_sample => '0',
          stamp_next  => '0',
          out_valid   => '0',
          out_last    => '0',
          out_plain   => '0'
        );
      end if;
    end if;

  end process main;

end architecture rtl;
