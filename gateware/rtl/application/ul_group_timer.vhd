-- SPDX-License-Identifier: BSD-3-Clause
--
-- Determines which periodic groups are due: counts the divisor of each group down at every base tick.
--
-- At a tick, all groups pass a pipeline, one group per cycle: read the counter, register it, decrement it and write it
-- back. So the time from the tick to a group's `due` depends only on its number. A group that becomes due again while
-- it is still due has lost a sample; a second memory counts the lost samples of each group until the group is served.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_group_timer is
  generic (
    groups : positive := 16
  );
  port (
    clk     : in    std_logic;
    rst     : in    std_logic;
    tick    : in    std_logic;
    running : in    std_logic_vector(groups - 1 downto 0);
    -- Only while busy is '0': set writes the divisor of group `number` (0: not periodic); start makes the group due at
    -- the next tick.
    number  : in    unsigned(7 downto 0);
    set     : in    std_logic;
    divisor : in    std_logic_vector(15 downto 0);
    start   : in    std_logic;
    busy    : out   std_logic;
    -- Groups that are due, until they are cleared.
    due   : out   std_logic_vector(groups - 1 downto 0);
    clear : in    std_logic_vector(groups - 1 downto 0);
    -- lost: number of samples that a due group has lost, one cycle after lost_number, which must be valid in the cycle
    -- of `clear`. In a cycle with collides = '1', that group becomes due: it must not be cleared, and its losses cannot
    -- be read.
    lost_number : in    unsigned(7 downto 0);
    lost        : out   unsigned(7 downto 0);
    collides    : out   std_logic
  );
end entity ul_group_timer;

architecture rtl of ul_group_timer is

  constant index_bits : natural := maximum(log2_ceil(groups), 1);

  subtype index_t is unsigned(index_bits - 1 downto 0);

  type counters_t is array (0 to 2 ** index_bits - 1) of std_logic_vector(15 downto 0);

  type losses_t is array (0 to 2 ** index_bits - 1) of std_logic_vector(7 downto 0);

  -- A group's memory words are not used before the group was set and started: the initial values only avoid unknown
  -- values in simulation.
  -- vsg_off signal_007
  signal divisors : counters_t := (others => (others => '0'));
  signal counters : counters_t := (others => (others => '0'));
  signal losses   : losses_t   := (others => (others => '0'));
  -- vsg_on signal_007

  signal scanning      : std_logic;
  signal scan_index    : index_t;
  signal read_valid    : std_logic;
  signal read_index    : index_t;
  signal read_divisor  : std_logic_vector(15 downto 0);
  signal read_counter  : std_logic_vector(15 downto 0);
  signal read_losses   : std_logic_vector(7 downto 0);
  signal kept_valid    : std_logic;
  signal kept_index    : index_t;
  signal kept_divisor  : std_logic_vector(15 downto 0);
  signal kept_counter  : std_logic_vector(15 downto 0);
  signal kept_losses   : std_logic_vector(7 downto 0);
  signal lost_read     : std_logic_vector(7 downto 0);
  signal is_due        : std_logic;
  signal was_due       : std_logic;
  signal counts        : std_logic;
  signal write_counter : std_logic;
  signal write_index   : index_t;
  signal new_counter   : std_logic_vector(15 downto 0);
  signal new_losses    : std_logic_vector(7 downto 0);

begin

  busy <= scanning or read_valid or kept_valid or tick;
  lost <= unsigned(lost_read);

  counts  <= kept_valid and bit_at(running, kept_index) and to_std_logic(unsigned(kept_divisor) /= 0);
  is_due  <= counts and to_std_logic(unsigned(kept_counter) = 1);
  was_due <= bit_at(due, kept_index);

  collides <= kept_valid and to_std_logic(kept_index = lost_number(index_t'range));

  write_counter <= counts or start;
  write_index   <= kept_index when kept_valid = '1' else
                   number(index_t'range);
  new_counter   <= x"0001" when kept_valid = '0' else
                   kept_divisor when is_due = '1' else
                   std_logic_vector(unsigned(kept_counter) - 1);
  new_losses    <= std_logic_vector(unsigned(kept_losses) + 1) when was_due = '1' else
                   x"00";

  memories : process (clk) is
  begin

    if rising_edge(clk) then
      if set = '1' then
        divisors(to_integer(number(index_t'range))) <= divisor;
      end if;
      read_divisor <= divisors(to_integer(scan_index));

      if write_counter = '1' then
        counters(to_integer(write_index)) <= new_counter;
      end if;
      read_counter <= counters(to_integer(scan_index));

      if is_due = '1' then
        losses(to_integer(kept_index)) <= new_losses;
      end if;
      read_losses <= losses(to_integer(scan_index));
      lost_read   <= losses(to_integer(lost_number(index_t'range)));

      kept_divisor <= read_divisor;
      kept_counter <= read_counter;
      kept_losses  <= read_losses;
    end if;

  end process memories;

  scan : process (clk) is
  begin

    if rising_edge(clk) then
      if tick = '1' then
        scanning   <= '1';
        scan_index <= (others => '0');
      elsif scanning = '1' then
        scan_index <= scan_index + 1;
        if scan_index = groups - 1 then
          scanning <= '0';
        end if;
      end if;
      read_valid <= scanning;
      read_index <= scan_index;
      kept_valid <= read_valid;
      kept_index <= read_index;

      for index in due'range loop

        if is_due = '1' and kept_index = index then
          due(index) <= '1';
        elsif clear(index) = '1' then
          due(index) <= '0';
        end if;

      end loop;

      if rst = '1' then
        scanning   <= '0';
        scan_index <= (others => '0');
        read_valid <= '0';
        read_index <= (others => '0');
        kept_valid <= '0';
        kept_index <= (others => '0');
        due        <= (others => '0');
      end if;
    end if;

  end process scan;

end architecture rtl;
