# SPDX-License-Identifier: BSD-3-Clause
# Quartus, in an open project: source import/quartus.tcl
# Files in compile order; made by `make lists`.
set gateware [file dirname [file dirname [file normalize [info script]]]]
set_global_assignment -name VHDL_FILE [file join $gateware rtl/bus/wishbone_master.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/cores/math_pkg.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/cores/reset_synchroniser.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/cores/stream_register.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/cores/synchroniser.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/datalink/crc_pkg.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/fifo_port.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/pad_input.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/pad_output.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/unity_link_pkg.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/base_tick.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/frame_writer.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/group_timer.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/request_decoder.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/request_executor.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/send_immediate.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/bus/axi4_lite_master.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/bus/bus_master.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/cores/fifo_async.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/cores/fifo_sync.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/cores/word_memory.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/cores/word_ring.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/datalink/datalink_rx.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/datalink/datalink_tx.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/datalink/plain_rx.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/datalink/plain_tx.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/ft245_pads.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/subscription_manager.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/ft245_async.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/ft245_sync.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/uart.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/unity_link_core.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/unity_link.vhd] -library work -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/unity_link_fifo.vhd] -library work -hdl_version VHDL_2008
