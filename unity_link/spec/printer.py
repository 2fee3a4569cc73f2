"""The printer of syntax trees: it defines the one layout of a spec, which `unity-link fmt` produces.

Two spaces for a level, one statement a line, at most 120 characters a line if the arguments can be wrapped. Numbers and
parentheses are printed as written. The output parses to the same tree, and printing that tree gives the same output.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.spec.syntax import (
    Argument,
    Call,
    Chain,
    Comment,
    ComponentDeclaration,
    EnumDeclaration,
    EnumValueDeclaration,
    Expression,
    File,
    GroupDeclaration,
    Import,
    Name,
    Number,
    ParameterDeclaration,
    Parenthesis,
    Placement,
    Prefixed,
    SignalDeclaration,
    Statement,
    Text,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

LINE_LENGTH = 120
_INDENT = "  "
_ESCAPES = str.maketrans({"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t"})


def print_file(file: File) -> str:
    """Return the text of a file; unless it is empty, it ends with a line end."""
    lines: list[str] = []
    previous: Statement | None = None
    for item in file.items:
        both_short = all(isinstance(one, Import | GroupDeclaration) for one in (previous, item))
        if previous is not None and (item.blank_before or not both_short or type(previous) is not type(item)):
            lines.append("")
        lines += _statement(item, "")
        previous = item
    lines += _comments(file.dangling, "", separate=bool(lines))
    return "".join(f"{line}\n" for line in lines)


def _statement(statement: Statement, indent: str, ending: str = "") -> list[str]:
    """Return the lines of a statement with its comments; `ending` follows the statement, before a trailing comment."""
    lines = _comments(statement.leading, indent, separate=False)
    lines += [f"{indent}///{' ' * bool(line)}{line}" for line in statement.doc]
    lines += _bare(statement, indent)
    lines[-1] += ending
    for comment in statement.trailing:
        lines[-1] += f"  {comment.text}"
    return lines


def _comments(comments: Sequence[Comment], indent: str, *, separate: bool) -> list[str]:
    lines: list[str] = []
    for comment in comments:
        if comment.blank_before and (lines or separate):
            lines.append("")
        lines.append(indent + comment.text)
    return lines


def _bare(statement: Statement, indent: str) -> list[str]:  # noqa: PLR0911  (one for each statement)
    match statement:
        case Import():
            return [f"{indent}import {_expression(statement.path)};"]
        case GroupDeclaration():
            return (
                _wrapped(f"{indent}group {statement.name}", [statement.arguments], ";")
                if (statement.arguments)
                else [f"{indent}group {statement.name};"]
            )
        case EnumValueDeclaration():
            value = "" if statement.value is None else f" = {_expression(statement.value)}"
            return [f"{indent}{statement.name}{value}"]
        case EnumDeclaration():
            return _block(f"{indent}enum {statement.name}", statement, statement.members, indent, ",")
        case SignalDeclaration():
            return _wrapped(indent + _signal_head(statement), [statement.arguments], ";")
        case ComponentDeclaration():
            return _block(indent + _component_head(statement), statement, statement.members, indent)
        case Placement():
            return _placement(statement, indent)
        case _:
            raise AssertionError(statement)


def _block(
    head: str,
    block: EnumDeclaration | ComponentDeclaration | Placement,
    members: Sequence[Statement],
    indent: str,
    ending: str = "",
) -> list[str]:
    inside: list[str] = []
    for member in members:
        if member.blank_before and inside:
            inside.append("")
        inside += _statement(member, indent + _INDENT, ending)
    inside += _comments(block.dangling, indent + _INDENT, separate=bool(inside))
    return [f"{head} {{", *inside, f"{indent}}}"]


def _signal_head(signal: SignalDeclaration) -> str:
    count = "" if signal.count is None else f"[{_expression(signal.count)}]"
    address = "" if signal.address is None else f" = {_expression(signal.address)}"
    bits = ""
    if signal.bits is not None:
        low = "" if signal.bits.low is None else f":{_expression(signal.bits.low)}"
        bits = f"[{_expression(signal.bits.high)}{low}]"
    kind = ""
    if signal.kind is not None:
        width = "" if signal.kind.width is None else f"{_expression(signal.kind.width)} "
        kind = f"{signal.kind.name} {width}"
    return f"@{signal.name}{count}{address}{bits}: {kind}{signal.access}"


def _component_head(component: ComponentDeclaration) -> str:
    public = "public " * component.public
    addresses = "" if component.addresses is None else f": @({_parameters(component.addresses)})"
    return f"{public}{component.name}({_parameters(component.parameters)}){addresses}"


def _parameters(parameters: Sequence[ParameterDeclaration]) -> str:
    return ", ".join(
        parameter.name if parameter.default is None else f"{parameter.name}={_expression(parameter.default)}"
        for parameter in parameters
    )


def _placement(placement: Placement, indent: str) -> list[str]:
    label = ""
    if placement.name is not None:
        count = "" if placement.count is None else f"[{_expression(placement.count)}]"
        label = f"{placement.name}{count}: "
    lists = [placement.arguments, *([] if placement.addresses is None else [placement.addresses])]
    head = f"{indent}{label}{placement.type}"
    if placement.members is None:
        return _wrapped(head, lists, ";")
    *first, last = _wrapped(head, lists, "")
    return [*first, *_block(last, placement, placement.members, indent)]


def _wrapped(head: str, lists: Sequence[Sequence[Argument]], ending: str) -> list[str]:
    """Return a statement in one line, or with one argument a line if it is too long for one line."""
    texts = [[_argument(argument) for argument in arguments] for arguments in lists]
    line = head + " @".join(f"({', '.join(arguments)})" for arguments in texts) + ending
    if len(line) <= LINE_LENGTH or not any(texts):
        return [line]
    indent = head[: len(head) - len(head.lstrip())]
    lines = [head]
    for number, arguments in enumerate(texts):
        lines[-1] += " @(" * bool(number) or "("
        lines += [f"{indent}{_INDENT}{_INDENT}{argument}," for argument in arguments]
        if arguments:
            lines[-1] = lines[-1].removesuffix(",")
        lines.append(f"{indent})") if arguments else None
        if not arguments:
            lines[-1] += ")"
    lines[-1] += ending
    return lines


def _argument(argument: Argument) -> str:
    value = _expression(argument.value)
    return value if argument.name is None else f"{argument.name}={value}"


def _expression(expression: Expression) -> str:  # noqa: PLR0911
    match expression:
        case Number():
            return expression.text
        case Text():
            return f'"{expression.value.translate(_ESCAPES)}"'
        case Name():
            return expression.name
        case Call():
            return f"{expression.name}({', '.join(_argument(argument) for argument in expression.arguments)})"
        case Parenthesis():
            return f"({_expression(expression.inner)})"
        case Prefixed():
            return expression.prefixes + _expression(expression.operand)
        case Chain():
            first, *rest = (_expression(operand) for operand in expression.operands)
            pairs = zip(expression.operators, rest, strict=True)
            return first + "".join(f" {operator} {operand}" for operator, operand in pairs)
