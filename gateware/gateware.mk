# Targets of the gateware; the Makefile in the folder above includes this file and sets VENV, BIN and ALL.

.PHONY: rtl synth synth-quick test-rtl lint-vhdl formal verilog lists datasheets

rtl: $(ALL) ## the gateware as C++ into unity_link/virtual/rtl/generated, from VHDL
	@$(BIN)/python -m gateware.tools.model

lists: $(ALL) ## file list, FuseSoC core and import scripts, after a change of files in gateware/rtl or gateware/cores
	@$(BIN)/python -m gateware.tools.lists

datasheets: $(ALL) ## tables and pictures of docs/reference/gateware and of the cores, after a change of an entity, its timing or its size
	@$(BIN)/python -m gateware.tools.datasheets

verilog: $(ALL) ## the gateway as Verilog-2005 into build/verilog, one file for each configuration
	@$(BIN)/python -m gateware.tools.verilog

synth: $(ALL) ## sizes and Fmax of changed designs into gateware/RESULTS.md, checked against gateware/budget.toml; mapped.json
	@$(BIN)/python -m gateware.tools.synth
	@$(BIN)/python -m gateware.tools.mapped

synth-quick: $(ALL) ## each top and each board through Yosys, not placed: short enough for a CI
	@$(BIN)/python -m gateware.tools.synth_quick

test-rtl: $(ALL) ## the benches of the gateware, in GHDL
	@$(BIN)/python -m pytest gateware/bench gateware/cores $(PYTEST_ARGS)

formal: $(ALL) ## prove the properties of gateware/formal and of the cores
	@$(BIN)/python -m gateware.tools.formal

lint-vhdl: $(ALL) ## the style of the VHDL sources
	@$(BIN)/vsg --configuration gateware/vsg.yaml --output_format syntastic \
		--filename $(sort $(shell find gateware/rtl gateware/cores gateware/pads gateware/boards -name '*.vhd'))

lint: lint-vhdl
