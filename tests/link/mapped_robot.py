"""Simulates a SCARA robot behind a bus that is mapped from a file: ``mapped_robot.py FILE``."""

import mmap
import sys
import time
from pathlib import Path

POSITIONS, SET_POINTS = range(0x88, 0x8C), range(0x8C, 0x90)

with Path(sys.argv[1]).open("r+b") as file:
    words = memoryview(mmap.mmap(file.fileno(), 0)).cast("I")
sys.stdout.write("ready\n")
sys.stdout.flush()
while True:
    for position, set_point in zip(POSITIONS, SET_POINTS, strict=True):
        words[position] = words[set_point]
    time.sleep(0.001)
