-- SPDX-License-Identifier: BSD-3-Clause
--
-- Signals from another clock, or from no clock at all, taken into this one: each bit through a row of registers with
-- nothing between them, so that a register that was caught by a change has a whole cycle to decide.
--
-- The bits know nothing of each other: what changes together comes out over two cycles. So a number may only pass in
-- Gray code, and with the delays of its bits bounded (gateware/constraints has the files).
--
-- `meta` is the register that meets the other clock; every tool is told by attributes what it is, so that none of the
-- row is shared, moved, or made a shift register of: Xilinx (UG912: ASYNC_REG, SHREG_EXTRACT, KEEP), Intel (a
-- QSF assignment in the source), Lattice and Gowin (syn_preserve, syn_srlstyle, syn_keep). Constraints find it by its
-- name.

library ieee;
  use ieee.std_logic_1164.all;

entity ul_synchroniser is
  generic (
    -- At least 1: signals, which know nothing of each other.
    width : positive := 1;
    -- At least 1: registers in a row. One is enough only behind a register that is the first itself, as in a pad.
    stages : positive := 2;
    -- '0', '1': what comes out during a reset.
    idle : std_logic := '0'
  );
  port (
    -- The clock into which the signals are taken.
    clk : in    std_logic;
    -- Synchronous, active high.
    rst : in    std_logic := '0';
    -- The signals as they come. Clock: none.
    d : in    std_logic_vector(width - 1 downto 0);
    -- The same, in step with clk.
    q : out   std_logic_vector(width - 1 downto 0)
  );
end entity ul_synchroniser;

architecture rtl of ul_synchroniser is

  type row_t is array (natural range <>) of std_logic_vector(width - 1 downto 0);

  signal meta    : std_logic_vector(width - 1 downto 0);
  signal settled : row_t(1 to stages);

  attribute async_reg        : string;
  attribute shreg_extract    : string;
  attribute keep             : string;
  attribute syn_keep         : boolean;
  attribute syn_preserve     : boolean;
  attribute syn_srlstyle     : string;
  attribute altera_attribute : string;

  attribute async_reg of meta, settled        : signal is "TRUE";
  attribute shreg_extract of meta, settled    : signal is "NO";
  attribute keep of meta, settled             : signal is "TRUE";
  attribute syn_keep of meta, settled         : signal is true;
  attribute syn_preserve of meta, settled     : signal is true;
  attribute syn_srlstyle of meta, settled     : signal is "registers";
  attribute altera_attribute of meta, settled : signal is
    "-name SYNCHRONIZER_IDENTIFICATION FORCED; -name DONT_MERGE_REGISTER ON; -name PRESERVE_REGISTER ON";

begin

  -- The first one again, so that there may be none behind it.
  settled(1) <= meta;
  q          <= settled(stages);

  first : process (clk) is
  begin

    if rising_edge(clk) then
      meta <= d;
      if rst = '1' then
        meta <= (others => idle);
      end if;
    end if;

  end process first;

  behind_it : for stage in 2 to stages generate

    settle : process (clk) is
    begin

      if rising_edge(clk) then
        settled(stage) <= settled(stage - 1);
        if rst = '1' then
          settled(stage) <= (others => idle);
        end if;
      end if;

    end process settle;

  end generate behind_it;

end architecture rtl;
