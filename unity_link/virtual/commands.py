"""The effect of each request in the virtual gateway, once its frame and its sequence are found right.

Each method checks the ranges (error 06), accesses the bus (04, 05), and returns what was read, if anything.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, TypeAlias

from unity_link.protocol.gateway.reception import group_fits
from unity_link.protocol.wire.messages import ErrorCode

if TYPE_CHECKING:
    from unity_link.protocol.wire.configuration import GatewayInfo
    from unity_link.virtual.bus import ModelBus
    from unity_link.virtual.groups import PublishGroups

Reads: TypeAlias = int | Sequence[int] | None

ADAPTIVE = 2
"""Send-immediate mode after a reset and after `K` (docs/protocol.md, "Send-immediate")."""


class FieldRangeError(Exception):
    """A field that the gateway refuses by error 06."""

    code = ErrorCode.OUT_OF_RANGE


class CommandSet:
    """The requests that need no knowledge of frames and sessions.

    Args:
        info: the gateway's configuration.
        bus: what reads and writes go to.
        groups: what the group commands go to.
    """

    def __init__(self, info: GatewayInfo, bus: ModelBus, groups: PublishGroups) -> None:
        self._info = info
        self._bus = bus
        self._groups = groups
        self._last_address = (1 << info.address_bits) - 1
        self._last_word = (1 << info.data_bits) - 1
        self.for_program = False
        """True in a session that a program began, in which samples are checked frames."""
        self.send_immediate = ADAPTIVE
        """Send-immediate mode of responses; it changes nothing here, as nothing here waits for a full packet."""
        self.run: dict[str, Callable[..., Reads]] = {
            "R": self._read,
            "RM": self._read_block,
            "RQ": self._read_queue,
            "W": self._write,
            "WM": self._write_block,
            "WQ": self._write_queue,
            "WK": self._write_masked,
            "WS": self._write,
            "GS": self._set_group,
            "GN": self._start_group,
            "GX": self._stop_group,
            "GP": self._publish_group,
            "I": self._set_send_immediate,
        }
        """Functions of time and fields by command; return what was read, raise `FieldRangeError` or `AccessError`."""

    def reset(self) -> None:
        """Go back to the state after power-up, as far as it is kept here."""
        self.for_program = False
        self.send_immediate = ADAPTIVE

    def _check(self, address: int, *words: int) -> None:
        if address > self._last_address or any(word > self._last_word for word in words):
            raise FieldRangeError

    def _check_count(self, count: int) -> None:
        if not 1 <= count <= self._info.block_words:
            raise FieldRangeError

    def _check_group(self, number: int) -> None:
        if not self._groups.is_set(number):
            raise FieldRangeError

    def _read(self, now: float, address: int) -> Reads:
        self._check(address)
        return self._bus.read(address, now)

    def _read_block(self, now: float, address: int, count: int) -> Reads:
        self._check(address)
        self._check_count(count)
        return self._bus.read_words(self._bus.block(address, count), now)

    def _read_queue(self, now: float, address: int, count: int) -> Reads:
        self._check(address)
        self._check_count(count)
        return self._bus.read_words([address] * count, now)

    def _write(self, now: float, address: int, word: int) -> Reads:
        self._check(address, word)
        self._bus.write(address, word, now)
        return None

    def _write_block(self, now: float, address: int, words: list[int]) -> Reads:
        self._check(address, max(words))
        self._check_count(len(words))
        self._bus.write_words(self._bus.block(address, len(words)), words, now)
        return None

    def _write_queue(self, now: float, address: int, words: list[int]) -> Reads:
        self._check(address, max(words))
        self._check_count(len(words))
        self._bus.write_words([address] * len(words), words, now)
        return None

    def _write_masked(self, now: float, address: int, mask: int, word: int) -> Reads:
        self._check(address, mask, word)
        old = self._bus.read(address, now)
        self._bus.write(address, old & ~mask | word & mask, now)
        return old

    def _set_group(self, _: float, number: int, flags: int, divisor: int, _count: int, addresses: list[int]) -> Reads:
        if not group_fits(self._info, number, flags, divisor, addresses, for_program=self.for_program):
            raise FieldRangeError
        self._groups.set(number, flags, divisor, addresses)
        return None

    def _start_group(self, now: float, number: int) -> Reads:
        self._check_group(number)
        self._groups.start(number, now)
        return None

    def _stop_group(self, _: float, number: int) -> Reads:
        self._check_group(number)
        self._groups.stop(number)
        return None

    def _publish_group(self, now: float, number: int) -> Reads:
        self._check_group(number)
        self._groups.publish_now(number, now)
        return None

    def _set_send_immediate(self, _: float, mode: int) -> Reads:
        if mode > ADAPTIVE:
            raise FieldRangeError
        self.send_immediate = mode
        return None

    def start_session(self, *, for_program: bool) -> None:
        """Stop all groups, forget their samples that wait, and go back to the adaptive mode."""
        self._groups.stop_all()
        self._groups.ring.clear()
        self.send_immediate = ADAPTIVE
        self.for_program = for_program
