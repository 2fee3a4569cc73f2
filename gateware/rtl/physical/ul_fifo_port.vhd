-- SPDX-License-Identifier: BSD-3-Clause
--
-- Physical layer: none. The link's byte streams stand as ports, for whatever carries bytes inside the same chip: a soft
-- processor, a network stack, another clock domain behind a `ul_fifo_async`.
--
-- The medium's side names its streams by direction as the link sees them: `in` goes into the link. `in_lost` marks a
-- byte before which the medium lost some; a medium that loses none leaves it open. `out_flush` pulses in the cycle
-- after the one in which the last byte meant by `flush` has left, so it never overtakes one.

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

  -- Bytes pass in the cycle in which they are accepted, so all that were are out one cycle later.
  delay : process (clk) is
  begin

    if rising_edge(clk) then
      out_flush <= flush and not rst;
    end if;

  end process delay;

end architecture rtl;
