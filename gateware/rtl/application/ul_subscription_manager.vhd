-- SPDX-License-Identifier: BSD-3-Clause
--
-- Takes the samples of all publish groups when they are due, and stores the settings of the groups (docs/protocol.md,
-- "Groups").
--
-- A group becomes due by the base tick (`ul_group_timer`), by an edge of its trigger, or by GP. Due groups are served
-- at once, lowest number first. The words of a sample are read by accesses of their own, which have priority in the bus
-- master. The words are stored in the sample ring until the frame writer sends them. If the ring has no space, or a
-- read fails, the sample is not sent; only its sequence number is used up.
--
-- To detect changed words, a memory stores the last accepted sample of each group. It has two halves for each group:
-- the new sample is written to the invalid half, which becomes the valid one only if the sample is accepted. So a
-- sample that fails half-way does not change the stored one.
--
-- Each sample has the epoch in which it was taken, for the frame writer.
--
-- A group g of n words uses the places g * slot to g * slot + n - 1 in the memory of addresses and in each half of the
-- memory of last samples.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_subscription_manager is
  generic (
    data_bits                 : positive := 32;
    address_bits              : positive := 8;
    groups                    : positive := 16;
    group_words               : positive := 32;
    clock_hz                  : positive := 50_000_000;
    base_frequency_millihertz : positive := 100_000_000;
    timestamps                : boolean  := true;
    triggers                  : boolean  := true;
    -- Bits of the word count of the sample ring.
    room_bits : positive := 9
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- May be asynchronous to clk; must be high and low for at least two cycles each. Edges that arrive before the
    -- sample for an earlier edge has begun are merged with that edge.
    trigger : in    std_logic_vector(groups - 1 downto 0);
    -- Operations, requested until done.
    group_request   : in    std_logic;
    group_operation : in    group_operation_t;
    group_done      : out   std_logic;
    group_number    : in    std_logic_vector(7 downto 0);
    group_flags     : in    std_logic_vector(5 downto 0);
    group_divisor   : in    std_logic_vector(15 downto 0);
    group_count     : in    std_logic_vector(7 downto 0);
    -- Valid one cycle after group_number.
    group_is_set : out   std_logic;
    -- Addresses of a group that is stopped.
    list_write   : in    std_logic;
    list_index   : in    std_logic_vector(7 downto 0);
    list_address : in    std_logic_vector(address_bits - 1 downto 0);
    epoch        : in    std_logic;
    -- Bus master.
    access_request   : out   std_logic;
    access_more      : out   std_logic;
    access_address   : out   std_logic_vector(address_bits - 1 downto 0);
    access_granted   : in    std_logic;
    access_done      : in    std_logic;
    access_failure   : in    error_t;
    access_read_data : in    std_logic_vector(data_bits - 1 downto 0);
    -- Sample ring; `ul_frame_writer` describes its layout.
    ring_write    : out   std_logic;
    ring_data     : out   std_logic_vector(maximum(4 * digits_of(data_bits), 32) - 1 downto 0);
    ring_commit   : out   std_logic;
    ring_rollback : out   std_logic;
    ring_room     : in    unsigned(room_bits - 1 downto 0);
    -- As in `ul_gateway_clock`.
    base_tick : out   std_logic;
    timestamp : out   std_logic_vector(63 downto 0)
  );
end entity ul_subscription_manager;

architecture rtl of ul_subscription_manager is

  -- Number of cycles that a round of the timer takes in addition to one cycle for each group.
  constant round_cycles : positive := 8;

  constant group_bits : positive := maximum(log2_ceil(groups), 1);
  constant slot_bits  : positive := maximum(log2_ceil(group_words), 1);
  constant word_bits  : positive := maximum(4 * digits_of(data_bits), 32);
  constant digit_bits : positive := 4 * digits_of(data_bits);

  subtype number_t is unsigned(group_bits - 1 downto 0);

  subtype vector_t is std_logic_vector(groups - 1 downto 0);

  type settings_memory_t is array (0 to 2 ** group_bits - 1) of std_logic_vector(13 downto 0);

  type state_memory_t is array (0 to 2 ** group_bits - 1) of std_logic_vector(9 downto 0);

  type list_t is array (0 to 2 ** (group_bits + slot_bits) - 1) of std_logic_vector(address_bits - 1 downto 0);

  type last_t is array (0 to 2 ** (group_bits + slot_bits + 1) - 1) of std_logic_vector(data_bits - 1 downto 0);

  -- A group's memory words are not used before the group was set: the initial values only avoid unknown values in
  -- simulation.
  -- vsg_off signal_007
  signal settings_memory : settings_memory_t := (others => (others => '0'));
  signal state_memory    : state_memory_t    := (others => (others => '0'));
  -- vsg_on signal_007
  signal list : list_t;
  signal last : last_t;

  type state_t is (
    state_idle, state_fetch, state_keep, state_measure, state_compare, state_prepare, state_sample, state_finish,
    state_wait_timer, state_told
  );

  type reason_t is (reason_periodic, reason_trigger, reason_request);

  signal state  : state_t;
  signal reason : reason_t;
  signal number : number_t;

  -- Settings and state of group `number`: read one cycle after it changes, and registered one cycle later.
  signal settings_read  : std_logic_vector(13 downto 0);
  signal settings       : std_logic_vector(13 downto 0);
  signal flags          : std_logic_vector(5 downto 0);
  signal count          : unsigned(7 downto 0);
  signal state_read     : std_logic_vector(9 downto 0);
  signal group_state    : std_logic_vector(9 downto 0);
  signal group_sequence : unsigned(7 downto 0);
  signal is_first       : std_logic;
  signal half           : std_logic;
  signal settings_write : std_logic;
  signal state_write    : std_logic;
  signal new_state      : std_logic_vector(9 downto 0);

  -- The timer is idle: execute the operation that was waiting for it.
  signal carry_out : std_logic;

  signal running : vector_t;
  -- Running groups that edges make due. Edges of other groups must be ignored at once: each would take cycles from due
  -- groups and from operations.
  signal listening      : vector_t;
  signal is_set         : vector_t;
  signal due_by_timer   : vector_t;
  signal due_by_trigger : vector_t;
  signal clear_timer    : vector_t;
  signal clear_trigger  : vector_t;
  signal pick_valid     : std_logic;
  signal pick_number    : number_t;
  signal pick_by_timer  : std_logic;
  signal picks          : std_logic;
  signal operates       : std_logic;
  signal operation_turn : std_logic;

  signal tick           : std_logic;
  signal timer_busy     : std_logic;
  signal timer_collides : std_logic;
  signal timer_set      : std_logic;
  signal timer_start    : std_logic;
  signal timer_divisor  : std_logic_vector(15 downto 0);
  signal lost           : unsigned(7 downto 0);
  signal lost_kept      : unsigned(7 downto 0);
  signal stamp          : std_logic_vector(63 downto 0);

  -- The sample being taken: its sequence number, number of words requested and number of words read.
  signal own_sequence : unsigned(7 downto 0);
  signal asked        : unsigned(7 downto 0);
  signal stored       : unsigned(7 downto 0);
  signal changed      : std_logic;
  signal failed       : std_logic;
  signal last_read    : std_logic_vector(data_bits - 1 downto 0);
  signal last_word    : std_logic_vector(data_bits - 1 downto 0);
  signal address_read : std_logic_vector(address_bits - 1 downto 0);
  signal all_asked    : std_logic;
  -- Addresses and last words are read two words ahead, so that there can be one access in each cycle.
  signal ahead : unsigned(7 downto 0);
  -- Number of words of the sample in the ring, with header and timestamp.
  signal total        : unsigned(8 downto 0);
  signal word_done    : std_logic;
  signal enough_room  : std_logic;
  signal is_wanted    : std_logic;
  signal accepted     : std_logic;
  signal write_header : std_logic;
  signal write_stamp  : std_logic;
  signal header       : std_logic_vector(31 downto 0);
  signal number_byte  : unsigned(7 downto 0);
  signal pick_byte    : unsigned(7 downto 0);

  function place (of_number : number_t; index : unsigned(7 downto 0)) return unsigned is

    variable wide : unsigned(slot_bits - 1 downto 0);

  begin

    wide := resize(index, slot_bits);
    return of_number & wide;

  end function place;

  function one_hot (of_number : number_t; enable : std_logic) return vector_t is

    variable result : vector_t := (others => '0');

  begin

    for index in result'range loop

      if of_number = index then
        result(index) := enable;
      end if;

    end loop;

    return result;

  end function one_hot;

  -- A value aligned to the highest bit of a ring word.
  function aligned (value : std_logic_vector; bits : positive) return std_logic_vector is

    variable result : std_logic_vector(word_bits - 1 downto 0) := (others => '0');

  begin

    result(word_bits - bits + value'length - 1 downto word_bits - bits) := value;
    return result;

  end function aligned;

begin

  assert group_words <= 255 and groups <= 256
    report "ul_subscription_manager: more than 256 groups or more than 255 words in one"
    severity failure;

  -- The timer processes one group per cycle; settings are changed between two of its rounds.
  assert real(clock_hz) * 1.0e3 / real(base_frequency_millihertz) >= real(groups + round_cycles)
    report "unity_link: a base tick of " & integer'image(base_frequency_millihertz) & " mHz leaves less than "
           & integer'image(groups + round_cycles) & " clock cycles, which " & integer'image(groups) & " groups take"
    severity failure;

  clock_inst : entity work.ul_gateway_clock
    generic map (
      clock_hz                  => clock_hz,
      base_frequency_millihertz => base_frequency_millihertz
    )
    port map (
      clk       => clk,
      rst       => rst,
      base_tick => tick,
      timestamp => stamp
    );

  base_tick <= tick;
  timestamp <= stamp;

  timer_inst : entity work.ul_group_timer
    generic map (
      groups => groups
    )
    port map (
      clk         => clk,
      rst         => rst,
      tick        => tick,
      running     => running,
      number      => number_byte,
      set         => timer_set,
      divisor     => timer_divisor,
      start       => timer_start,
      busy        => timer_busy,
      due         => due_by_timer,
      clear       => clear_timer,
      lost_number => pick_byte,
      lost        => lost,
      collides    => timer_collides
    );

  -- Groups that are due.

  with_triggers : if triggers generate

    signal now : vector_t;
    signal old : vector_t;

  begin

    trigger_crossing : entity work.ul_synchroniser
      generic map (
        width => groups,
        idle  => '1'
      )
      port map (
        clk => clk,
        rst => rst,
        d   => trigger,
        q   => now
      );

    edges : process (clk) is
    begin

      if rising_edge(clk) then
        old            <= now;
        due_by_trigger <= (due_by_trigger or (now and not old)) and not clear_trigger;

        if rst = '1' then
          old            <= (others => '1');
          due_by_trigger <= (others => '0');
        end if;
      end if;

    end process edges;

  end generate with_triggers;

  without_triggers : if not triggers generate

    due_by_trigger <= (others => '0');

  end generate without_triggers;

  pick : process (clk) is

    variable due : vector_t;

  begin

    if rising_edge(clk) then
      due         := (due_by_timer or due_by_trigger) and running;
      pick_valid  <= '0';
      pick_number <= (others => '0');

      for index in groups - 1 downto 0 loop

        if due(index) = '1' then
          pick_valid    <= '1';
          pick_number   <= to_unsigned(index, group_bits);
          pick_by_timer <= due_by_timer(index);
        end if;

      end loop;

      if rst = '1' then
        pick_valid    <= '0';
        pick_number   <= (others => '0');
        pick_by_timer <= '0';
      end if;
    end if;

  end process pick;

  -- After each sample an operation has priority, so that groups can be stopped even if they request more than the bus
  -- can transfer.
  operates      <= group_request and (operation_turn or not pick_valid) and to_std_logic(state = state_idle);
  picks         <= pick_valid and not operates and not timer_collides and to_std_logic(state = state_idle);
  clear_timer   <= one_hot(pick_number, picks and pick_by_timer) or not running;
  clear_trigger <= one_hot(pick_number, picks and not pick_by_timer) or not listening;

  -- Memories.

  number_byte    <= resize(number, 8);
  pick_byte      <= resize(pick_number, 8);
  flags          <= settings(5 downto 0);
  count          <= unsigned(settings(13 downto 6));
  group_sequence <= unsigned(group_state(7 downto 0));
  is_first       <= group_state(8);
  half           <= group_state(9);
  timer_divisor  <= group_divisor when group_flags(flag_periodic) = '1' else
                    (others => '0');

  memories : process (clk) is
  begin

    if rising_edge(clk) then
      if settings_write = '1' then
        settings_memory(to_integer(number)) <= group_count & group_flags;
      end if;
      settings_read <= settings_memory(to_integer(number));
      settings      <= settings_read;

      if state_write = '1' then
        state_memory(to_integer(number)) <= new_state;
      end if;
      state_read  <= state_memory(to_integer(number));
      group_state <= state_read;

      if list_write = '1' then
        list(to_integer(place(unsigned(group_number(group_bits - 1 downto 0)), unsigned(list_index)))) <= list_address;
      end if;
      if access_granted = '1' or state /= state_sample then
        address_read   <= list(to_integer(place(number, asked + ahead)));
        access_address <= address_read;
      end if;

      if word_done = '1' then
        last(to_integer(place(number, stored) & not half)) <= access_read_data;
      end if;
      if word_done = '1' or state /= state_sample then
        last_read <= last(to_integer(place(number, stored + ahead) & half));
        last_word <= last_read;
      end if;

      group_is_set <= '0';
      -- One bit wider, because the number 256 of groups does not fit into eight bits (GHDL converts such a comparison
      -- wrongly).
      if resize(unsigned(group_number), 9) < groups then
        group_is_set <= bit_at(is_set, unsigned(group_number(group_bits - 1 downto 0)));
      end if;
      if rst = '1' then
        group_is_set <= '0';
      end if;
    end if;

  end process memories;

  -- The sample.

  -- Derive the header from settings and state in several states, to keep the paths short.
  measure : process (clk) is
  begin

    if rising_edge(clk) then
      total <= resize(count, 9) + 1;
      if flags(flag_timestamp) = '1' then
        total <= resize(count, 9) + 2;
      end if;
      enough_room  <= to_std_logic(ring_room >= total);
      own_sequence <= group_sequence;
      if reason = reason_periodic then
        own_sequence <= group_sequence + lost_kept;
      end if;

      if rst = '1' then
        total <= (others => '0');
      end if;
    end if;

  end process measure;

  word_done      <= access_done and to_std_logic(state = state_sample);
  is_wanted      <= changed or is_first or not flags(flag_on_change) or to_std_logic(reason = reason_request);
  accepted       <= is_wanted and not failed;
  access_request <= to_std_logic(state = state_sample) and not all_asked;
  ahead          <= to_unsigned(2, 8) when state = state_sample else
                    to_unsigned(1, 8) when state = state_prepare else
                    to_unsigned(0, 8);
  access_more    <= to_std_logic(asked + 1 /= count);

  write_header  <= to_std_logic(state = state_prepare) and enough_room;
  write_stamp   <= access_granted and to_std_logic(asked = 0) and flags(flag_timestamp) and to_std_logic(timestamps);
  header        <= std_logic_vector(number_byte & own_sequence & total) & flags(flag_timestamp) & flags(flag_plain) &
                   flags(flag_immediate) & epoch & "000";
  ring_write    <= write_header or write_stamp or word_done;
  ring_data     <= aligned(header, 32) when write_header = '1' else
                   aligned(stamp(31 downto 0), 32) when write_stamp = '1' else
                   aligned(access_read_data, digit_bits);
  ring_commit   <= to_std_logic(state = state_finish) and accepted;
  ring_rollback <= to_std_logic(state = state_finish) and not accepted;

  group_done <= to_std_logic(state = state_told);

  -- Settings.

  carry_out      <= to_std_logic(state = state_wait_timer) and not timer_busy;
  timer_set      <= carry_out and to_std_logic(group_operation = group_set);
  timer_start    <= carry_out and to_std_logic(group_operation = group_start);
  settings_write <= timer_set;
  state_write    <= carry_out or to_std_logic(state = state_finish);

  next_state : process (all) is

    variable next_sequence : unsigned(7 downto 0);
    variable next_first    : std_logic;
    variable next_half     : std_logic;

  begin

    next_sequence := own_sequence;
    next_first    := is_first;
    next_half     := half;
    if state = state_finish then
      if accepted = '1' then
        next_first := '0';
        next_half  := not half;
      end if;
      if accepted = '1' or failed = '1' then
        next_sequence := own_sequence + 1;
      end if;
    else
      next_first    := '1';
      next_sequence := group_sequence;
      if group_operation = group_set then
        next_sequence := (others => '0');
      end if;
    end if;
    new_state <= next_half & next_first & std_logic_vector(next_sequence);

  end process next_state;

  main : process (clk) is

    procedure begin_operation is
    begin

      number <= unsigned(group_number(group_bits - 1 downto 0));
      reason <= reason_request;

      case group_operation is

        when group_stop_all =>
          running   <= (others => '0');
          listening <= (others => '0');
          state     <= state_told;

        when group_stop =>
          running   <= running and not one_hot(unsigned(group_number(group_bits - 1 downto 0)), '1');
          listening <= listening and not one_hot(unsigned(group_number(group_bits - 1 downto 0)), '1');
          state     <= state_told;

        when group_nothing =>
          state <= state_told;

        when others =>
          state <= state_fetch;

      end case;

    end procedure begin_operation;

  begin

    if rising_edge(clk) then

      case state is

        when state_idle =>
          asked     <= (others => '0');
          all_asked <= '0';
          stored    <= (others => '0');
          changed   <= '0';
          failed    <= '0';
          if picks = '1' then
            number <= pick_number;
            reason <= reason_trigger;
            if pick_by_timer = '1' then
              reason <= reason_periodic;
            end if;
            state <= state_fetch;
          elsif operates = '1' then
            begin_operation;
          end if;

        when state_fetch =>
          lost_kept <= lost;
          state     <= state_keep;

        when state_keep =>
          state <= state_measure;
          if reason = reason_request and group_operation /= group_publish then
            state <= state_wait_timer;
          end if;

        when state_measure =>
          state <= state_compare;

        when state_compare =>
          state <= state_prepare;

        when state_prepare =>
          state <= state_sample;
          if enough_room = '0' then
            failed <= '1';
            state  <= state_finish;
          end if;

        when state_sample =>
          if access_granted = '1' then
            asked     <= asked + 1;
            all_asked <= to_std_logic(asked + 1 = count);
          end if;
          if access_done = '1' then
            stored <= stored + 1;
            if access_read_data /= last_word then
              changed <= '1';
            end if;
            if access_failure /= error_none then
              failed <= '1';
              state  <= state_finish;
            elsif stored + 1 = count then
              state <= state_finish;
            end if;
          end if;

        when state_finish =>
          operation_turn <= '1';
          state          <= state_idle;
          if reason = reason_request then
            state <= state_told;
          end if;

        when state_wait_timer =>
          if carry_out = '1' then
            state <= state_told;
            if group_operation = group_set then
              is_set <= is_set or one_hot(number, '1');
            else
              running   <= running or one_hot(number, '1');
              listening <= listening or one_hot(number, flags(flag_trigger));
            end if;
          end if;

        when state_told =>
          operation_turn <= '0';
          state          <= state_idle;

      end case;

      if rst = '1' then
        operation_turn <= '0';
        state          <= state_idle;
        reason         <= reason_request;
        number         <= (others => '0');
        running        <= (others => '0');
        listening      <= (others => '0');
        is_set         <= (others => '0');
        asked          <= (others => '0');
        all_asked      <= '0';
        stored         <= (others => '0');
        changed        <= '0';
        failed         <= '0';
        lost_kept      <= (others => '0');
      end if;
    end if;

  end process main;

end architecture rtl;
