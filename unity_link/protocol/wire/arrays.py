"""Words and frames as arrays of numpy, for batches, blocks and samples.

numpy is slow to import, so other modules write ``wire.arrays``, which imports this module at the first use: by the
first batch, block or subscription, before any of it is sent, and by a server when it starts.
"""

from __future__ import annotations

from binascii import hexlify, unhexlify
from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, TypeAlias, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from unity_link.errors import ArgumentError, shown
from unity_link.protocol.wire.crc import Crc, byte_table
from unity_link.protocol.wire.frames import LF
from unity_link.protocol.wire.numbers import whole_number

if TYPE_CHECKING:
    from unity_link.protocol.wire.configuration import GatewayInfo
    from unity_link.protocol.wire.frames import Framing

Words: TypeAlias = NDArray[np.unsignedinteger[Any]]
_FEWEST_ROWS = 20
"""Fewest frames for which numpy is faster than a loop."""
_ROWS_TOGETHER = 64
"""Most rows that share one array; a program that keeps one row keeps the memory of all of them."""
_CRC_TYPES: dict[int, type[np.unsignedinteger]] = {8: np.uint8, 16: np.uint16, 32: np.uint32}
_HEX_OF_BYTE = np.frombuffer(b"".join(b"%02X" % value for value in range(256)), np.uint16)
"""The two hex digits of each byte, as one number of 16 bits in the order of the memory."""


# Numbers


class _Form(NamedTuple):
    """The smallest types of numpy for numbers of some hex digits."""

    padding: int
    """Leading zeros that fill the type: its hex digits, less those of the numbers."""
    sent: np.dtype[np.unsignedinteger[Any]]
    """Big-endian type, in the order of the digits."""
    held: np.dtype[np.unsignedinteger[Any]]
    """Type in the order of this machine."""


def _form(digits: int) -> _Form:
    octets = next(size for size in (1, 2, 4, 8) if 2 * size >= digits)
    return _Form(2 * octets - digits, np.dtype(f">u{octets}"), np.dtype(f"u{octets}"))


_FORMS = {digits: _form(digits) for digits in range(1, 17)}


def word_type(digits: int) -> np.dtype[np.unsignedinteger[Any]]:
    """Return the smallest type for numbers of `digits` hex digits."""
    return _FORMS[digits].held


def zeros(count: int, digits: int) -> Words:
    """Return `count` zeros, of the smallest type for numbers of `digits` hex digits."""
    return np.zeros(count, _FORMS[digits].held)


def of_words(words: Sequence[int], digits: int) -> Words:
    """Return words as an array, of the smallest type for numbers of `digits` hex digits."""
    return np.array(words, _FORMS[digits].held)


def in_range(values: ArrayLike, highest: int, what: str) -> NDArray[Any]:
    """Return whole numbers from 0 to `highest` as an array, shape (n,).

    Args:
        values: the numbers.
        highest: the upper limit.
        what: name of one number, for the error.

    Raises:
        ArgumentError: if they are not such numbers.
    """
    try:
        array = np.asarray(values)
        if array.dtype.kind == "O" or (array.dtype.kind not in "iu" and isinstance(values, Sequence)):
            # numpy would convert a list with numbers below and above 2**63 to floats.
            array = np.array([whole_number(value, what) for value in cast("Sequence[int]", values)], object)
    except (ArgumentError, TypeError, ValueError):
        array = np.array(None)
    if array.ndim != 1 or (array.size and array.dtype.kind not in "iuO"):
        raise ArgumentError(f"a sequence of whole numbers was expected for each {what}, not {shown(values)}")
    if array.size:
        low, high = int(array.min()), int(array.max())
        if low < 0 or high > highest:
            raise ArgumentError(f"{what} {low if low < 0 else high:#x} is not from 0 to {highest:#x}")
    return array


def joined(parts: Sequence[Words]) -> Words:
    """Return the words of several arrays, in order, as one array."""
    return parts[0] if len(parts) == 1 else np.concatenate(parts)


# Hex digits


def hex_rows(values: ArrayLike, digits: int) -> NDArray[np.uint8]:
    """Return numbers as upper-case hex digits, shape (n, digits)."""
    form = _FORMS[digits]
    # Give a type: numpy would convert a list with numbers below and above 2**63 to floats.
    numbers = values if isinstance(values, np.ndarray) else np.asarray(values, np.uint64)
    raw = numbers.astype(form.sent, copy=False).tobytes()
    return np.frombuffer(hexlify(raw).upper(), np.uint8).reshape(-1, digits + form.padding)[:, form.padding :]


def hex_columns(columns: Sequence[tuple[NDArray[Any], int]]) -> NDArray[np.uint8]:
    """Return the hex digits of several columns of numbers, concatenated row by row.

    Args:
        columns: the numbers of each column, shape (n,), and their number of hex digits.
    """
    rows = [hex_rows(values, digits) for values, digits in columns]
    return rows[0] if len(rows) == 1 else np.concatenate(rows, axis=1)


def parse_rows(rows: NDArray[np.uint8]) -> Words:
    """Return the numbers of rows of hex digits, shape (n, digits), as an array, shape (n,).

    Raises:
        ValueError: if a character is no hex digit.
    """
    form = _FORMS[rows.shape[1]]
    if form.padding:
        padded = np.full((len(rows), form.padding + rows.shape[1]), ord("0"), np.uint8)
        padded[:, form.padding :] = rows
        rows = padded
    return np.frombuffer(unhexlify(rows.tobytes()), form.sent).astype(form.held)


def apart(values: Words) -> list[Words]:
    """Return the rows of an array, copied in groups of `_ROWS_TOGETHER`, so that a kept row keeps little memory.

    An array of at most one group is not copied; it must not be a view of a larger array.
    """
    if len(values) <= _ROWS_TOGETHER:
        return list(values)
    starts = range(0, len(values), _ROWS_TOGETHER)
    return [row for start in starts for row in values[start : start + _ROWS_TOGETHER].copy()]


def parse_words(text: bytes, digits: int) -> Words:
    """Return the numbers in `text`, each of `digits` hex digits, without separators; shape (n,).

    Raises:
        ValueError: if a character is no hex digit, or the last number is cut.
    """
    form = _FORMS[digits]
    if form.padding:
        return parse_rows(np.frombuffer(text, np.uint8).reshape(-1, digits))
    return np.frombuffer(unhexlify(text), form.sent).astype(form.held)


# Frames


def rows_of(data: bytes, start: int, count: int, size: int) -> NDArray[np.uint8]:
    """Return `count` consecutive frames of `size` bytes from the offset `start` on, shape (count, size)."""
    return np.frombuffer(data, np.uint8, count * size, start).reshape(count, size)


def crc_rows(crc: Crc, rows: NDArray[np.uint8], begun: int = 0) -> NDArray[np.uint8]:
    """Return the CRC of each row of bytes, shape (n, length), as hex digits, shape (n, digits).

    With an initial value of 0 the CRC is linear: it is the xor of one table entry for each column. Another initial
    value xors the same constant into all rows.

    Args:
        crc: the CRC of the gateway.
        rows: the bytes.
        begun: initial value of the CRC of each row.
    """
    table, places = _begun_table(crc.bits, crc.polynomial, rows.shape[1], begun)
    # Transposed, because numpy reduces few long rows faster than many short ones.
    crcs = np.bitwise_xor.reduce(table.take(rows.T + places), axis=0)
    octets = crcs.astype(crcs.dtype.newbyteorder(">")).view(np.uint8)
    digits: NDArray[np.uint8] = _HEX_OF_BYTE.take(octets).view(np.uint8).reshape(-1, crc.digits)
    return digits


@lru_cache(maxsize=64)
def _begun_table(
    bits: int, polynomial: int, length: int, begun: int
) -> tuple[NDArray[np.unsignedinteger], NDArray[np.intp]]:
    """Return the tables of `_column_table` for an initial value, whose constant is xored into the first column."""
    table, places = _column_table(bits, polynomial, length)
    if not begun:
        return table, places
    table = table.copy()
    table[:256] ^= table.dtype.type(Crc(bits, polynomial).of(bytes(length), begun))
    return table, places


@lru_cache(maxsize=64)
def _column_table(bits: int, polynomial: int, length: int) -> tuple[NDArray[np.unsignedinteger], NDArray[np.intp]]:
    """Return the contribution of each byte in each column to the CRC of a row, and the offset of each column in it.

    The contributions have the shape (length * 256,), the offsets (length, 1).
    """
    step = np.array(byte_table(bits, polynomial), _CRC_TYPES[bits])
    columns = np.empty((length, 256), _CRC_TYPES[bits])
    columns[-1] = step
    for column in range(length - 2, -1, -1):
        after = columns[column + 1]
        # The column is followed by one more byte, so its remainder is shifted by eight bits.
        columns[column] = (after << 8 if bits > 8 else 0) ^ step[after >> bits - 8]
    return columns.ravel(), np.arange(0, columns.size, 256)[:, None]


def _count_alike(rows: NDArray[np.uint8], expected: NDArray[np.uint8]) -> int:
    """Return the number of rows before the first that differs from the expected row."""
    alike = rows == expected
    return len(rows) if alike.all() else int(alike.all(axis=1).argmin())


def open_rows(framing: Framing, rows: NDArray[np.uint8], head: bytes, seed: int = 0) -> NDArray[np.uint8]:
    """Return the bodies of checked frames of one length, up to the first that is damaged or begins otherwise.

    Args:
        framing: framing of the gateway.
        rows: the frames with their LF, shape (n, length).
        head: characters with which each frame must begin, with the prefix of the node.
        seed: seed of their session and direction.

    Returns:
        The bodies, shape (m, length of a body).
    """
    start, end = len(framing.prefix), rows.shape[1] - framing.crc.digits - len(LF)
    expected = rows.copy()
    expected[:, : len(head)] = np.frombuffer(head, np.uint8)
    expected[:, end : -len(LF)] = crc_rows(framing.crc, rows[:, start:end], framing.begun ^ seed)
    expected[:, -1] = LF[0]
    return rows[: _count_alike(rows, expected), start:end]


class FrameCodec(Protocol):
    """The part of `messages.Codec` that this module uses."""

    info: GatewayInfo
    framing: Framing
    id_count: int
    """Number of IDs."""
    lower: dict[str, bytes]
    """Letters of each command in a frame with an ID."""

    def request(self, command: str, number: int, fields: bytes, seed: int = 0) -> bytes:
        """Return the checked frame of a request with an ID, with the seed of its session."""


@lru_cache
def _id_rows(digits: int) -> NDArray[np.uint8]:
    """Return the digits of all IDs twice, so that IDs that wrap around are one slice; shape (2 * IDs, digits)."""
    return np.tile(hex_rows(np.arange(16**digits), digits), (2, 1))


def _ids(codec: FrameCodec, first: int, count: int) -> NDArray[np.uint8]:
    """Return the digits of `count` consecutive IDs, shape (count, digits)."""
    return _id_rows(codec.info.id_digits)[first : first + count]


def request_rows(codec: FrameCodec, command: str, first: int, fields: NDArray[np.uint8], seed: int = 0) -> bytes:
    """Return the checked frames of many requests of one command with consecutive IDs.

    Args:
        codec: message codec of the gateway.
        command: the command, in upper case.
        first: ID of the first request.
        fields: hex digits of the fields, shape (n, width).
        seed: seed of their session and direction.
    """
    count = len(fields)
    if count < _FEWEST_ROWS:
        text, width = fields.tobytes(), fields.shape[1]
        return b"".join(
            codec.request(command, first + place & codec.id_count - 1, text[place * width : (place + 1) * width], seed)
            for place in range(count)
        )
    framing = codec.framing
    head = np.frombuffer(framing.prefix + codec.lower[command], np.uint8)
    covered = np.concatenate((np.broadcast_to(head, (count, len(head))), _ids(codec, first, count), fields), axis=1)
    checks = crc_rows(framing.crc, covered[:, len(framing.prefix) :], framing.begun ^ seed)
    ends = np.full((count, 1), LF[0], np.uint8)
    return np.concatenate((covered, checks, ends), axis=1).tobytes()


def matching_rows(
    codec: FrameCodec, command: str, first: int, data: bytes, digits: int, seed: int = 0
) -> NDArray[np.uint8]:
    """Check the frames of requests or responses of one command with consecutive IDs.

    Args:
        codec: message codec of the gateway.
        command: the command, in upper case.
        first: ID of the first frame.
        data: complete frames of equal size.
        digits: characters between the ID and the CRC.
        seed: seed of their session and direction.

    Returns:
        The characters between ID and CRC, shape (n, digits), of the frames before the first unexpected one.
    """
    framing = codec.framing
    head = np.frombuffer(framing.prefix + codec.lower[command], np.uint8)
    crc_digits = framing.crc.digits
    before = len(head) + codec.info.id_digits
    rows = np.frombuffer(data, np.uint8).reshape(-1, before + digits + crc_digits + 1)
    expected = rows.copy()
    expected[:, : len(head)] = head
    expected[:, len(head) : before] = _ids(codec, first, len(rows))
    body = rows[:, len(framing.prefix) : before + digits]
    expected[:, -1 - crc_digits : -1] = crc_rows(framing.crc, body, framing.begun ^ seed)
    expected[:, -1] = LF[0]
    return rows[: _count_alike(rows, expected), before : before + digits]


def response_rows(codec: FrameCodec, command: str, first: int, data: bytes, digits: int, seed: int = 0) -> Words | None:
    """Decode the responses to many requests of one command with consecutive IDs.

    Args:
        codec: message codec of the gateway.
        command: the command, in upper case.
        first: ID of the first response.
        data: complete frames of equal size.
        digits: hex digits after the ID: those of one word, or 0.
        seed: seed of the session, for frames of a gateway.

    Returns:
        The words of the frames before the first unexpected one, shape (n,); zeros if `digits` is 0. None if the first
        frame is unexpected.
    """
    rows = matching_rows(codec, command, first, data, digits, seed)
    if not len(rows):
        return None
    if not digits:
        return zeros(len(rows), codec.info.data_digits)
    try:
        return parse_rows(rows)
    except ValueError:
        return None
