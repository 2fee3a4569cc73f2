-- SPDX-License-Identifier: BSD-3-Clause
--
-- The Wishbone slave of the example boards: LEDs to see, a counter and a memory to measure with.
--
--   address 0    LEDs, read and write
--   address 1    counter of clock cycles, read only
--   80..FF       memory, 128 words
--
-- Accesses to all other addresses end with an error. Each access is answered in the next cycle, because the memory is
-- block RAM.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity demo_slave is
  port (
    clk      : in    std_logic;
    rst      : in    std_logic;
    wb_cyc   : in    std_logic;
    wb_stb   : in    std_logic;
    wb_we    : in    std_logic;
    wb_adr   : in    std_logic_vector(7 downto 0);
    wb_dat_i : in    std_logic_vector(31 downto 0);
    wb_dat_o : out   std_logic_vector(31 downto 0);
    wb_ack   : out   std_logic;
    wb_err   : out   std_logic;
    leds     : out   std_logic_vector(7 downto 0)
  );
end entity demo_slave;

architecture rtl of demo_slave is

  type memory_t is array (0 to 127) of std_logic_vector(31 downto 0);

  signal memory      : memory_t;
  signal memory_word : std_logic_vector(31 downto 0);
  signal other_word  : std_logic_vector(31 downto 0);
  signal from_memory : std_logic;
  signal access_now  : std_logic;
  signal cycles      : unsigned(31 downto 0);

begin

  -- In the cycle of ack or err, the strobe still belongs to the access that is being answered.
  access_now <= wb_cyc and wb_stb and not wb_ack and not wb_err;
  wb_dat_o   <= memory_word when from_memory = '1' else
                other_word;

  words : process (clk) is
  begin

    if rising_edge(clk) then
      if access_now = '1' and wb_we = '1' and wb_adr(7) = '1' then
        memory(to_integer(unsigned(wb_adr(6 downto 0)))) <= wb_dat_i;
      end if;
      memory_word <= memory(to_integer(unsigned(wb_adr(6 downto 0))));
    end if;

  end process words;

  answer : process (clk) is
  begin

    if rising_edge(clk) then
      cycles      <= cycles + 1;
      wb_ack      <= '0';
      wb_err      <= '0';
      from_memory <= wb_adr(7);
      other_word  <= (others => '0');

      if access_now = '1' then
        wb_ack <= '1';
        if wb_adr = x"00" then
          other_word(7 downto 0) <= leds;
          if wb_we = '1' then
            leds <= wb_dat_i(7 downto 0);
          end if;
        elsif wb_adr = x"01" and wb_we = '0' then
          other_word <= std_logic_vector(cycles);
        elsif wb_adr(7) = '0' then
          wb_ack <= '0';
          wb_err <= '1';
        end if;
      end if;

      if rst = '1' then
        cycles <= (others => '0');
        leds   <= (others => '0');
        wb_ack <= '0';
        wb_err <= '0';
      end if;
    end if;

  end process answer;

end architecture rtl;
