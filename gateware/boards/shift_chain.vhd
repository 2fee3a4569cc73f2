-- SPDX-License-Identifier: BSD-3-Clause
--
-- Master of a chain of shift registers: many inputs and outputs on four pins, shifted continuously.
--
-- The outgoing and the incoming bits pass through one shift register, bit 0 first, as in SPI mode 0. A frame has as
-- many bits as the longer of the two. Between frames chain_load_n is low: input boards load their inputs while it is
-- low, as a 74HC165 does (SH/LD#); output boards update their outputs at its rising edge, as a 74HC595 does (RCLK). The
-- boards shift at the rising edge of chain_clk; their bit is sampled before that edge. So `from_chain` and the outputs
-- of the boards change as a whole, once per frame: every (2 * bits + 2) * half_period cycles of clk.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity shift_chain is
  generic (
    -- At least 1: number of output bits.
    bits_out : positive;
    -- At least 1: number of input bits.
    bits_in : positive;
    -- At least 2: cycles of clk in half a period of chain_clk. An input bit is sampled one cycle before the rising edge
    -- of chain_clk.
    half_period : positive := 2
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle.
    rst : in    std_logic;
    -- Bits to send, bit 0 first; sampled as a whole, once per frame.
    to_chain : in    std_logic_vector(bits_out - 1 downto 0);
    -- Bits received; they change as a whole, once per frame.
    from_chain : out   std_logic_vector(bits_in - 1 downto 0);
    -- SRCLK of a 74HC595 and CLK of a 74HC165, which shift at its rising edge.
    chain_clk : out   std_logic;
    -- SH/LD# of a 74HC165, which loads its inputs while it is '0', and RCLK of a 74HC595, which updates its outputs at
    -- the rising edge.
    chain_load_n : out   std_logic;
    -- To SER of the first 74HC595.
    chain_out : out   std_logic;
    -- From QH of the last 74HC165.
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
              -- The boards have shifted: change the bit to send, and shift the sampled bit in.
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
