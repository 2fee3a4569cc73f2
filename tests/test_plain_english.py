"""The check of prose finds phrases in every kind of file, and compares each folder with its limit."""

import re
import subprocess
from pathlib import Path

import pytest

from support.plain_english import (
    ROOT,
    TABLE,
    above,
    at_merge_base,
    long_names,
    lowered,
    questions,
    raised,
    read_rules,
    too_many,
)
from support.prose import pieces_of
from support.suppressions import suppressions

TEXT = (ROOT / TABLE).read_text(encoding="utf-8")
RULES = read_rules(TEXT)
SMALL = (
    re.sub(r"long_test_names = \d+", "long_test_names = 9", TEXT.partition("[ceilings]")[0])
    + '[ceilings]\n"." = 9.0\n"a" = 500.0\n"a/b" = 500.0\n'
    + TEXT[TEXT.index("[[ph") :]
)
"""A table of limits for two folders and the files outside of them."""


@pytest.mark.parametrize(
    ("name", "source", "prose"),
    [
        ("a.py", '"""Doc."""\nx = 1  # one\n# two,\n# three\ny = "# no"\n"""Attr."""\n', "one two, three|Doc.|Attr."),
        ("a.py", "def f():\n    '''Doc.'''\n    g('''no''', \"no # no\")\n", "Doc."),
        ("a.py", "try:\n    f()\nexcept E:\n    raise E(f'{x} is ' 'bad') from None\n", "x is bad"),
        ("a.py.jinja", '{# tpl #}\n{% if a %}\n"""Doc."""\n{% endif %}\nb = {{ c }}  # one\n', "tpl|Doc.|one"),
        ("a.py.jinja", 'raise E("bad " "{{ x }}")\nf("no")\n', "bad x"),
        ("generate/python/module.jinja", "# {{ a }}\n# one\n", "x one"),
        ("a.vhd", "-- one\n-- two\na <= '-' & \"-- no\"; -- three\n", "one two|three"),
        ("a.vhd.jinja", "{% for a in b %}\n-- {{ a }} one\n", "x one"),
        ("a.sv", "a = 8'hFF; // one\n/* two\n * three */ $display(\"// no\");\n", "one|two three"),
        ("a.c", "char *a = \"// no\"; /* one */ b = '\"'; // two\n", "one|two"),
        ("a.h.jinja", "/** One. */ {{ '//' }} int b;\n", "One."),
        ("a.js", "a = `http://no`; // one\n", "one"),
        ("a.m", "a = b' * c'; % one\nprintf('% no');\n%% two\n", "one|two"),
        ("a.m.jinja", "{% if a %}\nx = 1; % one\n", "one"),
        ("a.ul", "/// One.\nSIGNAL a(BASE=0); // two\n", "One.|two"),
        ("a.toml", 'a = "# no" # one\nb = 1\n# two\n', "one|two"),
        ("Makefile", 'all: ## one\n\techo "# no" a#no ${#b}\n# two\n', "one|two"),
        ("a.mk", "# one\n", "one"),
        ("a.sh", "echo $# # one\n", "one"),
        ("a.xdc", "# one\nset_property A 1\n", "one"),
        ("a.lark", 'a: "//" // one\n', "one"),
        ("a.md", "# Head\n\nOne\ntwo.\n- three\n\n```c\n// no\n```\n<!-- no -->\n| b |\n", "Head|One two.|three|b"),
        ("a.bin", "# no\n", ""),
    ],
)  # fmt: skip
def test_prose_of_each_kind_of_file_is_found_and_code_is_not(
    tmp_path: Path, name: str, source: str, prose: str
) -> None:
    path = tmp_path / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(source)
    assert "|".join(piece.text for piece in pieces_of(path)) == prose


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("Where it fails, stop.", ["where for if"]),
        ("Stop: where it fails.", ["where for if"]),
        ("The place where it fails.", []),
        ("Set where\npossible.", []),
        ("Keep what\nis kept.", ["what as a noun"]),
        ("What kind?", []),
        ("Whoever has it.", ["who for a thing"]),
        ("It is told.", ["tell, told"]),
        ("All behind the\nlast.", ["behind for after"]),
        ("The robot behind the gateway.", []),
        ("Nothing waits.", ["nobody, nothing"]),
        ("It stands for a stranger. Else none.", ["stands", "fate, loser, stranger", "inverted else"]),
        ("- Where it fails\n- a standard", ["where for if"]),
    ],
)
def test_a_phrase_is_found_across_lines(tmp_path: Path, text: str, names: list[str]) -> None:
    path = tmp_path / "a.md"
    path.write_text(text)
    assert [found.name for found in RULES.found_in(path)] == names


def test_every_phrase_has_a_reason_of_one_line() -> None:
    assert len(RULES.reasons) == TEXT.count("[[phrases]]")
    assert all(reason and "\n" not in reason for reason in RULES.reasons.values())


def test_a_folder_above_its_limit_fails_and_names_its_worst_files(tmp_path: Path) -> None:
    words = "word " * 96
    for name, text in {
        "a/b/c.md": "It stands. ",
        "a/d.md": "It stands. ",
        "a/e.md": "None. ",
        "f.md": "None. ",
    }.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text + words)
    rules = read_rules(SMALL)
    folders = rules.count(tmp_path.rglob("*.md"), tmp_path)
    assert {name: (folder.words, folder.phrases) for name, folder in folders.items()} == {
        ".": (97, {}),
        "a": (195, {"a/d.md": 1}),
        "a/b": (98, {"a/b/c.md": 1}),
    }
    assert list(above(folders, rules)) == []
    rules.ceilings["a"] = 5.1
    assert list(above(folders, rules)) == [
        "a: 5.13 phrases per 1,000 words, at most 5.1; most of them in",
        "       1 a/d.md",
    ]
    rules.ceilings["a"] = 5.2
    assert list(above(folders, rules)) == []
    table = SMALL.replace(f"long_test_names = {rules.long_test_names}", "long_test_names = 10")
    fewer = {"Any": 1, "noqa": 10**6, "type: ignore": 2}
    lower = read_rules(lowered(table, folders, 3, fewer))
    assert lower.ceilings == {".": 0.0, "a": 5.2, "a/b": 10.3}
    assert lower.long_test_names == 3
    assert lower.suppressions == {"Any": 1, "noqa": rules.suppressions["noqa"], "type: ignore": 2}


def test_a_limit_that_rises_fails_and_one_that_falls_does_not() -> None:
    higher = read_rules(SMALL.replace('"a" = 500.0', '"a" = 500.1').replace('"." = 9.0', '"." = 8.0'))
    assert list(raised(higher, read_rules(SMALL))) == [
        f"{TABLE}: the ceiling of a is 500.1, and was 500.0; it may only fall"
    ]
    longer = read_rules(SMALL.replace("longest_test_name = 72", "longest_test_name = 73"))
    assert list(raised(longer, read_rules(SMALL))) == [
        f"{TABLE}: longest_test_name is 73, and was 72; it may only fall"
    ]
    assert list(raised(read_rules(SMALL), longer)) == []
    freer = read_rules(SMALL)
    freer.suppressions["noqa"] = 1000
    (sentence,) = raised(freer, read_rules(SMALL))
    assert sentence.startswith(f"{TABLE}: noqa is 1000, and was ")


def test_limits_are_compared_with_the_merge_base(tmp_path: Path) -> None:
    def git(*arguments: str) -> None:
        author = ["-c", "user.name=a", "-c", "user.email=a", "-c", "core.hooksPath=/dev/null"]
        subprocess.run(["git", *author, *arguments], cwd=tmp_path, check=True, capture_output=True)

    assert at_merge_base(tmp_path) is None
    git("init", "-q", "-b", "main")
    git("commit", "-q", "--allow-empty", "-m", "Begin")
    assert at_merge_base(tmp_path) is None
    table = tmp_path / TABLE
    table.parent.mkdir(parents=True)
    for branch, ceiling in (("main", 9.0), ("branch", 8.0), ("main", 7.0)):
        git("checkout", "-q", "-B" if branch == "branch" else "-q", branch)
        table.write_text(SMALL.replace('"." = 9.0', f'"." = {ceiling}'))
        git("add", ".")
        git("commit", "-q", "-m", "Set a limit")
    git("checkout", "-q", "branch")
    before = at_merge_base(tmp_path)
    assert before is not None
    assert before.ceilings["."] == 9.0


def test_names_of_tests_that_are_too_long_are_found(tmp_path: Path) -> None:
    path = tmp_path / "test_a.py"
    path.write_text(f"async def test_{'a' * 68}() -> None: ...\ndef test_{'b' * 67}() -> None: ...\n")
    assert long_names([path], 72) == {f"test_{'a' * 68}": path}


def test_lines_that_switch_off_a_check_are_counted_in_the_package_only(tmp_path: Path) -> None:
    source = 'x: Any = f(Any)  # type: ignore[misc]\ny = "noqa"  # noqa: S105  (a word)\nz: Anyone = 1  # Any one.\n'
    for name in ("inside/a.py", "inside/b.txt", "outside.py"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(source)
    counts = suppressions([path for path in tmp_path.rglob("*") if path.is_file()], tmp_path / "inside")
    assert counts == {"Any": 1, "noqa": 1, "type: ignore": 1}


def test_more_lines_that_switch_off_a_check_than_the_limit_are_reported() -> None:
    rules = read_rules(SMALL)
    rules.suppressions = {"Any": 3, "noqa": 2}
    assert list(too_many({"Any": 3, "noqa": 3, "type: ignore": 9}, rules)) == [
        "3 lines of unity_link/ have `noqa`, at most 2 may"
    ]


def test_a_docstring_that_asks_or_orders_is_found(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    path.write_text(
        '"""Whether it is."""\n'
        'HEIGHT = 3\n"""Of the mast."""\n'
        'class A:\n    """Whichever.\n\n    What follows."""\n'
        '    def a(self):\n        """  Give it."""\n    b: int\n    """Height."""\n'
    )
    asking = "docstring asks or orders, write what it is"
    assert list(questions(tmp_path)) == [
        f"{path}:1: {asking}: Whether it is.",
        f"{path}:3: {asking}: Of the mast.",
        f"{path}:9: {asking}: Give it.",
    ]
