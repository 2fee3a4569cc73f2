-- SPDX-License-Identifier: BSD-3-Clause
--
-- All registers at the pins of an FT245: one per pin, and one per data pin for the enable of its driver.
--
-- All signals on the core's side are active high. `read`, `write`, `enable` (OE#) and `send_now` (SIWU#) set the levels
-- of their pins from the next edge on, and `drive` enables the data drivers from the next edge on. `rxf`, `txe` and
-- `data_seen` are the levels of the flags and data pins at the last edge.

library ieee;
  use ieee.std_logic_1164.all;

entity ul_ft245_pads is
  port (
    clk : in    std_logic;
    -- Asynchronous: `quiet` sets the strobes to their idle levels. `quiet_data` turns the data drivers off and clears
    -- the data sampled last, because in the pads of ECP5 and Gowin all registers of a pin share one clear.
    quiet      : in    std_logic;
    quiet_data : in    std_logic;
    -- Pins.
    data_in  : in    std_logic_vector(7 downto 0);
    data_out : out   std_logic_vector(7 downto 0);
    data_oe  : out   std_logic_vector(7 downto 0);
    rxf_n    : in    std_logic;
    txe_n    : in    std_logic;
    rd_n     : out   std_logic;
    wr_n     : out   std_logic;
    oe_n     : out   std_logic;
    siwu_n   : out   std_logic;
    -- Core.
    data      : in    std_logic_vector(7 downto 0);
    drive     : in    std_logic;
    read      : in    std_logic;
    write     : in    std_logic;
    enable    : in    std_logic;
    send_now  : in    std_logic;
    data_seen : out   std_logic_vector(7 downto 0);
    rxf       : out   std_logic;
    txe       : out   std_logic
  );
end entity ul_ft245_pads;

architecture rtl of ul_ft245_pads is

  -- From the highest bit: RD#, WR#, OE#, SIWU#.
  signal strobes   : std_logic_vector(3 downto 0);
  signal strobes_n : std_logic_vector(3 downto 0);
  signal rests     : std_logic;
  -- Polarity of the pads: '1' turns a driver off.
  signal data_off : std_logic_vector(7 downto 0);
  signal rxf_no   : std_logic;
  signal txe_no   : std_logic;

begin

  strobes                    <= not (read & write & enable & send_now);
  (rd_n, wr_n, oe_n, siwu_n) <= strobes_n;
  rests                      <= not drive;
  data_oe                    <= not data_off;
  rxf                        <= not rxf_no;
  txe                        <= not txe_no;

  each_strobe : for pin in strobes'range generate

    strobe : entity work.ul_pad_output
      port map (
        clk   => clk,
        quiet => quiet,
        d     => strobes(pin),
        q     => strobes_n(pin)
      );

  end generate each_strobe;

  each_data_pin : for pin in 0 to 7 generate

    value_out : entity work.ul_pad_output
      port map (
        clk   => clk,
        quiet => quiet_data,
        d     => data(pin),
        q     => data_out(pin)
      );

    driver : entity work.ul_pad_output
      port map (
        clk   => clk,
        quiet => quiet_data,
        d     => rests,
        q     => data_off(pin)
      );

    value_in : entity work.ul_pad_input
      port map (
        clk   => clk,
        quiet => quiet_data,
        d     => data_in(pin),
        q     => data_seen(pin)
      );

  end generate each_data_pin;

  receive_flag : entity work.ul_pad_input
    port map (
      clk   => clk,
      quiet => '0',
      d     => rxf_n,
      q     => rxf_no
    );

  transmit_flag : entity work.ul_pad_input
    port map (
      clk   => clk,
      quiet => '0',
      d     => txe_n,
      q     => txe_no
    );

end architecture rtl;
