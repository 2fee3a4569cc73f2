-- SPDX-License-Identifier: BSD-3-Clause
--
-- `ul_pad_output` with the pad register of Lattice's ECP5. The cell exists only in pads: if it does not fit there,
-- placing fails.

library ieee;
  use ieee.std_logic_1164.all;

entity ul_pad_output is
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- '1' sets the pin to its idle level '1' at once, asynchronously to clk. Clock: none.
    quiet : in    std_logic;
    -- Level of the pin from the next rising edge of clk on.
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
