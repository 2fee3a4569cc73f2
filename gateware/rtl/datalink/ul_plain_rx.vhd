-- SPDX-License-Identifier: BSD-3-Clause
--
-- Replaces `ul_datalink_rx` if the other end is a person and not a program: every line is a plain frame.
--
-- CR and LF both end a frame, there is no CRC, and the length is not limited (a line that is too long is malformed).
-- Together with `ul_plain_tx` it connects the application layer to a physical layer without a datalink layer
-- (`unity_link_core`, generic `checked_frames`).

library ieee;
  use ieee.std_logic_1164.all;

library work;
  use work.unity_link_pkg.all;

entity ul_plain_rx is
  port (
    clk      : in    std_logic;
    rst      : in    std_logic;
    in_data  : in    std_logic_vector(7 downto 0);
    in_lost  : in    std_logic;
    in_valid : in    std_logic;
    in_ready : out   std_logic;
    -- A character of a body; with out_last, the end of the frame, with error 09 or none.
    out_data  : out   std_logic_vector(7 downto 0);
    out_valid : out   std_logic;
    out_ready : in    std_logic;
    out_last  : out   std_logic;
    out_error : out   error_t;
    -- A frame has begun, and its end has not been output yet.
    busy : out   std_logic
  );
end entity ul_plain_rx;

architecture rtl of ul_plain_rx is

  signal begun : std_logic;
  signal lost  : std_logic;
  signal full  : std_logic;

begin

  in_ready  <= not full or out_ready;
  out_valid <= full;
  busy      <= begun or full;

  main : process (clk) is
  begin

    if rising_edge(clk) then
      if full = '0' or out_ready = '1' then
        full      <= '0';
        out_last  <= '0';
        out_error <= error_none;
        if in_valid = '1' then
          out_data <= in_data;
          if in_data = character_cr or in_data = character_lf then
            full     <= begun or in_lost;
            out_last <= '1';
            begun    <= '0';
            lost     <= '0';
            if lost = '1' or in_lost = '1' then
              out_error <= error_overflow;
            end if;
          else
            full  <= '1';
            begun <= '1';
            lost  <= lost or in_lost;
          end if;
        end if;
      end if;

      if rst = '1' then
        full      <= '0';
        begun     <= '0';
        lost      <= '0';
        out_last  <= '0';
        out_data  <= (others => '0');
        out_error <= error_none;
      end if;
    end if;

  end process main;

end architecture rtl;
