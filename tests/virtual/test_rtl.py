"""The compiled gateware behind the interface of the model: its bus, its time, and what happens without a compiler."""

from __future__ import annotations

import itertools
import shutil
from typing import TYPE_CHECKING

import pytest

from unity_link.errors import ArgumentError, ConnectError
from unity_link.virtual import AccessError
from unity_link.virtual.rtl import RtlGateway, configurations, library
from unity_link.wire.crc import Crc
from unity_link.wire.messages import ErrorCode

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = [
    pytest.mark.rtl,
    pytest.mark.skipif(
        not any(shutil.which(name) for name in ("c++", "g++", "clang++")), reason="no C++ compiler: apt install g++"
    ),
]


@pytest.fixture(scope="module")
def built() -> RtlGateway:
    return RtlGateway()


@pytest.fixture
def gateway(built: RtlGateway) -> RtlGateway:
    built.reset()
    for address in list(built.memory):
        del built.memory[address]
    return built


def _checked(body: bytes) -> bytes:
    return body + Crc().text(body) + b"\n"


def test_memory_is_what_requests_read_and_write(gateway: RtlGateway) -> None:
    gateway.memory[0x0A] = 0x12
    assert gateway.receive(b"R0ACB\n", 0.0) == b"R0A000000122C\n"
    assert gateway.receive(_checked(b"W0B89ABCDEF"), 0.0) == _checked(b"W0B")
    assert dict(gateway.memory) == {0x0A: 0x12, 0x0B: 0x89ABCDEF}


def test_addresses_and_words_out_of_range_are_refused(gateway: RtlGateway) -> None:
    with pytest.raises(ArgumentError, match="address 0x100 does not fit in 8 bits"):
        gateway.memory[0x100] = 0
    with pytest.raises(ArgumentError, match="word 0x100000000 does not fit in 32 bits"):
        gateway.memory[0] = 1 << 32


class _Recorder:
    """A device that notes what it is asked, and refuses where it is told to."""

    def __init__(self) -> None:
        self.calls: list[tuple[str, int, int]] = []
        self.refusal: Exception | None = None

    def read(self, offset: int, now: float) -> int:
        assert now >= 0
        self._note("read", offset, 0)
        return -1 - offset

    def write(self, offset: int, value: int, now: float) -> None:
        assert now >= 0
        self._note("write", offset, value)

    def _note(self, kind: str, offset: int, value: int) -> None:
        self.calls.append((kind, offset, value))
        if self.refusal is not None:
            raise self.refusal


def test_a_device_answers_at_its_addresses(gateway: RtlGateway) -> None:
    device = _Recorder()
    gateway.attach(device, (0x20, 0x21))
    assert gateway.receive(b"R21\rW200000002A\r", 0.0) == b"R21FFFFFFFE\r\nW20\r\n"
    assert device.calls == [("read", 1, 0), ("write", 0, 42)]
    gateway.detach((0x20, 0x21))
    assert gateway.receive(b"R21\r", 0.0) == b"R2100000000\r\n"


@pytest.mark.parametrize(("code", "answer"), [(ErrorCode.BUS_ERROR, b"X04\r\n"), (ErrorCode.BUS_TIMEOUT, b"X05\r\n")])
def test_a_device_that_refuses_is_an_error_of_the_bus(gateway: RtlGateway, code: ErrorCode, answer: bytes) -> None:
    device = _Recorder()
    device.refusal = AccessError(code)
    gateway.attach(device, (0x20,))
    assert gateway.receive(b"R20\r", 0.0) == answer
    gateway.detach((0x20,))


def test_what_a_device_raises_otherwise_reaches_the_caller(gateway: RtlGateway) -> None:
    device = _Recorder()
    device.refusal = ZeroDivisionError("in the device")
    gateway.attach(device, (0x20,))
    with pytest.raises(ZeroDivisionError, match="in the device"):
        gateway.receive(b"R20\r", 0.0)
    gateway.detach((0x20,))


def test_an_overflow_is_answered_by_error_09(gateway: RtlGateway) -> None:
    gateway.overflow()
    assert gateway.receive(b"R0ACB\nR0ACB\n", 0.0) == _checked(b"X09") + b"R0A0000000037\n"


def test_time_stands_still_while_no_group_runs(gateway: RtlGateway) -> None:
    gateway.receive(b"R0A\r", 1.0)
    cycles = gateway.cycles
    assert gateway.next_due is None
    assert gateway.advance(1000.0) == b""
    assert gateway.cycles == cycles


def test_a_running_group_publishes_at_its_rate_until_the_session_starts_anew(gateway: RtlGateway) -> None:
    # Group 0 at a tenth of the base frequency of 10 kHz, one word, plain frames: every millisecond.
    answers = gateway.receive(b"GS0021000A010A\rGN00\r", 5.0)
    assert answers.startswith(b"GS00\r\nGN00\r\n")
    due = gateway.next_due
    assert due is not None
    published = answers[12:] + b"".join(gateway.advance(5.0 + step / 1000) for step in range(1, 51))
    frames = published.split(b"\r\n")[:-1]
    assert len(frames) == pytest.approx(50, abs=1)
    assert [frame[:5] for frame in frames] == [b"P00%02X" % number for number in range(len(frames))]
    assert gateway.receive(b"K00\r", 5.06).endswith(b"K00\r\n")
    assert gateway.next_due is None
    assert gateway.advance(6.0) == b""


def test_samples_without_room_are_overruns(gateway: RtlGateway) -> None:
    gateway.receive(b"GS0021000A010A\rGN00\r", 0.0)
    for step in range(1, 400):
        assert gateway.advance(step / 100, room=0) == b""
    rest = gateway.advance(4.01)
    numbers = [int(frame[3:5], 16) for frame in rest.split(b"\r\n")[:-1]]
    # What the FIFOs hold comes first and without a gap; then the numbers of all that were lost are missing.
    assert len(numbers) < 2000
    assert any((later - earlier) % 256 > 1 for earlier, later in itertools.pairwise(numbers))


def test_every_configuration_says_what_it_is(gateway: RtlGateway) -> None:
    assert "default" in configurations()
    assert (gateway.info.data_bits, gateway.info.address_bits) == (32, 8)


def test_an_unknown_configuration_is_named() -> None:
    with pytest.raises(ArgumentError, match="there is no gateware 'huge': this installation has default"):
        RtlGateway("huge")


def test_without_a_compiler_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CXX", raising=False)
    library.load.cache_clear()
    with pytest.raises(ConnectError, match=r"apt install g\+\+"):
        RtlGateway()
    library.load.cache_clear()
