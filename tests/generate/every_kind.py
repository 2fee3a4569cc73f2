"""A spec with every kind of signal, and test values for each kind: every generated client must handle them.

`Signal.encode` and `Signal.decode` are the reference: if a client writes a value, the words on the bus must be those of
`encode`; if it reads words, the value must be that of `decode`.
"""

from __future__ import annotations

import math
import random
from typing import TYPE_CHECKING

from unity_link.spec import Access, KindName, Spec, compile_text

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.spec import Interface, Signal, Value

WORD_BITS = (8, 12, 16, 32, 64)
"""Word widths in bits of the gateways in tests of clients."""
RANDOM_VALUES = 8

_ENUMERATION = """\
/// What the arm does.
enum mode {
  off,      // 0
  manual = 4,
  auto,
  class = 7
}
"""
_JOINT = """\
/// A joint.
joint(): @(base) {
  @position = base: signed READWRITE(UNIT="counts");
  @double = base + 1: READWRITE();
  @flags[3] = base + 2[2 * i + 1:2 * i]: unsigned READWRITE();
}
"""


LIMITS_BEYOND_DOUBLES = compile_text("""\
public robot() {
  GATEWAY(DATA_BITS=64);
  @a = 0: unsigned 64 READWRITE(MAX=18446744073709551614);
  @b = 1: signed 64 READWRITE(MIN=-9223372036854775807);
  @c = 2: unsigned 64 READWRITE(MAX=9007199254740993);
  @d = 3: unsigned 64 READWRITE(MIN=9007199254740993);
  @e = 4: signed 64 READWRITE(MIN=-9223372036854775808, MAX=-9007199254740993);
  @f = 5: signed 8 READWRITE(MIN=-2.5, MAX=2.5);
  @g = 6: unsigned 60 READWRITE();
}
""")
"""A spec with limits that a double cannot represent, and limits that are not whole numbers."""
LIMIT_TRIALS: list[tuple[str, int, bool]] = [
    ("a", 2**64 - 2, True),
    ("a", 2**64 - 1, False),
    ("b", -(2**63) + 1, True),
    ("b", -(2**63), False),
    ("b", 2**63 - 1, True),
    ("c", 2**53 + 1, True),
    ("c", 2**53 + 2, False),
    ("d", 2**53 + 1, True),
    ("d", 2**53, False),
    ("d", 2**64 - 1, True),
    ("e", -(2**63), True),
    ("e", -(2**53) - 1, True),
    ("e", -(2**53), False),
    ("f", -2, True),
    ("f", 2, True),
    ("f", -3, False),
    ("f", 3, False),
    ("g", 2**60 - 1, True),
    ("g", 2**60, False),
]
"""Signals of that spec, values, and True if the signal accepts the value."""


def every_kind(word_bits: int) -> Spec:
    """Return the spec of every kind, for a gateway with words of `word_bits` bits and addresses of 8 bits."""
    kinds = [
        "bool",
        *(f"unsigned {width}" for width in (1, 3, 8, 13, 16, 24, 31, 32, 33, 53, 63, 64)),
        *(f"signed {width}" for width in (1, 2, 7, 8, 12, 16, 24, 32, 40, 63, 64)),
        *(f"float {width}" for width in (16, 32, 64)),
        "fixed 16.16",
        "fixed 0.8",
        "ufixed 8.8",
        "fixed 20.20",
        "mode 4",
        "mode 40",
    ]
    lines, address = [], 0
    for number, kind in enumerate(kinds):
        width = sum(int(part) for part in kind.split()[-1].split(".")) if " " in kind else 1
        lines.append(f"@s{number} = {address}: {kind} READWRITE();")
        address += -(-width // word_bits)
    scaled = {
        "scaled": 'signed 8 READWRITE(SCALE=0.01, OFFSET=-2.5, UNIT="mm")',
        "falling": "unsigned 8 READWRITE(SCALE=-3)",
        "wide": 'signed 40 READWRITE(SCALE=2 * pi / 65536, UNIT="rad")',
        "limited": "signed 8 READWRITE(SCALE=0.5, MIN=-5.25, MAX=12)",
        "half": "signed 8 READWRITE(MAX=50)",
        "warm": "float READWRITE(MIN=-1.5, MAX=1e6)",
        "far": "unsigned 64 READWRITE(MIN=3)",
    }
    for name, text in scaled.items():
        lines.append(f"@{name} = {address}: {text};")
        address += 1 if " 8 " in text else -(-64 // word_bits)
    lines += [
        f"@enable = {address}[0]: bool READWRITE();",
        f"@level = {address}[5:1]: signed READWRITE();",
        f"@rest = {address}[7:6]: unsigned READWRITE();",
        f"@status = {address + 1}: READ();",
        f"@command = {address + 1}: WRITE();",
        f"@near[3] = {address + 2} + i: signed 8 READWRITE(SCALE=0.25 * (i + 1));",
        f"@modes[2] = {address + 5}[4 * i + 3:4 * i]: mode READWRITE();",
        f"@shapes[3] = {address + 6} + i[i + 1:0]: READWRITE();",
        f"arms[2]: joint() @({address + 9} + 3 * i);",
    ]
    assert address + 15 <= 0x100
    body = "\n".join(f"  {line}" for line in lines)
    return compile_text(
        f"{_ENUMERATION}{_JOINT}/// One of each.\npublic robot() {{\n  GATEWAY(DATA_BITS={word_bits});\n{body}\n}}\n"
    )


def written(interface: Interface) -> Iterator[tuple[Signal, Value]]:
    """Yield each signal that can be written and read back, with each of many values that it accepts."""
    for signal in interface.signals.values():
        if signal.access is Access.READWRITE:
            for value in good_values(signal):
                yield signal, value


def good_values(signal: Signal) -> list[Value]:
    """Return values of a signal: the ends of its range, its limits, values around 0, and random ones."""
    kind, low, high = signal.kind, *signal.limits
    chance = random.Random(signal.path)
    raws = {0, 1, (1 << kind.width) - 1, 1 << kind.width - 1, (1 << kind.width - 1) - 1}
    raws |= {chance.getrandbits(kind.width) for _ in range(RANDOM_VALUES)}
    values = [kind.decode(raw & (1 << kind.width) - 1) for raw in sorted(raws)]
    if not (math.isfinite(low) and math.isfinite(high)):
        values += [low, high]
    else:
        values += [low, high] if kind.is_float else [math.ceil(low), math.floor(high)]
    return [value for value in values if low <= value <= high]


def bad_values(signal: Signal) -> list[float]:
    """Return numbers that a signal must refuse."""
    if signal.kind.name is KindName.FLOAT:
        limits = [] if signal.minimum is None else [signal.minimum - 1]
        limits += [] if signal.maximum is None else [2 * signal.maximum]
        return [*limits, math.nan] if limits else []
    step = abs(signal.kind.step) if signal.kind.is_float else 1
    low, high = signal.limits
    return [value for value in (low - step, high + step) if abs(value) < 1 << 53]
