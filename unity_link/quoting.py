"""Strings from outside, as other languages and a terminal take them: one function for each place in each language.

Outside are specs and their files' names, boards, gateways, recordings, other machines and options. None of their
strings can end the comment or the literal that it stands in, or say anything to what reads it: `tests/test_quoting.py`
has the reader of each language judge that. A line end is one of any kind that some language knows, and what is not
printed, or turns the direction of what is, becomes U+FFFD.
"""

from __future__ import annotations

import html
import re
import textwrap

_REPLACEMENT = "\N{REPLACEMENT CHARACTER}"
_DECLARES_CODING = re.compile("(coding)(?=[:=])")
"""Word that Python takes for the encoding of a file, in a comment of its first two lines."""
_ENDS_DOCSTRING = re.compile(r'"""|"\Z')
_DIRECTIVE = re.compile(
    r" *(?:altera|cadence|coverage|exemplar|pragma|psl|quartus|rtl_synthesis|synopsys|synplify|synthesis|verilator"
    r"|vhdl_comp|vsg|xilinx)(?:_|\b)",
    re.IGNORECASE,
)
"""First words of comments that tools for hardware obey: ``synthesis translate_off`` takes away what follows."""
_MARKDOWN = re.compile(r"[\\`*_{}\[\]<>#|&~$]|^[!-/:-@^]")
"""Characters that Markdown or an extension of it takes for more than a letter: some anywhere, all others in front."""
_LISTED = re.compile(r"^(\d+)(?=[.)])")
_LARGEST_OF_TCL = "\uffff"


def one_line(text: str) -> str:
    """Return a text as one line: a comment that ends with its line, of CMake, MATLAB, YAML or setup.cfg."""
    return text if text.isprintable() else "".join(map(_printable, text.replace("\r\n", "\n")))


def _printable(character: str) -> str:
    if character.isprintable():
        return character
    return " " if character.isspace() else _REPLACEMENT


def terminal(text: str) -> str:
    """Return a text that a terminal prints and does not obey; lines and tabs are kept.

    So are bytes that are no UTF-8, as Python has them from names of files: a stream writes them as such.
    """
    if text.isprintable():
        return text
    return "".join(
        character if character in "\n\t" or "\ud800" <= character <= "\udfff" else _printable(character)
        for character in text
    )


def _lines(text: str) -> list[str]:
    """Return the lines of a text, at least one."""
    return [one_line(line) for line in text.splitlines()] or [""]


# Python


def python_comment(text: str) -> str:
    """Return a text for behind ``#``."""
    return _DECLARES_CODING.sub(r"\1 ", one_line(text))


def python_string(text: str) -> str:
    """Return a literal, in double quotes where the text has none."""
    literal = repr(text)
    return literal if '"' in text else f'"{literal[1:-1]}"'


def python_docstring(text: str, indent: int = 4) -> str:
    """Return a docstring, its lines behind the first indented."""
    escaped = _ENDS_DOCSTRING.sub(lambda quotes: '\\"' * len(quotes[0]), "\n".join(_lines(text)).replace("\\", "\\\\"))
    first, *others = escaped.split("\n")
    body = "\n".join([first, *(" " * indent + line if line else "" for line in others)])
    end = "\n" + " " * indent if others else ""
    return f'"""{body}{end}"""'


# C and C++


def c_string(text: str) -> str:
    """Return a literal; ``??`` is parted, for it begins a trigraph."""
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
    """Return the lines of a text as they can stand in a comment."""
    safe = "\n".join(_lines(text)).replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")
    return [line.rstrip().rstrip("\\").rstrip() for line in safe.split("\n")]


# Languages of hardware


def hdl_comment(text: str) -> str:
    """Return a text for behind ``--`` of VHDL or ``//`` of Verilog."""
    line = one_line(text)
    return f"- {line.lstrip()}" if _DIRECTIVE.match(line) else line


def hdl_comment_lines(text: str, width: int) -> list[str]:
    """Return the lines of a text for behind ``--`` or ``//``, none longer than a width."""
    # Two columns are left for what `hdl_comment` may put before one.
    filled = (textwrap.wrap(one_line(line), width - 2) or [""] for line in text.splitlines())
    return [hdl_comment(line) for lines in filled for line in lines]


# XML, HTML and Markdown


def vhdl_string(text: str) -> str:
    """Write printable ASCII as a string literal of VHDL."""
    return '"' + text.replace('"', '""') + '"'


def vhdl_literal(value: int | str) -> str:
    """Write a whole number, a truth (a `bool`) or a string of printable ASCII as a literal of VHDL."""
    if isinstance(value, bool):
        return str(value).lower()
    return vhdl_string(value) if isinstance(value, str) else str(value)


def xml_text(text: str) -> str:
    """Return a text for between tags, or for an attribute in quotes."""
    return html.escape(one_line(text))


def xml_comment(text: str) -> str:
    """Return a text for inside a comment of XML, HTML or Markdown, with a blank on both sides."""
    return re.sub("-(?=-)", "- ", xml_text(text))


def markdown(text: str) -> str:
    """Return a text of one line that Markdown shows as it is, in a cell of a table too."""
    escaped = _MARKDOWN.sub(r"\\\g<0>", " ".join(one_line(text).split()))
    return _LISTED.sub(r"\1\\", escaped)


# Tcl, in which the tools of vendors are told what to do


def tcl_comment(text: str) -> str:
    """Return a text for behind ``#``; a backslash at its end would take the next line along."""
    return one_line(text).rstrip("\\ ")


def tcl_string(text: str) -> str:
    """Return a word in quotes, which may stand in braces, too."""
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
    """Return a char array of a text."""
    # Octave's are of bytes, MATLAB's are not, so that no number stands for the same character in both beyond ASCII.
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
