-- SPDX-License-Identifier: BSD-3-Clause
--
-- A FIFO in one clock domain: first-word fall-through, one entry in and one entry out per cycle, latency one cycle.
--
-- The storage is a memory with a registered read port and a read enable, which synthesis infers as block RAM on every
-- vendor's FPGAs. The read register is the head of the queue: it loads the next entry when the present one leaves. If
-- an entry becomes the head in the cycle in which it is written (into an empty FIFO, or when the last entry leaves),
-- the memory does not contain it yet; the register `bypass` supplies it. So the design never uses the result of a read
-- during a write to the same address, and the block RAM's behaviour in that case does not matter.
--
-- `level` counts all stored entries; the capacity is exactly `depth`.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_fifo_sync is
  generic (
    -- At least 1: bits of an entry.
    width : positive := 8;
    -- A power of two, at least 2: entries.
    depth : positive := 16
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- Entry to store. It is transferred at the rising edge at which in_valid and in_ready are both '1'.
    in_data : in    std_logic_vector(width - 1 downto 0);
    -- in_data is valid.
    in_valid : in    std_logic;
    -- There is space for an entry.
    in_ready : out   std_logic;
    -- The oldest entry.
    out_data : out   std_logic_vector(width - 1 downto 0);
    -- out_data is valid.
    out_valid : out   std_logic;
    -- The reader accepts the entry.
    out_ready : in    std_logic;
    -- Number of stored entries, 0 to depth; may be left open.
    level : out   unsigned(log2_ceil(depth) downto 0)
  );
end entity ul_fifo_sync;

architecture rtl of ul_fifo_sync is

  type memory_t is array (0 to depth - 1) of std_logic_vector(width - 1 downto 0);

  subtype pointer_t is unsigned(log2_ceil(depth) - 1 downto 0);

  signal memory     : memory_t;
  signal write_at   : pointer_t;
  signal read_next  : pointer_t;
  signal count      : unsigned(log2_ceil(depth) downto 0);
  signal not_empty  : std_logic;
  signal not_full   : std_logic;
  signal push       : std_logic;
  signal pop        : std_logic;
  signal read_data  : std_logic_vector(width - 1 downto 0);
  signal bypass     : std_logic_vector(width - 1 downto 0);
  signal use_bypass : std_logic;

  -- For Yosys: no read uses a word in the cycle in which it is written, so Yosys need not add bypass logic.
  attribute no_rw_check : boolean;
  attribute no_rw_check of memory : signal is true;

begin

  assert is_power_of_two(depth) and depth >= 2
    report "ul_fifo_sync: depth is " & integer'image(depth) & ", expected a power of two of at least 2"
    severity failure;

  push      <= in_valid and not_full;
  pop       <= not_empty and out_ready;
  in_ready  <= not_full;
  out_valid <= not_empty;
  out_data  <= bypass when use_bypass = '1' else
               read_data;
  level     <= count;

  storage : process (clk) is
  begin

    if rising_edge(clk) then
      if push = '1' then
        memory(to_integer(write_at)) <= in_data;
      end if;
      if pop = '1' then
        read_data <= memory(to_integer(read_next));
      end if;
    end if;

  end process storage;

  control : process (clk) is

    variable change : unsigned(count'range);

  begin

    if rising_edge(clk) then
      if push = '1' then
        write_at <= write_at + 1;
      end if;
      if pop = '1' then
        read_next <= read_next + 1;
      end if;

      if push = '1' and (count = 0 or (count = 1 and pop = '1')) then
        bypass     <= in_data;
        use_bypass <= '1';
      elsif pop = '1' then
        use_bypass <= '0';
      end if;

      -- 1, 0 or -1: one adder counts up and down.
      change    := (others => pop and not push);
      change(0) := push xor pop;
      count     <= count + change;

      if push = '1' and pop = '0' then
        not_empty <= '1';
        if count = depth - 1 then
          not_full <= '0';
        end if;
      elsif push = '0' and pop = '1' then
        not_full <= '1';
        if count = 1 then
          not_empty <= '0';
        end if;
      end if;

      if rst = '1' then
        write_at   <= (others => '0');
        read_next  <= to_unsigned(1, read_next'length);
        count      <= (others => '0');
        not_empty  <= '0';
        not_full   <= '1';
        use_bypass <= '1';
        bypass     <= (others => '0');
      end if;
    end if;

  end process control;

end architecture rtl;
