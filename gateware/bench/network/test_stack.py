"""The compiled gateway with the kernel's own network stack: its ARP, ICMP and UDP, as other programs see them."""

from __future__ import annotations

import contextlib
import re
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
import trio

import unity_link
from gateware.bench.network.host import checked
from gateware.bench.network.tap import GATEWAY, HOST, INTERFACE, URL, own_network, plugged
from gateware.bench.network.wire import GATEWAY_MAC, GATEWAY_PORT
from unity_link import blocking

if TYPE_CHECKING:
    from collections.abc import Iterator

    from gateware.bench.network.tap import Plugged

pytest_plugins = ["gateware.bench.network.fixtures"]
pytestmark = pytest.mark.slow
MAC = GATEWAY_MAC.hex(":")


def ran(*command: str) -> str:
    """Return the output of a program, which must succeed within a minute."""
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


def exchange(words: int = 20) -> None:
    """Write words to a gateway and read them back."""
    with blocking.connect(URL, timeout=60) as link:
        link.write_block(0x20, range(words))
        assert link.read_block(0x20, words).tolist() == [*range(words)]
        link.write(0x10, 42)
        assert link.read(0x10) == 42


def test_kernel_resolves_the_station_and_pings_of_all_sizes_are_answered(gateway: Plugged) -> None:
    for size in (0, 1, 56, 1472):
        said = ran("ping", "-n", "-c", "3", "-w", "50", "-i", "0.2", "-s", str(size), "-M", "do", GATEWAY)
        assert "3 received" in said
    assert MAC in ran("ip", "neighbour", "show", GATEWAY)
    assert gateway.written() == []


def test_arping_is_answered_by_the_station_alone(gateway: Plugged) -> None:
    said = ran("arping", "-c", "3", "-I", INTERFACE, GATEWAY).lower()
    assert set(re.findall(r"(?:[0-9a-f]{2}:){5}[0-9a-f]{2}", said)) == {MAC}
    assert gateway.written() == []


def test_link_reads_and_writes_through_a_packet_socket_without_a_tap() -> None:
    with own_network(), plugged(kind="veth") as gateway:
        exchange()
        assert gateway.written()[-1] == (0x10, 42)


def test_trio_link_opens_in_a_namespace_after_a_program_outside_of_it() -> None:
    async def read_one_word() -> int:
        async with unity_link.connect(URL, timeout=60) as link:
            return await link.read(0x10)

    # Its thread stays idle for ten seconds from now on.
    trio.run(trio.to_thread.run_sync, time.time)
    with own_network(), plugged():
        assert trio.run(read_one_word) == 0


def test_fragments_from_the_kernel_have_no_effect(gateway: Plugged) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        sender.sendto(b"W10FFFFFFFF\r" * 300, (GATEWAY, GATEWAY_PORT))
        exchange()
    assert 0xFFFFFFFF not in [word for _, word in gateway.written()]


def test_group_of_a_killed_program_disturbs_no_other(gateway: Plugged) -> None:
    """A killed program leaves a publishing group; the kernel rejects each of its samples."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as killed:
        killed.settimeout(30)
        killed.connect((GATEWAY, GATEWAY_PORT))
        killed.send(b"Q\r")
        session = killed.recv(2000)[1:9]
        killed.send(checked(b"U%s00000001" % session, b"K0001234"))
        killed.recv(2000)
        killed.send(checked(b"U%s00000002" % session, b"gs0000001000A0110", b"gn00100", number=0x1234))
        killed.recv(2000)
    until = time.monotonic() + 60
    while len(refusals := [frame for frame in gateway.heard if frame[23:24] == b"\x01"]) < 3:
        assert time.monotonic() < until, "no sample was refused within a minute"
        time.sleep(0.01)
    assert {frame[34:36] for frame in refusals} == {b"\x03\x03"}
    exchange()


def test_find_lists_the_board_and_gives_it_another_address_until_its_reset(gateway: Plugged) -> None:
    program, other = str(Path(sys.executable).parent / "unity-link"), "192.168.1.77"
    assert f"{URL}  {MAC}" in ran(program, "find", "--wait", "10")
    assert other in ran(program, "find", "--wait", "10", "--assign", f"{MAC}={other}")
    assert "1 received" in ran("ping", "-n", "-c", "1", "-w", "50", other)
    with blocking.connect(URL.replace(GATEWAY, other), timeout=60) as link:
        link.write(0x10, 7)
    gateway.call("reset")
    exchange()
    assert [word for address, word in gateway.written() if address == 0x10] == [7, 42]


# Captures by other programs


@contextlib.contextmanager
def captured(path: Path) -> Iterator[None]:
    """Run tcpdump, which writes all frames at the interface to a file, until the block ends."""
    command = ["tcpdump", "-Z", "root", "-n", "-U", "--immediate-mode", "-s", "0", "-i", INTERFACE, "-w", str(path)]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as watching:
        assert watching.stderr is not None
        try:
            # tcpdump prints this when the capture has begun.
            assert any("listening on" in line for line in iter(watching.stderr.readline, "")), "tcpdump has not begun"
            yield
        finally:
            watching.send_signal(signal.SIGINT)
            try:
                watching.wait(30)
            except subprocess.TimeoutExpired:
                watching.kill()
                raise


def test_tcpdump_and_tshark_find_nothing_wrong_with_its_frames(gateway: Plugged, tmp_path: Path) -> None:
    path = tmp_path / "seen.pcap"
    with captured(path):
        ran("arping", "-c", "1", "-I", INTERFACE, GATEWAY)
        ran("ping", "-n", "-c", "2", "-w", "50", "-i", "0.2", GATEWAY)
        exchange(100)
    said = ran("tcpdump", "-n", "-vv", "-e", "-r", str(path), "ether", "src", MAC)
    assert f"Reply {GATEWAY} is-at {MAC}" in said
    assert "ICMP echo reply" in said
    assert f"{GATEWAY}.{GATEWAY_PORT} > {HOST}." in said
    assert not re.search(r"bad|wrong|trunc|\[\|", said)
    checks = [option for kind in ("ip", "udp") for option in ("-o", f"{kind}.check_checksum:TRUE")]
    wrong = " or ".join(["_ws.malformed", *(f"{kind}.checksum.status == 0" for kind in ("ip", "udp", "icmp"))])
    seen = ("tshark", "-r", str(path), *checks, "-Y")
    assert ran(*seen, f"eth.src == {MAC} and ({wrong} or _ws.expert.severity >= 0x600000)") == ""
    assert len(ran(*seen, f"eth.src == {MAC} and udp").splitlines()) >= 4
    assert gateway.written()[-1] == (0x10, 42)
