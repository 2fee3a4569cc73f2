-- SPDX-License-Identifier: BSD-3-Clause
--
-- The first register behind a pin, which takes what the pin shows at every edge; nothing else looks at the pin.
--
-- This one is portable, as `ul_pad_output` is; gateware/pads has files that take its place.

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
