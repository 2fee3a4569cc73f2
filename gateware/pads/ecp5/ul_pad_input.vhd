-- SPDX-License-Identifier: BSD-3-Clause
--
-- `ul_pad_input` with the pad cells of Lattice's ECP5. The pad's delay cell is in front of the register: without it the
-- register needs a hold time of 3.3 ns (docs/gateware.md has the budget), and the chips hold their outputs for only 0
-- or 1 ns. Lattice's tools use 59 steps of 25 ps for a hold time of 0 (SCLK_ZEROHOLD). The further steps up to 127 fit
-- into the setup budget.

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

architecture ecp5 of ul_pad_input is

  component delayg is
    generic (
      del_mode  : string;
      del_value : integer
    );
    port (
      a : in    std_logic;
      z : out   std_logic
    );
  end component delayg;

  component ifs1p3bx is
    port (
      pd   : in    std_logic;
      d    : in    std_logic;
      sp   : in    std_logic;
      sclk : in    std_logic;
      q    : out   std_logic
    );
  end component ifs1p3bx;

  signal later : std_logic;

begin

  -- vsg_off instantiation_034

  pad_delay : component delayg
    generic map (
      del_mode  => "USER_DEFINED",
      del_value => 127
    )
    port map (
      a => d,
      z => later
    );

  pad_register : component ifs1p3bx
    port map (
      pd   => quiet,
      d    => later,
      sp   => '1',
      sclk => clk,
      q    => q
    );

-- vsg_on instantiation_034

end architecture ecp5;
