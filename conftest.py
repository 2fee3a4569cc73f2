"""What every test shares, those of tests/, of gateware/bench/ and of the documents alike.

- The hypothesis profiles: `quick` (the default) keeps the suite short, `pytest --hypothesis-profile=long` searches a
  hundred times longer. Neither has a deadline, since no test judges a wall-clock time.
- A skipped test has not passed: `--fail-on-skip` is for machines on which everything must run. It leaves alone only
  what the mark `usb` says to need a module of the kernel, which no package brings to a machine whose kernel has none.
- The documents are tests. Their blocks of `python` run, those of one document in one namespace. In a block of
  `console`, each `$ command` runs and must print what stands below it, where `...` is any text. What cannot run
  everywhere (it needs a board, or does not end) stands after `<!-- skip: next -->` or in a block of `shell`.
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

# A suite that was started in the background of a script ignores Ctrl-C, one that `nohup` started SIGHUP, and so would
# the programs that it interrupts.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP") and signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:
    signal.signal(signal.SIGHUP, signal.SIG_DFL)

# Tests start Python a thousand times. Without bytecode each start takes three times as long, so where the machine wants
# none beside the sources it is kept elsewhere.
if os.environ.pop("PYTHONDONTWRITEBYTECODE", ""):
    sys.dont_write_bytecode = False
    sys.pycache_prefix = os.environ["PYTHONPYCACHEPREFIX"] = str(Path(__file__).parent / ".cache" / "bytecode")

# The commands that tests run are not those that a shell is to offer.
os.environ["UNITY_LINK_MEMORY"] = ""

settings.register_profile("quick", deadline=None, max_examples=QUICK, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("long", settings.get_profile("quick"), max_examples=100 * QUICK)
settings.load_profile("quick")


@pytest.fixture(autouse=True)
def first_ids(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have the sessions of this process begin with ID 0, so that tests can say which ID a request has."""
    monkeypatch.setattr("unity_link.link.connection.choose_seed", lambda: 0)


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the option of this file."""
    parser.addoption("--fail-on-skip", action="store_true", help="fail the run if any test is skipped")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin with the slow tests, and measure no coverage of them.

    Where tests run in several processes, a slow one at the end would have the others wait. What slow tests do quick
    ones do as well, and coverage would slow them further.
    """
    items.sort(key=lambda item: item.get_closest_marker("slow") is None)
    for item in items:
        if item.get_closest_marker("slow") is not None:
            item.add_marker("no_cover")


class _Scheduler(LoadScopeScheduling):  # type: ignore[misc]  # pytest-xdist has no types
    """Gives each test to the process that is free.

    One process has the blocks of a document, which share names, and tests of a file that share much work: the first of
    them compiles a gateware, which others beside it would compile as well.
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
    """Return what distributes the tests over processes, unless the command line asks for another way."""
    return _Scheduler(config, log) if config.getvalue("dist") == "load" else None


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers() -> int:
    """Return how many processes `--numprocesses auto` has: one more than processors, since many tests wait."""
    return (os.cpu_count() or 1) + 1


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Under --fail-on-skip, turn a skip into a failure that gives the reason of the skip."""
    report = yield
    excused = hasattr(report, "wasxfail") or item.get_closest_marker("usb") is not None
    if report.skipped and not excused and item.config.getoption("--fail-on-skip"):
        report.outcome = "failed"
        report.longrepr = f"--fail-on-skip: {report.longrepr}"
    return report


def run_console_block(example: Example) -> None:
    """Run each `$ command` of a block and compare what it prints with the lines below it."""
    for command, expected in typed(example.parsed):
        run(command, expected)


def reset_log_levels(namespace: dict[str, object]) -> None:  # noqa: ARG001  (Sybil passes it)
    """Set the levels of the package's loggers back, because later tests of the process read the log."""
    for name in list(logging.root.manager.loggerDict):
        if name.partition(".")[0] == "unity_link":
            logging.getLogger(name).setLevel(logging.NOTSET)


pytest_collect_file = Sybil(
    parsers=[PythonCodeBlockParser(), CodeBlockParser("console", run_console_block), SkipParser()],
    patterns=["README.md", "docs/*.md", "docs/**/*.md"],
    # A walkthrough is followed from an empty folder, by tests/test_walkthroughs.py.
    excludes=["docs/_build/**", *WALKTHROUGHS],
    teardown=reset_log_levels,
).pytest()
