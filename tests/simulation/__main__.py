"""Run seeds of the simulation: ``python -m simulation FIRST [COUNT]``."""

from __future__ import annotations

import sys
import time
from collections import Counter

from simulation.world import run_seed


def main() -> None:
    first = int(sys.argv[1])
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    began = time.process_time()
    kinds = Counter()
    reqs = []
    sess = []
    faults = []
    for seed in range(first, first + count):
        o = run_seed(seed)
        reqs.append(o.requests); sess.append(o.sessions); faults.append(sum(o.injected.values()))
        if o.error:
            kinds[o.error.kind] += 1
            if count==1:
                for t in o.trace:
                    if t[2]!="carry" or "-v" in sys.argv: print(f"{t[0]:.6f}",*t[1:])
            if kinds[o.error.kind] <= 3: print(seed, str(o.error)[:300])
    spent = time.process_time() - began
    import statistics as s
    print(kinds, f"{spent/count*1e3:.1f} ms", "median requests", s.median(reqs), "sessions", s.median(sess), "faults", s.median(faults))


main()
