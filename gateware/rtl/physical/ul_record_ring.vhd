-- SPDX-License-Identifier: BSD-3-Clause
--
-- A ring of records that are written byte by byte on trial, and may be read while they are.
--
-- The reader takes the bytes of a record as they are there, also of one that is not committed; `trial` says so, and it
-- does nothing with them then that it cannot take back. Where such a record is rolled back, `undone` tells the reader
-- for one cycle that what it has of it counts for nothing. It tells the end of each record by `done`, when it has taken
-- all bytes of one that is committed. A record is shorter than the ring.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_record_ring is
  generic (
    -- A power of two: bytes.
    depth : positive := 2048
  );
  port (
    clk        : in    std_logic;
    rst        : in    std_logic;
    write      : in    std_logic;
    write_data : in    std_logic_vector(7 downto 0);
    -- Neither comes with a write.
    commit   : in    std_logic;
    rollback : in    std_logic;
    -- Nothing more may be written than a byte under way.
    full      : out   std_logic;
    out_data  : out   std_logic_vector(7 downto 0);
    out_valid : out   std_logic;
    out_ready : in    std_logic;
    trial     : out   std_logic;
    undone    : out   std_logic;
    done      : in    std_logic
  );
end entity ul_record_ring;

architecture rtl of ul_record_ring is

  constant reserve : positive := 4;

  type memory_t is array (0 to depth - 1) of std_logic_vector(7 downto 0);

  subtype pointer_t is unsigned(log2_ceil(depth) - 1 downto 0);

  signal memory   : memory_t;
  signal write_at : pointer_t;
  signal start    : pointer_t;
  signal read_at  : pointer_t;
  signal records  : pointer_t;
  signal none     : std_logic;
  signal head     : std_logic;
  signal load     : std_logic;
  signal more     : std_logic;

begin

  none <= '1' when records = 0 else
          '0';
  -- Not beyond the committed records before the reader has done with them.
  more      <= '1' when (none = '1' and read_at /= write_at) or (none = '0' and read_at /= start) else
               '0';
  load      <= more and (not head or out_ready);
  out_valid <= head;
  trial     <= none;
  undone    <= none and rollback;

  storage : process (clk) is
  begin

    if rising_edge(clk) then
      if write = '1' then
        memory(to_integer(write_at)) <= write_data;
      end if;
      if load = '1' then
        out_data <= memory(to_integer(read_at));
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
        read_at <= read_at + 1;
        head    <= '1';
      elsif out_ready = '1' then
        head <= '0';
      end if;
      if commit = '1' then
        start <= write_at;
      end if;
      if rollback = '1' then
        write_at <= start;
        if none = '1' then
          read_at <= start;
          head    <= '0';
        end if;
      end if;
      if (commit and not done) = '1' then
        records <= records + 1;
      elsif (done and not commit) = '1' then
        records <= records - 1;
      end if;
      used := write_at - read_at;
      full <= '0';
      if used >= depth - reserve then
        full <= '1';
      end if;

      if rst = '1' then
        write_at <= (others => '0');
        start    <= (others => '0');
        read_at  <= (others => '0');
        records  <= (others => '0');
        head     <= '0';
        full     <= '0';
      end if;
    end if;

  end process control;

end architecture rtl;
