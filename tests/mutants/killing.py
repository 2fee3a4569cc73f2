"""Runs tests on a mutant in a process of its own: the tests that reach its lines, the quickest first, until one fails.

A process is forked for each mutant. The process already has the test tools and libraries, and loads the mutated module
in place of the one on disk; no file in the repository changes.
"""

from __future__ import annotations

import importlib.abc
import importlib.machinery
import importlib.util
import json
import os
import resource
import signal
import sys
import tempfile
import time
from itertools import accumulate
from pathlib import Path
from typing import TYPE_CHECKING

import coverage
import pytest
from hypothesis import Phase, settings

from mutants.choosing import FOLDERS, ROOT, Mutant, module_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from types import ModuleType

LIBRARIES = [
    "hypothesis.strategies",
    "numpy",
    "pytest_asyncio",
    "sybil.parsers.myst",
    "trio",
    "usb.core",
    "xdist.scheduler",
]
"""Modules that the tests import, and that each forked process already has."""
WORLDS = "tests/mutants/worlds.py"
"""Scenarios that run on each mutant that they reach, however many other tests do."""
TESTS = [
    "tests/capture",
    "tests/protocol",
    WORLDS,
    "tests/test_protocol_document.py",
    "tests/generate/test_c.py::test_client_sends_the_same_bytes_at_the_same_times_as_the_python_host",
    "tests/generate/test_c.py::test_outcomes_of_requests_at_a_reset_equal_those_of_the_python_host",
    "tests/virtual/test_gateway.py",
    "tests/virtual/test_groups.py",
    "tests/link/test_cut_again.py",
    "tests/link/test_exactly_once.py",
    "tests/link/test_half_duplex.py",
    "tests/link/test_life.py",
    "tests/link/test_post_many.py",
    "tests/link/test_promises.py",
    "tests/link/test_reads_of_any_cut.py",
    "tests/link/test_recovery.py",
    "tests/link/test_requests.py",
    "tests/link/test_resets.py",
    "tests/link/test_samples_together.py",
    "tests/link/test_subscriptions.py",
]
ONE_FACE = "not (blocking or ftdi or mmio or pipes or serve or trio or zenoh)"
"""Tests of a link run on only one medium and one API."""
LONGEST_TEST = 20.0
"""Longest duration in seconds of a test that is run on mutants."""
MOST_EXAMPLES = 25
"""Number of examples that hypothesis tries in each test."""
FIRST = 25
"""Number of tests that run before all others are considered."""
PATIENCE = 900
"""Seconds after which a mutant counts as hanging."""
MOST_WORK = 300
"""Seconds of processor time after which a mutant counts as hanging."""
MOST_MEMORY = 4 << 30
TOO_MUCH = "it takes too much"
QUIETLY = [
    "--timeout=60",
    "-q",
    "-x",
    "-p",
    "no:cacheprovider",
    "-p",
    "no:xdist",
    "--assert=plain",
    "--hypothesis-seed=0",
]
SURVIVED, KILLED = "survived", "killed"
Timed = dict[str, float]
Reached = dict[str, dict[int, list[str]]]


class _Steady:
    """Makes the search of hypothesis deterministic, without a search for the smallest failing example."""

    @pytest.hookimpl
    def pytest_sessionstart(self) -> None:
        """Configure hypothesis."""
        phases = (Phase.explicit, Phase.generate)
        settings.register_profile(
            "mutants", settings.get_profile("quick"), phases=phases, database=None, max_examples=MOST_EXAMPLES
        )
        settings.load_profile("mutants")


class _Observer(_Steady):
    """Records the duration and the reached lines of each test."""

    def __init__(self, measured: coverage.Coverage) -> None:
        self.seconds: Timed = {}
        self._measured = measured

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> object:
        """Run a test."""
        self._measured.switch_context(item.nodeid)
        began = time.monotonic()
        done = yield
        self.seconds[item.nodeid] = time.monotonic() - began
        return done


def file_of(test: str) -> Path:
    """Return the file or folder of tests."""
    return Path(test.partition("::")[0])


def observe(kept: Path) -> tuple[Timed, Reached]:
    """Return the duration of each test, and the tests that reach each line; results are cached in a file."""
    for library in LIBRARIES:
        importlib.import_module(library)
    if not kept.exists():
        kept.parent.mkdir(parents=True, exist_ok=True)
        process = os.fork()
        if process == 0:
            _observe_here(kept)
        if os.waitpid(process, 0)[1] or not kept.exists():
            raise SystemExit("the tests fail without a mutant: see above")
    seconds, reached = json.loads(kept.read_text())
    return seconds, {module: {int(line): tests for line, tests in lines.items()} for module, lines in reached.items()}


def _observe_here(kept: Path) -> None:
    measured = coverage.Coverage(
        data_file=None, config_file=False, include=[str(ROOT / folder / "*") for folder in FOLDERS]
    )
    measured.start()
    observer = _Observer(measured)
    there = [test for test in TESTS if (ROOT / file_of(test)).exists()]
    code = pytest.main(
        [*QUIETLY, "--timeout=0", "-m", "not slow and not campaign and not rtl", "-k", ONE_FACE, *there],
        plugins=[observer],
    )
    measured.stop()
    if code == pytest.ExitCode.OK:
        data = measured.get_data()
        reached = {module_of(Path(file)): data.contexts_by_lineno(file) for file in data.measured_files()}
        kept.write_text(json.dumps([observer.seconds, reached]))
    os._exit(int(code))


def tests_for(mutant: Mutant, seconds: Timed, reached: Reached, search: float) -> list[str]:
    """Return the tests that reach a mutant, the quickest first.

    If the line is not in a function, these are the tests that reach its module; if no test reaches it, all tests.

    Args:
        mutant: the mutant.
        seconds: duration of each test.
        reached: tests that reach each line.
        search: largest total duration in seconds.
    """
    of_module = reached.get(mutant.module, {})
    lines = range(mutant.line, mutant.last_line + 1) if mutant.is_in_a_function else ()
    of_lines = seconds.keys() & {test for line in lines for test in of_module.get(line, [])}
    of_any_line = seconds.keys() & {test for tests in of_module.values() for test in tests}
    found = of_lines or of_any_line or seconds.keys()
    quick = sorted((seconds[test], test) for test in found if seconds[test] < LONGEST_TEST)
    until = accumulate(taken for taken, _ in quick)
    return [test for (_, test), all_taken in zip(quick, until, strict=True) if all_taken < search or WORLDS in test]


def verdict(mutant: Mutant, tests: Sequence[str]) -> tuple[str, str]:
    """Return the status of a mutant after running tests on it, and the test that killed it."""
    for some in (tests[:FIRST], tests[FIRST:]):
        if some:
            status, by = _run(mutant, some)
            if status != SURVIVED:
                return status, by
    return SURVIVED, ""


def _run(mutant: Mutant, tests: Sequence[str]) -> tuple[str, str]:
    with tempfile.NamedTemporaryFile("r") as noted:
        process = os.fork()
        if process == 0:
            try:
                _run_here(mutant, tests, noted.name)
            finally:
                # Exit even if the mutant raises: only the parent process may continue after the fork.
                os._exit(1)
        deadline = time.monotonic() + PATIENCE
        while os.waitpid(process, os.WNOHANG) == (0, 0):
            if time.monotonic() > deadline or _resident(process) > MOST_MEMORY:
                os.killpg(process, signal.SIGKILL)
                os.waitpid(process, 0)
                return KILLED, TOO_MUCH
            time.sleep(0.02)
        said = noted.read()
    # A process that the system ended, because of its time or memory, has written no result.
    return (SURVIVED, "") if said == "0" else (KILLED, said or TOO_MUCH)


def _resident(process: int) -> int:
    """Return the bytes of memory of a process. A limit of its address space would stop sanitizers in C."""
    pages = int(Path(f"/proc/{process}/statm").read_text().split()[1])
    return pages * resource.getpagesize()


def _run_here(mutant: Mutant, tests: Sequence[str], noted: str) -> None:
    os.setpgid(0, 0)
    resource.setrlimit(resource.RLIMIT_CPU, (MOST_WORK, MOST_WORK))
    nowhere = os.open(os.devnull, os.O_RDWR)
    for stream in (1, 2):
        os.dup2(nowhere, stream)
    sys.meta_path.insert(0, _Mutated(mutant))
    noter = _Noter()
    code = pytest.main([*QUIETLY, *tests], plugins=[noter])
    Path(noted).write_text("0" if code == pytest.ExitCode.OK else noter.failed or f"pytest ends with {code!r}")


class _Noter(_Steady):
    """Records the failing test."""

    def __init__(self) -> None:
        self.failed = ""

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Record a test that failed."""
        if report.failed:
            self.failed = report.nodeid

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        """Record a module of tests that failed to import."""
        if report.failed:
            self.failed = self.failed or f"{report.nodeid or 'collection'} cannot be imported"


class _Mutated(importlib.abc.MetaPathFinder, importlib.abc.SourceLoader):  # type: ignore[misc]  # typeshed separates them
    """Loads one module with a mutation in it."""

    def __init__(self, mutant: Mutant) -> None:
        self._name = ".".join(mutant.path.with_suffix("").parts).removesuffix(".__init__")
        self._path, self._source = str(ROOT / mutant.path), mutant.source().encode()

    def find_spec(
        self, name: str, path: Iterable[str] | None = None, target: ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        """Return the specification of the mutated module, or None for other modules."""
        if name != self._name:
            return None
        return importlib.util.spec_from_file_location(name, self._path, loader=self)

    def get_filename(self, fullname: str) -> str:
        """Return the path of the module."""
        return self._path

    def get_data(self, path: str | bytes) -> bytes:
        """Return the source; there is no compiled file."""
        if path != self._path:
            raise OSError
        return self._source
