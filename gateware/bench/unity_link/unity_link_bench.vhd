-- SPDX-License-Identifier: BSD-3-Clause
--
-- Top for the benches of the whole gateway: `unity_link_fifo` with a Wishbone memory.
--
-- The generics are integers, booleans and strings, because GHDL accepts no others when a simulation starts. The memory
-- has every address, with the initial value 0. One address answers with ERR, one never, and one returns the number of
-- clock cycles since the reset. The number of wait states is an input, so that a test can change it at any time. The
-- slave is classic, or pipelined; a pipelined slave stalls for the wait states and answers one cycle later.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

package sparse_memory_pkg is

  type sparse_memory_t is protected

    procedure write (address : natural; high, low : integer);

    impure function read_high (address : natural) return integer;

    impure function read_low (address : natural) return integer;

  end protected sparse_memory_t;

end package sparse_memory_pkg;

package body sparse_memory_pkg is

  type sparse_memory_t is protected body

    constant places : positive := 2 ** 16;

    type numbers_t is array (0 to places - 1) of integer;

    type bits_t is array (0 to places - 1) of boolean;

    variable used  : bits_t    := (others => false);
    variable keys  : numbers_t := (others => 0);
    variable highs : numbers_t := (others => 0);
    variable lows  : numbers_t := (others => 0);

    impure function place_of (address : natural) return natural is

      variable place : natural := address mod places;

    begin

      while used(place) and keys(place) /= address loop

        place := (place + 1) mod places;

      end loop;

      return place;

    end function place_of;

    procedure write (address : natural; high, low : integer) is

      constant place : natural := place_of(address);

    begin

      used(place)  := true;
      keys(place)  := address;
      highs(place) := high;
      lows(place)  := low;

    end procedure write;

    impure function read_high (address : natural) return integer is
    begin

      return highs(place_of(address));

    end function read_high;

    impure function read_low (address : natural) return integer is
    begin

      return lows(place_of(address));

    end function read_low;

  end protected body sparse_memory_t;

end package body sparse_memory_pkg;

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library unity_link;

library work;
  use work.sparse_memory_pkg.all;

entity unity_link_bench is
  generic (
    data_bits                 : positive := 32;
    address_bits              : positive := 8;
    id_digits                 : positive := 3;
    crc_bits                  : positive := 16;
    crc_polynomial            : natural  := 16#1021#;
    block_words               : positive := 255;
    groups                    : natural  := 16;
    group_words               : natural  := 32;
    sample_depth              : positive := 256;
    clock_hz                  : positive := 50_000_000;
    base_frequency_millihertz : positive := 100_000_000;
    rx_fifo_depth             : positive := 256;
    tx_fifo_depth             : positive := 256;
    bus_timeout               : positive := 64;
    masked_write              : boolean  := true;
    queue_commands            : boolean  := true;
    compact                   : boolean  := false;
    timestamps                : boolean  := true;
    triggers                  : boolean  := true;
    send_immediate            : boolean  := true;
    flow_control              : boolean  := true;
    checked_frames            : boolean  := true;
    node                      : integer  := -1;
    half_duplex               : boolean  := false;
    build_id                  : natural  := 0;
    fingerprint               : boolean  := false;
    description               : boolean  := false;
    wb_pipelined              : boolean  := false;
    -- Addresses that are not memory; -1 for none.
    error_at  : integer := -1;
    silent_at : integer := -1;
    cycles_at : integer := -1
  );
  port (
    clk         : in    std_logic;
    rst         : in    std_logic;
    in_data     : in    std_logic_vector(7 downto 0);
    in_lost     : in    std_logic;
    in_valid    : in    std_logic;
    in_ready    : out   std_logic;
    out_data    : out   std_logic_vector(7 downto 0);
    out_valid   : out   std_logic;
    out_ready   : in    std_logic;
    out_flush   : out   std_logic;
    trigger     : in    std_logic_vector(maximum(groups, 1) - 1 downto 0);
    wait_states : in    std_logic_vector(7 downto 0);
    -- Bus signals, for observation.
    wb_cyc   : out   std_logic;
    wb_stb   : out   std_logic;
    wb_we    : out   std_logic;
    wb_adr   : out   std_logic_vector(address_bits - 1 downto 0);
    wb_dat_o : out   std_logic_vector(data_bits - 1 downto 0);
    wb_dat_i : out   std_logic_vector(data_bits - 1 downto 0);
    wb_ack   : out   std_logic;
    wb_err   : out   std_logic;
    wb_stall : out   std_logic;
    -- wb_taken: the slave accepts an access. The other signals are those of the gateway.
    wb_taken      : out   std_logic;
    sample_strobe : out   std_logic;
    sample_access : out   std_logic;
    base_tick     : out   std_logic;
    timestamp     : out   std_logic_vector(63 downto 0)
  );
end entity unity_link_bench;

architecture bench of unity_link_bench is

  shared variable memory : sparse_memory_t;

  signal cycles   : unsigned(31 downto 0);
  signal waited   : unsigned(7 downto 0);
  signal answers  : std_logic;
  signal answered : std_logic;
  signal is_error : std_logic;
  -- A pipelined slave answers the access that it accepted in the cycle before.
  signal taken       : std_logic;
  signal taken_error : std_logic;
  signal taken_data  : std_logic_vector(data_bits - 1 downto 0);
  signal read_now    : std_logic_vector(data_bits - 1 downto 0);
  -- Number of writes; its change makes the read data be looked up again.
  -- vsg_off signal_007
  signal version : natural := 0;
  -- vsg_on signal_007

  function key (address : std_logic_vector) return natural is

    variable wide : unsigned(31 downto 0);

  begin

    wide := resize(unsigned(address), 32);
    return to_integer(wide(30 downto 0) xor (30 downto 1 => '0', 0 => '0'));

  end function key;

begin

  read_now <= std_logic_vector(resize(cycles, data_bits)) when to_integer(signed('0' & wb_adr(7 downto 0))) = cycles_at
                                                               and unsigned(wb_adr) < 256 else
              std_logic_vector(resize(unsigned(std_logic_vector(to_signed(memory.read_high(key(wb_adr)), 32))
                                                & std_logic_vector(to_signed(memory.read_low(key(wb_adr)), 32))),
                                       data_bits)) when version >= 0 else
              (others => '0');

  is_error <= '1' when error_at >= 0 and unsigned(wb_adr) = to_unsigned(maximum(error_at, 0), wb_adr'length) else
              '0';
  answers  <= '0' when silent_at >= 0 and unsigned(wb_adr) = to_unsigned(maximum(silent_at, 0), wb_adr'length) else
              '1';
  answered <= wb_cyc and wb_stb and answers when waited >= unsigned(wait_states) else
              '0';
  wb_taken <= answered;

  classic : if not wb_pipelined generate

    wb_ack   <= answered and not is_error;
    wb_err   <= answered and is_error;
    wb_dat_i <= read_now when answered = '1' else
                (others => '1');
    wb_stall <= '0';

  end generate classic;

  with_pipeline : if wb_pipelined generate

    wb_ack   <= taken and not taken_error;
    wb_err   <= taken and taken_error;
    wb_dat_i <= taken_data;
    wb_stall <= '0' when waited >= unsigned(wait_states) else
                '1';

  end generate with_pipeline;

  slave : process (clk) is
  begin

    if rising_edge(clk) then
      cycles      <= cycles + 1;
      waited      <= (others => '0');
      taken       <= answered and wb_cyc;
      taken_error <= is_error;
      taken_data  <= read_now;
      if wb_cyc = '1' and wb_stb = '1' and answered = '0' then
        waited <= waited + 1;
      end if;
      if answered = '1' and is_error = '0' and wb_we = '1' then
        memory.write(
                     key(wb_adr),
                     to_integer(signed(std_logic_vector(resize(unsigned(wb_dat_o), 64)(63 downto 32)))),
                     to_integer(signed(std_logic_vector(resize(unsigned(wb_dat_o), 64)(31 downto 0))))
                   );
        version <= (version + 1) mod 1000;
      end if;
      if rst = '1' then
        cycles <= (others => '0');
        waited <= (others => '0');
        taken  <= '0';
      end if;
    end if;

  end process slave;

  gateway : entity unity_link.unity_link_fifo
    generic map (
      flow_control              => flow_control,
      checked_frames            => checked_frames,
      wb_pipelined              => wb_pipelined,
      data_bits                 => data_bits,
      address_bits              => address_bits,
      id_digits                 => id_digits,
      crc_bits                  => crc_bits,
      crc_polynomial            => std_logic_vector(to_unsigned(crc_polynomial, 32)),
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
      build_id                  => std_logic_vector(to_unsigned(build_id, 32)),
      fingerprint               => fingerprint,
      description               => description
    )
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
      trigger   => trigger,
      wb_cyc    => wb_cyc,
      wb_stb    => wb_stb,
      wb_we     => wb_we,
      wb_sel    => open,
      wb_adr    => wb_adr,
      wb_dat_o  => wb_dat_o,
      wb_dat_i  => wb_dat_i,
      wb_ack    => wb_ack,
      wb_err    => wb_err,
      wb_stall  => wb_stall,

      sample_strobe => sample_strobe,
      sample_access => sample_access,
      base_tick     => base_tick,
      timestamp     => timestamp
    );

end architecture bench;
