-- Words 1, 2, 3, ... at the FIFO port of a generated gateway: some are stored before its group runs, others arrive one
-- by one or many at once. The frames from the gateway are printed, one on each line.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library std;
  use std.textio.all;

use work.logger_map.all;

entity fifo_bench is
end entity fifo_bench;

architecture test of fifo_bench is

  signal clk           : std_logic := '0';
  signal rst           : std_logic := '1';
  signal done          : boolean   := false;
  signal in_data       : std_logic_vector(7 downto 0);
  signal in_valid      : std_logic := '0';
  signal in_ready      : std_logic;
  signal out_data      : std_logic_vector(7 downto 0);
  signal out_valid     : std_logic;
  signal from_hardware : logger_from_hardware_t;
  signal to_hardware   : logger_to_hardware_t;
  signal made          : natural := 3;
  signal taken         : natural := 0;

begin

  clk <= not clk after 10 ns when not done;

  from_hardware.value       <= to_signed(taken + 1, 32);
  from_hardware.value_valid <= '1' when taken < made else '0';
  from_hardware.level       <= to_unsigned(made - taken, 8);

  gateway_inst : entity work.logger_gateway
    generic map (
      physical     => "fifo",
      offer_cycles => 512
    )
    port map (
      clk           => clk,
      rst           => rst,
      in_data       => in_data,
      in_valid      => in_valid,
      in_ready      => in_ready,
      out_data      => out_data,
      out_valid     => out_valid,
      out_ready     => '1',
      from_hardware => from_hardware,
      to_hardware   => to_hardware
    );

  take : process (clk) is
  begin

    if rising_edge(clk) and from_hardware.value_valid = '1' and to_hardware.value_ready = '1' then
      taken <= taken + 1;
    end if;

  end process take;

  print : process (clk) is
    variable text : line;
  begin

    if rising_edge(clk) and out_valid = '1' then
      if out_data = x"0D" then
        writeline(output, text);
      else
        write(text, character'val(to_integer(unsigned(out_data))));
      end if;
    end if;

  end process print;

  run : process is
    procedure send (text : string) is
    begin
      for index in text'range loop
        in_data  <= std_logic_vector(to_unsigned(character'pos(text(index)), 8));
        in_valid <= '1';
        wait until rising_edge(clk) and in_ready = '1';
      end loop;
      in_data  <= x"0D";
      wait until rising_edge(clk) and in_ready = '1';
      in_valid <= '0';
    end procedure send;
  begin

    wait for 200 ns;
    wait until rising_edge(clk);
    rst <= '0';
    -- Samples on the trigger, without timestamps, in plain frames.
    send("GS032200010120");
    send("GN03");
    wait for 60 us;
    for burst in 1 to 4 loop
      made <= made + burst * burst;
      wait for 40 us;
    end loop;
    send("R21");
    wait for 5 us;
    done <= true;
    wait;

  end process run;

end architecture test;
