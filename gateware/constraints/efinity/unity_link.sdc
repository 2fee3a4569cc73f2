# SPDX-License-Identifier: BSD-3-Clause
#
# unity_link in Efinity. Made by `make lists` from the VHDL. Unchecked: see README.md.
#
# 10 ns: put the period of the faster clock here. It also bounds the skew of a pointer, which has no command of its own.
#
# FT232H, table 4.1 of FT_000288: outputs from 0 to 9 ns after CLKOUT, setup 7.5 ns, hold 0. FT2232H: outputs from 1 to
# 7.15 ns, setup 8 ns.

create_clock -name ft_clkout -period 16.667 [get_ports {ft_clkout}]

set_input_delay -clock ft_clkout -max 9 [get_ports {ft_rxf_n ft_txe_n ft_data[*]}]
set_input_delay -clock ft_clkout -min 0 [get_ports {ft_rxf_n ft_txe_n ft_data[*]}]
set_output_delay -clock ft_clkout -max 7.5 [get_ports {ft_rd_n ft_wr_n ft_oe_n ft_siwu_n ft_data[*]}]
set_output_delay -clock ft_clkout -min 0 [get_ports {ft_rd_n ft_wr_n ft_oe_n ft_siwu_n ft_data[*]}]

# Gray pointers, and the memory of a FIFO if it consists of LUTs.
set_max_delay -from [get_cells {*write_gray*}] -to [get_cells {*write_crossing/meta*}] 10
set_max_delay -from [get_cells {*read_gray*}] -to [get_cells {*read_crossing/meta*}] 10
set_max_delay -from [get_cells {*ft245_sync*fifo*memory*}] -to [get_cells {*ft245_sync*fifo*out_data*}] 10
set_max_delay -from [get_cells {*mac_inst*fifo*memory*}] -to [get_cells {*mac_inst*fifo*out_data*}] 10

# Single bits, and resets, which are asserted asynchronously.
set_false_path -to [get_cells {*trigger_crossing/meta*}]
set_false_path -to [get_cells {*up_crossing/meta*}]
set_false_path -to [get_cells {*question_crossing/meta*}]
set_false_path -to [get_cells {*answer_crossing/meta*}]
set_false_path -to [get_cells {*driving_crossing/meta*}]
set_false_path -to [get_cells {*rx_up_crossing/meta*}]
set_false_path -to [get_cells {*tx_up_crossing/meta*}]
set_false_path -to [get_cells {*carrier_crossing/meta*}]
set_false_path -to [get_cells {*rx_crossing/meta*}]
set_false_path -to [get_cells {*cts_crossing/meta*}]
set_false_path -to [get_cells {*pins_crossing/meta*}]
set_false_path -to [get_cells {*estop_crossing/meta*}]
set_false_path -to [get_cells {*chip_reset/meta*}]
set_false_path -to [get_cells {*chip_quiet/meta*}]
set_false_path -to [get_cells {*chip_quiet_data/meta*}]
set_false_path -to [get_cells {*rx_reset/meta*}]
set_false_path -to [get_cells {*tx_reset/meta*}]
set_false_path -to [get_cells {*ft245_async*receive_flag*}]
set_false_path -to [get_cells {*ft245_async*transmit_flag*}]
