"""No string from outside breaks out of its place in a file of another language, as the language's own tool reads it."""

from __future__ import annotations

import configparser
import contextlib
import random
import shutil
from itertools import islice
from typing import TYPE_CHECKING

import pytest
import yaml

from support.readers import READERS
from unity_link import quoting

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

PIECES = (
    *("\n", "\r", "\r\n", "\t", "\v", "\f", "\0", "\x1b[31m", "\x1c", "\x1e", "\x7f", "\x85", "\x9b2J", "\xa0", "\xad"),
    *(
        "\u061c",
        "\u200b",
        "\u2028",
        "\u2029",
        "\u202e",
        "\u2066",
        "\u3000",
        "\ufeff",
        "\uffff",
        "\U0001f916",
        "\udce4",
        "\ud800",
        "µ",
        "°C",
    ),
    *(
        "\\",
        "\\\\",
        "\\n",
        "\\u000a",
        "\\x0a",
        "\\N{LF}",
        "'",
        '"',
        "'''",
        '"""',
        "`",
        "```",
        "??/",
        "??'",
        "%d%s%n",
        "%%",
    ),
    *(
        "/*",
        "*/",
        "//",
        "-->",
        "--",
        "--!>",
        "->",
        ">",
        "<",
        "<!--",
        "<?x?>",
        "]]>",
        "&",
        "&lt;",
        "&#10;",
        "</a>",
        "<script>",
    ),
    *(
        "#",
        "#{",
        "#[[",
        "]]",
        "%{",
        "%}",
        "%!test",
        "...",
        "$x",
        "${x}",
        "$(x)",
        "[exit 1]",
        "{",
        "}",
        "[",
        "]",
        "(",
        ")",
    ),
    *(
        ";",
        "; exit 1",
        "|",
        "||",
        "~~",
        "**",
        "__",
        "=",
        "===",
        "---",
        ":::",
        "+",
        "- ",
        "1. ",
        "12) ",
        "!",
        "@",
        "^",
        "~",
        ",",
    ),
    *(
        "coding:utf-7",
        "coding=latin-1",
        "-*- coding: utf-16 -*-",
        "+AAo-",
        "import os",
        "exit(1)",
        "raise",
        "{{ x }}",
        "{% x %}",
    ),
    *(
        "pragma translate_off",
        "synopsys translate_off",
        "synthesis translate_off",
        "psl assert never",
        "verilator lint_off",
    ),
    *(
        "end;",
        "endmodule",
        "return 1",
        "error('x')",
        "message(FATAL_ERROR x)",
        "word",
        "Word ",
        " ",
        "  ",
        "1",
        "a",
        "é",
        "中",
    ),
)
"""Ends and beginnings of strings and comments in some language, and line ends of all kinds."""
BATCH = 2_000
"""Strings that a reader gets at once."""
PROGRAMS = {
    "c string": "cc", "c comment": "cc", "c++ string": "c++", "c++ comment": "c++", "vhdl comment": "ghdl",
    "verilog comment": "iverilog", "cmake comment": "cmake", "tcl comment": "tclsh", "tcl string": "tclsh",
    "matlab comment": "octave-cli", "matlab string": "octave-cli",
}  # fmt: skip


def strings(seed: int) -> Iterator[str]:
    """Yield strings without end: each piece by itself, before and after a word, then random sequences of pieces."""
    for piece in PIECES:
        yield from (piece, f"{piece}word", f"word{piece}", f"word {piece} word", f"{piece}\n{piece}")
    chosen = random.Random(seed)
    while True:
        yield "".join(chosen.choices(PIECES, k=chosen.randint(0, 8)))


def outbreaks(place: str, count: int) -> list[str]:
    program = PROGRAMS.get(place)
    if program is not None and shutil.which(program) is None:
        pytest.skip(f"{program} is not installed")
    every = islice(strings(1), count)
    found: list[str] = []
    while some := list(islice(every, BATCH)):
        found += READERS[place](some)
    return found


@pytest.mark.slow
@pytest.mark.parametrize("place", READERS)
def test_no_string_breaks_out(place: str) -> None:
    assert outbreaks(place, BATCH) == []


@pytest.mark.campaign
@pytest.mark.parametrize("place", READERS)
def test_no_string_of_a_hundred_thousand_breaks_out(place: str) -> None:
    assert outbreaks(place, 100_000) == []


NAIVE: dict[str, tuple[str, Callable[[str], object]]] = {
    "python comment": ("python_comment", str),
    "python string": ("python_string", lambda text: f"'{text[:1]}'"),
    "python docstring": ("python_docstring", lambda text: f'"""{text.strip(chr(34))}"""'),
    "c string": ("c_string", lambda text: f'"{text.encode(errors="replace").decode()}"'),
    "c comment": ("c_comment", lambda text: f"/* {quoting.one_line(text)} */"),
    "c++ string": ("c_string", lambda text: f'"{text.encode(errors="replace").decode()}"'),
    "c++ comment": ("c_comment", lambda text: f"/* {quoting.one_line(text)} */"),
    "vhdl comment": ("hdl_comment", quoting.terminal),
    "verilog comment": ("hdl_comment", quoting.terminal),
    "xml": ("xml_comment", quoting.one_line),
    "html comment": ("xml_comment", str),
    "markdown": ("markdown", lambda text: " ".join(text.split())),
    "yaml comment": ("one_line", str),
    "setup.cfg comment": ("one_line", str),
    "cmake comment": ("one_line", quoting.terminal),
    "tcl comment": ("tcl_comment", quoting.one_line),
    "tcl string": ("tcl_string", lambda text: f'"{quoting.one_line(text)}"'),
    "matlab comment": ("one_line", quoting.terminal),
    "matlab string": ("matlab_string", lambda text: f"'{quoting.terminal(text)}'"),
    "terminal": ("terminal", str),
}
"""For each place, a function that quotes too little."""


@pytest.mark.parametrize("place", READERS)
def test_its_reader_finds_a_string_that_is_quoted_too_little(place: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(quoting, *NAIVE[place])
    # A reader within this process reports an outbreak by its error.
    with contextlib.suppress(SyntaxError, ValueError, yaml.YAMLError, configparser.Error):
        assert outbreaks(place, 1_000)
