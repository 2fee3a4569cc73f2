-- SPDX-License-Identifier: BSD-3-Clause
--
-- `ul_pad_input` for the 7 series of Xilinx and later families. The attribute IOB makes the tool move the register into
-- the pad, or report why it does not.

library ieee;
  use ieee.std_logic_1164.all;

entity ul_pad_input is
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- '1' sets q to '1' at once, asynchronously to clk, as it does in ul_pad_output. Clock: none.
    quiet : in    std_logic;
    -- From the pin. Clock: none.
    d : in    std_logic;
    -- Level of the pin at the last rising edge of clk.
    q : out   std_logic
  );
end entity ul_pad_input;

architecture xilinx of ul_pad_input is

  component fdpe is
    port (
      q   : out   std_logic;
      c   : in    std_logic;
      ce  : in    std_logic;
      pre : in    std_logic;
      d   : in    std_logic
    );
  end component fdpe;

  attribute iob : string;

  attribute iob of pad_register : label is "TRUE";

begin

  -- vsg_off instantiation_034

  pad_register : component fdpe
    port map (
      q   => q,
      c   => clk,
      ce  => '1',
      pre => quiet,
      d   => d
    );

-- vsg_on instantiation_034

end architecture xilinx;
