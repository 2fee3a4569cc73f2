"""The checked model as JSON for a generated module: without default values and places, one signal a line."""

from __future__ import annotations

import enum
import json
import re
from typing import TYPE_CHECKING, Any

import msgspec

if TYPE_CHECKING:
    from unity_link.spec import Interface


_UNSEEN = re.compile("['\x7f-\xa0\xad\u061c\u200b-\u200f\u2028-\u202f\u205f-\u206f\ud800-\udfff\ufeff]")
"""Single quotes, and characters that editors do not show."""


def model_text(interface: Interface) -> str:
    """Return the JSON that `unity_link.data.read_interface` reads; it contains no single quotes."""
    return _UNSEEN.sub(lambda found: f"\\u{ord(found[0]):04x}", "\n".join(_lines(_plain(interface))))


def _plain(value: Any) -> Any:
    """Return a value as JSON types, without fields that have their defaults."""
    if isinstance(value, msgspec.Struct):
        config = value.__struct_config__
        fields: dict[str, object] = {} if config.tag is None else {str(config.tag_field): config.tag}
        for field in msgspec.structs.fields(value):
            item = getattr(value, field.name)
            factory = field.default_factory
            default = field.default if factory is msgspec.NODEFAULT else factory()
            # Leave out paths, which are valid on this computer only; the Python file of a core is copied.
            is_of_here = field.name in {"span", "vhdl"} or (field.name == "python" and item.endswith(".py"))
            if not is_of_here and item != default:
                fields[field.encode_name] = _plain(item)
        return fields
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, tuple | list):
        return [_plain(item) for item in value]
    return value.value if isinstance(value, enum.Enum) else value


def _lines(value: Any) -> list[str]:
    """Return JSON in lines: a value that contains lists of objects takes several lines, any other one line."""
    if not _is_deep(value):
        return [json.dumps(value, ensure_ascii=False, separators=(",", ":"))]
    is_list = isinstance(value, list)
    items = [("", item) for item in value] if is_list else [(json.dumps(key) + ":", value[key]) for key in value]
    lines = ["[" if is_list else "{"]
    for number, (head, item) in enumerate(items):
        first, *rest = _lines(item)
        lines += [head + first, *rest]
        lines[-1] += "," if number + 1 < len(items) else ""
    return [*lines, "]" if is_list else "}"]


def _is_deep(value: Any) -> bool:
    if isinstance(value, list):
        return any(isinstance(item, dict) for item in value)
    return isinstance(value, dict) and any(_is_deep(item) for item in value.values())
