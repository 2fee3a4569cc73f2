-- SPDX-License-Identifier: BSD-3-Clause
--
-- Arbitrates the accesses of requests and of samples to one bus, and ends accesses that the bus does not answer.
--
-- Samples have priority, even between the words of a block read, so that they are read when they are due. They wait
-- only while a transaction must not be interrupted: until the end of WM and WK (`request_exclusive`). A sample that has
-- begun is not interrupted either. The instant of a sample is the cycle in which its first access is granted:
-- `sample_strobe` is '1' in that cycle, and `sample_access` from the next cycle until its last access was answered, or
-- until the bus has rested after a timeout.
--
-- An access takes three cycles on a bus without wait states: granted (`..._granted`), on the bus, reported (`..._done`,
-- with `failure` and `read_data`).
--
-- Rules for a client, which assertions check in simulation:
-- - It asserts its request until it is granted; the address and data of the next access must be valid in the cycle
--   after that.
-- - All accesses of a transaction are reads, or all are exclusive.
-- - After the last access of a transaction it requests nothing until that access is reported done: while a block read
--   is in progress, a new request would be treated as another word of the block.
--
-- The words of a block read and those of a sample are requested before earlier words were answered (`bus_ahead`), if
-- the bus accepts an access before it answers it (`bus_next`). Up to four accesses are in flight; they are reported in
-- order. The first access that fails is reported at once and is the last one reported. The accesses in flight after it
-- are completed before any other access begins.
--
-- Writes, exclusive transactions and single accesses are issued one at a time.
--
-- A request for the kept word is handled like any other access, but does not reach the bus: the kept word is its
-- result.
--
-- After an access that timed out, the bus is released for `timeout` cycles, so that a late answer of the slave falls
-- into this time and is ignored. If several accesses were in flight, the bus is released for twice as long, because the
-- youngest may have been accepted just before. The timeout is reported at once, so only the next access waits.

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
    -- Cycles without an answer after which an access has failed, and cycles for which the bus is released then.
    timeout : positive := 1024;
    -- Whether the bus may accept an access before it has answered the previous one; if false, bus_next must be '0'.
    pipelined : boolean := true
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- Accesses of requests. request_more: another access of the same atomic transaction follows.
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
    -- Valid with request_done: no other access of the transaction is pending.
    request_last : out   std_logic;
    -- Accesses of samples.
    sample         : in    std_logic;
    sample_more    : in    std_logic;
    sample_address : in    std_logic_vector(address_bits - 1 downto 0);
    sample_granted : out   std_logic;
    sample_done    : out   std_logic;
    sample_strobe  : out   std_logic;
    sample_access  : out   std_logic;
    -- Valid with request_done and sample_done; read_data is stable until the next access ends.
    failure   : out   error_t;
    read_data : out   std_logic_vector(data_bits - 1 downto 0);
    -- Bus-independent interface: see `unity_link_core`.
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

  -- Maximum number of accesses in flight.
  constant most : positive := 4;

  type state_t is (state_idle, state_active, state_drain, state_told, state_rest);

  signal state      : state_t;
  signal for_sample : std_logic;
  -- The client's transaction has further accesses. exclusive: samples must not come between them.
  signal sample_lock  : std_logic;
  signal request_lock : std_logic;
  signal exclusive    : std_logic;
  signal timed_out    : std_logic;
  signal time_left    : unsigned(log2_ceil(timeout) downto 0);
  -- The transaction is a block read: its accesses may be requested before earlier ones are answered.
  signal ahead : std_logic;
  -- Number of accesses that the bus has accepted but not answered, now and after this edge, without the one being
  -- requested.
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

  -- The bus has accepted the present access, so the next one may be requested.
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
  -- bus_lock is '0' after a timeout, whatever the transaction, until the bus has been released long enough.
  bus_lock <= (sample_lock or request_lock or (ahead and is_asking)) and not timed_out;

  -- Hidden from synthesis tools, because some of them convert assertions to logic. (The port `failure` hides the
  -- severity level of that name, hence the full name below.)
  -- synthesis translate_off
  check_rules : process (clk) is

    variable block_runs : std_logic;

  begin

    if rising_edge(clk) then
      block_runs := ahead and to_std_logic(state = state_active) and not rst;
      -- Registers are unknown before the first reset: 'U' and 'X' violate no rule.
      assert (block_runs and not for_sample and not request_lock and request) /= '1'
        report "ul_bus_master: a request after the last access of a block, before that access is done"
        severity std.standard.failure;
      assert (block_runs and for_sample and not sample_lock and sample) /= '1'
        report "ul_bus_master: a sample after the last access of another, before that access is done"
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

    -- Release the bus for as long as the youngest access may take to be answered.

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

        -- Complete the accesses in flight after a failed one before any other access begins.
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
