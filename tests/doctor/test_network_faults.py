"""`unity-link doctor udp://...` finds each fault of a network: at simulated stations, and behind a lossy relay."""

from __future__ import annotations

import asyncio
import json
import os
import select
import struct
import subprocess
import sys
import threading
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gateware.bench.network.host import HOST_IP, sum_of
from gateware.bench.network.tap import GATEWAY, LINE, URL, line, own_network, run_ip
from gateware.bench.network.wire import GATEWAY_IP, GATEWAY_MAC
from unity_link.protocol.wire import discovery
from unity_link.protocol.wire.discovery import Found
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Straying
from unity_link.virtual.serving import serve_udp
from unity_link.virtual.udp_relay import relay_udp

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

PROGRAM = str(Path(sys.executable).parent / "unity-link")
OTHER_MAC = GATEWAY_MAC[:-1] + b"\x02"


def examined(url: str) -> dict[str, dict[str, str]]:
    """Run the command; return the faults by their names, without those of a slow computer."""
    done = subprocess.run([PROGRAM, "doctor", url, "--json"], capture_output=True, text=True, timeout=120, check=False)
    assert "Traceback" not in done.stderr
    findings = [json.loads(line) for line in done.stdout.splitlines()]
    return {
        finding["fault"]: finding for finding in findings if finding["fault"] not in (None, "slow host", "slow link")
    }


def is_at(frame: bytes, mac: bytes) -> bytes:
    """Return the answer to an ARP request."""
    head = frame[6:12] + mac + b"\x08\x06" + struct.pack("!HHBBH", 1, 0x0800, 6, 4, 2)
    return head + mac + frame[38:42] + frame[22:32]


def unreachable(frame: bytes, code: int) -> bytes:
    """Return the ICMP message that refuses a datagram."""
    message = struct.pack("!BBHI", 3, code, 0, 0) + frame[14:42]
    message = message[:2] + struct.pack("!H", sum_of(message)) + message[4:]
    head = struct.pack("!BBHHHBBH", 0x45, 0, 20 + len(message), 1, 0, 64, 1, 0) + GATEWAY_IP + HOST_IP
    head = head[:10] + struct.pack("!H", sum_of(head)) + head[12:]
    return frame[6:12] + GATEWAY_MAC + b"\x08\0" + head + message


def silent_station(frame: bytes) -> list[bytes]:
    is_question = frame[12:14] == b"\x08\x06" and frame[38:42] == GATEWAY_IP
    return [is_at(frame, GATEWAY_MAC)] if is_question else []


def refusing_station(code: int) -> Callable[[bytes], list[bytes]]:
    def answer(frame: bytes) -> list[bytes]:
        is_datagram = frame[12:14] == b"\x08\0" and frame[23] == 17 and frame[30:34] == GATEWAY_IP
        return [unreachable(frame, code)] if is_datagram else silent_station(frame)

    return answer


@contextmanager
def station(answer: Callable[[bytes], list[bytes]]) -> Iterator[None]:
    """Run a station that answers the kernel's frames; in the block this thread is in a network namespace with it."""
    over = threading.Event()

    def run(descriptor: int) -> None:
        while not over.is_set():
            if select.select([descriptor], [], [], 0.05)[0]:
                for frame in answer(os.read(descriptor, 2048)):
                    os.write(descriptor, frame)

    with own_network(), line(LINE) as descriptor:
        thread = threading.Thread(target=run, args=(descriptor,))
        thread.start()
        try:
            yield
        finally:
            over.set()
            thread.join()


@pytest.mark.slow
def test_an_address_without_a_station_is_found() -> None:
    with station(lambda _: []):
        found = examined(URL)
    assert [*found] == ["no such station"]
    assert (
        f"no station has the address {GATEWAY} in the network that 192.168.1.5 is in"
        in found["no such station"]["text"]
    )


@pytest.mark.slow
def test_a_station_that_answers_arp_and_no_datagram_is_behind_a_firewall() -> None:
    with station(silent_station):
        found = examined(URL)
    assert [*found] == ["firewall"]
    text = f"the station {GATEWAY_MAC.hex(':')} has the address {GATEWAY}, and answers no datagram at port 21845"
    assert found["firewall"]["text"] == text


@pytest.mark.parametrize("code", [9, 10, 13])
def test_a_firewall_that_refuses_by_icmp_is_found(code: int) -> None:
    with station(refusing_station(code)):
        found = examined(URL)
    assert [*found] == ["firewall"]
    assert f"ICMP says that it is administratively prohibited (code {code})" in found["firewall"]["text"]


def test_a_datagram_port_without_a_listener_is_found() -> None:
    with station(refusing_station(3)):
        found = examined(URL)
    assert [*found] == ["nothing listens"]


def answering_stations(*macs: bytes) -> Callable[[bytes], list[bytes]]:
    """Return a function that answers as boards with one IP address do; the first of `macs` answers datagrams."""

    def answer(frame: bytes) -> list[bytes]:
        if frame[12:14] != b"\x08\0" or frame[23] != 17:
            return [is_at(frame, mac) for mac in macs if silent_station(frame)]
        if frame[42:44] == b"U?":
            found = [Found(mac, GATEWAY_IP, 0, has_fingerprint=False, session_open=False, name="twin") for mac in macs]
            return [datagram(frame, each.mac, discovery.answer(each)) for each in found]
        return [datagram(frame, macs[0], b"U0000000100000000\r\nH\r\n")] if frame[42:44] == b"H\r" else []

    return answer


def datagram(frame: bytes, mac: bytes, data: bytes) -> bytes:
    """Return a datagram that answers the one in a frame."""
    head = struct.pack("!BBHHHBBH", 0x45, 0, 28 + len(data), 1, 0, 64, 17, 0) + GATEWAY_IP + HOST_IP
    head = head[:10] + struct.pack("!H", sum_of(head)) + head[12:]
    ports = frame[36:38] + frame[34:36]
    return frame[6:12] + mac + b"\x08\0" + head + ports + struct.pack("!HH", 8 + len(data), 0) + data


@pytest.mark.slow
def test_two_boards_with_one_ip_address_are_reported_with_their_macs() -> None:
    with station(answering_stations(GATEWAY_MAC, OTHER_MAC)):
        found = examined(URL)
    macs = " and ".join(f"{mac.hex(':')} (twin)" for mac in (GATEWAY_MAC, OTHER_MAC))
    assert f"{GATEWAY} is the address of {macs}" in found["two of one address"]["text"]


@pytest.mark.slow
def test_two_boards_with_one_mac_address_are_found() -> None:
    with station(answering_stations(GATEWAY_MAC, GATEWAY_MAC)):
        found = examined(URL)
    assert f"two boards have the MAC address {GATEWAY_MAC.hex(':')}" in found["two of one address"]["text"]


def test_a_route_that_this_computer_prohibits_is_found() -> None:
    with station(silent_station):
        run_ip("route", "add", "prohibit", f"{GATEWAY}/32")
        found = examined(URL)
    assert [*found] == ["firewall"]


def test_a_network_without_a_route_is_found() -> None:
    with own_network():
        found = examined(URL)
    assert [*found] == ["failed"]
    assert "Network is unreachable" in found["failed"]["text"]


def test_loss_is_reported_with_its_rate_and_the_link_is_examined() -> None:
    async def examine() -> dict[str, dict[str, str]]:
        lossy = [Straying[object](seed, loss=0.05) for seed in (1, 2)]
        async with serve_udp(VirtualGateway()) as url, relay_udp(url, *lossy) as relayed:  # type: ignore[arg-type]
            return await asyncio.to_thread(examined, relayed)

    found = asyncio.run(examine())
    assert [*found] == ["loss"]
    assert "datagrams not answered: about one in " in found["loss"]["text"]


def test_a_healthy_network_has_no_fault() -> None:
    async def examine() -> dict[str, dict[str, str]]:
        async with serve_udp(VirtualGateway()) as url:
            return await asyncio.to_thread(examined, url)

    assert asyncio.run(examine()) == {}
