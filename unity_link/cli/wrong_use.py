"""One-sentence messages for wrong command lines: for values that typer and pydantic refuse."""

from __future__ import annotations

import enum
import re
from typing import TYPE_CHECKING, Any, get_args

from unity_link.errors import did_you_mean

if TYPE_CHECKING:
    import typer

_UNITS = {"HZ": "Hz", "SECONDS": "seconds", "SAMPLES": "samples"}
"""Units of options, by their metavars."""


def sentence_about(error: typer.TyperException) -> str:
    """Return a sentence with the wrong value and the expected one."""
    if re.fullmatch(r"-[\d.]+", getattr(error, "option_name", "")):
        return f"{getattr(error, 'option_name', '')} is no option: to give a negative number, write -- before it"
    wrong = getattr(error.__cause__, "errors", None)
    parameter = getattr(error, "param", None)
    if wrong is None or parameter is None:
        return error.format_message()
    name = parameter.get_error_hint().split("'")[1]
    value = str(wrong()[0]["input"])
    choices = _choices(parameter.type_descriptor.annotation)
    if choices:
        hint = did_you_mean(value, choices)
        return f"{name} is {value!r}: one of {', '.join(choices)} was expected" + (f"; {hint}" if hint else "")
    return f"{name} is {value!r}: {_expected(parameter)} was expected"


def _kinds(annotation: Any) -> tuple[object, ...]:
    """Return the alternatives of a union or literal type, or the type itself."""
    return get_args(annotation) or (annotation,)


def _choices(annotation: Any) -> list[str]:
    """Return the texts that a value may have; empty if they are not limited to a list."""
    kinds = [kind for kind in _kinds(annotation) if isinstance(kind, type) and issubclass(kind, enum.Enum)]
    literals = [text for text in _kinds(annotation) if isinstance(text, str)]
    return literals or [str(member.value) for kind in kinds for member in kind]


def _expected(parameter: Any) -> str:
    """Return a phrase for the numbers that a parameter accepts."""
    about = parameter.type_descriptor.parameter_info
    number = "a whole number" if int in _kinds(parameter.type_descriptor.annotation) else "a number"
    unit = f" of {_UNITS[parameter.metavar]}" if parameter.metavar in _UNITS else ""
    if about.min is None:
        return number + unit
    end = "on" if about.max is None else f"to {about.max:g}"
    return f"{number}{unit} from {about.min:g} {end}"
