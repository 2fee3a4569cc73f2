-- SPDX-License-Identifier: BSD-3-Clause
--
-- When to have a short packet sent at once (docs/protocol.md, "Send-immediate"): watches the bytes that leave and what
-- is still coming.
--
-- The mark beside the last byte of a frame says what its sender wants: `flush_now` pulses `flush` behind that byte,
-- `flush_when_idle` as soon as nothing is on its way any more, no request either. A request that has begun to arrive
-- counts as on its way: its answer takes the bytes that wait along.

library ieee;
  use ieee.std_logic_1164.all;

library work;
  use work.unity_link_pkg.all;

entity ul_send_immediate is
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- A byte with this mark goes to the physical layer.
    left : in    std_logic;
    mark : in    flush_mark_t;
    -- A byte, a request or an answer is somewhere in the gateway.
    active : in    std_logic;
    -- One cycle: send now what was given to the physical layer so far.
    flush : out   std_logic
  );
end entity ul_send_immediate;

architecture rtl of ul_send_immediate is

  -- What left in the cycle before: a FIFO's memory is slow to show it.
  signal has_left : std_logic;
  signal its_mark : flush_mark_t;
  signal waiting  : std_logic;

begin

  main : process (clk) is
  begin

    if rising_edge(clk) then
      has_left <= left;
      its_mark <= mark;
      flush    <= '0';
      if has_left = '1' and its_mark = flush_now then
        flush   <= '1';
        waiting <= '0';
      elsif has_left = '1' and its_mark = flush_when_idle then
        waiting <= '1';
      elsif waiting = '1' and active = '0' then
        flush   <= '1';
        waiting <= '0';
      end if;

      if rst = '1' then
        has_left <= '0';
        its_mark <= flush_none;
        flush    <= '0';
        waiting  <= '0';
      end if;
    end if;

  end process main;

end architecture rtl;
