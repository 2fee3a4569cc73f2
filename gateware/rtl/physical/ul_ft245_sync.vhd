-- SPDX-License-Identifier: BSD-3-Clause
--
-- Physical layer: the synchronous FT245 FIFO of an FT232H or FT2232H: one byte in every cycle of its 60 MHz CLKOUT.
--
-- Pins. Each is a register in `ul_ft245_pads` that nothing else hangs on, so that a vendor's tool can put it into the
-- pad; `pads` says whose. docs/gateware.md works out what that leaves of the 16.67 ns. It has a price in cycles: what
-- the chip did at an edge is known one cycle later, and what is decided then is at the pins one cycle after that. So
-- there are copies here of what the pins show (`rd_now`, `wr_now`) and of what they showed at the last edge (`rd_was`,
-- `wr_was`), which the flags of that edge belong to. A byte has moved if RD# and RXF# (or WR# and TXE#) were both low
-- at an edge; nothing but that is ever counted.
--
-- Reading past RXF# is harmless: what comes is dropped. Writing past TXE# is not done twice: when a byte is found to be
-- refused, the one behind it is at the pins already. It is refused as well, because TXE# stays high for more than one
-- cycle (10 were measured; the datasheet says nothing), and both are sent again, in their order, from `ring`. Should a
-- chip take the second one, its byte comes twice, once too early: a CRC finds that. From there until the next reset
-- each byte waits for the word of the one before it, at 30 MB/s.
--
-- Turnaround. OE# low one cycle after our drivers are off, RD# low one cycle after OE#; back: RD# high, OE# high, then
-- one cycle in which nobody drives. A direction is kept until the other one has something to do, and then for at most
-- `burst` bytes more and those under way. Where nothing has moved for `patience` cycles nobody drives, because what else
-- the PC makes of the chip may use the same pins.
--
-- Clocks. CLKOUT runs only while the PC holds the chip in synchronous mode. Both FIFOs stand between the two clocks.
-- clk's side asks CLKOUT's for an answer all the time. Where none comes for `silence` cycles of clk, all pins rest, and
-- go on when CLKOUT does: no byte is lost or comes twice by it, unless CLKOUT comes back at the very edge of clk at
-- which it is given up. A reset lasts for four cycles of clk on the chip's side, so that the core's side is surely in
-- reset when that one leaves it; and the core's side stays in reset until the chip's side reports that it was reset. So
-- a reset without CLKOUT is remembered, and nothing is kept from before it.
--
-- `flush` passes the transmit FIFO as a marker between the bytes (bit 8). When it comes out and the last byte before it
-- was accepted by the chip, SIWU# goes low for 16 cycles of CLKOUT (267 ns; 250 are asked for), and no byte follows
-- before its end; it stays high as long before it may fall again. A flush with no byte since the last one is dropped,
-- as what the chip makes of it is not documented.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_ft245_sync is
  generic (
    -- Powers of two, at least 16: bytes between the chip's clock and clk, to the core and from it.
    rx_depth : positive := 64;
    tx_depth : positive := 64;
    -- At least 1: most bytes that move in one direction while the other one waits.
    burst : positive := 256
  );
  port (
    -- The core's clock: rising edges count.
    clk : in    std_logic;
    -- Synchronous, active high, for one cycle or more.
    rst : in    std_logic;
    -- CLKOUT, 60 MHz, which may stand still.
    clkout : in    std_logic;
    -- The data pins; the board's top joins this and the next two to them, bit by bit. Clock: clkout.
    data_in : in    std_logic_vector(7 downto 0);
    -- What the data pins are to show. Clock: clkout.
    data_out : out   std_logic_vector(7 downto 0);
    -- '1': drive that pin. Clock: clkout.
    data_oe : out   std_logic_vector(7 downto 0);
    -- RXF#: the chip has a byte. Clock: clkout.
    rxf_n : in    std_logic;
    -- TXE#: the chip takes a byte. Clock: clkout.
    txe_n : in    std_logic;
    -- RD#. Clock: clkout.
    rd_n : out   std_logic;
    -- WR#. Clock: clkout.
    wr_n : out   std_logic;
    -- OE#. Clock: clkout.
    oe_n : out   std_logic;
    -- SIWU#: send at once. Clock: clkout.
    siwu_n : out   std_logic;
    -- A byte for the core: it has moved at the edge at which rx_valid and rx_ready are both '1'.
    rx_data : out   std_logic_vector(7 downto 0);
    -- With a byte: some before it were lost.
    rx_lost : out   std_logic;
    -- A byte stands at rx_data.
    rx_valid : out   std_logic;
    -- The core takes a byte.
    rx_ready : in    std_logic;
    -- A byte of the core.
    tx_data : in    std_logic_vector(7 downto 0);
    -- A byte stands at tx_data.
    tx_valid : in    std_logic;
    -- This layer takes a byte.
    tx_ready : out   std_logic;
    -- '1' for one cycle: when all bytes that were accepted so far are written, pull SIWU# low.
    flush : in    std_logic
  );
end entity ul_ft245_sync;

architecture rtl of ul_ft245_sync is

  constant siwu_time : positive := 16;
  -- Of CLKOUT: more than TXE# is high within a stream.
  constant patience : positive := 16;
  -- Of clk: longer than a question and its answer take, and than SIWU# must be low, for clocks of up to 250 MHz.
  constant silence : positive := 64;

  -- Room for the bytes that still come after RD# was told to go, with as many for the cycles that the level is late.
  constant rx_reserve : positive := 6;

  -- Bytes that are waiting for the pins, at them, or not known to be taken: one each, and one more on its way.
  constant ring_depth : positive := 4;

  type state_t is (idle, writing, release_ours, reading, release_theirs);

  type ring_t is array (0 to ring_depth - 1) of std_logic_vector(7 downto 0);

  -- One bit more than a place in the ring has.
  subtype place_t is unsigned(2 downto 0);

  -- Core's domain.
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

  -- Chip's domain.
  signal chip_rst   : std_logic;
  signal chip_up    : std_logic;
  signal answer     : std_logic;
  signal quiet      : std_logic;
  signal quiet_data : std_logic;
  signal state      : state_t;
  signal next_state : state_t;
  -- At the pins from the next edge on.
  signal read_next   : std_logic;
  signal write_next  : std_logic;
  signal enable_next : std_logic;
  signal drive_next  : std_logic;
  -- At the pins now, and at the last edge.
  signal driving : std_logic;
  signal rd_now  : std_logic;
  signal rd_was  : std_logic;
  signal wr_now  : std_logic;
  signal wr_was  : std_logic;
  -- At the last edge the pins showed these.
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
  -- What was written at the last edge stands behind a byte that was refused.
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

  -- Through all of chip_rst, too. Where we don't drive, the data pins are left alone: they hold what came in last.
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

  -- Where one_by_one, the word of what is at the pins now is waited for.
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

  -- What happened at the last edge is not taken back by a CLKOUT that stands behind it.
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
        -- The latter only where CLKOUT stood with a byte at the pins.
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
