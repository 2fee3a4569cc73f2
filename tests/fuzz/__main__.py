"""Search for inputs that make a target fail: ``python -m fuzz TARGET SECONDS``, from the directory of the tests.

Targets in Python need atheris, which `make fuzz` installs into an environment of its own; the clients in C and C++ need
clang. Failing inputs are written to ``crash-...`` here; inputs that reach new code are written to the folder that
FUZZ_FINDINGS names, in addition to those in `corpus`.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NoReturn

from fuzz.clients import PROGRAMS, build_search

CORPUS = Path(__file__).with_name("corpus")


def main() -> None:
    """Search for the time that the command line names."""
    known = sorted(path.name for path in CORPUS.iterdir())
    if len(sys.argv) != 3 or sys.argv[1] not in known:
        sys.exit(f"a target and its seconds were expected: one of {', '.join(known)}, as in `python -m fuzz serve 60`")
    name, seconds = sys.argv[1:]
    findings = Path(os.environ.get("FUZZ_FINDINGS", "/tmp/unity-link-fuzz"), name)
    findings.mkdir(parents=True, exist_ok=True)
    # An input in an instrumented process may take long; more than 20 s is a hang.
    options = [f"-max_total_time={seconds}", "-timeout=20", "-rss_limit_mb=2048", "-print_final_stats=1"]
    given = [str(findings), str(CORPUS / name), *options]
    if name in PROGRAMS:
        _search_client(name, given)
    _search(name, given)


def _search_client(name: str, given: list[str]) -> NoReturn:
    with tempfile.TemporaryDirectory(prefix="unity-link-fuzz.") as folder:
        try:
            program = build_search(name, Path(folder))
        except FileNotFoundError as error:
            sys.exit(str(error))
        sys.exit(subprocess.run([program, *given, "-max_len=1024", "-len_control=0"], check=False).returncode)


def _search(name: str, given: list[str]) -> None:
    import atheris

    with atheris.instrument_imports(include=["unity_link"]):
        from fuzz.targets import TARGETS
    atheris.Setup([sys.argv[0], *given], TARGETS[name])
    atheris.Fuzz()


if __name__ == "__main__":
    main()
