"""Commands never replace files that Unity-Link did not make, unless the user allows it."""

from __future__ import annotations

import os
import pty
import re
import secrets
import shutil
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from typer.testing import CliRunner

from support.recordings import record
from unity_link.cli import app
from unity_link.errors import ArgumentError
from unity_link.files import LIST, MARK, Writing, has_mark, is_marked, write_file, write_files, write_texts

if TYPE_CHECKING:
    from collections.abc import Callable

PROGRAM = str(Path(sys.executable).with_name("unity-link"))
EXAMPLES = Path(__file__).parents[1] / "examples"
ROVER = "public rover() { @duty = 1: signed 12 READWRITE(); }\n"
RDL = "addrmap rover { reg { field { sw = rw; hw = r; } duty[11:0]; } duty @ 0x4; };\n"
MINE = b"# my own model, not in git\n"
OURS = f"# {MARK} generate x` from rover.ul\nold\n".encode()
COMMANDS = {
    "generate python": "generate python rover.ul",
    "generate docs": "generate docs rover.ul",
    "generate c": "generate c rover.ul",
    "generate cpp": "generate cpp rover.ul",
    "generate vhdl": "generate vhdl rover.ul",
    "generate with the gateware": "generate vhdl rover.ul --with-gateware",
    "generate matlab": "generate matlab rover.ul",
    "generate ros1": "generate ros1 rover.ul",
    "generate ros2": "generate ros2 rover.ul",
    "build a project": "build rover.ul --board arty_a7",
    "gateware copy": "gateware copy copy",
    "export rdl": "export rdl rover.ul -o rover.out",
    "import rdl": "import rdl rover.rdl -o imported.ul",
    "export csv": "export run.mcap --csv",
    "export parquet": "export run.mcap --parquet",
}


def said_by(words: str) -> tuple[str, str]:
    """Run a command in this process; return the text of its error, and the name of the error's class."""
    result = CliRunner().invoke(app, words.split())
    error = result.exception
    return (str(error), type(error).__name__) if error and not isinstance(error, SystemExit) else ("", "")


def contents() -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in sorted(Path().rglob("*")) if path.is_file()}


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("recorded") / "run.mcap"
    record(path, lambda recorder: recorder.samples > 0)
    return path


@pytest.fixture
def here(tmp_path: Path, recorded: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Create the input files of commands in a folder, and change to that folder."""
    (tmp_path / "rover.ul").write_text(ROVER)
    (tmp_path / "rover.rdl").write_text(RDL)
    shutil.copy(recorded, tmp_path / "run.mcap")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.slow
@pytest.mark.parametrize("command", COMMANDS.values(), ids=COMMANDS)
def test_command_replaces_its_own_files_and_no_other(command: str, here: Path) -> None:
    given = contents()
    assert said_by(command) == ("", "")
    made = contents()
    assert said_by(command) == ("", "")
    assert contents().keys() == made.keys()

    mine = next(path for path in made if path not in given and made[path])
    mine.write_bytes(MINE)
    before = contents()
    words, kind = said_by(command)
    assert (words, kind) == (
        f"{mine} is there, and Unity-Link did not make it: write elsewhere, or replace by --overwrite",
        "ArgumentError",
    )
    assert contents() == before

    assert said_by(f"{command} --overwrite") == ("", "")
    assert contents().keys() == made.keys()
    assert mine.read_bytes() != MINE
    assert here.is_dir()


def test_the_model_beside_a_spec_survives_each_target(here: Path) -> None:
    for name in ("rover.py", "rover.md", "rover.c", "rover_map.vhd", "run.state.csv"):
        Path(name).write_bytes(MINE)
    before = contents()

    for command in ("generate python", "generate docs", "generate c", "generate vhdl"):
        assert " is there, and Unity-Link did not make it: " in said_by(f"{command} rover.ul")[0]
    assert " is there, and Unity-Link did not make it: " in said_by("export run.mcap --csv")[0]

    assert contents() == before
    assert here.is_dir()


def test_several_existing_files_are_reported_together(here: Path) -> None:
    for name in ("rover.h", "rover.c", "unity_link.h", "unity_link.c", "unity_link_posix.c"):
        Path(name).write_bytes(MINE)

    assert said_by("generate c rover.ul")[0] == (
        "rover.h, rover.c, unity_link.h and 2 more are there, and Unity-Link did not make them: "
        "write elsewhere, or replace by --overwrite"
    )
    assert here.is_dir()


def test_files_generated_from_another_spec_are_replaced(here: Path) -> None:
    said_by("generate c rover.ul")
    Path("rover.ul").write_text(ROVER.replace("= 1", "= 2"))
    before = contents()

    assert said_by("generate c rover.ul") == ("", "")

    assert contents()[Path("rover.h")] != before[Path("rover.h")]
    assert here.is_dir()


@pytest.mark.slow
@pytest.mark.parametrize(("answer", "replaced"), [("y", True), ("n", False), ("", False)])
def test_user_at_a_terminal_is_asked_before_a_file_is_replaced(answer: str, *, replaced: bool, here: Path) -> None:
    Path("rover.py").write_bytes(MINE)
    keyboard, screen = pty.openpty()
    os.write(keyboard, f"{answer}\n".encode())
    with os.fdopen(screen, "rb") as terminal:
        done = subprocess.run(
            [PROGRAM, "generate", "python", "rover.ul"],
            stdin=terminal,
            stdout=subprocess.PIPE,
            stderr=terminal,
            timeout=60,
            check=False,
        )
        said = os.read(keyboard, 65536).decode()
    os.close(keyboard)

    assert "rover.py is there, and Unity-Link did not make it. Replace? [y/N]" in said
    assert (done.returncode, Path("rover.py").read_bytes() != MINE) == ((0, True) if replaced else (2, False))
    assert here.is_dir()


# Files that may be replaced


@pytest.mark.parametrize(
    ("content", "goes"),
    [
        (b"", True),
        (OURS, True),
        (b'#!/usr/bin/env python3\n"""What it does."""\n' + OURS, True),
        (b"<?xml version='1.0'?>\r\n<!-- " + OURS[2:].replace(b"\n", b"\r\n"), True),
        (MINE, False),
        (b"new", True),
        (b"\n" * 5 + OURS, False),
        (b"# What is Generated by `unity-link generate c` stays out of git.\n", False),
        (b"\xff\x00\x1b" * 5000, False),
    ],
)
def test_own_file_is_recognised_by_its_mark_or_by_equal_contents(content: bytes, *, goes: bool, tmp_path: Path) -> None:
    path = tmp_path / "x"
    path.write_bytes(content)

    if goes:
        write_file(path, b"new")
    else:
        with pytest.raises(ArgumentError, match="x is there, and Unity-Link did not make it"):
            write_file(path, b"new")

    assert path.read_bytes() == (b"new" if goes else content)
    assert list(tmp_path.iterdir()) == [path]


def test_a_file_that_cannot_be_read_stays(tmp_path: Path) -> None:
    path = tmp_path / "x"
    path.write_bytes(OURS)

    def known(_: Path) -> bool:
        raise PermissionError(13, "Permission denied")

    with pytest.raises(ArgumentError, match="x is there, and Unity-Link did not make it"):
        write_file(path, b"new", known=known)

    assert path.read_bytes() == OURS


def test_file_without_a_mark_is_recognised_by_the_list_until_it_changes(tmp_path: Path) -> None:
    write_texts({"a.vhd": "one\n", "b/c.f": "two\n", "d.py": OURS.decode()}, tmp_path)
    done = subprocess.run(["sha256sum", "-c", LIST], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.splitlines() == ["a.vhd: OK", "b/c.f: OK"]

    # Write other contents, as a later version would.
    write_texts({"a.vhd": "three\n", "b/c.f": "two\n"}, tmp_path)
    assert (tmp_path / "a.vhd").read_text() == "three\n"

    (tmp_path / "b" / "c.f").write_text("mended by hand\n")
    with pytest.raises(ArgumentError, match=r"c\.f is there, and Unity-Link did not make it"):
        write_texts({"a.vhd": "four\n", "b/c.f": "five\n"}, tmp_path)
    assert [(tmp_path / name).read_text() for name in ("a.vhd", "b/c.f")] == ["three\n", "mended by hand\n"]


def test_list_without_its_mark_identifies_no_file_as_ours(tmp_path: Path) -> None:
    write_texts({"a.vhd": "one\n"}, tmp_path)
    (tmp_path / LIST).write_text("\n".join((tmp_path / LIST).read_text().splitlines()[1:]))

    with pytest.raises(ArgumentError, match=r"a\.vhd and .* are there, and Unity-Link did not make them"):
        write_texts({"a.vhd": "two\n"}, tmp_path)


def test_file_that_appears_during_writing_is_kept(tmp_path: Path) -> None:
    path = tmp_path / "x"

    def write() -> None:
        with Writing() as writing:
            writing.open(path).close()
            path.write_bytes(MINE)

    with pytest.raises(ArgumentError, match="x is there, and Unity-Link did not make it"):
        write()

    assert path.read_bytes() == MINE
    assert list(tmp_path.iterdir()) == [path]


def test_no_file_is_written_if_one_of_several_cannot_be_renamed(tmp_path: Path) -> None:
    def write() -> None:
        with Writing(overwrite=True) as writing:
            (tmp_path / "b").write_bytes(MINE)
            for name in ("a", "b"):
                writing.open(tmp_path / name).close()
            (tmp_path / "b").unlink()
            (tmp_path / "b").mkdir()

    with pytest.raises(OSError, match="Is a directory"):
        write()

    assert [path.name for path in tmp_path.iterdir()] == ["b"]


@pytest.mark.parametrize(
    "command", ["generate python rover.ul -o robot.py", "generate c rover.ul -o rover.h", "gateware copy top.vhd"]
)
def test_the_name_of_a_file_is_not_taken_for_that_of_a_folder(command: str, here: Path) -> None:
    before = contents()
    assert (
        said_by(command)[0]
        == f"{command.rsplit(maxsplit=1)[-1]} is named like a file: the name of a folder was expected"
    )
    assert contents() == before
    assert here.is_dir()


# Links, devices and modes


def test_a_link_stays_and_the_file_at_its_end_is_replaced(tmp_path: Path) -> None:
    (tmp_path / "kept").mkdir()
    target, link = tmp_path / "kept" / "rover.py", tmp_path / "rover.py"
    target.write_bytes(OURS)
    link.symlink_to("kept/rover.py")

    write_file(link, b"new")

    assert link.readlink() == Path("kept/rover.py")
    assert target.read_bytes() == b"new"
    assert [path.name for path in (tmp_path / "kept").iterdir()] == ["rover.py"]


@pytest.mark.parametrize("content", [MINE, None], ids=["to a file", "to nothing"])
def test_symbolic_link_to_a_users_file_is_refused(content: bytes | None, tmp_path: Path) -> None:
    target, link = tmp_path / "mine", tmp_path / "rover.py"
    if content is not None:
        target.write_bytes(content)
    link.symlink_to(target)

    with pytest.raises(ArgumentError) as refused:
        write_files({link: b"new"})

    assert str(refused.value).startswith(f"{link}, a link to {target}, is there, and Unity-Link did not make it: ")
    assert target.exists() == (content is not None)
    assert link.is_symlink()

    write_files({link: b"new"}, overwrite=True)
    assert (link.is_symlink(), target.read_bytes()) == (True, b"new")


def test_a_link_at_the_temporary_name_is_not_written_through(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(secrets, "token_hex", lambda _: "known")
    mine = tmp_path / "mine"
    mine.write_bytes(MINE)
    (tmp_path / ".unity-link-known").symlink_to(mine)

    with pytest.raises(ArgumentError, match="x cannot be written: File exists"):
        write_file(tmp_path / "x", b"new")

    assert mine.read_bytes() == MINE
    assert not (tmp_path / "x").exists()


def test_temporary_names_cannot_be_predicted(tmp_path: Path) -> None:
    names = set()
    for _ in range(2):
        with Writing() as writing:
            names.add(writing.part_of(tmp_path / "x"))
    assert len(names) == 2
    assert not any(str(os.getpid()) in re.sub("[0-9a-f]{16}", "", name.name) for name in names)


def test_a_device_is_written_to(tmp_path: Path) -> None:
    write_file(Path(os.devnull), b"new")
    with pytest.raises(ArgumentError, match=r"^/dev/full cannot be written: No space left on device$"):
        write_file(Path("/dev/full"), b"new")
    os.mkfifo(tmp_path / "pipe")

    with pytest.raises(ArgumentError, match="pipe is there, and Unity-Link did not make it"):
        write_files({tmp_path / "pipe": b"new"})


def test_the_mode_of_a_file_and_that_of_a_new_one_are_as_the_user_wants_them(tmp_path: Path) -> None:
    old, new = tmp_path / "old", tmp_path / "new"
    old.write_bytes(OURS)
    old.chmod(0o640)
    mask = os.umask(0o027)
    try:
        write_files({old: b"x", new: b"x"})
    finally:
        os.umask(mask)
    assert [path.stat().st_mode & 0o777 for path in (old, new)] == [0o640, 0o640]


@pytest.mark.parametrize("interrupt", [KeyboardInterrupt, OSError])
def test_interrupted_writing_leaves_nothing(interrupt: Callable[[], BaseException], tmp_path: Path) -> None:
    def stopped() -> None:
        with Writing() as writing:
            writing.open(tmp_path / "new" / "folder" / "x").close()
            raise interrupt()

    with pytest.raises(BaseException, match=r"^$"):
        stopped()

    assert list(tmp_path.iterdir()) == []


def test_each_example_is_a_users_file() -> None:
    # A command may replace files that it has made, so no example may carry the mark of a generated file.
    assert not any(has_mark(path) for path in EXAMPLES.iterdir() if path.is_file())
    assert not is_marked((EXAMPLES.parent / "README.md").read_bytes())
