-- SPDX-License-Identifier: BSD-3-Clause
--
-- `ul_pad_output` in the pads of Lattice's ECP5: the cell has its place in one, or placing it is an error.

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

architecture ecp5 of ul_pad_output is

  component ofs1p3bx is
    port (
      pd   : in    std_logic;
      d    : in    std_logic;
      sp   : in    std_logic;
      sclk : in    std_logic;
      q    : out   std_logic
    );
  end component ofs1p3bx;

begin

  -- vsg_off instantiation_034

  pad_register : component ofs1p3bx
    port map (
      pd   => quiet,
      d    => d,
      sp   => '1',
      sclk => clk,
      q    => q
    );

-- vsg_on instantiation_034

end architecture ecp5;
