"""Messages of bridges whose extra is not installed."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from support.bridge_programs import PATIENCE

SPEC = str(Path(__file__).parents[2] / "examples" / "scara.ul")


@pytest.mark.parametrize(
    ("absent", "command", "words"),
    [
        (
            ["starlette"],
            ["live", "sim:scara", SPEC],
            "the page needs a web server, which is not installed: pip install",
        ),
        (["uvicorn"], ["live", "sim:scara", SPEC], "the page needs a web server, which is not installed: pip install"),
        (["cyclonedds"], ["ros2", SPEC, "--link", "unix:/nosuch"], "CycloneDDS is not installed here: pip install"),
        (["cyclonedds", "yaml"], ["ros2", SPEC, "--params", "x.yaml"], "CycloneDDS is not installed here: pip install"),
        (
            ["zenoh"],
            ["zenoh", SPEC, "--link", "sim:scara", "--prefix", "a"],
            "Zenoh is not installed here: pip install",
        ),
        (["zenoh"], ["serve", "zenoh:robot/1", "--tcp", "0"], "Zenoh is not installed here: pip install"),
    ],
    ids=lambda value: "-".join(Path(word).name for word in value) if isinstance(value, list) else "",
)
def test_missing_extra_is_reported_at_once_with_its_name(absent: list[str], command: list[str], words: str) -> None:
    without = f"sys.modules.update(dict.fromkeys({absent}))"
    script = f"import sys; {without}; sys.argv[1:] = {command}; from unity_link.cli import main; main()"

    result = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=PATIENCE, check=False
    )

    assert (result.returncode, result.stdout) == (1, "")
    assert result.stderr.startswith(f"error: {words}")
    assert result.stderr.count("\n") == 1
