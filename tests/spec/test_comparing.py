"""The comparison of a program's spec with a board's: equal, compatible, or different with a list of differences."""

import random
from collections import Counter
from pathlib import Path

import pytest

from support.changed_specs import BALANCER, COMPATIBLE, CORES, INCOMPATIBLE, OF_CORES, ROVER, SCARA, WALKER, changed
from unity_link.data.describing import MOST_DIFFERENCES
from unity_link.spec import compile_file
from unity_link.spec.comparing import compare

INCOMPATIBLE_OF = {ROVER: (560, 20), SCARA: (120, 12), WALKER: (20, 8), BALANCER: (50, 2), CORES: (50, 6)}
"""Number of random changes of each spec, and the smallest number of their kinds that must occur."""
COMPATIBLE_OF = {ROVER: 150, SCARA: 20, WALKER: 10, BALANCER: 10, CORES: 10}


@pytest.mark.slow
@pytest.mark.parametrize("path", INCOMPATIBLE_OF, ids=lambda path: path.stem)
def test_each_incompatible_change_is_found_and_named(path: Path) -> None:
    mine, chance, tried = compile_file(path).interface(), random.Random(path.name), Counter[str]()
    changes = OF_CORES if path in {BALANCER, CORES} else INCOMPATIBLE
    times, fewest = INCOMPATIBLE_OF[path]
    for _ in range(times):
        name, change = changed(path, chance, changes)
        tried[name] += 1
        differences = compare(mine, change.interface)
        named = [one for one in differences[:MOST_DIFFERENCES] if change.thing in one.partition(": ")[0]]
        assert any(change.what in one for one in named), (name, change, differences)
        assert change.interface.fingerprint != mine.fingerprint, (name, change)
    assert len(tried) >= fewest, tried


@pytest.mark.slow
@pytest.mark.parametrize("path", COMPATIBLE_OF, ids=lambda path: path.stem)
def test_each_compatible_change_is_no_difference(path: Path) -> None:
    mine, chance, tried = compile_file(path).interface(), random.Random(path.name), Counter[str]()
    for _ in range(COMPATIBLE_OF[path]):
        name, change = changed(path, chance, COMPATIBLE)
        tried[name] += 1
        assert compare(mine, change.interface) == (), (name, change.text)
    assert len(tried) > len(COMPATIBLE) / 2, tried
