-- SPDX-License-Identifier: BSD-3-Clause
--
-- Physical layer: the synchronous FT245 FIFO of an FT232H or FT2232H: one byte in every cycle of its 60 MHz CLKOUT.
--
-- Timing (FT232H datasheet FT_000288, table 4.1). The chip's outputs are valid 9 ns after CLKOUT rises, its inputs must
-- be so 7.5 ns before: of 16.67 ns, 7.67 are left for the way in and 9.17 for the way out. Hence all outputs are
-- registers, and RXF#, TXE# and the data pass at most one level of logic before one. A byte has moved if, at a rising
-- edge, RD# and RXF# (or WR# and TXE#) were both low at the pins; nothing but that is ever counted, so the chip may
-- take its flag away in any cycle of a burst.
--
-- Turnaround. OE# low one cycle after our drivers are off, RD# low one cycle after OE#; back: RD# and OE# high, then
-- one cycle in which nobody drives. A direction is kept until the other one has something to do, and then for at most
-- `burst` bytes more.
--
-- Clocks. CLKOUT runs only while the PC holds the chip in synchronous mode. The strobes are reset asynchronously, as
-- CLKOUT may stand with one of them low. Both FIFOs stand between the two clocks. A
-- reset lasts for four cycles of clk on the chip's side, so that the core's side is surely in reset when that one
-- leaves it; and the core's side stays in reset until the chip's side reports that it was reset. So a reset without
-- CLKOUT is remembered, and nothing is kept from before it.
--
-- `flush` passes the transmit FIFO as a marker between the bytes (bit 8). When it comes out and the last byte before it
-- was accepted by the chip, SIWU# goes low for 16 cycles of CLKOUT (267 ns; 250 are asked for), and no byte follows
-- before its end. A flush with no byte since the last one is dropped, as what the chip makes of it is not documented.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.math_pkg.all;

entity ft245_sync is
  generic (
    -- Bytes; powers of two, at least 16.
    rx_depth : positive := 64;
    tx_depth : positive := 64;
    -- Bytes moved in one direction while the other one waits, at most.
    burst : positive := 256
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- Pins; the top joins data_in, data_out and data_oe ('1': drive) to the bidirectional bus.
    clkout   : in    std_logic;
    data_in  : in    std_logic_vector(7 downto 0);
    data_out : out   std_logic_vector(7 downto 0);
    data_oe  : out   std_logic;
    rxf_n    : in    std_logic;
    txe_n    : in    std_logic;
    rd_n     : out   std_logic;
    wr_n     : out   std_logic;
    oe_n     : out   std_logic;
    siwu_n   : out   std_logic;
    -- Core, in the domain of clk.
    rx_data  : out   std_logic_vector(7 downto 0);
    rx_lost  : out   std_logic;
    rx_valid : out   std_logic;
    rx_ready : in    std_logic;
    tx_data  : in    std_logic_vector(7 downto 0);
    tx_valid : in    std_logic;
    tx_ready : out   std_logic;
    flush    : in    std_logic
  );
end entity ft245_sync;

architecture rtl of ft245_sync is

  constant siwu_time : positive := 16;

  -- Room for the bytes that still come after RD# was told to go: one in the pins, one in the register before the FIFO,
  -- and the cycles that the level is late.
  constant rx_reserve : positive := 6;

  type state_t is (write_bytes, release_ours, enable_theirs, read_bytes, release_theirs);

  -- Core's domain.
  signal core_rst       : std_logic;
  signal rst_request    : std_logic_vector(3 downto 0);
  signal up_meta        : std_logic;
  signal up_seen        : std_logic;
  signal rx_entry_valid : std_logic;
  signal unflushed      : std_logic;
  signal flush_wanted   : std_logic;
  signal tx_entry       : std_logic_vector(8 downto 0);
  signal tx_entry_valid : std_logic;
  signal tx_entry_ready : std_logic;
  signal tx_accept      : std_logic;

  -- Chip's domain.
  signal chip_rst     : std_logic;
  signal chip_up      : std_logic;
  signal rst_stages   : std_logic_vector(2 downto 0);
  signal state        : state_t;
  signal rd_active    : std_logic;
  signal wr_active    : std_logic;
  signal written      : std_logic;
  signal out_free     : std_logic;
  signal room         : std_logic;
  signal may_read     : std_logic;
  signal may_write    : std_logic;
  signal rxf_seen     : std_logic;
  signal txe_seen     : std_logic;
  signal out_byte     : std_logic_vector(7 downto 0);
  signal out_held     : std_logic;
  signal head         : std_logic_vector(8 downto 0);
  signal head_valid   : std_logic;
  signal head_ready   : std_logic;
  signal captured     : std_logic_vector(7 downto 0);
  signal captured_one : std_logic;
  signal rx_level     : unsigned(log2_ceil(rx_depth) downto 0);
  signal moved        : natural range 0 to burst;
  signal siwu_low     : std_logic;
  signal siwu_cycles  : natural range 0 to siwu_time;

begin

  assert rx_depth >= 16 and tx_depth >= 16
    report "ft245_sync: rx_depth is " & integer'image(rx_depth) & " and tx_depth " & integer'image(tx_depth) &
           ", expected at least 16 each"
    severity failure;

  -- Reset of the chip's domain: begins with the request even while CLKOUT stands, ends after three of its edges.
  chip_reset : process (clkout, rst_request) is
  begin

    if rst_request(3) = '1' then
      rst_stages <= (others => '1');
      chip_up    <= '0';
    elsif rising_edge(clkout) then
      rst_stages <= rst_stages(1 downto 0) & '0';
      chip_up    <= not rst_stages(2);
    end if;

  end process chip_reset;

  chip_rst <= rst_stages(2);

  core_reset : process (clk) is
  begin

    if rising_edge(clk) then
      rst_request <= rst_request(2 downto 0) & '0';
      up_meta     <= chip_up and not rst_request(3);
      up_seen     <= up_meta and not rst_request(3);
      core_rst    <= rst_request(3) or not up_seen;
      if rst = '1' then
        rst_request <= (others => '1');
        core_rst    <= '1';
      end if;
    end if;

  end process core_reset;

  rx_fifo : entity work.fifo_async
    generic map (
      width => 8,
      depth => rx_depth
    )
    port map (
      in_clk    => clkout,
      in_rst    => chip_rst,
      in_data   => captured,
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

  tx_fifo : entity work.fifo_async
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

  data_out <= out_byte;
  rd_n     <= not rd_active;
  wr_n     <= not wr_active;
  siwu_n   <= not siwu_low;

  -- A byte is taken from the FIFO when the output register is free in the next cycle; a marker waits until it is empty.
  written    <= wr_active and not txe_n;
  out_free   <= not out_held or written;
  head_ready <= not out_held when head(8) = '1' else
                out_free and not siwu_low;
  room       <= '1' when rx_level < rx_depth - rx_reserve else
                '0';
  may_read   <= room and not rxf_seen;
  may_write  <= out_held and not txe_seen;

  bus_cycles : process (clkout, chip_rst) is

    variable holds : std_logic;

  begin

    if chip_rst = '1' then
      state        <= release_theirs;
      moved        <= 0;
      rd_active    <= '0';
      wr_active    <= '0';
      out_byte     <= (others => '0');
      out_held     <= '0';
      captured_one <= '0';
      rxf_seen     <= '1';
      txe_seen     <= '1';
      oe_n         <= '1';
      data_oe      <= '0';
    elsif rising_edge(clkout) then
      rxf_seen     <= rxf_n;
      txe_seen     <= txe_n;
      captured     <= data_in;
      captured_one <= rd_active and not rxf_n;

      -- The output register: `holds` is whether it will hold a byte that the chip has not accepted.
      holds := out_held and not written;
      if head_valid = '1' and head_ready = '1' and head(8) = '0' then
        out_byte <= head(7 downto 0);
        holds    := '1';
      end if;
      out_held  <= holds;
      wr_active <= '0';

      case state is

        when write_bytes =>

          wr_active <= holds;
          if written = '1' and moved /= burst then
            moved <= moved + 1;
          end if;
          if may_read = '1' and (may_write = '0' or moved = burst) then
            wr_active <= '0';
            state     <= release_ours;
          end if;

        when release_ours =>

          data_oe <= '0';
          moved   <= 0;
          state   <= enable_theirs;

        when enable_theirs =>

          oe_n <= '0';
          if oe_n = '0' then
            rd_active <= not rxf_n and room;
            state     <= read_bytes;
          end if;

        when read_bytes =>

          if captured_one = '1' and moved /= burst then
            moved <= moved + 1;
          end if;
          rd_active <= not rxf_n and room;
          if may_write = '1' and (rxf_n = '1' or room = '0' or moved = burst) then
            rd_active <= '0';
            state     <= release_theirs;
          end if;

        when release_theirs =>

          oe_n  <= '1';
          moved <= 0;
          if oe_n = '1' then
            data_oe <= '1';
            state   <= write_bytes;
          end if;

      end case;

    end if;

  end process bus_cycles;

  send_immediate : process (clkout, chip_rst) is
  begin

    if chip_rst = '1' then
      siwu_low    <= '0';
      siwu_cycles <= 0;
    elsif rising_edge(clkout) then
      if siwu_cycles /= 0 then
        siwu_cycles <= siwu_cycles - 1;
      elsif siwu_low = '1' then
        siwu_low <= '0';
      end if;
      if head_valid = '1' and head_ready = '1' and head(8) = '1' then
        siwu_low    <= '1';
        siwu_cycles <= siwu_time - 1;
      end if;
    end if;

  end process send_immediate;

end architecture rtl;
