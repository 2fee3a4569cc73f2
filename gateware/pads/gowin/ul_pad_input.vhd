-- SPDX-License-Identifier: BSD-3-Clause
--
-- `ul_pad_input` for Gowin's FPGAs, as `ul_pad_output` there: "Place input register to IOB", `--vopt ireg_in_iob`.

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
