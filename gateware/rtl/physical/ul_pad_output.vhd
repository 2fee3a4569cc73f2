-- SPDX-License-Identifier: BSD-3-Clause
--
-- The register at an output pin. It stores the level of the pin, with the polarity of the pin, and drives no other
-- logic.
--
-- This architecture is portable: the tool may place the register in the pad or in the fabric. It may also merge it with
-- an equal register, which keeps both out of their pads. The files of gateware/pads replace this file and instantiate
-- the vendor's own pad register.
--
-- While `quiet` is '1' the register is '1', the idle level of all pins of an FT245: the strobes are inactive, and the
-- data drivers (whose enables are active low here) are off.

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

architecture rtl of ul_pad_output is

begin

  hold : process (clk, quiet) is
  begin

    if quiet = '1' then
      q <= '1';
    elsif rising_edge(clk) then
      q <= d;
    end if;

  end process hold;

end architecture rtl;
