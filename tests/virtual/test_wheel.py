"""The package includes the compiled gateware: `rtl:` works from an installed wheel with only a C++ compiler."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = [pytest.mark.rtl, pytest.mark.slow]
ROOT = Path(__file__).resolve().parents[2]
PIP = [sys.executable, "-m", "pip", "--no-input", "--disable-pip-version-check", "--quiet"]
READ = "from unity_link.cli import main; main()"
WHERE = "import unity_link.virtual.rtl as rtl; print(rtl.__file__)"


def run(*command: object, **options: object) -> str:
    arguments = [str(argument) for argument in command]
    result = subprocess.run(arguments, capture_output=True, text=True, check=False, **options)  # type: ignore[call-overload]
    assert result.returncode == 0, result.stderr
    return str(result.stdout)


def test_an_installed_wheel_compiles_and_opens_the_gateware(tmp_path: Path) -> None:
    run(*PIP, "wheel", "--no-deps", "--no-build-isolation", "--no-index", "--wheel-dir", tmp_path, ROOT)
    (wheel,) = tmp_path.glob("*.whl")
    site = tmp_path / "site"
    run(*PIP, "install", "--no-deps", "--no-index", "--target", site, wheel)
    # For a single read, a short compilation matters more than fast code.
    compiler = tmp_path / "compiler"
    compiler.write_text('#!/bin/sh\nexec c++ "$@" -O0\n')
    compiler.chmod(0o755)
    environment = {
        **os.environ,
        "PYTHONPATH": str(site),
        "XDG_CACHE_HOME": str(tmp_path / "cache"),
        "CXX": str(compiler),
    }
    installed = run(sys.executable, "-c", WHERE, env=environment, cwd=tmp_path)
    assert Path(installed).is_relative_to(site)
    answer = run(sys.executable, "-c", READ, "read", "rtl:scara", "0x94", env=environment, cwd=tmp_path)
    assert answer.startswith("0x94  0x")
    assert [path.suffix for path in (tmp_path / "cache" / "unity-link" / "rtl").iterdir()] == [".so"]
