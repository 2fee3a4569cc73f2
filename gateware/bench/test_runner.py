"""The runner of the benches reports faults: a fault that it ignored would be found by no bench."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import pytest

from gateware.bench.runner import BenchError, run_bench

if TYPE_CHECKING:
    from pathlib import Path

_ENTITY = """\
library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;
entity faulty is port (clk, rst : in std_logic; q : out std_logic); end entity faulty;
architecture rtl of faulty is
  signal n : unsigned(3 downto 0);
begin
  process (clk) is
  begin
    if rising_edge(clk) then
      {statements}
    end if;
  end process;
end architecture rtl;
"""


@pytest.mark.parametrize(
    ("statements", "said"),
    [
        ("if n = 1 then q <= '1'; else q <= '0'; end if;", "the simulator warned"),
        ("q <= n(0);", r"assert \['q'\] == \[\]"),
        ("q <= nothing;", "does not analyse"),
        ('assert false report "no" severity failure;', "did not run to its end|tests failed"),
    ],
    ids=["an undefined signal is compared", "an output is undefined", "a source is wrong", "an assertion fails"],
)
def test_bench_fails_for_a_fault_in_the_entity(statements: str, said: str, tmp_path: Path) -> None:
    source = tmp_path / "faulty.vhd"
    source.write_text(_ENTITY.format(statements=statements))
    with pytest.raises(BenchError, match=said):
        run_bench(
            "faulty",
            "gateware.bench.reset.bench_reset",
            extra_sources=[source],
            extra_env={"PORTS": json.dumps([["clk", "rst"], ["q"], []])},
        )


def test_a_bench_that_runs_no_test_fails() -> None:
    with pytest.raises(BenchError, match="stream_register"):
        run_bench("ul_stream_register", "gateware.bench.streams")
