"""Finds the faults of an invalid text after the first one.

The parser is fed token by token. If a token does not fit, but the line has ended and a semicolon would fit, a semicolon
is inserted. Otherwise the statement is skipped: the parser returns to its state at the beginning of the statement and
continues after its end. The resulting tree is discarded; only the reported faults are used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from lark import Token
from lark.exceptions import UnexpectedInput, UnexpectedToken

from unity_link.spec.diagnostics import listed
from unity_link.spec.tokens import KEYWORDS, SIGNS, tokenize

if TYPE_CHECKING:
    from lark import Lark
    from lark.parsers.lalr_interactive_parser import InteractiveParser

    from unity_link.spec.diagnostics import Reporter, SourceText

MOST_FAULTS = 50
_WORDS = {
    "NAME": "a name",
    "NUMBER": "a number",
    "STRING": "a string",
    "OPERATOR": "an operator",
    "$END": "the end of the file",
}
_SIGNS = {name: sign for sign, name in (SIGNS | KEYWORDS).items()}
_STARTS = {"IMPORT", "ENUM", "GROUP", "PUBLIC"}
_ENDS = {"SEMICOLON", "LBRACE", "RBRACE"}
_OPERATORS = {"OPERATOR", "MINUS", "TILDE"}
_HINTS = {"'": "put strings in double quotes", "#": "a comment begins with //"}


def report_faults(parser: Lark, source: SourceText, reporter: Reporter) -> None:
    """Parse a source that has a syntax error, and report all faults."""
    _Recovery(parser, source, reporter).run()


class _Recovery:
    def __init__(self, parser: Lark, source: SourceText, reporter: Reporter) -> None:
        self._source = source
        self._reporter = reporter
        self._parser = parser.parse_interactive(source.text)
        self._tokens = list(tokenize(source.text))
        self._faults = 0
        self._last_line = 0

    def run(self) -> None:
        """Parse the tokens to the end of the text."""
        parser, index = self._parser, 0
        # A checkpoint is the state of the parser at the beginning of a statement; there is one for each open brace.
        checkpoints = [_copy(parser)]
        braces: list[Token] = []
        while index < len(self._tokens) and self._faults < MOST_FAULTS:
            token = self._tokens[index]
            try:
                parser.feed_token(token)
            except UnexpectedToken:
                parser, index = self._recover(parser, index, checkpoints, braces)
                continue
            index += 1
            if token.type == "LBRACE":
                braces.append(token)
                checkpoints.append(_copy(parser))
            elif token.type == "RBRACE":
                braces.pop()
                checkpoints.pop()
                checkpoints[-1] = _copy(parser)
            elif token.type == "SEMICOLON":
                checkpoints[-1] = _copy(parser)
        if self._faults < MOST_FAULTS:
            self._end(parser, braces)

    def _end(self, parser: InteractiveParser, braces: list[Token]) -> None:
        try:
            parser.feed_eof()
        except UnexpectedInput:
            if any(token.type in {"BAD_STRING", "BAD_COMMENT"} for token in self._tokens):
                # The string or comment without an end extends to the end of the file, and was reported.
                return
            if braces:
                place = (braces[-1].start_pos or 0, braces[-1].end_pos or 0)
                message = "this block has no end"
                self._reporter.error(self._source, place, "syntax", message, help="close it with '}'")
                return
            end = len(self._source.text.rstrip())
            message = f"the file ends where {self._expected(parser)} was expected"
            self._reporter.error(self._source, (max(0, end - 1), end), "syntax", message)

    def _recover(
        self, parser: InteractiveParser, index: int, checkpoints: list[InteractiveParser], braces: list[Token]
    ) -> tuple[InteractiveParser, int]:
        """Report the token that does not fit; return the parser and the index of the token to continue with."""
        token = self._tokens[index]
        self._faults += 1
        accepted = _accepted(parser)
        previous = self._tokens[index - 1] if index else None
        if previous is not None and "SEMICOLON" in accepted and self._is_later_line(previous, token):
            place = (max(0, (previous.end_pos or 0) - 1), previous.end_pos or 0)
            self._reporter.error(self._source, place, "syntax", "a ';' is missing after this")
            parser.feed_token(Token("SEMICOLON", ";", start_pos=previous.end_pos, end_pos=previous.end_pos))
            checkpoints[-1] = _copy(parser)
            return parser, index
        self._report(token, parser)
        if token.type in _STARTS and "NAME" in accepted and not self._begins_declaration(index):
            # Continue as if the keyword were a name, so that this fault causes no others.
            self._tokens[index] = Token("NAME", token, start_pos=token.start_pos, end_pos=token.end_pos)
            return parser, index
        return self._give_up(index, checkpoints, braces)

    def _report(self, token: Token, parser: InteractiveParser) -> None:
        place = (token.start_pos or 0, token.end_pos or 0)
        line = self._source.line_of(place[0])
        if line == self._last_line:
            # A second fault on a line most likely follows from the first one.
            return
        self._last_line = line
        hint = ""
        if token.type == "BAD_STRING":
            message, hint = "this string has no end", "close it with '\"' on the same line"
        elif token.type == "BAD_COMMENT":
            message, hint = "this comment has no end", "close it with '*/'"
        elif token.type == "BAD":
            shown = repr(str(token)) if token.isprintable() else f"U+{ord(token):04X}"
            message, hint = f"the character {shown} has no meaning here", _HINTS.get(token, "")
        else:
            message = f"{self._expected(parser)} was expected, not {self._shown(token)}"
            if token.type in _STARTS:
                hint = f"'{token}' is a word of the language: choose another name"
        self._reporter.error(self._source, place, "syntax", message, help=hint)

    def _give_up(
        self, index: int, checkpoints: list[InteractiveParser], braces: list[Token]
    ) -> tuple[InteractiveParser, int]:
        """Skip to the end of the statement that has the fault; return as `_recover`."""
        depth = 0
        in_enum = self._is_in_enum(index)
        while index < len(self._tokens):
            token = self._tokens[index]
            index += 1
            if depth == 0 and self._begins_declaration(index - 1):
                # Declarations are only at the top level of a file, so all blocks have ended.
                del checkpoints[1:]
                braces.clear()
                index -= 1
                break
            if token.type == "LBRACE":
                # The fault is in the head of a block; the members inside may be valid.
                if depth == 0 and not in_enum and self._enter_block(checkpoints, braces, token):
                    break
                depth += 1
            elif token.type == "RBRACE" and depth == 0:
                if braces:
                    index -= 1
                break
            elif token.type == "RBRACE":
                depth -= 1
                if depth == 0:
                    break
            elif depth == 0 and token.type in {"SEMICOLON", "BAD_STRING"}:
                # A string without an end includes the semicolon of its line.
                break
        return _copy(checkpoints[-1]), index

    def _begins_declaration(self, index: int) -> bool:
        """Return whether a keyword begins a declaration instead of being used as a name, by the tokens around it."""
        token, previous = self._tokens[index], self._tokens[index - 1] if index else None
        following = self._tokens[index + 1].type if index + 1 < len(self._tokens) else ""
        if token.type not in _STARTS or following != ("STRING" if token.type == "IMPORT" else "NAME"):
            return False
        return previous is None or previous.type in _ENDS or self._is_later_line(previous, token)

    def _is_in_enum(self, index: int) -> bool:
        for token in reversed(self._tokens[: index + 1]):
            if token.type in {"SEMICOLON", "RBRACE"} | _STARTS:
                return token.type == "ENUM"
        return False

    def _enter_block(self, checkpoints: list[InteractiveParser], braces: list[Token], opening: Token) -> bool:
        """Continue inside a block as if its head were valid; return False if no block is allowed there."""
        parser = _copy(checkpoints[-1])
        head = (("NAME", "head"), ("LPAR", "("), ("RPAR", ")"))
        try:
            for name, text in head:
                parser.feed_token(Token(name, text, start_pos=opening.start_pos, end_pos=opening.start_pos))
            parser.feed_token(opening)
        except UnexpectedToken:
            return False
        braces.append(opening)
        checkpoints.append(parser)
        return True

    def _is_later_line(self, previous: Token, token: Token) -> bool:
        return "\n" in self._source.text[previous.end_pos : token.start_pos]

    def _expected(self, parser: InteractiveParser) -> str:
        """Return the tokens that are allowed at the parser's position, as a phrase."""
        accepted = _accepted(parser)
        # Operators may follow any operand; listing them each time would hide the missing token.
        accepted = accepted - _OPERATORS or accepted
        if {"NAME", "NUMBER", "STRING"} <= accepted:
            accepted -= {"LPAR", "NAME", "NUMBER", "STRING"}
            names = ["a value"]
        else:
            names = []
        names += [f"'{_SIGNS[name]}'" if name in _SIGNS else _WORDS.get(name, name) for name in sorted(accepted)]
        return listed(names) if names else "nothing more"

    def _shown(self, token: Token) -> str:
        if token.type in {"NAME", "NUMBER", "STRING"}:
            return f"{_WORDS[token.type]} ({token[:40]})" if token.type != "STRING" else f"the string {token[:40]}"
        return f"'{token}'"


def _copy(parser: InteractiveParser) -> InteractiveParser:
    copied: InteractiveParser = parser.copy(deepcopy_values=False)
    return copied


def _accepted(parser: InteractiveParser) -> set[str]:
    accepted: set[str] = parser.accepts()
    return accepted
