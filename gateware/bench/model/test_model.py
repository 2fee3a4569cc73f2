"""The compiled gateware of `unity_link.virtual.rtl` sends the same bytes as the VHDL, each in the same cycle.

A conversion can go wrong without a message. So the same traffic is sent to the VHDL in GHDL and to the library that
users run: requests of every kind, damaged and truncated ones, errors of the bus, groups and triggers.
"""

from __future__ import annotations

import json
import random
from typing import TYPE_CHECKING

import pytest

from gateware.bench.runner import run_bench
from gateware.tools.model import CONFIGURATIONS, is_current
from support.makers import build_params
from unity_link.protocol.wire.crc import Crc
from unity_link.virtual.rtl import RtlGateway

if TYPE_CHECKING:
    from pathlib import Path

_CYCLES = 12_000
_TRIGGER_AT = (3000, 7000)
_TRIGGER_CYCLES = 5
_ERROR_AT, _SILENCE_AT = 0x21, 0x22


def _frames(gateway: RtlGateway) -> list[bytes]:
    """Return requests of every kind with the parameters of a gateway, some of them damaged, in a random order."""
    info, rng = gateway.info, random.Random(21)
    crc = Crc(info.crc_bits, info.crc_polynomial)

    def address() -> str:
        return f"{rng.choice((*range(0x10), _ERROR_AT) * 20 + (_SILENCE_AT,)):0{info.address_digits}X}"

    def word() -> str:
        return f"{rng.getrandbits(info.data_bits):0{info.data_digits}X}"

    def body() -> str:
        group, count = f"{rng.randrange(3):02X}", rng.randrange(1, 5)
        count_text = f"{count:02X}"
        listed = "".join(address() for _ in range(count))
        return rng.choice(
            (
                f"R{address()}",
                f"W{address()}{word()}",
                f"WS{address()}{word()}",
                f"RM{address()}{count_text}",
                f"RQ{address()}{count_text}",
                f"WM{address()}" + "".join(word() for _ in range(count)),
                f"WQ{address()}" + "".join(word() for _ in range(count)),
                f"WK{address()}{word()}{word()}",
                f"GS{group}{rng.choice(('01', '09', '0B', '11', '25')):s}0001{count_text}{listed}",
                f"GN{group}",
                f"GX{group}",
                f"GP{group}",
                "H",
                "Q",
                f"I{rng.choice(('00', '01', '02')):s}",
            )
        )

    number = "0" * info.id_digits
    # The first request is outside of a session.
    frames, expected = [f"h{number}\r".encode(), f"K{number}\r".encode()], 0
    for _ in range(120):
        text = body()
        if rng.random() < 0.5 and text[0] != "Q":
            letters = text.rstrip("0123456789ABCDEF")
            number = (expected + rng.choice((0, 0, 0, 0, 0, -1, 1))) % 16**info.id_digits
            expected += number == expected
            text = f"{letters.lower()}{number:0{info.id_digits}X}{text[len(letters) :]}"
        frame = text.encode()
        frame = frame + b"\r" if rng.random() < 0.3 else frame + crc.text(frame) + b"\n"
        if rng.random() < 0.1:
            cut = rng.randrange(len(frame))
            frame = frame[:cut] + bytes([rng.randrange(256)]) + frame[cut + 1 :]
        frames.append(frame)
    return frames


# GHDL 2 does not accept a vector as a generic, which "wide" needs for its polynomial.
@pytest.mark.parametrize("configuration", build_params(["default", "minimal"]))
def test_compiled_gateware_and_vhdl_send_the_same_bytes_in_the_same_cycles(configuration: str, tmp_path: Path) -> None:
    assert is_current(configuration), "the VHDL has changed since the C++ was made: make rtl"
    gateway = RtlGateway(configuration)
    requests = b"".join(_frames(gateway))
    library, handle = gateway._library, gateway._handle  # noqa: SLF001  (cycles are counted one by one)
    for address, kind in ((_ERROR_AT, 1), (_SILENCE_AT, 2)):
        library.ul_set_behind(handle, address, kind)
    library.ul_push(handle, requests, len(requests))
    sent: list[tuple[int, int]] = []
    flushed: list[int] = []
    for cycle in range(_CYCLES):
        library.ul_set_trigger(handle, any(at <= cycle < at + _TRIGGER_CYCLES for at in _TRIGGER_AT))
        flushes = gateway.flushes
        sent += [(cycle, byte) for byte in gateway.run(1)]
        if gateway.flushes != flushes:
            flushed.append(cycle)
    assert gateway.waiting == 0
    assert len(sent) > 500
    plan = tmp_path / "plan.json"
    plan.write_text(
        json.dumps(
            {
                "requests": requests.hex(),
                "cycles": _CYCLES,
                "triggers": [_TRIGGER_AT, _TRIGGER_CYCLES],
                "error_at": _ERROR_AT,
                "silence_at": _SILENCE_AT,
                "sent": sent,
                "flushed": flushed,
            }
        )
    )
    run_bench(
        "unity_link_fifo",
        "gateware.bench.model.bench_model",
        generics=CONFIGURATIONS[configuration],
        extra_env={"PLAN": str(plan)},
    )
