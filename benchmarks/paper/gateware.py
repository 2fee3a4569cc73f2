"""Cycles of the gateware alone, counted on the RTL, at the port of its FIFOs.

The medium accepts and sends a byte in every cycle. The messages are the paper's, without IDs.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from benchmarks.paper.build import OPENED_BYTES, OPENING, checked, compiled_gateway
from benchmarks.paper.results import Block, GatewareFigures, Publishing
from unity_link.protocol.wire.messages import GroupFlag

if TYPE_CHECKING:
    from collections.abc import Sequence

    from unity_link.virtual.rtl import RtlGateway

ADDRESS, WORD = 0x0A, 0x12
READ_BYTES, WRITE_BYTES, POST_BYTES = (6, 14), (14, 6), (15, 0)
"""Bytes of request and answer."""
BLOCKS = (1, 16, 255)
_PIPELINED = 500
_PATIENCE = 20_000
"""Cycles after which every operation here has certainly ended."""
_FLOOD_CYCLES = 100_000
_HEAD_BYTES, _WORD_BYTES = 8, 8
"""Bytes of a sample without timestamp: letter, group, sequence number, CRC and line end; and bytes of a word of it."""


def measure_gateware(sizes: Sequence[int] = (1, 4, 16, 64, 255)) -> GatewareFigures:
    """Count the cycles of each kind of access, alone and pipelined, and of samples of several sizes."""
    gateway = compiled_gateway()
    _, read, _ = _count(gateway, checked(b"R%02X" % ADDRESS), READ_BYTES[1])
    _, write, effect = _count(gateway, checked(b"W%02X%08X" % (ADDRESS, WORD)), WRITE_BYTES[1])
    gateway.memory[ADDRESS] = 0
    _, _, post_effect = _count(gateway, checked(b"WS%02X%08X" % (ADDRESS, WORD)), 0)
    assert effect is not None
    assert post_effect is not None
    return GatewareFigures(
        clock_hz=gateway.info.clock_hz,
        read_cycles=read,
        write_cycles=write,
        effect_cycles=effect,
        post_effect_cycles=post_effect,
        cycles_per_read=_pipelined(gateway, checked(b"R%02X" % ADDRESS), READ_BYTES[1]),
        cycles_per_write=_pipelined(gateway, checked(b"W%02X%08X" % (ADDRESS, WORD)), WRITE_BYTES[1]),
        cycles_per_post=_pipelined_posts(gateway),
        bytes_per_cycle=_with_ids(gateway),
        blocks=[_block(gateway, words) for words in BLOCKS],
        publishing=[_publishing(words) for words in sizes],
    )


def _count(gateway: RtlGateway, request: bytes, answer_size: int) -> tuple[int, int, int | None]:
    """Return the cycles from the last byte in to the first and the last byte out, and to a change in memory, if any."""
    rest, sent, effect = request, 0, None
    last_in = first_out = 0
    for cycle in range(_PATIENCE):
        passage = gateway.pass_pins(rest, 1, max(answer_size, 1))
        rest = rest[passage.taken :]
        if passage.sent and not sent:
            first_out = cycle - last_in
        sent += len(passage.sent)
        if passage.taken and not rest:
            last_in = cycle
        if effect is None and gateway.memory[ADDRESS] == WORD:
            effect = cycle - last_in
        if sent == answer_size and not rest and (answer_size or effect is not None):
            return first_out, cycle - last_in, effect
    raise AssertionError(f"the gateware has not answered {request!r}")


def _block(gateway: RtlGateway, words: int) -> Block:
    size = len(checked(b"RM00%02X" % words)) + _WORD_BYTES * words
    first, last, _ = _count(gateway, checked(b"RM00%02X" % words), size)
    return Block(words=words, first_cycles=first, last_cycles=last)


def _flood(gateway: RtlGateway, requests: bytes, size: int) -> list[int]:
    """Return the cycles in which bytes are output, one by one, while requests are sent as fast as they are accepted."""
    rest, cycles = requests, []
    for cycle in range(len(requests) + 2 * size + _PATIENCE):
        passage = gateway.pass_pins(rest[:64], 1, size)
        rest = rest[passage.taken :]
        cycles += [cycle] * len(passage.sent)
        if len(cycles) == size:
            return cycles
    raise AssertionError(f"the gateware has answered with {len(cycles)} of {size} bytes")


def _pipelined(gateway: RtlGateway, request: bytes, answer_size: int) -> float:
    """Return the cycles from answer to answer, at the end of a long burst."""
    ends = _flood(gateway, request * _PIPELINED, answer_size * _PIPELINED)[answer_size - 1 :: answer_size]
    half = _PIPELINED // 2
    return (ends[-1] - ends[half - 1]) / (_PIPELINED - half)


def _pipelined_posts(gateway: RtlGateway) -> float:
    """Return the cycles from the end of one posted write to the end of the next, as they are accepted."""
    rest, cycle, taken_at = checked(b"WS%02X%08X" % (ADDRESS, WORD)) * _PIPELINED, 0, []
    while rest:
        taken = gateway.pass_pins(rest[:64], 1, 64).taken
        rest, cycle = rest[taken:], cycle + 1
        taken_at += [cycle] * taken
    ends = taken_at[POST_BYTES[0] - 1 :: POST_BYTES[0]]
    half = _PIPELINED // 2
    return (ends[-1] - ends[half - 1]) / (_PIPELINED - half)


def _with_ids(gateway: RtlGateway) -> float:
    """Return the bytes per cycle that are output while reads with IDs are sent."""
    _count(gateway, OPENING, OPENED_BYTES)
    requests = b"".join(checked(b"r%03X%02X" % (number, ADDRESS)) for number in range(_PIPELINED))
    size = len(checked(b"r00000000000")) * _PIPELINED
    cycles = _flood(gateway, requests, size)
    return size / (cycles[-1] - cycles[0] + 1)


def _publishing(words: int) -> Publishing:
    """Count the cycles of one sample, and the maximum rate if all groups are always due."""
    size = _HEAD_BYTES + _WORD_BYTES * words
    gateway = compiled_gateway()
    _set_up(gateway, 0, GroupFlag(0), words)
    return Publishing(
        words=words,
        message_bytes=size,
        cycles=_one_sample(gateway, words, size),
        rate=round(_most_samples(words, size), 3),
    )


class _Noting:
    """Device that records the cycle of its first read."""

    def __init__(self, gateway: RtlGateway) -> None:
        self._gateway = gateway
        self.first: int | None = None

    def read(self, offset: int, now: float) -> int:  # noqa: ARG002  (as devices have it)
        if self.first is None:
            self.first = self._gateway.cycles
        return 0

    def write(self, offset: int, value: int, now: float) -> None:
        """Accept a write."""


def _one_sample(gateway: RtlGateway, words: int, size: int) -> int:
    noting = _Noting(gateway)
    gateway.attach(noting, [0])
    request, sent = checked(b"GP00"), 0
    for _ in range(_PATIENCE):
        passage = gateway.pass_pins(request, 1, size)
        request = request[passage.taken :]
        sent += len(passage.sent)
        if sent >= size:
            assert noting.first is not None
            return gateway.cycles - noting.first
    raise AssertionError(f"the gateware has sent {sent} of {size} bytes of a sample of {words} words")


def _most_samples(words: int, size: int) -> float:
    gateway = compiled_gateway()
    info = gateway.info
    for group in range(info.groups):
        _set_up(gateway, group, GroupFlag.PERIODIC, words)
    for group in range(info.groups):
        gateway.run(1)
        gateway.pass_pins(checked(b"GN%02X" % group), 200, 1 << 20)
    gateway.run(10_000)
    return len(gateway.run(_FLOOD_CYCLES)) / size / _FLOOD_CYCLES * info.clock_hz


def _set_up(gateway: RtlGateway, group: int, flags: GroupFlag, words: int) -> None:
    listed = b"".join(b"%02X" % address for address in range(words))
    request = checked(b"GS%02X%02X0001%02X" % (group, flags, words) + listed)
    sent, rest = b"", request
    for _ in range(_PATIENCE):
        passage = gateway.pass_pins(rest, 1, 64)
        rest, sent = rest[passage.taken :], sent + passage.sent
        if sent.endswith(b"\n"):
            break
    assert sent == checked(b"GS%02X" % group), sent
