"""External tools and temporary folders end with their program; incomplete files of the cache are made again."""

from __future__ import annotations

import os
import select
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path
from types import SimpleNamespace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from support.bridge_programs import PROGRAM
from unity_link.gateware import cache, ghdl
from unity_link.gateware.convert import to_verilog
from unity_link.gateware.external import FolderError, run, running, temporary_folder

SPEC = 'public blinking() { @lamp = 0x30[0]: bool READWRITE(PIN="led0"); }'


def test_a_tool_has_its_temporary_files_in_the_folder_and_no_input() -> None:
    with temporary_folder() as folder:
        done = run(["sh", "-c", "cat; echo $TMPDIR; echo $OTHER >&2; exit 3"], folder, environment={"OTHER": "é"})
        assert (done.returncode, done.stdout, done.stderr) == (3, f"{folder}\n", "é\n")
        (folder / "a name with\nspaces" / "below").mkdir(parents=True)
    assert not folder.exists()


def test_a_folder_is_removed_while_a_tool_still_makes_files_in_it() -> None:
    script = "while :; do : > $TMPDIR/$((n+=1)); done"
    with temporary_folder() as folder, running(["sh", "-c", script], folder, stderr=subprocess.DEVNULL):
        while len(list(folder.iterdir())) < 3:
            pass
    assert not folder.exists()


HOLDING = """
    import sys
    from pathlib import Path
    from unity_link.gateware.external import running, temporary_folder

    with temporary_folder() as folder:
        # The inner process holds the FIFO open for as long as it lives.
        script = 'touch $TMPDIR/file; sh -c "exec 3>$1; echo $TMPDIR >&3; sleep 1000"; true'
        with running(["sh", "-c", script, "sh", sys.argv[1]], folder) as process:
            process.wait()
"""


@pytest.mark.parametrize("way", ["SIGINT", "SIGTERM", "SIGHUP", "SIGKILL"])
def test_neither_tools_nor_folders_outlive_a_program_that_a_signal_ends(way: str, tmp_path: Path) -> None:
    fifo = tmp_path / "fifo"
    os.mkfifo(fifo)
    watch = os.open(fifo, os.O_RDONLY | os.O_NONBLOCK)
    command = [sys.executable, "-c", textwrap.dedent(HOLDING), str(fifo)]
    with subprocess.Popen(command, stderr=subprocess.DEVNULL) as program:
        select.select([watch], [], [], 60)
        folder = Path(os.read(watch, 4096).decode().strip())
        assert (folder / "file").exists()
        program.send_signal(signal.Signals[way])
        assert program.wait() != 0
    # Wait with a time-out: the pipe ends only when no process is left that has it open.
    assert select.select([watch], [], [], 60)[0]
    assert os.read(watch, 1) == b""
    os.close(watch)
    deadline = time.monotonic() + 60
    while folder.exists() and time.monotonic() < deadline:
        time.sleep(0.01)
    assert not folder.exists()


def test_a_folder_that_cannot_be_made_is_named_with_its_variable(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    gone = tmp_path / "gone"
    monkeypatch.setattr("tempfile.tempdir", str(gone))
    for parent, variable in ((None, "TMPDIR"), (gone, "XDG_CACHE_HOME")):
        words = rf"{gone} can't hold temporary files \(No such file or directory\): name another folder in {variable}"
        with pytest.raises(FolderError, match=words), temporary_folder(parent):
            pass


def test_an_error_about_a_file_elsewhere_is_not_one_of_the_folder(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError), temporary_folder():
        (tmp_path / "gone").read_bytes()


def limited(folder: Path, blocks: int, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Run a command whose files may have at most `blocks` blocks of 512 bytes, as on a full disk."""
    (folder / "blinking.ul").write_text(SPEC)
    environment = {**os.environ, "XDG_CACHE_HOME": str(folder / "cache"), "TMPDIR": str(folder)}
    limit = ["sh", "-c", f'ulimit -f {blocks}; exec "$@"', "sh"]
    return subprocess.run(
        [*limit, PROGRAM, *arguments], env=environment, cwd=folder, capture_output=True, text=True, check=False
    )


@pytest.mark.parametrize("blocks", [0, *(pytest.param(blocks, marks=pytest.mark.slow) for blocks in (8, 64))])
@pytest.mark.parametrize(
    "command",
    [
        ["get", "rtl:blinking.ul", "blinking.ul"],
        ["generate", "verilog", "blinking.ul", "-o", "made"],
        ["build", "blinking.ul", "--board", "hx8k_breakout", "-o", "made"],
    ],
    ids=["rtl", "generate", "build"],
)
def test_a_full_disk_is_one_sentence(command: list[str], blocks: int, tmp_path: Path) -> None:
    tools = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache"), "unity-link", "tools")
    if tools.exists():
        (tmp_path / "cache" / "unity-link").mkdir(parents=True)
        (tmp_path / "cache" / "unity-link" / "tools").symlink_to(tools)
    done = limited(tmp_path, blocks, *command)
    assert done.returncode in (1, 2)
    assert "Traceback" not in done.stderr
    assert "standard output" not in done.stderr
    assert len([line for line in done.stderr.splitlines() if line.startswith("error: ")]) == 1
    assert not (tmp_path / "made").exists()
    assert not list(tmp_path.glob("unity-link-*"))


@given(data=st.binary())
def test_sealed_data_are_whole_and_cut_or_changed_data_are_not(
    tmp_path_factory: pytest.TempPathFactory, data: bytes
) -> None:
    path = tmp_path_factory.mktemp("sealed") / "file"
    assert not cache.is_whole(path)
    sealed = cache.sealed(data)
    path.write_bytes(sealed)
    assert cache.is_whole(path)
    for damaged in (sealed[:-1], sealed[: len(sealed) // 2], b"", b"\0" * 16, sealed.replace(sealed[:1], b"?", 1)):
        path.write_bytes(damaged)
        assert not cache.is_whole(path) or damaged == sealed


def test_incomplete_text_in_the_cache_is_made_again(tmp_path: Path) -> None:
    path = tmp_path / "netlist.json"
    assert cache.kept(path, lambda: "{}") == "{}"
    assert cache.kept(path, lambda: "another") == "{}"
    (file,) = tmp_path.iterdir()
    file.write_bytes(file.read_bytes()[:1])
    assert cache.kept(path, lambda: "another") == "another"


def test_incomplete_verilog_in_the_cache_is_converted_again(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    tools = cache.cache_folder("tools")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    (tmp_path / "unity-link").mkdir()
    (tmp_path / "unity-link" / "tools").symlink_to(tools)
    path = to_verilog("ul_synchroniser")
    whole = path.read_bytes()
    path.write_bytes(whole[: len(whole) // 2])
    assert to_verilog("ul_synchroniser").read_bytes() == whole


def test_full_disk_while_ghdl_is_downloaded_is_reported_as_such(tmp_path: Path) -> None:
    script = (
        "echo 'Err:1 x Error writing to file - write (28: No space left on device)'; echo 'E: Some index files' >&2"
    )
    with pytest.raises(
        cache.ToolMissingError, match=r"fetching Debian trixie's failed: Err:1 .*No space left on device"
    ):
        ghdl._call(["sh", "-c", f"{script}; exit 100"], tmp_path)


def test_full_disk_for_the_package_lists_of_ghdl_is_reported(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    work = tmp_path / "work"
    work.mkdir()
    monkeypatch.setattr("shutil.disk_usage", lambda _: SimpleNamespace(free=57_344))
    script = "echo \"E: The repository 'http://deb.debian.org/debian trixie InRelease' is not signed.\" >&2; exit 100"
    with pytest.raises(cache.ToolMissingError, match=rf"{tmp_path} has 57,344 bytes left \(E: The repository"):
        ghdl._call(["sh", "-c", script], work)
