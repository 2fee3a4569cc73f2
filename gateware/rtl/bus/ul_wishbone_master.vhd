-- SPDX-License-Identifier: BSD-3-Clause
--
-- Bus wrapper: converts the bus-independent interface of `unity_link_core` to a Wishbone B4 master, classic or
-- pipelined.
--
-- The classic wrapper has no registers in the path of an access: a slave that answers in the same cycle costs no wait
-- state. `cyc` is '1' during all accesses of one atomic transaction. An access that timed out ends by deasserting
-- `cyc`, which Wishbone allows at any time. Answers have no tag that identifies their access: an answer without a
-- pending access is ignored, and `ul_bus_master` leaves a late slave time for it.
--
-- A pipelined slave has up to four pending reads of one transaction (`bus_ahead`); it answers them in order. If it
-- answers one with `rty`, the wrapper buffers the answers after it, and repeats that read alone when all answers have
-- arrived.
--
-- An access answered with `rty` was not executed: it is repeated after a cycle without strobe, until the slave accepts
-- it or the core gives it up. In that cycle `cyc` is deasserted too, so that another master can get the bus, except in
-- the middle of an atomic transaction.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_wishbone_master is
  generic (
    -- 8 to 64: bits of a word.
    data_bits : positive := 32;
    -- 8 to 32: bits of a word address.
    address_bits : positive := 8;
    -- Whether the bus is pipelined Wishbone B4 instead of classic.
    pipelined : boolean := false
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- The core requests an access.
    bus_request : in    std_logic;
    -- '1' for a write, '0' for a read.
    bus_write : in    std_logic;
    -- '1' during all accesses of one atomic bus transaction.
    bus_lock : in    std_logic;
    -- '1' if further reads of the same transaction may be requested before this one is answered.
    bus_ahead : in    std_logic;
    -- The read is accepted; its answer comes later.
    bus_next : out   std_logic;
    -- Word address.
    bus_address : in    std_logic_vector(address_bits - 1 downto 0);
    -- Word to write.
    bus_write_data : in    std_logic_vector(data_bits - 1 downto 0);
    -- Valid with bus_done: the word read.
    bus_read_data : out   std_logic_vector(data_bits - 1 downto 0);
    -- The access ends at this rising edge.
    bus_done : out   std_logic;
    -- Valid with bus_done: '1' if the access failed.
    bus_error : out   std_logic;
    -- A bus transaction is in progress.
    cyc : out   std_logic;
    -- Strobe: an access is requested.
    stb : out   std_logic;
    -- '1' for a write, '0' for a read.
    we : out   std_logic;
    -- All '1': every access covers a whole word.
    sel : out   std_logic_vector((data_bits + 7) / 8 - 1 downto 0);
    -- Word address.
    adr : out   std_logic_vector(address_bits - 1 downto 0);
    -- Word to write.
    dat_o : out   std_logic_vector(data_bits - 1 downto 0);
    -- The word read, valid with ack.
    dat_i : in    std_logic_vector(data_bits - 1 downto 0);
    -- The access succeeded.
    ack : in    std_logic;
    -- The access failed.
    err : in    std_logic;
    -- The access was not executed; the master repeats it.
    rty : in    std_logic;
    -- Pipelined mode: the slave does not accept the access yet.
    stall : in    std_logic
  );
end entity ul_wishbone_master;

architecture rtl of ul_wishbone_master is

  signal answered : std_logic;

begin

  sel      <= (others => '1');
  we       <= bus_write;
  dat_o    <= bus_write_data;
  answered <= ack or err;

  classic : if not pipelined generate

    -- '1' in the cycle after `rty`.
    signal sent_away : std_logic;
    signal asks      : std_logic;

  begin

    asks          <= bus_request and not sent_away;
    cyc           <= asks or bus_lock;
    stb           <= asks;
    adr           <= bus_address;
    bus_read_data <= dat_i;
    bus_error     <= err;
    bus_done      <= asks and answered;
    bus_next      <= '0';

    retry : process (clk) is
    begin

      if rising_edge(clk) then
        sent_away <= asks and rty and not answered;

        if rst = '1' then
          sent_away <= '0';
        end if;
      end if;

    end process retry;

  end generate classic;

  with_pipeline : if pipelined generate

    -- Ring of accepted accesses whose results were not passed to the core yet. After an `rty`, the results of the later
    -- accesses are buffered until all are answered (gathers); then the access is repeated alone, and the buffered
    -- results are passed on in order (replays).

    type addresses_t is array (0 to 3) of std_logic_vector(address_bits - 1 downto 0);

    type words_t is array (0 to 3) of std_logic_vector(data_bits - 1 downto 0);

    signal addresses  : addresses_t;
    signal words      : words_t;
    signal failed     : std_logic_vector(3 downto 0);
    signal again      : std_logic_vector(3 downto 0);
    signal head       : unsigned(1 downto 0);
    signal middle     : unsigned(1 downto 0);
    signal tail       : unsigned(1 downto 0);
    signal held       : unsigned(2 downto 0);
    signal owed       : unsigned(2 downto 0);
    signal gathers    : std_logic;
    signal replays    : std_logic;
    signal sent_away  : std_logic;
    signal lives      : std_logic;
    signal on_bus     : std_logic;
    signal asks       : std_logic;
    signal asks_again : std_logic;
    signal strobe     : std_logic;
    signal takes      : std_logic;
    signal hit        : std_logic;
    signal sends_away : std_logic;
    signal is_kept    : std_logic;
    signal done       : std_logic;

  begin

    lives      <= bus_request or bus_lock;
    on_bus     <= bus_lock or (bus_request and not sent_away);
    asks       <= bus_request and not (gathers and not bus_ahead) and not replays
                  and (bus_ahead or to_std_logic(held = 0));
    asks_again <= replays and again(to_integer(head)) and to_std_logic(owed = 0) and not sent_away and lives;
    strobe     <= asks or asks_again;
    takes      <= strobe and not stall;
    hit        <= on_bus and (answered or rty) and (takes or to_std_logic(owed /= 0));
    sends_away <= on_bus and rty and not answered and (takes or to_std_logic(owed /= 0));
    is_kept    <= replays and not again(to_integer(head));
    done       <= (hit and answered and not gathers) or (is_kept and lives);

    cyc           <= on_bus;
    stb           <= strobe;
    adr           <= addresses(to_integer(head)) when replays = '1' else
                     bus_address;
    bus_next      <= asks and not stall and bus_ahead;
    bus_done      <= done;
    bus_read_data <= words(to_integer(head)) when is_kept = '1' else
                     dat_i;
    bus_error     <= failed(to_integer(head)) when is_kept = '1' else
                     err;

    main : process (clk) is

      variable still : unsigned(2 downto 0);
      variable owes  : unsigned(2 downto 0);

    begin

      if rising_edge(clk) then
        sent_away <= sends_away;
        still     := held;
        owes      := owed;
        if takes = '1' then
          owes := owes + 1;
        end if;
        if hit = '1' then
          owes := owes - 1;
        end if;
        if (asks and takes) = '1' then
          addresses(to_integer(tail)) <= bus_address;
          tail                        <= tail + 1;
          still                       := still + 1;
        end if;
        if done = '1' then
          head  <= head + 1;
          still := still - 1;
        end if;
        if (hit and gathers) = '1' then
          words(to_integer(middle))  <= dat_i;
          failed(to_integer(middle)) <= err;
          again(to_integer(middle))  <= sends_away;
          middle                     <= middle + 1;
        elsif sends_away = '1' then
          again(to_integer(head)) <= '1';
          middle                  <= head + 1;
          gathers                 <= not replays;
        end if;
        if gathers = '1' and owes = 0 and (asks and stall) = '0' then
          gathers <= '0';
          replays <= '1';
        end if;
        if still = 0 then
          replays <= '0';
        end if;
        held <= still;
        owed <= owes;

        if rst = '1' or lives = '0' then
          head      <= (others => '0');
          middle    <= (others => '0');
          tail      <= (others => '0');
          held      <= (others => '0');
          owed      <= (others => '0');
          gathers   <= '0';
          replays   <= '0';
          sent_away <= '0';
        end if;
      end if;

    end process main;

  end generate with_pipeline;

end architecture rtl;
