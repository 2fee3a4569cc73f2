-- SPDX-License-Identifier: BSD-3-Clause
--
-- `ul_pad_output` for Gowin FPGAs. The tool moves the register into the pad: with "Place output register to IOB" in
-- Gowin EDA, and `--vopt oreg_in_iob` in nextpnr. nextpnr prints no message if it leaves the register in the fabric;
-- docs/gateware.md has the observations.

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

architecture gowin of ul_pad_output is

  component dffp is
    port (
      q      : out   std_logic;
      d      : in    std_logic;
      clk    : in    std_logic;
      preset : in    std_logic
    );
  end component dffp;

begin

  -- vsg_off instantiation_034

  pad_register : component dffp
    port map (
      q      => q,
      d      => d,
      clk    => clk,
      preset => quiet
    );

-- vsg_on instantiation_034

end architecture gowin;
