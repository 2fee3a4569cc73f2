-- SPDX-License-Identifier: BSD-3-Clause
--
-- `ul_pad_output` for the 7 series of Xilinx and what came after it: IOB has the tool move it into the pad, or say why
-- not.

library ieee;
  use ieee.std_logic_1164.all;

entity ul_pad_output is
  port (
    -- Rising edges count.
    clk : in    std_logic;
    -- '1': the pin rests at once, whatever clk does. Clock: none.
    quiet : in    std_logic;
    -- What the pin is to show from the next edge on.
    d : in    std_logic;
    -- To the pin.
    q : out   std_logic
  );
end entity ul_pad_output;

architecture xilinx of ul_pad_output is

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
