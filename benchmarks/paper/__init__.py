"""The paper's experiment again, table by table, on a virtual FT232H: its Table I, its figures 3 and 4, its text.

What is run is this package's own host software, all of it, and the gateware itself, compiled, behind a model of the
chip and of the USB. So each figure has up to three parts, and says which:

- *clock-exact*: cycles of the gateware's clock, counted on the RTL
- *modelled*: the time of the USB and of the chip; `unity_link.virtual.ft232h.Timing` states every number's source
- *measured*: the processor time that the program took, on the machine that it ran on

They meet in an event loop whose time stands still while a model computes, jumps while everyone waits, and else runs
with the program's processor time (`unity_link.virtual.modelled_time`). Not in it is what the kernel and libusb take for
a transfer, and how long a sleeping program takes to wake up.

- `workbench`: a fresh gateway, chip and loop for each measurement; `stacks`: the two ways to them, driver and link;
  `media`: what is between chip and gateway; `probe`: a clock behind the gateway's bus
- `gateware`, `latency`, `throughput`, `publishing`, `variants`, `lines` measure; `experiment` runs all of it
- `results`: what comes out, as data; `published`: what the paper says
- `tables`, `table_1`, `plots`: how it is shown

Without a C++ compiler, the gateway's model in Python takes the place of the RTL; then nothing is clock-exact.
"""

from benchmarks.paper.experiment import run_experiment
from benchmarks.paper.results import Results

__all__ = ["Results", "run_experiment"]
