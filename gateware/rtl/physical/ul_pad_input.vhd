-- SPDX-License-Identifier: BSD-3-Clause
--
-- The register at an input pin, which samples the pin at every edge; no other logic reads the pin.
--
-- This architecture is portable, like that of `ul_pad_output`; the files of gateware/pads replace it for one vendor
-- each.

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

architecture rtl of ul_pad_input is

begin

  take : process (clk, quiet) is
  begin

    if quiet = '1' then
      q <= '1';
    elsif rising_edge(clk) then
      q <= d;
    end if;

  end process take;

end architecture rtl;
