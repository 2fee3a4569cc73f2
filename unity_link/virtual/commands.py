"""Executes requests in the virtual gateway, after their frames and IDs were checked.

Each method checks the ranges of fields (error 06), accesses the bus (errors 04 and 05), and returns the words that were
read, if any.
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
    """A field is out of range; the gateway answers with error 06."""

    code = ErrorCode.OUT_OF_RANGE


class CommandSet:
    """All requests that do not depend on frames or sessions.

    Args:
        info: the gateway's configuration.
        bus: bus for reads and writes.
        groups: groups for the group commands.
    """

    def __init__(self, info: GatewayInfo, bus: ModelBus, groups: PublishGroups) -> None:
        self._info = info
        self._bus = bus
        self._groups = groups
        self._last_address = (1 << info.address_bits) - 1
        self._last_word = (1 << info.data_bits) - 1
        self.for_program = False
        """True in a session that a program began with a checked `K`; samples are then checked frames."""
        self.send_immediate = ADAPTIVE
        """Send-immediate mode of responses; without effect here, because the model never waits for a full packet."""
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
        """Function of each command. Arguments are the time and the fields; the result are the words that were read.

        The functions raise `FieldRangeError` or `AccessError`.
        """

    def reset(self) -> None:
        """Restore the state after power-up."""
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
        """Stop all groups, drop their pending samples, and set the adaptive send-immediate mode."""
        self._groups.stop_all()
        self._groups.ring.clear()
        self.send_immediate = ADAPTIVE
        self.for_program = for_program
