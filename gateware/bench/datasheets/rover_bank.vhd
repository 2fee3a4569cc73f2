-- SPDX-License-Identifier: BSD-3-Clause
--
-- Top for the pictures of a generated register bank: the bank of examples/rover.ul with a pipelined master. The shown
-- elements of its records are ports.

library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library work;
  use work.rover_map.all;

entity rover_bank is
  port (
    clk               : in    std_logic;
    rst               : in    std_logic;
    wb_cyc            : in    std_logic;
    wb_stb            : in    std_logic;
    wb_we             : in    std_logic;
    wb_adr            : in    std_logic_vector(7 downto 0);
    wb_dat_i          : in    std_logic_vector(31 downto 0);
    wb_dat_o          : out   std_logic_vector(31 downto 0);
    wb_ack            : out   std_logic;
    wb_err            : out   std_logic;
    wb_stall          : out   std_logic;
    sample_access     : in    std_logic;
    hits              : in    unsigned(15 downto 0);
    log               : in    unsigned(7 downto 0);
    log_valid         : in    std_logic;
    log_ready         : out   std_logic;
    left_duty         : out   signed(11 downto 0);
    left_duty_written : out   std_logic
  );
end entity rover_bank;

architecture sim of rover_bank is

  constant still : wheel_from_hardware_t := (speed => (others => '0'), position => (others => '0'));

  signal from_hardware : rover_from_hardware_t;
  signal to_hardware   : rover_to_hardware_t;

begin

  from_hardware.battery   <= x"0C80";
  from_hardware.hits      <= hits;
  from_hardware.log       <= log;
  from_hardware.log_valid <= log_valid;
  from_hardware.left      <= still;
  from_hardware.right     <= still;

  log_ready         <= to_hardware.log_ready;
  left_duty         <= to_hardware.left.duty;
  left_duty_written <= to_hardware.left.duty_written;

  registers : entity work.rover_registers
    generic map (
      wb_pipelined => true
    )
    port map (
      clk           => clk,
      rst           => rst,
      wb_cyc        => wb_cyc,
      wb_stb        => wb_stb,
      wb_we         => wb_we,
      wb_adr        => wb_adr,
      wb_dat_i      => wb_dat_i,
      wb_dat_o      => wb_dat_o,
      wb_ack        => wb_ack,
      wb_err        => wb_err,
      wb_stall      => wb_stall,
      sample_access => sample_access,
      from_hardware => from_hardware,
      to_hardware   => to_hardware
    );

end architecture sim;
