-- SPDX-License-Identifier: BSD-3-Clause
--
-- Replaces `ul_datalink_tx` if every frame is plain: adds CR LF after each body. See `ul_plain_rx`.

library ieee;
  use ieee.std_logic_1164.all;

library work;
  use work.unity_link_pkg.all;

entity ul_plain_tx is
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- Bodies; in_mark is valid with in_last.
    in_data   : in    std_logic_vector(7 downto 0);
    in_valid  : in    std_logic;
    in_ready  : out   std_logic;
    in_last   : in    std_logic;
    in_mark   : in    flush_mark_t;
    out_data  : out   std_logic_vector(7 downto 0);
    out_mark  : out   flush_mark_t;
    out_valid : out   std_logic;
    out_ready : in    std_logic;
    busy      : out   std_logic
  );
end entity ul_plain_tx;

architecture rtl of ul_plain_tx is

  type state_t is (state_body, state_cr, state_lf);

  signal state : state_t;
  signal mark  : flush_mark_t;

begin

  busy <= to_std_logic(state /= state_body);

  -- Bodies pass unchanged; in_ready is '0' while CR LF is output.
  in_ready  <= out_ready and to_std_logic(state = state_body);
  out_valid <= in_valid or to_std_logic(state /= state_body);
  out_data  <= in_data when state = state_body else
               character_cr when state = state_cr else
               character_lf;
  out_mark  <= mark when state = state_lf else
               flush_none;

  main : process (clk) is
  begin

    if rising_edge(clk) then
      if out_ready = '1' then

        case state is

          when state_body =>
            mark <= in_mark;
            if in_valid = '1' and in_last = '1' then
              state <= state_cr;
            end if;

          when state_cr =>
            state <= state_lf;

          when state_lf =>
            state <= state_body;

        end case;

      end if;

      if rst = '1' then
        state <= state_body;
        mark  <= flush_none;
      end if;
    end if;

  end process main;

end architecture rtl;
