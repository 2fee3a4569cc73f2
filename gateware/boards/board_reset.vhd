-- SPDX-License-Identifier: BSD-3-Clause
--
-- Reset after configuration and by a button: for 16 cycles after the FPGA was configured, and while `button` is '1'.
--
-- The counter relies on the initial value of its register. FPGAs that load their configuration from an external memory
-- support initial values.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library unity_link;

entity board_reset is
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- '1' requests a reset; from a pin. Leave it open if the board has no button. Clock: none.
    button : in    std_logic := '0';
    -- '1' for 16 cycles after configuration and while the button is pressed.
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
