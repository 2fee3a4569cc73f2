"""Kinds: the meaning of a signal's bits, and the conversion between bits and values.

A `Kind` has no address. Its *raw* is the unsigned number in the signal's bits; its *value* is the number that a program
uses, in the signal's unit. The conversion is exact: `encode(decode(raw)) == raw` for every raw. The checker rejects
scales that would give two raws the same float (`is_exact`). `encode` rounds a value to the nearest raw.
"""

from __future__ import annotations

import enum
import functools
import math
import operator
import struct
from typing import TYPE_CHECKING, Any, TypeAlias

import msgspec
import numpy as np

from unity_link.errors import ArgumentError, shown
from unity_link.spec.diagnostics import Span  # noqa: TC001  (msgspec reads the annotations)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

Value: TypeAlias = bool | int | float
"""Value of a signal in a program; for an enumeration a member of its `IntEnum`, or a number that has no name."""

MOST_BITS = 64
MOST_WRAPPED = 48
"""Most bits of a number with WRAPS: a float then has 32 exact rounds (53 bits), and an int64 has 32,768."""
_NATIVE_BITS = (8, 16, 32, 64)
"""Widths of integers that processors and numpy have."""
FLOAT_BITS = {16: "<e", 32: "<f", 64: "<d"}
"""Widths of IEEE 754 numbers in bits, with their `struct` formats."""
_FLOAT_MARGIN = 2.0**-50
"""Smallest step relative to the largest number: eight roundings of 2**-53 then stay below half a step."""


class KindName(enum.StrEnum):
    """Words for kinds in a spec; a signal of kind `ENUM` has the name of its enumeration instead."""

    BOOL = "bool"
    UNSIGNED = "unsigned"
    SIGNED = "signed"
    FLOAT = "float"
    FIXED = "fixed"
    UFIXED = "ufixed"
    ENUM = "enum"


WITHOUT_SCALE = {KindName.BOOL, KindName.ENUM, KindName.FLOAT}


class EnumValue(msgspec.Struct, frozen=True):
    """One name of an enumeration."""

    name: str
    value: int
    doc: str = ""


class Enumeration(msgspec.Struct, frozen=True):
    """Names of numbers; the numbers are not negative and differ."""

    name: str
    values: tuple[EnumValue, ...]
    doc: str = ""
    span: Span | None = None

    @property
    def largest(self) -> int:
        """The largest number that has a name."""
        return max(value.value for value in self.values)

    @property
    def names(self) -> str:
        """All names with their numbers, sorted by number: ``off = 0, on = 1``."""
        named = sorted((value.value, value.name) for value in self.values)
        return ", ".join(f"{name} = {number}" for number, name in named)

    @property
    def python_type(self) -> type[NamedNumber]:
        """The enumeration as a Python class; the class is cached."""
        return _python_type(self)


class NamedNumber(enum.IntEnum):
    """A number of an enumeration, which also compares equal to its name: ``mode == "balance"``.

    ``print(mode)`` shows the name ``balance``, and ``f"{mode:d}"`` the number. The hash is that of the number, so that
    sets and dictionaries do not find the name.

    Raises:
        ArgumentError: if it is compared with a string that is not a name of the enumeration.
    """

    def __eq__(self, other: object) -> bool:
        return int(self) == (number_named(type(self), other) if isinstance(other, str) else other)

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __str__(self) -> str:
        return self.name

    __hash__ = int.__hash__


class NamedNumbers(np.ndarray[Any, np.dtype[Any]]):
    """Numbers of an enumeration as an array, which also compares with names: ``column == "balance"``.

    One element is a `NamedNumber`, or an `int` if the number has no name.

    Raises:
        ArgumentError: if it is compared with a string that is not a name of the enumeration.
    """

    names: type[NamedNumber] | None = None

    def __array_finalize__(self, made_from: object) -> None:
        self.names = getattr(made_from, "names", None)

    def __getitem__(self, key: Any) -> Any:
        found = super().__getitem__(key)
        if self.names is None or isinstance(found, np.ndarray):
            return found
        return _named(self.names, int(found))

    def __eq__(self, other: object) -> Any:
        return np.asarray(self) == self._number(other)

    def __ne__(self, other: object) -> Any:
        return np.asarray(self) != self._number(other)

    __hash__ = None

    def _number(self, other: object) -> Any:
        return number_named(self.names, other) if self.names is not None and isinstance(other, str) else other


def _named(names: type[NamedNumber], number: int) -> int:
    """Return the member of an enumeration that has a number; a number without a name is returned unchanged."""
    return names(number) if number in names.__members__.values() else number


def name_of(value: Value) -> str:
    """Return the name of a value of an enumeration; any other value as text."""
    return str(getattr(value, "name", value))


def number_named(names: type[enum.IntEnum], name: str) -> int:
    """Return the number of a name of an enumeration.

    A generated class appends one or two underscores to names that Python reserves; both spellings are accepted.

    Raises:
        ArgumentError: if the enumeration does not have the name.
    """
    members = names.__members__
    found = next((members[one] for one in (name, f"{name}_", f"{name}__") if one in members), None)
    if found is None:
        raise ArgumentError(f"{name!r} is no value of {names.__name__}: {', '.join(members)} are")
    return int(found)


@functools.cache
def _python_type(enumeration: Enumeration) -> type[NamedNumber]:
    members = {value.name: value.value for value in enumeration.values}
    made: type[NamedNumber] = NamedNumber(enumeration.name, members)  # type: ignore[call-arg, assignment, arg-type]

    def reduce(member: enum.Enum, _: object) -> tuple[object, ...]:
        return _member, (enumeration, member.value)

    # Pickle by value: pickle would look up the class in a module, but this class is in none.
    made.__reduce_ex__ = reduce  # type: ignore[assignment, method-assign]
    return made


def _member(enumeration: Enumeration, number: int) -> NamedNumber:
    """Return the member that a pickle stores as an enumeration and a number."""
    return _python_type(enumeration)(number)


class Kind(msgspec.Struct, frozen=True, dict=True):
    """Meaning of the bits of a signal.

    A value is ``number * scale + offset``; `number` is the whole, fixed-point or floating-point number in the bits.
    """

    name: KindName
    width: int
    """Width in bits, 1 to 64."""
    fraction: int = 0
    """Bits after the binary point, for `FIXED` and `UFIXED`."""
    scale: float = 1
    offset: float = 0
    enumeration: Enumeration | None = None
    wraps: bool = False
    """True if the number overflows to its other end, and the host extends the values beyond the range."""

    def __str__(self) -> str:
        """Return the kind in the syntax of a spec."""
        if self.name is KindName.BOOL:
            return "bool"
        if self.enumeration is not None:
            return f"{self.enumeration.name} {self.width}"
        if self.name in {KindName.FIXED, KindName.UFIXED}:
            return f"{self.name} {self.width - self.fraction}.{self.fraction}"
        return f"{self.name} {self.width}"

    @functools.cached_property
    def is_signed(self) -> bool:
        """Return whether the raw is in two's complement."""
        return self.name in {KindName.SIGNED, KindName.FIXED}

    @functools.cached_property
    def is_scaled(self) -> bool:
        """Return whether the value is a multiple of a scale or binary fraction, so that it is a float."""
        return self.scale != 1 or self.offset != 0 or self.name in {KindName.FIXED, KindName.UFIXED}

    @functools.cached_property
    def is_float(self) -> bool:
        """Return whether the value is a float."""
        return self.is_scaled or self.name is KindName.FLOAT

    @functools.cached_property
    def step(self) -> float:
        """Change of the value for a change of the raw by one; meaningless for floats."""
        return math.ldexp(self.scale, -self.fraction)

    @functools.cached_property
    def span(self) -> int | float:
        """Change of the value over one full round of the raw."""
        return (1 << self.width) * (abs(self.step) if self.is_scaled else 1)

    def within(self, value: float) -> float:
        """Return the value in the range that differs from a value by whole spans; it may lie between two raws."""
        low, high = self.range
        return value if low <= value <= high else value - self.span * math.floor((value - low) / self.span)

    def wrapped(self, value: float) -> float:
        """Return the value of the nearest raw after removing whole spans from a value."""
        low, _ = self.raw_range
        number = self._nearest(value) if self.is_scaled else self._whole(value)
        return self._scaled((number - low) % (1 << self.width) + low)

    @functools.cached_property
    def raw_range(self) -> tuple[int, int]:
        """Smallest and largest whole number in the bits, sign included."""
        if self.is_signed:
            return -1 << self.width - 1, (1 << self.width - 1) - 1
        return 0, (1 << self.width) - 1

    @functools.cached_property
    def range(self) -> tuple[float, float]:
        """Smallest and largest value; for floats minus and plus infinity."""
        if self.name is KindName.FLOAT:
            return -math.inf, math.inf
        low, high = (self._scaled(number) for number in self.raw_range)
        return min(low, high), max(low, high)

    @functools.cached_property
    def dtype(self) -> np.dtype[Any]:
        """The numpy type of an array of values."""
        if self.name is KindName.FLOAT:
            return np.dtype(f"f{self.width // 8}")
        if self.is_scaled:
            return np.dtype(np.float64)
        if self.name is KindName.BOOL:
            return np.dtype(np.bool_)
        if self.wraps:
            return np.dtype(np.int64)
        size = next(bytes_ for bytes_ in (1, 2, 4, 8) if self.width <= 8 * bytes_)
        return np.dtype(f"{'i' if self.is_signed else 'u'}{size}")

    def is_exact(self) -> bool:
        """Return whether every raw has a different value: the 53 bits of a double hold value and offset together."""
        if not self.is_scaled:
            return True
        step = abs(self.step)
        if not 1e-290 < step < 1e290 or not math.isfinite(self.offset):
            return False
        most = max(max(abs(number) for number in self.raw_range) * step, abs(self.offset))
        return most * _FLOAT_MARGIN <= step

    # One value

    def _scaled(self, number: int) -> float:
        return number * self.step + self.offset if self.is_scaled else number

    def decode(self, raw: int) -> Value:
        """Return the value of a raw, an unsigned number of `width` bits."""
        if self.name is KindName.FLOAT:
            value: float = struct.unpack(FLOAT_BITS[self.width], raw.to_bytes(self.width // 8, "little"))[0]
            return value
        if self.name is KindName.BOOL:
            return raw != 0
        if self.enumeration is not None:
            return _named(self.enumeration.python_type, raw)
        number = raw - (1 << self.width) if self.is_signed and raw >> (self.width - 1) else raw
        return self._scaled(number)

    def encode(self, value: Value | str) -> int:
        """Return the raw of a value; for an enumeration also of a name.

        Raises:
            ArgumentError: for a value that the kind cannot represent.
        """
        if isinstance(value, str):
            return self._encode_name(value)
        if self.name is not KindName.BOOL and isinstance(value, (bool, np.bool_)):
            raise self._no_truth(value)
        if self.name is KindName.FLOAT:
            return self._encode_float(value)
        number = self._nearest(value) if self.is_scaled else self._whole(value)
        low, high = self.raw_range
        if not low <= number <= high:
            first, last = self.range
            raise ArgumentError(f"{shown(value)} is outside of {first:.12g} to {last:.12g}, the range of {self}")
        return number & ((1 << self.width) - 1)

    def _encode_name(self, name: str) -> int:
        if self.enumeration is None:
            raise ArgumentError(f"{name!r} is no value of {self}: a number was expected")
        return number_named(self.enumeration.python_type, name)

    def _no_truth(self, value: object) -> ArgumentError:
        """Return the error for a bool that is given as a number: `True` as a speed of 1 would be full speed."""
        return ArgumentError(f"{value} is no value of {self}: a number was expected")

    def _encode_float(self, value: float) -> int:
        try:
            packed = struct.pack(FLOAT_BITS[self.width], value)
        except (OverflowError, struct.error) as error:
            # `struct` raises its own error for an int that is larger than all floats.
            if isinstance(error, OverflowError) or isinstance(value, int):
                raise ArgumentError(f"{shown(value)} is too large for {self}") from None
            raise ArgumentError(f"{shown(value)} is no value of {self}: a number was expected") from None
        return int.from_bytes(packed, "little")

    def _nearest(self, value: float) -> int:
        try:
            number = float(value)
        except (TypeError, ValueError, OverflowError):
            raise ArgumentError(f"{shown(value)} is no value of {self}: a number was expected") from None
        if not math.isfinite(number):
            raise ArgumentError(f"{shown(value)} is no value of {self}: a finite number was expected")
        steps = (number - self.offset) / self.step
        return round(steps) if math.isfinite(steps) else 1 << MOST_BITS

    def _whole(self, value: float) -> int:
        # Accept floats without a fraction: numpy and notebooks produce many of them. A numpy bool is not an int in
        # Python.
        given: Any = value
        is_whole = isinstance(given, np.bool_) or getattr(given, "is_integer", bool)()
        whole: Any = int(given) if is_whole else given
        try:
            return operator.index(whole)
        except TypeError:
            raise ArgumentError(f"{shown(value)} is no value of {self}: a whole number was expected") from None

    # Many values

    def decode_array(self, raw: NDArray[np.unsignedinteger[Any]]) -> NDArray[Any]:
        """Return the values of an array of raws, as `dtype`; those of an enumeration as `NamedNumbers`."""
        if self.name is KindName.FLOAT:
            return raw.astype(f"u{self.width // 8}").view(self.dtype)
        if self.name is KindName.BOOL:
            truths: NDArray[np.bool_] = raw != 0
            return truths
        if self.enumeration is not None:
            named = raw.astype(self.dtype).view(NamedNumbers)
            named.names = self.enumeration.python_type
            return named
        numbers = self._signed(raw) if self.is_signed else raw
        if not self.is_scaled:
            return numbers.astype(self.dtype)
        values = numbers.astype(np.float64)
        values *= self.step
        values += self.offset
        return values

    def _signed(self, raw: NDArray[np.unsignedinteger[Any]]) -> NDArray[np.signedinteger[Any]]:
        if self.width in _NATIVE_BITS:
            size = self.width // 8
            return raw.astype(f"u{size}", copy=False).view(f"i{size}")
        # Shift the sign bit to the top and back: the arithmetic shift copies it.
        unused = MOST_BITS - self.width
        return (raw.astype(np.uint64, copy=False) << np.uint64(unused)).view(np.int64) >> np.int64(unused)

    def array(self, values: ArrayLike) -> NDArray[Any]:
        """Return values as an array without changing their types or precision.

        Raises:
            ArgumentError: for nested sequences of different lengths.
        """
        if self.name is not KindName.BOOL and isinstance(values, (list, tuple)) and bool in map(type, values):
            # numpy would convert bools in a list with numbers to numbers, so that they could not be refused.
            return np.asarray(values, object)
        try:
            made = np.asarray(values)
        except ValueError:
            raise ArgumentError(f"{shown(values)} are no values of {self}: one array of them was expected") from None
        if made.dtype.kind == "f" and not self.is_float and not hasattr(values, "dtype"):
            # numpy would convert ints to floats if some are negative and others 2**63 or more.
            return np.asarray(values, object)
        return made

    def encode_array(self, values: ArrayLike) -> NDArray[np.uint64]:
        """Return the raws of an array of values of any shape.

        Raises:
            ArgumentError: for a value that the kind cannot represent.
        """
        values = self.array(values)
        if values.dtype.kind not in "biuf":
            # Names, or objects that are not numbers. Encode them one by one: numpy would convert a text such as "1".
            return np.array([self.encode(value) for value in values.ravel().tolist()], np.uint64).reshape(values.shape)
        if values.dtype.kind == "b" and self.name is not KindName.BOOL:
            raise self._no_truth(values.dtype)
        if self.name is KindName.FLOAT:
            return self._encode_floats(values)
        if self.is_scaled:
            with np.errstate(invalid="ignore", over="ignore"):
                numbers = np.rint((values.astype(np.float64) - self.offset) / self.step)
        elif (values.dtype.kind == "f" and np.array_equal(values, np.rint(values))) or values.dtype.kind in "iub":
            numbers = values
        else:
            raise ArgumentError(f"values of {self} are whole numbers, not {values.dtype}")
        low, high = self.raw_range
        # numpy 2 compares Python ints exactly with arrays of any type. A limit of 64 bits has no exact float, so
        # compare floats with the power of two itself.
        good = (
            (numbers >= float(low)) & (numbers < float(high + 1))
            if numbers.dtype.kind == "f"
            else ((numbers >= low) & (numbers <= high))
        )
        if not good.all():
            first, last = self.range
            wrong = np.ravel(values)[np.flatnonzero(~np.ravel(good))[0]]
            raise ArgumentError(f"{shown(wrong)} is outside of {first:.12g} to {last:.12g}, the range of {self}")
        whole = numbers.astype(np.int64) if self.is_signed else numbers.astype(np.uint64)
        mask = np.uint64((1 << self.width) - 1)
        return np.ascontiguousarray(whole).view(np.uint64) & mask

    def _encode_floats(self, values: NDArray[Any]) -> NDArray[np.uint64]:
        with np.errstate(over="ignore"):
            floats = np.ascontiguousarray(values.astype(self.dtype))
        lost = np.isinf(floats) & ~np.isinf(values.astype(np.float64))
        if lost.any():
            raise ArgumentError(f"{np.ravel(values)[np.flatnonzero(np.ravel(lost))[0]]} is too large for {self}")
        return floats.view(f"u{self.width // 8}").astype(np.uint64)
