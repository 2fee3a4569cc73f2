"""Set up all tests: those of tests/, of gateware/bench/ and of the documents.

- The hypothesis profiles: `quick` (the default) keeps the suite short, `pytest --hypothesis-profile=long` searches a
  hundred times longer. Neither has a deadline, because no test judges a wall-clock time.
- A skipped test has not passed: `--fail-on-skip` is for machines on which everything must run. It accepts only skips of
  tests with the mark `usb`, which need a kernel module that some machines lack and no package provides.
- The documents are tests. The blocks of `python` of one document run in one namespace. In a block of `console`, each
  `$ command` runs and must print the lines below it; `...` matches any text. Blocks that cannot run everywhere (because
  they need a board, or do not end) follow `<!-- skip: next -->`, or are blocks of `shell`.
"""

import logging
import os
import signal
import sys
from collections.abc import Generator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings
from sybil import Example, Sybil
from sybil.parsers.myst import CodeBlockParser, PythonCodeBlockParser, SkipParser
from xdist.remote import Producer
from xdist.scheduler import LoadScopeScheduling

from docs.walkthrough import WALKTHROUGHS, run, typed
from support.searching import QUICK

# A test run in the background of a script ignores Ctrl-C, one started by `nohup` ignores SIGHUP, and the programs that
# tests interrupt would inherit that.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP") and signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:
    signal.signal(signal.SIGHUP, signal.SIG_DFL)

# Tests start Python a thousand times, and each start takes three times as long without bytecode. If the machine forbids
# bytecode beside the sources, store it in another folder.
if os.environ.pop("PYTHONDONTWRITEBYTECODE", ""):
    sys.dont_write_bytecode = False
    sys.pycache_prefix = os.environ["PYTHONPYCACHEPREFIX"] = str(Path(__file__).parent / ".cache" / "bytecode")

# A shell must not offer the commands of tests as completions.
os.environ["UNITY_LINK_MEMORY"] = ""

settings.register_profile("quick", deadline=None, max_examples=QUICK, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("long", settings.get_profile("quick"), max_examples=100 * QUICK)
settings.load_profile("quick")


@pytest.fixture(autouse=True)
def first_ids(monkeypatch: pytest.MonkeyPatch) -> None:
    """Begin the sessions of this process with ID 0, so that tests can name the ID of a request."""
    monkeypatch.setattr("unity_link.link.connection.choose_seed", lambda: 0)


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the option of this file."""
    parser.addoption("--fail-on-skip", action="store_true", help="fail the run if any test is skipped")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Run the slow tests first, and measure no coverage of them.

    A slow test at the end would keep one process busy while the others are idle. Quick tests run the same code as the
    slow
    ones, which coverage would slow down further.
    """
    items.sort(key=lambda item: item.get_closest_marker("slow") is None)
    for item in items:
        if item.get_closest_marker("slow") is not None:
            item.add_marker("no_cover")


class _Scheduler(LoadScopeScheduling):  # type: ignore[misc]  # pytest-xdist has no types
    """Gives each test to an idle process.

    One process gets all blocks of a document, which share names, and all tests of a file that share a build: the first
    test
    compiles a gateware, which other processes would compile as well.
    """

    _TOGETHER = (
        ".md",
        "test_balancer.py",
        "test_cores_on_rtl.py",
        "test_experiment.py",
        "test_gantry.py",
        "test_own_robot.py",
        "test_quick_models_on_rtl.py",
        "test_rclpy_on_rtl.py",
        "test_rtl_of_spec.py",
        "test_schedule_on_rtl.py",
    )

    def _split_scope(self, nodeid: str) -> str:
        file, _, _ = nodeid.partition("::")
        return file if file.endswith(self._TOGETHER) else nodeid


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Producer) -> LoadScopeScheduling | None:
    """Return the scheduler that assigns tests to processes, unless the command line selects another one."""
    return _Scheduler(config, log) if config.getvalue("dist") == "load" else None


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers() -> int:
    """Return the number of processes for `--numprocesses auto`: one more than processors, because many tests wait."""
    return (os.cpu_count() or 1) + 1


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """With --fail-on-skip, report a skip as a failure that gives the reason of the skip."""
    report = yield
    excused = hasattr(report, "wasxfail") or item.get_closest_marker("usb") is not None
    if report.skipped and not excused and item.config.getoption("--fail-on-skip"):
        report.outcome = "failed"
        report.longrepr = f"--fail-on-skip: {report.longrepr}"
    return report


def run_console_block(example: Example) -> None:
    """Run each `$ command` of a block, and compare its output with the lines below it."""
    for command, expected in typed(example.parsed):
        run(command, expected)


def reset_log_levels(namespace: dict[str, object]) -> None:  # noqa: ARG001  (Sybil passes it)
    """Reset the levels of the package's loggers, because later tests of the process read the log."""
    for name in list(logging.root.manager.loggerDict):
        if name.partition(".")[0] == "unity_link":
            logging.getLogger(name).setLevel(logging.NOTSET)


pytest_collect_file = Sybil(
    parsers=[PythonCodeBlockParser(), CodeBlockParser("console", run_console_block), SkipParser()],
    patterns=["README.md", "docs/*.md", "docs/**/*.md"],
    # tests/test_walkthroughs.py follows the walkthroughs, each from an empty folder.
    excludes=["docs/_build/**", *WALKTHROUGHS],
    teardown=reset_log_levels,
).pytest()
