-- SPDX-License-Identifier: BSD-3-Clause
--
-- The speed of an axis in the next round, so that neither its acceleration nor its target is overshot.
--
-- All is counted in rounds: a speed is the way of one round, an acceleration the change of speed from one to the next.
-- There is no multiplication: `needed` follows what the axis does. It is the way that the axis would still go if it went
-- one more round at its speed, and then lost `accel` in each: speed + (speed - accel) + (speed - 2 * accel) ... So
--
--   one more round at `speed`:             possible where the way left is `needed` or more; `needed` stays,
--   a round at `faster`, which is higher:  possible where it is needed + faster or more; that is `needed` then,
--   a round at `slower`:                   possible always, if the round before was; it is needed - speed then.
--
-- The last bit of a way is shorter than what one round of acceleration gives, and is gone in one round. An axis whose
-- `needed` is not known, because it comes from a velocity or has followed nothing in a round, stops first. The
-- acceleration may change in a round of an axis that stands or follows nothing. An axis that stands takes a round to
-- turn. Where the acceleration has no limit, the speed of a round does not depend on that before it, and `needed` is 0.
--
-- Everything is a register, in every cycle: results follow from what is given, if that stays, six cycles later.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.unity_link_pkg.all;

entity ul_stepgen_ramp is
  generic (
    place_bits : positive := 64;
    -- Less than place_bits.
    speed_bits : positive := 40
  );
  port (
    clk : in    std_logic;
    -- '1': results are those of an axis that stands at 0.
    clear : in    std_logic;
    -- What is wanted: the target in the mode `position`, else the speed; nothing unless `follows`.
    is_position : in    std_logic;
    follows     : in    std_logic;
    target      : in    std_logic_vector(place_bits - 1 downto 0);
    -- At most the limit. May come two cycles later than all others.
    wanted : in    std_logic_vector(speed_bits - 1 downto 0);
    -- Of the speed that is wanted.
    is_down : in    std_logic;
    -- May come one cycle later than all others, and so may the acceleration.
    limit : in    std_logic_vector(speed_bits - 1 downto 0);
    accel : in    std_logic_vector(speed_bits - 1 downto 0);
    -- `accel` has no limit, and is 0.
    is_sudden : in    std_logic;
    -- State of the axis.
    place : in    std_logic_vector(place_bits - 1 downto 0);
    -- The complement of `needed`, -1 - needed: an iCE40 subtracts it without a LUT for the inversion of each bit.
    unneeded : in    std_logic_vector(place_bits - 1 downto 0);
    speed    : in    std_logic_vector(speed_bits - 1 downto 0);
    down     : in    std_logic;
    -- `needed` holds; it does for an axis that stands.
    known  : in    std_logic;
    stands : in    std_logic;
    -- The next state, six cycles later; the speed and the direction are there one cycle sooner.
    next_place    : out   std_logic_vector(place_bits - 1 downto 0);
    next_unneeded : out   std_logic_vector(place_bits - 1 downto 0);
    next_speed    : out   std_logic_vector(speed_bits - 1 downto 0);
    next_down     : out   std_logic;
    next_known    : out   std_logic;
    next_stands   : out   std_logic;
    -- It stands at its target, and did.
    arrived : out   std_logic
  );
end entity ul_stepgen_ramp;

architecture rtl of ul_stepgen_ramp is

  -- One bit more, for a sign or a carry.
  constant way_bits : positive := place_bits + 1;
  constant sum_bits : positive := speed_bits + 1;

  subtype place_t is unsigned(place_bits - 1 downto 0);

  subtype speed_t is unsigned(speed_bits - 1 downto 0);

  subtype way_t is signed(way_bits - 1 downto 0);

  subtype sum_t is unsigned(sum_bits - 1 downto 0);

  -- One addition for tools that would make two of it.
  function sum_of (left, right : unsigned; carry : std_logic) return unsigned is

    constant sum : unsigned(left'length downto 0) := (left & carry) + (right & carry);

  begin

    return sum(left'length downto 1);

  end function sum_of;

  -- In the order in which they are there.
  signal away      : place_t;
  signal ahead     : unsigned(way_bits - 1 downto 0);
  signal spare     : way_t;
  signal slower    : sum_t;
  signal base      : speed_t;
  signal rise      : speed_t;
  signal faster    : sum_t;
  signal bound     : way_t;
  signal most      : speed_t;
  signal is_short  : std_logic;
  signal too_fast  : std_logic;
  signal is_over   : std_logic;
  signal is_wrong  : std_logic;
  signal is_behind : std_logic;
  signal to_bound  : std_logic;
  signal gains     : std_logic;
  signal keeps     : std_logic;
  signal ends      : std_logic;
  signal gained    : std_logic;
  signal kept      : std_logic;
  signal arrives   : std_logic;
  signal new_speed : speed_t;
  signal is_still  : std_logic;
  signal change    : place_t;
  signal way       : place_t;

begin

  -- The way to the target, in the direction in which the axis goes: of the complement, one less is the opposite.
  ahead <= not (away(place_bits - 1) & away) when down = '1' else
           away(place_bits - 1) & away;

  -- What is wanted lies in the other direction.
  is_wrong  <= bound(way_bits - 1) when is_position = '1' else
               down xor is_down;
  is_behind <= is_wrong or (is_position and not known);

  -- What a speed that is gained begins from.
  base <= (others => '0') when is_sudden = '1' else
          unsigned(speed);

  to_bound <= follows and not is_behind and is_short and (stands or is_sudden or not is_position) and not is_over;
  gains    <= follows and not is_behind and not is_short and not too_fast and not is_over;
  keeps    <= follows and not is_behind and not is_over and is_position;
  ends     <= slower(sum_bits - 1) or is_sudden;

  choose : process (clk) is
  begin

    if rising_edge(clk) then
      if clear = '1' then
        away      <= (others => '0');
        spare     <= (others => '0');
        slower    <= (others => '0');
        rise      <= (others => '0');
        faster    <= (others => '0');
        bound     <= (others => '0');
        most      <= (others => '0');
        is_short  <= '0';
        too_fast  <= '0';
        is_over   <= '0';
        gained    <= '0';
        kept      <= '0';
        arrives   <= '0';
        new_speed <= (others => '0');
        next_down <= '0';
      else
        away <= sum_of(unsigned(target), not unsigned(place), not down);

        spare  <= signed(sum_of(ahead, '1' & unsigned(unneeded), '1'));
        slower <= ('0' & unsigned(speed)) - unsigned(accel);
        rise   <= unsigned(accel);
        if is_sudden = '1' or unsigned(accel) > unsigned(limit) then
          rise <= unsigned(limit);
        end if;

        faster <= ('0' & base) + rise;
        bound  <= spare;
        most   <= unsigned(limit);
        if is_position = '0' then
          bound <= signed(resize(unsigned(wanted), way_bits));
          most  <= unsigned(wanted);
        end if;

        is_short <= to_std_logic(bound <= signed(resize(faster, way_bits)));
        too_fast <= to_std_logic(faster > unsigned(limit));
        is_over  <= to_std_logic(base > most);

        gained  <= to_bound or gains;
        kept    <= keeps;
        arrives <= to_bound and is_position;
        if to_bound = '1' then
          new_speed <= unsigned(bound(speed_bits - 1 downto 0));
        elsif gains = '1' then
          new_speed <= faster(speed_bits - 1 downto 0);
        elsif keeps = '1' then
          new_speed <= unsigned(speed);
        elsif ends = '1' then
          new_speed <= (others => '0');
        else
          new_speed <= slower(speed_bits - 1 downto 0);
        end if;
        next_down <= down xor (stands and follows and is_wrong);
      end if;
    end if;

  end process choose;

  next_speed <= std_logic_vector(new_speed);

  is_still <= to_std_logic(new_speed = 0);
  change   <= not resize(new_speed, place_bits) when gained = '1' else
              resize(unsigned(speed), place_bits);
  way      <= not resize(new_speed, place_bits) when down = '1' else
              resize(new_speed, place_bits);

  move : process (clk) is
  begin

    if rising_edge(clk) then
      if clear = '1' then
        next_place    <= (others => '0');
        next_unneeded <= (others => '1');
        next_known    <= '1';
        next_stands   <= '1';
        arrived       <= '0';
      else
        next_place    <= std_logic_vector(sum_of(unsigned(place), way, down));
        next_unneeded <= unneeded;
        if is_still = '1' or is_sudden = '1' then
          next_unneeded <= (others => '1');
        elsif gained = '1' or kept = '0' then
          next_unneeded <= std_logic_vector(sum_of(unsigned(unneeded), change, gained));
        end if;
        next_known  <= is_still or (known and is_position and follows);
        next_stands <= is_still;
        arrived     <= arrives and is_still;
      end if;
    end if;

  end process move;

end architecture rtl;
