"""cocotb benches of the gateware: one folder for each entity, run in GHDL by pytest.

pytest collects `test_<entity>.py`, which names the configurations (generics) to run. `bench_<entity>.py` in the same
folder has the cocotb tests, which run inside the simulator. `runner.run_bench` connects the two.
"""
