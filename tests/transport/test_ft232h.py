"""The ftdi: driver on a virtual chip, through unmodified pyftdi, in real time and with real threads."""

from __future__ import annotations

import asyncio
import logging
import threading
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Any

import pytest
from msgspec import structs

import unity_link
from unity_link.errors import ArgumentError, ConnectError, LinkLostError
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.messages import Codec
from unity_link.transport import load_driver, parse_url
from unity_link.transport.ft232h import with_libusb
from unity_link.transport.ft232h.chip import list_chips, made_of, open_chip, open_in_thread, settings_of
from unity_link.transport.ft232h.eeprom_image import BLANK, build_eeprom
from unity_link.transport.ft232h.kinds import FT232H, FT2232H, in_endpoint, out_endpoint
from unity_link.transport.ft232h.transport import StatusStripper
from unity_link.virtual import VirtualGateway
from unity_link.virtual.ft232h.board import GatewayBoard, Unconnected
from unity_link.virtual.ft232h.bus import VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.port import OVERRUN, Mode
from unity_link.virtual.ft232h.pyusb_backend import installed
from unity_link.virtual.ft232h.timing import Timing

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from unity_link.transport.ft232h.eeprom_image import ChannelType
    from unity_link.transport.ft232h.kinds import ChipKind
    from unity_link.virtual.ft232h.port import ChipPort

pytestmark = pytest.mark.asyncio
URL = "ftdi://ftdi:232h/1"
FRAMING = Codec(GatewayInfo()).framing
READ, ANSWER = FRAMING.checked(b"R0A"), FRAMING.checked(b"R0A00000000")


def kind_in(url: str) -> ChipKind:
    return FT2232H if "2232h" in url else FT232H


def port_in(url: str) -> int:
    return int(url.partition("?")[0][-1])


def port_at(device: VirtualFt232h, url: str) -> ChipPort:
    """Return the port of the chip that a URL names."""
    return device.chip.ports[port_in(url) - 1]


def eeprom_for(url: str, channel_type: ChannelType, serial: str = "UL000001") -> bytes:
    """Return an EEPROM that sets the port of a URL to `channel_type`, and the chip's other port to the other type."""
    kind, port = kind_in(url), port_in(url)
    if channel_type == "FIFO":
        return build_eeprom("FIFO", serial, kind=kind, ports=[port])
    return build_eeprom("FIFO", serial, kind=kind, ports={1, kind.ports} - {port})


@contextmanager
def plugged_in(
    url: str = URL,
    gateway: VirtualGateway | None = None,
    *,
    mode: Mode = Mode.FIFO,
    image: bytes | None = None,
    **timing: Any,
) -> Iterator[VirtualFt232h]:
    """Connect one chip to the machine's USB, as its only device, with a gateway at the port of a URL."""
    board = GatewayBoard(gateway or VirtualGateway(), mode)
    boards = (board,) if port_in(url) == 1 else (Unconnected(), board)
    device = VirtualFt232h(*boards, kind=kind_in(url), image=image or eeprom_for(url, "FIFO"), timing=Timing(**timing))
    with installed(VirtualBus(device)):
        yield device
    for thread in threading.enumerate():
        if "ft232h" in thread.name:
            thread.join(10)
            assert not thread.is_alive()


class Recorder(asyncio.Protocol):
    """Records the bytes and events of a driver."""

    def __init__(self) -> None:
        self.received = b""
        self.transport: Any = None
        self.error: Exception | None = None
        self.paused = False
        self.changed = asyncio.Event()
        self.ended = asyncio.Event()

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self.transport = transport

    def data_received(self, data: bytes) -> None:
        self.received += data
        self.changed.set()

    def pause_writing(self) -> None:
        self.paused = True

    def resume_writing(self) -> None:
        self.paused = False
        self.changed.set()

    def connection_lost(self, exc: Exception | None) -> None:
        self.error = exc
        self.ended.set()

    async def until(self, size: int) -> None:
        while len(self.received) < size:
            self.changed.clear()
            await asyncio.wait_for(self.changed.wait(), 10)

    async def lost(self) -> Exception | None:
        await asyncio.wait_for(self.ended.wait(), 10)
        return self.error


PLACES = ["ftdi:232h/1", "ftdi:2232h/1", "ftdi:2232h/2"]


@pytest.fixture(params=PLACES)
def place(request: pytest.FixtureRequest) -> str:
    """Return the part of a URL that names a port of a chip."""
    return str(request.param)


@pytest.fixture(params=["ftdi", "ftdi-async"])
def url(request: pytest.FixtureRequest, place: str) -> str:
    """Return the URL of the connected port, for either driver."""
    return f"{request.param}://{place}"


async def connect(url: str = URL) -> Recorder:
    recorder = Recorder()
    parsed = parse_url(url)
    await load_driver(parsed.scheme).connect(parsed, recorder)
    return recorder


async def close(recorder: Recorder) -> None:
    recorder.transport.close()
    assert await recorder.lost() is None


# URLs


@pytest.mark.parametrize(
    ("url", "host", "path"),
    [
        ("ftdi://ftdi:232h/1", "ftdi:232h", "/1"),
        ("ftdi://ftdi:232h:FT4XYZ/1", "ftdi:232h:FT4XYZ", "/1"),
        ("ftdi://ftdi:2232h:FT4XYZ/2", "ftdi:2232h:FT4XYZ", "/2"),
        ("ftdi://0x403:0x6014:1:2/1", "0x403:0x6014:1:2", "/1"),
        ("ftdi:///1", "", "/1"),
        ("ftdi://virtual/scara", "virtual", "/scara"),
    ],
)
async def test_the_url_forms_of_pyftdi_are_kept(url: str, host: str, path: str) -> None:
    parsed = parse_url(url + "?latency=2")
    assert (parsed.host, parsed.port, parsed.path, parsed.options) == (host, None, path, {"latency": "2"})


@pytest.mark.parametrize(
    "query",
    [
        "mode=fifo",
        "latency=0",
        "latency=256",
        "latency=soon",
        "event_char=256",
        "baud=9600",
        "mode=uart&baud=13000000",
        "data_bits=16",
        "speed=1",
    ],
)
async def test_an_unknown_option_of_a_chip_is_refused_by_its_name(query: str) -> None:
    with pytest.raises(ArgumentError, match=query.rpartition("&")[2].partition("=")[0]):
        settings_of(parse_url(f"{URL}?{query}"))


@pytest.mark.parametrize("url", ["ftdi://ftdi:232h", "ftdi://ftdi:232h/?", "ftdi:///?"])
async def test_a_url_without_a_port_is_refused(url: str) -> None:
    with pytest.raises((ArgumentError, ConnectError)):
        await connect(url)


# Bytes


@pytest.mark.parametrize(
    ("place", "mode"),
    # Port B has no synchronous FIFO.
    [
        (place, mode)
        for place in PLACES
        for mode in (Mode.FIFO, Mode.SYNC_FIFO, Mode.UART)
        if (place, mode) != ("ftdi:2232h/2", Mode.SYNC_FIFO)
    ],
    indirect=["place"],
)
async def test_every_mode_moves_bytes(url: str, mode: Mode) -> None:
    image = eeprom_for(url, "UART" if mode is Mode.UART else "FIFO")
    baud = "&baud=3000000" if mode is Mode.UART else ""
    with plugged_in(url, mode=mode, image=image):
        recorder = await connect(f"{url}?mode={mode.value}{baud}")
        recorder.transport.write(READ)
        await recorder.until(len(ANSWER))
        assert recorder.received == ANSWER
        await close(recorder)


async def test_a_virtual_chip_needs_only_its_url() -> None:
    async with unity_link.connect("ftdi://virtual/scara?id_digits=2") as link:
        assert link.gateway.id_digits == 2
        await link.write(0x94, 1000)
        assert await link.read(0x94) == 1000


async def test_bytes_written_in_many_pieces_arrive_complete_and_in_order(url: str) -> None:
    with plugged_in(url):
        recorder = await connect(url)
        for _ in range(1000):
            recorder.transport.write(READ[:3])
            recorder.transport.write(READ[3:])
        await recorder.until(1000 * len(ANSWER))
        assert recorder.received == ANSWER * 1000
        await close(recorder)


async def test_a_closed_transport_has_written_all_its_bytes(url: str) -> None:
    gateway = VirtualGateway()
    with plugged_in(url, gateway) as device:
        recorder = await connect(url)
        recorder.transport.write(b"WS10%08X\r" % 1 * 500 + b"WS1100000007\r")
        await close(recorder)
        with device.changed:
            device.host.advance(device.clock.now() + 1)
        assert gateway.memory[0x11] == 7


async def test_closing_ends_a_running_read(url: str) -> None:
    with plugged_in(url) as device:
        recorder = await connect(f"{url}?latency=255")
        await close(recorder)
        assert not device.claims
        again = await connect(url)
        await close(again)


async def test_a_gateway_that_does_not_read_pauses_the_program(url: str) -> None:
    with plugged_in(url, mode=Mode.SYNC_FIFO):
        # In this mode the gateway does not read its pins, so the chip accepts only as many bytes as its FIFO holds.
        recorder = await connect(url)
        while not recorder.paused:
            recorder.transport.write(bytes(8192))
        assert recorder.transport.get_write_buffer_size() > 65536
        recorder.transport.abort()
        await recorder.lost()


async def test_a_paused_reader_gets_all_bytes_later(url: str) -> None:
    with plugged_in(url):
        recorder = await connect(url)
        recorder.transport.pause_reading()
        recorder.transport.write(READ * 500)
        while recorder.transport.get_write_buffer_size():  # noqa: ASYNC110  (there is no event for it)
            await asyncio.sleep(0.01)
        assert recorder.received == b""
        recorder.transport.resume_reading()
        await recorder.until(500 * len(ANSWER))
        assert recorder.received == ANSWER * 500
        await close(recorder)


async def test_a_packet_of_exactly_510_bytes_arrives(url: str) -> None:
    with plugged_in(url, short_packet_after_full=False):
        recorder = await connect(url)
        recorder.transport.write(b"H\r" * 170)
        await recorder.until(510)
        assert recorder.received == b"H\r\n" * 170
        await close(recorder)


# Send-immediate


async def test_the_driver_sets_the_latency_timer_for_send_immediate(url: str) -> None:
    with plugged_in(url) as device:
        recorder = await connect(url)
        choose = recorder.transport.get_extra_info("send_immediate")
        seen = {}
        for mode in ("off", "always", "adaptive"):
            await choose(mode)
            seen[mode] = port_at(device, url).latency
        assert seen == {"off": 16, "always": 1, "adaptive": 1}
        assert port_at(device, url).event_character is None
        await close(recorder)


async def test_a_send_immediate_mode_reaches_gateway_and_chip(url: str) -> None:
    gateway = VirtualGateway()
    with plugged_in(url, gateway) as device:
        async with unity_link.connect(url) as link:
            for mode, number, latency in (("off", 0, 16), ("always", 1, 1), ("adaptive", 2, 1)):
                await link.send_immediate(mode)  # type: ignore[arg-type]  # a Literal, in a loop
                assert (gateway.send_immediate, port_at(device, url).latency) == (number, latency)


async def test_a_latency_timer_in_the_url_holds_for_every_mode(url: str) -> None:
    with plugged_in(url) as device:
        recorder = await connect(f"{url}?latency=7&event_char=0x0D")
        for mode in ("off", "always", "adaptive"):
            await recorder.transport.get_extra_info("send_immediate")(mode)
            assert (port_at(device, url).latency, port_at(device, url).event_character) == (7, 0x0D)
        await close(recorder)


# Faults


async def test_an_unplug_while_reading_is_a_lost_connection(url: str) -> None:
    with plugged_in(url) as device:
        recorder = await connect(f"{url}?latency=255")
        device.unplug()
        error = await recorder.lost()
        assert isinstance(error, ConnectError)
        assert "unplugged" in str(error)
        assert getattr(error.__context__, "errno", None) == 19


async def test_an_unplug_while_writing_is_a_lost_connection(url: str) -> None:
    with plugged_in(url, mode=Mode.SYNC_FIFO) as device:
        recorder = await connect(url)
        recorder.transport.write(bytes(30000))
        await asyncio.sleep(0)
        device.unplug()
        assert "unplugged" in str(await recorder.lost())


async def test_a_call_on_an_unplugged_chip_raises_and_a_new_plug_in_is_found(url: str) -> None:
    with plugged_in(url) as device:
        async with unity_link.connect(url) as link:
            device.unplug()
            with pytest.raises(LinkLostError, match="unplugged"):
                await link.read(1)
        with pytest.raises(ConnectError, match="plugged in"):
            await unity_link.connect(url)
        device.plug_in()
        async with unity_link.connect(url) as link:
            assert await link.read(1) == 0


async def test_a_send_immediate_mode_for_an_unplugged_chip_is_a_lost_link(url: str) -> None:
    with plugged_in(url) as device:
        recorder = await connect(url)
        device.unplug()
        with pytest.raises(LinkLostError):
            await recorder.transport.get_extra_info("send_immediate")("always")
        assert "unplugged" in str(await recorder.lost())


async def test_a_chip_unplugged_while_it_is_opened_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    with plugged_in() as device:

        async def open_and_unplug(url: Any) -> Any:
            chip = await open_in_thread(url)
            device.unplug()
            return chip

        monkeypatch.setattr(with_libusb, "open_in_thread", open_and_unplug)
        with pytest.raises(ConnectError, match="unplugged"):
            await connect("ftdi-async://ftdi:232h/1")


async def test_a_link_reconnects_when_the_chip_is_plugged_in_again(url: str) -> None:
    with plugged_in(url) as device:
        async with unity_link.connect(url, reconnect=True) as link:
            await link.write(1, 5)
            device.unplug()
            device.plug_in()
            assert await asyncio.wait_for(link.read(1), 10) == 5
            assert link.statistics.reconnections == 1


@pytest.mark.parametrize(
    ("image_of", "words"),
    [
        (lambda url: eeprom_for(url, "UART"), "2H a UART"),
        (lambda _url: BLANK, "blank"),
        (lambda url: eeprom_for(url, "FIFO")[:-1] + b"\x55", "checksum"),
    ],
)
async def test_a_port_that_is_no_fifo_is_refused_with_the_remedy(
    url: str, place: str, image_of: Callable[[str], bytes], words: str
) -> None:
    with plugged_in(url, image=image_of(url)), pytest.raises(ConnectError, match=words) as refused:
        await connect(url)
    assert f"unity-link ft232h configure ftdi://{place} --mode fifo" in str(refused.value)


async def test_a_fifo_is_refused_as_a_uart(url: str) -> None:
    with plugged_in(url), pytest.raises(ConnectError, match="--mode uart"):
        await connect(f"{url}?mode=uart")


async def test_a_chip_in_use_by_another_program_is_reported(url: str) -> None:
    with plugged_in(url) as device:
        device.claims[port_in(url) - 1] = object()
        with pytest.raises(ConnectError, match="in use by another program"):
            await connect(url)


async def test_a_chip_that_this_program_has_open_is_refused(url: str) -> None:
    with plugged_in(url):
        recorder = await connect(url)
        with pytest.raises(ConnectError, match="in use"):
            await connect(url)
        recorder.transport.write(READ)
        await recorder.until(len(ANSWER))
        await close(recorder)


async def test_the_error_without_permission_names_the_udev_rule(url: str) -> None:
    with plugged_in(url) as device:
        device.denied = True
        with pytest.raises(ConnectError, match=r"/etc/udev/rules\.d/70-ft232h\.rules"):
            await connect(url)


async def test_a_missing_chip_is_reported(url: str) -> None:
    with installed(VirtualBus()), pytest.raises(ConnectError, match="is it plugged in"):
        await connect(url)


async def test_the_serial_number_selects_one_of_two_chips(url: str) -> None:
    def chip(serial: str) -> VirtualFt232h:
        return VirtualFt232h(
            GatewayBoard(VirtualGateway()), kind=kind_in(url), image=eeprom_for(url, "FIFO", serial=serial)
        )

    def of(serial: str) -> str:
        return url.replace("/1", f":{serial}/1").replace("/2", f":{serial}/2")

    first, second = chip("AAA"), chip("BBB")
    with installed(VirtualBus(first, second)):
        recorder = await connect(of("BBB"))
        assert (list(first.claims), list(second.claims)) == ([], [port_in(url) - 1])
        other = await connect(of("AAA"))
        await close(recorder)
        await close(other)
        with pytest.raises(ConnectError, match="2 USB devices match"):
            await connect(url)


async def test_an_overrun_is_counted_and_logged_once(url: str, caplog: pytest.LogCaptureFixture) -> None:
    with plugged_in(url) as device, caplog.at_level(logging.WARNING, "unity_link"):
        recorder = await connect(url)
        for count in (1, 2):
            device.report_error(OVERRUN, port_in(url))
            recorder.transport.write(READ)
            await recorder.until(count * len(ANSWER))
        assert recorder.transport.get_extra_info("line_errors") == 2
        assert caplog.text.count("lost bytes") == 1
        await close(recorder)


async def test_the_status_of_every_packet_of_a_read_is_checked() -> None:
    stripper = StatusStripper()
    good, bad = b"\x02\x60" + b"a" * 510, b"\x02\x62" + b"b" * 510
    assert stripper.strip(good + bad + b"\x02\x60c") == b"a" * 510 + b"b" * 510 + b"c"
    assert stripper.errors == 1


@pytest.mark.parametrize("endpoint_of", [in_endpoint, out_endpoint])
async def test_a_stalled_endpoint_is_cleared(url: str, endpoint_of: Callable[[int], int]) -> None:
    with plugged_in(url) as device:
        recorder = await connect(url)
        device.halt(endpoint_of(port_in(url)))
        recorder.transport.write(READ)
        await recorder.until(len(ANSWER))
        assert recorder.received == ANSWER
        await close(recorder)


async def test_an_endpoint_that_keeps_stalling_is_a_lost_connection(url: str, monkeypatch: pytest.MonkeyPatch) -> None:
    with plugged_in(url) as device:
        recorder = await connect(url)
        monkeypatch.setattr(device.chip, "halted", NeverCleared([in_endpoint(port_in(url))]))
        device.halt(in_endpoint(port_in(url)))
        assert "stalled" in str(await recorder.lost())


class NeverCleared(set[int]):
    """Endpoints that stay halted."""

    def discard(self, element: object, /) -> None:
        pass


async def test_a_gateway_that_never_reads_is_reported_after_a_while(url: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("unity_link.transport.ft232h.chip.WRITE_PATIENCE", 0.01)
    with plugged_in(url, mode=Mode.SYNC_FIFO):
        recorder = await connect(url)
        recorder.transport.write(bytes(FT2232H.fifo_size + 1))
        assert "has not read" in str(await recorder.lost())


async def test_a_cancelled_opening_leaves_the_chip_closed(url: str) -> None:
    with plugged_in(url) as device:
        opening = asyncio.create_task(connect(url))
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        opening.cancel()
        with pytest.raises(asyncio.CancelledError):
            await opening
        # A thread of the event loop opens the chip, and a thread of its own closes it.
        await asyncio.get_running_loop().shutdown_default_executor()
        for thread in threading.enumerate():
            if thread.name == "ft232h close":
                thread.join(10)
        assert not device.claims


# Two ports of one chip


@pytest.fixture(params=["ftdi", "ftdi-async"])
def both(request: pytest.FixtureRequest) -> tuple[str, str]:
    """Return the URLs of both ports."""
    return f"{request.param}://ftdi:2232h/1", f"{request.param}://ftdi:2232h/2"


@contextmanager
def two_ports(**settings: Any) -> Iterator[tuple[VirtualFt232h, VirtualGateway, VirtualGateway]]:
    first, second = VirtualGateway(), VirtualGateway()
    device = VirtualFt232h(GatewayBoard(first), GatewayBoard(second), kind=FT2232H, **settings)
    with installed(VirtualBus(device)):
        yield device, first, second


async def test_both_ports_of_a_chip_have_independent_links(both: tuple[str, str]) -> None:
    with two_ports() as (device, first, second):
        async with unity_link.connect(both[0]) as one:
            async with unity_link.connect(f"{both[1]}?latency=9") as other:
                await asyncio.gather(
                    one.write_many(list(range(200)), [1] * 200),
                    other.write_many(list(range(200)), [2] * 200),
                )
                assert [port.latency for port in device.chip.ports] == [1, 9]
            assert await one.read(5) == 1
        assert (first.memory[7], second.memory[7]) == (1, 2)
        assert not device.claims


async def test_an_open_port_is_refused_and_the_other_port_can_be_opened(both: tuple[str, str]) -> None:
    with two_ports():
        recorder = await connect(both[1])
        with pytest.raises(ConnectError, match="in use"):
            await connect(both[1])
        other = await connect(both[0])
        await close(recorder)
        again = await connect(both[1])
        for opened in (other, again):
            opened.transport.write(READ)
            await opened.until(len(ANSWER))
            await close(opened)


async def test_a_port_can_be_opened_if_another_program_uses_the_other_port(both: tuple[str, str]) -> None:
    with two_ports() as (device, _, _):
        device.claims[0] = object()
        await close(await connect(both[1]))
        with pytest.raises(ConnectError, match="in use by another program"):
            await connect(both[0])


async def test_an_unplug_ends_both_ports_and_both_can_be_opened_again(both: tuple[str, str]) -> None:
    with two_ports() as (device, _, _):
        lost = [await connect(url) for url in both]
        device.unplug()
        for recorder in lost:
            assert "unplugged" in str(await recorder.lost())
        device.plug_in()
        for recorder in [await connect(url) for url in both]:
            await close(recorder)


async def test_the_synchronous_fifo_is_refused_on_port_b(both: tuple[str, str]) -> None:
    with two_ports(), pytest.raises(ArgumentError, match="on port A alone"):
        await connect(f"{both[1]}?mode=ft245-sync")


async def test_a_port_that_the_chip_does_not_have_is_refused() -> None:
    with plugged_in(), pytest.raises(ConnectError, match="No such FTDI port: 2"):
        await connect("ftdi://ftdi:232h/2")


@pytest.mark.parametrize(("product", "release", "name"), [(0x6011, 0x0800, "FT4232H"), (0x6010, 0x0500, "FT2232C")])
async def test_a_chip_without_a_high_speed_fifo_is_refused_by_its_name(product: int, release: int, name: str) -> None:
    kind = structs.replace(FT2232H, product_id=product, release=release)
    device = VirtualFt232h(GatewayBoard(VirtualGateway()), kind=kind)
    with installed(VirtualBus(device)):
        with pytest.raises(ConnectError, match=f"is an {name}, which has no high-speed FIFO"):
            await connect("ftdi:///1")
        assert not device.claims
        assert list_chips() == []


async def test_the_reported_rate_is_that_of_pyftdi_and_of_the_chip() -> None:
    url = f"{URL}?mode=uart"
    with plugged_in(mode=Mode.UART, image=eeprom_for(URL, "UART")) as device:
        chip = open_chip(parse_url(url))
        compared = 0
        for baud in [*range(184, 20_000, 171), *range(20_000, 12_000_000, 40_009), 6_000_000, 7_000_000, 8_000_000]:
            # pyftdi refuses rates with an error of more than 3 %.
            with suppress(ValueError):
                chip.ftdi.set_baudrate(baud)
                assert made_of(baud) == chip.ftdi.baudrate == round(port_at(device, url).baud)
                compared += 1
        chip.close()
    assert compared > 300
