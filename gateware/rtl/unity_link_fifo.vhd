-- SPDX-License-Identifier: BSD-3-Clause
--
-- The gateway with a FIFO port as its medium, for benches and for the compiled model that runs in a process.
--
-- Equals `unity_link` with physical = "fifo", without the pins of the other media.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.unity_link_pkg.all;

entity unity_link_fifo is
  generic (
    -- Whether the source of bytes respects in_ready.
    flow_control : boolean := true;
    -- Whether the bus is pipelined Wishbone B4 instead of classic.
    wb_pipelined : boolean := false;
    -- Bits of a word (8 to 64) and of a word address (8 to 32), and digits of an ID (2 or 3).
    data_bits    : positive := 32;
    address_bits : positive := 8;
    id_digits    : positive := 3;
    -- If false, there is no datalink layer: all frames are plain, for a person at a terminal. A host needs checked
    -- frames.
    checked_frames : boolean := true;
    -- 8, 16 or 32 bits, and the polynomial of that width without its highest term, right-aligned.
    crc_bits       : positive                      := 16;
    crc_polynomial : std_logic_vector(31 downto 0) := x"00001021";
    -- Maximum number of words in one block or queue request, 1 to 255.
    block_words : positive := 255;
    -- Number of publish groups, 0 to 256, and maximum number of addresses in one group, 1 to 255.
    groups      : natural := 16;
    group_words : natural := 32;
    -- Words of the buffer in which the samples of all groups wait for transmission: a power of two.
    sample_depth : positive := 256;
    -- Frequency of clk in Hz, and of the base tick for periodic groups in mHz.
    clock_hz                  : positive := 50_000_000;
    base_frequency_millihertz : positive := 100_000_000;
    -- Sizes of the FIFOs in bytes: powers of two, 2 to 32768.
    rx_fifo_depth : positive := 256;
    tx_fifo_depth : positive := 256;
    -- Cycles after which an unanswered bus access ends with error 05.
    bus_timeout : positive := 1024;
    -- Features. A disabled feature takes no logic and is answered with error 02 (a command) or 06 (a flag).
    masked_write   : boolean := true;
    queue_commands : boolean := true;
    -- Whether frames of a session may use the compact form; words must have an even number of hex digits then.
    compact        : boolean := false;
    timestamps     : boolean := true;
    triggers       : boolean := true;
    send_immediate : boolean := true;
    -- Number of this node on a shared medium (docs/protocol.md, "Addressed frames"), 0 to 254; -1 if the medium is not
    -- shared.
    node : integer := -1;
    -- Whether only one side may send at a time (docs/protocol.md, "Half-duplex"): groups publish only on request by GP.
    half_duplex : boolean := false;
    -- The build identifier that `Q` reports, and whether it is the fingerprint of a spec's map.
    build_id    : std_logic_vector(31 downto 0) := x"00000000";
    fingerprint : boolean                       := false;
    -- Whether the highest addresses contain a description of the registers, in the format of docs/protocol.md.
    description : boolean := false
  );
  port (
    clk       : in    std_logic;
    rst       : in    std_logic;
    in_data   : in    std_logic_vector(7 downto 0);
    in_lost   : in    std_logic := '0';
    in_valid  : in    std_logic;
    in_ready  : out   std_logic;
    out_data  : out   std_logic_vector(7 downto 0);
    out_valid : out   std_logic;
    out_ready : in    std_logic;
    out_flush : out   std_logic;
    -- A rising edge makes the group of that number due (docs/protocol.md, "Groups", flag 02).
    trigger : in    std_logic_vector(maximum(groups, 1) - 1 downto 0) := (others => '0');
    -- Wishbone B4 master; wb_sel is all ones, wb_stall is used only with wb_pipelined.
    wb_cyc   : out   std_logic;
    wb_stb   : out   std_logic;
    wb_we    : out   std_logic;
    wb_sel   : out   std_logic_vector((data_bits + 7) / 8 - 1 downto 0);
    wb_adr   : out   std_logic_vector(address_bits - 1 downto 0);
    wb_dat_o : out   std_logic_vector(data_bits - 1 downto 0);
    wb_dat_i : in    std_logic_vector(data_bits - 1 downto 0);
    wb_ack   : in    std_logic;
    wb_err   : in    std_logic := '0';
    wb_rty   : in    std_logic := '0';
    wb_stall : in    std_logic := '0';
    -- '1' in the cycle at which a sample is taken, and while its words are read.
    sample_strobe : out   std_logic;
    sample_access : out   std_logic;
    -- base_tick: '1' for one cycle at each base tick. timestamp: cycles since the reset.
    base_tick : out   std_logic;
    timestamp : out   std_logic_vector(63 downto 0)
  );
end entity unity_link_fifo;

architecture rtl of unity_link_fifo is

begin

  unity_link_inst : entity work.unity_link
    generic map (
      physical                  => "fifo",
      flow_control              => flow_control,
      wb_pipelined              => wb_pipelined,
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
      bus_timeout               => bus_timeout,
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
      clk           => clk,
      rst           => rst,
      in_data       => in_data,
      in_lost       => in_lost,
      in_valid      => in_valid,
      in_ready      => in_ready,
      out_data      => out_data,
      out_valid     => out_valid,
      out_ready     => out_ready,
      out_flush     => out_flush,
      trigger       => trigger,
      wb_cyc        => wb_cyc,
      wb_stb        => wb_stb,
      wb_we         => wb_we,
      wb_sel        => wb_sel,
      wb_adr        => wb_adr,
      wb_dat_o      => wb_dat_o,
      wb_dat_i      => wb_dat_i,
      wb_ack        => wb_ack,
      wb_err        => wb_err,
      wb_rty        => wb_rty,
      wb_stall      => wb_stall,
      sample_strobe => sample_strobe,
      sample_access => sample_access,
      base_tick     => base_tick,
      timestamp     => timestamp
    );

end architecture rtl;
