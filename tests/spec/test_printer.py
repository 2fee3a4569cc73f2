"""The printer prints the parsed spec, with its comments."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from support.searching import examples
from support.spec_examples import FIGURE_1, expressions, specs
from unity_link.spec import SpecError, compile_text, format_text
from unity_link.spec.diagnostics import Reporter, SourceText
from unity_link.spec.parser import parse
from unity_link.spec.printer import print_file
from unity_link.spec.syntax import Argument, ComponentDeclaration, File, Placement, Word


def parsed(text: str) -> File:
    reporter = Reporter()
    file = parse(SourceText("test", text), reporter)
    assert file is not None, SpecError(reporter.diagnostics)
    return file


@pytest.mark.slow
@settings(max_examples=examples(40))
@given(specs())
def test_a_valid_spec_prints_and_parses_to_itself(file: File) -> None:
    text = print_file(file)
    assert parsed(text) == file
    assert print_file(parsed(text)) == text


@pytest.mark.slow
@settings(max_examples=examples(40))
@given(specs())
def test_a_valid_spec_compiles(file: File) -> None:
    compile_text(print_file(file))


@pytest.mark.slow
@given(expressions(["a", "b"]))
def test_any_expression_prints_and_parses_to_itself(expression: object) -> None:
    member = Placement(Word("x"), None, Word("y"), [Argument(None, expression)], None)  # type: ignore[arg-type]
    file = File([ComponentDeclaration(False, Word("c"), [], None, [member])])
    assert parsed(print_file(file)) == file


def test_the_spaces_of_figure_1_are_formatted() -> None:
    formatted = format_text(FIGURE_1)
    assert '  j1: joint("joint 1") @(0x80, 0x88, 0x8C, 0x94);\n' in formatted
    assert '  @cpos: signed READ(ID=name + ":cpos", PUBLISH(1, 10));\n' in formatted
    assert "}\n\njoint(name): @(spd, cpos, pos_sp, spd_sp) {\n" in formatted


COMMENTED = """\
// first
/* a block
   of two lines */
public x() { // behind the brace
  /// A doc string
  ///   indented
  @a = 1: READ(); // trailing
  // before b

  // again before b
  @b = 2: /* inside */ READ(
    // inside, too
    UNIT="// no comment" );
  /* between */ @c = 3: READ(); @d = 4: READ(); /* one */ // two
  // dangling
}
enum e { a, // of a
  // of b
  b }
// the end
"""


def test_no_comment_is_lost() -> None:
    formatted = format_text(COMMENTED)
    for comment in (
        "// first\n", "/* a block\n   of two lines */\n",
        "  // behind the brace\n", "  /// A doc string\n  ///   indented\n",
        ";  // trailing\n", "  // before b\n\n  // again before b\n", "  /* inside */\n", "  // inside, too\n",
        '"// no comment"', "  /* between */\n  @c", "@d = 4: READ();  /* one */  // two\n", "  // dangling\n}",
        "  a,  // of a\n  // of b\n  b,\n", "}\n// the end\n",
    ):  # fmt: skip
        assert comment in formatted, comment
    assert format_text(formatted) == formatted


@settings(max_examples=examples(100))
@given(st.data())
def test_comments_anywhere_are_kept_and_formatting_is_idempotent(data: st.DataObject) -> None:
    pieces = COMMENTED.replace("{", " { ").replace(";", " ; ").replace(",", " , ").split(" ")
    for number in range(data.draw(st.integers(1, 5))):
        place = data.draw(st.integers(0, len(pieces)))
        style = data.draw(st.sampled_from(["// c{}\n", "/// c{}\n", "/* c{} */", "\n\n// c{}\n", "\n/*c{}\n*/\n"]))
        pieces.insert(place, style.format(number))
    text = " ".join(pieces)
    try:
        formatted = format_text(text)
    except SpecError:
        return  # The comment fell into a string or another comment.
    assert format_text(formatted) == formatted
    count = text.count("c0") if "// no c0" not in text else 1
    assert formatted.count("c0") == count


def test_an_empty_file_stays_empty() -> None:
    assert format_text("") == ""
    assert format_text("\ufeff  \r\n") == ""


def test_a_long_statement_has_one_argument_a_line() -> None:
    text = f'public x() {{ @a = 1: READ(ID="{"i" * 60}", UNIT="{"u" * 60}", PUBLISH(1, 10)); }}'
    lines = format_text(text).splitlines()
    assert lines[1] == "  @a = 1: READ("
    assert lines[-3:-1] == ["      PUBLISH(1, 10)", "  );"]
    assert format_text(format_text(text)) == format_text(text)


@pytest.mark.parametrize("text", ["public x() {\r\n  @a = 1: READ();\r\n}\r\n", "\ufeffpublic x() {\n@a=1:READ();}"])
def test_line_ends_and_byte_order_marks_of_other_systems_are_accepted(text: str) -> None:
    assert format_text(text) == "public x() {\n  @a = 1: READ();\n}\n"
