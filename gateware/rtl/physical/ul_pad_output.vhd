-- SPDX-License-Identifier: BSD-3-Clause
--
-- The last register before a pin: it holds what the pin shows, with the pin's own polarity, and nothing else looks at
-- it.
--
-- This one is portable: the tool may take one in the pad, or one of the fabric, and may merge it with its like, which
-- keeps them all out of the pads. gateware/pads has files that take its place, in which it is the vendor's own.
--
-- While `quiet` is '1' it is '1', the rest of every pin of an FT245: a strobe that asks for nothing, a driver that is
-- off.

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
