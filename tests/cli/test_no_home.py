"""A user without a home, as in a container, can use every command; the files kept for this user are private."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from support.unmeasured import unmeasured_environment
from unity_link.gateware import cache
from unity_link.gateware.cache import ToolMissingError, cache_folder

EXAMPLES = Path(__file__).parents[2] / "examples"
UNKNOWN = """
import os, pwd, sys
def unknown(uid):
    raise KeyError(uid)
pwd.getpwuid = unknown
from unity_link.cli import main
main()
"""
NAMED = ("HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME", "XDG_CONFIG_HOME", "XDG_RUNTIME_DIR", "UNITY_LINK_MEMORY")


def homeless(monkeypatch: pytest.MonkeyPatch, place: Path) -> None:
    for name in NAMED:
        monkeypatch.delenv(name, raising=False)

    def none() -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr(Path, "home", none)
    monkeypatch.setattr(tempfile, "gettempdir", lambda: str(place))


@pytest.mark.parametrize(
    "command",
    [
        "read sim:scara 0",
        "info sim:scara",
        f"get sim:scara {EXAMPLES / 'scara.ul'} j1.cpos",
        f"check {EXAMPLES / 'scara.ul'}",
        f"generate c {EXAMPLES / 'scara.ul'} -o out",
        f"record sim:scara {EXAMPLES / 'scara.ul'} -o run.mcap --duration 0.2",
        "doctor",
    ],
)
def test_each_command_works_without_a_home(command: str, tmp_path: Path) -> None:
    environment = {name: text for name, text in unmeasured_environment().items() if name not in NAMED}
    done = subprocess.run(
        [sys.executable, "-c", UNKNOWN, *command.split()],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
        cwd=tmp_path,
        env=environment | {"TMPDIR": str(tmp_path)},
    )
    assert "Traceback" not in done.stderr
    assert done.returncode == 0 or command == "doctor", done.stderr
    # The command must not create a folder of the name `~` in the working folder.
    assert not (tmp_path / "~").exists()


def test_files_kept_without_a_home_are_private(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    homeless(monkeypatch, tmp_path)
    folder = cache_folder("rtl")
    assert folder == tmp_path / f"unity-link-{os.getuid()}" / "rtl"
    assert folder.parent.stat().st_mode & 0o777 == 0o700
    assert cache_folder("rtl") == folder


@pytest.mark.parametrize("kind", ["open to others", "a link", "a file"])
def test_a_folder_that_another_user_may_have_made_is_refused(
    kind: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    homeless(monkeypatch, tmp_path)
    folder = tmp_path / f"unity-link-{os.getuid()}"
    if kind == "a link":
        (tmp_path / "theirs").mkdir(0o700)
        folder.symlink_to(tmp_path / "theirs")
    elif kind == "a file":
        folder.touch()
    else:
        folder.mkdir()
        folder.chmod(0o777)
    with pytest.raises(ToolMissingError, match=r"other users can write into .*: name a folder for the cache"):
        cache_folder("rtl")


def test_a_home_that_cannot_be_written_is_as_none(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    homeless(monkeypatch, tmp_path)
    (tmp_path / "home").touch()
    monkeypatch.setattr(Path, "home", lambda: tmp_path / "home")
    assert cache.cache_folder() == tmp_path / f"unity-link-{os.getuid()}"
