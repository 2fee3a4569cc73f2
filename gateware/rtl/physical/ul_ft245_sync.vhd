-- SPDX-License-Identifier: BSD-3-Clause
--
-- Physical layer: the synchronous FT245 FIFO of an FT232H or FT2232H: one byte in every cycle of its 60 MHz CLKOUT.
--
-- Pins. Each pin has a register in `ul_ft245_pads` that drives no other logic, so that a vendor's tool can place it in
-- the pad. docs/gateware.md derives the budget that this leaves of the 16.67 ns. The registers cost cycles: an event at
-- the pins is known one cycle later, and the reaction reaches the pins one cycle after that. So this file has copies of
-- the levels at the pins now (`rd_now`, `wr_now`) and at the last edge (`rd_was`, `wr_was`); the flags that are visible
-- now belong to the last edge. A byte has been transferred if RD# and RXF# (or WR# and TXE#) were both low at an edge;
-- bytes are counted by this condition only.
--
-- Reading while RXF# is high is harmless: the byte is dropped. A byte written while TXE# is high is refused, and when
-- this is known, the next byte is at the pins already. The chip refuses that byte too, because TXE# stays high for more
-- than one cycle (10 were measured; the datasheet gives no number). Both are then sent again, in order, from `ring`. If
-- a chip accepted the second byte nevertheless, that byte would arrive twice, the first time too early; the CRC detects
-- this. From then until the next reset, each byte is sent only after the one before it was accepted, at 30 MB/s.
--
-- Turnaround. OE# goes low one cycle after the data drivers are off, and RD# one cycle after OE#. In the other
-- direction: RD# high, OE# high, then one cycle in which neither side drives. A direction is kept until the other one
-- has bytes to transfer, and then for at most `burst` more bytes and those in flight. After `patience` cycles without a
-- transfer neither side drives, because another mode of the chip may use the same pins.
--
-- Clocks. CLKOUT runs only while the PC keeps the chip in synchronous mode. One FIFO in each direction crosses between
-- the two clocks. The clk domain polls the CLKOUT domain continuously. Without a reply for `silence` cycles of clk, all
-- pins go to their idle levels, until CLKOUT runs again. This neither loses nor duplicates a byte, unless CLKOUT
-- resumes at the very edge of clk at which the timeout expires. A reset is held for four cycles of clk on the chip's
-- side, so that the core's side is in reset when the chip's side leaves it; and the core's side stays in reset until
-- the chip's side reports that it was reset. So a reset without CLKOUT is remembered, and no byte from before the reset
-- survives.
--
-- `flush` passes the transmit FIFO as a marker between the bytes (bit 8). When the marker leaves the FIFO and the chip
-- has accepted the last byte before it, SIWU# goes low for 16 cycles of CLKOUT (267 ns; the chip requires 250 ns), and
-- no byte follows before its end. It then stays high for at least as long. A flush without a byte since the last flush
-- is dropped, because the chip's reaction is not documented.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_ft245_sync is
  generic (
    -- Powers of two, at least 16: bytes of the FIFOs between the chip's clock and clk, towards the core and from it.
    rx_depth : positive := 64;
    tx_depth : positive := 64;
    -- At least 1: maximum number of bytes transferred in one direction while the other direction is waiting.
    burst : positive := 256
  );
  port (
    -- The core's clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- CLKOUT, 60 MHz; it may be stopped.
    clkout : in    std_logic;
    -- Data pins, input. The board's top joins data_in, data_out and data_oe bit by bit at the pins. Clock: clkout.
    data_in : in    std_logic_vector(7 downto 0);
    -- Data pins, output. Clock: clkout.
    data_out : out   std_logic_vector(7 downto 0);
    -- '1' enables the driver of that data pin. Clock: clkout.
    data_oe : out   std_logic_vector(7 downto 0);
    -- RXF#: '0' if the chip has a byte. Clock: clkout.
    rxf_n : in    std_logic;
    -- TXE#: '0' if the chip accepts a byte. Clock: clkout.
    txe_n : in    std_logic;
    -- RD#, the read strobe. Clock: clkout.
    rd_n : out   std_logic;
    -- WR#, the write strobe. Clock: clkout.
    wr_n : out   std_logic;
    -- OE#: '0' enables the chip's data drivers. Clock: clkout.
    oe_n : out   std_logic;
    -- SIWU#: '0' makes the chip send its buffer at once. Clock: clkout.
    siwu_n : out   std_logic;
    -- Byte for the core. It is transferred at the rising edge at which rx_valid and rx_ready are both '1'.
    rx_data : out   std_logic_vector(7 downto 0);
    -- Valid with rx_data: '1' if bytes before this one were lost.
    rx_lost : out   std_logic;
    -- rx_data is valid.
    rx_valid : out   std_logic;
    -- The core accepts the byte.
    rx_ready : in    std_logic;
    -- Byte from the core.
    tx_data : in    std_logic_vector(7 downto 0);
    -- tx_data is valid.
    tx_valid : in    std_logic;
    -- This layer accepts the byte.
    tx_ready : out   std_logic;
    -- '1' for one cycle: pull SIWU# low when all bytes accepted so far have been written.
    flush : in    std_logic
  );
end entity ul_ft245_sync;

architecture rtl of ul_ft245_sync is

  constant siwu_time : positive := 16;
  -- In cycles of CLKOUT: more than TXE# is high within a stream.
  constant patience : positive := 16;
  -- In cycles of clk: longer than a poll and its reply take, and longer than SIWU# must be low, for clk of up to 250
  -- MHz.
  constant silence : positive := 64;

  -- Space for the bytes that still arrive after RD# was deasserted, and as much again for the cycles by which in_level
  -- is late.
  constant rx_reserve : positive := 6;

  -- One byte each: waiting for the pins, at the pins, not yet known to be accepted, and in flight to the pins.
  constant ring_depth : positive := 4;

  type state_t is (idle, writing, release_ours, reading, release_theirs);

  type ring_t is array (0 to ring_depth - 1) of std_logic_vector(7 downto 0);

  -- One bit more than an index of the ring, which distinguishes full from empty.
  subtype place_t is unsigned(2 downto 0);

  -- Domain of clk.
  signal core_rst       : std_logic;
  signal rst_request    : std_logic_vector(3 downto 0);
  signal up_seen        : std_logic;
  signal asked          : std_logic;
  signal answer_seen    : std_logic;
  signal silent_for     : natural range 0 to silence;
  signal driving_seen   : std_logic;
  signal hushed         : std_logic;
  signal hushed_data    : std_logic;
  signal rx_entry_valid : std_logic;
  signal unflushed      : std_logic;
  signal flush_wanted   : std_logic;
  signal tx_entry       : std_logic_vector(8 downto 0);
  signal tx_entry_valid : std_logic;
  signal tx_entry_ready : std_logic;
  signal tx_accept      : std_logic;

  -- Domain of CLKOUT.
  signal chip_rst   : std_logic;
  signal chip_up    : std_logic;
  signal answer     : std_logic;
  signal quiet      : std_logic;
  signal quiet_data : std_logic;
  signal state      : state_t;
  signal next_state : state_t;
  -- Levels at the pins from the next edge on; '1' is active.
  signal read_next   : std_logic;
  signal write_next  : std_logic;
  signal enable_next : std_logic;
  signal drive_next  : std_logic;
  -- Levels at the pins now, and at the last edge.
  signal driving : std_logic;
  signal rd_now  : std_logic;
  signal rd_was  : std_logic;
  signal wr_now  : std_logic;
  signal wr_was  : std_logic;
  -- Levels that the pins had at the last edge.
  signal rxf       : std_logic;
  signal txe       : std_logic;
  signal data_seen : std_logic_vector(7 downto 0);

  signal room         : std_logic;
  signal may_read     : std_logic;
  signal may_write    : std_logic;
  signal captured_one : std_logic;
  signal rx_level     : unsigned(log2_ceil(rx_depth) downto 0);
  signal wrote_last   : std_logic;
  signal moved        : natural range 0 to burst;
  signal idle_for     : natural range 0 to patience;
  signal bored        : std_logic;

  signal head       : std_logic_vector(8 downto 0);
  signal head_valid : std_logic;
  signal head_ready : std_logic;
  signal ring       : ring_t;
  signal out_byte   : std_logic_vector(7 downto 0);
  signal put_at     : place_t;
  signal send_at    : place_t;
  signal done_at    : place_t;
  signal ring_full  : std_logic;
  signal all_done   : std_logic;
  -- The byte written at the last edge directly follows a refused byte.
  signal behind_refused : std_logic;
  signal accepted       : std_logic;
  signal refused        : std_logic;
  signal one_by_one     : std_logic;

  signal siwu_low    : std_logic;
  signal siwu_cycles : natural range 0 to siwu_time;

begin

  assert rx_depth >= 16 and tx_depth >= 16
    report "ul_ft245_sync: rx_depth is " & integer'image(rx_depth) & " and tx_depth " & integer'image(tx_depth) &
           ", expected at least 16 each"
    severity failure;

  chip_reset : entity work.ul_reset_synchroniser
    port map (
      clk   => clkout,
      cause => rst_request(3),
      rst   => chip_rst
    );

  chip_is_up : process (clkout, chip_rst) is
  begin

    if chip_rst = '1' then
      chip_up <= '0';
    elsif rising_edge(clkout) then
      chip_up <= '1';
    end if;

  end process chip_is_up;

  up_crossing : entity work.ul_synchroniser
    port map (
      clk  => clk,
      rst  => rst_request(3),
      d(0) => chip_up,
      q(0) => up_seen
    );

  core_reset : process (clk) is
  begin

    if rising_edge(clk) then
      rst_request <= rst_request(2 downto 0) & '0';
      core_rst    <= rst_request(3) or not up_seen;
      if rst = '1' then
        rst_request <= (others => '1');
        core_rst    <= '1';
      end if;
    end if;

  end process core_reset;

  question_crossing : entity work.ul_synchroniser
    port map (
      clk  => clkout,
      d(0) => asked,
      q(0) => answer
    );

  answer_crossing : entity work.ul_synchroniser
    port map (
      clk  => clk,
      d(0) => answer,
      q(0) => answer_seen
    );

  listen : process (clk) is
  begin

    if rising_edge(clk) then
      if answer_seen = asked then
        asked      <= not asked;
        silent_for <= 0;
        if core_rst = '0' then
          hushed      <= '0';
          hushed_data <= '0';
        end if;
      elsif silent_for /= silence then
        silent_for <= silent_for + 1;
      elsif hushed = '0' then
        hushed      <= '1';
        hushed_data <= driving_seen;
      end if;

      if rst = '1' then
        asked       <= '0';
        silent_for  <= 0;
        hushed      <= '1';
        hushed_data <= '1';
      end if;
    end if;

  end process listen;

  driving_crossing : entity work.ul_synchroniser
    port map (
      clk  => clk,
      d(0) => driving,
      q(0) => driving_seen
    );

  -- `hushed` is '1' during all of chip_rst, too. The data pins are only cleared if this side drove them: otherwise
  -- their registers contain the byte received last.
  chip_quiet : entity work.ul_reset_synchroniser
    port map (
      clk   => clkout,
      cause => hushed,
      rst   => quiet
    );

  chip_quiet_data : entity work.ul_reset_synchroniser
    port map (
      clk   => clkout,
      cause => hushed_data,
      rst   => quiet_data
    );

  rx_fifo : entity work.ul_fifo_async
    generic map (
      width => 8,
      depth => rx_depth
    )
    port map (
      in_clk    => clkout,
      in_rst    => chip_rst,
      in_data   => data_seen,
      in_valid  => captured_one,
      in_ready  => open,
      in_level  => rx_level,
      out_clk   => clk,
      out_rst   => core_rst,
      out_data  => rx_data,
      out_valid => rx_entry_valid,
      out_ready => rx_ready
    );

  rx_valid <= rx_entry_valid and not core_rst;
  rx_lost  <= '0';

  tx_fifo : entity work.ul_fifo_async
    generic map (
      width => 9,
      depth => tx_depth
    )
    port map (
      in_clk    => clk,
      in_rst    => core_rst,
      in_data   => tx_entry,
      in_valid  => tx_entry_valid,
      in_ready  => tx_entry_ready,
      in_level  => open,
      out_clk   => clkout,
      out_rst   => chip_rst,
      out_data  => head,
      out_valid => head_valid,
      out_ready => head_ready
    );

  tx_entry       <= flush_wanted & tx_data;
  tx_entry_valid <= (flush_wanted or tx_valid) and not core_rst;
  tx_accept      <= tx_entry_ready and not flush_wanted and not core_rst;
  tx_ready       <= tx_accept;

  mark_flush : process (clk) is
  begin

    if rising_edge(clk) then
      if tx_entry_ready = '1' then
        flush_wanted <= '0';
      end if;
      if tx_valid = '1' and tx_accept = '1' then
        unflushed <= '1';
      end if;
      if flush = '1' and (unflushed = '1' or (tx_valid = '1' and tx_accept = '1')) then
        unflushed    <= '0';
        flush_wanted <= '1';
      end if;

      if core_rst = '1' then
        flush_wanted <= '0';
        unflushed    <= '0';
      end if;
    end if;

  end process mark_flush;

  pins : entity work.ul_ft245_pads
    port map (
      clk        => clkout,
      quiet      => quiet,
      quiet_data => quiet_data,
      data_in    => data_in,
      data_out   => data_out,
      data_oe    => data_oe,
      rxf_n      => rxf_n,
      txe_n      => txe_n,
      rd_n       => rd_n,
      wr_n       => wr_n,
      oe_n       => oe_n,
      siwu_n     => siwu_n,
      data       => out_byte,
      drive      => drive_next,
      read       => read_next,
      write      => write_next,
      enable     => enable_next,
      send_now   => siwu_low,
      data_seen  => data_seen,
      rxf        => rxf,
      txe        => txe
    );

  out_byte     <= ring(to_integer(send_at(1 downto 0)));
  room         <= '1' when rx_level < rx_depth - rx_reserve else
                  '0';
  may_read     <= room and rxf;
  captured_one <= rd_was and rxf;

  -- With one_by_one, wait until the result for the byte at the pins is known.
  may_write <= '1' when send_at /= put_at and txe = '1' and (one_by_one and wr_now) = '0' else
               '0';
  accepted  <= wr_was and txe and not behind_refused;
  refused   <= wr_was and not txe and not behind_refused;

  ring_full  <= '1' when put_at - done_at = ring_depth else
                '0';
  all_done   <= '1' when put_at = done_at else
                '0';
  head_ready <= all_done when head(8) = '1' and siwu_low = '0' and siwu_cycles = 0 else
                not ring_full and not head(8) and not siwu_low;
  bored      <= '1' when idle_for = patience else
                '0';

  decide : process (all) is
  begin

    next_state  <= state;
    read_next   <= '0';
    write_next  <= '0';
    enable_next <= '0';
    drive_next  <= '0';

    case state is

      when idle =>

        if may_read = '1' and (may_write = '0' or wrote_last = '1') then
          enable_next <= '1';
          next_state  <= reading;
        elsif may_write = '1' then
          drive_next <= '1';
          next_state <= writing;
        end if;

      when writing =>

        drive_next <= '1';
        if (may_read = '1' and (may_write = '0' or moved = burst)) or bored = '1' then
          next_state <= release_ours;
        else
          write_next <= may_write;
        end if;

      when reading =>

        enable_next <= '1';
        if (may_write = '1' and (may_read = '0' or moved = burst)) or bored = '1' then
          next_state <= release_theirs;
        else
          read_next <= may_read;
        end if;

      when release_ours | release_theirs =>

        next_state <= idle;

    end case;

  end process decide;

  bus_cycles : process (clkout, quiet) is
  begin

    if quiet = '1' then
      state      <= idle;
      driving    <= '0';
      rd_now     <= '0';
      wr_now     <= '0';
      wrote_last <= '0';
      moved      <= 0;
      idle_for   <= 0;
    elsif rising_edge(clkout) then
      state   <= next_state;
      driving <= drive_next;
      rd_now  <= read_next;
      wr_now  <= write_next;
      if state = writing then
        wrote_last <= '1';
      elsif state = reading then
        wrote_last <= '0';
      end if;
      if state = idle then
        moved <= 0;
      elsif (write_next = '1' or captured_one = '1') and moved /= burst then
        moved <= moved + 1;
      end if;
      if state = idle or write_next = '1' or captured_one = '1' then
        idle_for <= 0;
      elsif bored = '0' then
        idle_for <= idle_for + 1;
      end if;
    end if;

  end process bus_cycles;

  -- Not cleared by `quiet`: if CLKOUT stops after an edge, the transfers of that edge remain counted.
  keep_count : process (clkout, chip_rst) is
  begin

    if chip_rst = '1' then
      rd_was         <= '0';
      wr_was         <= '0';
      behind_refused <= '0';
      one_by_one     <= '0';
      put_at         <= (others => '0');
      send_at        <= (others => '0');
      done_at        <= (others => '0');
      ring           <= (others => (others => '0'));
    elsif rising_edge(clkout) then
      rd_was         <= rd_now;
      wr_was         <= wr_now;
      behind_refused <= refused;
      if (head_valid and head_ready and not head(8)) = '1' then
        ring(to_integer(put_at(1 downto 0))) <= head(7 downto 0);
        put_at                               <= put_at + 1;
      end if;
      if accepted = '1' then
        done_at <= done_at + 1;
      end if;
      if write_next = '1' then
        send_at <= send_at + 1;
      elsif refused = '1' or (wr_now = '0' and wr_was = '0') then
        -- The second condition occurs only if CLKOUT stopped with a byte at the pins.
        send_at <= done_at;
      end if;
      if (wr_was and txe and behind_refused) = '1' then
        one_by_one <= '1';
      end if;
    end if;

  end process keep_count;

  send_immediate : process (clkout, quiet) is
  begin

    if quiet = '1' then
      siwu_low    <= '0';
      siwu_cycles <= siwu_time - 1;
    elsif rising_edge(clkout) then
      if siwu_cycles /= 0 then
        siwu_cycles <= siwu_cycles - 1;
      elsif siwu_low = '1' then
        siwu_low    <= '0';
        siwu_cycles <= siwu_time - 1;
      elsif (head_valid and head_ready and head(8)) = '1' then
        siwu_low    <= '1';
        siwu_cycles <= siwu_time - 1;
      end if;
    end if;

  end process send_immediate;

end architecture rtl;
