-- SPDX-License-Identifier: BSD-3-Clause
--
-- Puts the frames of a session into compact form (docs/protocol.md, "The compact form"), and passes all others.
--
-- A byte leaves each cycle. Where a line end of text comes in a frame, as behind a plain error, it goes out as it is.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_compact_pkg.all;
  use work.unity_link_pkg.all;

entity ul_compact_tx is
  generic (
    -- Digits of an ID.
    id_digits : positive := 3;
    -- Number on a shared medium, 0 to 254, or -1.
    node : integer := -1
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- The session has asked for the form; counts when the first letter of a frame is taken.
    compact   : in    std_logic;
    in_data   : in    std_logic_vector(7 downto 0);
    in_mark   : in    flush_mark_t;
    in_valid  : in    std_logic;
    in_ready  : out   std_logic;
    out_data  : out   std_logic_vector(7 downto 0);
    out_mark  : out   flush_mark_t;
    out_valid : out   std_logic;
    out_ready : in    std_logic;
    -- Something was taken that has not gone out yet.
    busy : out   std_logic
  );
end entity ul_compact_tx;

architecture rtl of ul_compact_tx is

  constant filled : std_logic_vector(0 to 15) := compact_filled(id_digits, 0);

  constant lf : std_logic_vector(7 downto 0) := x"0A";
  constant cr : std_logic_vector(7 downto 0) := x"0D";

  -- What comes next: a first letter, or the prefix and it; the second letter or a digit; digits in pairs; text.

  type state_t is (at_letter, at_second, at_high, at_low, in_text);

  -- What is to go out before the next character is taken: a byte of the frame, with an escape or behind it; what stands
  -- before the command; the first letter, as text.

  type rest_t is (nothing, escaped, whole, node_byte, prefix, letter, letters);

  signal state   : state_t;
  signal rest    : rest_t;
  signal value   : std_logic_vector(7 downto 0);
  signal first   : std_logic_vector(7 downto 0);
  signal taken   : unsigned(1 downto 0);
  signal held    : std_logic;
  signal advance : std_logic;

begin

  assert node < 0
    report "ul_compact_tx: addressed frames are not in it yet"
    severity failure;

  advance   <= out_ready or not held;
  in_ready  <= advance when rest = nothing else
               '0';
  out_valid <= held;
  busy      <= held or to_std_logic(state /= at_letter or rest /= nothing);

end architecture rtl;
