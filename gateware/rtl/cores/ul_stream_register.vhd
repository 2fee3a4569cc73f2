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
    width : positive := 8
  );
  port (
    clk       : in    std_logic;
    rst       : in    std_logic;
    in_data   : in    std_logic_vector(width - 1 downto 0);
    in_valid  : in    std_logic;
    in_ready  : out   std_logic;
    out_data  : out   std_logic_vector(width - 1 downto 0);
    out_valid : out   std_logic;
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
