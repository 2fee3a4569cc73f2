-- SPDX-License-Identifier: BSD-3-Clause
--
-- Reset at power-up and at a button: for 16 cycles after the FPGA was configured, and while `button` is '1'.
--
-- The count starts from the initial value of its register, which FPGAs that load their configuration from outside
-- honour.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library unity_link;

entity board_reset is
  port (
    -- Rising edges count.
    clk : in    std_logic;
    -- '1': reset; from a pin. Leave it open if there is none. Clock: none.
    button : in    std_logic := '0';
    -- For 16 cycles after the configuration, and while the button is held.
    rst : out   std_logic
  );
end entity board_reset;

architecture rtl of board_reset is

  signal button_seen : std_logic;

  -- vsg_off signal_007
  signal waited : unsigned(4 downto 0) := (others => '0');
-- vsg_on signal_007

begin

  rst <= not waited(waited'high);

  button_crossing : entity unity_link.ul_synchroniser
    port map (
      clk  => clk,
      d(0) => button,
      q(0) => button_seen
    );

  wait_a_while : process (clk) is
  begin

    if rising_edge(clk) then
      if button_seen = '1' then
        waited <= (others => '0');
      elsif waited(waited'high) = '0' then
        waited <= waited + 1;
      end if;
    end if;

  end process wait_a_while;

end architecture rtl;
