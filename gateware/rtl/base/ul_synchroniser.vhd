-- SPDX-License-Identifier: BSD-3-Clause
--
-- Synchroniser for signals from another clock or from no clock. Each bit passes a row of registers with no logic
-- between them, so that a register that became metastable has a whole cycle to settle.
--
-- The bits are synchronised independently: bits that change together may come out in two different cycles. So a number
-- may pass only in Gray code and with the delays of its bits bounded (gateware/constraints has the files).
--
-- `meta` is the register that samples the other clock domain. Attributes keep every tool from sharing or moving the
-- registers of the row, and from making a shift register of them: Xilinx (UG912: ASYNC_REG, SHREG_EXTRACT, KEEP), Intel
-- (a QSF assignment in the source), Lattice and Gowin (syn_preserve, syn_srlstyle, syn_keep). Constraints find `meta`
-- by its name.

library ieee;
  use ieee.std_logic_1164.all;

entity ul_synchroniser is
  generic (
    -- At least 1: number of signals, which are synchronised independently.
    width : positive := 1;
    -- At least 1: registers in series. One is enough only if the signal comes from a register that samples it with clk
    -- already, as in a pad.
    stages : positive := 2;
    -- '0', '1': level of the outputs during a reset.
    idle : std_logic := '0'
  );
  port (
    -- Clock to which the signals are synchronised.
    clk : in    std_logic;
    -- Synchronous reset, active high.
    rst : in    std_logic := '0';
    -- Asynchronous signals. Clock: none.
    d : in    std_logic_vector(width - 1 downto 0);
    -- The signals, synchronous to clk.
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

  -- `settled(1)` is `meta`, so that q is `meta` itself if `stages` is 1.
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
