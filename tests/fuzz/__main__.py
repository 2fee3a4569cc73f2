"""Search for inputs that a target cannot take: ``python -m fuzz TARGET SECONDS``, from the directory of the tests.

Needs atheris, which `make fuzz` installs into an environment of its own. What is found stands in ``crash-...`` here;
new inputs that reach new code go to the folder that FUZZ_FINDINGS names, beside those in `corpus`.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

import atheris

with atheris.instrument_imports(include=["unity_link"]):
    from fuzz.targets import TARGETS

CORPUS = Path(__file__).with_name("corpus")


def main() -> None:
    """Search, for as long as the command line says."""
    name, seconds = sys.argv[1], sys.argv[2]
    target = TARGETS[name]
    findings = Path(os.environ.get("FUZZ_FINDINGS", "/tmp/unity-link-fuzz"), name)
    findings.mkdir(parents=True, exist_ok=True)
    # One input in a process that is instrumented may take long; a second is a hang.
    options = [f"-max_total_time={seconds}", "-timeout=20", "-rss_limit_mb=2048", "-print_final_stats=1"]
    atheris.Setup([sys.argv[0], str(findings), str(CORPUS / name), *options], target)
    atheris.Fuzz()


if __name__ == "__main__":
    main()
