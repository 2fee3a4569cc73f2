"""The lexer of the pages has a colour for each token of a valid spec, and each page shows its specs with this lexer."""

import re
from pathlib import Path

import pytest
from hypothesis import given
from pygments.token import Comment, Error, Keyword, Name, Number, String, Token

from docs.ul_lexer import KINDS, UlLexer
from docs.walkthrough import PAGES, blocks
from support.spec_examples import FIGURE_1, specs
from unity_link.spec.printer import print_file
from unity_link.spec.signals import PLAIN_KINDS
from unity_link.spec.syntax import File

ROOT = Path(__file__).parents[1]
EXAMPLES = [FIGURE_1, *(path.read_text(encoding="utf-8") for path in sorted(ROOT.glob("**/examples/*.ul")))]
SPEC = re.compile(r"^(public|@\w+ =) ", re.MULTILINE)
IN_PAGES = [block.text for page in PAGES for block in blocks(page) if block.language == "ul"]


def coloured(text: str) -> list[tuple[object, str]]:
    """Return the tokens of a spec other than spaces, each with its text."""
    made = list(UlLexer(ensurenl=False, stripnl=False).get_tokens(text))
    assert "".join(value for _, value in made) == text
    return [(token, value) for token, value in made if token is not Token.Text]


@pytest.mark.parametrize("text", EXAMPLES + IN_PAGES)
def test_examples_have_no_errors(text: str) -> None:
    assert not [value for token, value in coloured(text) if token is Error]


@pytest.mark.slow
@given(specs())
def test_no_valid_spec_has_errors(spec: File) -> None:
    assert not [value for token, value in coloured(print_file(spec)) if token is Error]


def test_each_token_has_its_colour() -> None:
    text = """/// Arm.
enum mode { off }
public arm() { // a
  @on = 0x1F: bool READ(UNIT="V", SCALE=2.5, MAX=7); /* b */
}
"""
    colours = {value: token for token, value in coloured(text)}
    expected = {
        "/// Arm.": String.Doc,
        "enum": Keyword,
        "mode": Name.Class,
        "arm": Name.Function,
        "// a": Comment.Single,
        "on": Name.Variable,
        "0x1F": Number.Hex,
        "bool": Keyword.Type,
        "READ": Keyword.Reserved,
        "UNIT": Name.Attribute,
        '"V"': String,
        "2.5": Number.Float,
        "7": Number.Integer,
        "/* b */": Comment.Multiline,
    }
    assert {value: colours[value] for value in expected} == expected


def test_kinds_are_those_of_the_language() -> None:
    assert set(KINDS) == set(PLAIN_KINDS)


def test_invalid_token_is_an_error() -> None:
    assert (Error, "$") in coloured("public $ robot")


def test_each_spec_of_the_pages_has_its_colours() -> None:
    assert len(IN_PAGES) > 10
    plain = [
        (page.name, block.line)
        for page in PAGES
        for block in blocks(page)
        if block.language == "text" and "error:" not in block.text and SPEC.search(block.text)
    ]
    assert plain == []
