-- A whole gateway on AXI4-Lite: the core, the other bus wrapper, and bytes from wherever they come.
--
-- `unity_link` is the same with a Wishbone wrapper and a choice of media: this is how to join the core to a bus of one's
-- own.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.math_pkg.all;

entity axi4_lite_gateway is
  generic (
    data_bits    : positive := 32;
    address_bits : positive := 8;
    bus_timeout  : positive := 64
  );
  port (
    clk       : in    std_logic;
    rst       : in    std_logic;
    in_data   : in    std_logic_vector(7 downto 0);
    in_valid  : in    std_logic;
    in_ready  : out   std_logic;
    out_data  : out   std_logic_vector(7 downto 0);
    out_valid : out   std_logic;
    out_ready : in    std_logic;
    awaddr    : out   std_logic_vector(address_bits + log2_ceil(data_bits / 8) - 1 downto 0);
    awprot    : out   std_logic_vector(2 downto 0);
    awvalid   : out   std_logic;
    awready   : in    std_logic;
    wdata     : out   std_logic_vector(data_bits - 1 downto 0);
    wstrb     : out   std_logic_vector(data_bits / 8 - 1 downto 0);
    wvalid    : out   std_logic;
    wready    : in    std_logic;
    bresp     : in    std_logic_vector(1 downto 0);
    bvalid    : in    std_logic;
    bready    : out   std_logic;
    araddr    : out   std_logic_vector(address_bits + log2_ceil(data_bits / 8) - 1 downto 0);
    arprot    : out   std_logic_vector(2 downto 0);
    arvalid   : out   std_logic;
    arready   : in    std_logic;
    rdata     : in    std_logic_vector(data_bits - 1 downto 0);
    rresp     : in    std_logic_vector(1 downto 0);
    rvalid    : in    std_logic;
    rready    : out   std_logic
  );
end entity axi4_lite_gateway;

architecture bench of axi4_lite_gateway is

  signal bus_request    : std_logic;
  signal bus_write      : std_logic;
  signal bus_address    : std_logic_vector(address_bits - 1 downto 0);
  signal bus_write_data : std_logic_vector(data_bits - 1 downto 0);
  signal bus_read_data  : std_logic_vector(data_bits - 1 downto 0);
  signal bus_done       : std_logic;
  signal bus_error      : std_logic;

begin

  core : entity work.unity_link_core
    generic map (
      data_bits    => data_bits,
      address_bits => address_bits,
      bus_timeout  => bus_timeout
    )
    port map (
      clk            => clk,
      rst            => rst,
      rx_data        => in_data,
      rx_valid       => in_valid,
      rx_ready       => in_ready,
      tx_data        => out_data,
      tx_valid       => out_valid,
      tx_ready       => out_ready,
      flush          => open,
      bus_request    => bus_request,
      bus_write      => bus_write,
      bus_lock       => open,
      bus_address    => bus_address,
      bus_write_data => bus_write_data,
      bus_read_data  => bus_read_data,
      bus_done       => bus_done,
      bus_error      => bus_error,
      sample_strobe  => open,
      sample_access  => open
    );

  axi4_lite_master : entity work.axi4_lite_master
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
      awaddr         => awaddr,
      awprot         => awprot,
      awvalid        => awvalid,
      awready        => awready,
      wdata          => wdata,
      wstrb          => wstrb,
      wvalid         => wvalid,
      wready         => wready,
      bresp          => bresp,
      bvalid         => bvalid,
      bready         => bready,
      araddr         => araddr,
      arprot         => arprot,
      arvalid        => arvalid,
      arready        => arready,
      rdata          => rdata,
      rresp          => rresp,
      rvalid         => rvalid,
      rready         => rready
    );

end architecture bench;
