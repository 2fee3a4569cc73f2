"""The manual page, and the output of commands for other programs."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from typer.main import get_group

from unity_link.cli import app, manual
from unity_link.cli.families import FAMILIES

PROGRAM = [sys.executable, "-m", "unity_link"]
ROOT = Path(__file__).parents[2]
SCARA = str(ROOT / "examples" / "scara.ul")


def commands() -> dict[str, Any]:
    """Return all commands, also those in groups, by the words of the command line."""
    found: dict[str, Any] = {}

    def add(command: Any, name: str, above: Any) -> None:
        context = command.context_class(command, info_name=name, parent=above, resilient_parsing=True)
        if hasattr(command, "list_commands"):
            for below in command.list_commands(context):
                add(command.get_command(context, below), f"{name} {below}".strip(), context)
        else:
            found[name] = command

    add(get_group(app), "", None)
    return found


def test_the_manual_page_has_every_command_and_option() -> None:
    page = manual.page().replace("\\-", "-")
    sections = dict(re.findall(r"^\.SS ((?:[a-z0-9]+ )+)[^\n]*\n(.*?)(?=^\.S[SH] )", page, re.MULTILINE | re.DOTALL))
    found = commands()
    assert {name.strip() for name in sections} == set(found)
    assert {name.split()[0] for name in found} == set(FAMILIES)
    for name, command in found.items():
        for parameter in command.params:
            shown = parameter.param_type_name == "option" and not getattr(parameter, "hidden", False)
            for option in parameter.opts if shown else ():
                assert f".B {option}" in sections[f"{name} "] or f", {option}" in sections[f"{name} "], (name, option)


def test_no_text_of_the_manual_page_is_a_request_to_roff() -> None:
    requests = {line.split()[0] for line in manual.page().splitlines() if line.startswith((".", "'"))}
    assert requests == {".TH", ".SH", ".SS", ".TP", ".PP", ".B", ".I"}


PROGRAMS_READ = {name for name in FAMILIES if name not in {"terminal", "retrace", "fmt", "ros1", "ros2", "zenoh"}}
"""Commands whose results are data; the others are for people, print their input in another form, or only run."""


def test_every_command_that_a_program_may_read_has_json() -> None:
    texts = {"import rdl", "export rdl", "ft232h configure"}
    for name, command in commands().items():
        if name.split()[0] in PROGRAMS_READ and name not in texts:
            assert any("--json" in parameter.opts for parameter in command.params), name


def test_written_files_are_listed_as_json(tmp_path: Path) -> None:
    command = [*PROGRAM, "generate", "docs", SCARA, "-o", str(tmp_path), "--json"]
    lines = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    assert sorted(json.loads(line)["file"] for line in lines) == sorted(map(str, tmp_path.iterdir()))


def test_recording_is_described_as_json(tmp_path: Path) -> None:
    output = tmp_path / "run.mcap"
    command = [*PROGRAM, "record", "sim:scara", SCARA, "-o", str(output), "--poll", "20", "--duration", "0.3", "--json"]
    result = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    assert result["file"] == str(output)
    assert (result["bytes"], result["lost"]) == (output.stat().st_size, 0)


@pytest.mark.parametrize("command", [["simulate", "--tcp", "0"], ["serve", "sim:", "--tcp", "0"]], ids=lambda c: c[0])
def test_url_of_a_served_gateway_is_printed_as_json(command: list[str]) -> None:
    with subprocess.Popen([*PROGRAM, *command, "--json"], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert json.loads(process.stdout.readline())["url"].startswith("tcp://127.0.0.1:")
        process.terminate()
