-- SPDX-License-Identifier: BSD-3-Clause
--
-- A ring buffer of records that are written byte by byte and can be discarded at their end; they may be read while they
-- are written.
--
-- The reader reads the bytes of a record as soon as they are available, even before the record is committed. While
-- `trial` is '1', the record may still be discarded, so the reader must not do anything that it cannot undo. `undone`
-- is '1' for one cycle if the record is rolled back: the reader drops the bytes of that record. It asserts `done` when
-- it has read all bytes of a committed record. A record must be shorter than the ring.

library ieee;
  use ieee.std_logic_1164.all;

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
    -- commit and rollback must not be asserted in the cycle of a write.
    commit   : in    std_logic;
    rollback : in    std_logic;
    -- After full is '1', at most the one byte in flight may still be written.
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

  -- No committed record is unread: the reader has finished all of them.
  signal none   : std_logic;
  signal rewind : std_logic;
  signal kept   : std_logic;
  signal empty  : std_logic;

begin

  kept   <= not none;
  rewind <= none and rollback;
  trial  <= none;
  undone <= rewind;

  byte_ring_inst : entity work.ul_byte_ring
    generic map (
      depth => depth
    )
    port map (
      clk        => clk,
      rst        => rst,
      write      => write,
      write_data => write_data,
      commit     => commit,
      rollback   => rollback,
      rewind     => rewind,
      kept_only  => kept,
      full       => full,
      written    => open,
      out_data   => out_data,
      out_valid  => out_valid,
      out_ready  => out_ready,
      empty      => empty
    );

  control : process (clk) is
  begin

    if rising_edge(clk) then
      if commit = '1' then
        none <= '0';
      elsif (done and empty) = '1' then
        none <= '1';
      end if;

      if rst = '1' then
        none <= '1';
      end if;
    end if;

  end process control;

end architecture rtl;
