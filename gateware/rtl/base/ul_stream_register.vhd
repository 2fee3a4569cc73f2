-- SPDX-License-Identifier: BSD-3-Clause
--
-- One register in a stream: cuts the path between two parts, costs one cycle of latency and none of throughput.
--
-- Block RAMs are slow to show what they read (5.7 ns of the 10 ns at 100 MHz on an ECP5): what comes out of a FIFO
-- passes one of these before anything is decided by it. The path of `ready` is not cut.

library ieee;
  use ieee.std_logic_1164.all;

entity ul_stream_register is
  generic (
    -- At least 1: bits of an entry.
    width : positive := 8
  );
  port (
    -- Rising edges count.
    clk : in    std_logic;
    -- Synchronous, active high, for one cycle or more.
    rst : in    std_logic;
    -- An entry: it has moved at the edge at which in_valid and in_ready are both '1'.
    in_data : in    std_logic_vector(width - 1 downto 0);
    -- An entry stands at in_data.
    in_valid : in    std_logic;
    -- There is room.
    in_ready : out   std_logic;
    -- The oldest entry.
    out_data : out   std_logic_vector(width - 1 downto 0);
    -- An entry stands at out_data.
    out_valid : out   std_logic;
    -- It is taken.
    out_ready : in    std_logic
  );
end entity ul_stream_register;

architecture rtl of ul_stream_register is

  signal full : std_logic;

begin

  in_ready  <= not full or out_ready;
  out_valid <= full;

  main : process (clk) is
  begin

    if rising_edge(clk) then
      if full = '0' or out_ready = '1' then
        full     <= in_valid;
        out_data <= in_data;
      end if;

      if rst = '1' then
        full     <= '0';
        out_data <= (others => '0');
      end if;
    end if;

  end process main;

end architecture rtl;
