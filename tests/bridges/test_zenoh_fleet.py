"""Fifty virtual gateways in one group of peers without a router: two processes of 25 bridges each, and this process."""

from __future__ import annotations

import socket
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
import pytest

from unity_link import blocking
from unity_link.transport.zenoh_session import Network, close_session, open_session

if TYPE_CHECKING:
    from collections.abc import Iterator

    import zenoh

SPEC = str(Path(__file__).parents[2] / "examples" / "scara.ul")
ROBOTS, PROCESSES = 50, 2
PATIENCE = 240
pytestmark = pytest.mark.slow

BRIDGES = """
import asyncio, sys
from unity_link.bridges.zenoh import Network, ZenohBridge
from unity_link.data import load

async def main(spec, endpoint, first, last):
    robot = load(spec)
    network = Network(connect=(endpoint,), listen=("tcp/127.0.0.1:0",))
    gateway = "sim:scara?base_frequency_millihertz=200000"
    bridges = [ZenohBridge(robot, gateway, f"fleet/{n}", network=network, every=0.5) for n in range(first, last)]
    await asyncio.gather(*[bridge.run() for bridge in bridges])

asyncio.run(main(sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])))
"""


@contextmanager
def fleet(endpoint: str) -> Iterator[list[subprocess.Popen[bytes]]]:
    each = ROBOTS // PROCESSES
    arguments = [(str(number * each), str((number + 1) * each)) for number in range(PROCESSES)]
    processes = [subprocess.Popen([sys.executable, "-c", BRIDGES, SPEC, endpoint, *part]) for part in arguments]
    try:
        yield processes
    finally:
        for process in processes:
            process.kill()
            process.wait()


def positions(peer: zenoh.Session) -> dict[int, float]:
    """Return the position of each robot, by one query to all."""
    replies = peer.get("fleet/*/signals/j1/pos_sp", timeout=PATIENCE)
    answers = [reply.ok for reply in replies if reply.ok is not None]
    return {int(str(one.key_expr).split("/")[1]): msgspec.json.decode(one.payload.to_bytes()) for one in answers}


def wait_for_robots(peer: zenoh.Session, count: int) -> None:
    deadline = time.monotonic() + PATIENCE
    while len(positions(peer)) != count:
        assert time.monotonic() < deadline
        time.sleep(0.1)


def test_fifty_gateways_answer_each_for_itself_when_some_are_killed() -> None:
    with socket.create_server(("127.0.0.1", 0)) as free:
        endpoint = f"tcp/127.0.0.1:{free.getsockname()[1]}"
    peer = open_session(Network(listen=(endpoint,)))
    sampled: set[str] = set()
    try:
        with fleet(endpoint) as processes:
            subscriber = peer.declare_subscriber("fleet/*/samples/*", lambda one: sampled.add(str(one.key_expr)))
            wait_for_robots(peer, ROBOTS)

            for number in range(ROBOTS):
                (reply,) = peer.get(f"fleet/{number}/write", payload=f'{{"j1.pos_sp": {number}}}', timeout=PATIENCE)
                assert reply.ok is not None
            assert positions(peer) == pytest.approx({number: number for number in range(ROBOTS)}, abs=0.01)
            with blocking.connect(f"zenoh:fleet/17?connect={endpoint}", timeout=PATIENCE) as link:
                assert link.read(0x8C) == round(17 * 50 * 4000 / 360)
            deadline = time.monotonic() + PATIENCE
            while len(sampled) < ROBOTS:
                assert time.monotonic() < deadline
                time.sleep(0.1)

            processes[0].kill()
            wait_for_robots(peer, ROBOTS // PROCESSES)
            assert set(positions(peer)) == set(range(ROBOTS // PROCESSES, ROBOTS))
            del subscriber
    finally:
        close_session(peer)
