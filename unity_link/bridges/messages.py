"""The JSON of a sample, in recordings and for viewers of samples.

::

    {"sequence": 7, "time": 0.07, "lost": 0, "epoch": 0, "words": "000003E8", "signals": {"j1": {"cpos": 1.5}}}

``signals`` is the tree of the spec, so the signal ``legs[2].coxa.cpos`` has the same path in the tools that open the
file. ``words`` has the words of the group in the order of its addresses, each as hex digits of whole bytes. They encode
the exact values, but without the rounds that are counted for signals with WRAPS. ``epoch`` is the number of the session
in which rounds are counted. ``time`` is missing without timestamps, and so is a value that JSON cannot represent (NaN,
an infinity); in an array of signals such a value is null.
"""

from __future__ import annotations

import functools
import json
import re
from typing import TYPE_CHECKING, Any

import msgspec
import numpy as np

from unity_link.spec.kinds import KindName

if TYPE_CHECKING:
    from collections.abc import Collection, Sequence

    from numpy.typing import NDArray

    from unity_link.data import Batch
    from unity_link.protocol.wire.arrays import Words
    from unity_link.spec import Signal

_STEP = re.compile(r"([^.\[\]]+)|\[(\d+)\]")
_ALWAYS = ("sequence", "lost", "epoch", "words")
"""Fields of each message, in addition to the time and the values."""
_TYPES = {"b": "boolean", "i": "integer", "u": "integer", "f": "number"}


class RecordedMessage(msgspec.Struct):
    """A message as it is read back from a recording."""

    sequence: int
    lost: int
    words: str
    time: float | None = None
    epoch: int = 0


class Encoder:
    """Writes the samples of one group as JSON, a batch at a time."""

    def __init__(self, signals: Sequence[Signal]) -> None:
        self._tree: dict[str, object] = {}
        for place, signal in enumerate(signals):
            _plant(self._tree, _steps(signal.path), place)
        self._floats = [
            place for place, signal in enumerate(signals) if signal.kind.name is KindName.FLOAT and signal.index is None
        ]
        """Places of the values that are left out if they are NaN or infinite."""
        # Cache a template for each set of values that are left out.
        self._template = functools.lru_cache(256)(self._make_template)
        self.schema = _message_schema(self._tree, signals)
        """JSON schema of a message."""

    def encode(self, batch: Batch, word_bits: int) -> list[bytes]:
        """Return the messages of the samples of a batch."""
        columns = list(batch.columns.values())
        time = [] if batch.time is None else [_texts(batch.time)]
        words = words_to_hex(batch.words, word_bits)
        head = [batch.sequence.tolist(), *time, batch.lost.tolist(), batch.epoch.tolist(), words]
        texts = [_texts(column) for column in columns]
        missing = np.zeros((len(batch), len(self._floats)), bool)
        for number, place in enumerate(self._floats):
            missing[:, number] = ~np.isfinite(columns[place])
        if not missing.any():
            return self._fill(missing[0], head, texts)
        messages = [b""] * len(batch)
        patterns, which = np.unique(missing, axis=0, return_inverse=True)
        for number, pattern in enumerate(patterns):
            rows = np.flatnonzero(which.ravel() == number).tolist()
            some = [[[column[row] for row in rows] for column in part] for part in (head, texts)]
            for row, message in zip(rows, self._fill(pattern, *some), strict=True):
                messages[row] = message
        return messages

    def _fill(self, missing: NDArray[np.bool_], head: Sequence[list[Any]], texts: Sequence[list[bytes]]) -> list[bytes]:
        """Return messages that lack the same values, made from columns of texts."""
        template, order = self._template(len(head), missing.tobytes())
        return [template % row for row in zip(*head, *(texts[place] for place in order), strict=True)]

    def _make_template(self, fields: int, missing: bytes) -> tuple[bytes, list[int]]:
        """Return the template of messages with `fields` fields before their values, and the places of the values."""
        order: list[int] = []
        absent = {place for place, is_missing in zip(self._floats, missing, strict=True) if is_missing}
        values = _template(self._tree, order, absent)
        time = '"time":%b,' if fields > len(_ALWAYS) else ""
        return f'{{"sequence":%d,{time}"lost":%d,"epoch":%d,"words":"%b","signals":{values}}}'.encode(), order


def words_to_hex(words: Words, word_bits: int) -> list[bytes]:
    """Return a text of hex digits for each sample of words of shape (samples, addresses)."""
    size = _word_bytes(word_bits)
    big_endian = np.ascontiguousarray(words.astype(">u8")).view(np.uint8).reshape(*words.shape, 8)[..., 8 - size :]
    text = big_endian.tobytes().hex().upper().encode()
    length = 2 * size * words.shape[1]
    return [text[start : start + length] for start in range(0, len(text), length)]


def hex_to_words(texts: Sequence[str], addresses: int, word_bits: int) -> Words:
    """Parse texts that `words_to_hex` has made; return words of shape (samples, addresses).

    Raises:
        ValueError: for any other text.
    """
    size = _word_bytes(word_bits)
    given = np.frombuffer(bytes.fromhex("".join(texts)), np.uint8).reshape(len(texts), addresses, size)
    padded = np.zeros((len(texts), addresses, 8), np.uint8)
    padded[..., 8 - size :] = given
    return padded.view(">u8")[..., 0].astype(np.uint64)


def _word_bytes(word_bits: int) -> int:
    return -(-word_bits // 8)


def _texts(values: NDArray[Any]) -> list[bytes]:
    """Return numbers as JSON texts; NaN and infinities become null."""
    return msgspec.json.encode(values.tolist())[1:-1].split(b",")


# The tree of names: objects are dicts, arrays of components are lists, leaves are the places of signals. Items of a
# list that are not in the group are {}; in an array of signals, they become null.


def _steps(path: str) -> list[str | int]:
    return [name or int(index) for name, index in _STEP.findall(path)]


def _plant(tree: Any, steps: list[str | int], place: int) -> None:
    for step, following in zip(steps, [*steps[1:], None], strict=True):
        if isinstance(step, int):
            tree.extend({} for _ in range(step + 1 - len(tree)))
        below: Any = place if following is None else [] if isinstance(following, int) else {}
        if following is None or (isinstance(tree, dict) and step not in tree):
            tree[step] = below
        tree = tree[step]


def _template(tree: Any, order: list[int], missing: Collection[int]) -> str:
    if isinstance(tree, int):
        order.append(tree)
        return "%b"
    if isinstance(tree, list):
        is_row = _value_of(tree) is not None
        return f"[{','.join('null' if is_row and item == {} else _template(item, order, missing) for item in tree)}]"
    there = [
        (json.dumps(name), item) for name, item in tree.items() if not isinstance(item, int) or item not in missing
    ]
    return f"{{{','.join(f'{name}:{_template(item, order, missing)}' for name, item in there)}}}"


# Foxglove needs one type for each property and for the items of an array, properties for each object, and no nested
# arrays. So a property is left out instead of being null. Items that may be null are declared in `prefixItems`, which
# validators use instead of `items`, and Foxglove ignores.


def _message_schema(tree: Any, signals: Sequence[Signal]) -> dict[str, Any]:
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "type": "object",
        "properties": {
            "sequence": {"type": "integer", "description": "number of the sample, lost ones counted"},
            "time": {"type": "number", "description": "instant of sampling, seconds of the gateway's clock"},
            "lost": {"type": "integer", "description": "samples lost before this one"},
            "epoch": {"type": "integer", "description": "number of the session, one more after each reconnection"},
            "words": {"type": "string", "description": "the words as they came, in hex"},
            "signals": _schema(tree, signals),
        },
    }


def _schema(tree: Any, signals: Sequence[Signal]) -> dict[str, object]:
    if isinstance(tree, int):
        return _value_schema(signals[tree])
    if isinstance(tree, list):
        value = _value_of(tree)
        if value is not None:
            return _row_schema(tree, signals[value])
        # Readers need one schema for all items; an item may lack properties that the group only has for other items.
        merged: dict[str, object] = {}
        for item in tree:
            merged.update(item)
        return {"type": "array", "items": _schema(merged, signals)}
    properties = {name: _schema(item, signals) for name, item in tree.items()}
    return {"type": "object", "properties": properties}


def _value_of(items: list[Any]) -> int | None:
    """Return the place of the first value in an array of signals; None for an array of components."""
    return next((item for item in items if isinstance(item, int)), None)


def _row_schema(items: list[Any], signal: Signal) -> dict[str, object]:
    """Return the schema of an array of signals of one kind; an item without a place is not in the group."""
    value = _value_schema(signal)
    schema: dict[str, object] = {"type": "array", "items": value}
    if signal.kind.name is KindName.FLOAT or not all(isinstance(item, int) for item in items):
        schema["prefixItems"] = [{"type": [value["type"], "null"]}] * len(items)
    return schema


def _value_schema(signal: Signal) -> dict[str, object]:
    kind = signal.kind
    schema: dict[str, object] = {"type": _TYPES[kind.dtype.kind]}
    absent = "no value for NaN and infinities" if kind.name is KindName.FLOAT else ""
    names = [f"{value.value}: {value.name}" for value in kind.enumeration.values] if kind.enumeration else []
    described = "; ".join(filter(None, [signal.doc, ", ".join(names), signal.unit and f"in {signal.unit}", absent]))
    return {**schema, "description": described} if described else schema
