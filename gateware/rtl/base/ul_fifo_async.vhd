-- SPDX-License-Identifier: BSD-3-Clause
--
-- A FIFO between two asynchronous clocks: first-word fall-through, sustained throughput of one entry per cycle.
--
-- Each side owns a pointer and passes it to the other side in Gray code. One step of a Gray code changes one bit, so a
-- pointer sampled while it changes reads as its old or its new value, never as a third one. The copy of the other
-- side's pointer is `stages` to `stages` + 1 cycles old, so `in_ready` and `out_valid` err on the safe side only: the
-- FIFO may look fuller to the writer and emptier to the reader than it is. Pointers have one bit more than an address,
-- which distinguishes full from empty. Source: C. E. Cummings, "Simulation and Synthesis Techniques for Asynchronous
-- FIFO Design", SNUG 2002.
--
-- Both sides must be reset together, each synchronously to its own clock and for an overlapping time: a reset of one
-- side alone would make old entries appear again. Constraints: the delays of a pointer's bits may differ by less than
-- one cycle of the clock that launches them; otherwise two steps could be sampled as a value that the pointer never
-- had. So the constraints bound each path from `*_gray` to the `meta` register of a `ul_synchroniser` to the shorter of
-- the two periods. They bound the path of an entry to the same delay: when the entry is read, it has been stable in the
-- memory for `stages` cycles. The constraint files are in gateware/constraints.
-- many cycles as the row has registers when it is read, to as much. gateware/constraints has the files.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_fifo_async is
  generic (
    -- At least 1: bits of an entry.
    width : positive := 8;
    -- A power of two, at least 4: entries. The output register stores one more.
    depth : positive := 16;
    -- At least 2: registers in series in the synchroniser of each pointer.
    stages : positive := 2
  );
  port (
    -- Clock of the writing side.
    in_clk : in    std_logic;
    -- Synchronous reset, active high; it must overlap out_rst. Clock: in_clk.
    in_rst : in    std_logic;
    -- Entry to store. It is transferred at the rising edge at which in_valid and in_ready are both '1'. Clock: in_clk.
    in_data : in    std_logic_vector(width - 1 downto 0);
    -- in_data is valid. Clock: in_clk.
    in_valid : in    std_logic;
    -- There is space for an entry. Clock: in_clk.
    in_ready : out   std_logic;
    -- Upper bound of the number of stored entries, as seen by the writing side; may be left open. Clock: in_clk.
    in_level : out   unsigned(log2_ceil(depth) downto 0);
    -- Clock of the reading side.
    out_clk : in    std_logic;
    -- Synchronous reset, active high; it must overlap in_rst. Clock: out_clk.
    out_rst : in    std_logic;
    -- The oldest entry. Clock: out_clk.
    out_data : out   std_logic_vector(width - 1 downto 0);
    -- out_data is valid. Clock: out_clk.
    out_valid : out   std_logic;
    -- The reader accepts the entry. Clock: out_clk.
    out_ready : in    std_logic
  );
end entity ul_fifo_async;

architecture rtl of ul_fifo_async is

  type memory_t is array (0 to depth - 1) of std_logic_vector(width - 1 downto 0);

  subtype address_t is unsigned(log2_ceil(depth) - 1 downto 0);

  subtype pointer_t is unsigned(log2_ceil(depth) downto 0);

  function gray (number : pointer_t) return pointer_t is
  begin

    return number xor ('0' & number(pointer_t'high downto 1));

  end function gray;

  function binary (code : pointer_t) return pointer_t is

    variable result : pointer_t;

  begin

    result := code;

    for bit_index in pointer_t'high - 1 downto 0 loop

      result(bit_index) := result(bit_index + 1) xor code(bit_index);

    end loop;

    return result;

  end function binary;

  -- The FIFO is full if the write pointer is `depth` ahead; in Gray code, only the two highest bits differ then.
  function one_round_ahead (code : pointer_t) return pointer_t is
  begin

    return (not code(code'high downto code'high - 1)) & code(code'high - 2 downto 0);

  end function one_round_ahead;

  signal memory : memory_t;

  signal write_at   : pointer_t;
  signal write_gray : pointer_t;
  -- Read pointer, synchronised to the writing side.
  signal read_seen : pointer_t;
  signal not_full  : std_logic;
  signal push      : std_logic;

  signal read_at   : pointer_t;
  signal read_gray : pointer_t;
  -- Write pointer, synchronised to the reading side.
  signal write_seen : pointer_t;
  signal head_valid : std_logic;
  signal load       : std_logic;

begin

  assert is_power_of_two(depth) and depth >= 4
    report "ul_fifo_async: depth is " & integer'image(depth) & ", expected a power of two of at least 4"
    severity failure;

  assert stages >= 2
    report "ul_fifo_async: stages is " & integer'image(stages) & ", expected 2 or more"
    severity failure;

  not_full <= '0' when write_gray = one_round_ahead(read_seen) else
              '1';
  push     <= in_valid and not_full;
  in_ready <= not_full;

  read_crossing : entity work.ul_synchroniser
    generic map (
      width  => pointer_t'length,
      stages => stages
    )
    port map (
      clk         => in_clk,
      rst         => in_rst,
      d           => std_logic_vector(read_gray),
      unsigned(q) => read_seen
    );

  write_side : process (in_clk) is
  begin

    if rising_edge(in_clk) then
      if push = '1' then
        memory(to_integer(write_at(address_t'range))) <= in_data;
        write_at                                      <= write_at + 1;
        write_gray                                    <= gray(write_at + 1);
      end if;
      -- Count an entry accepted in this cycle at once. An entry that was read may be counted for some more cycles, so
      -- the level is never too low.
      if push = '1' then
        in_level <= write_at + 1 - binary(read_seen);
      else
        in_level <= write_at - binary(read_seen);
      end if;

      if in_rst = '1' then
        write_at   <= (others => '0');
        write_gray <= (others => '0');
        in_level   <= (others => '0');
      end if;
    end if;

  end process write_side;

  load      <= '1' when read_gray /= write_seen and (head_valid = '0' or out_ready = '1') else
               '0';
  out_valid <= head_valid;

  write_crossing : entity work.ul_synchroniser
    generic map (
      width  => pointer_t'length,
      stages => stages
    )
    port map (
      clk         => out_clk,
      rst         => out_rst,
      d           => std_logic_vector(write_gray),
      unsigned(q) => write_seen
    );

  read_side : process (out_clk) is
  begin

    if rising_edge(out_clk) then
      if load = '1' then
        out_data   <= memory(to_integer(read_at(address_t'range)));
        read_at    <= read_at + 1;
        read_gray  <= gray(read_at + 1);
        head_valid <= '1';
      elsif out_ready = '1' then
        head_valid <= '0';
      end if;

      if out_rst = '1' then
        read_at    <= (others => '0');
        read_gray  <= (others => '0');
        head_valid <= '0';
      end if;
    end if;

  end process read_side;

end architecture rtl;
