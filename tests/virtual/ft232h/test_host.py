"""The chip as a program sees it, in simulated time: round trips, streams, faults."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import pytest

from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.transport.ft232h.eeprom_image import build_eeprom
from unity_link.transport.ft232h.kinds import FT2232H
from unity_link.virtual import VirtualGateway
from unity_link.virtual.ft232h.board import AttachedBoard, GatewayBoard, Unconnected
from unity_link.virtual.ft232h.chip import Chip
from unity_link.virtual.ft232h.host import Transfer, TransferStatus, UsbHost
from unity_link.virtual.ft232h.port import Mode
from unity_link.virtual.ft232h.timing import Timing
from unity_link.virtual.gateway import Gateway

if TYPE_CHECKING:
    from collections.abc import Callable, MutableMapping

IN, OUT = 0x81, 0x02
MICROFRAME = 125e-6
READ = b"R0A6DDE\n"
ANSWER = b"R0A000000004E83\n"


def payload(ended: Transfer) -> bytes:
    """Return the bytes of a read transfer without the status bytes."""
    return b"".join(bytes(ended.data[start + 2 : start + 512]) for start in range(0, len(ended.data), 512))


class Program:
    """Submits transfers to a host and waits for them; time passes only while it waits."""

    def __init__(self, board: AttachedBoard, timing: Timing = Timing()) -> None:  # noqa: B008  (frozen)
        self.chip = Chip(build_eeprom("FIFO", "S1"), timing)
        [self.port] = self.chip.ports
        self.host = UsbHost(self.chip, board)
        self.now = 0.0

    def submit(self, transfer: Transfer) -> Transfer:
        self.host.submit(transfer, self.now)
        return transfer

    def wait(self, transfer: Transfer) -> Transfer:
        while transfer.status is None or transfer.ends_at > self.now:
            due = self.host.next_due
            assert due is not None, "no further event is due"
            self.now = max(self.now, due)
            self.host.advance(self.now)
        return transfer

    def run_for(self, seconds: float) -> None:
        self.now += seconds
        self.host.advance(self.now)

    def write(self, data: bytes) -> Transfer:
        return self.wait(self.submit(Transfer(OUT, data=data)))

    def transact(self, request: bytes, size: int = 16384) -> tuple[bytes, float]:
        """Send a request while a read is pending; return the answer, and the seconds that it took."""
        began = self.now
        reading = self.submit(Transfer(IN, size=size))
        self.submit(Transfer(OUT, data=request))
        while len(self.wait(reading).data) <= 2:
            reading = self.submit(Transfer(IN, size=size))
        return payload(reading), self.now - began


def new_program(mode: Mode = Mode.FIFO, timing: Timing = Timing()) -> Program:  # noqa: B008  (frozen)
    program = Program(GatewayBoard(VirtualGateway(), mode), timing)
    if mode is Mode.SYNC_FIFO:
        program.port.bit_mode = 0x40
    return program


@pytest.mark.parametrize("mode", [b"I01\r", b"I02\r"])
def test_a_read_with_send_immediate_takes_at_most_two_microframes(mode: bytes) -> None:
    program = new_program()
    program.transact(mode)
    for _ in range(100):
        program.run_for(random.Random(1).random() * MICROFRAME)
        answer, took = program.transact(READ)
        assert answer == ANSWER
        assert took <= 2 * MICROFRAME + 1e-9


def test_a_read_without_send_immediate_takes_the_latency_timer() -> None:
    program = new_program()
    program.transact(b"I00\r")
    program.run_for(0.1)
    program.transact(READ)
    answer, took = program.transact(READ)
    assert answer == ANSWER
    assert 0.016 - 2 * MICROFRAME < took < 0.016 + 2 * MICROFRAME


def test_a_burst_fills_its_packets_with_adaptive_send_immediate() -> None:
    burst, packets = READ * 250, {}
    for mode in (b"I00\r", b"I01\r", b"I02\r"):
        program = new_program()
        program.chip.control_out(0x40, 0x09, 1, 1, 0.0)
        program.transact(mode)
        program.submit(Transfer(OUT, data=burst))
        received, count = b"", 0
        posted = [program.submit(Transfer(IN, size=512)) for _ in range(4)]
        while len(received) < 250 * len(ANSWER):
            posted.append(program.submit(Transfer(IN, size=512)))
            data = bytes(program.wait(posted.pop(0)).data)
            received += data[2:]
            count += len(data) > 2
        assert received == ANSWER * 250
        packets[mode] = count
    full = -(-250 * len(ANSWER) // 510)
    assert packets[b"I00\r"] <= full + 1
    assert packets[b"I02\r"] <= full + 2
    assert packets[b"I01\r"] > 2 * full


def test_a_sample_of_an_immediate_group_is_sent_at_once() -> None:
    program = new_program()
    program.transact(b"GS000503E8010A\r")
    program.transact(b"GN00\r")
    taken = []
    for _ in range(50):
        reading = program.wait(program.submit(Transfer(IN, size=512)))
        taken.append(bytes(reading.data[2:]))
    samples = [data for data in taken if data.startswith(b"P")]
    # 100 Hz with a latency timer of 16 ms: each sample is alone in its packet.
    assert len(samples) > 20
    assert all(data.count(b"\n") == 1 for data in samples)


class Echo:
    """A gateway that echoes all bytes, and so fills both directions."""

    open = Gateway.open

    def __init__(self) -> None:
        self.info = GatewayInfo()
        self.wake: Callable[[], None] = lambda: None
        self.next_due: float | None = None
        self.leaves_time_out = False
        self.refusal = ""
        self.waiting = 0

    @property
    def memory(self) -> MutableMapping[int, int]:
        raise NotImplementedError

    def receive(self, data: bytes, now: float) -> bytes:
        return data

    def advance(self, now: float, room: int | None = None) -> bytes:
        return b""


def stream(seconds: float, *, mode: Mode, transfers: int, size: int, step: int) -> float:
    """Echo bytes for some seconds and compare them; return the bytes per second in each direction."""
    program = Program(GatewayBoard(Echo(), mode, step=step))
    program.port.bit_mode = 0x40 if mode is Mode.SYNC_FIFO else 0
    pattern = random.Random(7).randbytes(1 << 20)
    pattern += pattern[:size]
    sent = received = 0
    end = seconds

    def send(ended: Transfer | None = None) -> None:
        nonlocal sent
        assert ended is None or ended.status is TransferStatus.DONE
        if program.now < end:
            start = sent % (1 << 20)
            program.host.submit(Transfer(OUT, data=pattern[start : start + size], on_end=to_send.append), program.now)
            sent += size

    def check(ended: Transfer) -> None:
        nonlocal received
        assert ended.status is TransferStatus.DONE
        for start in range(0, len(ended.data), 512):
            packet = ended.data[start + 2 : start + 512]
            place = received % (1 << 20)
            assert packet == pattern[place : place + len(packet)]
            received += len(packet)

    to_send: list[Transfer] = []
    to_check: list[Transfer] = []
    for _ in range(transfers):
        program.host.submit(Transfer(IN, size=size, on_end=to_check.append), program.now)
        send()
    received_by_end = 0
    while received < sent or program.now < end:
        if program.now < end:
            received_by_end = received
        due = program.host.next_due
        assert due is not None
        program.now = max(program.now, due)
        program.host.advance(program.now)
        for ended in to_check:
            check(ended)
            program.host.submit(Transfer(IN, size=size, on_end=to_check.append), program.now)
        del to_check[:transfers]
        for ended in to_send:
            send(ended)
        to_send.clear()
    return received_by_end / end


def test_a_stream_in_both_directions_reaches_the_rate_of_the_chip() -> None:
    rate = stream(0.2, mode=Mode.FIFO, transfers=4, size=4096, step=64)
    assert 0.95 * 8e6 < rate <= 8e6


def test_a_stream_of_one_transfer_at_a_time_loses_no_byte() -> None:
    assert stream(0.2, mode=Mode.FIFO, transfers=1, size=16384, step=64) > 0.8 * 8e6


def test_a_synchronous_stream_shares_40_mb_per_second() -> None:
    assert 15e6 < stream(0.1, mode=Mode.SYNC_FIFO, transfers=4, size=16384, step=256) <= 20e6


@pytest.mark.slow
@pytest.mark.parametrize("seconds", [3.0, pytest.param(60.0, marks=pytest.mark.campaign)])
def test_seconds_of_8_mb_per_second_in_both_directions_lose_no_byte(seconds: float) -> None:
    rate = stream(seconds, mode=Mode.FIFO, transfers=4, size=16384, step=256)
    assert rate > 0.97 * 8e6


def test_a_gateway_with_long_answers_throttles_the_host() -> None:
    program = new_program()
    # Each request of 14 characters has an answer of 2054, so RD# waits most of the time.
    requests = b"RM0020\r" * 20
    program.submit(Transfer(OUT, data=requests))
    received = b""
    while received.count(b"\n") < 20:
        received += bytes(program.wait(program.submit(Transfer(IN, size=512))).data[2:])
    assert received == (b"RM0020" + b"00000000" * 32 + b"\r\n") * 20


def test_samples_without_space_are_counted_and_the_others_arrive_whole() -> None:
    program = new_program()
    program.transact(b"GS00010001010A\r")
    program.transact(b"GN00\r")
    program.run_for(1.0)
    received = b""
    while len(received) < 4000:
        received += bytes(program.wait(program.submit(Transfer(IN, size=512))).data[2:])
    lines = received.split(b"\n")[:-1]
    assert all(line.startswith(b"P00") and len(line) == 17 for line in lines)


# Faults


def test_a_packet_of_510_bytes_arrives_at_latest_with_the_latency_timer() -> None:
    program = new_program()
    program.transact(b"I02\r")
    # 31 answers of 16 bytes, one of 8 and one of 6: together one full packet, which does not end the transfer.
    requests = READ * 31 + b"W0A00000012D4FE\n" + b"HC9CC\n"
    answer, took = program.transact(requests)
    assert len(answer) == 510
    assert took <= 0.016 + 3 * MICROFRAME
    short, quick = new_program(timing=Timing(short_packet_after_full=True)).transact(requests)
    assert len(short) == 510
    assert quick < 0.001


def test_unplugging_ends_every_transfer() -> None:
    program = new_program()
    transfers = [program.submit(Transfer(IN, size=512)), program.submit(Transfer(OUT, data=READ))]
    program.host.unplug(program.now)
    assert [transfer.status for transfer in transfers] == [TransferStatus.GONE] * 2
    with pytest.raises(ConnectionError):
        program.submit(Transfer(IN, size=512))


def test_a_halted_endpoint_stalls_until_it_is_cleared() -> None:
    program = new_program()
    program.host.halt(OUT, program.now)
    assert program.write(READ).status is TransferStatus.STALLED
    program.host.control_out(0x02, 0x01, 0, OUT, program.now)
    assert program.write(READ).status is TransferStatus.DONE


def test_a_cancelled_read_loses_no_byte() -> None:
    program = new_program()
    program.submit(Transfer(OUT, data=READ * 100))
    reading = program.submit(Transfer(IN, size=16384))
    program.run_for(3 * MICROFRAME)
    program.host.cancel(reading, program.now)
    received = payload(reading)
    while received.count(b"\n") < 100:
        received += payload(program.wait(program.submit(Transfer(IN, size=512))))
    assert received == ANSWER * 100


def test_no_byte_passes_the_pins_in_the_wrong_mode() -> None:
    program = new_program(Mode.SYNC_FIFO)
    program.port.bit_mode = 0
    program.write(READ)
    program.run_for(0.1)
    assert program.port.readable == len(READ)
    assert program.wait(program.submit(Transfer(IN, size=512))).moved == 2


def test_a_uart_that_is_not_read_reports_an_overrun() -> None:
    program = Program(GatewayBoard(VirtualGateway(), Mode.UART))
    program.chip.eeprom[:] = build_eeprom("UART")
    program.chip.power_up(0.0)
    program.port.baud = 12e6
    program.write(READ * 100)
    program.run_for(0.01)
    first = program.wait(program.submit(Transfer(IN, size=512)))
    assert first.data[1] & 0x02


def test_the_ports_of_a_chip_share_the_bus_in_turns() -> None:
    chip = Chip(build_eeprom("FIFO", kind=FT2232H, ports=[1, 2]), Timing(), FT2232H)
    host = UsbHost(chip, Unconnected(), Unconnected())
    ended: list[Transfer] = []
    for port in chip.ports:
        port.write(bytes([port.number]) * 4080)
        for _ in range(8):
            host.submit(Transfer(port.in_endpoint, size=512, on_end=ended.append), 0.0)
    host.advance(2 * MICROFRAME)
    assert [transfer.endpoint for transfer in ended] == [0x81, 0x83] * 8
    assert payload(ended[0]) == b"\x01" * 510
    assert payload(ended[1]) == b"\x02" * 510
