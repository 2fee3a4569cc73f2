"""The configuration of a gateway: the fields of its answer to `Q` (docs/protocol.md, "Configuration").

The widths of all messages follow from it. A host therefore sends `Q` first.
"""

from __future__ import annotations

import enum

import msgspec

from unity_link.errors import UnsupportedError
from unity_link.protocol.wire.crc import last_session

PROTOCOL_VERSION = 3
HEX_DIGITS = b"0123456789ABCDEFabcdef"


class Feature(enum.IntFlag):
    """Features that a gateway was built with.

    A feature has the same name in C (`UL_FEATURE_...`), in MATLAB (a field of `features`), in VHDL (`feature_...`, and
    the generic that enables it), and as text.
    """

    GROUPS = 1
    """The gateway samples groups of words at a rate of its own."""
    EXTERNAL_TRIGGERS = 2
    """Inputs of the gateware can trigger the sampling of groups. The generic is `triggers`."""
    TIMESTAMPS = 4
    """Samples can contain the instant of sampling."""
    SEND_IMMEDIATE = 8
    """The gateway can make the USB chip send its buffer at once."""
    FLOW_CONTROL = 16
    """The medium stops the host while the gateway's receive FIFO is full, so that no byte is lost there."""
    MASKED_WRITE = 32
    """The gateway can write some bits of a word, in one bus transaction."""
    QUEUE_COMMANDS = 64
    """The gateway can read many words from one address, or write many words to it."""
    ADDRESSED = 128
    """The gateway shares its medium with others, and its frames contain its node number."""
    FINGERPRINT = 256
    """The build identifier is the fingerprint of a spec's map."""
    HALF_DUPLEX = 512
    """Only one side of the line may send at a time."""
    DESCRIPTION = 1024
    """The highest addresses contain a description: the spec from which the gateway was generated."""
    COMPACT = 2048
    """The gateway accepts and sends the frames of a session in compact form."""

    @property
    def words(self) -> str:
        """The names of the features as text: ``masked write, queue commands``."""
        return ", ".join((feature.name or "unknown").lower().replace("_", " ") for feature in self)


class GatewayInfo(msgspec.Struct, frozen=True, kw_only=True):
    """The configuration of one gateway. The defaults are those of the gateware, but with the most groups possible."""

    protocol_version: int = PROTOCOL_VERSION
    """Version of the protocol."""
    data_bits: int = 32
    """Width of a word, 8 to 64 bits."""
    address_bits: int = 8
    """Width of an address, 8 to 32 bits. Addresses count words."""
    id_digits: int = 3
    """Hex digits of a message ID, 2 or 3."""
    crc_bits: int = 16
    """Width of the CRC of a frame, 8, 16 or 32 bits."""
    crc_polynomial: int = 0x1021
    """Polynomial of the CRC, without its highest bit."""
    block_words: int = 255
    """Most words in one block or queue request."""
    groups: int = 256
    """Number of publish groups, 0 to 256."""
    group_words: int = 255
    """Most addresses in one group."""
    base_frequency_millihertz: int = 100_000_000
    """Base publish frequency in mHz; the rate of a group is this frequency divided by an integer."""
    clock_hz: int = 50_000_000
    """Clock of the gateway in Hz: the unit of timestamps."""
    receive_fifo_bytes: int = 256
    """Bytes from the host that the gateway can buffer."""
    transmit_fifo_bytes: int = 256
    """Bytes to the host that the gateway can buffer."""
    features: Feature = Feature(0x7F)
    """Features that the gateway was built with."""
    build_id: int = 0
    """Build identifier, chosen at synthesis."""

    @property
    def address_digits(self) -> int:
        """Hex digits of an address."""
        return -(-self.address_bits // 4)

    @property
    def data_digits(self) -> int:
        """Hex digits of a word."""
        return -(-self.data_bits // 4)

    @property
    def session_digits(self) -> int:
        """Hex digits of a session number."""
        return min(self.crc_bits // 4, 4)

    @property
    def last_session(self) -> int:
        """Highest session number."""
        return last_session(self.crc_bits // 4)

    @property
    def asks_compact(self) -> int:
        """Bit that a host adds to the session number in `K i s` to request the compact form."""
        return self.last_session + 1

    @property
    def base_frequency_hz(self) -> float:
        """Base publish frequency in Hz."""
        return self.base_frequency_millihertz / 1000

    def block_words_in(self, longest_frame: int) -> int:
        """Return the most words of a block whose request and answer each fit in `longest_frame` bytes."""
        around = 4 + self.id_digits + self.address_digits + self.crc_bits // 4 + 1
        return max(min(self.block_words, (longest_frame - around) // self.data_digits), 1)

    @property
    def longest_request(self) -> int:
        """Characters of the longest checked request that this gateway accepts, without the line end."""
        head = 2 + self.id_digits
        lengths = [
            head + self.address_digits + 2,
            head + self.address_digits + self.data_digits * max(self.block_words, 1),
        ]
        if Feature.MASKED_WRITE in self.features:
            lengths.append(head + self.address_digits + 2 * self.data_digits)
        if Feature.GROUPS in self.features:
            lengths.append(head + 10 + self.address_digits * self.group_words)
        return max(lengths) + self.crc_bits // 4

    def to_hex(self) -> bytes:
        """Return the fields of the answer to `Q` as hex digits."""
        return b"".join(b"%0*X" % (digits, int(getattr(self, name))) for name, digits in FIELDS)

    @classmethod
    def from_hex(cls, text: bytes) -> GatewayInfo:
        """Decode the fields of the answer to `Q`; digits after the known fields are ignored.

        Raises:
            UnsupportedError: for another protocol version, or a value that the protocol does not allow.
            ValueError: if `text` is too short, or has a character that is no hex digit.
        """
        values: dict[str, int] = {}
        position = 0
        for name, digits in FIELDS:
            field = text[position : position + digits]
            if len(field) != digits or field.strip(HEX_DIGITS):
                raise ValueError(f"an answer to Q of {_TOTAL_DIGITS} hex digits was expected, not {text[:80]!r}")
            values[name] = int(field, 16)
            position += digits
            if name == "protocol_version" and values[name] != PROTOCOL_VERSION:
                raise UnsupportedError(
                    f"the gateway speaks version {values[name]:02X} of the protocol and this program version "
                    f"{PROTOCOL_VERSION:02X}: build the gateway anew with this version of unity-link, or install one "
                    f"that speaks {values[name]:02X}"
                )
        info = cls(**{**values, "features": Feature(values["features"])})  # type: ignore[arg-type]
        info.check()
        return info

    def check(self) -> None:
        """Raise `UnsupportedError` if a field has a value that the protocol does not allow."""
        for name, low, high in _RANGES:
            value = int(getattr(self, name))
            if not low <= value <= high:
                raise UnsupportedError(f"the gateway reports {name} = {value}, expected {low} to {high}")
        if Feature.GROUPS in self.features and self.base_frequency_millihertz == 0:
            raise UnsupportedError(
                f"the gateway reports base_frequency_millihertz = 0, expected 1 to {_MOST_MILLIHERTZ} as it has groups"
            )
        if self.crc_bits not in (8, 16, 32) or not 0 < self.crc_polynomial < 1 << self.crc_bits:
            raise UnsupportedError(
                f"the gateway reports a CRC of {self.crc_bits} bits with polynomial {self.crc_polynomial:#x}, "
                "expected 8, 16 or 32 bits and a polynomial that fits"
            )
        if Feature.COMPACT in self.features and self.data_digits % 2:
            raise UnsupportedError(
                f"the gateway reports the compact form and data_bits = {self.data_bits}, expected words with an even "
                "number of hex digits"
            )


FIELDS = (
    ("protocol_version", 2),
    ("data_bits", 2),
    ("address_bits", 2),
    ("id_digits", 2),
    ("crc_bits", 2),
    ("crc_polynomial", 8),
    ("block_words", 2),
    ("groups", 4),
    ("group_words", 2),
    ("base_frequency_millihertz", 10),
    ("clock_hz", 8),
    ("receive_fifo_bytes", 4),
    ("transmit_fifo_bytes", 4),
    ("features", 4),
    ("build_id", 8),
)
"""Names and hex digits of the fields of the answer to `Q`, in their order."""
_MOST_MILLIHERTZ = 16**10 - 1
_TOTAL_DIGITS = sum(digits for _, digits in FIELDS)
_RANGES = (
    ("data_bits", 8, 64),
    ("address_bits", 8, 32),
    ("id_digits", 2, 3),
    ("block_words", 1, 255),
    ("groups", 0, 256),
    ("group_words", 0, 255),
    ("base_frequency_millihertz", 0, _MOST_MILLIHERTZ),
    ("clock_hz", 1, 0xFFFF_FFFF),
    ("receive_fifo_bytes", 0, 0xFFFF),
    ("transmit_fifo_bytes", 0, 0xFFFF),
    ("features", 0, 0xFFFF),
    ("build_id", 0, 0xFFFF_FFFF),
)
