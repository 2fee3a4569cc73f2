-- SPDX-License-Identifier: BSD-3-Clause
--
-- An Ethernet MAC at 100 Mb/s, full duplex, between the pins of a PHY and byte streams in the core's clock domain.
--
-- RMII: both PHY clocks are its REF_CLK of 50 MHz. CRS_DV falls with the carrier and then toggles until the PHY has
-- output the whole frame, so a symbol is valid if CRS_DV is high with it or with the next symbol. MII: RX_CLK and
-- TX_CLK, 25 MHz each. RGMII at 100 Mb/s (the PHY delays RXC): both edges have the same data, so only rising edges are
-- sampled; RX_CTL at the falling edge differs if the PHY reports an error. `phy_tx_clk` is then a clock of 50 MHz,
-- twice TXC. Data changes at the falling edges of TXC, and 10 ns before its rising edges, so TXC needs no delay.
--
-- Each side of the PHY has its own clock, which may be stopped, and is connected by an asynchronous FIFO. A reset is
-- held for four cycles of clk on the PHY's sides, and the core's side stays in reset until both report that they were
-- reset, as in `ul_ft245_sync`.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity ul_mac is
  generic (
    -- "rmii", "mii", "rgmii": interface to the PHY.
    physical : string := "rmii"
  );
  port (
    -- The core's clock, at least 25 MHz; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- REF_CLK, RX_CLK or RXC.
    phy_rx_clk : in    std_logic;
    -- RXD; RMII uses the lower two bits. Clock: phy_rx_clk.
    phy_rxd : in    std_logic_vector(3 downto 0);
    -- CRS_DV, RX_DV or RX_CTL. Clock: phy_rx_clk.
    phy_rx_dv : in    std_logic;
    -- RX_ER of RMII and MII. Clock: phy_rx_clk.
    phy_rx_er : in    std_logic;
    -- REF_CLK, TX_CLK, or a clock of 50 MHz for RGMII.
    phy_tx_clk : in    std_logic;
    -- TXD; RMII uses the lower two bits. Clock: phy_tx_clk.
    phy_txd : out   std_logic_vector(3 downto 0);
    -- TX_EN or TX_CTL. Clock: phy_tx_clk.
    phy_tx_en : out   std_logic;
    -- TXC of RGMII. Clock: phy_tx_clk.
    phy_txc : out   std_logic;
    -- A byte of a frame; with rx_end, bit 0 is '1' if the frame has no errors.
    rx_data : out   std_logic_vector(7 downto 0);
    -- rx_data is the status of the frame that ends, not a byte.
    rx_end : out   std_logic;
    -- rx_data is valid.
    rx_valid : out   std_logic;
    -- The reader accepts rx_data. A byte that is not accepted in time makes its frame bad.
    rx_ready : in    std_logic;
    -- A byte of a frame to send, without preamble, padding and frame check sequence.
    tx_data : in    std_logic_vector(7 downto 0);
    -- The byte is the last one of its frame.
    tx_last : in    std_logic;
    -- tx_data is valid. Once a frame has begun, each byte must be valid in time; otherwise the frame ends with a wrong
    -- frame check sequence.
    tx_valid : in    std_logic;
    -- The reader accepts the byte.
    tx_ready : out   std_logic
  );
end entity ul_mac;

architecture rtl of ul_mac is

  function lanes_of (name : string) return positive is
  begin

    if name = "rmii" then
      return 2;
    end if;
    return 4;

  end function lanes_of;

  constant lanes : positive := lanes_of(physical);
  constant depth : positive := 8;

  subtype symbol_t is std_logic_vector(lanes - 1 downto 0);

  signal rst_request : std_logic_vector(3 downto 0);
  signal core_rst    : std_logic;
  signal rx_up_seen  : std_logic;
  signal tx_up_seen  : std_logic;

  -- Domain of the receiver: levels of the pins at the last edge, and the inputs of the receiver.
  signal rx_rst     : std_logic;
  signal rx_up      : std_logic;
  signal data_first : symbol_t;
  signal dv_first   : std_logic;
  signal er_first   : std_logic;
  signal dv_between : std_logic;
  signal data_now   : symbol_t;
  signal dv_now     : std_logic;
  signal er_now     : std_logic;
  signal data_was   : symbol_t;
  signal dv_was     : std_logic;
  signal er_was     : std_logic;
  signal rx_byte    : std_logic_vector(8 downto 0);
  signal rx_waits   : std_logic;
  signal rx_taken   : std_logic;
  signal rx_entry   : std_logic_vector(8 downto 0);

  -- Domain of the transmitter.
  signal tx_rst   : std_logic;
  signal tx_up    : std_logic;
  signal tick     : std_logic;
  signal symbol   : symbol_t;
  signal enable   : std_logic;
  signal tx_entry : std_logic_vector(8 downto 0);
  signal tx_byte  : std_logic_vector(8 downto 0);
  signal tx_waits : std_logic;
  signal tx_taken : std_logic;

begin

  assert physical = "rmii" or physical = "mii" or physical = "rgmii"
    report "ul_mac: physical is """ & physical & """, expected ""rmii"", ""mii"" or ""rgmii"""
    severity failure;

  core_reset : process (clk) is
  begin

    if rising_edge(clk) then
      rst_request <= rst_request(2 downto 0) & '0';
      core_rst    <= rst_request(3) or not (rx_up_seen and tx_up_seen);
      if rst = '1' then
        rst_request <= (others => '1');
        core_rst    <= '1';
      end if;
    end if;

  end process core_reset;

  rx_reset : entity work.ul_reset_synchroniser
    port map (
      clk   => phy_rx_clk,
      cause => rst_request(3),
      rst   => rx_rst
    );

  tx_reset : entity work.ul_reset_synchroniser
    port map (
      clk   => phy_tx_clk,
      cause => rst_request(3),
      rst   => tx_rst
    );

  rx_is_up : process (phy_rx_clk, rx_rst) is
  begin

    if rx_rst = '1' then
      rx_up <= '0';
    elsif rising_edge(phy_rx_clk) then
      rx_up <= '1';
    end if;

  end process rx_is_up;

  tx_is_up : process (phy_tx_clk, tx_rst) is
  begin

    if tx_rst = '1' then
      tx_up <= '0';
    elsif rising_edge(phy_tx_clk) then
      tx_up <= '1';
    end if;

  end process tx_is_up;

  rx_up_crossing : entity work.ul_synchroniser
    port map (
      clk  => clk,
      rst  => rst_request(3),
      d(0) => rx_up,
      q(0) => rx_up_seen
    );

  tx_up_crossing : entity work.ul_synchroniser
    port map (
      clk  => clk,
      rst  => rst_request(3),
      d(0) => tx_up,
      q(0) => tx_up_seen
    );

  -- Input pins.

  rx_pins : process (phy_rx_clk) is
  begin

    if rising_edge(phy_rx_clk) then
      data_first <= phy_rxd(lanes - 1 downto 0);
      er_first   <= phy_rx_er;
      data_was   <= data_now;
      er_was     <= er_now;
      if rx_rst = '1' then
        data_first <= (others => '0');
        er_first   <= '0';
        data_was   <= (others => '0');
        er_was     <= '0';
      end if;
    end if;

  end process rx_pins;

  rmii_in : if physical = "rmii" generate

    -- CRS_DV rises asynchronously, with the carrier.
    carrier_crossing : entity work.ul_synchroniser
      port map (
        clk  => phy_rx_clk,
        rst  => rx_rst,
        d(0) => phy_rx_dv,
        q(0) => dv_now
      );

    behind_it : process (phy_rx_clk) is
    begin

      if rising_edge(phy_rx_clk) then
        data_now <= data_first;
        er_now   <= er_first;
        dv_first <= dv_now;
        if rx_rst = '1' then
          data_now <= (others => '0');
          er_now   <= '0';
          dv_first <= '0';
        end if;
      end if;

    end process behind_it;

    dv_was <= dv_first or dv_now;

  end generate rmii_in;

  mii_in : if physical /= "rmii" generate

    dv_pin : process (phy_rx_clk) is
    begin

      if rising_edge(phy_rx_clk) then
        dv_first <= phy_rx_dv;
        dv_was   <= dv_first;
        if rx_rst = '1' then
          dv_first <= '0';
          dv_was   <= '0';
        end if;
      end if;

    end process dv_pin;

    data_now <= data_first;
    dv_now   <= dv_first;

  end generate mii_in;

  mii_error : if physical = "mii" generate

    er_now <= er_first;

  end generate mii_error;

  rgmii_error : if physical = "rgmii" generate

    half_way : process (phy_rx_clk) is
    begin

      if falling_edge(phy_rx_clk) then
        dv_between <= phy_rx_dv;
        if rx_rst = '1' then
          dv_between <= '0';
        end if;
      end if;

    end process half_way;

    er_now <= dv_between xor dv_first;

  end generate rgmii_error;

  mac_rx_inst : entity work.ul_mac_rx
    generic map (
      lanes => lanes
    )
    port map (
      clk       => phy_rx_clk,
      rst       => rx_rst,
      data      => data_was,
      valid     => dv_was,
      error     => er_was,
      out_data  => rx_byte(7 downto 0),
      out_end   => rx_byte(8),
      out_valid => rx_waits,
      out_ready => rx_taken
    );

  rx_fifo : entity work.ul_fifo_async
    generic map (
      width => 9,
      depth => depth
    )
    port map (
      in_clk    => phy_rx_clk,
      in_rst    => rx_rst,
      in_data   => rx_byte,
      in_valid  => rx_waits,
      in_ready  => rx_taken,
      in_level  => open,
      out_clk   => clk,
      out_rst   => core_rst,
      out_data  => rx_entry,
      out_valid => rx_valid,
      out_ready => rx_ready
    );

  rx_data <= rx_entry(7 downto 0);
  rx_end  <= rx_entry(8);

  -- Output pins.

  tx_entry <= tx_last & tx_data;

  tx_fifo : entity work.ul_fifo_async
    generic map (
      width => 9,
      depth => depth
    )
    port map (
      in_clk    => clk,
      in_rst    => core_rst,
      in_data   => tx_entry,
      in_valid  => tx_valid,
      in_ready  => tx_ready,
      in_level  => open,
      out_clk   => phy_tx_clk,
      out_rst   => tx_rst,
      out_data  => tx_byte,
      out_valid => tx_waits,
      out_ready => tx_taken
    );

  mac_tx_inst : entity work.ul_mac_tx
    generic map (
      lanes => lanes
    )
    port map (
      clk      => phy_tx_clk,
      rst      => tx_rst,
      tick     => tick,
      in_data  => tx_byte(7 downto 0),
      in_last  => tx_byte(8),
      in_valid => tx_waits,
      in_ready => tx_taken,
      data     => symbol,
      enable   => enable
    );

  one_edge : if physical /= "rgmii" generate

    tick      <= '1';
    phy_tx_en <= enable;
    phy_txc   <= '0';

    txd : process (symbol) is
    begin

      phy_txd                     <= (others => '0');
      phy_txd(lanes - 1 downto 0) <= symbol;

    end process txd;

  end generate one_edge;

  rgmii_out : if physical = "rgmii" generate

    half : process (phy_tx_clk) is
    begin

      if rising_edge(phy_tx_clk) then
        tick    <= not tick;
        phy_txc <= not tick;
        if tx_rst = '1' then
          tick    <= '0';
          phy_txc <= '0';
        end if;
      end if;

    end process half;

    between : process (phy_tx_clk) is
    begin

      if falling_edge(phy_tx_clk) then
        phy_txd   <= symbol;
        phy_tx_en <= enable;
        if tx_rst = '1' then
          phy_txd   <= (others => '0');
          phy_tx_en <= '0';
        end if;
      end if;

    end process between;

  end generate rgmii_out;

end architecture rtl;
