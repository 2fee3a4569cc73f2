-- SPDX-License-Identifier: BSD-3-Clause
--
-- The gateway for use in a design: one medium, chosen by the generic `physical`, and one bus, chosen by `bus_standard`.
--
-- Connect only the pins of the chosen medium and bus: the inputs of the others have defaults that keep them inactive.
-- The layers of the others are not elaborated. The board's top joins bidirectional data pins, because vendors describe
-- tristate pins in different ways. It joins them bit by bit, because each pin has a register of its own that enables
-- its driver: `ft_data(n) <= ft_data_out(n) when ft_data_oe(n) = '1' else 'Z'`.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;
  use work.ul_ethernet_pkg.all;
  use work.unity_link_pkg.all;

entity unity_link is
  generic (
    -- "fifo", "uart", "ft245", "ft245_sync", "rmii", "mii", "rgmii", "w5500": the medium. "ft245" is the asynchronous
    -- FIFO; the last four are Ethernet at 100 Mb/s, "w5500" through the SPI of that chip.
    physical : string := "uart";
    -- 1 to clock_hz / 4: bits per second, for "uart".
    baud : positive := 1_000_000;
    -- For "uart": whether RTS# and CTS# are used. For "fifo": whether the source of bytes respects in_ready. An FT245
    -- always respects it.
    flow_control : boolean := false;
    -- "wishbone", "axi4_lite": the bus. AXI4-Lite needs data_bits of 32 or 64.
    bus_standard : string := "wishbone";
    -- Whether the bus is pipelined Wishbone B4 instead of classic.
    wb_pipelined : boolean := false;
    -- 8 to 64: bits of a word.
    data_bits : positive := 32;
    -- 8 to 32: bits of a word address.
    address_bits : positive := 8;
    -- 2, 3: hex digits of a message ID, for up to 128 or 2,048 requests in flight.
    id_digits : positive := 3;
    -- Whether the gateway has a datalink layer. If false, all frames are plain, for a person at a terminal; a host
    -- needs checked frames.
    checked_frames : boolean := true;
    -- 8, 16, 32: bits of the CRC of a frame.
    crc_bits : positive := 16;
    -- crc_bits bits, not all 0: polynomial of the CRC without its highest term, right-aligned. The default is for 16
    -- bits.
    crc_polynomial : std_logic_vector(31 downto 0) := x"00001021";
    -- 1 to 255: maximum number of words in one block or queue request.
    block_words : positive := 255;
    -- 0 to 256: number of publish groups.
    groups : natural := 16;
    -- 1 to 255: maximum number of addresses in one group.
    group_words : natural := 32;
    -- A power of two, at least group_words + 2: words of the buffer in which the samples of all groups wait for
    -- transmission.
    sample_depth : positive := 256;
    -- At least 1: frequency of clk in Hz, from which all intervals are derived.
    clock_hz : positive := 50_000_000;
    -- 1 to 1000 * clock_hz / (groups + 8): frequency of the base tick in mHz; periodic groups publish at integer
    -- divisions of it.
    base_frequency_millihertz : positive := 100_000_000;
    -- Powers of two, 2 to 32768: bytes of the receive FIFO and of the transmit FIFO.
    rx_fifo_depth : positive := 256;
    tx_fifo_depth : positive := 256;
    -- At least 1: cycles after which an unanswered bus access ends with error 05; the bus is then released for as long.
    bus_timeout : positive := 1024;
    -- Whether the gateway has the command WK. If false, WK is answered with error 02, like all commands that are left
    -- out.
    masked_write : boolean := true;
    -- Whether the gateway has the commands RQ and WQ, for FIFOs at one address.
    queue_commands : boolean := true;
    -- Whether frames of a session may use the compact form; words must have an even number of hex digits then.
    compact : boolean := false;
    -- Whether samples can have a timestamp. If false, the group flag for it is answered with error 06.
    timestamps : boolean := true;
    -- Whether edges of trigger can make groups due. If false, the group flag for it is answered with error 06.
    triggers : boolean := true;
    -- Whether the gateway makes the medium send its buffer at once after an answer.
    send_immediate : boolean := true;
    -- -1 to 254: number of this node on a shared medium; -1 if the medium is not shared.
    node : integer := -1;
    -- Whether only one side may send at a time; groups then publish only on request by GP.
    half_duplex : boolean := false;
    -- 48 bits, a unicast address, for Ethernet: MAC address of the gateway.
    mac_address : std_logic_vector(47 downto 0) := x"02554C000001";
    -- 32 bits, for Ethernet: IP address of the gateway.
    ip_address : std_logic_vector(31 downto 0) := x"C0A80164";
    -- 1 to 65535, for Ethernet: UDP port.
    udp_port : positive := 21_845;
    -- At most 15 ASCII characters, for Ethernet: name of the gateway in answers to discovery requests.
    gateway_name : string := "";
    -- 0 to 15: with half_duplex, bits for which uart_de is '1' before the first start bit, and after the last stop bit.
    driver_lead : natural := 1;
    driver_tail : natural := 0;
    -- Any: build identifier that Q reports.
    build_id : std_logic_vector(31 downto 0) := x"00000000";
    -- Whether build_id is the fingerprint of a spec's address map, which hosts compare with their own.
    fingerprint : boolean := false;
    -- Whether the highest addresses contain a description of the registers, in the format of docs/protocol.md.
    description : boolean := false
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- Serial input from the host, '1' while idle. Clock: none.
    uart_rxd : in    std_logic := '1';
    -- Serial output to the host.
    uart_txd : out   std_logic;
    -- RTS#, used with flow_control. '0': the host may send.
    uart_rts_n : out   std_logic;
    -- CTS#, used with flow_control. '0': the gateway may send. Clock: none.
    uart_cts_n : in    std_logic := '0';
    -- '1': the transceiver drives the line. Always '1' if half_duplex is false.
    uart_de : out   std_logic;
    -- CLKOUT, 60 MHz, for "ft245_sync".
    ft_clkout : in    std_logic := '0';
    -- Data pins, input. The board's top joins ft_data_in, ft_data_out and ft_data_oe bit by bit at the pins. Clock:
    -- ft_clkout.
    ft_data_in : in    std_logic_vector(7 downto 0) := (others => '0');
    -- Data pins, output. Clock: ft_clkout.
    ft_data_out : out   std_logic_vector(7 downto 0);
    -- '1' enables the driver of that data pin. Clock: ft_clkout.
    ft_data_oe : out   std_logic_vector(7 downto 0);
    -- RXF#: '0' if the chip has a byte. Clock: ft_clkout.
    ft_rxf_n : in    std_logic := '1';
    -- TXE#: '0' if the chip accepts a byte. Clock: ft_clkout.
    ft_txe_n : in    std_logic := '1';
    -- RD#, the read strobe. Clock: ft_clkout.
    ft_rd_n : out   std_logic;
    -- WR#, the write strobe. Clock: ft_clkout.
    ft_wr_n : out   std_logic;
    -- OE#, for "ft245_sync": '0' enables the chip's data drivers. Clock: ft_clkout.
    ft_oe_n : out   std_logic;
    -- SIWU#: '0' makes the chip send its buffer at once. Clock: ft_clkout.
    ft_siwu_n : out   std_logic;
    -- For Ethernet: REF_CLK of RMII, RX_CLK of MII, RXC of RGMII.
    phy_rx_clk : in    std_logic := '0';
    -- RXD; RMII uses the lower two bits. Clock: phy_rx_clk.
    phy_rxd : in    std_logic_vector(3 downto 0) := (others => '0');
    -- CRS_DV, RX_DV or RX_CTL. Clock: phy_rx_clk.
    phy_rx_dv : in    std_logic := '0';
    -- RX_ER of RMII and MII. Clock: phy_rx_clk.
    phy_rx_er : in    std_logic := '0';
    -- REF_CLK of RMII, TX_CLK of MII; a clock of 50 MHz for RGMII.
    phy_tx_clk : in    std_logic := '0';
    -- TXD; RMII uses the lower two bits. Clock: phy_tx_clk.
    phy_txd : out   std_logic_vector(3 downto 0);
    -- TX_EN or TX_CTL. Clock: phy_tx_clk.
    phy_tx_en : out   std_logic;
    -- TXC of RGMII. Clock: phy_tx_clk.
    phy_txc : out   std_logic;
    -- SCLK of a W5500, for "w5500".
    spi_sck : out   std_logic;
    -- SCSn.
    spi_cs_n : out   std_logic;
    -- MOSI.
    spi_mosi : out   std_logic;
    -- MISO, which changes after falling edges of SCLK.
    spi_miso : in    std_logic := '0';
    -- RSTn.
    spi_rst_n : out   std_logic;
    -- For Ethernet: number of datagrams that were dropped because they did not fit into the buffer, modulo 65,536.
    phy_dropped : out   unsigned(15 downto 0);
    -- Byte to the gateway, for "fifo". It is transferred at the rising edge at which in_valid and in_ready are both
    -- '1'.
    in_data : in    std_logic_vector(7 downto 0) := (others => '0');
    -- Valid with in_data: '1' if bytes before this one were lost.
    in_lost : in    std_logic := '0';
    -- in_data is valid.
    in_valid : in    std_logic := '0';
    -- The gateway accepts the byte.
    in_ready : out   std_logic;
    -- Byte from the gateway, for "fifo".
    out_data : out   std_logic_vector(7 downto 0);
    -- out_data is valid.
    out_valid : out   std_logic;
    -- The medium accepts the byte.
    out_ready : in    std_logic := '0';
    -- '1' for one cycle: the medium should send the bytes so far without waiting for more.
    out_flush : out   std_logic;
    -- A rising edge makes the group of that number due. High and low times must be at least two cycles. Clock: none.
    trigger : in    std_logic_vector(maximum(groups, 1) - 1 downto 0) := (others => '0');
    -- A bus transaction is in progress; '1' during all accesses that belong to one atomic transaction.
    wb_cyc : out   std_logic;
    -- Strobe: an access is requested, and the signals below are stable.
    wb_stb : out   std_logic;
    -- '1' for a write, '0' for a read.
    wb_we : out   std_logic;
    -- All '1': every access covers a whole word.
    wb_sel : out   std_logic_vector((data_bits + 7) / 8 - 1 downto 0);
    -- Word address.
    wb_adr : out   std_logic_vector(address_bits - 1 downto 0);
    -- Word to write.
    wb_dat_o : out   std_logic_vector(data_bits - 1 downto 0);
    -- The word read, valid with wb_ack.
    wb_dat_i : in    std_logic_vector(data_bits - 1 downto 0) := (others => '0');
    -- The access succeeded.
    wb_ack : in    std_logic := '0';
    -- The access failed: error 04.
    wb_err : in    std_logic := '0';
    -- The access was not executed; the master repeats it, for at most bus_timeout cycles.
    wb_rty : in    std_logic := '0';
    -- With wb_pipelined: the slave does not accept the access yet.
    wb_stall : in    std_logic := '0';
    -- AW channel: byte address.
    axi_awaddr : out   std_logic_vector(address_bits + log2_ceil(data_bits / 8) - 1 downto 0);
    -- The other signals of the AW channel; the protection is always "000".
    axi_awprot  : out   std_logic_vector(2 downto 0);
    axi_awvalid : out   std_logic;
    axi_awready : in    std_logic := '0';
    -- W channel; every write covers all bytes of a word.
    axi_wdata  : out   std_logic_vector(data_bits - 1 downto 0);
    axi_wstrb  : out   std_logic_vector(data_bits / 8 - 1 downto 0);
    axi_wvalid : out   std_logic;
    axi_wready : in    std_logic := '0';
    -- B channel; the responses SLVERR and DECERR are error 04.
    axi_bresp  : in    std_logic_vector(1 downto 0) := (others => '0');
    axi_bvalid : in    std_logic                    := '0';
    axi_bready : out   std_logic;
    -- AR channel: byte address.
    axi_araddr : out   std_logic_vector(address_bits + log2_ceil(data_bits / 8) - 1 downto 0);
    -- The other signals of the AR channel; the protection is always "000".
    axi_arprot  : out   std_logic_vector(2 downto 0);
    axi_arvalid : out   std_logic;
    axi_arready : in    std_logic := '0';
    -- R channel; the responses SLVERR and DECERR are error 04.
    axi_rdata  : in    std_logic_vector(data_bits - 1 downto 0) := (others => '0');
    axi_rresp  : in    std_logic_vector(1 downto 0)             := (others => '0');
    axi_rvalid : in    std_logic                                := '0';
    axi_rready : out   std_logic;
    -- '1' for one cycle, at the time of a sample's timestamp: modules latch their values at the end of this cycle.
    sample_strobe : out   std_logic;
    -- '1' from the cycle after sample_strobe until the last word of the sample was read.
    sample_access : out   std_logic;
    -- '1' for one cycle at each base tick; periodic groups publish at integer divisions of it. It is never delayed, and
    -- also runs without groups.
    base_tick : out   std_logic;
    -- Cycles since the reset; timestamps of samples are its lower half.
    timestamp : out   std_logic_vector(63 downto 0)
  );
end entity unity_link;

architecture rtl of unity_link is

  constant is_ethernet : boolean := physical = "rmii" or physical = "mii" or physical = "rgmii" or physical = "w5500";

  -- Maximum number of frame bytes in a datagram, besides its header.
  constant largest_frame : positive := largest_datagram - 18 - crc_bits / 4;

  -- Length of the longest answer, sample or request in bytes. Only block answers, samples, Q and block requests can be
  -- the longest.
  function longest_frame return positive is

    constant word  : positive := digits_of(data_bits);
    constant q     : positive := 76;
    variable bytes : positive := maximum(2 + maximum(id_digits, digits_of(address_bits) + 2) + word * block_words, q);

  begin

    if groups > 0 then
      bytes := maximum(bytes, 13 + word * group_words);
    end if;
    bytes := maximum(bytes + crc_bits / 4, longest_request(
                                                           data_bits, address_bits, id_digits, crc_bits, block_words,
                                                           groups, group_words, masked_write
                                                         ));
    return bytes + 2;

  end function longest_frame;

  constant longest_answer : positive := longest_frame;

  -- Bytes of buffer in the medium: the ring of `ul_ethernet`, less the bytes that precede frames in a datagram.
  function room_of_medium return natural is
  begin

    if is_ethernet then
      return 1792;
    end if;
    return 0;

  end function room_of_medium;

  -- Whether the medium stops the host when the receive FIFO is full.
  constant medium_waits : boolean := flow_control or physical = "ft245" or physical = "ft245_sync";

  signal rx_data    : std_logic_vector(7 downto 0);
  signal rx_lost    : std_logic;
  signal rx_valid   : std_logic;
  signal rx_ready   : std_logic;
  signal tx_data    : std_logic_vector(7 downto 0);
  signal tx_valid   : std_logic;
  signal tx_ready   : std_logic;
  signal flush      : std_logic;
  signal active     : std_logic;
  signal now        : std_logic_vector(63 downto 0);
  signal no_session : std_logic;
  signal ticks      : std_logic_vector(31 downto 0);

  signal bus_request    : std_logic;
  signal bus_write      : std_logic;
  signal bus_lock       : std_logic;
  signal bus_ahead      : std_logic;
  signal bus_next       : std_logic;
  signal bus_address    : std_logic_vector(address_bits - 1 downto 0);
  signal bus_write_data : std_logic_vector(data_bits - 1 downto 0);
  signal bus_read_data  : std_logic_vector(data_bits - 1 downto 0);
  signal bus_done       : std_logic;
  signal bus_error      : std_logic;

begin

  assert physical = "fifo" or physical = "uart" or physical = "ft245" or physical = "ft245_sync" or is_ethernet
    report "unity_link: physical is """ & physical & """, expected ""fifo"", ""uart"", ""ft245"", ""ft245_sync"", "
           & """rmii"", ""mii"", ""rgmii"" or ""w5500"""
    severity failure;

  assert not is_ethernet or (node < 0 and not half_duplex)
    report "unity_link: physical is """ & physical & """ with node or half_duplex, expected neither: each has an address"
    severity failure;

  assert not is_ethernet or longest_answer <= largest_frame
    report "unity_link: with block_words " & integer'image(block_words) & ", groups " & integer'image(groups)
           & " and group_words " & integer'image(group_words) & " a frame has up to " & integer'image(longest_answer)
           & " bytes, expected at most " & integer'image(largest_frame) & ", which a datagram holds: take fewer words"
    severity failure;

  assert not is_ethernet or clock_hz >= 25_000_000
    report "unity_link: physical is """ & physical & """ with clock_hz " & integer'image(clock_hz)
           & ", expected at least 25000000"
    severity failure;

  assert bus_standard = "wishbone" or bus_standard = "axi4_lite"
    report "unity_link: bus_standard is """ & bus_standard & """, expected ""wishbone"" or ""axi4_lite"""
    severity failure;

  core_inst : entity work.unity_link_core
    generic map (
      flow_control              => medium_waits,
      data_bits                 => data_bits,
      address_bits              => address_bits,
      id_digits                 => id_digits,
      checked_frames            => checked_frames,
      crc_bits                  => crc_bits,
      crc_polynomial            => crc_polynomial,
      block_words               => block_words,
      groups                    => groups,
      group_words               => group_words,
      sample_depth              => sample_depth,
      clock_hz                  => clock_hz,
      base_frequency_millihertz => base_frequency_millihertz,
      rx_fifo_depth             => rx_fifo_depth,
      tx_fifo_depth             => tx_fifo_depth,
      medium_bytes              => room_of_medium,
      bus_timeout               => bus_timeout,
      bus_pipelined             => bus_standard = "wishbone" and wb_pipelined,
      masked_write              => masked_write,
      queue_commands            => queue_commands,
      compact                   => compact,
      timestamps                => timestamps,
      triggers                  => triggers,
      send_immediate            => send_immediate,
      node                      => node,
      half_duplex               => half_duplex,
      build_id                  => build_id,
      fingerprint               => fingerprint,
      description               => description
    )
    port map (
      clk            => clk,
      rst            => rst,
      rx_data        => rx_data,
      rx_lost        => rx_lost,
      rx_valid       => rx_valid,
      rx_ready       => rx_ready,
      tx_data        => tx_data,
      tx_valid       => tx_valid,
      tx_ready       => tx_ready,
      no_session     => no_session,
      flush          => flush,
      active         => active,
      trigger        => trigger,
      bus_request    => bus_request,
      bus_write      => bus_write,
      bus_lock       => bus_lock,
      bus_ahead      => bus_ahead,
      bus_next       => bus_next,
      bus_address    => bus_address,
      bus_write_data => bus_write_data,
      bus_read_data  => bus_read_data,
      bus_done       => bus_done,
      bus_error      => bus_error,
      sample_strobe  => sample_strobe,
      sample_access  => sample_access,
      base_tick      => base_tick,
      timestamp      => now
    );

  timestamp <= now;
  ticks     <= now(31 downto 0);

  with_wishbone : if bus_standard = "wishbone" generate

    wishbone_master_inst : entity work.ul_wishbone_master
      generic map (
        data_bits    => data_bits,
        address_bits => address_bits,
        pipelined    => wb_pipelined
      )
      port map (
        clk            => clk,
        rst            => rst,
        bus_request    => bus_request,
        bus_write      => bus_write,
        bus_lock       => bus_lock,
        bus_ahead      => bus_ahead,
        bus_next       => bus_next,
        bus_address    => bus_address,
        bus_write_data => bus_write_data,
        bus_read_data  => bus_read_data,
        bus_done       => bus_done,
        bus_error      => bus_error,
        cyc            => wb_cyc,
        stb            => wb_stb,
        we             => wb_we,
        sel            => wb_sel,
        adr            => wb_adr,
        dat_o          => wb_dat_o,
        dat_i          => wb_dat_i,
        ack            => wb_ack,
        err            => wb_err,
        rty            => wb_rty,
        stall          => wb_stall
      );

    axi_awaddr  <= (others => '0');
    axi_awprot  <= (others => '0');
    axi_awvalid <= '0';
    axi_wdata   <= (others => '0');
    axi_wstrb   <= (others => '0');
    axi_wvalid  <= '0';
    axi_bready  <= '0';
    axi_araddr  <= (others => '0');
    axi_arprot  <= (others => '0');
    axi_arvalid <= '0';
    axi_rready  <= '0';

  end generate with_wishbone;

  with_axi4_lite : if bus_standard = "axi4_lite" generate

    bus_next <= '0';

    axi4_lite_master_inst : entity work.ul_axi4_lite_master
      generic map (
        data_bits    => data_bits,
        address_bits => address_bits
      )
      port map (
        clk            => clk,
        rst            => rst,
        bus_request    => bus_request,
        bus_write      => bus_write,
        bus_address    => bus_address,
        bus_write_data => bus_write_data,
        bus_read_data  => bus_read_data,
        bus_done       => bus_done,
        bus_error      => bus_error,
        awaddr         => axi_awaddr,
        awprot         => axi_awprot,
        awvalid        => axi_awvalid,
        awready        => axi_awready,
        wdata          => axi_wdata,
        wstrb          => axi_wstrb,
        wvalid         => axi_wvalid,
        wready         => axi_wready,
        bresp          => axi_bresp,
        bvalid         => axi_bvalid,
        bready         => axi_bready,
        araddr         => axi_araddr,
        arprot         => axi_arprot,
        arvalid        => axi_arvalid,
        arready        => axi_arready,
        rdata          => axi_rdata,
        rresp          => axi_rresp,
        rvalid         => axi_rvalid,
        rready         => axi_rready
      );

    wb_cyc   <= '0';
    wb_stb   <= '0';
    wb_we    <= '0';
    wb_sel   <= (others => '0');
    wb_adr   <= (others => '0');
    wb_dat_o <= (others => '0');

  end generate with_axi4_lite;

  with_fifo : if physical = "fifo" generate

    fifo_port_inst : entity work.ul_fifo_port
      port map (
        clk       => clk,
        rst       => rst,
        in_data   => in_data,
        in_lost   => in_lost,
        in_valid  => in_valid,
        in_ready  => in_ready,
        out_data  => out_data,
        out_valid => out_valid,
        out_ready => out_ready,
        out_flush => out_flush,
        rx_data   => rx_data,
        rx_lost   => rx_lost,
        rx_valid  => rx_valid,
        rx_ready  => rx_ready,
        tx_data   => tx_data,
        tx_valid  => tx_valid,
        tx_ready  => tx_ready,
        flush     => flush
      );

  end generate with_fifo;

  without_fifo : if physical /= "fifo" generate

    in_ready  <= '0';
    out_data  <= (others => '0');
    out_valid <= '0';
    out_flush <= '0';

  end generate without_fifo;

  with_uart : if physical = "uart" generate

    uart_inst : entity work.ul_uart
      generic map (
        clock_hz     => clock_hz,
        baud         => baud,
        flow_control => flow_control,
        half_duplex  => half_duplex,
        driver_lead  => driver_lead,
        driver_tail  => driver_tail
      )
      port map (
        clk           => clk,
        rst           => rst,
        rxd           => uart_rxd,
        txd           => uart_txd,
        rts_n         => uart_rts_n,
        cts_n         => uart_cts_n,
        driver_enable => uart_de,
        rx_data       => rx_data,
        rx_lost       => rx_lost,
        rx_valid      => rx_valid,
        rx_ready      => rx_ready,
        tx_data       => tx_data,
        tx_valid      => tx_valid,
        tx_ready      => tx_ready,
        flush         => flush
      );

  end generate with_uart;

  without_uart : if physical /= "uart" generate

    uart_txd   <= '1';
    uart_rts_n <= '1';
    uart_de    <= '0';

  end generate without_uart;

  with_ft245 : if physical = "ft245" generate

    ft245_async_inst : entity work.ul_ft245_async
      generic map (
        clock_hz => clock_hz
      )
      port map (
        clk      => clk,
        rst      => rst,
        data_in  => ft_data_in,
        data_out => ft_data_out,
        data_oe  => ft_data_oe,
        rxf_n    => ft_rxf_n,
        txe_n    => ft_txe_n,
        rd_n     => ft_rd_n,
        wr_n     => ft_wr_n,
        siwu_n   => ft_siwu_n,
        rx_data  => rx_data,
        rx_lost  => rx_lost,
        rx_valid => rx_valid,
        rx_ready => rx_ready,
        tx_data  => tx_data,
        tx_valid => tx_valid,
        tx_ready => tx_ready,
        flush    => flush
      );

    ft_oe_n <= '1';

  end generate with_ft245;

  with_ft245_sync : if physical = "ft245_sync" generate

    ft245_sync_inst : entity work.ul_ft245_sync
      port map (
        clk      => clk,
        rst      => rst,
        clkout   => ft_clkout,
        data_in  => ft_data_in,
        data_out => ft_data_out,
        data_oe  => ft_data_oe,
        rxf_n    => ft_rxf_n,
        txe_n    => ft_txe_n,
        rd_n     => ft_rd_n,
        wr_n     => ft_wr_n,
        oe_n     => ft_oe_n,
        siwu_n   => ft_siwu_n,
        rx_data  => rx_data,
        rx_lost  => rx_lost,
        rx_valid => rx_valid,
        rx_ready => rx_ready,
        tx_data  => tx_data,
        tx_valid => tx_valid,
        tx_ready => tx_ready,
        flush    => flush
      );

  end generate with_ft245_sync;

  without_ft245 : if physical /= "ft245" and physical /= "ft245_sync" generate

    ft_data_out <= (others => '0');
    ft_data_oe  <= (others => '0');
    ft_rd_n     <= '1';
    ft_wr_n     <= '1';
    ft_oe_n     <= '1';
    ft_siwu_n   <= '1';

  end generate without_ft245;

  with_ethernet : if is_ethernet generate

    ethernet_inst : entity work.ul_ethernet
      generic map (
        physical       => physical,
        clock_hz       => clock_hz,
        mac_address    => mac_address,
        ip_address     => ip_address,
        udp_port       => udp_port,
        gateway_name   => gateway_name,
        build_id       => build_id,
        fingerprint    => fingerprint,
        crc_bits       => crc_bits,
        crc_polynomial => crc_polynomial
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
        spi_sck    => spi_sck,
        spi_cs_n   => spi_cs_n,
        spi_mosi   => spi_mosi,
        spi_miso   => spi_miso,
        spi_rst_n  => spi_rst_n,
        rx_data    => rx_data,
        rx_valid   => rx_valid,
        rx_ready   => rx_ready,
        tx_data    => tx_data,
        tx_valid   => tx_valid,
        tx_ready   => tx_ready,
        no_session => no_session,
        active     => active,
        cycles     => ticks,
        dropped    => phy_dropped
      );

    rx_lost <= '0';

  end generate with_ethernet;

  without_ethernet : if not is_ethernet generate

    phy_txd     <= (others => '0');
    phy_tx_en   <= '0';
    phy_txc     <= '0';
    phy_dropped <= (others => '0');
    no_session  <= '0';
    spi_sck     <= '0';
    spi_cs_n    <= '1';
    spi_mosi    <= '0';
    spi_rst_n   <= '0';

  end generate without_ethernet;

end architecture rtl;
