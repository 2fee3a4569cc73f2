"""A compiled gateway at this machine's own network stack: its cable ends at an interface of the kernel, in a namespace.

A thread in a network namespace of its own (`own_network`) has an interface there, `ul0`, to which a `Wire` is connected
(`plugged`). So ARP, ICMP and UDP are the kernel's, and programs that this thread starts are in the namespace too.

The interface is a TAP device, or one end of a veth pair with a packet socket at the other end if there is no TAP:
`LINE` has the name of the kind on this machine. Both need root, or `unshare --user --map-root-user`.
"""

from __future__ import annotations

import contextlib
import ctypes
import fcntl
import os
import select
import socket
import stat
import struct
import subprocess
import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any
from unittest import mock

import pytest
from trio._core import _thread_cache

from gateware.bench.network.host import HOST_IP
from gateware.bench.network.wire import GATEWAY_IP, GATEWAY_PORT, Wire
from unity_link.virtual.faults import Straying

if TYPE_CHECKING:
    from collections.abc import Iterator

INTERFACE = "ul0"
GATEWAY = ".".join(map(str, GATEWAY_IP))
HOST = ".".join(map(str, HOST_IP))
URL = f"udp://{GATEWAY}:{GATEWAY_PORT}"
_OTHER_END = "ul1"
_TUN = Path("/dev/net/tun")
_TUN_NUMBER = (10, 200)
_TUNSETIFF = 0x400454CA
_IFF_TAP, _IFF_NO_PI = 0x0002, 0x1000
_ETH_P_ALL = 3
_CLONE_NEWNET = 0x40000000
_LONGEST_FRAME = 2048
_SLICE = 1000
"""Maximum number of cycles of a slice; a slice ends earlier if the gateway has sent a frame."""
_SILENCE = 50
"""Number of slices without a frame after which the gateway runs only half of the time, to save processor time."""


def _has_tap() -> bool:
    with contextlib.suppress(OSError):
        if not _TUN.exists():
            _TUN.parent.mkdir(exist_ok=True)
            os.mknod(_TUN, 0o600 | stat.S_IFCHR, os.makedev(*_TUN_NUMBER))
        os.close(os.open(_TUN, os.O_RDWR))
        return True
    return False


LINE = "tap" if _has_tap() else "veth"
"""Kind of the line between kernel and gateway, for the names of tests."""


# Namespaces


def _call(name: str, *arguments: int) -> None:
    libc = ctypes.CDLL(None, use_errno=True)
    if getattr(libc, name)(*arguments) != 0:
        raise OSError(ctypes.get_errno(), f"{name}: {os.strerror(ctypes.get_errno())}")


@contextlib.contextmanager
def own_network() -> Iterator[None]:
    """Move this thread, and the programs that it starts, into a network namespace of its own with only the loopback."""
    before = os.open("/proc/thread-self/ns/net", os.O_RDONLY)
    try:
        try:
            _call("unshare", _CLONE_NEWNET)
        except PermissionError:
            pytest.skip("no network namespace can be made: run it as root, or behind `unshare --user --map-root-user`")
        try:
            run_ip("link", "set", "lo", "up")
            # A thread stays in the namespace in which it began, and trio reuses idle threads of earlier runs.
            with mock.patch.object(_thread_cache, "THREAD_CACHE", _thread_cache.ThreadCache()):
                yield
        finally:
            _call("setns", before, _CLONE_NEWNET)
    finally:
        os.close(before)


def run_ip(*arguments: str) -> None:
    """Run the program `ip`.

    Raises:
        OSError: if it fails, with its error text.
    """
    done = subprocess.run(["ip", *arguments], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise OSError(f"ip {' '.join(arguments)}: {done.stderr.strip()}")


# Lines


def _open_tap() -> int:
    line = os.open(_TUN, os.O_RDWR)
    fcntl.ioctl(line, _TUNSETIFF, struct.pack("16sH22x", INTERFACE.encode(), _IFF_TAP | _IFF_NO_PI))
    return line


def _open_veth() -> int:
    run_ip("link", "add", INTERFACE, "type", "veth", "peer", "name", _OTHER_END)
    # Keep the kernel from sending frames of its own at the gateway's end.
    with contextlib.suppress(OSError):
        Path(f"/proc/sys/net/ipv6/conf/{_OTHER_END}/disable_ipv6").write_text("1")
    run_ip("link", "set", _OTHER_END, "up")
    with socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(_ETH_P_ALL)) as opened:
        opened.bind((_OTHER_END, 0))
        return opened.detach()


@contextlib.contextmanager
def line(kind: str) -> Iterator[int]:
    """Return a descriptor for the frames of the interface `INTERFACE`, in the namespace of this thread."""
    opened = _open_tap() if kind == "tap" else _open_veth()
    try:
        run_ip("address", "add", f"{HOST}/24", "dev", INTERFACE)
        run_ip("link", "set", INTERFACE, "up")
        yield opened
    finally:
        os.close(opened)
        if kind == "veth":
            run_ip("link", "delete", INTERFACE)


class Plugged:
    """A gateway at the interface, run by a thread.

    Args:
        wire: the gateway.
        line: descriptor from which the kernel's frames are read, and to which frames for the kernel are written.
        towards: loses or delays frames on their way to the gateway.
        back: loses or delays frames of the gateway.
    """

    def __init__(self, wire: Wire, line: int, towards: Straying[bytes], back: Straying[bytes]) -> None:
        self._wire, self._line = wire, line
        self._towards, self._back = towards, back
        self._runs, self._over = threading.Event(), threading.Event()
        self._lock = threading.Lock()
        self._error: BaseException | None = None
        self._thread = threading.Thread(target=self._pump, daemon=True)
        self.heard: list[bytes] = []
        """Frames from the kernel."""
        self._runs.set()
        self._thread.start()

    def call(self, name: str, *arguments: Any, **options: Any) -> Any:
        """Call a method of the wire between two slices, and return its result."""
        with self._lock:
            return getattr(self._wire, name)(*arguments, **options)

    def written(self) -> list[tuple[int, int]]:
        """Return address and word of all writes to the bus."""
        writes: list[tuple[int, int]] = self.call("writes")
        return writes

    def pause(self) -> None:
        """Stop the gateway, as if it had no clock."""
        self._runs.clear()

    def unplug(self) -> None:
        """Stop the gateway for good.

        Raises:
            AssertionError: if a frame of the gateway was damaged.
        """
        self._over.set()
        self._runs.set()
        self._thread.join()
        if self._error is not None:
            raise self._error

    def _pump(self) -> None:
        silent = 0
        try:
            while not self._over.is_set():
                self._runs.wait()
                began = time.monotonic()
                moved = self._turn()
                silent = 0 if moved else silent + 1
                rest = time.monotonic() - began if silent > _SILENCE else 0
                select.select([self._line], [], [], rest)
        except BaseException as error:  # noqa: BLE001  (it is raised where the gateway is unplugged)
            self._error = error

    def _turn(self) -> bool:
        """Move frames, and run the gateway for a slice; return whether any frame was moved or is pending."""
        came = [frame for frame in self._read() for frame in self._towards.carry(frame)]
        with self._lock:
            for frame in came:
                self._wire.put(frame)
            self._wire.run(_SLICE, 1)
            taken = self._wire.take()
            is_moving = bool(came or taken or self._wire.waiting())
        for one in taken:
            assert one.sound, f"a frame without a right preamble or check: {one.body.hex()}"
            for body in self._back.carry(one.body):
                # Ignore the error if the interface is down already.
                with contextlib.suppress(OSError):
                    os.write(self._line, body)
        return is_moving

    def _read(self) -> Iterator[bytes]:
        while select.select([self._line], [], [], 0)[0]:
            frame = os.read(self._line, _LONGEST_FRAME)
            self.heard.append(frame)
            yield frame


@contextlib.contextmanager
def plugged(
    wire: Wire | None = None,
    *,
    kind: str = LINE,
    towards: Straying[bytes] | None = None,
    back: Straying[bytes] | None = None,
) -> Iterator[Plugged]:
    """Connect a gateway to the network namespace of this thread, that of `own_network`.

    Args:
        wire: the gateway; None for a new `Wire`.
        kind: of line, "tap" or "veth".
        towards: loses or delays frames on their way to the gateway; None for an ideal line.
        back: loses or delays frames of the gateway; None for an ideal line.
    """
    made = wire or Wire()
    with line(kind) as descriptor:
        gateway = Plugged(made, descriptor, towards or Straying(), back or Straying())
        try:
            yield gateway
        finally:
            gateway.unplug()
