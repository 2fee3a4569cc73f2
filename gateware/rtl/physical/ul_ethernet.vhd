-- SPDX-License-Identifier: BSD-3-Clause
--
-- Physical layer: Ethernet at 100 Mb/s through RMII, MII, RGMII or a W5500, with all layers between the PHY and the
-- gateway's frames: MAC, ARP, ping, UDP, and the sessions of docs/protocol.md, "Datagrams".
--
-- Received frames pass through `ul_mac` or `ul_w5500` and `ul_network_rx`, which drop frames with errors; then through
-- `ul_record_ring`, which passes each datagram whole or not at all; then to `ul_datagram_reader`, which accepts
-- datagrams of the session and requests without one. Answers of the core are gathered in datagrams by `ul_answer_ring`
-- and sent by `ul_datagram_writer`. A datagram that does not fit into the buffer is dropped and counted. Answers in a
-- session go only to the host that opened it.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_ethernet_pkg.all;

entity ul_ethernet is
  generic (
    -- "rmii", "mii", "rgmii": interface to a PHY; "w5500": SPI of that chip.
    physical : string := "rmii";
    -- At least 25,000,000, for "w5500": frequency of clk in Hz.
    clock_hz : positive := 50_000_000;
    -- 48 bits, a unicast address: MAC address of this gateway.
    mac_address : std_logic_vector(47 downto 0) := x"02554C000001";
    -- 32 bits: IP address of this gateway.
    ip_address : std_logic_vector(31 downto 0) := x"C0A80164";
    -- 1 to 65535: UDP port.
    udp_port : positive := 21_845;
    -- At most 15 ASCII characters: name of the gateway in answers to discovery requests.
    gateway_name : string := "";
    -- As of unity_link_core.
    build_id       : std_logic_vector(31 downto 0) := x"00000000";
    fingerprint    : boolean                       := false;
    crc_bits       : positive                      := 16;
    crc_polynomial : std_logic_vector(31 downto 0) := x"00001021"
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
    -- SCLK of a W5500.
    spi_sck : out   std_logic;
    -- SCSn.
    spi_cs_n : out   std_logic;
    -- MOSI.
    spi_mosi : out   std_logic;
    -- MISO.
    spi_miso : in    std_logic := '0';
    -- RSTn.
    spi_rst_n : out   std_logic;
    -- Byte for the core. It is transferred at the rising edge at which rx_valid and rx_ready are both '1'.
    rx_data : out   std_logic_vector(7 downto 0);
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
    -- The bytes to the core are from a host without a session.
    no_session : out   std_logic;
    -- The core has bytes that may lead to an answer.
    active : in    std_logic;
    -- Cycles since the reset, lower half.
    cycles : in    std_logic_vector(31 downto 0);
    -- Number of datagrams and ARP, ping or discovery requests that were dropped because they did not fit into the
    -- buffer, modulo 65,536.
    dropped : out   unsigned(15 downto 0)
  );
end entity ul_ethernet;

architecture rtl of ul_ethernet is

  constant ring_bytes   : positive := 2048;
  constant header_bytes : positive := 17 + crc_bits / 4 + 1;

  type memory_t is array (0 to 127) of std_logic_vector(7 downto 0);

  signal frame_data  : std_logic_vector(7 downto 0);
  signal frame_end   : std_logic;
  signal frame_valid : std_logic;

  signal write      : std_logic;
  signal write_data : std_logic_vector(7 downto 0);
  signal commit     : std_logic;
  signal rollback   : std_logic;
  signal full       : std_logic;
  signal drops      : std_logic;
  signal lost       : unsigned(15 downto 0);

  signal record_data  : std_logic_vector(7 downto 0);
  signal record_valid : std_logic;
  signal record_ready : std_logic;
  signal trial        : std_logic;
  signal undone       : std_logic;
  signal done         : std_logic;

  signal peers        : memory_t;
  signal peer_write   : std_logic;
  signal peer_at      : peer_address_t;
  signal peer_data    : std_logic_vector(7 downto 0);
  signal reader_at    : peer_address_t;
  signal reader_data  : std_logic_vector(7 downto 0);
  signal writer_at    : peer_address_t;
  signal writer_data  : std_logic_vector(7 downto 0);
  signal opener       : bank_t;
  signal requester    : bank_t;
  signal has_session  : std_logic;
  signal opened       : std_logic;
  signal asking       : std_logic;
  signal asking_plain : std_logic;

  signal job        : job_t;
  signal job_plain  : std_logic;
  signal job_bank   : bank_t;
  signal job_bytes  : unsigned(10 downto 0);
  signal job_carry  : std_logic;
  signal job_done   : std_logic;
  signal echo_taken : std_logic;
  signal hold       : std_logic;
  signal still      : std_logic;
  signal under_way  : std_logic;

  signal whole        : unsigned(10 downto 0);
  signal to_asking    : std_logic;
  signal close        : std_logic;
  signal empty        : std_logic;
  signal answer_data  : std_logic_vector(7 downto 0);
  signal answer_taken : std_logic;

  signal sent_data  : std_logic_vector(7 downto 0);
  signal sent_last  : std_logic;
  signal sent_valid : std_logic;
  signal sent_ready : std_logic;

  -- As LUTs this memory would take 300 of an ECP5.
  attribute ram_style    : string;
  attribute syn_ramstyle : string;

  attribute ram_style of peers    : signal is "block";
  attribute syn_ramstyle of peers : signal is "block_ram";

begin

  assert mac_address(40) = '0'
    report "ul_ethernet: mac_address is a group's, expected one with bit 40 at '0'"
    severity failure;

  assert udp_port <= 65535
    report "ul_ethernet: udp_port is " & integer'image(udp_port) & ", expected 1 to 65535"
    severity failure;

  assert gateway_name'length < find_bytes / 2
    report "ul_ethernet: gateway_name has " & integer'image(gateway_name'length) & " characters, expected at most 15"
    severity failure;

  with_phy : if physical /= "w5500" generate

    mac_inst : entity work.ul_mac
      generic map (
        physical => physical
      )
      port map (
        clk        => clk,
        rst        => rst,
        phy_rx_clk => phy_rx_clk,
        phy_rxd    => phy_rxd,
        phy_rx_dv  => phy_rx_dv,
        phy_rx_er  => phy_rx_er,
        phy_tx_clk => phy_tx_clk,
        phy_txd    => phy_txd,
        phy_tx_en  => phy_tx_en,
        phy_txc    => phy_txc,
        rx_data    => frame_data,
        rx_end     => frame_end,
        rx_valid   => frame_valid,
        rx_ready   => '1',
        tx_data    => sent_data,
        tx_last    => sent_last,
        tx_valid   => sent_valid,
        tx_ready   => sent_ready
      );

    spi_sck   <= '0';
    spi_cs_n  <= '1';
    spi_mosi  <= '0';
    spi_rst_n <= '0';

  end generate with_phy;

  with_w5500 : if physical = "w5500" generate

    w5500_inst : entity work.ul_w5500
      generic map (
        clock_hz    => clock_hz,
        mac_address => mac_address
      )
      port map (
        clk       => clk,
        rst       => rst,
        spi_sck   => spi_sck,
        spi_cs_n  => spi_cs_n,
        spi_mosi  => spi_mosi,
        spi_miso  => spi_miso,
        spi_rst_n => spi_rst_n,
        rx_data   => frame_data,
        rx_end    => frame_end,
        rx_valid  => frame_valid,
        tx_data   => sent_data,
        tx_last   => sent_last,
        tx_valid  => sent_valid,
        tx_ready  => sent_ready
      );

    phy_txd   <= (others => '0');
    phy_tx_en <= '0';
    phy_txc   <= '0';

  end generate with_w5500;

  network_rx_inst : entity work.ul_network_rx
    generic map (
      mac_address => mac_address,
      udp_port    => udp_port
    )
    port map (
      clk        => clk,
      rst        => rst,
      in_data    => frame_data,
      in_end     => frame_end,
      in_valid   => frame_valid,
      write      => write,
      write_data => write_data,
      commit     => commit,
      rollback   => rollback,
      full       => full,
      dropped    => drops
    );

  count_dropped : process (clk) is
  begin

    if rising_edge(clk) then
      if drops = '1' then
        lost <= lost + 1;
      end if;
      if rst = '1' then
        lost <= (others => '0');
      end if;
    end if;

  end process count_dropped;

  dropped <= lost;

  record_ring_inst : entity work.ul_record_ring
    generic map (
      depth => ring_bytes
    )
    port map (
      clk        => clk,
      rst        => rst,
      write      => write,
      write_data => write_data,
      commit     => commit,
      rollback   => rollback,
      full       => full,
      out_data   => record_data,
      out_valid  => record_valid,
      out_ready  => record_ready,
      trial      => trial,
      undone     => undone,
      done       => done
    );

  hosts : process (clk) is
  begin

    if rising_edge(clk) then
      if peer_write = '1' then
        peers(to_integer(unsigned(peer_at))) <= peer_data;
      end if;
      reader_data <= peers(to_integer(unsigned(reader_at)));
      writer_data <= peers(to_integer(unsigned(writer_at)));
    end if;

  end process hosts;

  no_session <= asking;
  under_way  <= active or not empty;

  datagram_reader_inst : entity work.ul_datagram_reader
    generic map (
      mac_address    => mac_address,
      ip_address     => ip_address,
      build_id       => build_id,
      crc_bits       => crc_bits,
      crc_polynomial => crc_polynomial
    )
    port map (
      clk          => clk,
      rst          => rst,
      in_data      => record_data,
      in_valid     => record_valid,
      in_ready     => record_ready,
      trial        => trial,
      undone       => undone,
      done         => done,
      out_data     => rx_data,
      out_valid    => rx_valid,
      out_ready    => rx_ready,
      peer_write   => peer_write,
      peer_at      => peer_at,
      peer_data    => peer_data,
      read_at      => reader_at,
      read_data    => reader_data,
      opener       => opener,
      requester    => requester,
      has_session  => has_session,
      opened       => opened,
      asking       => asking,
      asking_plain => asking_plain,
      job          => job,
      job_plain    => job_plain,
      job_bank     => job_bank,
      job_bytes    => job_bytes,
      job_carry    => job_carry,
      job_done     => job_done,
      echo_taken   => echo_taken,
      active       => under_way,
      hold         => hold,
      still        => still,
      cycles       => cycles
    );

  answer_ring_inst : entity work.ul_answer_ring
    generic map (
      depth => ring_bytes,
      most  => largest_datagram - header_bytes
    )
    port map (
      clk         => clk,
      rst         => rst,
      in_data     => tx_data,
      in_valid    => tx_valid,
      in_ready    => tx_ready,
      has_session => has_session,
      asking      => asking,
      whole       => whole,
      to_asking   => to_asking,
      close       => close,
      empty       => empty,
      out_data    => answer_data,
      out_ready   => answer_taken
    );

  datagram_writer_inst : entity work.ul_datagram_writer
    generic map (
      udp_port       => udp_port,
      gateway_name   => gateway_name,
      fingerprint    => fingerprint,
      crc_bits       => crc_bits,
      crc_polynomial => crc_polynomial
    )
    port map (
      clk          => clk,
      rst          => rst,
      job          => job,
      job_plain    => job_plain,
      job_bank     => job_bank,
      job_bytes    => job_bytes,
      job_carry    => job_carry,
      job_done     => job_done,
      echo_data    => record_data,
      echo_valid   => record_valid,
      echo_taken   => echo_taken,
      opener       => opener,
      requester    => requester,
      has_session  => has_session,
      opened       => opened,
      asking_plain => asking_plain,
      hold         => hold,
      still        => still,
      read_at      => writer_at,
      read_data    => writer_data,
      whole        => whole,
      to_asking    => to_asking,
      close        => close,
      answer_data  => answer_data,
      answer_taken => answer_taken,
      out_data     => sent_data,
      out_last     => sent_last,
      out_valid    => sent_valid,
      out_ready    => sent_ready
    );

end architecture rtl;
