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

  -- There is no committed record with which the reader has not done.
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
