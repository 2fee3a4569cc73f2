-- SPDX-License-Identifier: BSD-3-Clause
--
-- Bus wrapper: the bus-independent interface of `unity_link_core` as a Wishbone B4 master, classic or pipelined.
--
-- Nothing is registered here: a classic slave that answers in the same cycle costs no wait state. `cyc` stands over all
-- accesses of one atomic transaction. An access that timed out ends by taking back `cyc`, which Wishbone allows at any
-- time; an answer that comes later is not looked at. A pipelined slave must forget what is under way when `cyc` falls.

library ieee;
  use ieee.std_logic_1164.all;

entity wishbone_master is
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
    stall : in    std_logic
  );
end entity wishbone_master;

architecture rtl of wishbone_master is

  -- A pipelined slave has taken the access and will answer.
  signal taken : std_logic;

begin

  cyc   <= bus_request or bus_lock;
  stb   <= bus_request and not taken;
  we    <= bus_write;
  sel   <= (others => '1');
  adr   <= bus_address;
  dat_o <= bus_write_data;

  bus_read_data <= dat_i;
  bus_error     <= err;

  classic : if not pipelined generate

    taken    <= '0';
    bus_done <= bus_request and (ack or err);

  end generate classic;

  with_pipeline : if pipelined generate

    bus_done <= bus_request and (ack or err) and (taken or not stall);

    main : process (clk) is
    begin

      if rising_edge(clk) then
        taken <= bus_request and (taken or not stall) and not (ack or err);

        if rst = '1' then
          taken <= '0';
        end if;
      end if;

    end process main;

  end generate with_pipeline;

end architecture rtl;
