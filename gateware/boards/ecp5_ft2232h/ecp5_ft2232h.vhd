-- SPDX-License-Identifier: BSD-3-Clause
--
-- Unity-Link on the open ECP5/FT2232HQ board (gildobjanschi/ECP5_BGA381_FT2232HQ_FIFO, rev. A): synchronous FT245.
--
-- The board has an ECP5-25 and an FT2232H; channel A is wired as a FIFO with all of its pins. The gateway runs on the
-- board's oscillator of 24.576 MHz. `ul_ft245_sync` crosses to the 60 MHz clock of the chip, which runs only while the
-- PC keeps the chip in synchronous mode (`ft232h://...` does). To use an FT232H module with another ECP5, only the .lpf
-- changes: CLKOUT must enter at a clock input (PCLKT).
--
-- The registers at the pins are the ECP5's pad registers: gateware/pads/ecp5 replaces the files of the same names in
-- gateware/rtl. The bus slave is `demo_slave`; the board has its first four LEDs.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library unity_link;

entity ecp5_ft2232h is
  generic (
    -- "ft245_sync" or "ft245" (asynchronous): the wiring is the same; the PC must select the same mode.
    physical : string := "ft245_sync"
  );
  port (
    clk_24576000   : in    std_logic;
    btn_reset      : in    std_logic;
    ft2232_reset_n : out   std_logic;
    fifo_clk       : in    std_logic;
    fifo_data      : inout std_logic_vector(7 downto 0);
    fifo_rxf_n     : in    std_logic;
    fifo_txe_n     : in    std_logic;
    fifo_rd_n      : out   std_logic;
    fifo_wr_n      : out   std_logic;
    fifo_oe_n      : out   std_logic;
    fifo_siwu      : out   std_logic;
    leds           : out   std_logic_vector(3 downto 0)
  );
end entity ecp5_ft2232h;

architecture rtl of ecp5_ft2232h is

  signal rst          : std_logic;
  signal ft_data_out  : std_logic_vector(7 downto 0);
  signal ft_data_oe   : std_logic_vector(7 downto 0);
  signal wb_cyc       : std_logic;
  signal wb_stb       : std_logic;
  signal wb_we        : std_logic;
  signal wb_adr       : std_logic_vector(7 downto 0);
  signal wb_to_slave  : std_logic_vector(31 downto 0);
  signal wb_to_master : std_logic_vector(31 downto 0);
  signal wb_ack       : std_logic;
  signal wb_err       : std_logic;
  signal slave_leds   : std_logic_vector(7 downto 0);

begin

  ft2232_reset_n <= '1';
  leds           <= slave_leds(3 downto 0);

  each_data_pin : for pin in fifo_data'range generate

    fifo_data(pin) <= ft_data_out(pin) when ft_data_oe(pin) = '1' else
                      'Z';

  end generate each_data_pin;

  reset : entity work.board_reset
    port map (
      clk    => clk_24576000,
      button => btn_reset,
      rst    => rst
    );

  gateway : entity unity_link.unity_link
    generic map (
      physical => physical,
      clock_hz => 24_576_000
    )
    port map (
      clk         => clk_24576000,
      rst         => rst,
      ft_clkout   => fifo_clk,
      ft_data_in  => fifo_data,
      ft_data_out => ft_data_out,
      ft_data_oe  => ft_data_oe,
      ft_rxf_n    => fifo_rxf_n,
      ft_txe_n    => fifo_txe_n,
      ft_rd_n     => fifo_rd_n,
      ft_wr_n     => fifo_wr_n,
      ft_oe_n     => fifo_oe_n,
      ft_siwu_n   => fifo_siwu,
      wb_cyc      => wb_cyc,
      wb_stb      => wb_stb,
      wb_we       => wb_we,
      wb_adr      => wb_adr,
      wb_dat_o    => wb_to_slave,
      wb_dat_i    => wb_to_master,
      wb_ack      => wb_ack,
      wb_err      => wb_err
    );

  slave : entity work.demo_slave
    port map (
      clk      => clk_24576000,
      rst      => rst,
      wb_cyc   => wb_cyc,
      wb_stb   => wb_stb,
      wb_we    => wb_we,
      wb_adr   => wb_adr,
      wb_dat_i => wb_to_slave,
      wb_dat_o => wb_to_master,
      wb_ack   => wb_ack,
      wb_err   => wb_err,
      leds     => slave_leds
    );

end architecture rtl;
