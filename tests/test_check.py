"""`make check` runs the tests of the changed files, and no others."""

import subprocess
from pathlib import Path

import pytest

from support import check

ROOT = Path(__file__).parent.parent


@pytest.mark.parametrize(
    ("file", "tests"),
    [
        ("unity_link/files.py", {"tests/test_files.py"}),
        ("unity_link/blocking.py", {"tests/test_blocking.py", "tests/test_blocking_reconnection.py"}),
        ("unity_link/pytest_plugin.py", {"tests/test_pytest_plugin.py"}),
        ("unity_link/boards/board.py", {"tests/boards"}),
        ("tests/spec/test_kinds.py", {"tests/spec/test_kinds.py"}),
        ("tests/link/conftest.py", {"tests/link"}),
        (
            "tests/support/counting_device.py",
            {"tests/cli/test_full_screen.py", "tests/data/test_samples.py", "tests/link/test_subscriptions.py"},
        ),
        ("gateware/rtl/base/ul_fifo_sync.vhd", {"gateware/bench/fifo_sync", "gateware/bench/test_lists.py"}),
        ("gateware/cores/encoder/ul_encoder.vhd", {"gateware/cores/encoder", "gateware/bench/test_lists.py"}),
        ("gateware/cores/encoder/core.toml", {"gateware/cores/encoder"}),
        ("gateware/bench/runner.py", {"gateware/bench"}),
        ("gateware/tools/lists.py", {"gateware/bench/test_lists.py"}),
        ("benchmarks/posts.py", {"tests/benchmarks"}),
        ("LICENSE", {"tests/generate/test_vhdl_folder.py"}),
        ("requirements/all.lock", set()),
    ],
)
def test_a_change_of_a_file_runs_its_tests(file: str, tests: set[str]) -> None:
    assert set(check.tests_of([file])) - set(check.ALWAYS) == tests


@pytest.mark.parametrize(
    ("file", "test"),
    [
        ("unity_link/bridges/serve/turns.py", "tests/bridges/test_serve_pace.py"),
        ("unity_link/link/runtimes/timers.py", "tests/link/runtimes/test_synchronisation.py"),
        ("unity_link/protocol/window/retransmission.py", "tests/protocol/window/test_window.py"),
        ("unity_link/virtual/rtl/snooped.py", "tests/virtual/test_retrace.py"),
        ("unity_link/generate/c/layout.py", "tests/generate/test_c.py"),
        ("unity_link/gateware/release.py", "gateware/bench/verilog"),
        ("docs/protocol.md", "tests/test_protocol_document.py"),
        ("docs/tutorials/rover.md", "tests/test_walkthroughs.py"),
        ("examples/scara.ul", "tests/spec/test_language.py"),
    ],
)
def test_the_tests_of_a_part_are_among_those_that_run(file: str, test: str) -> None:
    found = check.tests_of([file])
    assert any(path == test or test.startswith(f"{path}/") for path in found)
    assert not {"tests/bridges", "tests/virtual", "tests/generate", "tests/link", "tests/protocol"} & set(found)


def test_every_package_and_module_has_tests() -> None:
    folders = [path for path in (ROOT / "unity_link").iterdir() if (path / "__init__.py").exists()]
    files = [path for path in (ROOT / "unity_link").glob("*.py") if not path.name.startswith("__")]
    for path in (*folders, *files):
        found = check.tests_of([f"unity_link/{path.name}/x.py" if path in folders else f"unity_link/{path.name}"])
        assert set(found) - set(check.ALWAYS) or path.name == "gateware", path


def test_slow_tests_and_those_of_unchanged_compiled_gateware_are_left_out() -> None:
    assert (
        check.marks_of(["unity_link/protocol/window/window.py"]) == "not slow and not campaign and not usb and not rtl"
    )
    assert check.marks_of(["gateware/rtl/unity_link.vhd"]) == "not slow and not campaign and not usb"


def test_folder_replaces_its_files() -> None:
    found = check.tests_of(["tests/link/conftest.py", "tests/link/test_life.py"])
    assert set(found) - set(check.ALWAYS) == {"tests/link"}


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(check, "ROOT", tmp_path)
    for variable, value in (("GIT_AUTHOR_NAME", "a"), ("GIT_AUTHOR_EMAIL", "a@b"), ("GIT_CONFIG_GLOBAL", "/dev/null")):
        monkeypatch.setenv(variable, value)
        monkeypatch.setenv(variable.replace("AUTHOR", "COMMITTER"), value)
    git(tmp_path, "init", "-q", "-b", "main")
    commit(tmp_path, "first")
    commit(tmp_path, "second")
    return tmp_path


def git(folder: Path, *arguments: str) -> None:
    subprocess.run(["git", *arguments], cwd=folder, check=True)


def commit(folder: Path, name: str) -> None:
    (folder / name).write_text(name)
    git(folder, "add", name)
    git(folder, "commit", "-q", "-m", name)


def test_change_on_main_is_the_last_commit_and_uncommitted_work(repository: Path) -> None:
    (repository / "first").write_text("otherwise")
    (repository / "né w").write_text("")
    assert check.changed_files() == ["first", "né w", "second"]


def test_on_a_branch_all_its_commits_are_the_change_and_none_of_main(repository: Path) -> None:
    git(repository, "checkout", "-q", "-b", "mine")
    commit(repository, "third")
    commit(repository, "fourth")
    git(repository, "checkout", "-q", "main")
    commit(repository, "of another")
    git(repository, "checkout", "-q", "mine")
    assert check.changed_files() == ["fourth", "third"]
    assert check.changed_files("HEAD~") == ["fourth"]
