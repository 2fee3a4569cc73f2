-- SPDX-License-Identifier: BSD-3-Clause
--
-- Step generators: axes that go to a position or at a velocity, on one data path (gateware/cores/stepgen/README.md).
--
-- A second has 2 ** rate_bits rounds, and in each all axes are looked at in turn, for seven cycles: `ul_stepgen_ramp`
-- makes the speed of the next round, and the place of an axis moves by it. Where it comes to be nearer to another step,
-- that goes out at once, or the axis waits for a round: so places are those of the steps that have gone out. All times
-- of the pins are counted in rounds.
--
-- In units of a round all numbers are whole: a speed of 1 is 2 ** -rate_bits steps/s, an acceleration of 1 is 1 step/s2.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;
  use work.unity_link_pkg.all;

entity ul_stepgen is
  generic (
    -- At least 1: motors.
    axes : positive := 1;
    -- At least 1792 for each axis: Hz of clk.
    clock_hz : positive := 50_000_000;
    -- At least 0: nanoseconds for which a pulse is high at least.
    steplen_ns : natural := 2000;
    -- At least 0: nanoseconds between two pulses at least.
    stepspace_ns : natural := 2000;
    -- At least 0: nanoseconds for which dir is stable before a pulse begins, at least.
    dirsetup_ns : natural := 5000;
    -- At least 0: nanoseconds for which dir is stable after a pulse has ended, at least.
    dirhold_ns : natural := 5000;
    -- Whether dir is '1' upwards, and not downwards.
    reverse : boolean := false
  );
  port (
    -- Rising edges count.
    clk : in    std_logic;
    -- Synchronous, active high. Places are 0 behind it, and a pulse is cut.
    rst : in    std_logic;
    -- '0': the axis slows down by maxaccel, stands, and stays until it is commanded anew.
    armed : in    std_logic_vector(axes - 1 downto 0) := (others => '1');
    -- Signed, in steps * 2 ** -8.
    position_cmd         : in    std_logic_vector(axes * 32 - 1 downto 0);
    position_cmd_written : in    std_logic_vector(axes - 1 downto 0);
    -- Signed, in steps/s * 2 ** -8.
    velocity_cmd : in    std_logic_vector(axes * 29 - 1 downto 0);
    -- Not needed.
    velocity_cmd_written : in    std_logic_vector(axes - 1 downto 0) := (others => '0');
    -- '0': to a position, '1': at a velocity.
    mode         : in    std_logic_vector(axes - 1 downto 0);
    mode_written : in    std_logic_vector(axes - 1 downto 0);
    -- In steps/s * 2 ** -8.
    maxvel : in    std_logic_vector(axes * 28 - 1 downto 0);
    -- Not needed.
    maxvel_written : in    std_logic_vector(axes - 1 downto 0) := (others => '0');
    -- In steps/s2; 0 is no limit. A new one acts from the next standstill, or if the axis has no command.
    maxaccel : in    std_logic_vector(axes * 28 - 1 downto 0);
    -- Not needed.
    maxaccel_written : in    std_logic_vector(axes - 1 downto 0) := (others => '0');
    -- Signed, in steps * 2 ** -8; goes round. To the nearest step, halves up, it is the pulses that have begun: those
    -- upwards less those downwards.
    position : out   std_logic_vector(axes * 32 - 1 downto 0);
    -- Signed, in steps/s * 2 ** -8.
    velocity : out   std_logic_vector(axes * 29 - 1 downto 0);
    -- The axis stands at position_cmd.
    in_position : out   std_logic_vector(axes - 1 downto 0);
    -- The axis slows down or stands for want of a command.
    holding : out   std_logic_vector(axes - 1 downto 0);
    -- A pulse for each step.
    step : out   std_logic_vector(axes - 1 downto 0);
    -- '1' downwards.
    dir : out   std_logic_vector(axes - 1 downto 0)
  );
end entity ul_stepgen;

architecture rtl of ul_stepgen is

  constant cycles_of_axis : positive := 7;

  -- The most rounds of which each has the cycles of all axes.
  function most_rate_bits return positive is
  begin

    for bits in 20 downto 9 loop

      if clock_hz / 2 ** bits >= cycles_of_axis * axes then
        return bits;
      end if;

    end loop;

    return 8;

  end function most_rate_bits;

  constant rate_bits : positive := most_rate_bits;
  constant fraction  : positive := 2 * rate_bits;

  constant place_bits : positive := 24 + fraction;
  -- An axis goes less than a step in a round; an acceleration may be more.
  constant speed_bits : positive := maximum(fraction, 28);
  constant speed_unit : natural  := rate_bits - 8;

  -- Cycles of the shortest round, and rounds of a duration.
  constant shortest : positive := maximum(clock_hz / 2 ** rate_bits, 1);

  function rounds_of (duration_ns : natural) return positive is
  begin

    return maximum((minimum(cycles_of(duration_ns, 1_000_000_000, clock_hz), 2 ** 30) + shortest - 1) / shortest, 1);

  end function rounds_of;

  constant length_rounds : positive := rounds_of(steplen_ns);
  constant space_rounds  : positive := rounds_of(stepspace_ns);
  constant hold_rounds   : positive := rounds_of(dirhold_ns);
  constant setup_rounds  : positive := maximum(rounds_of(dirsetup_ns), space_rounds);
  constant most_rounds   : positive := maximum(maximum(length_rounds, space_rounds), maximum(hold_rounds, setup_rounds));
  constant age_bits      : positive := log2_ceil(most_rounds + 1);

  -- Pulses are never nearer to each other than they may be.
  constant fastest : natural := 2 ** (rate_bits + 8) / (length_rounds + space_rounds);

  constant axis_bits : positive := maximum(log2_ceil(axes), 1);

  subtype axis_t is unsigned(axis_bits - 1 downto 0);

  subtype age_t is unsigned(age_bits - 1 downto 0);

  -- What an axis keeps beside its place.
  constant kept_bits : positive := place_bits + speed_bits + age_bits + 6;

  type targets_t is array (0 to axes - 1) of std_logic_vector(31 downto 0);

  type velocities_t is array (0 to axes - 1) of signed(28 downto 0);

  type limits_t is array (0 to axes - 1) of unsigned(27 downto 0);

  -- Below 0 while a round goes on.
  signal time_left : signed(log2_ceil(clock_hz) downto 0);
  signal begins    : std_logic;
  signal clearing  : std_logic;

  signal is_busy    : std_logic;
  signal stage      : unsigned(2 downto 0);
  signal axis       : axis_t;
  signal takes      : std_logic;
  signal writes     : std_logic;
  signal write_axis : axis_t;

  -- Of each axis.
  signal fresh    : std_logic_vector(axes - 1 downto 0);
  signal obeys    : std_logic_vector(axes - 1 downto 0);
  signal dirty    : std_logic_vector(axes - 1 downto 0);
  signal is_there : std_logic_vector(axes - 1 downto 0);

  signal targets    : targets_t;
  signal velocities : velocities_t;
  signal maxvels    : limits_t;
  -- The accelerations that act. None is used before it was taken: the initial values only keep simulations quiet.
  -- vsg_off signal_007
  signal accels : limits_t := (others => (others => '0'));
  -- vsg_on signal_007

  -- Of the axis that is looked at: its commands,
  signal target_now   : std_logic_vector(31 downto 0);
  signal velocity_now : signed(28 downto 0);
  signal maxvel_now   : unsigned(27 downto 0);
  signal maxaccel_now : unsigned(27 downto 0);
  signal is_position  : std_logic;
  signal follows      : std_logic;
  signal size_now     : unsigned(28 downto 0);
  signal limit_now    : unsigned(27 downto 0);
  signal wanted_now   : unsigned(27 downto 0);

  -- the same in units of a round,
  signal target    : std_logic_vector(place_bits - 1 downto 0);
  signal wanted    : std_logic_vector(speed_bits - 1 downto 0);
  signal limit     : unsigned(speed_bits - 1 downto 0);
  signal accel     : unsigned(speed_bits - 1 downto 0);
  signal is_sudden : std_logic;

  -- its state, and the next one.
  signal kept          : std_logic_vector(kept_bits - 1 downto 0);
  signal to_keep       : std_logic_vector(kept_bits - 1 downto 0);
  signal place         : std_logic_vector(place_bits - 1 downto 0);
  signal unneeded      : std_logic_vector(place_bits - 1 downto 0);
  signal speed         : std_logic_vector(speed_bits - 1 downto 0);
  signal age           : age_t;
  signal down          : std_logic;
  signal known         : std_logic;
  signal stands        : std_logic;
  signal is_high       : std_logic;
  signal points_down   : std_logic;
  signal has_turned    : std_logic;
  signal next_place    : std_logic_vector(place_bits - 1 downto 0);
  signal next_unneeded : std_logic_vector(place_bits - 1 downto 0);
  signal next_speed    : std_logic_vector(speed_bits - 1 downto 0);
  signal next_down     : std_logic;
  signal next_known    : std_logic;
  signal next_stands   : std_logic;
  signal arrived       : std_logic;
  signal shown_speed   : unsigned(28 downto 0);
  signal shown         : unsigned(28 downto 0);

  -- Its pins.
  signal crosses     : std_logic;
  signal is_rested   : std_logic;
  signal begins_step : std_logic;
  signal ends_step   : std_logic;
  signal turns       : std_logic;
  signal has_event   : std_logic;
  signal moves       : std_logic;
  signal next_age    : age_t;
  signal next_high   : std_logic;
  signal next_points : std_logic;
  signal next_turned : std_logic;

begin

  assert clock_hz / 256 >= cycles_of_axis * axes
    report "ul_stepgen: clock_hz is " & integer'image(clock_hz) & ": at least 1792 for each of the "
           & integer'image(axes) & " axes was expected"
    severity failure;

  -- Rounds, and the axes in each.

  takes <= is_busy and to_std_logic(stage = 0);

  main : process (clk) is
  begin

    if rising_edge(clk) then
      begins    <= '0';
      time_left <= time_left + 2 ** rate_bits;
      if time_left >= 0 then
        time_left <= time_left + (2 ** rate_bits - clock_hz);
        begins    <= '1';
      end if;

      writes     <= '0';
      write_axis <= axis;
      if is_busy = '1' then
        stage <= stage + 1;
        if stage = cycles_of_axis - 1 then
          stage  <= (others => '0');
          writes <= '1';
          axis   <= axis + 1;
          if axis = axes - 1 then
            axis    <= (others => '0');
            is_busy <= '0';
          end if;
        end if;
      end if;
      if begins = '1' then
        is_busy <= '1';
      end if;
      -- The first round writes the states of axes that stand at 0.
      if writes = '1' and write_axis = axes - 1 then
        clearing <= '0';
      end if;

      if rst = '1' then
        begins     <= '0';
        time_left  <= to_signed(2 ** rate_bits - clock_hz, time_left'length);
        writes     <= '0';
        write_axis <= (others => '0');
        stage      <= (others => '0');
        axis       <= (others => '0');
        is_busy    <= '0';
        clearing   <= '1';
      end if;
    end if;

  end process main;

  -- Commands.

  obeys   <= armed and (fresh or mode);
  holding <= not obeys;

  take : process (clk) is
  begin

    if rising_edge(clk) then
      if takes = '1' then
        target_now   <= targets(to_integer(axis));
        velocity_now <= velocities(to_integer(axis));
        maxvel_now   <= maxvels(to_integer(axis));
        is_position  <= not mode(to_integer(axis));
        follows      <= obeys(to_integer(axis));
      end if;
      -- One cycle later, as the limit.
      maxaccel_now <= accels(to_integer(axis));

      size_now <= unsigned(velocity_now);
      if velocity_now < 0 then
        size_now <= unsigned(-velocity_now);
      end if;
      limit_now <= maxvel_now;
      if maxvel_now > fastest then
        limit_now <= to_unsigned(fastest, 28);
      end if;

      wanted_now <= size_now(27 downto 0);
      if size_now > limit_now then
        wanted_now <= limit_now;
      end if;

      if rst = '1' then
        target_now   <= (others => '0');
        velocity_now <= (others => '0');
        maxvel_now   <= (others => '0');
        maxaccel_now <= (others => '0');
        size_now     <= (others => '0');
        limit_now    <= (others => '0');
        wanted_now   <= (others => '0');
        is_position  <= '1';
        follows      <= '0';
      end if;
    end if;

  end process take;

  target    <= std_logic_vector(shift_left(resize(unsigned(target_now), place_bits), fraction - 8));
  wanted    <= std_logic_vector(shift_left(resize(wanted_now, speed_bits), speed_unit));
  limit     <= shift_left(resize(limit_now, speed_bits), speed_unit);
  accel     <= resize(maxaccel_now, speed_bits);
  is_sudden <= to_std_logic(maxaccel_now = 0);

  -- State.

  of_many : if axes > 1 generate

    places_inst : entity work.ul_word_memory
      generic map (
        width => place_bits,
        depth => 2 ** axis_bits
      )
      port map (
        clk         => clk,
        write       => moves,
        write_index => write_axis,
        write_data  => next_place,
        read_index  => axis,
        read_data   => place
      );

    memory_inst : entity work.ul_word_memory
      generic map (
        width => kept_bits,
        depth => 2 ** axis_bits
      )
      port map (
        clk         => clk,
        write       => writes,
        write_index => write_axis,
        write_data  => to_keep,
        read_index  => axis,
        read_data   => kept
      );

  end generate of_many;

  of_one : if axes = 1 generate

    keep : process (clk) is
    begin

      if rising_edge(clk) then
        if moves = '1' then
          place <= next_place;
        end if;
        if writes = '1' then
          kept <= to_keep;
        end if;
      end if;

    end process keep;

  end generate of_one;

  unneeded    <= kept(kept_bits - 1 downto kept_bits - place_bits);
  speed       <= kept(speed_bits + age_bits + 5 downto age_bits + 6);
  age         <= (others => '0') when clearing = '1' else
                 unsigned(kept(age_bits + 5 downto 6));
  down        <= kept(5);
  known       <= kept(4);
  stands      <= kept(3);
  is_high     <= kept(2);
  points_down <= kept(1);
  has_turned  <= kept(0);

  to_keep <= next_unneeded & next_speed & std_logic_vector(next_age) & next_down & next_known & next_stands & next_high
             & next_points & next_turned;

  ramp_inst : entity work.ul_stepgen_ramp
    generic map (
      place_bits => place_bits,
      speed_bits => speed_bits
    )
    port map (
      clk           => clk,
      clear         => clearing,
      is_position   => is_position,
      follows       => follows,
      target        => target,
      wanted        => wanted,
      is_down       => velocity_now(28),
      limit         => std_logic_vector(limit),
      accel         => std_logic_vector(accel),
      is_sudden     => is_sudden,
      place         => place,
      unneeded      => unneeded,
      speed         => speed,
      down          => down,
      known         => known,
      stands        => stands,
      next_place    => next_place,
      next_unneeded => next_unneeded,
      next_speed    => next_speed,
      next_down     => next_down,
      next_known    => next_known,
      next_stands   => next_stands,
      arrived       => arrived
    );

  shown_speed <= resize(shift_right(unsigned(next_speed), speed_unit), 29);

  show : process (clk) is
  begin

    if rising_edge(clk) then
      shown <= shown_speed;
      if down = '1' then
        shown <= 0 - shown_speed;
      end if;
    end if;

  end process show;

  -- Pins. A place is nearest to an even step where its bits of one and of a half are alike.

  crosses <= place(fraction) xor place(fraction - 1) xor next_place(fraction) xor next_place(fraction - 1);

  is_rested   <= not is_high and to_std_logic(age >= setup_rounds) when has_turned = '1' else
                 not is_high and to_std_logic(age >= space_rounds);
  begins_step <= crosses and is_rested and (points_down xnor down) and not clearing;
  ends_step   <= is_high and to_std_logic(age >= length_rounds);
  turns       <= (points_down xor down) and not stands and not is_high and to_std_logic(age >= hold_rounds);
  has_event   <= begins_step or ends_step or turns;

  moves <= writes and (not crosses or begins_step or clearing);

  next_age    <= to_unsigned(1, age_bits) when has_event = '1' or clearing = '1' else
                 age when age = most_rounds else
                 age + 1;
  next_high   <= (begins_step or (is_high and not ends_step)) and not clearing;
  next_points <= (points_down xor turns) and not clearing;
  next_turned <= ((has_turned or turns) and not begins_step) or clearing;

  each : for index in 0 to axes - 1 generate

    signal is_taken   : std_logic;
    signal is_written : std_logic;
    -- The axis stood at the end of its last look, which may be in the cycle in which the next one begins.
    signal stood       : std_logic;
    signal is_still    : std_logic;
    signal takes_accel : std_logic;

  begin

    is_taken   <= takes and to_std_logic(axis = index);
    is_written <= writes and to_std_logic(write_axis = index);

    targets(index)    <= position_cmd(index * 32 + 31 downto index * 32);
    velocities(index) <= signed(velocity_cmd(index * 29 + 28 downto index * 29));
    maxvels(index)    <= unsigned(maxvel(index * 28 + 27 downto index * 28));

    -- An acceleration that changes while the axis follows a position would void `needed`.
    is_still    <= next_stands when is_written = '1' else
                   stood;
    takes_accel <= is_taken and (is_still or not obeys(index));

    in_position(index) <= is_there(index) and obeys(index);

    result : process (clk) is
    begin

      if rising_edge(clk) then
        if is_written = '1' then
          velocity(index * 29 + 28 downto index * 29) <= std_logic_vector(shown);

          is_there(index) <= arrived and not dirty(index);
          step(index)     <= next_high;
          dir(index)      <= next_points xor to_std_logic(reverse);
        end if;
        if is_written = '1' and moves = '1' then
          position(index * 32 + 31 downto index * 32) <= next_place(fraction + 23 downto fraction - 8);
        end if;

        stood <= is_still;
        if takes_accel = '1' then
          accels(index) <= unsigned(maxaccel(index * 28 + 27 downto index * 28));
        end if;

        -- An axis is not yet where it goes by what was written since its commands were taken.
        if is_taken = '1' then
          dirty(index) <= '0';
        end if;
        if position_cmd_written(index) = '1' then
          fresh(index) <= '1';
        end if;
        if position_cmd_written(index) = '1' or mode_written(index) = '1' then
          dirty(index)    <= '1';
          is_there(index) <= '0';
        end if;
        if armed(index) = '0' then
          fresh(index) <= '0';
        end if;

        if rst = '1' then
          position(index * 32 + 31 downto index * 32) <= (others => '0');
          velocity(index * 29 + 28 downto index * 29) <= (others => '0');

          is_there(index) <= '0';
          step(index)     <= '0';
          dir(index)      <= to_std_logic(reverse);
          fresh(index)    <= '0';
          dirty(index)    <= '0';
          stood           <= '1';
        end if;
      end if;

    end process result;

  end generate each;

end architecture rtl;
