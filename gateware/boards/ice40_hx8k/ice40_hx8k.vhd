-- SPDX-License-Identifier: BSD-3-Clause
--
-- Unity-Link on Lattice's iCE40-HX8K Breakout Board (iCE40HX8K-B-EVN): a UART on its USB port at 3 MBd without flow
-- control.
--
-- The second channel of the board's FT2232H is a UART: on Linux /dev/ttyUSB1. The clock is the board's 12 MHz
-- oscillator. 3 MBd are a quarter of it, the highest rate of `ul_uart`; so the design needs no PLL and no other vendor
-- primitive. The bus slave is `demo_slave`: type `W000000005A` and Enter in a terminal to light half of the LEDs.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library unity_link;

entity ice40_hx8k is
  port (
    clk_12mhz : in    std_logic;
    uart_rxd  : in    std_logic;
    uart_txd  : out   std_logic;
    leds      : out   std_logic_vector(7 downto 0)
  );
end entity ice40_hx8k;

architecture rtl of ice40_hx8k is

  signal rst          : std_logic;
  signal wb_cyc       : std_logic;
  signal wb_stb       : std_logic;
  signal wb_we        : std_logic;
  signal wb_adr       : std_logic_vector(7 downto 0);
  signal wb_to_slave  : std_logic_vector(31 downto 0);
  signal wb_to_master : std_logic_vector(31 downto 0);
  signal wb_ack       : std_logic;
  signal wb_err       : std_logic;

begin

  reset : entity work.board_reset
    port map (
      clk => clk_12mhz,
      rst => rst
    );

  gateway : entity unity_link.unity_link
    generic map (
      physical => "uart",
      clock_hz => 12_000_000,
      baud     => 3_000_000
    )
    port map (
      clk      => clk_12mhz,
      rst      => rst,
      uart_rxd => uart_rxd,
      uart_txd => uart_txd,
      wb_cyc   => wb_cyc,
      wb_stb   => wb_stb,
      wb_we    => wb_we,
      wb_adr   => wb_adr,
      wb_dat_o => wb_to_slave,
      wb_dat_i => wb_to_master,
      wb_ack   => wb_ack,
      wb_err   => wb_err
    );

  slave : entity work.demo_slave
    port map (
      clk      => clk_12mhz,
      rst      => rst,
      wb_cyc   => wb_cyc,
      wb_stb   => wb_stb,
      wb_we    => wb_we,
      wb_adr   => wb_adr,
      wb_dat_i => wb_to_slave,
      wb_dat_o => wb_to_master,
      wb_ack   => wb_ack,
      wb_err   => wb_err,
      leds     => leds
    );

end architecture rtl;
