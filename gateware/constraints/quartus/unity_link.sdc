# SPDX-License-Identifier: BSD-3-Clause
#
# unity_link in Quartus. Made by `make lists` from the VHDL. Unchecked: see README.md.
#
# FT232H, table 4.1 of FT_000288: outputs from 0 to 9 ns after CLKOUT, setup 7.5 ns, hold 0. FT2232H: outputs from 1 to
# 7.15 ns, setup 8 ns.

if {[get_collection_size [get_ports -nowarn ft_clkout]]} {
    create_clock -name ft_clkout -period 16.667 [get_ports {ft_clkout}]
    set_input_delay -clock ft_clkout -max 9 [get_ports {ft_rxf_n ft_txe_n ft_data[*]}]
    set_input_delay -clock ft_clkout -min 0 [get_ports {ft_rxf_n ft_txe_n ft_data[*]}]
    set_output_delay -clock ft_clkout -max 7.5 [get_ports {ft_rd_n ft_wr_n ft_oe_n ft_siwu_n ft_data[*]}]
    set_output_delay -clock ft_clkout -min 0 [get_ports {ft_rd_n ft_wr_n ft_oe_n ft_siwu_n ft_data[*]}]
}

# Gray pointers: delay below a cycle of the receiving clock, skew below a cycle of the sending clock.
foreach way {write read} {
    set from [get_registers -nowarn "*ul_fifo_async*|${way}_gray\[*\]"]
    set to   [get_registers -nowarn "*ul_fifo_async*|*:${way}_crossing|meta\[*\]"]
    if {[get_collection_size $to]} {
        set_false_path -hold -from $from -to $to
        set_max_delay -from $from -to $to 100
        set_net_delay -from $from -to $to -max -get_value_from_clock_period dst_clock_period -value_multiplier 0.8
        set_max_skew -from $from -to $to -get_skew_value_from_clock_period src_clock_period -skew_value_multiplier 0.8
    }
}

# The memory of a FIFO if it consists of LUTs. 10 ns: put the period of the faster clock here.
set memory [get_registers -nowarn "*ul_fifo_async*|*memory*"]
set taken  [get_registers -nowarn "*ul_fifo_async*|out_data\[*\]"]
if {[get_collection_size $memory] && [get_collection_size $taken]} {
    set_max_delay -from $memory -to $taken 10
}

# Single bits, and resets, which are asserted asynchronously.
foreach crossing {trigger_crossing up_crossing question_crossing answer_crossing driving_crossing rx_up_crossing tx_up_crossing carrier_crossing rx_crossing cts_crossing pins_crossing estop_crossing} {
    set_false_path -to [get_registers -nowarn "*${crossing}|meta*"]
}
foreach crossing {chip_reset chip_quiet chip_quiet_data rx_reset tx_reset} {
    set_false_path -to [get_pins -nowarn -compatibility_mode "*${crossing}|meta*|clrn"]
}
set_false_path -to [get_registers -nowarn "*ul_ft245_async*|*receive_flag|*"]
set_false_path -to [get_registers -nowarn "*ul_ft245_async*|*transmit_flag|*"]
