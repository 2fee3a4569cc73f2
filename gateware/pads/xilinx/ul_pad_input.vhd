-- SPDX-License-Identifier: BSD-3-Clause
--
-- `ul_pad_input` for the 7 series of Xilinx and what came after it: IOB has the tool move it into the pad, or say why
-- not.

library ieee;
  use ieee.std_logic_1164.all;

entity ul_pad_input is
  port (
    -- Rising edges count.
    clk : in    std_logic;
    -- '1': forget at once what was taken in, as in the output of the same pin. Clock: none.
    quiet : in    std_logic;
    -- From the pin. Clock: none.
    d : in    std_logic;
    -- What the pin showed at the last edge.
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
