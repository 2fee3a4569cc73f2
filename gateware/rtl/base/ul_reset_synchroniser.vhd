-- SPDX-License-Identifier: BSD-3-Clause
--
-- Reset synchroniser: asserts the reset asynchronously, even while the clock is stopped, and deasserts it at an edge of
-- the clock, `stages` edges after the cause has ended.
--
-- Registers use `rst` as an asynchronous clear. Its assertion may come at any time; its deassertion comes from a
-- register of the same clock, so recovery time is met. The attributes are those of `ul_synchroniser`. `cause` reaches
-- only the clear inputs of the registers here, for which a tool needs a false path (gateware/constraints).

library ieee;
  use ieee.std_logic_1164.all;

entity ul_reset_synchroniser is
  generic (
    -- At least 2: registers in series.
    stages : positive := 3
  );
  port (
    -- Clock of the registers that rst resets.
    clk : in    std_logic;
    -- '1' requests a reset. It must come from a register, so that no glitch of combinational logic causes a reset.
    -- Clock: none.
    cause : in    std_logic;
    -- Asserted at once, and until `stages` edges of clk after the cause has ended.
    rst : out   std_logic
  );
end entity ul_reset_synchroniser;

architecture rtl of ul_reset_synchroniser is

  signal meta : std_logic_vector(stages - 1 downto 0);

  attribute async_reg        : string;
  attribute shreg_extract    : string;
  attribute keep             : string;
  attribute syn_keep         : boolean;
  attribute syn_preserve     : boolean;
  attribute syn_srlstyle     : string;
  attribute altera_attribute : string;

  attribute async_reg of meta        : signal is "TRUE";
  attribute shreg_extract of meta    : signal is "NO";
  attribute keep of meta             : signal is "TRUE";
  attribute syn_keep of meta         : signal is true;
  attribute syn_preserve of meta     : signal is true;
  attribute syn_srlstyle of meta     : signal is "registers";
  attribute altera_attribute of meta : signal is
    "-name SYNCHRONIZER_IDENTIFICATION FORCED; -name DONT_MERGE_REGISTER ON; -name PRESERVE_REGISTER ON";

begin

  assert stages >= 2
    report "ul_reset_synchroniser: stages is " & integer'image(stages) & ", expected 2 or more"
    severity failure;

  rst <= meta(meta'high);

  synchronise : process (clk, cause) is
  begin

    if cause = '1' then
      meta <= (others => '1');
    elsif rising_edge(clk) then
      meta <= meta(meta'high - 1 downto 0) & '0';
    end if;

  end process synchronise;

end architecture rtl;
