-- SPDX-License-Identifier: BSD-3-Clause
--
-- One register stage in a stream: cuts the combinational path of data and `valid`, adds one cycle of latency, and keeps
-- the full throughput.
--
-- Block RAMs have a long clock-to-output delay (5.7 ns of the 10 ns at 100 MHz on an ECP5), so the output of a FIFO
-- passes such a register before any logic uses it. The path of `ready` is not cut.

library ieee;
  use ieee.std_logic_1164.all;

entity ul_stream_register is
  generic (
    -- At least 1: bits of an entry.
    width : positive := 8
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- Entry to store. It is transferred at the rising edge at which in_valid and in_ready are both '1'.
    in_data : in    std_logic_vector(width - 1 downto 0);
    -- in_data is valid.
    in_valid : in    std_logic;
    -- There is space for an entry.
    in_ready : out   std_logic;
    -- The oldest entry.
    out_data : out   std_logic_vector(width - 1 downto 0);
    -- out_data is valid.
    out_valid : out   std_logic;
    -- The reader accepts the entry.
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
