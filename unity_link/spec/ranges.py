"""Checks that the numbers of a model that was read from a file are ones that a spec could have."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.protocol.wire.numbers import RATE
from unity_link.spec.arguments import ADDRESS_BITS, DATA_BITS, DIVISOR
from unity_link.spec.kinds import FLOAT_BITS, MOST_BITS, MOST_WRAPPED, WITHOUT_SCALE, KindName

if TYPE_CHECKING:
    from unity_link.spec.kinds import Kind
    from unity_link.spec.model import Interface, Signal


def check_ranges(interface: Interface) -> None:
    """Raise `ArgumentError` if a number of the model cannot come from a spec."""
    _check("address_bits", interface.address_bits, *ADDRESS_BITS)
    _check("data_bits", interface.data_bits, *DATA_BITS)
    for signal in interface.signals.values():
        _check_signal(signal, interface)
    for group in interface.groups:
        _check(f"{group.name}: divisor", group.divisor, *DIVISOR)
        _check(f"{group.name}: rate_hz", group.rate_hz, *RATE)


def _check_signal(signal: Signal, interface: Interface) -> None:
    _check_kind(signal.path, signal.kind)
    _check(f"{signal.path}: word_bits", signal.word_bits, interface.data_bits, interface.data_bits)
    # A value longer than a word begins at bit 0.
    _check(f"{signal.path}: lowest_bit", signal.lowest_bit, 0, max(0, signal.word_bits - signal.width))
    _check(f"{signal.path}: address", signal.address, 0, (1 << interface.address_bits) - signal.words)
    _check(f"{signal.path}: poll_hz", signal.poll_hz, *RATE)
    base = None if signal.laps_of is None else interface.signals.get(signal.laps_of)
    if (signal.laps_of is not None or signal.kind.wraps) and not (
        base is not None and base.laps_of == base.path and base.kind == signal.kind and signal.kind.wraps
    ):
        raise ArgumentError(f"{signal.path}: laps_of is {signal.laps_of}, expected a signal of its kind that wraps")


def _check_kind(path: str, kind: Kind) -> None:
    _check(f"{path}: width", kind.width, 1, MOST_BITS)
    if kind.name is KindName.FLOAT and kind.width not in FLOAT_BITS:
        raise ArgumentError(f"{path}: a float has {kind.width} bits, expected 16, 32 or 64")
    _check(f"{path}: fraction", kind.fraction, 0, kind.width)
    if kind.wraps and (kind.name in WITHOUT_SCALE or kind.width > MOST_WRAPPED):
        raise ArgumentError(f"{path}: {kind} wraps, expected a number of at most {MOST_WRAPPED} bits")
    if kind.is_scaled and (kind.name in WITHOUT_SCALE or not kind.is_exact()):
        scaled = f"{kind.scale} and offset {kind.offset}"
        raise ArgumentError(
            f"{path}: scale is {scaled}, expected ones that give each number of {kind} a different value"
        )


def _check(what: str, value: float | None, low: float, high: float) -> None:
    if value is not None and not low <= value <= high:
        expected = f"{low}" if low == high else f"{low} to {high}"
        raise ArgumentError(f"{what} is {value}, expected {expected}")
