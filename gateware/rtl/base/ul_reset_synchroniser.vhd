-- SPDX-License-Identifier: BSD-3-Clause
--
-- A reset for a clock that it does not come from: it begins at once, also while that clock stands, and ends a few edges
-- of that clock after its cause, at one of them.
--
-- Registers take it asynchronously. Their recovery time is then kept, because its end leaves a register of their own
-- clock; its begin may come at any instant. The attributes are those of `ul_synchroniser`; what reaches the registers
-- here is no data but their clear, for which a tool needs a false path (gateware/constraints).

library ieee;
  use ieee.std_logic_1164.all;

entity ul_reset_synchroniser is
  generic (
    -- At least 2: registers in a row.
    stages : positive := 3
  );
  port (
    -- The clock of what is reset.
    clk : in    std_logic;
    -- '1': reset. Out of a register of its own, so that no hazard of logic is a reset. Clock: none.
    cause : in    std_logic;
    -- '1' at once, and until some edges of clk after the cause has ended.
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
