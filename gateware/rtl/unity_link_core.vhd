-- The gateway without a medium and without a bus standard: bytes on one side, the bus-independent interface on the other.
--
--     rx -> FIFO -> datalink_rx -> request_decoder -> request_executor -> bus_master -> bus
--     tx <- FIFO <- datalink_tx <- frame_writer  <-+- (responses)            ^
--                                                  +- (samples) <- subscription_manager <- trigger, base tick
--
-- Requests are parsed while they arrive and executed at their end; the next one is parsed and executed while the last
-- answer is sent, so that a stream of reads fills every cycle of the transmitter. See docs/gateware.md.
--
-- The bus-independent interface: while `bus_request` is '1', address, write and data stand still until the rising edge at
-- which `bus_done` is '1' (which may be the first one: no wait states). `bus_error` and `bus_read_data` count at that edge.
-- `bus_request` is taken back for at least one cycle between accesses, and without `bus_done` when the access timed out:
-- it is over then, whatever the bus does. `bus_lock` stays '1' over all accesses that belong to one atomic transaction.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.unity_link_pkg.all;

entity unity_link_core is
  generic (
    -- Whether the medium stops the host when this side is full: `Q` reports it.
    flow_control              : boolean                       := true;
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
    -- Bytes from the physical layer; rx_lost: bytes were lost before this one.
    rx_data        : in    std_logic_vector(7 downto 0);
    rx_lost        : in    std_logic := '0';
    rx_valid       : in    std_logic;
    rx_ready       : out   std_logic;
    -- Bytes to the physical layer; flush: one cycle, send what was given so far at once.
    tx_data        : out   std_logic_vector(7 downto 0);
    tx_valid       : out   std_logic;
    tx_ready       : in    std_logic;
    flush          : out   std_logic;
    -- A rising edge makes the group of that number due (protocol section 2, group flag 1).
    trigger        : in    std_logic_vector(maximum(groups, 1) - 1 downto 0) := (others => '0');
    -- Bus-independent interface.
    bus_request    : out   std_logic;
    bus_write      : out   std_logic;
    bus_lock       : out   std_logic;
    bus_address    : out   std_logic_vector(address_bits - 1 downto 0);
    bus_write_data : out   std_logic_vector(data_bits - 1 downto 0);
    bus_read_data  : in    std_logic_vector(data_bits - 1 downto 0);
    bus_done       : in    std_logic;
    bus_error      : in    std_logic
  );
end entity unity_link_core;
