-- SPDX-License-Identifier: BSD-3-Clause
--
-- A memory with one write port and one registered read port, as in every vendor's block RAM.
--
-- All words are 0 after configuration; a reset does not change them. A read in the cycle of a write to the same address
-- returns the old or the new word, undefined which; no user of this memory relies on it.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_word_memory is
  generic (
    width : positive := 32;
    -- Words; a power of two, at least 2.
    depth : positive := 256
  );
  port (
    clk         : in    std_logic;
    write       : in    std_logic;
    write_index : in    unsigned(log2_ceil(depth) - 1 downto 0);
    write_data  : in    std_logic_vector(width - 1 downto 0);
    read_index  : in    unsigned(log2_ceil(depth) - 1 downto 0);
    -- The word at read_index of the cycle before.
    read_data : out   std_logic_vector(width - 1 downto 0)
  );
end entity ul_word_memory;

architecture rtl of ul_word_memory is

  type memory_t is array (0 to depth - 1) of std_logic_vector(width - 1 downto 0);

  -- vsg_off signal_007
  signal memory : memory_t := (others => (others => '0'));
  -- vsg_on signal_007

  -- For Yosys: no read uses a word in the cycle in which it is written, so Yosys need not add bypass logic.
  attribute no_rw_check : boolean;
  attribute no_rw_check of memory : signal is true;

begin

  main : process (clk) is
  begin

    if rising_edge(clk) then
      if write = '1' then
        memory(to_integer(write_index)) <= write_data;
      end if;
      read_data <= memory(to_integer(read_index));
    end if;

  end process main;

end architecture rtl;
