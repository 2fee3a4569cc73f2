-- SPDX-License-Identifier: BSD-3-Clause
--
-- Bus wrapper: the bus-independent interface of `unity_link_core` as a Wishbone B4 master, classic or pipelined.
--
-- Nothing is registered here: a classic slave that answers in the same cycle costs no wait state. `cyc` stands over
-- all accesses of one atomic transaction. An access that timed out ends by taking back `cyc`, which Wishbone allows at
-- any time. No tag says which access an answer belongs to: one without an access is not looked at, and `ul_bus_master`
-- leaves a slave that is late time for it.
--
-- An access answered by `rty` has not been made: it is repeated, after a cycle without it, until the slave takes it or
-- the core gives it up. In that cycle `cyc` falls as well, so that another master may have the bus, but not in the
-- middle of an atomic transaction.

library ieee;
  use ieee.std_logic_1164.all;

entity ul_wishbone_master is
  generic (
    data_bits    : positive := 32;
    address_bits : positive := 8;
    pipelined    : boolean  := false
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- Bus-independent interface.
    bus_request    : in    std_logic;
    bus_write      : in    std_logic;
    bus_lock       : in    std_logic;
    bus_address    : in    std_logic_vector(address_bits - 1 downto 0);
    bus_write_data : in    std_logic_vector(data_bits - 1 downto 0);
    bus_read_data  : out   std_logic_vector(data_bits - 1 downto 0);
    bus_done       : out   std_logic;
    bus_error      : out   std_logic;
    -- Wishbone.
    cyc   : out   std_logic;
    stb   : out   std_logic;
    we    : out   std_logic;
    sel   : out   std_logic_vector((data_bits + 7) / 8 - 1 downto 0);
    adr   : out   std_logic_vector(address_bits - 1 downto 0);
    dat_o : out   std_logic_vector(data_bits - 1 downto 0);
    dat_i : in    std_logic_vector(data_bits - 1 downto 0);
    ack   : in    std_logic;
    err   : in    std_logic;
    rty   : in    std_logic;
    stall : in    std_logic
  );
end entity ul_wishbone_master;

architecture rtl of ul_wishbone_master is

  -- The cycle after `rty`.
  signal sent_away : std_logic;
  -- The access is the slave's: it has not been sent away, and a pipelined slave has taken it (before, or now).
  signal asks     : std_logic;
  signal answered : std_logic;
  signal taken    : std_logic;
  signal takes    : std_logic;

begin

  asks  <= bus_request and not sent_away;
  cyc   <= asks or bus_lock;
  stb   <= asks and not taken;
  we    <= bus_write;
  sel   <= (others => '1');
  adr   <= bus_address;
  dat_o <= bus_write_data;

  bus_read_data <= dat_i;
  bus_error     <= err;
  bus_done      <= asks and takes and answered;

  answered <= ack or err;

  main : process (clk) is
  begin

    if rising_edge(clk) then
      sent_away <= asks and takes and rty and not answered;

      if rst = '1' then
        sent_away <= '0';
      end if;
    end if;

  end process main;

  classic : if not pipelined generate

    taken <= '0';
    takes <= '1';

  end generate classic;

  with_pipeline : if pipelined generate

    takes <= taken or not stall;

    pipeline : process (clk) is
    begin

      if rising_edge(clk) then
        taken <= asks and takes and not (answered or rty);

        if rst = '1' then
          taken <= '0';
        end if;
      end if;

    end process pipeline;

  end generate with_pipeline;

end architecture rtl;
