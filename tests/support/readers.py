"""Readers of other languages: each checks how a language's own tool reads quoted strings.

Each function takes strings, writes all of them into one file, because every reader is a program to start, and returns
the strings that the tool reads differently, or that change the text around them.
"""

from __future__ import annotations

import ast
import configparser
import io
import subprocess
import tempfile
import tokenize
from collections.abc import Callable, Iterable, Iterator, Sequence
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree as ET

import yaml
from markdown_it import MarkdownIt

from unity_link import quoting

Reader = Callable[[Sequence[str]], list[str]]


def run(folder: Path, *command: str) -> str | None:
    """Return the output of a command, or None if it fails."""
    done = subprocess.run(command, cwd=folder, capture_output=True, check=False, timeout=120)
    return None if done.returncode else done.stdout.decode(errors="replace")


def bisected(texts: Sequence[str], is_sound: Callable[[Sequence[str]], bool]) -> list[str]:
    """Return a list of one unsound text, found by bisection, or an empty list if all texts are sound."""
    if is_sound(texts):
        return []
    while len(texts) > 1:
        half = texts[: len(texts) // 2]
        texts = texts[len(half) :] if is_sound(half) else half
    return list(texts)


def by_halves(name: str, write: Callable[[Sequence[str]], str], *commands: str, said: Callable[[int], str]) -> Reader:
    """Return a reader that runs programs.

    Args:
        name: name of the file to write.
        write: returns the text of the file.
        commands: command lines, run one after the other in the folder of the file.
        said: returns the output that the last command must print for a number of strings.
    """

    def is_sound(texts: Sequence[str]) -> bool:
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / name).write_text(write(texts), encoding="utf-8", newline="")
            printed = ""
            for command in commands:
                output = run(Path(folder), *command.split())
                # If a compiler has failed, there is no program to run.
                if output is None:
                    return False
                printed = output
            return printed.split() == said(len(texts)).split()

    return lambda texts: bisected(texts, is_sound)


def numbered(texts: Iterable[str], line: str) -> Iterator[str]:
    """Yield a line for each text, with its number for `%d` and the text for `%s`."""
    return (line.replace("%d", str(number)).replace("%s", text) for number, text in enumerate(texts))


def numbers(count: int) -> str:
    """Return the numbers from 0 to `count` - 1, separated by spaces."""
    return " ".join(map(str, range(count)))


# Python


def python_comments(texts: Sequence[str]) -> list[str]:
    comments = [quoting.python_comment(text) for text in texts]

    def is_sound(some: Sequence[str]) -> bool:
        body = ast.parse("".join(numbered(some, "# %s\n%d\n"))).body
        return [ast.literal_eval(ast.unparse(one)) for one in body] == list(range(len(some)))

    declared = [
        comment
        for comment in comments
        for first in (b"", b"#!/usr/bin/env python3\n")
        if tokenize.detect_encoding(io.BytesIO(first + f"# {comment}\n".encode()).readline)[0] != "utf-8"
    ]
    return declared + bisected(comments, is_sound)


def python_strings(texts: Sequence[str]) -> list[str]:
    return [text for text in texts if ast.literal_eval(quoting.python_string(text)) != text]


def python_docstrings(texts: Sequence[str]) -> list[str]:
    def is_sound(text: str) -> bool:
        tree = ast.parse(f"class A:\n    {quoting.python_docstring(text)}\n    b = 1\n")
        (only,) = tree.body
        assert isinstance(only, ast.ClassDef)
        shown = [quoting.one_line(line).strip() for line in text.splitlines()]
        told = [line.strip() for line in (ast.get_docstring(only, clean=False) or "").split("\n")]
        return len(only.body) == 2 and "\n".join(shown).strip() == "\n".join(told).strip()

    return [text for text in texts if not is_sound(text)]


# C and C++


def _c_strings(texts: Sequence[str]) -> str:
    # Compare each string with its bytes; a wrong length ends the compilation.
    lines = []
    for text in texts:
        data = text.encode(errors="replace")
        lines.append(f"{{{quoting.c_string(text)}, {len(data)}, {{{', '.join(map(str, data)) or '0'}}}}},")
    longest = max(len(text.encode(errors="replace")) for text in texts) + 1
    return (
        "#include <stdio.h>\n#include <string.h>\n"
        f"static const struct {{ char text[{longest}]; unsigned size; unsigned char bytes[{longest}]; }} all[] = {{\n"
        + "\n".join(lines)
        + "\n};\nint main(void) {\n  for (unsigned i = 0; i < sizeof all / sizeof *all; i++)\n"
        f'    if (memcmp(all[i].text, all[i].bytes, {longest}) == 0) printf("%u ", i);\n  return 0;\n}}\n'
    )


def _c_comments(texts: Sequence[str]) -> str:
    lines = (f"{quoting.c_comment(text)}\n{number},\n" for number, text in enumerate(texts))
    return (
        "#include <stdio.h>\nstatic const unsigned all[] = {\n" + "".join(lines) + "};\nint main(void) {\n"
        '  for (unsigned i = 0; i < sizeof all / sizeof *all; i++) printf("%u ", all[i]);\n  return 0;\n}\n'
    )


_STRICT = "-Wall -Wextra -Werror -pedantic -trigraphs -O0 -o a.out"
_C, _CXX = f"cc -std=c99 {_STRICT} a.c", f"c++ -std=c++17 {_STRICT} a.cc"
c_strings = by_halves("a.c", _c_strings, _C, "./a.out", said=numbers)
c_comments = by_halves("a.c", _c_comments, _C, "./a.out", said=numbers)
cpp_strings = by_halves("a.cc", _c_strings, _CXX, "./a.out", said=numbers)
cpp_comments = by_halves("a.cc", _c_comments, _CXX, "./a.out", said=numbers)


# Hardware description languages


def _vhdl(texts: Sequence[str]) -> str:
    names, comments = [], []
    for number, text in enumerate(texts):
        lines = [quoting.hdl_comment(text), *quoting.hdl_comment_lines(text, 40)]
        comments.append(
            "".join(f"    -- {line}\n" for line in lines) + f"    constant c_{number} : natural := {number};\n"
        )
        names.append(f"c_{number}")
    return (
        "entity top is port (o : out natural); end entity top;\narchitecture a of top is\n"
        + "".join(comments)
        + f"  constant total : natural := {' + '.join(names)};\nbegin\n  o <= total;\n"
        "  assert false report integer'image(total) severity note;\nend architecture a;\n".replace(" + ", "\n    + ")
    )


def _verilog(texts: Sequence[str]) -> str:
    lines = (f"  // {quoting.hdl_comment(text)}\n  initial $display({number});\n" for number, text in enumerate(texts))
    return "module top;\n" + "".join(lines) + "endmodule\n"


_GHDL = "--std=08 --workdir=."


def vhdl_comments(texts: Sequence[str]) -> list[str]:
    def is_sound(some: Sequence[str]) -> bool:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "a.vhd").write_text(_vhdl(some), encoding="utf-8", newline="")
            if run(folder, "ghdl", "-a", "--std=08", "a.vhd") is None:
                return False
            printed = run(folder, "ghdl", "--elab-run", "--std=08", "top") or ""
            # Synthesis obeys some comments that simulation ignores.
            is_taken = run(folder, "ghdl", "--synth", "--std=08", "a.vhd", "-e", "top") is not None
            return is_taken and printed.rstrip().endswith(f": {sum(range(len(some)))}")

    return bisected(texts, is_sound)


verilog_comments = by_halves("a.v", _verilog, "iverilog -g2005 -o a.out a.v", "vvp -n a.out", said=numbers)


# XML, HTML, Markdown


def xml_texts(texts: Sequence[str]) -> list[str]:
    def is_sound(some: Sequence[str]) -> bool:
        items = (
            f'<a b="{quoting.xml_text(text)}">{quoting.xml_text(text)}</a><!-- {quoting.xml_comment(text)} -->'
            for text in some
        )
        builder = ET.TreeBuilder(insert_comments=True)
        try:
            root = ET.fromstring(f"<r>{''.join(items)}</r>", ET.XMLParser(target=builder))
        except ET.ParseError:
            return False
        shown = list(map(quoting.one_line, some))
        return (
            len(root) == 2 * len(some)
            and [one.text or "" for one in root[::2]] == shown
            and [one.get("b") for one in root[::2]] == shown
            and not any(isinstance(one.tag, str) for one in root[1::2])
        )

    return bisected(texts, is_sound)


class Tags(HTMLParser):
    """Collects the tags of a page of HTML, without the text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append(f"<{tag} {' '.join(name for name, _ in attrs)}>")

    def handle_endtag(self, tag: str) -> None:
        self.found.append(f"</{tag}>")

    def handle_comment(self, data: str) -> None:
        self.found.append("<!>")

    def handle_decl(self, decl: str) -> None:
        self.found.append("<!decl>")

    def handle_pi(self, data: str) -> None:
        self.found.append("<?>")


def html_comments(texts: Sequence[str]) -> list[str]:
    return [
        text for text in texts if Tags(f"<p><!-- {quoting.xml_comment(text)} --></p>").found != ["<p >", "<!>", "</p>"]
    ]


_MARKDOWN = MarkdownIt("commonmark").enable(["table", "strikethrough"])


def shape_of_markdown(text: str) -> list[str]:
    """Return the elements of a page of Markdown, without the text."""
    kinds: list[str] = []
    for token in _MARKDOWN.parse(text):
        inner = [one.type for one in token.children or ()]
        kinds += [token.type, *(one for one in inner if one not in {"text", "text_special"})]
    return kinds


def markdown_texts(texts: Sequence[str]) -> list[str]:
    def is_sound(text: str) -> bool:
        quoted, shown = quoting.markdown(text), " ".join(quoting.one_line(text).split())
        if not shown:
            return not quoted
        paragraph = _MARKDOWN.parse(f"{quoted}\n\nbehind\n")
        cells = _MARKDOWN.parse(f"| a | b |\n|---|---|\n| {quoted} | 1 |\n")
        read = ["".join(one.content for one in token.children or ()) for token in paragraph if token.type == "inline"]
        in_cell = ["".join(one.content for one in token.children or ()) for token in cells if token.type == "inline"]
        plain = shape_of_markdown(f"{quoted}\n\nbehind\n") == ["paragraph_open", "inline", "paragraph_close"] * 2
        return plain and read == [shown, "behind"] and in_cell == ["a", "b", shown, "1"]

    return [text for text in texts if not is_sound(text)]


# Comments up to the end of the line


def yaml_comments(texts: Sequence[str]) -> list[str]:
    def is_sound(some: Sequence[str]) -> bool:
        text = "".join(numbered(map(quoting.one_line, some), "# %s\n- %d\n"))
        return bool(yaml.safe_load(text) == list(range(len(some))))

    return bisected(texts, is_sound)


def ini_comments(texts: Sequence[str]) -> list[str]:
    def is_sound(some: Sequence[str]) -> bool:
        parser = configparser.ConfigParser(interpolation=None)
        parser.read_file(
            io.StringIO("[a]\n" + "".join(numbered(map(quoting.one_line, some), "# %s\nk%d=%d\n")), newline=None)
        )
        return dict(parser["a"]) == {f"k{number}": str(number) for number in range(len(some))}

    return bisected(texts, is_sound)


cmake_comments = by_halves(
    "a.cmake",
    lambda texts: (
        "".join(numbered(map(quoting.one_line, texts), "# %s\nlist(APPEND all %d)\n"))
        + 'string(REPLACE ";" " " all "${all}")\nexecute_process(COMMAND echo ${all})\n'
    ),
    "cmake -P a.cmake",
    said=numbers,
)
tcl_comments = by_halves(
    "a.tcl",
    lambda texts: "".join(numbered(map(quoting.tcl_comment, texts), "# %s\nputs %d\n")),
    "tclsh a.tcl",
    said=numbers,
)


def _tcl_strings(texts: Sequence[str]) -> str:
    lines = (
        f"if {{1}} {{\n  puts [string equal {quoting.tcl_string(text)} [encoding convertfrom utf-8 [binary format H* "
        f"{_in_tcl(text).encode().hex() or '{}'}]]]\n}}\n"
        for text in texts
    )
    return "".join(lines)


def _in_tcl(text: str) -> str:
    """Return a text as Tcl 8.6 can represent it: with at most 16 bits for each character."""
    return "".join(min(character, "\uffff") for character in quoting.one_line(text))


tcl_strings = by_halves("a.tcl", _tcl_strings, "tclsh a.tcl", said=lambda count: " ".join(["1"] * count))
_OCTAVE = "octave-cli --no-init-file --quiet a.m"
matlab_comments = by_halves(
    "a.m",
    lambda texts: "1;\n" + "".join(numbered(map(quoting.one_line, texts), "% %s\ndisp(%d);  % %s\n")),
    _OCTAVE,
    said=numbers,
)


def _matlab_strings(texts: Sequence[str]) -> str:
    lines = (
        f"printf('%d ', isequal(double({quoting.matlab_string(text)}), [{' '.join(map(str, _in_octave(text)))}]"
        f" ) || isempty({quoting.matlab_string(text)}));\n"
        for text in texts
    )
    return "1;\n" + "".join(lines)


def _in_octave(text: str) -> bytes:
    shown = "".join(one if one.isascii() or one.isprintable() or one.isspace() else "\ufffd" for one in text)
    return shown.encode()


matlab_strings = by_halves("a.m", _matlab_strings, _OCTAVE, said=lambda count: " ".join(["1"] * count))


# A terminal


def terminal_texts(texts: Sequence[str]) -> list[str]:
    return [
        text
        for text in texts
        if not all(one.isprintable() or one in "\n\t" or "\ud800" <= one <= "\udfff" for one in quoting.terminal(text))
        or quoting.terminal(quoting.terminal(text)) != quoting.terminal(text)
        or (text.isprintable() and quoting.terminal(text) != text)
    ]


READERS: dict[str, Reader] = {
    "python comment": python_comments,
    "python string": python_strings,
    "python docstring": python_docstrings,
    "c string": c_strings,
    "c comment": c_comments,
    "c++ string": cpp_strings,
    "c++ comment": cpp_comments,
    "vhdl comment": vhdl_comments,
    "verilog comment": verilog_comments,
    "xml": xml_texts,
    "html comment": html_comments,
    "markdown": markdown_texts,
    "yaml comment": yaml_comments,
    "setup.cfg comment": ini_comments,
    "cmake comment": cmake_comments,
    "tcl comment": tcl_comments,
    "tcl string": tcl_strings,
    "matlab comment": matlab_comments,
    "matlab string": matlab_strings,
    "terminal": terminal_texts,
}
"""The reader of each place, in each language, that a string from outside is written to."""
