"""Signals to a command: the first ends it, further signals at once count as one, a later signal kills it."""

from __future__ import annotations

import signal
import subprocess
import sys
import textwrap
import time

import pytest

from unity_link.cli.running import INTERRUPTED, PATIENCE, SIGNALS

PROGRAM = """
    import asyncio, time, typer
    from unity_link.cli.running import run

    async def command():
        print("began", flush=True)
        try:
            await asyncio.sleep(3600)
        finally:
            print("ends", flush=True)
            {end}
            print("summary", flush=True)

    try:
        run(command())
    except typer.Exit as ended:
        raise SystemExit(ended.exit_code)
"""


def running(end: str) -> subprocess.Popen[str]:
    program = textwrap.dedent(PROGRAM).format(end=end)
    process = subprocess.Popen(
        [sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "began\n"
    return process


@pytest.mark.parametrize("second", SIGNALS)
def test_two_signals_at_once_end_a_command_as_one_does(second: signal.Signals) -> None:
    with running("await asyncio.sleep(0.2)") as process:
        assert process.stdout is not None
        process.send_signal(signal.SIGINT)
        assert process.stdout.readline() == "ends\n"
        process.send_signal(second)
        said, errors = process.communicate()
    assert (said, errors, process.returncode) == ("summary\n", "", INTERRUPTED)


@pytest.mark.parametrize("hanging", ["await asyncio.sleep(3600)", "time.sleep(3600)"])
def test_a_command_that_hangs_at_its_end_is_ended_by_a_later_signal(hanging: str) -> None:
    with running(hanging) as process:
        assert process.stdout is not None
        process.send_signal(signal.SIGTERM)
        assert process.stdout.readline() == "ends\n"
        time.sleep(1.2 * PATIENCE)
        process.send_signal(signal.SIGINT)
        said, errors = process.communicate()
    assert (said, errors, process.returncode) == ("", "", -signal.SIGINT)


LOADING = """
    import os, signal, sys

    class Interrupting:
        def find_spec(self, name, path=None, target=None):
            if name == "unity_link.cli.families":
                os.kill(os.getpid(), signal.SIGINT)

    sys.argv = ["/usr/bin/unity-link", "info", "sim:"]
    sys.meta_path.insert(0, Interrupting())
    from unity_link.cli import main
    main()
"""


def test_ctrl_c_while_a_command_is_being_loaded_ends_it_without_a_word() -> None:
    program = [sys.executable, "-c", textwrap.dedent(LOADING)]
    done = subprocess.run(program, capture_output=True, text=True, check=False, timeout=60)
    assert (done.stdout, done.stderr, done.returncode) == ("", "", -signal.SIGINT)
