-- SPDX-License-Identifier: BSD-3-Clause
--
-- Sends the bytes from an FT245 back: the pins of gateware/boards/ecp5_ft2232h, with only the two FT245 layers.

library ieee;
  use ieee.std_logic_1164.all;

library unity_link;

entity ft245_loopback is
  generic (
    synchronous : boolean := true
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
end entity ft245_loopback;

architecture rtl of ft245_loopback is

  signal rst       : std_logic;
  signal data_out  : std_logic_vector(7 downto 0);
  signal data_oe   : std_logic_vector(7 downto 0);
  signal loop_byte : std_logic_vector(7 downto 0);
  signal valid     : std_logic;
  signal ready     : std_logic;

begin

  ft2232_reset_n <= '1';
  leds           <= loop_byte(3 downto 0);

  each_data_pin : for pin in fifo_data'range generate

    fifo_data(pin) <= data_out(pin) when data_oe(pin) = '1' else
                      'Z';

  end generate each_data_pin;

  reset : entity work.board_reset
    port map (
      clk    => clk_24576000,
      button => btn_reset,
      rst    => rst
    );

  with_clock : if synchronous generate

    layer : entity unity_link.ul_ft245_sync
      port map (
        clk      => clk_24576000,
        rst      => rst,
        clkout   => fifo_clk,
        data_in  => fifo_data,
        data_out => data_out,
        data_oe  => data_oe,
        rxf_n    => fifo_rxf_n,
        txe_n    => fifo_txe_n,
        rd_n     => fifo_rd_n,
        wr_n     => fifo_wr_n,
        oe_n     => fifo_oe_n,
        siwu_n   => fifo_siwu,
        rx_data  => loop_byte,
        rx_lost  => open,
        rx_valid => valid,
        rx_ready => ready,
        tx_data  => loop_byte,
        tx_valid => valid,
        tx_ready => ready,
        flush    => valid
      );

  end generate with_clock;

  without_clock : if not synchronous generate

    layer : entity unity_link.ul_ft245_async
      generic map (
        clock_hz => 24_576_000
      )
      port map (
        clk      => clk_24576000,
        rst      => rst,
        data_in  => fifo_data,
        data_out => data_out,
        data_oe  => data_oe,
        rxf_n    => fifo_rxf_n,
        txe_n    => fifo_txe_n,
        rd_n     => fifo_rd_n,
        wr_n     => fifo_wr_n,
        siwu_n   => fifo_siwu,
        rx_data  => loop_byte,
        rx_lost  => open,
        rx_valid => valid,
        rx_ready => ready,
        tx_data  => loop_byte,
        tx_valid => valid,
        tx_ready => ready,
        flush    => valid
      );

    fifo_oe_n <= '1';

  end generate without_clock;

end architecture rtl;
