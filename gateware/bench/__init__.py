"""cocotb benches of the gateware: one folder per entity, run by GHDL from pytest.

`test_<entity>.py` is what pytest collects: it names the configurations (generics) to run. `bench_<entity>.py` beside it
holds the cocotb tests, which run inside the simulator. `runner.run_bench` joins the two.
"""
