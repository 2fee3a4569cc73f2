"""How many samples and values a second do the bridges transfer without loss? `make bench-ros` writes BRIDGES.md.

A virtual gateway in the bridge's own process publishes at the target rate. A peer in another process counts the
messages that arrive, or sends values, which the bridge counts as it writes them. The paper has 1,800 samples a second
to ROS, and 300 values a second from it.
"""

from __future__ import annotations

import datetime as dt
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from benchmarks.__main__ import machine
from benchmarks.paper.published import FROM_ROS, TO_ROS, value

if TYPE_CHECKING:
    from collections.abc import Iterator

SECONDS = 30.0
MARGIN = 1.02
"""Ratio of the requested rate to the target, so that the measured rate is not slightly below the target."""
RESULTS = Path(__file__).with_name("BRIDGES.md")
PEER = str(Path(__file__).with_name("bridge_peer.py"))
PROGRAM = str(Path(sys.executable).parent / "unity-link")
SPEC = """
group fast(1, 1, TIMESTAMPS);
public bench() {
  GATEWAY(DATA_BITS=64);
  @value = 0x10: float 64 READ(PUBLISH(fast));
  @target = 0x20: float 64 WRITE();
}
"""
GATEWAY = "sim:?data_bits=64&base_frequency_millihertz={}000"


class Row(NamedTuple):
    """Figures of one bridge in one direction."""

    what: str
    rate: float
    """Messages per second, between the first and the last that was received or sent."""
    carried: int
    expected: int
    target: int
    bridge_load: float | None = None
    """CPU seconds per second of the bridge, with those of the gateway in its process."""
    peer_load: float | None = None

    @property
    def met(self) -> bool:
        """Whether the target was reached without loss."""
        return self.rate >= self.target and self.carried == self.expected


def to_peer(kind: str, folder: Path, target: int) -> Row:
    """Measure samples from a bridge to a peer."""
    with peering(kind, "listen") as peer, bridging(kind, folder, round(MARGIN * target)) as bridge:
        with measuring(bridge, peer) as loads:
            time.sleep(SECONDS)
        # The bridge passes all its samples on before it ends.
        published, lost, sent, _ = end(bridge)
        received, seconds = answer(peer).split()
    # A publication of Zenoh contains many samples.
    expected = (published if kind == "zenoh" else sent) + lost
    return Row(f"{kind}: gateway to topic", int(received) / float(seconds), int(received), expected, target, *loads)


def from_peer(kind: str, folder: Path, target: int) -> Row:
    """Measure values from a peer to a bridge."""
    with bridging(kind, folder, 100) as bridge, peering(kind, "talk", MARGIN * target) as peer:
        with measuring(bridge, peer) as loads:
            sent, seconds = answer(peer).split()
        time.sleep(1)
        *_, written = end(bridge)
    return Row(f"{kind}: topic to gateway", written / float(seconds), written, int(sent), target, *loads)


@contextmanager
def measuring(*processes: subprocess.Popen[str]) -> Iterator[list[float]]:
    """Measure the CPU seconds per second of processes during the context."""
    loads: list[float] = []
    before, began = [cpu_seconds(process) for process in processes], time.monotonic()
    yield loads
    elapsed = time.monotonic() - began
    loads += [(cpu_seconds(process) - used) / elapsed for process, used in zip(processes, before, strict=True)]


def cpu_seconds(process: subprocess.Popen[str]) -> float:
    """Return the CPU time that a process has used so far (proc(5), "stat": utime and stime)."""
    fields = Path(f"/proc/{process.pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def recording(folder: Path, target: int) -> Row:
    """Measure samples that are recorded to a file."""
    result = subprocess.run(
        [
            *command("record", round(MARGIN * target), folder),
            "-o",
            str(folder / "run.mcap"),
            "--duration",
            str(SECONDS),
            "--overwrite",
        ],
        capture_output=True,
        text=True,
        check=True,
    )
    carried, lost = numbers(r"([\d,]+) samples in .* ([\d,]+) lost", result.stderr)
    return Row("record: gateway to disk", carried / SECONDS, carried, carried + lost, target)


def command(kind: str, rate: int, folder: Path) -> list[str]:
    """Return the command line of a bridge."""
    spec = folder / "bench.ul"
    spec.write_text(SPEC)
    url = GATEWAY.format(rate)
    if kind == "record":
        return [PROGRAM, kind, url, str(spec)]
    return [PROGRAM, kind, str(spec), "--link", url, *(["--prefix", "bench"] if kind == "zenoh" else [])]


@contextmanager
def bridging(kind: str, folder: Path, rate: int) -> Iterator[subprocess.Popen[str]]:
    """Run a bridge for the duration of the context."""
    with subprocess.Popen(command(kind, rate, folder), stderr=subprocess.PIPE, text=True) as bridge:
        assert bridge.stderr is not None
        for line in bridge.stderr:
            if "published" in line:
                break
        try:
            yield bridge
        finally:
            bridge.kill()


@contextmanager
def peering(kind: str, what: str, rate: float = 0.0) -> Iterator[subprocess.Popen[str]]:
    """Run a peer for the duration of the context."""
    python = "/usr/bin/python3" if kind == "ros1" else sys.executable
    environment = {**os.environ, "PYTHONPATH": "" if kind == "ros1" else str(Path(__file__).parents[1])}
    with subprocess.Popen(
        [python, "-W", "ignore", PEER, kind, what, str(SECONDS), str(rate)],
        stdout=subprocess.PIPE,
        text=True,
        env=environment,
    ) as peer:
        assert answer(peer) == "ready"
        try:
            yield peer
        finally:
            peer.kill()


def answer(peer: subprocess.Popen[str]) -> str:
    """Return the next line that a peer prints."""
    assert peer.stdout is not None
    return peer.stdout.readline().strip()


def end(bridge: subprocess.Popen[str]) -> tuple[int, ...]:
    """End a bridge; return the numbers of samples published and lost, of messages sent, and of values written."""
    bridge.send_signal(signal.SIGINT)
    assert bridge.stderr is not None
    pattern = r"([\d,]+) samples published, ([\d,]+) lost; ([\d,]+) messages sent, ([\d,]+) values written"
    return numbers(pattern, bridge.stderr.read())


def numbers(pattern: str, text: str) -> tuple[int, ...]:
    """Return the numbers in the output of a program."""
    found = re.search(pattern, text)
    assert found is not None, text
    return tuple(int(number.replace(",", "")) for number in found.groups())


@contextmanager
def ros_master(folder: Path) -> Iterator[None]:
    """Run a ROS 1 master for the duration of the context."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_IP="127.0.0.1", ROS_HOME=str(folder))
    with subprocess.Popen(
        [str(shutil.which("rosmaster")), "--core", "-p", str(port)], stdout=subprocess.DEVNULL
    ) as process:
        try:
            yield
        finally:
            process.kill()


def document(rows: list[Row]) -> str:
    """Return the text of BRIDGES.md."""
    to_ros, from_ros = value(TO_ROS, "ROS"), value(FROM_ROS, "ROS")
    lines = [
        "# Bridges",
        "",
        f"Sustained for {SECONDS:.0f} s, from a virtual gateway in the bridge's process to a peer in another process,",
        "and back. The rate is that between the first message and the last; CPU is the share of one core, with the",
        "virtual gateway included in the bridge's share.",
        "`make bench-ros` runs it again.",
        f"The paper: {to_ros:,.0f} samples a second to ROS, {from_ros:,.0f} values a second from it.",
        "",
        f"Seen on {dt.datetime.now(dt.UTC):%Y-%m-%d}: {machine()}.",
        "",
        "| Bridge | a second | carried | lost | target | met | CPU of the bridge | of the peer |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        met = "yes" if row.met else "**no**"
        lost = row.expected - row.carried
        loads = " | ".join("" if load is None else f"{load:.0%}" for load in (row.bridge_load, row.peer_load))
        lines.append(
            f"| {row.what} | {row.rate:,.0f} | {row.carried:,} | {lost:,} | {row.target:,} | {met} | {loads} |"
        )
    return "\n".join(lines) + "\n"


def main() -> None:
    """Measure all bridges whose peers are installed on this machine."""
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if shutil.which("rosmaster"):
            with ros_master(folder):
                rows += [to_peer("ros1", folder, 30_000), from_peer("ros1", folder, 10_000)]
        for kind in ("ros2", "zenoh"):
            rows += [to_peer(kind, folder, 25_000), from_peer(kind, folder, 25_000)]
        rows.append(recording(folder, 50_000))
    text = document(rows)
    RESULTS.write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
