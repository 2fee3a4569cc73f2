"""Runs a cocotb bench in GHDL from pytest: the only module that builds and starts simulations.

The sources are analysed once for each entity and state of the gateware (the folder in `gateware/build/` is named after
a hash of them). So a second run starts at once, and outdated sources never run. Generics are set when the simulation
starts, so all configurations share one build.

A bench fails if one of its tests fails, if none ran, or if the simulator printed a warning: about a source, or about an
undriven or undefined signal, which `numeric_std` reports and which would otherwise remain unnoticed.
"""

from __future__ import annotations

import fcntl
import hashlib
import itertools
import os
import re
import shutil
import uuid
from pathlib import Path
from typing import TYPE_CHECKING

from unity_link.gateware.cache import LIBRARY, library_of, sources_for

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

GATEWARE = Path(__file__).resolve().parent.parent
_BUILD = GATEWARE / "build" / "bench"
_STD = "--std=08"
# cocotb uses pytest to explain assertions; pytest's plugins are not needed in a simulation, and take two seconds to
# load. Coverage would double the time, only to measure benches and code that the model's own tests cover.
_INSIDE = {"PYTHONWARNINGS": "error", "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1", "COVERAGE_PROCESS_CONFIG": ""}
_SOURCE_WARNING = r"^.*:\d+:\d+:warning:.*$"
_PICOSECONDS = {"fs": 0.001, "ps": 1, "ns": 10**3, "us": 10**6, "ms": 10**9, "s": 10**12}


class BenchError(AssertionError):
    """A bench failed; the message ends with the last lines of the simulator's output."""


def simulator_available() -> bool:
    """Return whether `ghdl` and cocotb are installed, which every bench needs."""
    try:
        import cocotb  # noqa: F401 - asked for here, so that the module can be imported without it
    except ImportError:
        return False
    return shutil.which("ghdl") is not None


def run_bench(  # noqa: PLR0913 - each says one thing of the run, by its name
    toplevel: str,
    module: str,
    *,
    generics: Mapping[str, object] | None = None,
    extra_sources: Sequence[Path] = (),
    testcase: str | Sequence[str] | None = None,
    seed: int | None = None,
    extra_env: Mapping[str, str] | None = None,
    warnings_allowed: bool = False,
    waves: Path | None = None,
) -> None:
    """Run the cocotb tests of one module on one entity.

    Args:
        toplevel: name of the entity, in lower case.
        module: dotted name of the Python module with the cocotb tests (`gateware.bench.uart.bench_uart`).
        generics: generics of the top entity; booleans may be Python's.
        extra_sources: VHDL files in addition to those of the gateware (a wrapper for the bench), in the library `work`.
        testcase: run only the tests whose names end with this.
        seed: of cocotb's random numbers; by default 1, so that a run can be repeated. The environment variable
            COCOTB_RANDOM_SEED overrides it.
        extra_env: further environment variables that the bench reads.
        warnings_allowed: do not fail on the simulator's warnings; give the reason in a comment at the call.
        waves: a file for the waveform (VCD) of all signals.

    Raises:
        BenchError: if a test fails, none ran, the sources do not analyse, or the simulator warned.
    """
    __tracebackhide__ = True
    from cocotb_tools.check_results import get_results
    from cocotb_tools.runner import get_runner

    libraries = {
        # GHDL determines the order of analysis itself.
        LIBRARY: sources_for(toplevel, extra_sources),
        "work": [Path(source).resolve() for source in extra_sources],
    }
    build_dir = _BUILD / f"{toplevel}-{_hash_of(itertools.chain(*libraries.values()))}"
    run_dir = build_dir / f"run-{uuid.uuid4().hex[:12]}"
    run_dir.mkdir(parents=True)
    # cocotb's use of pytest stops here, and does not load the project's conftest.py, which takes a second.
    if not (_BUILD / "pytest.ini").exists():
        (_BUILD / "pytest.ini").write_text("[pytest]\n")
    log_file, results_file = run_dir / "simulation.log", run_dir / "results.xml"
    runner = get_runner("ghdl")
    try:
        # A lock, because two runs at once could leave the library of one and the index of the other, which GHDL
        # rejects.
        with (build_dir / "lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            _build_once(runner, toplevel, libraries, build_dir)
        runner.test(
            test_module=module,
            hdl_toplevel=toplevel,
            hdl_toplevel_library=library_of(toplevel),
            hdl_toplevel_lang="vhdl",
            build_dir=build_dir,
            test_dir=run_dir,
            results_xml=str(results_file),
            testcase=testcase,
            seed=os.environ.get("COCOTB_RANDOM_SEED", seed if seed is not None else 1),
            test_args=[_STD, f"--workdir={build_dir}", f"-P{build_dir}"],
            plusargs=["--ieee-asserts=disable-at-0", *([f"--vcd={waves}"] if waves else [])],
            parameters={name: _as_vhdl(value) for name, value in (generics or {}).items()},
            extra_env={**_INSIDE, **(extra_env or {})},
            timescale=("1ns", "1ps"),
            log_file=log_file,
        )
        ran, failed = get_results(results_file)
    except (RuntimeError, SystemExit) as error:
        # The runner exits if a test failed; the counts in a results file have more information than the exit.
        if not results_file.exists():
            raise BenchError(f"{toplevel} did not run to its end ({error})\n{_tail(log_file)}") from error
        ran, failed = get_results(results_file)
    if failed or not ran:
        raise BenchError(f"{toplevel} with {dict(generics or {})}: {failed} of {ran} tests failed\n{_tail(log_file)}")
    warned = _warnings(log_file.read_text())
    if warned and not warnings_allowed:
        raise BenchError(f"{toplevel}: the simulator warned {len(warned)} times, first: {warned[0]}")
    shutil.rmtree(run_dir)


def _build_once(runner: object, toplevel: str, libraries: Mapping[str, Sequence[Path]], build_dir: Path) -> None:
    """Analyse the sources unless that was done. Two runs at once both analyse, and one result is kept."""
    # The library of the entity comes last, because only that one is elaborated.
    own = library_of(toplevel)
    names = [name for name in libraries if libraries[name] and name != own] + [own]
    if (build_dir / _index(own)).exists():
        return
    scratch = build_dir / f"build-{uuid.uuid4().hex[:12]}"
    scratch.mkdir()
    for name in names:
        log_file = scratch / f"{name}.log"
        try:
            runner.build(  # type: ignore[attr-defined]
                hdl_library=name,
                sources=list(libraries[name]),
                hdl_toplevel=toplevel if name == own else None,
                build_args=[_STD],
                build_dir=scratch,
                always=True,
                log_file=log_file,
            )
        except RuntimeError as error:
            raise BenchError(f"{toplevel} does not analyse: {error}\n{_tail(log_file)}") from error
        warned = re.findall(_SOURCE_WARNING, log_file.read_text(), re.MULTILINE)
        if warned:
            raise BenchError(f"{toplevel}: the simulator warns of a source: {warned[0]}")
    for name in names:
        (scratch / _index(name)).replace(build_dir / _index(name))
    shutil.rmtree(scratch)


def _index(library: str) -> str:
    """Return the name of GHDL's index file of a library."""
    return f"{library}-obj08.cf"


def _hash_of(sources: Iterable[Path]) -> str:
    """Return a hash of the contents and paths of all sources, as the name of a build."""
    digest = hashlib.sha256()
    for source in sources:
        digest.update(str(source).encode() + b"\0" + source.read_bytes() + b"\0")
    return digest.hexdigest()[:12]


def _as_vhdl(value: object) -> object:
    """Format the value of a generic for GHDL's option `-g`."""
    return str(value).lower() if isinstance(value, bool) else value


def _warnings(log: str) -> list[str]:
    """Return the simulator's warnings: about sources, and about undefined signals after the end of the first reset."""
    reset_ended = re.search(r"reset ended at (\d+) ps", log)
    first_ps = int(reset_ended[1]) if reset_ended else 0
    found = re.finditer(r"^.*:@(\d+)([fpnum]?s):\((?:assertion|report) (?:warning|error)\).*$", log, re.MULTILINE)
    late = [match[0] for match in found if int(match[1]) * _PICOSECONDS[match[2]] >= first_ps]
    return re.findall(_SOURCE_WARNING, log, re.MULTILINE) + late


def _tail(log_file: Path, lines: int = 20) -> str:
    """Return the end of a log for an error text."""
    if not log_file.exists():
        return "(no output)"
    text = log_file.read_text(errors="replace").splitlines()
    failures = [line for line in text if re.search(r"failed|failure|Error", line)]
    return "\n".join([f"{log_file}:", *failures[:lines], "...", *text[-lines:]])
