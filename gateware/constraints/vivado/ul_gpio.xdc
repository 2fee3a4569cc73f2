# SPDX-License-Identifier: BSD-3-Clause
#
# ul_gpio in Vivado: read_xdc -ref ul_gpio ul_gpio.xdc
#
# Made by `make lists` from the VHDL. Unchecked: see README.md.
#
# What comes from no clock, or is one bit: any delay is right. A reset begins at any instant; its end is timed, from the
# last register of its row on.

set_false_path -quiet -to [get_cells -quiet -hierarchical -filter {NAME =~ *pins_crossing/meta_reg*}]
