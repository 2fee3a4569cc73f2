-- SPDX-License-Identifier: BSD-3-Clause
--
-- Physical layer: the asynchronous FT245 FIFO of an FT232H or FT2232H, with SIWU#.
--
-- All intervals follow from the clock frequency and the FT232H datasheet (FT_000288, table 4.2, named T1 to T11 below),
-- plus `skew_ns` for the difference between the delays of two pins. Data is driven from before the falling edge of WR#
-- until after its rising edge. This is right for either edge at which the chip may latch (editions of the datasheet
-- differ on T9).
--
-- Each pin has a register of its own in `ul_ft245_pads`, which drives no other logic. A decision of the state machine
-- reaches the pins at the next edge; the data sampled while RD# was low leaves the pad registers one cycle later.
--
-- RXF# and TXE# are asynchronous to the clock, so each passes two registers: the one in the pad and one in a
-- `ul_synchroniser`. The synchronised flag is two cycles old. An access withdraws its flag within 14 ns (T1 and T6);
-- the state machine ignores the flag until a sample taken after that time has arrived. If both directions are ready,
-- they take turns.
--
-- A byte to send is driven before TXE# allows the write, so that its setup time costs no extra cycles. If a byte to
-- receive arrives in the meantime, or TXE# stays high for `patience` cycles, the bus is released: the PC may have
-- switched the chip to another mode that uses the same pins. After that the bus is driven only once TXE# is low.
--
-- `flush` means: pull SIWU# low when all bytes accepted so far have been written. Until then no further byte is
-- accepted, so that the pulse falls between the right two bytes. A flush without a byte since the last flush has no
-- effect, because the chip's reaction to SIWU# with an empty FIFO is not documented.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity ul_ft245_async is
  generic (
    -- At least 1: frequency of clk in Hz.
    clock_hz : positive := 50_000_000;
    -- At least 0: maximum difference in ns between the delays of two pins, including the board.
    skew_ns : natural := 5
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- Data pins, input. The board's top joins data_in, data_out and data_oe bit by bit at the pins. Clock: none.
    data_in : in    std_logic_vector(7 downto 0);
    -- Data pins, output.
    data_out : out   std_logic_vector(7 downto 0);
    -- '1' enables the driver of that data pin.
    data_oe : out   std_logic_vector(7 downto 0);
    -- RXF#: '0' if the chip has a byte. Clock: none.
    rxf_n : in    std_logic;
    -- TXE#: '0' if the chip accepts a byte. Clock: none.
    txe_n : in    std_logic;
    -- RD#, the read strobe.
    rd_n : out   std_logic;
    -- WR#, the write strobe.
    wr_n : out   std_logic;
    -- SIWU#: '0' makes the chip send its buffer at once.
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
end entity ul_ft245_async;

architecture rtl of ul_ft245_async is

  -- Clock cycles that last at least `ns` plus the skew of the pins; at least 1.
  function cycles (ns : positive) return positive is
  begin

    return maximum(1, integer(real(ns + skew_ns) * real(clock_hz) / 1.0e9 + 0.499_999));

  end function cycles;

  -- Clock cycles from an output register through its pin, the chip, the flag's pin and both registers of the flag; `ns`
  -- is the chip's part.
  function cycles_until_seen (ns : positive) return positive is
  begin

    return cycles(ns) + 2;

  end function cycles_until_seen;

  function most (a : positive; b : positive) return positive is
  begin

    if a > b then
      return a;
    end if;
    return b;

  end function most;

  -- RD# low: T4. It also covers T3 and the skew between RD# and the data inputs.
  constant rd_low : positive := cycles(30);
  -- RD# high until RXF# is valid again: T1. The chip has released the data bus by then, too.
  constant rd_high : positive := cycles_until_seen(14);
  -- Data setup before WR#: T8.
  constant wr_setup : positive := cycles(5);
  -- WR# low: T10.
  constant wr_low : positive := cycles(30);
  -- Data hold after WR#: T9.
  constant wr_hold : positive := cycles(5);
  -- From the end of the hold time until TXE# is valid again: T6, counted from the falling edge of WR#.
  constant wr_rest : positive := most(cycles_until_seen(14), wr_low + wr_hold + 1) - wr_low - wr_hold;
  -- SIWU#: 250 ns low, and at least as long high before it may fall again.
  constant siwu_time : positive := cycles(250);
  -- Cycles for which the bus is driven before TXE# allows the write.
  constant patience : positive := cycles(500);

  constant longest : positive := patience + rd_low + rd_high + wr_setup + wr_low + wr_hold + wr_rest;

  type state_t is (idle, reading, after_read, setup, offering, writing, holding, after_write);

  signal state        : state_t;
  signal next_state   : state_t;
  signal length       : natural range 1 to longest;
  signal wait_cycles  : natural range 0 to longest;
  signal over         : std_logic;
  signal rxf          : std_logic;
  signal rxf_seen     : std_logic;
  signal txe          : std_logic;
  signal txe_seen     : std_logic;
  signal read_next    : std_logic;
  signal write_next   : std_logic;
  signal drive_next   : std_logic;
  signal data_seen    : std_logic_vector(7 downto 0);
  signal take         : std_logic;
  signal offered      : std_logic;
  signal wrote_last   : std_logic;
  signal may_read     : std_logic;
  signal received     : std_logic;
  signal tx_byte      : std_logic_vector(7 downto 0);
  signal tx_held      : std_logic;
  signal accept       : std_logic;
  signal unflushed    : std_logic;
  signal flush_wanted : std_logic;
  signal siwu_low     : std_logic;
  signal siwu_next    : std_logic;
  signal siwu_cycles  : natural range 0 to siwu_time;

begin

  rx_valid <= received;
  rx_lost  <= '0';
  tx_ready <= accept;
  accept   <= not tx_held and not flush_wanted and not siwu_low;
  may_read <= rxf_seen and not received;

  pins : entity work.ul_ft245_pads
    port map (
      clk        => clk,
      quiet      => '0',
      quiet_data => '0',
      data_in    => data_in,
      data_out   => data_out,
      data_oe    => data_oe,
      rxf_n      => rxf_n,
      txe_n      => txe_n,
      rd_n       => rd_n,
      wr_n       => wr_n,
      oe_n       => open,
      siwu_n     => siwu_n,
      data       => tx_byte,
      drive      => drive_next,
      read       => read_next,
      write      => write_next,
      enable     => '0',
      send_now   => siwu_next,
      data_seen  => data_seen,
      rxf        => rxf,
      txe        => txe
    );

  -- The register in the pad is the first of two.
  flags : entity work.ul_synchroniser
    generic map (
      width  => 2,
      stages => 1
    )
    port map (
      clk  => clk,
      rst  => rst,
      d(0) => rxf,
      d(1) => txe,
      q(0) => rxf_seen,
      q(1) => txe_seen
    );

  over <= '1' when wait_cycles = 0 else
          '0';

  -- A state lasts for `length` cycles unless an event ends it earlier.
  decide : process (all) is
  begin

    next_state <= state;
    length     <= 1;

    case state is

      when idle =>

        if may_read = '1' and (wrote_last = '1' or tx_held = '0' or txe_seen = '0') then
          next_state <= reading;
          length     <= rd_low;
        elsif tx_held = '1' and (txe_seen = '1' or offered = '0') then
          next_state <= setup;
          length     <= wr_setup;
        end if;

      when reading =>

        if over = '1' then
          next_state <= after_read;
          length     <= rd_high;
        end if;

      when after_read | after_write =>

        if over = '1' then
          next_state <= idle;
        end if;

      when setup =>

        -- TXE# may become low in the last cycle of the setup time.
        if over = '1' and txe_seen = '1' then
          next_state <= writing;
          length     <= wr_low;
        elsif over = '1' then
          next_state <= offering;
          length     <= patience;
        end if;

      when offering =>

        if txe_seen = '1' then
          next_state <= writing;
          length     <= wr_low;
        elsif may_read = '1' or over = '1' then
          next_state <= idle;
        end if;

      when writing =>

        if over = '1' then
          next_state <= holding;
          length     <= wr_hold;
        end if;

      when holding =>

        if over = '1' then
          next_state <= after_write;
          length     <= wr_rest;
        end if;

    end case;

    if rst = '1' then
      next_state <= idle;
    end if;

  end process decide;

  read_next  <= '1' when next_state = reading else
                '0';
  write_next <= '1' when next_state = writing else
                '0';
  drive_next <= '1' when next_state = setup or next_state = offering or next_state = writing or next_state = holding else
                '0';

  bus_cycles : process (clk) is
  begin

    if rising_edge(clk) then
      state <= next_state;
      if next_state /= state then
        wait_cycles <= length - 1;
      elsif over = '0' then
        wait_cycles <= wait_cycles - 1;
      end if;

      if received = '1' and rx_ready = '1' then
        received <= '0';
      end if;
      if tx_valid = '1' and accept = '1' then
        tx_byte <= tx_data;
        tx_held <= '1';
      end if;

      -- At the rising edge of RD# the pad registers sample the byte.
      take <= '0';
      if state = reading and over = '1' then
        take       <= '1';
        wrote_last <= '0';
      end if;
      if take = '1' then
        rx_data  <= data_seen;
        received <= '1';
      end if;
      if state = offering and over = '1' then
        offered <= '1';
      end if;
      if state = holding and over = '1' then
        offered    <= '0';
        tx_held    <= '0';
        wrote_last <= '1';
      end if;

      if rst = '1' then
        wait_cycles <= 0;
        take        <= '0';
        offered     <= '0';
        rx_data     <= (others => '0');
        received    <= '0';
        tx_byte     <= (others => '0');
        tx_held     <= '0';
        wrote_last  <= '0';
      end if;
    end if;

  end process bus_cycles;

  -- A SIWU# pulse begins from the idle level and is followed by a pause of the same length.
  siwu_next <= '0' when rst = '1' else
               siwu_low when siwu_cycles /= 0 else
               not siwu_low and flush_wanted and not tx_held;

  send_immediate : process (clk) is
  begin

    if rising_edge(clk) then
      if siwu_cycles /= 0 then
        siwu_cycles <= siwu_cycles - 1;
      elsif siwu_low = '1' then
        siwu_cycles <= siwu_time;
      elsif siwu_next = '1' then
        flush_wanted <= '0';
        siwu_cycles  <= siwu_time - 1;
      end if;
      siwu_low <= siwu_next;

      if tx_valid = '1' and accept = '1' then
        unflushed <= '1';
      end if;
      if flush = '1' and (unflushed = '1' or (tx_valid = '1' and accept = '1')) then
        unflushed    <= '0';
        flush_wanted <= '1';
      end if;

      if rst = '1' then
        unflushed    <= '0';
        flush_wanted <= '0';
        siwu_low     <= '0';
        siwu_cycles  <= 0;
      end if;
    end if;

  end process send_immediate;

end architecture rtl;
