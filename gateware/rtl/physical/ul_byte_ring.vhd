-- SPDX-License-Identifier: BSD-3-Clause
--
-- The memory of `ul_record_ring` and `ul_answer_ring`: a FIFO of bytes. Its output passes an extra register, because
-- block RAM has a long clock-to-output delay.
--
-- `rollback` discards all bytes written since the last `commit`. If some of them may have been read already, assert
-- `rewind` as well: the next byte read is then the next one written.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_byte_ring is
  generic (
    -- A power of two, at least 8: bytes.
    depth : positive := 2048
  );
  port (
    clk        : in    std_logic;
    rst        : in    std_logic;
    write      : in    std_logic;
    write_data : in    std_logic_vector(7 downto 0);
    -- commit and rollback must not be asserted in the cycle of a write.
    commit   : in    std_logic := '0';
    rollback : in    std_logic := '0';
    rewind   : in    std_logic := '0';
    -- '1': bytes that are not committed cannot be read yet.
    kept_only : in    std_logic := '0';
    -- After full is '1', at most the one byte in flight may still be written.
    full : out   std_logic;
    -- Address of the next byte.
    written   : out   unsigned(log2_ceil(depth) - 1 downto 0);
    out_data  : out   std_logic_vector(7 downto 0);
    out_valid : out   std_logic;
    out_ready : in    std_logic;
    -- No byte can be read now.
    empty : out   std_logic
  );
end entity ul_byte_ring;

architecture rtl of ul_byte_ring is

  type memory_t is array (0 to depth - 1) of std_logic_vector(7 downto 0);

  subtype pointer_t is unsigned(log2_ceil(depth) - 1 downto 0);

  signal memory   : memory_t;
  signal write_at : pointer_t;
  signal start    : pointer_t;
  signal read_at  : pointer_t;
  signal last     : pointer_t;
  signal more     : std_logic;
  signal load     : std_logic;
  signal move     : std_logic;
  signal fetched  : std_logic_vector(7 downto 0);
  signal is_there : std_logic;
  signal head     : std_logic;

begin

  assert is_power_of_two(depth) and depth >= 8
    report "ul_byte_ring: depth is " & integer'image(depth) & ", expected a power of two of at least 8"
    severity failure;

  last      <= start when kept_only = '1' else
               write_at;
  more      <= '1' when read_at /= last else
               '0';
  move      <= is_there and (not head or out_ready);
  load      <= more and (not is_there or move);
  empty     <= not (more or is_there or head);
  written   <= write_at;
  out_valid <= head;

  storage : process (clk) is
  begin

    if rising_edge(clk) then
      if write = '1' then
        memory(to_integer(write_at)) <= write_data;
      end if;
      if load = '1' then
        fetched <= memory(to_integer(read_at));
      end if;
      if move = '1' then
        out_data <= fetched;
      end if;
    end if;

  end process storage;

  control : process (clk) is

    variable used : pointer_t;

  begin

    if rising_edge(clk) then
      if write = '1' then
        write_at <= write_at + 1;
      end if;
      if load = '1' then
        read_at  <= read_at + 1;
        is_there <= '1';
      elsif move = '1' then
        is_there <= '0';
      end if;
      if move = '1' then
        head <= '1';
      elsif out_ready = '1' then
        head <= '0';
      end if;
      if commit = '1' then
        start <= write_at;
      end if;
      if rollback = '1' then
        write_at <= start;
      end if;
      if rewind = '1' then
        read_at  <= start;
        is_there <= '0';
        head     <= '0';
      end if;
      -- Full at depth - 4 bytes, so that the comparison needs only the highest bits.
      used := write_at - read_at;
      full <= '0';
      if (not used(used'high downto 2)) = 0 then
        full <= '1';
      end if;

      if rst = '1' then
        write_at <= (others => '0');
        start    <= (others => '0');
        read_at  <= (others => '0');
        is_there <= '0';
        head     <= '0';
        full     <= '0';
      end if;
    end if;

  end process control;

end architecture rtl;
