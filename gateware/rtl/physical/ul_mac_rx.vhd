-- SPDX-License-Identifier: BSD-3-Clause
--
-- Receiver of an Ethernet MAC at 100 Mb/s, in the clock domain of the PHY: receives symbols of RMII (two bits) or MII
-- (four) and outputs the bytes of each frame, followed by its status.
--
-- A frame begins after its start delimiter, whatever the length of the preamble. It is good if it has 64 to 1518 bytes,
-- its frame check sequence (IEEE 802.3) is right, the PHY reported no error in it, and no byte was lost at the output.
-- Symbols after the last whole byte (dribble bits) are ignored. A transmission without a delimiter is ignored. A frame
-- that exceeds 1518 bytes is reported as bad at that point, and the rest of it is skipped.
--
-- The receiver has no back pressure: a byte that is not accepted in its cycle is lost, and its frame bad. The status is
-- held until it is accepted; symbols received meanwhile are skipped. After a reset, the line must be idle first.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_crc32_pkg.all;

entity ul_mac_rx is
  generic (
    -- 2, 4: bits per symbol.
    lanes : positive := 2;
    -- At least 5: lengths of the shortest and the longest frame in bytes, with the frame check sequence.
    shortest : positive := 64;
    longest  : positive := 1518
  );
  port (
    -- The PHY's clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- A symbol; its lowest bit was first on the line.
    data : in    std_logic_vector(lanes - 1 downto 0);
    -- The symbol belongs to a frame or its preamble.
    valid : in    std_logic;
    -- The PHY reports an error.
    error : in    std_logic;
    -- A byte of a frame; with out_end, bit 0 is '1' if the frame has no errors.
    out_data : out   std_logic_vector(7 downto 0);
    -- out_data is the status of the frame that ends, not a byte.
    out_end   : out   std_logic;
    out_valid : out   std_logic;
    out_ready : in    std_logic
  );
end entity ul_mac_rx;

architecture rtl of ul_mac_rx is

  constant symbols : positive := 8 / lanes;

  -- The repeated symbol of the preamble, and the last symbol of the delimiter.
  function repeated return std_logic_vector is

    variable symbol : std_logic_vector(lanes - 1 downto 0) := (others => '0');

  begin

    for place in 0 to lanes / 2 - 1 loop

      symbol(2 * place) := '1';

    end loop;

    return symbol;

  end function repeated;

  constant preamble  : std_logic_vector(lanes - 1 downto 0) := repeated;
  constant delimiter : std_logic_vector(lanes - 1 downto 0) := "11" & preamble(lanes - 3 downto 0);

  type state_t is (passing_over, hunting, in_frame, ending);

  signal state     : state_t;
  signal begun     : std_logic;
  signal place     : natural range 0 to symbols - 1;
  signal length    : unsigned(10 downto 0);
  signal gathered  : std_logic_vector(7 downto 0);
  signal crc       : std_logic_vector(31 downto 0);
  signal right_now : std_logic;
  signal right     : std_logic;
  signal bad       : std_logic;

begin

  assert lanes = 2 or lanes = 4
    report "ul_mac_rx: lanes is " & integer'image(lanes) & ", expected 2 or 4"
    severity failure;

  right_now <= '1' when crc = crc32_right else
               '0';

  main : process (clk) is

    variable in_byte : std_logic_vector(7 downto 0);

  begin

    if rising_edge(clk) then
      in_byte := data & gathered(7 downto lanes);

      if out_ready = '1' or out_end = '0' then
        out_valid <= '0';
        out_end   <= '0';
      end if;

      case state is

        when passing_over =>
          begun <= '0';
          if valid = '0' then
            state <= hunting;
          end if;

        when hunting =>
          length <= (others => '0');
          place  <= 0;
          crc    <= (others => '1');
          bad    <= '0';
          right  <= '0';
          if valid = '0' then
            begun <= '0';
          elsif error = '1' then
            state <= passing_over;
          elsif data = delimiter and begun = '1' then
            state <= in_frame;
          elsif data = preamble then
            begun <= '1';
          elsif begun = '1' or unsigned(data) /= 0 then
            state <= passing_over;
          end if;

        when in_frame =>
          if place = 0 then
            right <= right_now;
          end if;
          if (out_valid and not out_ready) = '1' then
            bad <= '1';
          end if;
          if valid = '0' or length > longest then
            state <= ending;
          else
            gathered <= in_byte;
            crc      <= crc32_after(crc, data);
            bad      <= bad or error or (out_valid and not out_ready);
            if place = symbols - 1 then
              place     <= 0;
              length    <= length + 1;
              out_valid <= '1';
              out_data  <= in_byte;
            else
              place <= place + 1;
            end if;
          end if;

        when ending =>
          begun <= '0';
          if out_end = '0' then
            out_valid   <= '1';
            out_end     <= '1';
            out_data(0) <= right and not bad and not (out_valid and not out_ready);
            if length < shortest or length > longest then
              out_data(0) <= '0';
            end if;
          elsif out_ready = '1' then
            state <= passing_over;
          end if;

      end case;

      if rst = '1' then
        state     <= passing_over;
        begun     <= '0';
        place     <= 0;
        length    <= (others => '0');
        gathered  <= (others => '0');
        crc       <= (others => '1');
        right     <= '0';
        bad       <= '0';
        out_data  <= (others => '0');
        out_end   <= '0';
        out_valid <= '0';
      end if;
    end if;

  end process main;

end architecture rtl;
