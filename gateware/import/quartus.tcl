# SPDX-License-Identifier: BSD-3-Clause
# Quartus, in an open project: source import/quartus.tcl
# Files in compile order; made by `make lists`.
set gateware [file dirname [file dirname [file normalize [info script]]]]
set_global_assignment -name VHDL_FILE [file join $gateware rtl/base/ul_math_pkg.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/base/ul_reset_synchroniser.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/base/ul_stream_register.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/base/ul_synchroniser.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/datalink/ul_crc_pkg.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/ul_fifo_port.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/ul_pad_input.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/ul_pad_output.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/unity_link_pkg.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware cores/encoder/ul_encoder_axis.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware cores/gpio/ul_gpio.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware cores/lease/ul_lease.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware cores/pwm/ul_pwm.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware cores/stepgen/ul_stepgen_ramp.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/ul_base_tick.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/ul_frame_writer.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/ul_group_timer.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/ul_request_decoder.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/ul_request_executor.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/ul_send_immediate.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/base/ul_fifo_async.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/base/ul_fifo_sync.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/base/ul_word_memory.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/base/ul_word_ring.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/bus/ul_axi4_lite_master.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/bus/ul_bus_master.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/bus/ul_wishbone_master.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/datalink/ul_datalink_rx.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/datalink/ul_datalink_tx.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/datalink/ul_plain_rx.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/datalink/ul_plain_tx.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/ul_ft245_pads.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware cores/encoder/ul_encoder_velocity.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware cores/schedule/ul_schedule.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware cores/stepgen/ul_stepgen.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/ul_gateway_clock.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/ul_ft245_async.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/ul_ft245_sync.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/physical/ul_uart.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware cores/encoder/ul_encoder.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/application/ul_subscription_manager.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/unity_link_core.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/unity_link.vhd] -library unity_link -hdl_version VHDL_2008
set_global_assignment -name VHDL_FILE [file join $gateware rtl/unity_link_fifo.vhd] -library unity_link -hdl_version VHDL_2008
