-- SPDX-License-Identifier: BSD-3-Clause
--
-- `ul_pad_input` for Gowin FPGAs. Their tools move the register into the pad, as for `ul_pad_output`: with "Place input
-- register to IOB" in Gowin EDA, and `--vopt ireg_in_iob` in nextpnr.

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

architecture gowin of ul_pad_input is

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
