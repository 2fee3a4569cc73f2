-- SPDX-License-Identifier: BSD-3-Clause
-- Replaces the gateway while a user's top is compared with its Verilog. It accesses random addresses on the Wishbone
-- bus and writes random words. The pins of the medium output a hash of the words that were read.

architecture bus_noise of unity_link is

  signal first, second : unsigned(63 downto 0)                        := x"0123456789ABCDEF";
  signal now           : unsigned(63 downto 0)                        := (others => '0');
  signal left          : unsigned(5 downto 0)                         := (others => '0');
  signal asks          : std_logic                                    := '0';
  signal owed          : std_logic                                    := '0';
  signal writes        : std_logic                                    := '0';
  signal address       : std_logic_vector(address_bits - 1 downto 0) := (others => '0');
  signal word          : std_logic_vector(data_bits - 1 downto 0)    := (others => '0');
  signal was_read      : std_logic_vector(7 downto 0)                 := (others => '0');

  -- A vector of any width that repeats the upper 48 bits of a number.
  function bits_of (
    number : unsigned;
    width  : positive
  ) return std_logic_vector is

    variable result : std_logic_vector(width - 1 downto 0);

  begin

    for place in result'range loop
      result(place) := number(number'high - place mod 48);
    end loop;
    return result;

  end function bits_of;

  function folded (
    value : std_logic_vector
  ) return std_logic_vector is

    variable result : std_logic_vector(7 downto 0) := (others => '0');

  begin

    for place in 0 to value'length - 1 loop
      result(place mod 8) := result(place mod 8) xor value(value'low + place);
    end loop;
    return result;

  end function folded;

begin

  noise : process (clk) is
  begin

    if rising_edge(clk) then
      first  <= resize(first * x"5851F42D4C957F2D", 64) + 1442695040;
      second <= resize(second * x"14057B7EF767814F", 64) + 1442695041;
      now    <= now + 1;
      left   <= left - 1;
      if wb_pipelined and wb_stall = '0' then
        asks <= '0';
      end if;
      if wb_ack = '1' and writes = '0' then
        was_read <= folded(wb_dat_i) xor (was_read(6 downto 0) & was_read(7));
      end if;
      if wb_ack = '1' or wb_err = '1' or left = 0 then
        asks <= '0';
        owed <= '0';
      end if;
      if owed = '0' and first(63) = '1' then
        asks    <= '1';
        owed    <= '1';
        left    <= (others => '1');
        writes  <= first(62);
        address <= bits_of(second, address_bits);
        word    <= bits_of(first(60 downto 0), data_bits);
        -- Prefer low addresses and small numbers.
        for place in 3 to address_bits - 1 loop
          if second(10 downto 9) = "00" or (place > 4 and second(9) = '1') then
            address(place) <= '0';
          end if;
        end loop;
        if second(12 downto 11) = "00" then
          word(data_bits - 1 downto 4) <= (others => second(8));
        end if;
      end if;
    end if;

  end process noise;

  wb_cyc        <= owed;
  wb_stb        <= asks;
  wb_we         <= writes;
  wb_sel        <= (others => '1');
  wb_adr        <= address;
  wb_dat_o      <= word;
  sample_strobe <= first(50) and first(51);
  sample_access <= first(52);
  base_tick     <= first(53) and first(54);
  timestamp     <= std_logic_vector(now);

  uart_txd    <= was_read(0);
  uart_rts_n  <= was_read(1);
  uart_de     <= was_read(2);
  ft_data_out <= was_read;
  ft_data_oe  <= (others => '0');
  ft_rd_n     <= was_read(3);
  ft_wr_n     <= was_read(4);
  ft_oe_n     <= was_read(5);
  ft_siwu_n   <= was_read(6);
  phy_txd     <= was_read(3 downto 0);
  phy_tx_en   <= was_read(4);
  phy_txc     <= was_read(5);
  spi_sck     <= was_read(4);
  spi_cs_n    <= was_read(5);
  spi_mosi    <= was_read(6);
  spi_rst_n   <= was_read(7);
  phy_dropped <= unsigned(was_read) & unsigned(was_read);
  in_ready    <= was_read(0);
  out_data    <= was_read;
  out_valid   <= was_read(1);
  out_flush   <= was_read(2);
  axi_awaddr  <= (others => was_read(0));
  axi_awprot  <= "000";
  axi_awvalid <= first(40);
  axi_wdata   <= word;
  axi_wstrb   <= (others => '1');
  axi_wvalid  <= first(41);
  axi_bready  <= '1';
  axi_araddr  <= (others => was_read(1));
  axi_arprot  <= "000";
  axi_arvalid <= first(42);
  axi_rready  <= '1';

end architecture bus_noise;
