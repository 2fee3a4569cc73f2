"""Quotes strings from outside for other languages and terminals: one function for each position in each language.

Outside are specs and the names of their files, boards, gateways, recordings, other machines and options. A quoted
string cannot end the comment or literal that contains it, and its reader interprets nothing in it:
`tests/test_quoting.py` checks that with the reader of each language. Line ends of all languages count as line ends.
Characters that are not printable, or that change the writing direction, become U+FFFD.
"""

from __future__ import annotations

import html
import re
import textwrap

_REPLACEMENT = "\N{REPLACEMENT CHARACTER}"
_DECLARES_CODING = re.compile("(coding)(?=[:=])")
"""Word by which Python finds the encoding of a file, in a comment of its first two lines."""
_ENDS_DOCSTRING = re.compile(r'"""|"\Z')
_DIRECTIVE = re.compile(
    r" *(?:altera|cadence|coverage|exemplar|pragma|psl|quartus|rtl_synthesis|synopsys|synplify|synthesis|verilator"
    r"|vhdl_comp|vsg|xilinx)(?:_|\b)",
    re.IGNORECASE,
)
"""First words of comments that hardware tools obey: ``synthesis translate_off`` makes them skip the following code."""
_MARKDOWN = re.compile(r"[\\`*_{}\[\]<>#|&~$]|^[!-/:-@^]")
"""Characters with a meaning in Markdown or an extension of it: some at any place, the others at the start of a line."""
_LISTED = re.compile(r"^(\d+)(?=[.)])")
_LARGEST_OF_TCL = "\uffff"


def one_line(text: str) -> str:
    """Return a text as one line, for comments that end with the line, in CMake, MATLAB, YAML or setup.cfg."""
    return text if text.isprintable() else "".join(map(_printable, text.replace("\r\n", "\n")))


def _printable(character: str) -> str:
    if character.isprintable():
        return character
    return " " if character.isspace() else _REPLACEMENT


def terminal(text: str) -> str:
    """Return a text that a terminal prints without interpreting it; line ends and tabs are kept.

    Bytes of file names that are not UTF-8 are kept too, as Python's surrogate escapes: a stream writes the same bytes.
    """
    if text.isprintable():
        return text
    return "".join(
        character if character in "\n\t" or "\ud800" <= character <= "\udfff" else _printable(character)
        for character in text
    )


def _lines(text: str) -> list[str]:
    """Return the lines of a text without control characters; at least one line."""
    return [one_line(line) for line in text.splitlines()] or [""]


# Python


def python_comment(text: str) -> str:
    """Return a text for use after ``#``."""
    return _DECLARES_CODING.sub(r"\1 ", one_line(text))


def python_string(text: str) -> str:
    """Return a string literal, in double quotes unless the text contains one."""
    literal = repr(text)
    return literal if '"' in text else f'"{literal[1:-1]}"'


def python_docstring(text: str, indent: int = 4) -> str:
    """Return a docstring whose lines after the first are indented."""
    escaped = _ENDS_DOCSTRING.sub(lambda quotes: '\\"' * len(quotes[0]), "\n".join(_lines(text)).replace("\\", "\\\\"))
    first, *others = escaped.split("\n")
    body = "\n".join([first, *(" " * indent + line if line else "" for line in others)])
    end = "\n" + " " * indent if others else ""
    return f'"""{body}{end}"""'


# C and C++


def c_string(text: str) -> str:
    """Return a string literal; ``??`` is split, because it begins a trigraph."""
    escaped = "".join(
        f"\\{character}"
        if character in '"\\'
        else character
        if character.isprintable()
        else "".join(f"\\{byte:03o}" for byte in character.encode(errors="replace"))
        for character in text
    )
    return f'"{escaped.replace("??", "?" + chr(92) + "?")}"'


def c_comment(text: str, indent: str = "") -> str:
    """Return a text of one or more lines as a comment."""
    return f"{indent}/* " + f"\n{indent} * ".join(c_comment_lines(text)) + " */"


def c_comment_lines(text: str) -> list[str]:
    """Return the lines of a text for use inside a comment."""
    safe = "\n".join(_lines(text)).replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")
    return [line.rstrip().rstrip("\\").rstrip() for line in safe.split("\n")]


# Languages of hardware


def hdl_comment(text: str) -> str:
    """Return a text for use after ``--`` in VHDL or ``//`` in Verilog."""
    line = one_line(text)
    return f"- {line.lstrip()}" if _DIRECTIVE.match(line) else line


def hdl_comment_lines(text: str, width: int) -> list[str]:
    """Return the lines of a text for use after ``--`` or ``//``, wrapped at a width."""
    # Leave two columns for the prefix that `hdl_comment` may add.
    filled = (textwrap.wrap(one_line(line), width - 2) or [""] for line in text.splitlines())
    return [hdl_comment(line) for lines in filled for line in lines]


# XML, HTML and Markdown


def vhdl_string(text: str) -> str:
    """Return a VHDL string literal for a text of printable ASCII."""
    return '"' + text.replace('"', '""') + '"'


def vhdl_literal(value: int | str) -> str:
    """Return a VHDL literal for an integer, a bool, or a string of printable ASCII."""
    if isinstance(value, bool):
        return str(value).lower()
    return vhdl_string(value) if isinstance(value, str) else str(value)


def xml_text(text: str) -> str:
    """Return a text for use between tags or in a quoted attribute."""
    return html.escape(one_line(text))


def xml_comment(text: str) -> str:
    """Return a text for use in a comment of XML, HTML or Markdown, between two blanks."""
    return re.sub("-(?=-)", "- ", xml_text(text))


def markdown(text: str) -> str:
    """Return a text of one line that Markdown shows literally, also in a cell of a table."""
    escaped = _MARKDOWN.sub(r"\\\g<0>", " ".join(one_line(text).split()))
    return _LISTED.sub(r"\1\\", escaped)


# Tcl, the language of the scripts for vendors' tools


def tcl_comment(text: str) -> str:
    """Return a text for use after ``#``; a backslash at its end, which would continue the comment, is removed."""
    return one_line(text).rstrip("\\ ")


def tcl_string(text: str) -> str:
    """Return a word in quotes, which may also be inside braces."""
    escaped = (
        f"\\{character}"
        if character in '\\"$[]{};#'
        else character
        if character.isascii()
        else f"\\u{ord(min(character, _LARGEST_OF_TCL)):04x}"
        for character in one_line(text)
    )
    return f'"{"".join(escaped)}"'


# MATLAB and GNU Octave


def matlab_string(text: str) -> str:
    """Return an expression for a char array with the text."""
    # Octave's char arrays contain bytes, MATLAB's UTF-16, so that beyond ASCII no character code fits both.
    shown = "".join(
        character if character.isascii() or character.isprintable() or character.isspace() else _REPLACEMENT
        for character in text
    )
    pieces = [piece for piece in re.split(r"([\x00-\x1f\x7f]+)", shown) if piece]
    written = [
        f"char([{' '.join(str(ord(letter)) for letter in piece)}])"
        if piece[0] < " " or piece[0] == "\x7f"
        else "'" + piece.replace("'", "''") + "'"
        for piece in pieces
    ]
    if len(written) == 1:
        return written[0]
    return f"[{', '.join(written)}]" if written else "''"
