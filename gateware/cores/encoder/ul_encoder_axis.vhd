-- SPDX-License-Identifier: BSD-3-Clause
--
-- One axis of an encoder: its pins, filtered, and what is counted of them.
--
-- A filter gives another level on when it has seen that so many times in a row. Then the two signals are looked at
-- together: one that changes is a count, both in one cycle are an error, since the way between cannot be known.
--
-- While `settled` is '0', the filters stand open and nothing counts: what the pins show at the start is no movement.
--
-- An edge stands between two positions, and is the same one in both directions: from 4 to 5 and from 5 to 4. So what
-- tells velocity is the edge and its instant: `position`, and `down` added to it, which says that the last count went
-- down.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.ul_math_pkg.all;

entity ul_encoder_axis is
  generic (
    filter    : positive := 15;
    counter   : boolean  := false;
    time_bits : positive := 27
  );
  port (
    clk     : in    std_logic;
    rst     : in    std_logic;
    settled : in    std_logic;
    -- Runs freely.
    time_now : in    std_logic_vector(time_bits - 1 downto 0);
    a        : in    std_logic;
    b        : in    std_logic;
    z        : in    std_logic;
    -- z, b, a behind the filters.
    filtered       : out   std_logic_vector(2 downto 0);
    position       : out   std_logic_vector(31 downto 0);
    index_position : out   std_logic_vector(31 downto 0);
    index_count    : out   std_logic_vector(15 downto 0);
    errors         : out   std_logic_vector(15 downto 0);
    -- Of the last count.
    edge_time : out   std_logic_vector(time_bits - 1 downto 0);
    down      : out   std_logic;
    -- There was a count since `taken`.
    moved : out   std_logic;
    taken : in    std_logic
  );
end entity ul_encoder_axis;

architecture rtl of ul_encoder_axis is

  constant count_bits : natural := log2_ceil(filter);

  subtype count_t is unsigned(count_bits - 1 downto 0);

  type counts_t is array (0 to 2) of count_t;

  signal pins    : std_logic_vector(2 downto 0);
  signal sampled : std_logic_vector(2 downto 0);
  signal level   : std_logic_vector(2 downto 0);
  signal old     : std_logic_vector(2 downto 0);

  signal changed_a : std_logic;
  signal changed_b : std_logic;
  signal counts    : std_logic;
  signal goes_down : std_logic;
  signal is_error  : std_logic;
  signal is_index  : std_logic;

  signal place      : unsigned(31 downto 0);
  signal change     : unsigned(31 downto 0);
  signal next_place : unsigned(31 downto 0);
  signal indexes    : unsigned(15 downto 0);
  signal faults     : unsigned(15 downto 0);

begin

  pins <= z & b & a;

  pins_crossing : entity work.ul_synchroniser
    generic map (
      width => 3
    )
    port map (
      clk => clk,
      rst => rst,
      d   => pins,
      q   => sampled
    );

  unfiltered : if filter = 1 generate

    filters : process (clk) is
    begin

      if rising_edge(clk) then
        level <= sampled;

        if rst = '1' then
          level <= (others => '0');
        end if;
      end if;

    end process filters;

  end generate unfiltered;

  with_filter : if filter > 1 generate

    signal seen : counts_t;

  begin

    filters : process (clk) is
    begin

      if rising_edge(clk) then

        for pin in 0 to 2 loop

          seen(pin) <= (others => '0');
          if sampled(pin) /= level(pin) then
            seen(pin) <= seen(pin) + 1;
            if seen(pin) = filter - 1 or settled = '0' then
              seen(pin)  <= (others => '0');
              level(pin) <= sampled(pin);
            end if;
          end if;

        end loop;

        if rst = '1' then
          seen  <= (others => (others => '0'));
          level <= (others => '0');
        end if;
      end if;

    end process filters;

  end generate with_filter;

  filtered <= level;

  changed_a <= level(0) xor old(0);
  changed_b <= level(1) xor old(1);
  is_index  <= settled and level(2) and not old(2);

  in_quadrature : if not counter generate

    counts    <= settled and (changed_a xor changed_b);
    is_error  <= settled and changed_a and changed_b;
    goes_down <= level(0) xnor old(1);

  end generate in_quadrature;

  by_edges : if counter generate

    counts    <= settled and changed_a and level(0);
    is_error  <= '0';
    goes_down <= level(1);

  end generate by_edges;

  -- 0, 1 or -1.
  change     <= (0 => counts, others => counts and goes_down);
  next_place <= place + change;

  position    <= std_logic_vector(place);
  index_count <= std_logic_vector(indexes);
  errors      <= std_logic_vector(faults);

  main : process (clk) is
  begin

    if rising_edge(clk) then
      old   <= level;
      place <= next_place;
      if is_error = '1' then
        faults <= faults + 1;
      end if;
      if is_index = '1' then
        indexes        <= indexes + 1;
        index_position <= std_logic_vector(next_place);
      end if;
      if taken = '1' then
        moved <= '0';
      end if;
      if counts = '1' then
        moved     <= '1';
        down      <= goes_down;
        edge_time <= time_now;
      end if;

      if rst = '1' then
        old            <= (others => '0');
        place          <= (others => '0');
        faults         <= (others => '0');
        indexes        <= (others => '0');
        index_position <= (others => '0');
        moved          <= '0';
        down           <= '0';
        edge_time      <= (others => '0');
      end if;
    end if;

  end process main;

end architecture rtl;
