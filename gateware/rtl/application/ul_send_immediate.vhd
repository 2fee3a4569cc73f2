-- SPDX-License-Identifier: BSD-3-Clause
--
-- Decides when the medium must send a short packet at once (docs/protocol.md, "Send-immediate"), from the bytes that
-- leave and from pending activity.
--
-- The mark beside the last byte of a frame has the wish of its sender: `flush_now` pulses `flush` after that byte;
-- `flush_when_idle` pulses it as soon as the gateway is idle. A request that has begun to arrive counts as activity:
-- its answer will be sent together with the waiting bytes.

library ieee;
  use ieee.std_logic_1164.all;

library work;
  use work.unity_link_pkg.all;

entity ul_send_immediate is
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- A byte with this mark is passed to the physical layer.
    left : in    std_logic;
    mark : in    flush_mark_t;
    -- The gateway has a byte, a request or an answer.
    active : in    std_logic;
    -- '1' for one cycle: send all bytes that were passed to the physical layer so far.
    flush : out   std_logic
  );
end entity ul_send_immediate;

architecture rtl of ul_send_immediate is

  -- left and mark of the cycle before; registered because the FIFO's memory has a long clock-to-output delay.
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
