-- SPDX-License-Identifier: BSD-3-Clause
--
-- A lease: outputs are enabled only while one owner renews the lease, at most until the end that it named last.
--
-- The owner arms the lease with a token and an end, and moves the end by kicks with the same token. The end is an
-- absolute time of the gateway, so a word that was delayed or retransmitted does not prolong the lease. Time counts
-- modulo 2 ** 40: an end in the past is equal to one far ahead, and rejected because it is more than `most` cycles
-- ahead.
--
-- A word takes two cycles, which do not lengthen a lease. The first cycle subtracts: `ahead` is the time from the cycle
-- after the write to the end. The second cycle compares `ahead` and loads it into `left`, which counts down. While
-- armed, `left` is the number of cycles to the end plus one; if it is `least`, the next cycle is the end. It is `least`
-- while disarmed, too. So one comparison rejects both a kick that would shorten the lease and an arm whose end comes
-- before it takes effect. A wrong bit in `left` or `now` cannot make a lease longer than the range of `left`.
--
-- The highest bit of the token states the owner's choice for the end. If it is '1', the lease continues after its end
-- while `empty` is '0', for at most `finish_us`. During that time it accepts only a disarm. If `finish_us` is 0, a word
-- with that bit is ignored.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_lease is
  generic (
    -- At least 1: number of independent leases.
    axes : positive := 1;
    -- At least 1: frequency of clk in Hz.
    clock_hz : positive := 50_000_000;
    -- A time of 3 to 2 ** 30 cycles, rounded up to cycles: maximum time to the end in us.
    most_us : positive := 100_000;
    -- A time of 0 to 2 ** 30 cycles: maximum time in us for which a lease can continue after its end.
    finish_us : natural := 0;
    -- Whether there is an e-stop. If false, `estop` is ignored.
    estop_used : boolean := true
  );
  port (
    -- Clock; its rising edge is active.
    clk : in    std_logic;
    -- Synchronous reset, active high, for at least one cycle; it disarms.
    rst : in    std_logic;
    -- Cycles of clk, from the gateway's timestamp counter.
    now : in    std_logic_vector(63 downto 0);
    -- '1': no accepted schedule entry is pending after the end of the lease.
    empty : in    std_logic_vector(axes - 1 downto 0) := (others => '1');
    -- Token of the owner (bits 63 to 40; bit 63: pending entries continue after the end), and the end of the lease
    -- (bits 39 to 0): a time of now, modulo 2 ** 40.
    arm : in    std_logic_vector(axes * 64 - 1 downto 0);
    -- '1' for one cycle: arm was written.
    arm_written : in    std_logic_vector(axes - 1 downto 0);
    -- As arm, for a lease that has begun.
    kick : in    std_logic_vector(axes * 64 - 1 downto 0);
    -- '1' for one cycle: kick was written; ignored if arm_written is '1' in the same cycle.
    kick_written : in    std_logic_vector(axes - 1 downto 0);
    -- Equal to now; the register bank reads it.
    clock : out   std_logic_vector(axes * 64 - 1 downto 0);
    -- Value of now in the last cycle with armed = '1' before the last fault.
    fault_time : out   std_logic_vector(axes * 64 - 1 downto 0);
    -- '1' during the lease.
    armed : out   std_logic_vector(axes - 1 downto 0);
    -- 0: disarmed; 1: armed; 2: fault, until the next arm; 3: finishing, after the end.
    state : out   std_logic_vector(axes * 2 - 1 downto 0);
    -- '1' in state 3.
    finishing : out   std_logic_vector(axes - 1 downto 0);
    -- Reason for which armed fell last. 0: it has not fallen since the reset; 1: disarm; 2: silence, the end came; 3:
    -- e-stop.
    reason : out   std_logic_vector(axes * 3 - 1 downto 0);
    -- Number of leases begun since the reset, modulo 2 ** 16.
    arms : out   std_logic_vector(axes * 16 - 1 downto 0);
    -- '1': the e-stop is open, and stops.
    estop_open : out   std_logic_vector(axes - 1 downto 0);
    -- Unused: a write of any value disarms.
    disarm : in    std_logic_vector(axes - 1 downto 0) := (others => '0');
    -- '1' for one cycle: armed is '0' from the next cycle on; an arm or kick in this cycle or the one before is
    -- discarded.
    disarm_written : in    std_logic_vector(axes - 1 downto 0);
    -- Equals armed.
    enable : out   std_logic_vector(axes - 1 downto 0);
    -- '0' stops, '1' permits operation. Clock: none.
    estop : in    std_logic_vector(axes - 1 downto 0) := (others => '1')
  );
end entity ul_lease;

architecture rtl of ul_lease is

  -- Converts and rounds up an allowed number; others become `lowest`, so that elaboration reaches their assertion.
  function cycles_of (cycles : real; lowest : natural) return natural is
  begin

    if cycles < real(lowest) or cycles > 2.0 ** 30 then
      return lowest;
    end if;
    return integer(cycles + 0.499_999);

  end function cycles_of;

  constant time_bits  : positive := 40;
  constant token_bits : positive := 64 - time_bits;

  -- Maximum number of cycles to the end, and for which the lease continues after it.
  constant cycles      : real     := real(most_us) * real(clock_hz) / 1.0e6;
  constant most        : positive := cycles_of(cycles, 3);
  constant more_cycles : real     := real(finish_us) * real(clock_hz) / 1.0e6;
  constant more        : natural  := cycles_of(more_cycles, 0);
  constant least       : positive := 2;

  constant reason_none     : std_logic_vector(1 downto 0) := "00";
  constant reason_disarmed : std_logic_vector(1 downto 0) := "01";
  constant reason_silence  : std_logic_vector(1 downto 0) := "10";
  constant reason_estop    : std_logic_vector(1 downto 0) := "11";

  subtype instant_t is unsigned(time_bits - 1 downto 0);

  subtype token_t is std_logic_vector(token_bits - 1 downto 0);

  subtype left_t is unsigned(maximum(log2_ceil(most), log2_ceil(more + 2)) - 1 downto 0);

  signal stops : std_logic_vector(axes - 1 downto 0);

begin

  assert cycles > 2.0 and cycles <= 2.0 ** 30
    report "ul_lease: most_us is " & integer'image(most_us) & ", expected a time of 3 to 2 ** 30 cycles of a "
           & "clock of " & integer'image(clock_hz) & " Hz"
    severity failure;

  assert more_cycles <= 2.0 ** 30
    report "ul_lease: finish_us is " & integer'image(finish_us) & ", expected a time of at most 2 ** 30 cycles of "
           & "a clock of " & integer'image(clock_hz) & " Hz"
    severity failure;

  with_estop : if estop_used generate

    signal is_cut : std_logic_vector(axes - 1 downto 0);

  begin

    is_cut <= not estop;

    estop_crossing : entity work.ul_synchroniser
      generic map (
        width => axes,
        idle  => '1'
      )
      port map (
        clk => clk,
        rst => rst,
        d   => is_cut,
        q   => stops
      );

  end generate with_estop;

  without_estop : if not estop_used generate

    stops <= (others => '0');

  end generate without_estop;

  estop_open <= stops;

  all_axes : for axis in 0 to axes - 1 generate

    signal given       : std_logic_vector(63 downto 0);
    signal is_asked    : std_logic;
    signal is_arm      : std_logic;
    signal token_asked : token_t;
    signal ahead       : instant_t;
    signal token       : token_t;
    signal left        : left_t;
    signal is_near     : std_logic;
    signal is_later    : std_logic;
    signal may_ask     : std_logic;
    signal takes       : std_logic;
    signal begins      : std_logic;
    signal falls       : std_logic;
    signal goes_on     : std_logic;

    signal is_finishing : std_logic;

    signal is_fault : std_logic;
    signal why      : std_logic_vector(1 downto 0);
    signal fell_at  : std_logic_vector(63 downto 0);
    signal begun    : unsigned(15 downto 0);

    -- Disarmed between configuration and reset, too.
    -- vsg_off signal_007
    signal is_armed : std_logic := '0';
  -- vsg_on signal_007

  begin

    given <= arm(64 * axis + 63 downto 64 * axis) when arm_written(axis) = '1' else
             kick(64 * axis + 63 downto 64 * axis);

    -- Cycles from the next cycle to the end: one less than from the present cycle.
    subtract : process (clk) is
    begin

      if rising_edge(clk) then
        is_asked    <= (arm_written(axis) or kick_written(axis)) and not disarm_written(axis);
        is_arm      <= arm_written(axis);
        token_asked <= given(63 downto time_bits);
        ahead       <= unsigned(given(time_bits - 1 downto 0)) + not unsigned(now(time_bits - 1 downto 0));
        if rst = '1' or (more = 0 and given(63) = '1') then
          is_asked <= '0';
        end if;
      end if;

    end process subtract;

    is_near  <= '1' when ahead < most else
                '0';
    is_later <= '1' when ahead(left'range) >= left else
                '0';
    may_ask  <= is_arm when is_armed = '0' else
                '1' when token_asked = token else
                '0';
    takes    <= is_asked and may_ask and is_near and is_later and not is_finishing and not stops(axis) and
                not disarm_written(axis);
    begins   <= takes and not is_armed;
    falls    <= '1' when stops(axis) = '1' or disarm_written(axis) = '1' or left <= least else
                is_finishing and empty(axis);
    goes_on  <= not is_finishing and not empty(axis) and token(token'high) and not stops(axis) and
                not disarm_written(axis) when more > 0 else
                '0';

    lease : process (clk) is
    begin

      if rising_edge(clk) then
        left <= to_unsigned(least, left'length);
        if takes = '1' then
          is_armed <= '1';
          is_fault <= '0';
          token    <= token_asked;
          left     <= ahead(left'range);
        elsif is_armed = '1' and falls = '0' then
          left <= left - 1;
        elsif is_armed = '1' and goes_on = '1' then
          is_finishing <= '1';
          left         <= to_unsigned(more + 1, left'length);
        elsif is_armed = '1' then
          is_armed     <= '0';
          is_finishing <= '0';
          if stops(axis) = '1' then
            is_fault <= '1';
            why      <= reason_estop;
            fell_at  <= now;
          elsif disarm_written(axis) = '1' then
            why <= reason_disarmed;
          else
            is_fault <= '1';
            why      <= reason_silence;
            fell_at  <= now;
          end if;
        end if;

        if begins = '1' then
          begun <= begun + 1;
        end if;

        if rst = '1' then
          is_armed     <= '0';
          is_finishing <= '0';
          is_fault     <= '0';
          why          <= reason_none;
          fell_at      <= (others => '0');
          begun        <= (others => '0');
          left         <= to_unsigned(least, left'length);
        end if;
      end if;

    end process lease;

    armed(axis)                                 <= is_armed;
    enable(axis)                                <= is_armed;
    finishing(axis)                             <= is_finishing;
    state(2 * axis + 1 downto 2 * axis)         <= (is_fault or is_finishing) & is_armed;
    reason(3 * axis + 2 downto 3 * axis)        <= '0' & why;
    fault_time(64 * axis + 63 downto 64 * axis) <= fell_at;
    arms(16 * axis + 15 downto 16 * axis)       <= std_logic_vector(begun);
    clock(64 * axis + 63 downto 64 * axis)      <= now;

  end generate all_axes;

end architecture rtl;
