-- SPDX-License-Identifier: BSD-3-Clause
--
-- Application layer, second half: executes complete requests and starts their answers (docs/protocol.md, "Requests and
-- responses" and "Exactly once, in order").
--
-- It executes one request at a time, from `request_valid` until the frame writer begins the answer. The checks have the
-- order of the protocol: frame, command and form (results of the decoder), session, sequence, range, bus.
--
-- Words that are read go to the response ring before the answer begins, because after a later error the answer contains
-- only that error. The words of a block write, and the mask of WK, are in the request memory, whose read port follows
-- `memory_index` one cycle later; a single word comes directly from the decoder.
--
-- Each request about groups begins a new epoch, which the subscription manager records in each sample. The frame writer
-- sends all samples of the previous epoch before the answer, even if the answer is an error. A K discards the waiting
-- samples when its answer begins.
--
-- Two memories, which no reset clears, have the outcomes of requests with an ID, and the words that destructive reads
-- returned. For a repetition, a kept word is read again by an access that the bus master answers without the bus.
--
-- Some answers end in a field of their own, the tail: the number of a session or a CRC residue (from the decoder's
-- register), the current session, or the count of failed writes. The tail is read digit by digit while it is sent, and
-- no request executes meanwhile. A new session number is shifted into the session's register while the old one is sent,
-- and is complete with the last digit.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_request_executor is
  generic (
    data_bits      : positive := 32;
    address_bits   : positive := 8;
    id_digits      : positive := 3;
    crc_bits       : positive := 16;
    groups         : natural  := 16;
    masked_write   : boolean  := true;
    queue_commands : boolean  := true;
    send_immediate : boolean  := true;
    -- Bits of the word count of the response ring.
    room_bits : positive := 9
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- Request, from the decoder.
    request_valid        : in    std_logic;
    request_accept       : out   std_logic;
    hold                 : out   std_logic;
    hold_letters         : out   std_logic;
    request_command      : in    command_t;
    request_has_id       : in    std_logic;
    request_plain        : in    std_logic;
    request_silent       : in    std_logic;
    request_error        : in    error_t;
    request_out_of_range : in    std_logic;
    request_id           : in    std_logic_vector(4 * id_digits - 1 downto 0);
    request_address      : in    std_logic_vector(4 * digits_of(address_bits) - 1 downto 0);
    request_count        : in    std_logic_vector(7 downto 0);
    request_group        : in    std_logic_vector(7 downto 0);
    request_word         : in    std_logic_vector(data_bits - 1 downto 0);
    request_asks         : in    std_logic;
    request_number       : in    std_logic_vector(number_bits_of(crc_bits, groups) - 1 downto 0);
    number_shift         : out   std_logic;
    -- session: the current session, 0 if there is none; it shifts while a K is answered. Its highest bit requests the
    -- compact form and is not part of the CRC seed. in_session: a session exists. for_program: a checked frame began
    -- it.
    session     : out   std_logic_vector(4 * session_digits_of(crc_bits) - 1 downto 0);
    in_session  : out   std_logic;
    for_program : out   std_logic;
    -- The requests belong to no session.
    no_session : in    std_logic := '0';
    -- Request memory.
    memory_index : out   std_logic_vector(7 downto 0);
    memory_word  : in    std_logic_vector(data_bits - 1 downto 0);
    -- Response ring; the word written is the bus master's read_data.
    ring_write    : out   std_logic;
    ring_commit   : out   std_logic;
    ring_rollback : out   std_logic;
    ring_room     : in    unsigned(room_bits - 1 downto 0);
    -- Bus master.
    access_request   : out   std_logic;
    access_write     : out   std_logic;
    access_more      : out   std_logic;
    access_exclusive : out   std_logic;
    access_address   : out   std_logic_vector(address_bits - 1 downto 0);
    access_data      : out   std_logic_vector(data_bits - 1 downto 0);
    -- Do not access the bus: kept_word is the result of the read.
    access_kept    : out   std_logic;
    kept_word      : out   std_logic_vector(data_bits - 1 downto 0);
    access_granted : in    std_logic;
    access_done    : in    std_logic;
    -- Valid with access_done: no other access of the transaction is pending.
    access_last      : in    std_logic;
    access_failure   : in    error_t;
    access_read_data : in    std_logic_vector(data_bits - 1 downto 0);
    -- Subscription manager; the operation is requested until it is done. group_is_set is valid one cycle after the
    -- group's number.
    group_is_set    : in    std_logic;
    group_request   : out   std_logic;
    group_operation : out   group_operation_t;
    group_done      : in    std_logic;
    -- Write port of the manager's list of addresses; the word written is that of the request memory.
    list_write : out   std_logic;
    list_index : out   std_logic_vector(7 downto 0);
    epoch      : out   std_logic;
    -- The waiting samples belong to a session that has ended: discard them.
    drop_samples : out   std_logic;
    -- Answer, to the frame writer; it is stable until accepted.
    answer_valid       : out   std_logic;
    answer_taken       : in    std_logic;
    answer_message     : out   message_t;
    answer_lower       : out   std_logic;
    answer_plain       : out   std_logic;
    answer_mark        : out   flush_mark_t;
    answer_has_id      : out   std_logic;
    answer_has_address : out   std_logic;
    answer_has_pair    : out   std_logic;
    answer_id          : out   std_logic_vector(4 * id_digits - 1 downto 0);
    answer_pair        : out   std_logic_vector(7 downto 0);
    answer_words       : out   std_logic_vector(7 downto 0);
    -- tail: the answer accepted last ends in a tail. tail_more: number of its digits after the first one. tail_digit:
    -- the digit to send. tail_left: number of digits that remain after it. tail_taken: the digit is sent.
    tail       : out   std_logic;
    tail_more  : out   unsigned(2 downto 0);
    tail_digit : out   std_logic_vector(3 downto 0);
    tail_left  : in    unsigned(2 downto 0);
    tail_taken : in    std_logic
  );
end entity ul_request_executor;

architecture rtl of ul_request_executor is

  subtype id_t is std_logic_vector(4 * id_digits - 1 downto 0);

  constant session_digits : positive := session_digits_of(crc_bits);
  constant crc_digits     : positive := crc_bits / 4;
  constant keeps          : boolean  := masked_write or queue_commands;

  subtype session_t is std_logic_vector(4 * session_digits - 1 downto 0);

  -- Outcome of a request: "00" for success, or one of the errors 04, 05 and 06.
  subtype fate_t is std_logic_vector(1 downto 0);

  type state_t is (
    state_idle, state_room, state_load, state_access, state_stop, state_copy, state_group, state_answer, state_tail,
    state_look
  );

  constant mode_off      : std_logic_vector(1 downto 0) := "00";
  constant mode_always   : std_logic_vector(1 downto 0) := "01";
  constant mode_adaptive : std_logic_vector(1 downto 0) := "10";

  type registers_t is record
    state : state_t;
    -- The session.
    in_session  : std_logic;
    for_program : std_logic;
    session     : session_t;
    expected    : unsigned(id_t'range);
    gap_told    : std_logic;
    failures    : unsigned(id_t'range);
    mode        : std_logic_vector(1 downto 0);
    -- The session number in the present request equals that of the session.
    is_same : std_logic;
    -- Comparison of the present request's ID with the expected ID.
    is_expected : std_logic;
    is_ahead    : std_logic;
    -- The request.
    command : command_t;
    has_id  : std_logic;
    plain   : std_logic;
    silent  : std_logic;
    id      : id_t;
    asks    : std_logic;
    -- It takes the next place in the sequence.
    counted : std_logic;
    -- For a repetition: outcome of the first execution.
    fate : fate_t;
    -- The words that it read were kept.
    replays : std_logic;
    -- Execution of the request.
    address : unsigned(address_bits - 1 downto 0);
    -- Number of words not requested from the bus yet.
    left           : unsigned(7 downto 0);
    index          : unsigned(7 downto 0);
    enough_room    : std_logic;
    access_request : std_logic;
    modifying      : std_logic;
    operation      : group_operation_t;
    list_write     : std_logic;
    list_index     : unsigned(7 downto 0);
    epoch          : std_logic;
    -- The answer, if it is not a plain acknowledgement.
    error        : error_t;
    out_of_order : std_logic;
  end record registers_t;

  constant after_reset : registers_t :=
  (
    state          => state_idle,
    in_session     => '0',
    for_program    => '0',
    session        => (others => '0'),
    failures       => (others => '0'),
    is_same        => '0',
    asks           => '0',
    counted        => '0',
    fate           => "00",
    replays        => '0',
    expected       => (others => '0'),
    gap_told       => '0',
    mode           => mode_adaptive,
    is_expected    => '0',
    is_ahead       => '0',
    command        => command_h,
    has_id         => '0',
    plain          => '0',
    silent         => '0',
    id             => (others => '0'),
    address        => (others => '0'),
    left           => (others => '0'),
    index          => (others => '0'),
    enough_room    => '0',
    access_request => '0',
    modifying      => '0',
    operation      => group_stop,
    list_write     => '0',
    list_index     => (others => '0'),
    epoch          => '0',
    error          => error_none,
    out_of_order   => '0'
  );

  -- The distance is in the upper half of the sequence space: the ID is older than the expected one.
  function half_ring (distance : unsigned) return std_logic is
  begin

    return distance(distance'high);

  end function half_ring;

  -- After the answer to such a command, no sample from before it may be sent.
  function ends_samples (command : command_t) return boolean is
  begin

    return command(3 downto 2) = "10";

  end function ends_samples;

  -- Commands that change nothing, or begin a session.
  function looks (command : command_t) return boolean is
  begin

    return command = command_r or command = command_rm or command = command_h or command = command_q or
           command = command_k;

  end function looks;

  function fate_of (error : error_t) return fate_t is
  begin

    case error is

      when error_bus =>
        return "01";

      when error_timeout =>
        return "10";

      when error_range =>
        return "11";

      when others =>
        return "00";

    end case;

  end function fate_of;

  function error_of (fate : fate_t) return error_t is
  begin

    case fate is

      when "01" =>
        return error_bus;

      when "10" =>
        return error_timeout;

      when others =>
        return error_range;

    end case;

  end function error_of;

  -- A digit of a number of two or three hex digits, counted from the right.
  function digit_at (number : unsigned; place : unsigned(1 downto 0)) return std_logic_vector is

    variable padded : unsigned(15 downto 0);

  begin

    padded := resize(number, 16);

    case place is

      when "00" =>
        return std_logic_vector(padded(3 downto 0));

      when "01" =>
        return std_logic_vector(padded(7 downto 4));

      when others =>
        return std_logic_vector(padded(11 downto 8));

    end case;

  end function digit_at;

  signal r           : registers_t;
  signal is_write    : std_logic;
  signal is_queue    : std_logic;
  signal is_masked   : std_logic;
  signal is_block    : std_logic;
  signal last_word   : std_logic;
  signal ok_done     : std_logic;
  signal failed      : std_logic;
  signal memory_kept : std_logic_vector(data_bits - 1 downto 0);
  signal for_nobody  : std_logic;
  signal shut_out    : std_logic;
  signal begins      : std_logic;
  signal in_order    : std_logic;
  signal repeats     : std_logic;
  signal runs        : std_logic;
  signal refusal     : error_t;
  signal is_opening  : std_logic;
  signal has_tail    : std_logic;
  signal from_number : std_logic;
  signal moves       : std_logic;
  signal number_top  : std_logic_vector(3 downto 0);
  signal session_top : std_logic_vector(3 downto 0);
  signal fate_write  : std_logic;
  signal fate        : fate_t;
  signal new_fate    : fate_t;
  -- The group of GN, GX or GP is not set.
  signal group_is_missing : std_logic;

begin

  is_masked <= to_std_logic(masked_write and r.command = command_wk) and not r.replays;
  is_write  <= r.command(2) or r.modifying;
  is_block  <= to_std_logic(r.command = command_wm or r.command = command_wq);
  is_queue  <= to_std_logic(r.command = command_rq or r.command = command_wq);
  last_word <= to_std_logic(r.left = 1) and not (is_masked and not r.modifying);
  ok_done   <= access_done and to_std_logic(access_failure = error_none);
  failed    <= access_done and to_std_logic(access_failure /= error_none);

  request_accept <= to_std_logic(r.state = state_idle);
  hold           <= to_std_logic(r.state /= state_idle);
  hold_letters   <= to_std_logic(r.state /= state_idle and r.command = command_k);
  memory_index   <= std_logic_vector(r.index);

  access_request   <= r.access_request and to_std_logic(r.left /= 0);
  access_write     <= is_write;
  access_more      <= not last_word and not is_queue;
  access_exclusive <= is_write or is_masked;
  access_address   <= std_logic_vector(r.address);
  access_data      <= memory_kept when is_block = '1' else
                      (access_read_data and not memory_kept) or (request_word and memory_kept) when is_masked = '1' else
                      request_word;

  ring_write    <= ok_done and not is_write;
  ring_commit   <= to_std_logic(r.state = state_answer) and answer_taken;
  ring_rollback <= failed;

  group_request   <= to_std_logic(r.state = state_stop or r.state = state_group);
  group_operation <= r.operation;
  list_write      <= r.list_write;
  list_index      <= std_logic_vector(r.list_index);
  epoch           <= r.epoch;

  session     <= r.session;
  in_session  <= r.in_session;
  for_program <= r.for_program;

  -- Result for the present request, checked in the order of the protocol.

  -- The only request allowed to all nodes is WS; a session begun by a program accepts it only in a checked frame.
  for_nobody <= request_silent and
                (request_has_id or to_std_logic(request_error /= error_none or request_command /= command_ws) or
                 (r.for_program and request_plain));
  shut_out   <= (r.for_program and request_has_id and request_plain and not no_session) or
                (r.for_program and not request_has_id and not request_silent and
                 to_std_logic(not looks(request_command))) or
                (r.in_session and r.is_same and begins and not no_session);
  begins     <= not request_asks and to_std_logic(request_command = command_k);
  in_order   <= request_has_id and r.in_session and not no_session and to_std_logic(request_error = error_none) and
                not (r.for_program and request_plain);
  repeats    <= in_order and not r.is_expected and not r.is_ahead;
  runs       <= not request_has_id or r.is_expected;
  refusal    <= request_error when request_error /= error_none else
                error_under_way when shut_out = '1' else
                error_session when ((request_has_id and not r.in_session) or
                                     (no_session and (request_has_id or begins))) = '1' else
                error_range when (runs and (request_out_of_range or group_is_missing)) = '1' else
                error_none;

  group_is_missing <= to_std_logic(groups > 0 and ends_samples(request_command) and request_command /= command_gs) and
                      not group_is_set;

  -- Memories.

  new_fate   <= fate_of(r.error);
  fate_write <= r.counted and to_std_logic(r.state /= state_idle);

  fates_inst : entity work.ul_word_memory
    generic map (
      width => 2,
      depth => 2 ** (4 * id_digits - 1)
    )
    port map (
      clk         => clk,
      write       => fate_write,
      write_index => unsigned(r.id(4 * id_digits - 2 downto 0)),
      write_data  => new_fate,
      read_index  => unsigned(request_id(4 * id_digits - 2 downto 0)),
      read_data   => fate
    );

  with_kept : if keeps generate

    signal keep  : std_logic;
    signal place : unsigned(7 downto 0);

  begin

    keep        <= ok_done and not is_write and r.counted and to_std_logic(r.command(3 downto 1) = "001");
    place       <= unsigned(r.id(7 downto 0)) + r.index;
    access_kept <= r.replays;

    kept_inst : entity work.ul_word_memory
      generic map (
        width => data_bits,
        depth => 256
      )
      port map (
        clk         => clk,
        write       => keep,
        write_index => place,
        write_data  => access_read_data,
        read_index  => place,
        read_data   => kept_word
      );

  end generate with_kept;

  without_kept : if not keeps generate

    access_kept <= '0';
    kept_word   <= (others => '0');

  end generate without_kept;

  -- The tail of an answer.

  is_opening  <= to_std_logic(r.command = command_k) and not r.asks;
  has_tail    <= (to_std_logic(r.error = error_session) and r.has_id) or
                 (to_std_logic(r.error = error_none) and
                  (to_std_logic(r.command = command_k) or
                    (to_std_logic(r.command = command_h) and r.has_id and not r.out_of_order)));
  from_number <= to_std_logic(r.error = error_session) or (is_opening and to_std_logic(tail_left >= session_digits));
  number_top  <= request_number(crc_bits - 1 downto crc_bits - 4) when r.error = error_session else
                 request_number(4 * session_digits - 1 downto 4 * session_digits - 4);
  session_top <= r.session(r.session'high downto r.session'high - 3);

  tail         <= to_std_logic(r.state = state_tail);
  tail_more    <= to_unsigned(crc_digits - 1, 3) when r.error = error_session else
                  to_unsigned(id_digits - 1, 3) when r.command = command_h else
                  to_unsigned(session_digits - 1, 3) when r.asks = '1' else
                  to_unsigned(2 * session_digits - 1, 3);
  tail_digit   <= number_top when from_number = '1' else
                  digit_at(r.failures, tail_left(1 downto 0)) when r.command = command_h else
                  session_top;
  number_shift <= tail_taken;
  moves        <= tail_taken and not from_number and to_std_logic(r.command = command_k);
  drop_samples <= to_std_logic(r.state = state_answer and r.error = error_none) and answer_taken and is_opening;

  answer : process (all) is

    variable is_error : std_logic;

  begin

    is_error       := to_std_logic(r.error /= error_none);
    answer_valid   <= to_std_logic(r.state = state_answer) and not r.silent;
    answer_message <= '0' & r.command;
    answer_lower   <= r.has_id;
    answer_plain   <= r.plain;
    answer_id      <= r.id;
    answer_has_id  <= r.has_id or (is_opening and not is_error);
    answer_pair    <= request_count;
    answer_words   <= (others => '0');
    if r.command(3) = '1' then
      answer_pair <= request_group;
    end if;
    answer_has_address <= not r.has_id and not r.command(3) and not is_error;
    answer_has_pair    <= '0';
    if r.has_id = '0' then

      case r.command is

        when command_rm | command_rq | command_wm | command_wq | command_gs | command_gn | command_gx | command_gp |
             command_i =>
          answer_has_pair <= '1';

        when others =>
          null;

      end case;

    end if;
    if is_error = '0' and r.out_of_order = '0' and r.command(3 downto 2) = "00" then
      answer_words <= request_count;
    end if;
    if r.out_of_order = '1' then
      answer_message <= message_out_of_sequence;
    end if;
    if is_error = '1' then
      answer_message  <= message_error;
      answer_has_pair <= '1';
      answer_pair     <= x"0" & r.error;
    end if;

    answer_mark <= flush_none;
    if send_immediate and r.mode = mode_always then
      answer_mark <= flush_now;
    elsif send_immediate and r.mode /= mode_off then
      answer_mark <= flush_when_idle;
    end if;

  end process answer;

  main : process (clk) is

    variable v        : registers_t;
    variable distance : unsigned(id_t'range);

    procedure begin_group_operation (operation : group_operation_t; state : state_t) is
    begin

      v.operation := operation;
      v.state     := state;
      if groups = 0 then
        v.state := state_answer;
      end if;

    end procedure begin_group_operation;

    procedure refuse (error : error_t) is
    begin

      v.error := error;
      v.state := state_answer;
      if ends_samples(v.command) then
        begin_group_operation(group_nothing, state_group);
      end if;

    end procedure refuse;

    procedure start_session is
    begin

      v.expected := unsigned(request_id);
      v.gap_told := '0';
      v.failures := (others => '0');
      v.mode     := mode_adaptive;
      begin_group_operation(group_stop_all, state_group);

    end procedure start_session;

    -- Execute a request that is neither rejected nor a repetition that only needs an acknowledgement.

    procedure execute is
    begin

      v.state := state_answer;

      case request_command is

        when command_rm | command_rq =>
          v.state := state_room;

        when command_r | command_wk =>
          v.state          := state_access;
          v.access_request := '1';
          if ring_room = 0 then
            v.state          := state_room;
            v.access_request := '0';
          end if;

        when command_w | command_ws =>
          v.state          := state_access;
          v.access_request := '1';

        when command_wm | command_wq =>
          v.state := state_load;

        when command_gs =>
          begin_group_operation(group_stop, state_stop);

        when command_gn =>
          begin_group_operation(group_start, state_group);

        when command_gx =>
          begin_group_operation(group_stop, state_group);

        when command_gp =>
          begin_group_operation(group_publish, state_group);

        when command_i =>
          v.mode := request_group(1 downto 0);

        when command_k =>
          if request_asks = '0' then
            start_session;
          end if;

        when others =>
          null;

      end case;

    end procedure execute;

    procedure accept_request is
    begin

      v.command      := request_command;
      v.has_id       := request_has_id and to_std_logic(request_error = error_none);
      v.plain        := request_plain;
      v.silent       := request_silent;
      v.id           := request_id;
      v.address      := unsigned(request_address(address_bits - 1 downto 0));
      v.left         := unsigned(request_count);
      v.asks         := request_asks;
      v.counted      := in_order and r.is_expected and not request_silent;
      v.replays      := repeats and request_command(1) and to_std_logic(keeps);
      v.modifying    := '0';
      v.error        := error_none;
      v.out_of_order := '0';
      if v.counted = '1' then
        v.expected := r.expected + 1;
        v.gap_told := '0';
      end if;

      if for_nobody = '1' then
        null;
      elsif refusal /= error_none then
        refuse(refusal);
      elsif runs = '1' then
        execute;
      elsif repeats = '1' then
        v.state := state_look;
      elsif r.gap_told = '0' then
        v.gap_told     := '1';
        v.out_of_order := '1';
        v.id           := std_logic_vector(r.expected);
        v.state        := state_answer;
      end if;

    end procedure accept_request;

    -- Answer a repetition. Reads are executed again; reads with kept words return the kept words.

    procedure answer_again is
    begin

      if r.fate /= "00" then
        refuse(error_of(r.fate));
      elsif r.command(3 downto 2) = "00" then
        v.state := state_room;
        if request_out_of_range = '1' then
          refuse(error_range);
        end if;
      else
        v.state := state_answer;
        if r.command = command_ws then
          v.state := state_idle;
        end if;
      end if;

    end procedure answer_again;

    procedure finish_access is
    begin

      if failed = '1' then
        v.access_request := '0';
        refuse(access_failure);
      elsif is_masked = '1' and r.modifying = '0' then
        v.modifying := '1';
      else
        if r.left = 0 and access_last = '1' then
          v.access_request := '0';
          v.state          := state_answer;
          if r.command = command_ws then
            v.state := state_idle;
          end if;
        end if;
      end if;

    end procedure finish_access;

    -- Copy the addresses of GS from the request memory to the subscription manager.

    procedure copy_list is
    begin

      if r.index = unsigned(request_count) then
        begin_group_operation(group_set, state_group);
      else
        v.index      := r.index + 1;
        v.list_write := '1';
        v.list_index := r.index;
      end if;

    end procedure copy_list;

  begin

    if rising_edge(clk) then
      memory_kept   <= memory_word;
      v             := r;
      distance      := unsigned(request_id) - r.expected;
      v.is_expected := to_std_logic(distance = 0);
      v.is_ahead    := not half_ring(distance);
      v.enough_room := to_std_logic(ring_room >= unsigned(request_count));
      v.is_same     := to_std_logic(request_number(4 * session_digits - 2 downto 0)
                                    = r.session(4 * session_digits - 2 downto 0));
      v.fate        := fate;
      v.list_write  := '0';

      case r.state is

        when state_idle =>
          -- Index 0 is applied all the time, so that the first word of the next request is read in time.
          v.index := (others => '0');
          if request_valid = '1' then
            accept_request;
          end if;

        when state_room =>
          if r.enough_room = '1' then
            v.state          := state_access;
            v.access_request := '1';
          end if;

        when state_load =>
          v.state          := state_access;
          v.access_request := '1';

        when state_access =>
          if access_granted = '1' then
            if r.command(2) = '1' then
              v.index := r.index + 1;
            end if;
            if is_queue = '0' and is_masked = '0' then
              v.address := r.address + 1;
            end if;
            if is_masked = '0' or r.modifying = '1' then
              v.left := r.left - 1;
            end if;
          end if;
          if ok_done = '1' and r.command = command_rq then
            v.index := r.index + 1;
          end if;
          if access_done = '1' then
            finish_access;
          end if;

        when state_stop =>
          if group_done = '1' then
            v.state := state_copy;
          end if;

        when state_copy =>
          copy_list;

        when state_group =>
          if group_done = '1' then
            v.state := state_answer;
            v.epoch := r.epoch xor not r.command(2);
          end if;

        when state_answer =>
          if answer_taken = '1' or r.silent = '1' then
            v.state := state_idle;
            if has_tail = '1' then
              v.state := state_tail;
            end if;
            -- A posted write has no answer unless it was rejected; count its failure.
            if r.counted = '1' and r.command = command_ws then
              v.failures := r.failures + 1;
            end if;
          end if;

        when state_tail =>
          if tail_taken = '1' and tail_left = 0 then
            v.state := state_idle;
            if r.command = command_k and r.asks = '0' then
              v.in_session  := '1';
              v.for_program := not r.plain;
            end if;
          end if;

        when state_look =>
          answer_again;

      end case;

      if moves = '1' then
        v.session := r.session(r.session'high - 4 downto 0) & session_top;
        if r.asks = '0' then
          v.session(3 downto 0) := number_top;
        end if;
      end if;

      r <= v;

      if rst = '1' then
        r <= after_reset;
      end if;
    end if;

  end process main;

end architecture rtl;
