-- SPDX-License-Identifier: BSD-3-Clause
--
-- Incremental encoders: position, index and velocity of each axis (gateware/cores/encoder/README.md).
--
-- Each axis filters and counts by itself (`ul_encoder_axis`); one divider makes the velocities of all
-- (`ul_encoder_velocity`).

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_encoder is
  generic (
    -- At least 1: encoders.
    axes : positive := 1;
    -- At least 4: frequency of clk in Hz, from which velocities follow.
    clock_hz : positive := 50_000_000;
    -- At least 1: samples in a row, one in each cycle, that make another level of a pin.
    filter : positive := 15;
    -- Whether rising edges of a are counted instead of a quadrature, down while b is '1'.
    counter : boolean := false
  );
  port (
    -- Rising edges count.
    clk : in    std_logic;
    -- Synchronous, active high.
    rst : in    std_logic;
    -- '1' for one cycle: velocities are made anew.
    tick : in    std_logic;
    -- Counts of each axis, signed; goes round.
    position : out   std_logic_vector(axes * 32 - 1 downto 0);
    -- Signed, in counts/s * 2 ** -8; saturates.
    velocity : out   std_logic_vector(axes * 32 - 1 downto 0);
    -- The position at the last rising edge of z.
    index_position : out   std_logic_vector(axes * 32 - 1 downto 0);
    -- Rising edges of z; goes round.
    index_count : out   std_logic_vector(axes * 16 - 1 downto 0);
    -- Cycles in which a and b have changed together, and the position stays; goes round. None with counter.
    errors : out   std_logic_vector(axes * 16 - 1 downto 0);
    -- The pins. a leads b while the position goes up. Clock: none.
    a : in    std_logic_vector(axes - 1 downto 0);
    b : in    std_logic_vector(axes - 1 downto 0) := (others => '0');
    -- The index. Clock: none.
    z : in    std_logic_vector(axes - 1 downto 0) := (others => '0')
  );
end entity ul_encoder;

architecture rtl of ul_encoder is

  -- Half a second, up to a power of two, four times.
  constant time_bits : positive := log2_ceil((clock_hz + 1) / 2) + 2;

  signal time_now    : unsigned(time_bits - 1 downto 0);
  signal since_round : std_logic;
  signal begins      : std_logic;
  -- The synchronisers are behind the reset by then.
  signal settling : unsigned(3 downto 0);
  signal settled  : std_logic;

  signal positions  : std_logic_vector(axes * 32 - 1 downto 0);
  signal edge_times : std_logic_vector(axes * time_bits - 1 downto 0);
  signal down       : std_logic_vector(axes - 1 downto 0);
  signal moved      : std_logic_vector(axes - 1 downto 0);
  signal taken      : std_logic_vector(axes - 1 downto 0);

begin

  assert clock_hz >= 4
    report "ul_encoder: clock_hz is " & integer'image(clock_hz) & ", expected 4 at least"
    severity failure;

  each : for index in 0 to axes - 1 generate

    axis_inst : entity work.ul_encoder_axis
      generic map (
        filter    => filter,
        counter   => counter,
        time_bits => time_bits
      )
      port map (
        clk            => clk,
        rst            => rst,
        settled        => settled,
        time_now       => std_logic_vector(time_now),
        a              => a(index),
        b              => b(index),
        z              => z(index),
        filtered       => open,
        position       => positions(index * 32 + 31 downto index * 32),
        index_position => index_position(index * 32 + 31 downto index * 32),
        index_count    => index_count(index * 16 + 15 downto index * 16),
        errors         => errors(index * 16 + 15 downto index * 16),
        edge_time      => edge_times((index + 1) * time_bits - 1 downto index * time_bits),
        down           => down(index),
        moved          => moved(index),
        taken          => taken(index)
      );

  end generate each;

  position <= positions;

  velocity_inst : entity work.ul_encoder_velocity
    generic map (
      axes      => axes,
      clock_hz  => clock_hz,
      time_bits => time_bits
    )
    port map (
      clk       => clk,
      rst       => rst,
      tick      => begins,
      time_now  => std_logic_vector(time_now),
      position  => positions,
      edge_time => edge_times,
      down      => down,
      moved     => moved,
      taken     => taken,
      velocity  => velocity
    );

  -- Where ticks are rare, there is a round before the time goes round.
  begins  <= tick or (time_now(time_bits - 2) xor since_round);
  settled <= settling(3);

  main : process (clk) is
  begin

    if rising_edge(clk) then
      time_now    <= time_now + 1;
      since_round <= time_now(time_bits - 2);
      if settled = '0' then
        settling <= settling + 1;
      end if;

      if rst = '1' then
        time_now    <= (others => '0');
        since_round <= '0';
        settling    <= (others => '0');
      end if;
    end if;

  end process main;

end architecture rtl;
