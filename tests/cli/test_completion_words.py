"""Words that a shell completes may be names of files, and zsh evaluates them."""

from pathlib import Path

import pytest

from unity_link.cli.completion import complete_simulated, complete_url


@pytest.mark.parametrize(
    "name", ['a\\\\" ; touch P ; ".ul', "a`touch P`.ul", "a$(touch P).ul", "a\ntouch P.ul", "a'b.ul", "a;b.ul"]
)
def test_no_name_that_a_shell_would_obey_is_completed(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / name).touch()
    (tmp_path / "a b-2.ul").touch()
    monkeypatch.chdir(tmp_path)
    assert complete_simulated("a") == ["a b-2.ul"]


def test_no_url_that_a_shell_would_obey_is_completed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    memory = tmp_path / "urls"
    memory.write_text("tcp://host:1?x=$(touch P)\ntcp://host:7000?timeout=1&crc=1\n")
    monkeypatch.setenv("UNITY_LINK_MEMORY", str(memory))
    assert complete_url("tcp://h") == ["tcp://host:7000?timeout=1&crc=1"]
