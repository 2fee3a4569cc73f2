-- SPDX-License-Identifier: BSD-3-Clause
--
-- A ring buffer of words with commit and rollback: `rollback` discards all words written since the last `commit`.
--
-- Answers and samples are written before it is certain that they will be sent: a later error discards them. The reader
-- may read a word as soon as `available` reports committed words, or as soon as another signal announces the word.
--
-- `read_data` is a registered memory port that always shows the oldest word. After `pop`, and after a write into an
-- empty ring, the next word is valid from the second cycle on.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_word_ring is
  generic (
    width : positive := 32;
    -- Words; a power of two, at least 2.
    depth : positive := 256
  );
  port (
    clk        : in    std_logic;
    rst        : in    std_logic;
    write      : in    std_logic;
    write_data : in    std_logic_vector(width - 1 downto 0);
    -- commit may be asserted together with the last write, rollback may not.
    commit   : in    std_logic;
    rollback : in    std_logic;
    -- Number of words that can still be written.
    room      : out   unsigned(log2_ceil(depth) downto 0);
    available : out   std_logic;
    read_data : out   std_logic_vector(width - 1 downto 0);
    pop       : in    std_logic
  );
end entity ul_word_ring;

architecture rtl of ul_word_ring is

  type memory_t is array (0 to depth - 1) of std_logic_vector(width - 1 downto 0);

  -- One bit more than an index, which distinguishes full from empty.
  subtype pointer_t is unsigned(log2_ceil(depth) downto 0);

  signal memory    : memory_t;
  signal write_at  : pointer_t;
  signal committed : pointer_t;
  signal read_at   : pointer_t;

  -- For Yosys: no read uses a word in the cycle in which it is written, so Yosys need not add bypass logic.
  attribute no_rw_check : boolean;
  attribute no_rw_check of memory : signal is true;

  function index_of (pointer : pointer_t) return natural is
  begin

    return to_integer(pointer(pointer'high - 1 downto 0));

  end function index_of;

begin

  assert is_power_of_two(depth) and depth >= 2
    report "ul_word_ring: depth is " & integer'image(depth) & ", expected a power of two of at least 2"
    severity failure;

  storage : process (clk) is
  begin

    if rising_edge(clk) then
      if write = '1' then
        memory(index_of(write_at)) <= write_data;
      end if;
      read_data <= memory(index_of(read_at));
    end if;

  end process storage;

  control : process (clk) is

    variable next_write_at : pointer_t;
    variable next_read_at  : pointer_t;
    variable free          : pointer_t;

  begin

    if rising_edge(clk) then
      next_write_at := write_at;
      next_read_at  := read_at;
      if write = '1' then
        next_write_at := write_at + 1;
      end if;
      if rollback = '1' then
        next_write_at := committed;
      end if;
      -- depth - (write_at - read_at) by one subtraction: inverting the highest bit adds `depth`.
      free            := read_at - write_at;
      free(free'high) := not free(free'high);
      room            <= free;
      if commit = '1' then
        committed <= next_write_at;
      end if;
      if pop = '1' then
        next_read_at := read_at + 1;
      end if;
      write_at  <= next_write_at;
      read_at   <= next_read_at;
      available <= '0';
      if committed /= next_read_at then
        available <= '1';
      end if;

      if rst = '1' then
        write_at  <= (others => '0');
        committed <= (others => '0');
        read_at   <= (others => '0');
        room      <= to_unsigned(depth, room'length);
        available <= '0';
      end if;
    end if;

  end process control;

end architecture rtl;
