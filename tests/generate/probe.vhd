-- An entity for a core of a spec, with every kind of port that a core can have.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

entity probe is
  generic (
    axes : positive := 1;
    clock_hz : positive := 1;
    weight : natural := 0;
    name : string := ""
  );
  port (
    clk : in std_logic;
    rst : in std_logic;
    tick : in std_logic;
    now : in std_logic_vector(63 downto 0);
    armed : in std_logic_vector(axes - 1 downto 0);
    set : in std_logic_vector(axes * 8 - 1 downto 0);
    set_written : in std_logic_vector(axes - 1 downto 0);
    goal : in std_logic_vector(axes * 24 - 1 downto 0);
    goal_written : in std_logic_vector(axes - 1 downto 0);
    seen : out std_logic_vector(axes * 3 - 1 downto 0);
    long : out std_logic_vector(axes * 40 - 1 downto 0);
    hit : out std_logic_vector(axes - 1 downto 0);
    touch_in : in std_logic_vector(axes - 1 downto 0);
    touch_out : out std_logic_vector(axes - 1 downto 0);
    touch_oe : out std_logic_vector(axes - 1 downto 0)
  );
end entity probe;

architecture rtl of probe is

begin

  assert weight = 3 and name = "a ""word"""
    severity failure;

  each : for axis in 0 to axes - 1 generate

    watch : process (clk) is
    begin

      if rising_edge(clk) then
        seen(3 * axis + 2 downto 3 * axis) <= armed(axis) & tick & touch_in(axis);
        long(40 * axis + 39 downto 40 * axis) <= now(39 downto 0);
        hit(axis) <= touch_in(axis) and not set_written(axis);
        touch_out(axis) <= set(8 * axis);
        touch_oe(axis) <= set(8 * axis + 1) and not rst and not (goal(24 * axis) and goal_written(axis));
      end if;

    end process watch;

  end generate each;

end architecture rtl;
