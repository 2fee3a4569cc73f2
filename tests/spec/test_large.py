"""A spec of 10,000 signals compiles, and the work grows no faster than its size.

Benchmarks measure the time; these tests count function calls, which are the same on every machine.
"""

import sys
from collections.abc import Callable
from types import FrameType

import pytest

from unity_link.spec import compile_text

FLAT = '  @s{0} = {0}: signed 16 READ(ID="s {0}", POLL(10), SCALE=0.1, UNIT="V");\n'


def flat(signals: int) -> str:
    return "public x() {\n  GATEWAY(ADDRESS_BITS=16);\n" + "".join(map(FLAT.format, range(signals))) + "}\n"


def arrays(signals: int) -> str:
    return f"""
        public x() {{ GATEWAY(ADDRESS_BITS=16); legs[{signals // 10}]: leg("leg " + i) @(10 * i); }}
        leg(name): @(base) {{ joints[2]: joint(name + ":" + i) @(base + 5 * i); }}
        joint(name): @(base) {{
          @a = base: signed 16 READ(ID=name + ":a", SCALE=0.1, POLL(10));
          @b = base + 1: signed 16 READ(ID=name + ":b", SCALE=0.1, POLL(10));
          @c = base + 2: signed 16 READ(ID=name + ":c", SCALE=0.1, POLL(10));
          @d = base + 3[15:0]: READWRITE(ID=name + ":d", MIN=1, MAX=9);
          @e = base + 4: float READ(ID=name + ":e");
        }}
    """


def calls(text: str) -> int:
    """Return the number of Python function calls that a compilation makes."""
    count = 0

    def profile(frame: FrameType, event: str, argument: object) -> None:
        nonlocal count
        count += event == "call"

    sys.setprofile(profile)
    try:
        compile_text(text)
    finally:
        sys.setprofile(None)
    return count


@pytest.mark.slow
@pytest.mark.parametrize("make", [flat, arrays], ids=["flat", "arrays"])
def test_10_000_signals_compile(make: Callable[[int], str]) -> None:
    assert len(compile_text(make(10_000)).interface().signals) == 10_000


@pytest.mark.slow
@pytest.mark.parametrize(("make", "most"), [(flat, 600), (arrays, 400)], ids=["flat", "arrays"])
def test_the_work_for_each_signal_is_constant_in_a_large_spec(make: Callable[[int], str], most: int) -> None:
    calls(make(100))  # The parser is made once.
    small, large = calls(make(500)), calls(make(2500))
    assert large <= 5 * small * 1.02
    assert large / 2500 <= most
