-- The gateway as a design uses it: one medium, chosen by the generic `physical`, and a Wishbone B4 master.
--
-- Only the pins of the medium in use need to be connected: the inputs of the others have defaults that keep them still.
-- The layers that were not chosen are not elaborated. Bidirectional data pins are joined by the board's top, because how
-- a tristate pin is described differs between vendors: `ft_data <= ft_data_out when ft_data_oe = '1' else (others => 'Z')`.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.unity_link_pkg.all;

entity unity_link is
  generic (
    -- "fifo", "uart", "ft245" (asynchronous) or "ft245_sync".
    physical                  : string                        := "uart";
    -- UART: bits a second, and whether RTS# and CTS# are used.
    baud                      : positive                      := 1_000_000;
    uart_flow_control         : boolean                       := false;
    -- Wishbone B4 pipelined instead of classic.
    wb_pipelined              : boolean                       := false;
    -- Widths: 8 to 64 bits a word, 8 to 32 bits an address (which counts words), 2 or 3 digits an ID.
    data_bits                 : positive                      := 32;
    address_bits              : positive                      := 8;
    id_digits                 : positive                      := 2;
    -- 8, 16 or 32 bits; the polynomial without its highest term, right-aligned.
    crc_bits                  : positive                      := 8;
    crc_polynomial            : std_logic_vector(31 downto 0) := x"00000007";
    -- Most words in one block or queue request, 1 to 255.
    block_words               : positive                      := 255;
    -- Publish groups, 0 to 256, and the most addresses in one, 1 to 255.
    groups                    : natural                       := 16;
    group_words               : positive                      := 32;
    -- Words that the samples of all groups may wait in until they are sent: a power of two.
    sample_depth              : positive                      := 256;
    -- Frequency of clk in Hz, and of the base tick of periodic groups in mHz.
    clock_hz                  : positive                      := 50_000_000;
    base_frequency_millihertz : positive                      := 100_000_000;
    -- Bytes; powers of two.
    rx_fifo_depth             : positive                      := 256;
    tx_fifo_depth             : positive                      := 256;
    -- Cycles after which a bus access that is not answered ends with error 05.
    bus_timeout               : positive                      := 1024;
    -- Features: what is switched off costs nothing and is answered with error 02 (a command) or 06 (a flag).
    masked_write              : boolean                       := true;
    queue_commands            : boolean                       := true;
    timestamps                : boolean                       := true;
    triggers                  : boolean                       := true;
    send_immediate            : boolean                       := true;
    -- Number of this node on a medium that several share (protocol section 7), 0 to 254, or -1: not shared.
    node                      : integer                       := -1;
    -- What `Q` reports as the build identifier.
    build_id                  : std_logic_vector(31 downto 0) := x"00000000"
  );
  port (
    clk            : in    std_logic;
    -- Synchronous, active high; one cycle is enough.
    rst            : in    std_logic;
    -- "uart".
    uart_rxd       : in    std_logic := '1';
    uart_txd       : out   std_logic;
    uart_rts_n     : out   std_logic;
    uart_cts_n     : in    std_logic := '0';
    -- "ft245" and "ft245_sync"; ft_clkout and ft_oe_n with the latter only.
    ft_clkout      : in    std_logic := '0';
    ft_data_in     : in    std_logic_vector(7 downto 0) := (others => '0');
    ft_data_out    : out   std_logic_vector(7 downto 0);
    ft_data_oe     : out   std_logic;
    ft_rxf_n       : in    std_logic := '1';
    ft_txe_n       : in    std_logic := '1';
    ft_rd_n        : out   std_logic;
    ft_wr_n        : out   std_logic;
    ft_oe_n        : out   std_logic;
    ft_siwu_n      : out   std_logic;
    -- "fifo": bytes in and out, with the handshake that all parts of the gateware use.
    in_data        : in    std_logic_vector(7 downto 0) := (others => '0');
    in_lost        : in    std_logic := '0';
    in_valid       : in    std_logic := '0';
    in_ready       : out   std_logic;
    out_data       : out   std_logic_vector(7 downto 0);
    out_valid      : out   std_logic;
    out_ready      : in    std_logic := '0';
    out_flush      : out   std_logic;
    -- A rising edge makes the group of that number due (protocol section 2, group flag 1).
    trigger        : in    std_logic_vector(maximum(groups, 1) - 1 downto 0) := (others => '0');
    -- Wishbone B4 master; wb_sel is all ones, wb_stall counts with wb_pipelined only.
    wb_cyc         : out   std_logic;
    wb_stb         : out   std_logic;
    wb_we          : out   std_logic;
    wb_sel         : out   std_logic_vector((data_bits + 7) / 8 - 1 downto 0);
    wb_adr         : out   std_logic_vector(address_bits - 1 downto 0);
    wb_dat_o       : out   std_logic_vector(data_bits - 1 downto 0);
    wb_dat_i       : in    std_logic_vector(data_bits - 1 downto 0);
    wb_ack         : in    std_logic;
    wb_err         : in    std_logic := '0';
    wb_stall       : in    std_logic := '0'
  );
end entity unity_link;
