-- SPDX-License-Identifier: BSD-3-Clause
--
-- A FIFO between two clocks that know nothing of each other: first-word fall-through, one entry per cycle sustained.
--
-- Each side owns a pointer and shows it to the other in Gray code, where one step changes one bit: a pointer that is
-- caught while it changes reads as its old or its new value, never as something else. What a side sees of the other is
-- `stages` to `stages` + 1 of its cycles old, so `in_ready` and `out_valid` err on the safe side only. Pointers have one
-- bit more than an address, which tells full from empty. Sources: C. E. Cummings, "Simulation and Synthesis Techniques
-- for Asynchronous FIFO Design", SNUG 2002.
--
-- Both sides must be reset together (each synchronously to its own clock, overlapping): a reset of one side alone
-- would bring back old entries. Constraints: the bits of a pointer may differ in their delays by less than a cycle of
-- the clock that makes them, or two steps could be seen as one that never was; so each way from `*_gray` into the
-- `meta` of a `ul_synchroniser` is bounded to the shorter period, and an entry, which has stood in the memory for as
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
    -- A power of two, at least 4: entries. One more waits in the output register.
    depth : positive := 16;
    -- At least 2: registers in a row that a pointer passes.
    stages : positive := 2
  );
  port (
    -- The writing side's clock.
    in_clk : in    std_logic;
    -- Synchronous, active high; it must overlap out_rst. Clock: in_clk.
    in_rst : in    std_logic;
    -- An entry: it has moved at the edge at which in_valid and in_ready are both '1'. Clock: in_clk.
    in_data : in    std_logic_vector(width - 1 downto 0);
    -- An entry stands at in_data. Clock: in_clk.
    in_valid : in    std_logic;
    -- There is room. Clock: in_clk.
    in_ready : out   std_logic;
    -- The most entries that can be inside, as far as this side knows; may be left open. Clock: in_clk.
    in_level : out   unsigned(log2_ceil(depth) downto 0);
    -- The reading side's clock.
    out_clk : in    std_logic;
    -- Synchronous, active high; it must overlap in_rst. Clock: out_clk.
    out_rst : in    std_logic;
    -- The oldest entry. Clock: out_clk.
    out_data : out   std_logic_vector(width - 1 downto 0);
    -- An entry stands at out_data. Clock: out_clk.
    out_valid : out   std_logic;
    -- It is taken. Clock: out_clk.
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

  -- Full: the write pointer is one whole round ahead, which in Gray code differs in the two highest bits alone.
  function one_round_ahead (code : pointer_t) return pointer_t is
  begin

    return (not code(code'high downto code'high - 1)) & code(code'high - 2 downto 0);

  end function one_round_ahead;

  signal memory : memory_t;

  signal write_at   : pointer_t;
  signal write_gray : pointer_t;
  -- As the writing side sees it.
  signal read_seen : pointer_t;
  signal not_full  : std_logic;
  signal push      : std_logic;

  signal read_at   : pointer_t;
  signal read_gray : pointer_t;
  -- As the reading side sees it.
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
      -- An entry accepted in this cycle counts at once, one that left may count for longer: never too few.
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
