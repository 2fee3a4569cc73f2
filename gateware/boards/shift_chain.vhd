-- SPDX-License-Identifier: BSD-3-Clause
--
-- The hardware's side of many signals on four pins: a chain of shift registers, clocked round and round.
--
-- What is to be sent and what comes in pass through one shift register, bit 0 first, as in SPI mode 0. A frame has as
-- many bits as the longer of the two. Between frames chain_load_n is low: boards take their inputs while it is low, as a
-- 74HC165 does (SH/LD#), and show what they got from its rising edge on, as a 74HC595 does (RCLK). They shift at the
-- rising edge of chain_clk; a bit of theirs is sampled in front of that edge. So `from_chain` and what the boards show
-- change as a whole, once a frame: every (2 * bits + 2) * half_period cycles of clk.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity shift_chain is
  generic (
    -- At least 1: bits that go out.
    bits_out : positive;
    -- At least 1: bits that come in.
    bits_in : positive;
    -- At least 2: cycles of clk for half a cycle of chain_clk. A bit that comes in is sampled one cycle before it
    -- counts.
    half_period : positive := 2
  );
  port (
    -- Rising edges count.
    clk : in    std_logic;
    -- Synchronous, active high, for one cycle or more.
    rst : in    std_logic;
    -- What is sent, bit 0 first; it is taken as a whole, once a frame.
    to_chain : in    std_logic_vector(bits_out - 1 downto 0);
    -- What came in; it changes as a whole, once a frame.
    from_chain : out   std_logic_vector(bits_in - 1 downto 0);
    -- SRCLK of a 74HC595, CLK of a 74HC165: they shift at its rising edge.
    chain_clk : out   std_logic;
    -- SH/LD# of a 74HC165, RCLK of a 74HC595: inputs are taken while it is '0', outputs change at its rising edge.
    chain_load_n : out   std_logic;
    -- SER of the first 74HC595.
    chain_out : out   std_logic;
    -- QH of the last 74HC165.
    chain_in : in    std_logic
  );
end entity shift_chain;

architecture rtl of shift_chain is

  constant bits : positive := maximum(bits_out, bits_in);

  type state_t is (state_load, state_begin, state_shift);

  signal state   : state_t;
  signal shifted : std_logic_vector(bits - 1 downto 0);
  signal left    : natural range 0 to bits - 1;
  signal waited  : natural range 0 to half_period - 1;
  signal arrived : std_logic;
  signal sampled : std_logic;

begin

  assert half_period >= 2
    report "shift_chain: half_period is " & integer'image(half_period) & ", expected 2 or more"
    severity failure;

  chain_out <= shifted(0);

  main : process (clk) is
  begin

    if rising_edge(clk) then
      arrived <= chain_in;
      if waited = half_period - 1 then
        waited <= 0;

        case state is

          when state_load =>
            from_chain                     <= shifted(bits_in - 1 downto 0);
            shifted                        <= (others => '0');
            shifted(bits_out - 1 downto 0) <= to_chain;
            left                           <= bits - 1;
            chain_load_n                   <= '0';
            state                          <= state_begin;

          when state_begin =>
            chain_load_n <= '1';
            state        <= state_shift;

          when state_shift =>
            chain_clk <= not chain_clk;
            if chain_clk = '0' then
              sampled <= arrived;
            else
              -- Only now may the bit that is sent change, and the one sampled take its place.
              shifted <= sampled & shifted(bits - 1 downto 1);
              if left = 0 then
                state <= state_load;
              else
                left <= left - 1;
              end if;
            end if;

        end case;

      else
        waited <= waited + 1;
      end if;

      if rst = '1' then
        state        <= state_load;
        shifted      <= (others => '0');
        from_chain   <= (others => '0');
        left         <= 0;
        waited       <= 0;
        chain_clk    <= '0';
        chain_load_n <= '1';
      end if;
    end if;

  end process main;

end architecture rtl;
