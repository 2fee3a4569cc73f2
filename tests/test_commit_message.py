"""The hook of `make hooks` refuses subjects that CONTRIBUTING.md does not allow."""

import os
import re
import subprocess
from pathlib import Path

import pytest

from support import commit_message
from support.commit_message import ROOT, fault_of, install


@pytest.mark.parametrize(
    "message",
    ["Reject kicks that arrive after disarm", "µ" * 72, "x" * 72 + "\n\n" + "y" * 200, "fixup! " + "x" * 72],
)
def test_a_subject_of_72_characters_or_fewer_is_accepted(message: str) -> None:
    assert fault_of(message) is None


@pytest.mark.parametrize(
    ("message", "words"),
    [
        ("", "is empty"),
        ("\n \n", "is empty"),
        ("x" * 73, "has 73 characters, at most 72: xxx"),
        ("x" * 40 + "\n" + "y" * 40, "has 81 characters.* Leave a blank line after the subject"),
    ],
)
def test_an_empty_or_long_subject_is_refused(message: str, words: str) -> None:
    assert re.search(words, fault_of(message) or "")


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name in [name for name in os.environ if name.startswith("GIT_")]:
        monkeypatch.delenv(name)
    for name in ("GIT_CONFIG_GLOBAL", "GIT_CONFIG_SYSTEM"):
        monkeypatch.setenv(name, os.devnull)
    for name in ("GIT_AUTHOR_NAME", "GIT_AUTHOR_EMAIL", "GIT_COMMITTER_NAME", "GIT_COMMITTER_EMAIL"):
        monkeypatch.setenv(name, "a")
    (tmp_path / "tests/support").mkdir(parents=True)
    script = (ROOT / "tests/support/commit_message.py").read_text(encoding="utf-8")
    (tmp_path / "tests/support/commit_message.py").write_text(script, encoding="utf-8")
    assert git(tmp_path, "init", "-q").returncode == 0
    return tmp_path


def git(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["git", *arguments], cwd=folder, capture_output=True, text=True, check=False)


def test_git_refuses_a_long_subject_once_the_hook_is_installed(repository: Path) -> None:
    assert install(repository) == f"Wrote {repository / '.git/hooks/commit-msg'}."
    assert install(repository).startswith("Wrote ")
    refused = git(repository, "commit", "--allow-empty", "-m", "x" * 73)
    assert refused.returncode == 1
    assert "has 73 characters, at most 72" in refused.stderr
    assert git(repository, "commit", "--allow-empty", "-m", "x" * 72).returncode == 0
    assert git(repository, "worktree", "add", "-q", "other").returncode == 0
    other = repository / "other"
    assert install(other).startswith("Wrote ")
    # A revision without the script, as in this checkout, is not checked.
    assert git(other, "commit", "--allow-empty", "-m", "x" * 73).returncode == 0


def test_a_hook_of_the_user_is_not_overwritten(repository: Path) -> None:
    own = repository / ".git/hooks/commit-msg"
    own.parent.mkdir(exist_ok=True)
    own.write_text("#!/bin/sh\n")
    assert install(repository).startswith(f"{own} is a hook of your own and was not changed: call python3 ")
    assert own.read_text() == "#!/bin/sh\n"


def test_a_folder_of_hooks_of_the_user_is_not_written_to(repository: Path, tmp_path: Path) -> None:
    git(repository, "config", "core.hooksPath", str(tmp_path / "own"))
    assert install(repository).startswith(
        f"core.hooksPath is {tmp_path / 'own'}, so no hook was written: call python3 "
    )
    assert not (tmp_path / "own").exists()


def test_comments_in_the_message_are_not_its_subject(
    repository: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(repository)
    written = repository / "message"
    written.write_text("\n# " + "x" * 80 + "\nAdd a hook\n")
    assert commit_message.main([str(written)]) == 0
    written.write_text("# Please enter the message\n")
    assert commit_message.main([str(written)]) == 1
    assert capsys.readouterr().err == "The subject of the commit is empty: say in one line what changes.\n"
