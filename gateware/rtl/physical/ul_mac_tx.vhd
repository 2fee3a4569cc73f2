-- SPDX-License-Identifier: BSD-3-Clause
--
-- Transmitter of an Ethernet MAC at 100 Mb/s, in the clock domain of the PHY: accepts bytes of frames and outputs
-- symbols of RMII (two bits) or MII (four), with preamble, padding to 60 bytes, frame check sequence and an interframe
-- gap of 12 bytes.
--
-- Once begun, a frame needs a valid byte in each byte time. If a byte is missing (underrun), the transmitter ends the
-- frame with a CRC that is certainly wrong, and accepts and drops the rest of the frame.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_crc32_pkg.all;
  use work.unity_link_pkg.all;

entity ul_mac_tx is
  generic (
    -- 2, 4: bits per symbol.
    lanes : positive := 2
  );
  port (
    -- The PHY's clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- '1': the symbol changes at this edge.
    tick : in    std_logic;
    -- A byte of a frame. It is transferred at the rising edge at which in_valid and in_ready are both '1'.
    in_data : in    std_logic_vector(7 downto 0);
    -- The byte is the last one of its frame, not counting the frame check sequence.
    in_last  : in    std_logic;
    in_valid : in    std_logic;
    in_ready : out   std_logic;
    -- A symbol; its lowest bit is first on the line.
    data : out   std_logic_vector(lanes - 1 downto 0);
    -- The symbol belongs to a frame or its preamble.
    enable : out   std_logic
  );
end entity ul_mac_tx;

architecture rtl of ul_mac_tx is

  constant symbols   : positive := 8 / lanes;
  constant shortest  : positive := 60;
  constant gap       : positive := 12;
  constant delimiter : positive := 8;
  constant checks    : positive := 4;

  type state_t is (idle, preamble, payload, padding, check, dropping, resting);

  -- state: the kind of `out_byte`. count: number of bytes of that kind begun; payload and padding count together, up to
  -- `shortest`.
  signal state    : state_t;
  signal count    : unsigned(5 downto 0);
  signal place    : natural range 0 to symbols - 1;
  signal out_byte : std_logic_vector(7 downto 0);
  signal crc      : std_logic_vector(31 downto 0);
  -- last: the byte is the last one of the payload. spoilt: the frame must end with a wrong CRC.
  signal last   : std_logic;
  signal spoilt : std_logic;
  -- step: the next byte begins at this edge. take: it is the byte offered at in_data.
  signal step : std_logic;
  signal take : std_logic;

begin

  assert lanes = 2 or lanes = 4
    report "ul_mac_tx: lanes is " & integer'image(lanes) & ", expected 2 or 4"
    severity failure;

  step     <= tick when place = symbols - 1 else
              '0';
  take     <= step when (state = preamble and count = delimiter) or (state = payload and last = '0') else
              '0';
  in_ready <= '1' when take = '1' or state = dropping else
              '0';

  pins : process (clk) is
  begin

    if rising_edge(clk) then
      if tick = '1' then
        enable <= to_std_logic(state = preamble or state = payload or state = padding or state = check);
        data   <= out_byte(lanes - 1 downto 0);
        if state = preamble then
          crc <= (others => '1');
        elsif state = check then
          crc  <= std_logic_vector(shift_right(unsigned(crc), lanes));
          data <= crc(lanes - 1 downto 0);
          if spoilt = '0' then
            data <= not crc(lanes - 1 downto 0);
          end if;
        elsif state = payload or state = padding then
          crc <= crc32_after(crc, out_byte(lanes - 1 downto 0));
        end if;
      end if;

      if rst = '1' then
        enable <= '0';
        data   <= (others => '0');
        crc    <= (others => '1');
      end if;
    end if;

  end process pins;

  main : process (clk) is
  begin

    if rising_edge(clk) then
      if tick = '1' then
        out_byte <= std_logic_vector(shift_right(unsigned(out_byte), lanes));
      end if;
      if step = '1' then
        place    <= 0;
        count    <= count + 1;
        out_byte <= (others => '0');
      elsif tick = '1' then
        place <= place + 1;
      end if;

      case state is

        when idle =>
          place    <= 0;
          count    <= to_unsigned(1, count'length);
          out_byte <= x"55";
          spoilt   <= '0';
          if (tick and in_valid) = '1' then
            state <= preamble;
          end if;

        when preamble =>
          if step = '1' then
            out_byte <= x"55";
            if count = delimiter - 1 then
              out_byte <= x"D5";
            end if;
          end if;
          last <= '0';

        when payload | padding =>
          if step = '1' then
            if count = shortest then
              count <= count;
            end if;
            if state = padding or last = '1' then
              state <= padding;
              if count = shortest then
                state <= check;
                count <= to_unsigned(1, count'length);
              end if;
            end if;
          end if;

        when check =>
          if step = '1' and count = checks then
            state <= resting;
            count <= to_unsigned(1, count'length);
            if spoilt = '1' then
              state <= dropping;
            end if;
          end if;

        when dropping =>
          count <= to_unsigned(1, count'length);
          if (in_valid and in_last) = '1' then
            state <= resting;
          end if;

        when resting =>
          if step = '1' and count = gap then
            state <= idle;
          end if;

      end case;

      if take = '1' then
        state    <= payload;
        out_byte <= in_data;
        last     <= in_last;
        if state = preamble then
          count <= to_unsigned(1, count'length);
        end if;
        if in_valid = '0' then
          state  <= check;
          spoilt <= '1';
          count  <= to_unsigned(1, count'length);
        end if;
      end if;

      if rst = '1' then
        state    <= idle;
        count    <= (others => '0');
        place    <= 0;
        out_byte <= (others => '0');
        last     <= '0';
        spoilt   <= '0';
      end if;
    end if;

  end process main;

end architecture rtl;
