"""The drivers on a real USB stack: the virtual chip, attached by USB/IP, with libusb and the kernel.

The tests need root and the kernel's vhci-hcd; `tests/usb/in_qemu.sh` runs them if the kernel of the machine has none.
"""

from __future__ import annotations

import asyncio
import os
import socket
import statistics
import struct
import subprocess
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

import unity_link
from unity_link.errors import LinkLostError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from unity_link import Link
    from unity_link.link.link import SendImmediate

VHCI = Path("/sys/devices/platform/vhci_hcd.0")
pytestmark = [
    pytest.mark.asyncio,
    pytest.mark.usb,
    pytest.mark.slow,
    pytest.mark.skipif(not os.access(VHCI / "attach", os.W_OK), reason="needs root and the kernel's vhci-hcd"),
]
HIGH_SPEED = 3
USB_DEVICES = Path("/sys/bus/usb/devices")


def chips() -> list[Path]:
    """Return the FT232H devices that the kernel has."""
    return [path.parent for path in USB_DEVICES.glob("*/idProduct") if path.read_text().strip() == "6014"]


def wait_for(condition: Callable[[], object]) -> None:
    end = time.monotonic() + 30
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.05)


@pytest.fixture
def chip() -> Iterator[subprocess.Popen[str]]:
    """Attach a chip; yield the process that simulates it."""
    command = [str(Path(sys.executable).parent / "unity-link"), "simulate", "--usbip", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as served:
        try:
            assert served.stdout is not None
            port = int(served.stdout.readline().split()[2])
            with socket.create_connection(("127.0.0.1", port)) as connection:
                connection.sendall(bytes.fromhex("0111 8003 00000000") + b"1-1".ljust(32, b"\0"))
                reply = connection.recv(320, socket.MSG_WAITALL)
                bus, device = struct.unpack(">II", reply[296:304])
                # The kernel keeps the connection after this process has closed its own descriptor.
                (VHCI / "attach").write_text(f"0 {connection.fileno()} {bus << 16 | device} {HIGH_SPEED}")
            wait_for(lambda: chips() and (chips()[0] / "bNumInterfaces").exists())
            yield served
        finally:
            served.terminate()
    wait_for(lambda: not chips())


@pytest.mark.parametrize("scheme", ["ftdi", "ftdi-async"])
async def test_reads_writes_and_samples_pass_a_real_usb_stack(
    chip: subprocess.Popen[str], scheme: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert chip.poll() is None
    async with unity_link.connect(f"{scheme}://ftdi:232h:UL000001/1", timeout=20) as link:
        await link.write_many(range(256), range(1000, 1256))
        times = []
        for address in range(200):
            start = time.perf_counter()
            assert await link.read(address) == 1000 + address
            times.append(time.perf_counter() - start)
        assert list(await link.read_block(0, 256)) == list(range(1000, 1256))
        start = time.perf_counter()
        assert list(await link.read_many([index % 256 for index in range(5000)])) == [
            1000 + index % 256 for index in range(5000)
        ]
        rate = 5000 / (time.perf_counter() - start)
        with capsys.disabled():
            sys.stdout.write(
                f"\n{scheme}: lone read {1e6 * statistics.median(times):.0f} us, {rate:.0f} reads a second in a batch\n"
            )
        async with link.subscribe(7, rate_hz=500) as samples:
            count = 0
            async for sample in samples:
                assert list(sample.values) == [1007]
                count += 1
                if count == 200:
                    break
        modes: tuple[SendImmediate, ...] = ("off", "always", "adaptive")
        for mode in modes:
            await link.send_immediate(mode)
            assert await link.read(1) == 1001


@pytest.mark.parametrize("scheme", ["ftdi", "ftdi-async"])
async def test_an_unplugged_chip_is_a_lost_link(chip: subprocess.Popen[str], scheme: str) -> None:
    async with unity_link.connect(f"{scheme}://ftdi:232h/1", timeout=20) as link:
        await link.write(1, 2)
        chip.terminate()
        with pytest.raises(LinkLostError):
            await asyncio.wait_for(read_for_ever(link), 30)


async def read_for_ever(link: Link) -> None:
    while True:
        await link.read(1)
