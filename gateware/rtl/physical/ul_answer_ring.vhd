-- SPDX-License-Identifier: BSD-3-Clause
--
-- Gathers frames from the core into datagrams until they can be sent.
--
-- The present datagram has `whole` bytes of whole frames, all for one host: the opener of the session or the requester
-- without a session. `close` finishes it: the next datagram begins, and the bytes of the finished one can be read. The
-- last byte of a frame that no longer fits, and the first byte of a frame for the other host, wait until then. A frame
-- for which there is no host is dropped.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_compact_pkg.all;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_answer_ring is
  generic (
    -- A power of two: bytes.
    depth : positive := 2048;
    -- Maximum number of frame bytes in a datagram.
    most : positive := 1378
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- Bytes from the core.
    in_data  : in    std_logic_vector(7 downto 0);
    in_valid : in    std_logic;
    in_ready : out   std_logic;
    -- has_session: a session exists. asking: answers go to the requester, and only samples belong to the session.
    has_session : in    std_logic;
    asking      : in    std_logic;
    -- whole: bytes of the present datagram. to_asking: the datagram is for the requester. close: finish the datagram.
    whole     : out   unsigned(log2_ceil(depth) - 1 downto 0);
    to_asking : out   std_logic;
    close     : in    std_logic;
    -- The ring has no bytes at all.
    empty     : out   std_logic;
    out_data  : out   std_logic_vector(7 downto 0);
    out_ready : in    std_logic
  );
end entity ul_answer_ring;

architecture rtl of ul_answer_ring is

  subtype pointer_t is unsigned(log2_ceil(depth) - 1 downto 0);

  -- Addresses in the ring: of the next byte, of the first byte of the present datagram, and after its last whole frame.
  signal written  : pointer_t;
  signal begin_at : pointer_t;
  signal end_at   : pointer_t;
  -- The present datagram has at least one whole frame.
  signal has_whole  : std_logic;
  signal full       : std_logic;
  signal too_many   : std_logic;
  signal ring_empty : std_logic;
  signal line_start : std_logic;
  signal dropping   : std_logic;
  signal kept_for   : std_logic;
  signal for_asking : std_logic;
  signal for_nobody : std_logic;
  signal is_end     : std_logic;
  signal waits      : std_logic;
  signal take       : std_logic;
  signal write      : std_logic;

begin

  is_end <= to_std_logic(in_data = character_lf or in_data = compact_end);
  -- Answers to requests without a session are text; samples begin with P, or are in compact form.
  for_asking <= asking and not (has_session and to_std_logic(in_data = x"50" or in_data = compact_start));
  for_nobody <= not for_asking and not has_session;
  waits      <= full or (is_end and too_many)
                or (line_start and not for_nobody and has_whole and (for_asking xor kept_for));
  take       <= in_valid and not waits;
  in_ready   <= not waits;
  write      <= take and not dropping and not (line_start and for_nobody);
  whole      <= end_at - begin_at;
  to_asking  <= kept_for;

  byte_ring_inst : entity work.ul_byte_ring
    generic map (
      depth => depth
    )
    port map (
      clk        => clk,
      rst        => rst,
      write      => write,
      write_data => in_data,
      full       => full,
      written    => written,
      out_data   => out_data,
      out_valid  => open,
      out_ready  => out_ready,
      empty      => ring_empty
    );

  control : process (clk) is
  begin

    if rising_edge(clk) then
      if close = '1' then
        begin_at  <= end_at;
        has_whole <= '0';
      end if;
      if write = '1' then
        if line_start = '1' then
          kept_for <= for_asking;
        end if;
        if is_end = '1' then
          end_at    <= written + 1;
          has_whole <= '1';
        end if;
      end if;
      if take = '1' then
        line_start <= is_end;
        dropping   <= (dropping or (line_start and for_nobody)) and not is_end;
      end if;

      -- Registered, so it is one cycle late; the comparison is early by one byte to make up for that.
      too_many <= has_whole and not close and to_std_logic(written - begin_at >= most - 1);
      empty    <= ring_empty;

      if rst = '1' then
        begin_at   <= (others => '0');
        end_at     <= (others => '0');
        has_whole  <= '0';
        too_many   <= '0';
        line_start <= '1';
        dropping   <= '0';
        kept_for   <= '0';
        empty      <= '1';
      end if;
    end if;

  end process control;

end architecture rtl;
