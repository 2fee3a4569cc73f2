-- SPDX-License-Identifier: BSD-3-Clause
--
-- Ethernet frames through a W5500 of WIZnet on SPI, in place of `ul_mac` and a PHY (section numbers refer to the chip's
-- datasheet, version 1.0.9).
--
-- The chip's TCP/IP stack is not used: its socket 0 is opened for raw frames (MACRAW, section 4.2), so that addresses,
-- sessions and discovery are those of the other Ethernet ports. The chip sends and checks frames. It receives frames
-- for its own address and broadcasts; its buffers have 16 KiB in each direction.
--
-- The state machine repeats a few SPI accesses (section 2.2.1: address, block, data). To receive: read the pointers and
-- see if a frame has arrived; read its length and bytes; write the new pointer and the command RECV. To send: write a
-- frame, padded to 60 bytes; write the new pointer and the command SEND; poll until it was sent. All pointers are read
-- from the chip each time. From time to time it checks that the socket is still open: a chip that lost its power is
-- reset and configured again. If the chip returns an impossible value or does not finish a frame, the socket is closed
-- and reopened, which does not disturb the chip's PHY.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_ethernet_pkg.all;
  use work.unity_link_pkg.all;

entity ul_w5500 is
  generic (
    -- At least 1000: frequency of clk in Hz. The SPI clock is at most half of it, and at most 33.3 MHz (section 5.5.4).
    clock_hz : positive := 50_000_000;
    -- 48 bits: MAC address of this gateway.
    mac_address : std_logic_vector(47 downto 0) := x"02554C000001"
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- SCLK, mode 0.
    spi_sck : out   std_logic;
    -- SCSn.
    spi_cs_n : out   std_logic;
    -- MOSI.
    spi_mosi : out   std_logic;
    -- MISO. It changes at falling edges of SCLK and is sampled at the next falling edge.
    spi_miso : in    std_logic;
    -- RSTn.
    spi_rst_n : out   std_logic;
    -- A byte of a frame; with rx_end, bit 0 is '1' if the frame has no errors. It must be accepted at once.
    rx_data  : out   std_logic_vector(7 downto 0);
    rx_end   : out   std_logic;
    rx_valid : out   std_logic;
    -- A byte of a frame to send, without padding and frame check sequence.
    tx_data : in    std_logic_vector(7 downto 0);
    -- The byte is the last one of its frame.
    tx_last  : in    std_logic;
    tx_valid : in    std_logic;
    tx_ready : out   std_logic
  );
end entity ul_w5500;

architecture rtl of ul_w5500 is

  constant highest_sck : positive := 33_300_000;
  -- Cycles for which SCLK is low; it is high for as many.
  constant half : positive := (clock_hz + 2 * highest_sck - 1) / (2 * highest_sck);
  -- Minimum number of cycles for which SCSn is high between accesses: 30 ns with a clock of 133 MHz.
  constant gap : positive := 4;
  -- Cycles in a millisecond: longer than the minimum pulse of RSTn, and longer than the chip takes to start (section
  -- 5.5.1).
  constant pause : positive := clock_hz / 1000 + 1;
  -- Number of accesses, each of at least a microsecond, after which an awaited result counts as failed: sending a frame
  -- takes at most 1.3 ms.
  constant patience : positive := 2 ** 12 - 1;
  -- Length limits of a received frame in bytes, with the 2 bytes of its length before it and without its frame check
  -- sequence.
  constant shortest : positive := 62;
  constant longest  : positive := 1520;

  -- Blocks of section 2.2.2, and register addresses within a socket's block.

  subtype block_t is std_logic_vector(4 downto 0);

  subtype octet_t is std_logic_vector(7 downto 0);

  constant common   : block_t := "00000";
  constant socket   : block_t := "00001";
  constant tx_block : block_t := "00010";
  constant rx_block : block_t := "00011";

  constant mode      : octet_t := x"00";
  constant command   : octet_t := x"01";
  constant interrupt : octet_t := x"02";
  constant status    : octet_t := x"03";
  constant rx_size   : octet_t := x"1E";
  constant tx_size   : octet_t := x"1F";
  constant tx_write  : octet_t := x"24";
  constant rx_read   : octet_t := x"28";

  constant is_open : octet_t := x"42";

  -- A register of one byte and the value to write.

  type setting_t is record
    area  : block_t;
    place : octet_t;
    value : octet_t;
  end record setting_t;

  type settings_t is array (0 to 26) of setting_t;

  -- Reset the chip; set its MAC address; assign all buffer memory to socket 0; close socket 0 and open it for raw
  -- frames that are addressed to this gateway or broadcast.
  function set_up return settings_t is

    variable result : settings_t;

  begin

    result(0) := (common, mode, x"80");

    for number in 0 to 5 loop

      result(1 + number) := (common, std_logic_vector(to_unsigned(9 + number, 8)), octet(mac_address, number));

    end loop;

    for number in 1 to 7 loop

      result(5 + 2 * number) := (std_logic_vector(to_unsigned(4 * number + 1, 5)), rx_size, x"00");
      result(6 + 2 * number) := (std_logic_vector(to_unsigned(4 * number + 1, 5)), tx_size, x"00");

    end loop;

    result(21) := (socket, rx_size, x"10");
    result(22) := (socket, tx_size, x"10");
    result(23) := (socket, command, x"10");
    result(24) := (socket, interrupt, x"FF");
    result(25) := (socket, mode, x"84");
    result(26) := (socket, command, x"01");
    return result;

  end function set_up;

  constant settings : settings_t := set_up;
  constant reopen   : natural    := 23;

  -- Each step is an SPI access or a pause of a millisecond. `look` reads the pointers, `take` a frame; `advance_rx` and
  -- `receive` free its buffer. `put` writes a frame; `advance_tx` and `send` start its transmission. `accepted` polls
  -- until the chip has accepted a command, `sent` until the frame was sent; `forget` clears the interrupt flag of that.
  -- `check` reads if the socket is still open.

  type step_t is (
    reset, start, restart, configure, look, take, advance_rx, receive, put, advance_tx, send, accepted, sent, forget, check
  );

  -- Phases of an access: SCSn is high; the next byte is selected; a byte is shifted out and one in; the received byte
  -- is evaluated.

  type phase_t is (rest, load, shifting, arrived);

  signal step  : step_t;
  signal phase : phase_t;
  -- The step after a command was accepted.
  signal then_step : step_t;
  signal index     : natural range 0 to 26;
  signal timer     : natural range 0 to pause;
  signal tries     : natural range 0 to patience;

  -- Place of the byte in its access; data begins at place 3, and all later data bytes count as the last place.
  signal place    : natural range 0 to 9;
  signal shift    : octet_t;
  signal bits     : unsigned(2 downto 0);
  signal sck      : std_logic;
  signal duration : natural range 0 to half - 1;
  signal chosen   : octet_t;

  signal rx_pointer : unsigned(15 downto 0);
  signal tx_pointer : unsigned(15 downto 0);
  signal has_come   : std_logic;
  -- Bytes that remain of the frame being received or sent.
  signal left : unsigned(10 downto 0);
  signal many : octet_t;
  -- All bytes of the frame are written; padding follows.
  signal padding : std_logic;
  -- A frame to send is next.
  signal tx_turn : std_logic;
  signal idle    : unsigned(7 downto 0);
  signal ends    : std_logic;

begin

  spi_sck  <= sck;
  spi_mosi <= shift(7);
  tx_ready <= '1' when step = put and phase = load and place >= 3 and padding = '0' else
              '0';

  choose : process (all) is

    variable address : std_logic_vector(15 downto 0);
    variable area    : block_t;
    variable writes  : std_logic;
    variable value   : octet_t;

  begin

    area    := socket;
    writes  := '1';
    address := x"00" & command;
    value   := x"00";

    case step is

      when configure =>
        area                := settings(index).area;
        address(7 downto 0) := settings(index).place;
        value               := settings(index).value;

      when look =>
        writes              := '0';
        address(7 downto 0) := tx_write;

      when take =>
        writes  := '0';
        area    := rx_block;
        address := std_logic_vector(rx_pointer);

      when advance_rx =>
        address(7 downto 0) := rx_read;
        value               := std_logic_vector(rx_pointer(7 downto 0));
        if place = 3 then
          value := std_logic_vector(rx_pointer(15 downto 8));
        end if;

      when receive =>
        value := x"40";

      when put =>
        area    := tx_block;
        address := std_logic_vector(tx_pointer);
        if padding = '0' then
          value := tx_data;
        end if;

      when advance_tx =>
        address(7 downto 0) := tx_write;
        value               := std_logic_vector(tx_pointer(7 downto 0));
        if place = 3 then
          value := std_logic_vector(tx_pointer(15 downto 8));
        end if;

      when send =>
        value := x"20";

      when sent =>
        writes              := '0';
        address(7 downto 0) := interrupt;

      when forget =>
        address(7 downto 0) := interrupt;
        value               := x"FF";

      when check =>
        writes              := '0';
        address(7 downto 0) := status;

      when others =>
        writes := '0';

    end case;

    case place is

      when 0 =>
        chosen <= address(15 downto 8);

      when 1 =>
        chosen <= address(7 downto 0);

      when 2 =>
        chosen <= area & writes & "00";

      when others =>
        chosen <= value;

    end case;

  end process choose;

  main : process (clk) is

    variable length : unsigned(15 downto 0);

    -- End the access and continue with another step.

    procedure go_on (following : step_t) is
    begin

      step     <= following;
      phase    <= rest;
      spi_cs_n <= '1';
      timer    <= gap;
      place    <= 0;

    end procedure go_on;

    -- Repeat the access, at most `patience` times; then reopen the socket.

    procedure try_again is
    begin

      go_on(step);
      tries <= tries + 1;
      if tries = patience then
        go_on(configure);
        index <= reopen;
      end if;

    end procedure try_again;

  begin

    if rising_edge(clk) then
      rx_valid <= '0';
      rx_end   <= '0';
      ends     <= '0';
      length   := unsigned(many & shift);

      if ends = '1' then
        rx_valid <= '1';
        rx_end   <= '1';
        rx_data  <= x"01";
      end if;

      case phase is

        when rest =>
          if timer /= 0 then
            timer <= timer - 1;
          elsif step = reset then
            spi_rst_n <= '1';
            step      <= start;
            timer     <= pause;
          elsif step = start or step = restart then
            step <= configure;
          else
            spi_cs_n <= '0';
            phase    <= load;
          end if;

        when load =>
          if step /= put or place < 3 or padding = '1' or tx_valid = '1' then
            shift    <= chosen;
            duration <= half - 1;
            phase    <= shifting;
            if step = put and place >= 3 then
              left    <= left + 1;
              padding <= padding or tx_last;
            end if;
          end if;

        when shifting =>
          if duration /= 0 then
            duration <= duration - 1;
          else
            duration <= half - 1;
            sck      <= not sck;
            if sck = '1' then
              shift <= shift(6 downto 0) & spi_miso;
              bits  <= bits + 1;
              if bits = 7 then
                phase <= arrived;
              end if;
            end if;
          end if;

        when arrived =>
          phase <= load;
          many  <= shift;
          if place /= 9 then
            place <= place + 1;
          end if;
          if place >= 3 then

            case step is

              when configure =>
                if index = 0 then
                  go_on(restart);
                  timer <= pause;
                  index <= 1;
                elsif index = settings'high then
                  go_on(accepted);
                  then_step <= check;
                  tries     <= 0;
                else
                  go_on(configure);
                  index <= index + 1;
                  if index = reopen then
                    go_on(accepted);
                    then_step <= configure;
                    tries     <= 0;
                  end if;
                end if;

              when look =>
                if place = 4 then
                  tx_pointer <= length;
                elsif place = 6 then
                  has_come <= to_std_logic(length /= 0);
                elsif place = 8 then
                  rx_pointer <= length;
                  padding    <= '0';
                  left       <= (others => '0');
                  idle       <= idle + 1;
                  tries      <= 0;
                  tx_turn    <= not tx_turn;
                  if tx_valid = '1' and (tx_turn = '1' or has_come = '0') then
                    go_on(put);
                  elsif has_come = '1' then
                    go_on(take);
                  elsif idle = 0 then
                    go_on(check);
                  else
                    go_on(look);
                  end if;
                end if;

              when take =>
                if place = 4 then
                  left       <= length(10 downto 0) - 2;
                  rx_pointer <= rx_pointer + length;
                  if length < shortest or length > longest then
                    go_on(configure);
                    index <= reopen;
                  end if;
                elsif place > 4 then
                  rx_data  <= shift;
                  rx_valid <= '1';
                  left     <= left - 1;
                  if left = 1 then
                    ends <= '1';
                    go_on(advance_rx);
                  end if;
                end if;

              when advance_rx =>
                if place = 4 then
                  go_on(receive);
                end if;

              when receive =>
                go_on(accepted);
                then_step <= look;

              when put =>
                if padding = '1' and left >= shortest - 2 then
                  go_on(advance_tx);
                  tx_pointer <= tx_pointer + left;
                end if;

              when advance_tx =>
                if place = 4 then
                  go_on(send);
                end if;

              when send =>
                go_on(accepted);
                then_step <= sent;

              when accepted =>
                if shift = x"00" then
                  go_on(then_step);
                else
                  try_again;
                end if;

              when sent =>
                if (shift(4) or shift(3)) = '1' then
                  go_on(forget);
                else
                  try_again;
                end if;

              when forget =>
                go_on(look);

              when check =>
                if shift = is_open then
                  go_on(look);
                else
                  go_on(reset);
                  timer     <= pause;
                  index     <= 0;
                  spi_rst_n <= '0';
                end if;

              when others =>
                null;

            end case;

          end if;

      end case;

      if rst = '1' then
        step       <= reset;
        phase      <= rest;
        then_step  <= look;
        index      <= 0;
        timer      <= pause;
        tries      <= 0;
        place      <= 0;
        shift      <= (others => '0');
        bits       <= (others => '0');
        sck        <= '0';
        duration   <= half - 1;
        rx_pointer <= (others => '0');
        tx_pointer <= (others => '0');
        has_come   <= '0';
        left       <= (others => '0');
        many       <= (others => '0');
        padding    <= '0';
        tx_turn    <= '0';
        idle       <= (others => '0');
        ends       <= '0';
        spi_cs_n   <= '1';
        spi_rst_n  <= '0';
        rx_data    <= (others => '0');
        rx_end     <= '0';
        rx_valid   <= '0';
      end if;
    end if;

  end process main;

end architecture rtl;
