-- SPDX-License-Identifier: BSD-3-Clause
--
-- Bus wrapper: converts the bus-independent interface of `unity_link_core` to an AXI4-Lite master (AMBA IHI 0022).
--
-- AXI addresses bytes: the byte address is the word address times the number of bytes per word, which AXI4-Lite limits
-- to 4 or 8. AXI4-Lite has no locked transfers, so `bus_lock` has no effect: another master may access the bus between
-- the words of a block.
--
-- AXI does not allow a master to withdraw an access. If the core gives up an access (timeout), this wrapper completes
-- it on the bus and discards its response; the next access waits for that, and times out in turn if the slave never
-- responds.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_axi4_lite_master is
  generic (
    -- 32, 64: bits of a word.
    data_bits : positive := 32;
    -- 8 to 32: bits of the core's word address.
    address_bits : positive := 8
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- The core requests an access.
    bus_request : in    std_logic;
    -- '1' for a write, '0' for a read.
    bus_write : in    std_logic;
    -- Word address.
    bus_address : in    std_logic_vector(address_bits - 1 downto 0);
    -- Word to write.
    bus_write_data : in    std_logic_vector(data_bits - 1 downto 0);
    -- Valid with bus_done: the word read.
    bus_read_data : out   std_logic_vector(data_bits - 1 downto 0);
    -- The access ends at this rising edge.
    bus_done : out   std_logic;
    -- Valid with bus_done: '1' if the access failed.
    bus_error : out   std_logic;
    -- AW channel: byte address.
    awaddr : out   std_logic_vector(address_bits + log2_ceil(data_bits / 8) - 1 downto 0);
    -- The other signals of the AW channel; the protection is always "000".
    awprot  : out   std_logic_vector(2 downto 0);
    awvalid : out   std_logic;
    awready : in    std_logic;
    -- W channel; every write covers all bytes of a word.
    wdata  : out   std_logic_vector(data_bits - 1 downto 0);
    wstrb  : out   std_logic_vector(data_bits / 8 - 1 downto 0);
    wvalid : out   std_logic;
    wready : in    std_logic;
    -- B channel; the responses SLVERR and DECERR count as failures.
    bresp  : in    std_logic_vector(1 downto 0);
    bvalid : in    std_logic;
    bready : out   std_logic;
    -- AR channel: byte address.
    araddr : out   std_logic_vector(address_bits + log2_ceil(data_bits / 8) - 1 downto 0);
    -- The other signals of the AR channel; the protection is always "000".
    arprot  : out   std_logic_vector(2 downto 0);
    arvalid : out   std_logic;
    arready : in    std_logic;
    -- R channel; the responses SLVERR and DECERR count as failures.
    rdata  : in    std_logic_vector(data_bits - 1 downto 0);
    rresp  : in    std_logic_vector(1 downto 0);
    rvalid : in    std_logic;
    rready : out   std_logic
  );
end entity ul_axi4_lite_master;

architecture rtl of ul_axi4_lite_master is

  constant byte_bits : natural := log2_ceil(data_bits / 8);

  signal address_valid : std_logic;
  signal write         : std_logic;
  signal data_valid    : std_logic;
  signal waiting       : std_logic;
  -- The core still awaits the response.
  signal wanted   : std_logic;
  signal address  : std_logic_vector(address_bits + byte_bits - 1 downto 0);
  signal answered : std_logic;

begin

  assert data_bits = 32 or data_bits = 64
    report "ul_axi4_lite_master: data_bits is " & integer'image(data_bits) & ", expected 32 or 64"
    severity failure;

  awaddr  <= address;
  araddr  <= address;
  awprot  <= "000";
  arprot  <= "000";
  wstrb   <= (others => '1');
  awvalid <= address_valid and write;
  arvalid <= address_valid and not write;
  wvalid  <= data_valid;
  bready  <= waiting and write;
  rready  <= waiting and not write;

  answered      <= waiting and ((write and bvalid) or (not write and rvalid));
  bus_done      <= answered and wanted and bus_request;
  bus_read_data <= rdata;
  bus_error     <= bresp(1) when write = '1' else
                   rresp(1);

  main : process (clk) is
  begin

    if rising_edge(clk) then
      wanted <= wanted and bus_request;
      if waiting = '0' then
        if bus_request = '1' then
          waiting       <= '1';
          wanted        <= '1';
          write         <= bus_write;
          address       <= bus_address & (byte_bits - 1 downto 0 => '0');
          wdata         <= bus_write_data;
          address_valid <= '1';
          data_valid    <= bus_write;
        end if;
      else
        if (write = '1' and awready = '1') or (write = '0' and arready = '1') then
          address_valid <= '0';
        end if;
        if wready = '1' then
          data_valid <= '0';
        end if;
        if answered = '1' then
          waiting <= '0';
        end if;
      end if;

      if rst = '1' then
        address_valid <= '0';
        data_valid    <= '0';
        waiting       <= '0';
        wanted        <= '0';
        write         <= '0';
        address       <= (others => '0');
        wdata         <= (others => '0');
      end if;
    end if;

  end process main;

end architecture rtl;
