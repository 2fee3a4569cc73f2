-- SPDX-License-Identifier: BSD-3-Clause
--
-- Physical layer without pins: the link's byte streams are ports, for any medium inside the same chip, such as a soft
-- processor, a network stack, or another clock domain through a `ul_fifo_async`.
--
-- The medium's ports are named by their direction as the link sees them: `in` is from the medium to the link. `in_lost`
-- marks a byte before which the medium lost others; leave it open if the medium loses none. `out_flush` pulses one
-- cycle after `flush`: all bytes accepted before have left by then, so the pulse never overtakes a byte.

library ieee;
  use ieee.std_logic_1164.all;

entity ul_fifo_port is
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- Medium.
    in_data   : in    std_logic_vector(7 downto 0);
    in_lost   : in    std_logic := '0';
    in_valid  : in    std_logic;
    in_ready  : out   std_logic;
    out_data  : out   std_logic_vector(7 downto 0);
    out_valid : out   std_logic;
    out_ready : in    std_logic;
    out_flush : out   std_logic;
    -- Core.
    rx_data  : out   std_logic_vector(7 downto 0);
    rx_lost  : out   std_logic;
    rx_valid : out   std_logic;
    rx_ready : in    std_logic;
    tx_data  : in    std_logic_vector(7 downto 0);
    tx_valid : in    std_logic;
    tx_ready : out   std_logic;
    flush    : in    std_logic
  );
end entity ul_fifo_port;

architecture rtl of ul_fifo_port is

begin

  rx_data   <= in_data;
  rx_lost   <= in_lost;
  rx_valid  <= in_valid;
  in_ready  <= rx_ready;
  out_data  <= tx_data;
  out_valid <= tx_valid;
  tx_ready  <= out_ready;

  -- A byte leaves in the cycle in which it is accepted, so one cycle of delay is enough for all bytes before the flush.
  delay : process (clk) is
  begin

    if rising_edge(clk) then
      out_flush <= flush and not rst;
    end if;

  end process delay;

end architecture rtl;
