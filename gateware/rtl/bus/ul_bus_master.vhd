-- SPDX-License-Identifier: BSD-3-Clause
--
-- Takes the accesses of requests and of samples to one bus, and ends those that are not answered.
--
-- Samples go first, also between the words of a block that is read, so that they are taken when they are due. They wait
-- where a transaction would be torn: for the rest of WM and WK (`request_exclusive`). A sample, once begun, is not
-- interrupted either. Its instant is the cycle in which its first access is chosen: `sample_strobe` is '1' then, and
-- `sample_access` from the next one on until its last access has been answered, or the bus has rested after one that
-- has not.
--
-- One access takes three cycles on a bus without wait states: chosen (`..._granted`), on the bus, told (`..._done`,
-- with `failure` and `read_data`).
--
-- Rules for a client, which a simulation checks by assertions:
-- - It keeps its request up until it is granted; address and data of the next access must stand there in the cycle
--   after that.
-- - A transaction of several accesses is of reads, or exclusive, from its first to its last.
-- - Behind its last access it asks for nothing before that has been told: what it asks for while a block is under way
--   would be taken for another word of the block.
--
-- The words of a block that is read, and those of a sample, are asked for before the answers to those before them
-- (`bus_ahead`), where the bus takes an access before it answers it (`bus_next`): up to four are under way, and they
-- are told in order. The first that fails is told at once and is the last to be told. What is under way behind it is
-- answered before anything else is asked for. Writes, exclusive transactions and single accesses go one by one.
--
-- A request of a kept word is an access like any other, but the bus sees nothing of it, and the word is what is read.
--
-- After an access that timed out nothing is asked of the bus for `timeout` cycles, in which the bus is taken back: a
-- slave that answers late does so then, when nobody listens. Where several may have been under way it is twice as long,
-- as the youngest may just have been taken. The access is told before, so only the next one waits.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_bus_master is
  generic (
    data_bits    : positive := 32;
    address_bits : positive := 8;
    -- Cycles on the bus after which an access has failed, and then without any.
    timeout : positive := 1024;
    -- Whether the bus takes an access before it answers the one before; else bus_next is '0'.
    pipelined : boolean := true
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- Accesses of requests; more: another one of the same atomic transaction follows.
    request           : in    std_logic;
    request_write     : in    std_logic;
    request_more      : in    std_logic;
    request_exclusive : in    std_logic;
    request_address   : in    std_logic_vector(address_bits - 1 downto 0);
    request_data      : in    std_logic_vector(data_bits - 1 downto 0);
    request_kept      : in    std_logic;
    kept_word         : in    std_logic_vector(data_bits - 1 downto 0);
    request_granted   : out   std_logic;
    request_done      : out   std_logic;
    -- With done: no other access of the transaction is under way.
    request_last : out   std_logic;
    -- Accesses of samples.
    sample         : in    std_logic;
    sample_more    : in    std_logic;
    sample_address : in    std_logic_vector(address_bits - 1 downto 0);
    sample_granted : out   std_logic;
    sample_done    : out   std_logic;
    sample_strobe  : out   std_logic;
    sample_access  : out   std_logic;
    -- For both, with done; read_data stands until the next access ends.
    failure   : out   error_t;
    read_data : out   std_logic_vector(data_bits - 1 downto 0);
    -- Bus-independent interface, see `unity_link_core`.
    bus_request    : out   std_logic;
    bus_write      : out   std_logic;
    bus_lock       : out   std_logic;
    bus_ahead      : out   std_logic;
    bus_next       : in    std_logic;
    bus_address    : out   std_logic_vector(address_bits - 1 downto 0);
    bus_write_data : out   std_logic_vector(data_bits - 1 downto 0);
    bus_read_data  : in    std_logic_vector(data_bits - 1 downto 0);
    bus_done       : in    std_logic;
    bus_error      : in    std_logic
  );
end entity ul_bus_master;

architecture rtl of ul_bus_master is

  -- Accesses that are under way at once.
  constant most : positive := 4;

  type state_t is (state_idle, state_active, state_drain, state_told, state_rest);

  signal state      : state_t;
  signal for_sample : std_logic;
  -- A transaction of this client has further accesses; of a request: nobody may come between them.
  signal sample_lock  : std_logic;
  signal request_lock : std_logic;
  signal exclusive    : std_logic;
  signal timed_out    : std_logic;
  signal time_left    : unsigned(log2_ceil(timeout) downto 0);
  -- The transaction is of reads that may be asked for before the answers to those before them.
  signal ahead : std_logic;
  -- Accesses that the bus has taken and not answered, now and behind this edge, without the one that is asked for.
  signal under_way    : unsigned(2 downto 0);
  signal still        : unsigned(2 downto 0);
  signal stands       : std_logic;
  signal kept         : std_logic;
  signal told_ahead   : std_logic;
  signal goes_on      : std_logic;
  signal free         : std_logic;
  signal is_asking    : std_logic;
  signal grant_sample : std_logic;
  signal grant        : std_logic;

begin

  -- The place of the access that is asked for is free for the next one.
  goes_on      <= ahead and (bus_next or not bus_request) and not (bus_done and bus_error)
                  and to_std_logic(state = state_active and time_left /= 0 and under_way < most - 1);
  free         <= to_std_logic(state = state_idle);
  is_asking    <= to_std_logic(state = state_active or state = state_drain);
  grant_sample <= sample and not exclusive and (free or (goes_on and for_sample));
  grant        <= request and not (sample and not exclusive) and not sample_lock
                  and (free or (goes_on and not for_sample));

  stands <= bus_request and not (bus_next or (bus_done and to_std_logic(under_way = 0)));
  still  <= (others => '0') when not pipelined else
            under_way + 1 when bus_next = '1' and bus_done = '0' else
            under_way - 1 when bus_next = '0' and bus_done = '1' and under_way /= 0 else
            under_way;

  sample_granted  <= grant_sample;
  request_granted <= grant;
  sample_done     <= (to_std_logic(state = state_told) or told_ahead) and for_sample;
  sample_strobe   <= grant_sample and not sample_lock;
  sample_access   <= for_sample and (is_asking or sample_lock or timed_out);
  request_done    <= (to_std_logic(state = state_told) or told_ahead) and not for_sample;
  request_last    <= to_std_logic(state = state_told);
  bus_ahead       <= ahead;
  -- An access that timed out takes the bus down with it, whatever transaction it stood in, until its rest is over.
  bus_lock <= (sample_lock or request_lock or (ahead and is_asking)) and not timed_out;

  -- Not for synthesis, which makes something of an assertion in each tool. (The port hides the severity of its name.)
  -- synthesis translate_off
  check_rules : process (clk) is

    variable block_runs : std_logic;

  begin

    if rising_edge(clk) then
      block_runs := ahead and to_std_logic(state = state_active) and not rst;
      -- What is unknown, as registers are before the first reset, breaks no rule.
      assert (block_runs and not for_sample and not request_lock and request) /= '1'
        report "ul_bus_master: a request behind the last access of a block, before that has been told"
        severity std.standard.failure;
      assert (block_runs and for_sample and not sample_lock and sample) /= '1'
        report "ul_bus_master: a sample behind the last access of another, before that has been told"
        severity std.standard.failure;
      assert (block_runs and not for_sample and request and (request_write or request_exclusive)) /= '1'
        report "ul_bus_master: a request of another kind in a block that is read"
        severity std.standard.failure;
      assert (not rst and request and request_write and request_more and not request_exclusive) /= '1'
        report "ul_bus_master: a transaction of writes that is not exclusive"
        severity std.standard.failure;
    end if;

  end process check_rules;

  -- synthesis translate_on

  main : process (clk) is

    -- The rest is as long as the youngest access may take to be answered.

    procedure give_up is
    begin

      bus_request <= '0';
      under_way   <= (others => '0');
      timed_out   <= '1';
      time_left   <= to_unsigned(timeout - 1, time_left'length);
      if ahead = '1' then
        time_left <= to_unsigned(2 * timeout - 1, time_left'length);
      end if;

    end procedure give_up;

  begin

    if rising_edge(clk) then
      told_ahead <= '0';
      under_way  <= still;

      case state is

        when state_idle =>
          time_left <= to_unsigned(timeout - 1, time_left'length);
          if grant_sample = '1' then
            for_sample <= '1';
            ahead      <= sample_more and to_std_logic(pipelined);
          end if;
          if grant = '1' then
            for_sample <= '0';
            exclusive  <= request_more and request_exclusive;
            ahead      <= request_more and not request_exclusive and to_std_logic(pipelined);
          end if;
          if grant_sample = '1' or grant = '1' then
            state <= state_active;
          end if;

        when state_active =>
          time_left   <= time_left - 1;
          failure     <= error_none;
          bus_request <= stands;
          if (bus_done or kept) = '1' then
            time_left <= to_unsigned(timeout - 1, time_left'length);
            read_data <= bus_read_data;
            if kept = '1' then
              read_data <= kept_word;
            end if;
            told_ahead <= '1';
            if (bus_error and not kept) = '1' then
              failure <= error_bus;
              state   <= state_drain;
            end if;
            if still = 0 and stands = '0' and grant_sample = '0' and grant = '0' then
              told_ahead <= '0';
              state      <= state_told;
            end if;
          elsif time_left = 0 then
            give_up;
            failure <= error_timeout;
            state   <= state_told;
          end if;

        -- What was asked for behind an access that failed is answered before anything else is.
        when state_drain =>
          time_left   <= time_left - 1;
          bus_request <= stands;
          if for_sample = '1' then
            sample_lock <= '0';
          else
            request_lock <= '0';
          end if;
          if bus_done = '1' then
            time_left <= to_unsigned(timeout - 1, time_left'length);
            if still = 0 and stands = '0' then
              state <= state_idle;
            end if;
          elsif time_left = 0 then
            give_up;
            state <= state_rest;
          end if;

        when state_told =>
          if failure /= error_none then
            if for_sample = '1' then
              sample_lock <= '0';
            else
              request_lock <= '0';
              exclusive    <= '0';
            end if;
          end if;
          state <= state_idle;
          if timed_out = '1' then
            state <= state_rest;
          end if;

        when state_rest =>
          time_left <= time_left - 1;
          if time_left = 0 then
            timed_out <= '0';
            state     <= state_idle;
          end if;

      end case;

      if grant_sample = '1' then
        sample_lock <= sample_more;
      end if;
      if grant = '1' then
        request_lock <= request_more;
      end if;
      if grant_sample = '1' or grant = '1' then
        kept           <= grant and request_kept;
        bus_request    <= not (grant and request_kept);
        bus_write      <= grant and request_write;
        bus_write_data <= request_data;
        bus_address    <= request_address;
        if grant_sample = '1' then
          bus_address <= sample_address;
        end if;
      end if;

      if rst = '1' then
        state          <= state_idle;
        ahead          <= '0';
        under_way      <= (others => '0');
        told_ahead     <= '0';
        for_sample     <= '0';
        sample_lock    <= '0';
        request_lock   <= '0';
        exclusive      <= '0';
        timed_out      <= '0';
        time_left      <= (others => '0');
        failure        <= error_none;
        read_data      <= (others => '0');
        kept           <= '0';
        bus_request    <= '0';
        bus_write      <= '0';
        bus_address    <= (others => '0');
        bus_write_data <= (others => '0');
      end if;
    end if;

  end process main;

end architecture rtl;
