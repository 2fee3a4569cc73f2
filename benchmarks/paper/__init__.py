"""The paper's experiment again, table by table, on a virtual FT232H: its Table I, its figures 3 and 4, its text.

It runs the complete host software of this package and the compiled gateware, with a model of the chip and of USB. So
each figure has up to three parts, which are named:

- *clock-exact*: cycles of the gateware's clock, counted on the RTL
- *modelled*: the time of USB and of the chip; `unity_link.virtual.ft232h.Timing` has the source of every number
- *measured*: the processor time of the program, on the machine that it ran on

The parts are added in an event loop with its own time: it stops while a model computes, jumps while all tasks
wait, and otherwise advances with the program's processor time (`unity_link.virtual.modelled_time`). It does not include
the time of the kernel and of libusb for a transfer, and the time in which a sleeping program wakes up.

- `workbench`: a new gateway, chip and loop for each measurement; `stacks`: the two ways to them, driver and link;
  `media`: the connections between chip and gateway; `probe`: a clock on the gateway's bus
- `gateware`, `latency`, `throughput`, `publishing`, `variants` and `lines` measure; `experiment` runs all of them
- `results`: the results as data; `published`: the figures of the paper
- `tables`, `table_1`, `plots`: presentation

Without a C++ compiler, the gateway's Python model replaces the RTL; then no figure is clock-exact.
"""

from benchmarks.paper.experiment import run_experiment
from benchmarks.paper.results import Results

__all__ = ["Results", "run_experiment"]
