"""The arithmetic of generics at elaboration, compared with Python's."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

from gateware.bench.test_documentation import ghdl
from unity_link.gateware.cache import LIBRARY, vhdl_sources

if TYPE_CHECKING:
    from pathlib import Path

_MOST = 2**31 - 1
_BENCH = """\
library unity_link;
  use unity_link.ul_math_pkg.all;
entity cycles is end entity cycles;
architecture bench of cycles is
begin
{asserts}
end architecture bench;
"""
_ASSERT = """\
  assert cycles_of({duration}, {per_second}, {clock_hz}) = {cycles}
    report "{duration} of {per_second} at {clock_hz} are not {cycles}"
    severity failure;"""


def test_duration_in_cycles_is_rounded_up_and_limited_to_the_largest_number(tmp_path: Path) -> None:
    rng = random.Random(1)
    cases = [
        (rng.getrandbits(rng.randint(1, 31)), 10 ** rng.choice([3, 6, 9]), rng.getrandbits(30) + 1) for _ in range(200)
    ]
    cases += [(0, 10**9, 50_000_000), (1510, 10**9, 10_000_000), (_MOST, 10**9, 10**9), (1, 1, _MOST), (1, 10**9, 1)]
    found = [(*case, -(-case[0] * case[2] // case[1])) for case in cases]
    asserts = [
        _ASSERT.format(duration=duration, per_second=per_second, clock_hz=clock_hz, cycles=min(cycles, _MOST))
        for duration, per_second, clock_hz, cycles in found
        if not 2**29 < cycles <= 2**31
    ]
    assert len(asserts) > 100
    source = tmp_path / "cycles.vhd"
    source.write_text(_BENCH.format(asserts="\n".join(asserts)))
    ghdl(tmp_path, "-i", f"--work={LIBRARY}", *map(str, vhdl_sources()))
    ghdl(tmp_path, "-i", str(source))
    ghdl(tmp_path, "-m", "cycles")
    ghdl(tmp_path, "-r", "cycles")
