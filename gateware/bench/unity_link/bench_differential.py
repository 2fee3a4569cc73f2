"""Bench: random frames get the same answers, byte for byte, as from the Python model.

Frames are good, damaged, truncated, repeated, out of sequence, or too long, in either case and form, and some have lost
bytes. Sessions begin at any time, and resets end them. Only responses about groups have a defined order relative to
samples (docs/protocol.md, "Groups"), so two comparisons are made: these responses with the samples, and all responses.
"""

from __future__ import annotations

import os
import random
import re
from typing import TYPE_CHECKING

import cocotb

from gateware.bench.unity_link.gateway import IDS, Gateway, with_id
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

ERROR_AT, SILENT_AT = 0xE0, 0xE8
GROUPS, GROUP_WORDS = 16, 32
COMMANDS = ("R", "RM", "RQ", "W", "WM", "WQ", "WK", "WS", "GS", "GN", "GX", "GP", "I", "H", "Q", "K")
WEIGHTS = (8, 4, 2, 8, 4, 2, 3, 3, 3, 3, 2, 3, 1, 3, 0.3, 1)
TIMED = 1 | 2 | 8
"""Flags of groups whose samples depend on time: periodic, triggered, with timestamp."""
GARBAGE = bytes(range(256))


def _sets_a_clock(frame: bytes) -> bool:
    """Return whether a frame may set a group with a timestamp, a period or a trigger, even as a result of damage."""
    flags = re.findall(rb"(?:GS|gs[0-9A-Fa-f]{3})[0-9A-Fa-f]{2}([0-9A-Fa-f]{2})", frame)
    return any(int(digits, 16) & TIMED for digits in flags)


class Frames:
    """Generates frames that a working or faulty host might send."""

    def __init__(self, seed: int, model: VirtualGateway) -> None:
        self._rng = random.Random(seed)
        self._model = model
        self._crc = Crc()

    def _digits(self, count: int) -> bytes:
        text = b"%0*X" % (count, self._rng.getrandbits(4 * count))
        return text.lower() if self._rng.random() < 0.1 else text

    def _address(self) -> bytes:
        if self._rng.random() < 0.02:
            return b"%02X" % self._rng.choice((ERROR_AT - 1, ERROR_AT, SILENT_AT))
        return self._digits(2)

    def _number(self) -> bytes:
        return b"%02X" % min(255, int(self._rng.expovariate(0.3))) if self._rng.random() < 0.97 else self._digits(2)

    def _fields(self, command: str) -> bytes:
        if command == "GS":
            return self._settings()
        rng = self._rng
        makers = {
            "RM": lambda: self._address() + self._number(),
            "W": lambda: self._address() + self._digits(8),
            "WM": lambda: self._address() + self._digits(8 * min(255, 1 + int(rng.expovariate(0.3)))),
            "WK": lambda: self._address() + self._digits(16),
            "GN": lambda: b"%02X" % rng.randrange(18),
            "I": lambda: b"%02X" % rng.randrange(4),
            "K": self._session,
            "R": self._address,
            "H": lambda: b"",
        }
        same = {"RQ": "RM", "WS": "W", "WQ": "WM", "GX": "GN", "GP": "GN", "Q": "H"}
        return makers[same.get(command, command)]()

    def _session(self) -> bytes:
        rng = self._rng
        if rng.random() < 0.4:
            return b""
        session = rng.choice((rng.randrange(1 << 15), rng.randrange(1 << 16), self._model.session, 0, 1))
        return self._digits(GatewayInfo().id_digits) + b"%04X" % session

    def _settings(self) -> bytes:
        rng = self._rng
        count = rng.choice((0, 1, 2, 3, GROUP_WORDS, GROUP_WORDS + 1))
        # Never periodic or triggered, because those depend on time, and so do timestamps.
        flags = rng.choice((0, 16, 32, 48, 4, 64)) if rng.random() < 0.95 else 0x80
        addresses = b"".join(self._address() for _ in range(count))
        return b"%02X%02X%04X%02X" % (rng.randrange(18), flags, rng.randrange(3), count) + addresses

    def _body(self) -> bytes:
        rng = self._rng
        command = rng.choices(COMMANDS, WEIGHTS)[0]
        letters, fields = command.encode(), self._fields(command)
        if command in ("Q", "K") and rng.random() < 0.9:
            return letters + fields
        if rng.random() < 0.35:
            return letters + fields
        half = IDS // 2
        distance = 0 if rng.random() < 0.75 else rng.choice((-1, -2, -5, 1 - half, -half, 1, 2, half - 1))
        return with_id(letters.lower(), self._model.expected + distance, fields)

    def _spoilt(self, body: bytes) -> bytes:
        rng = self._rng
        data = bytearray(body or b"R")
        for _ in range(rng.choice((1, 1, 2))):
            at = rng.randrange(len(data))
            kind = rng.randrange(4)
            if kind == 0:
                data[at] = rng.choice(GARBAGE)
            elif kind == 1:
                data.insert(at, rng.choice(GARBAGE))
            elif kind == 2 and len(data) > 1:
                del data[at]
            else:
                data[at:at] = rng.choice((b"G", b"r", b"0", b"Zz", b"\r", b"\n"))
        return bytes(data)

    def one(self) -> bytes:
        """Return one frame, or the rest of a damaged one, that requests no operation that depends on time."""
        while _sets_a_clock(frame := self._any()):
            pass
        return frame

    def _any(self) -> bytes:
        rng = self._rng
        body = self._body()
        # Damaged before the CRC is added: the frame is intact, but its request is wrong.
        if rng.random() < 0.1:
            body = self._spoilt(body)
        if rng.random() < 0.003:
            body = body + b"0" * 2100
        if rng.random() < 0.25:
            if rng.random() < 0.2 and body[:1] in b"Ww":
                body = body[: rng.randrange(4, 14)]
            frame = body + b"\r"
        else:
            # CRC for the session, for one that has ended, or for none; sometimes with the gateway's direction.
            session = self._model.session if rng.random() < 0.95 else rng.choice((0, 1, rng.randrange(1 << 15)))
            seed = seed_of(session, from_gateway=rng.random() < 0.01) if body[:1].islower() else 0
            frame = body + self._crc.text(body, seed) + b"\n"
        # Damaged on the line.
        if rng.random() < 0.08:
            frame = self._spoilt(frame)
        if rng.random() < 0.01:
            frame = frame[: rng.randrange(len(frame) + 1)]
        return frame


def _all_responses(frame: bytes) -> bool:
    return not frame.startswith(b"P")


def _what_is_about_groups(frame: bytes) -> bool:
    return frame.startswith((b"P", b"G", b"g", b"K"))


@cocotb.test
async def it_answers_random_frames_as_the_model_does(dut: SimHandleBase) -> None:
    count, seed, pause = int(os.environ["FRAMES"]), int(os.environ["SEED"]), float(os.environ["PAUSE"])
    model = VirtualGateway(GatewayInfo(groups=GROUPS, group_words=GROUP_WORDS))
    model.attach(Failing(ErrorCode.BUS_ERROR), [ERROR_AT])
    model.attach(Failing(ErrorCode.BUS_TIMEOUT), [SILENT_AT])
    frames, rng = Frames(seed, model), random.Random(seed + 1)
    gateway = Gateway(dut, pause_in=pause, pause_out=pause, seed=seed)
    await gateway.begin()
    done = 0
    while done < count:
        dut.wait_states.value = rng.choice((0, 0, 1, 3, 9)) if pause else 0
        if rng.random() < 0.3:
            await gateway.reset()
            model.reset()
        sent, expected = [], b""
        for _ in range(min(100, count - done)):
            frame = frames.one()
            lost_before = rng.randrange(len(frame)) if frame and rng.random() < 0.01 else None
            sent.append(frame)
            gateway.send(frame, lost_before=lost_before)
            if lost_before is not None:
                expected += model.receive(frame[:lost_before], 0.0)
                model.overflow()
                frame = frame[lost_before:]
            expected += model.receive(frame, 0.0)
        done += len(sent)
        # Longer than any request takes: the longest block on the slowest bus.
        await gateway.quiet(4000 if pause else 1200)
        for is_in_order in (_all_responses, _what_is_about_groups):
            got, wanted = (
                [frame for frame in data.splitlines(keepends=True) if is_in_order(frame)]
                for data in (bytes(gateway.received), expected)
            )
            wrong = next((index for index, pair in enumerate(zip(got, wanted)) if pair[0] != pair[1]), None)  # noqa: B905
            assert wrong is None, f"frame {wrong}: {got[wrong]!r} and not {wanted[wrong]!r}\n{sent}"
            assert len(got) == len(wanted)
        gateway.take()
