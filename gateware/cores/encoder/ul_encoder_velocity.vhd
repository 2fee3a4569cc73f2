-- SPDX-License-Identifier: BSD-3-Clause
--
-- The velocity of all axes, by one divider: counts between two edges, over the cycles between them.
--
-- A round looks at each axis in turn. Where there was a count, the last one is the edge of this round: it lies `way`
-- counts and `span` cycles behind the edge of the round before, and
--
--   velocity = way * 256 * clock_hz / span
--
-- in counts/s * 2 ** -8. Where there was none, the axis is slower than one count in the cycles since its last edge: it
-- keeps the lower one of its velocity and that bound. Half a second without a count, up to a power of two in cycles, is
-- standstill: then the next edge is the first of a pair again.
--
-- Product and quotient are one: the bits of 256 * clock_hz come in from the highest one down, and
--
--   way * (bits so far) = quotient * span + remainder, with a remainder below span
--
-- holds after each. A bit doubles both sides, and adds `way` to the right one if it is set; either is followed by a
-- subtraction of span at most, because way is never more than span. So a bit takes two cycles.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_encoder_velocity is
  generic (
    axes      : positive := 1;
    clock_hz  : positive := 50_000_000;
    time_bits : positive := 27
  );
  port (
    clk : in    std_logic;
    rst : in    std_logic;
    -- Begins a round, or another one behind that which is under way.
    tick     : in    std_logic;
    time_now : in    std_logic_vector(time_bits - 1 downto 0);
    -- Of the axes, lowest bits first. Of positions, those that a way has are looked at.
    position  : in    std_logic_vector(axes * 32 - 1 downto 0);
    edge_time : in    std_logic_vector(axes * time_bits - 1 downto 0);
    down      : in    std_logic_vector(axes - 1 downto 0);
    moved     : in    std_logic_vector(axes - 1 downto 0);
    taken     : out   std_logic_vector(axes - 1 downto 0);
    velocity  : out   std_logic_vector(axes * 32 - 1 downto 0)
  );
end entity ul_encoder_velocity;

architecture rtl of ul_encoder_velocity is

  constant factor      : unsigned(39 downto 0) := to_unsigned(clock_hz, 32) & x"00";
  constant factor_bits : positive              := log2_ceil(clock_hz) + 9;
  constant axis_bits   : positive              := maximum(log2_ceil(axes), 1);

  subtype time_t is unsigned(time_bits - 1 downto 0);

  subtype wide_t is unsigned(time_bits + 1 downto 0);

  subtype place_t is unsigned(axis_bits - 1 downto 0);

  type times_t is array (0 to axes - 1) of time_t;

  type velocities_t is array (0 to axes - 1) of signed(31 downto 0);

  type state_t is (
    state_idle, state_look, state_wait, state_compare, state_turn, state_begin, state_double, state_add, state_end
  );

  signal state   : state_t;
  signal waiting : std_logic;
  signal axis    : place_t;
  signal bit_now : unsigned(5 downto 0);
  signal last    : std_logic;

  signal positions  : times_t;
  signal edges      : times_t;
  signal velocities : velocities_t;
  signal known      : std_logic_vector(axes - 1 downto 0);
  signal looked_at  : std_logic_vector(axes - 1 downto 0);

  -- Of the axis that is looked at: its edge and those of the round before, and its velocity.
  signal place       : time_t;
  signal instant     : time_t;
  signal now         : time_t;
  signal goes        : std_logic;
  signal is_known    : std_logic;
  signal kept        : std_logic_vector(2 * time_bits - 1 downto 0);
  signal to_keep     : std_logic_vector(2 * time_bits - 1 downto 0);
  signal keeps       : std_logic;
  signal kept_place  : time_t;
  signal kept_time   : time_t;
  signal old         : signed(31 downto 0);
  signal speed       : unsigned(30 downto 0);
  signal is_negative : std_logic;

  signal way        : time_t;
  signal span       : time_t;
  signal way_less   : wide_t;
  signal too_long   : std_logic;
  signal remainder  : wide_t;
  signal quotient   : unsigned(31 downto 0);
  signal grown      : unsigned(32 downto 0);
  signal digit      : std_logic;
  signal dividend   : wide_t;
  signal less       : wide_t;
  signal fits       : std_logic;
  signal is_full    : std_logic;
  signal new_speed  : unsigned(30 downto 0);
  signal stands     : std_logic;
  signal changes    : std_logic;
  signal factor_bit : std_logic;

  signal new_velocity : signed(31 downto 0);

begin

  gathered : for index in 0 to axes - 1 generate

    positions(index) <= unsigned(position(index * 32 + time_bits - 1 downto index * 32));
    edges(index)     <= unsigned(edge_time((index + 1) * time_bits - 1 downto index * time_bits));

    velocity((index + 1) * 32 - 1 downto index * 32) <= std_logic_vector(velocities(index));

    looked_at(index) <= to_std_logic(axis = index);
    taken(index)     <= looked_at(index) and to_std_logic(state = state_look);

    result : process (clk) is
    begin

      if rising_edge(clk) then
        if state = state_end and looked_at(index) = '1' then
          known(index) <= goes or (is_known and not too_long);
          if changes = '1' then
            velocities(index) <= new_velocity;
          end if;
        end if;

        if rst = '1' then
          known(index)      <= '0';
          velocities(index) <= (others => '0');
        end if;
      end if;

    end process result;

  end generate gathered;

  -- The edge of the round before, of each axis.

  to_keep    <= std_logic_vector(place) & std_logic_vector(instant);
  kept_place <= unsigned(kept(2 * time_bits - 1 downto time_bits));
  kept_time  <= unsigned(kept(time_bits - 1 downto 0));

  of_many : if axes > 1 generate

    memory_inst : entity work.ul_word_memory
      generic map (
        width => 2 * time_bits,
        depth => 2 ** axis_bits
      )
      port map (
        clk         => clk,
        write       => keeps,
        write_index => axis,
        write_data  => to_keep,
        read_index  => axis,
        read_data   => kept
      );

  end generate of_many;

  of_one : if axes = 1 generate

    keep : process (clk) is
    begin

      if rising_edge(clk) then
        if keeps = '1' then
          kept <= to_keep;
        end if;
      end if;

    end process keep;

  end generate of_one;

  keeps <= goes and to_std_logic(state = state_end);

  -- The divider.

  factor_bit <= bit_at(std_logic_vector(factor), bit_now);

  dividend <= remainder(time_bits downto 0) & '0' when state = state_double else
              remainder + way when factor_bit = '1' else
              remainder;
  -- The same less span, beside it and not behind it.
  less <= (remainder(time_bits downto 0) & '0') - span when state = state_double else
          remainder + way_less;
  fits <= not less(time_bits + 1) and (factor_bit or to_std_logic(state = state_double));

  -- Twice the quotient, and both digits.
  grown(32 downto 1) <= quotient + 1 when digit = '1' and fits = '1' else
                        quotient;
  grown(0)           <= digit xor fits;

  last <= to_std_logic(axis = axes - 1);

  -- Standstill is found where nothing goes, and a bound where that is lower.
  new_speed    <= (others => '0') when stands = '1' else
                  (others => '1') when is_full = '1' else
                  quotient(30 downto 0);
  stands       <= too_long and not goes;
  changes      <= is_known and (goes or stands or to_std_logic(quotient < speed));
  new_velocity <= -signed('0' & new_speed) when is_negative = '1' else
                  signed('0' & new_speed);

  divide : process (clk) is
  begin

    if rising_edge(clk) then

      case state is

        when state_begin =>
          way_less  <= way - resize(span, time_bits + 2);
          remainder <= (others => '0');
          quotient  <= (others => '0');
          is_full   <= '0';
          bit_now   <= to_unsigned(factor_bits - 1, 6);

        when state_double | state_add =>
          remainder <= dividend;
          if fits = '1' then
            remainder <= less;
          end if;
          digit <= fits;
          if state = state_add then
            quotient <= grown(31 downto 0);
            is_full  <= is_full or grown(32) or grown(31);
            bit_now  <= bit_now - 1;
          end if;

        when others =>
          null;

      end case;

      if rst = '1' then
        way_less  <= (others => '0');
        remainder <= (others => '0');
        quotient  <= (others => '0');
        is_full   <= '0';
        digit     <= '0';
        bit_now   <= (others => '0');
      end if;
    end if;

  end process divide;

  main : process (clk) is
  begin

    if rising_edge(clk) then
      if tick = '1' then
        waiting <= '1';
      end if;

      case state is

        when state_idle =>
          axis <= (others => '0');
          if waiting = '1' then
            waiting <= tick;
            state   <= state_look;
          end if;

        when state_look =>
          place <= positions(to_integer(axis));
          if down(to_integer(axis)) = '1' then
            place <= positions(to_integer(axis)) + 1;
          end if;
          instant  <= edges(to_integer(axis));
          now      <= unsigned(time_now);
          goes     <= moved(to_integer(axis));
          is_known <= known(to_integer(axis));
          old      <= velocities(to_integer(axis));
          state    <= state_wait;

        when state_wait =>
          is_negative <= old(31);
          speed       <= unsigned(old(30 downto 0));
          if old(31) = '1' then
            speed <= unsigned(0 - old(30 downto 0));
          end if;
          state <= state_compare;

        when state_compare =>
          way  <= to_unsigned(1, time_bits);
          span <= now - instant;
          if goes = '1' and is_known = '1' then
            way  <= place - kept_place;
            span <= instant - kept_time;
          end if;
          state <= state_turn;

        when state_turn =>
          -- Half a second or more.
          too_long <= span(time_bits - 1) or span(time_bits - 2);
          if goes = '1' and is_known = '1' then
            is_negative <= way(time_bits - 1);
            if way(time_bits - 1) = '1' then
              way <= 0 - way;
            end if;
          end if;
          state <= state_begin;

        when state_begin =>
          state <= state_double;

        when state_double =>
          state <= state_add;

        when state_add =>
          state <= state_double;
          if bit_now = 0 then
            state <= state_end;
          end if;

        when state_end =>
          axis  <= axis + 1;
          state <= state_look;
          if last = '1' then
            state <= state_idle;
          end if;

      end case;

      if rst = '1' then
        state       <= state_idle;
        waiting     <= '0';
        axis        <= (others => '0');
        place       <= (others => '0');
        instant     <= (others => '0');
        now         <= (others => '0');
        goes        <= '0';
        is_known    <= '0';
        old         <= (others => '0');
        is_negative <= '0';
        speed       <= (others => '0');
        way         <= (others => '0');
        span        <= (others => '0');
        too_long    <= '0';
      end if;
    end if;

  end process main;

end architecture rtl;
