-- SPDX-License-Identifier: BSD-3-Clause
--
-- Physical layer: a UART with 8 data bits, no parity and one stop bit, at up to a quarter of the clock frequency.
--
-- Baud rate. Receiver and transmitter each have a phase accumulator that counts in fractions of a bit. It generates any
-- baud rate within 0.05 %, with edges at most one clock cycle away from their ideal times.
--
-- Sampling. If a bit lasts 16 clock cycles or more, the receiver samples the line 16 times per bit and filters it by a
-- majority of three: it suppresses glitches shorter than floor(clock / baud / 16) cycles. At higher baud rates it
-- samples the line in every clock cycle, so the start edge is known to within one cycle. With b = clock / baud, and t
-- (0 < t <= 1) the position of the start edge within its cycle, bit k is sampled at t + ceil(b/2 - 1 + k*b) cycles:
-- between b/2 - 1 and b/2 + 1 cycles after the beginning of the bit. At b = 4 this leaves one cycle on either side,
-- which tolerates a baud rate error of 2.6 % until the stop bit.
--
-- Lost bytes. The receiver drops a byte that arrives while the previous one has not been read, and a byte without a
-- stop bit (noise, a break). The next byte is then marked by `rx_lost`. After a reset and after a break, the receiver
-- waits for a high line before the next start bit.
--
-- Flow control. With `flow_control` the receiver has a small FIFO and deasserts RTS# when a quarter of it is used; the
-- rest has space for the bytes that the far end sends until it reacts. The transmitter begins no byte while CTS# is
-- high.
--
-- Half-duplex. `driver_enable` controls a transceiver on a pair of wires that both sides share, as with RS-485. The
-- driver is enabled `driver_lead` bits before the first start bit, stays enabled between consecutive bytes, and is
-- disabled `driver_tail` bits after the last stop bit. It is enabled only after the line has been idle for one bit,
-- counted from the middle of the last stop bit. So it does not collide with bytes that the far end sends without a
-- pause, even if a frame ends among them (CR LF, or noise that became CR). The receiver ignores the line while this
-- side drives it.
--
-- `flush` exists because every physical layer has it; a UART buffers no bytes that it could send earlier.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_uart is
  generic (
    -- At least 1: frequency of clk in Hz.
    clock_hz : positive := 50_000_000;
    -- 1 to clock_hz / 4: bits per second.
    baud : positive := 115_200;
    -- Whether RTS# and CTS# are used.
    flow_control : boolean := false;
    -- A power of two, at least 8: bytes of the receiver's FIFO, which exists only with flow_control.
    rx_slack : positive := 64;
    -- Whether both directions share one pair of wires; flow_control must be false then.
    half_duplex : boolean := false;
    -- 0 to 15: bits for which the driver is enabled before the first start bit, and after the last stop bit.
    driver_lead : natural := 1;
    driver_tail : natural := 0
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- Serial input, '1' while idle. Clock: none.
    rxd : in    std_logic;
    -- Serial output.
    txd : out   std_logic;
    -- RTS#: '0' while the far end may send.
    rts_n : out   std_logic;
    -- CTS#: '0' while this end may send. Clock: none.
    cts_n : in    std_logic := '0';
    -- '1': the transceiver drives the line. Always '1' if half_duplex is false.
    driver_enable : out   std_logic;
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
    -- Unused: a UART sends every byte at once.
    flush : in    std_logic := '0'
  );
end entity ul_uart;

architecture rtl of ul_uart is

  -- Registers in series that synchronise RXD and CTS#.
  constant stages : positive := 2;

  constant oversampled : boolean := clock_hz / baud >= 16;

  -- Enough bits that `step` has at least 10 significant bits: its rounding is the error of the baud rate.
  constant phase_bits : positive := log2_ceil(clock_hz / baud + 1) + 11;
  constant tick_bits  : positive := phase_bits - 4;

  subtype phase_t is unsigned(phase_bits - 1 downto 0);

  subtype sum_t is unsigned(phase_bits downto 0);

  function phase_of (bits : real) return phase_t is
  begin

    return to_unsigned(integer(bits * 2.0 ** phase_bits), phase_bits);

  end function phase_of;

  constant bits_per_cycle : real    := real(baud) / real(clock_hz);
  constant step           : phase_t := phase_of(bits_per_cycle);

  -- Phase to load at a start edge, so that it overflows in the middle of the start bit: half a bit and a step. It is
  -- not computed by phase_of, because at the slowest baud rates half a bit exceeds the range of an integer.
  constant start_direct : phase_t              := shift_left(to_unsigned(1, phase_bits), phase_bits - 1) + step;
  constant start_ticks  : unsigned(3 downto 0) := to_unsigned(9, 4);

  type rx_state_t is (wait_high, idle, start_bit, data_bits, stop_bit);

  signal rx_seen     : std_logic;
  signal rx_now      : std_logic;
  signal rx_quiet    : std_logic;
  signal rx_history  : std_logic_vector(2 downto 0);
  signal rx_level    : std_logic;
  signal rx_phase    : phase_t;
  signal rx_sum      : sum_t;
  signal rx_tick     : std_logic;
  signal rx_state    : rx_state_t;
  signal rx_count    : unsigned(2 downto 0);
  signal rx_shift    : std_logic_vector(7 downto 0);
  signal rx_done     : std_logic;
  signal rx_broken   : std_logic;
  signal rx_lost_one : std_logic;
  signal held        : std_logic_vector(8 downto 0);
  signal held_valid  : std_logic;
  signal held_ready  : std_logic;

  signal cts_seen : std_logic;
  signal may_send : std_logic;
  signal tx_phase : phase_t;
  signal tx_sum   : sum_t;
  signal tx_shift : std_logic_vector(9 downto 0);
  signal tx_count : unsigned(3 downto 0);
  signal tx_load  : std_logic;
  signal tx_last  : std_logic;
  -- Signals for half-duplex.
  signal driving   : std_logic;
  signal tail_over : std_logic;
  signal may_drive : std_logic;
  signal may_hear  : std_logic;
  signal deaf      : std_logic_vector(stages - 1 downto 0);

begin

  assert clock_hz / 4 >= baud
    report "ul_uart: baud is " & integer'image(baud) & ", expected at most a quarter of clock_hz (" &
           integer'image(clock_hz / 4) & ")"
    severity failure;

  assert not (half_duplex and flow_control)
    report "ul_uart: half_duplex and flow_control are both true, expected one of them at most"
    severity failure;

  assert driver_lead <= 15 and driver_tail <= 15
    report "ul_uart: driver_lead is " & integer'image(driver_lead) & " and driver_tail " & integer'image(driver_tail) &
           ", expected 0 to 15"
    severity failure;

  rx_crossing : entity work.ul_synchroniser
    generic map (
      stages => stages
    )
    port map (
      clk  => clk,
      rst  => rst,
      d(0) => rxd,
      q(0) => rx_seen
    );

  -- `deaf` delays the driver enable like the synchroniser delays RXD, so it masks exactly the samples of the line taken
  -- while this side drove it.
  rx_now <= rx_seen or deaf(deaf'high);

  rx_sum <= ('0' & rx_phase) + step;

  filtered : if oversampled generate
    rx_tick  <= rx_sum(tick_bits) xor rx_phase(tick_bits);
    rx_level <= (rx_history(0) and rx_history(1)) or (rx_history(1) and rx_history(2)) or
                (rx_history(2) and rx_history(0));
  end generate filtered;

  direct : if not oversampled generate
    rx_tick  <= '1';
    rx_level <= rx_now;
  end generate direct;

  receive : process (clk) is
  begin

    if rising_edge(clk) then
      deaf <= deaf(deaf'high - 1 downto 0) & not may_hear;
      if rx_tick = '1' then
        rx_history <= rx_history(1 downto 0) & rx_now;
      end if;

      rx_phase  <= rx_sum(rx_phase'range);
      rx_done   <= '0';
      rx_broken <= '0';
      -- The phase has advanced since the middle of the stop bit; its overflow marks one idle bit.
      if rx_state /= idle then
        rx_quiet <= '0';
      elsif rx_sum(sum_t'high) = '1' then
        rx_quiet <= '1';
      end if;

      case rx_state is

        when wait_high =>

          if rx_level = '1' then
            rx_state <= idle;
            if half_duplex then
              rx_phase <= (others => '0');
            end if;
          end if;

        when idle =>

          if rx_level = '0' then
            rx_state <= start_bit;
            if oversampled then
              rx_phase(phase_t'high downto tick_bits) <= start_ticks;
            else
              rx_phase <= start_direct;
            end if;
          end if;

        when start_bit =>

          rx_count <= (others => '0');
          if rx_sum(sum_t'high) = '1' then
            if rx_level = '0' then
              rx_state <= data_bits;
            else
              rx_state <= idle;
            end if;
          end if;

        when data_bits =>

          if rx_sum(sum_t'high) = '1' then
            rx_shift <= rx_level & rx_shift(7 downto 1);
            rx_count <= rx_count + 1;
            if rx_count = 7 then
              rx_state <= stop_bit;
            end if;
          end if;

        when stop_bit =>

          if rx_sum(sum_t'high) = '1' then
            if rx_level = '1' then
              rx_done  <= '1';
              rx_state <= idle;
            else
              rx_broken <= '1';
              rx_state  <= wait_high;
            end if;
          end if;

      end case;

      if rst = '1' then
        deaf       <= (others => '0');
        rx_history <= (others => '0');
        rx_phase   <= (others => '0');
        rx_state   <= wait_high;
        rx_quiet   <= '0';
        rx_done    <= '0';
        rx_broken  <= '0';
      end if;
    end if;

  end process receive;

  hold : process (clk) is
  begin

    if rising_edge(clk) then
      if held_ready = '1' then
        held_valid <= '0';
      end if;
      if rx_done = '1' then
        if held_valid = '0' or held_ready = '1' then
          held        <= rx_lost_one & rx_shift;
          held_valid  <= '1';
          rx_lost_one <= '0';
        else
          rx_lost_one <= '1';
        end if;
      end if;
      if rx_broken = '1' then
        rx_lost_one <= '1';
      end if;

      if rst = '1' then
        held        <= (others => '0');
        held_valid  <= '0';
        rx_lost_one <= '0';
      end if;
    end if;

  end process hold;

  with_flow_control : if flow_control generate

    signal level    : unsigned(log2_ceil(rx_slack) downto 0);
    signal rx_entry : std_logic_vector(8 downto 0);

  begin

    slack : entity work.ul_fifo_sync
      generic map (
        width => 9,
        depth => rx_slack
      )
      port map (
        clk       => clk,
        rst       => rst,
        in_data   => held,
        in_valid  => held_valid,
        in_ready  => held_ready,
        out_data  => rx_entry,
        out_valid => rx_valid,
        out_ready => rx_ready,
        level     => level
      );

    rx_data <= rx_entry(7 downto 0);
    rx_lost <= rx_entry(8);

    cts_crossing : entity work.ul_synchroniser
      generic map (
        stages => stages,
        idle   => '1'
      )
      port map (
        clk  => clk,
        rst  => rst,
        d(0) => cts_n,
        q(0) => cts_seen
      );

    pins : process (clk) is
    begin

      if rising_edge(clk) then
        rts_n <= '0';
        if rst = '1' or level >= rx_slack / 4 then
          rts_n <= '1';
        end if;
      end if;

    end process pins;

    may_send <= not cts_seen;

  end generate with_flow_control;

  without_flow_control : if not flow_control generate
    held_ready <= rx_ready;
    rx_data    <= held(7 downto 0);
    rx_lost    <= held(8);
    rx_valid   <= held_valid;
    rts_n      <= '0';
    may_send   <= may_drive;
  end generate without_flow_control;

  tx_sum   <= ('0' & tx_phase) + step;
  tx_last  <= '1' when tx_count = 0 or (tx_count = 1 and tx_sum(sum_t'high) = '1') else
              '0';
  tx_ready <= tx_last and may_send;
  tx_load  <= tx_last and may_send and tx_valid;
  txd      <= tx_shift(0);

  may_drive     <= driving when half_duplex else
                   '1';
  may_hear      <= not driving when half_duplex else
                   '1';
  driver_enable <= may_drive;

  -- `tx_count` is the number of bits that remain of 10. If the next byte follows without a pause, the phase is not
  -- restarted.
  transmit : process (clk) is
  begin

    if rising_edge(clk) then
      tx_phase <= tx_sum(tx_phase'range);
      if tx_count = 0 then
        tx_phase <= (others => '0');
      elsif tx_sum(sum_t'high) = '1' then
        tx_shift <= '1' & tx_shift(9 downto 1);
        tx_count <= tx_count - 1;
      end if;
      if tx_load = '1' then
        tx_shift  <= '1' & tx_data & '0';
        tx_count  <= to_unsigned(10, tx_count'length);
        tail_over <= '0';
      elsif half_duplex and tx_last = '1' then
        -- Lead and tail are counted as bits during which the line stays high.
        tail_over <= '1';
        if driving = '0' and tx_valid = '1' and rx_quiet = '1' then
          driving  <= '1';
          tx_count <= to_unsigned(driver_lead, tx_count'length);
        elsif tail_over = '0' and driver_tail > 0 then
          tx_count <= to_unsigned(driver_tail, tx_count'length);
        else
          driving <= '0';
        end if;
      end if;

      if rst = '1' then
        tx_phase  <= (others => '0');
        tx_shift  <= (others => '1');
        tx_count  <= (others => '0');
        driving   <= '0';
        tail_over <= '1';
      end if;
    end if;

  end process transmit;

end architecture rtl;
