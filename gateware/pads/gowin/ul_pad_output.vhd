-- SPDX-License-Identifier: BSD-3-Clause
--
-- `ul_pad_output` for Gowin's FPGAs. It is moved into the pad by the tool: "Place output register to IOB" in Gowin's
-- own, `--vopt oreg_in_iob` in nextpnr (which says nothing where it does not; docs/gateware.md has what was seen).

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
