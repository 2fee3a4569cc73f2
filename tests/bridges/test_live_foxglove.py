"""Samples for the Foxglove app, on its own WebSocket: messages and faults."""

from __future__ import annotations

import json
import signal
import socket
import struct
import subprocess
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Subprotocol

from support.bridge_programs import PATIENCE, PROGRAM, line_of
from support.live_page import FAST, SPEC, Live, gateway, hear, live, looking, memory_of, take

if TYPE_CHECKING:
    from collections.abc import Iterator

STATE = "/scara/state"


@contextmanager
def served(url: str, **options: str) -> Iterator[tuple[Live, str]]:
    """Run `unity-link live` with Foxglove; yield it, and the URL for the app."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = str(free.getsockname()[1])
    with live(url, SPEC, "--foxglove", "--foxglove-port", port, **options) as running:
        address = line_of(running.process)
        assert address == f"ws://127.0.0.1:{port}"
        yield running, address


@contextmanager
def app(url: str, topic: str = STATE) -> Iterator[tuple[ClientConnection, Any]]:
    """Subscribe to a topic as the app does; yield the connection and the channel."""
    with connect(url, subprotocols=[Subprotocol("foxglove.sdk.v1")], max_size=None, close_timeout=0) as connection:
        channels: dict[str, Any] = {}
        while topic not in channels:
            said = connection.recv(timeout=PATIENCE)
            message = json.loads(said) if isinstance(said, str) else {}
            channels |= {one["topic"]: one for one in message.get("channels", [])}
        channel = channels[topic]
        connection.send(json.dumps({"op": "subscribe", "subscriptions": [{"id": 3, "channelId": channel["id"]}]}))
        yield connection, channel


def next_message(connection: ClientConnection) -> tuple[int, Any]:
    """Return the time of the next message in nanoseconds, and its contents."""
    while True:
        said = connection.recv(timeout=PATIENCE)
        if isinstance(said, bytes) and said[0] == 1:
            assert struct.unpack_from("<I", said, 1) == (3,)
            return struct.unpack_from("<Q", said, 5)[0], json.loads(said[13:])


def test_foxglove_gets_the_messages_of_recordings() -> None:
    with served("sim:scara") as (_, url), app(url) as (connection, channel):
        assert (channel["encoding"], channel["schemaEncoding"]) == ("json", "jsonschema")
        assert "cpos" in channel["schema"]
        received = [next_message(connection) for _ in range(100)]
    sequence = [message["sequence"] for _, message in received]
    assert sequence == sorted(set(sequence))
    assert received[0][1]["signals"]["j1"]["cpos"] == 0
    (first, began), (last, ended) = received[0], received[-1]
    assert (last - first) * 1e-9 == pytest.approx(ended["time"] - began["time"], abs=0.1)


@pytest.mark.slow
def test_app_that_stops_reading_delays_no_other_client_and_costs_no_memory() -> None:
    with served(FAST) as (running, url), ExitStack() as stack:
        page = stack.enter_context(looking(running))
        about = hear(page, "about")
        # This app subscribes and then reads no message, so that its socket is soon full.
        stack.enter_context(app(url))
        other, _ = stack.enter_context(app(url))
        seen, before = 0, 0
        while seen < 200_000:
            samples = take(page, about)
            seen += sum(table.shape[1] for table in samples.tables[0])
            if seen < 100_000:
                before = memory_of(running.process.pid)
            assert samples.dropped == 0
            next_message(other)
        assert memory_of(running.process.pid) - before < 32e6


@pytest.mark.slow
def test_messages_continue_when_the_gateway_returns(tmp_path: Path) -> None:
    place = tmp_path / "gateway"
    simulate = ("simulate", "--robot", "scara")
    with ExitStack() as stack:
        with gateway(place, *simulate) as url:
            running, address = stack.enter_context(served(url))
            page = stack.enter_context(looking(running))
            connection, _ = stack.enter_context(app(address))
            next_message(connection)
        while hear(page, "status")["connected"]:
            pass
        before = 0
        while True:
            # Read the messages that were on their way.
            try:
                said = connection.recv(timeout=1)
            except TimeoutError:
                break
            if isinstance(said, bytes) and said[0] == 1:
                before = struct.unpack_from("<Q", said, 5)[0]
        stack.enter_context(gateway(place, *simulate))
        at, _ = next_message(connection)
        assert at > before


def test_ctrl_c_ends_live_with_one_line_although_one_app_does_not_read() -> None:
    with served("sim:scara") as (running, url), app(url) as (connection, _), app(url):
        for _ in range(100):
            next_message(connection)
        running.process.send_signal(signal.SIGINT)
        _, said = running.process.communicate(timeout=PATIENCE)
        assert running.process.returncode == 128 + signal.SIGINT
        assert len(said.splitlines()) == 1
        assert " samples in " in said


def test_taken_port_is_one_sentence_and_no_page_is_opened() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        result = subprocess.run(
            [PROGRAM, "live", "sim:scara", SPEC, "--port", "0", "--no-browser", "--foxglove", "--foxglove-port", port],
            capture_output=True,
            text=True,
            timeout=PATIENCE,
            check=False,
        )
    assert (result.returncode, result.stdout) == (1, "")
    assert f"Foxglove's port {port} of 127.0.0.1 can't be opened" in " ".join(result.stderr.split())
    assert "Traceback" not in result.stderr


def test_it_listens_on_this_machine_alone_and_takes_no_writes() -> None:
    with (
        served("sim:scara") as (_, url),
        connect(url, subprotocols=[Subprotocol("foxglove.sdk.v1")], close_timeout=0) as connection,
    ):
        port = int(url.rpartition(":")[2])
        lines = Path("/proc/net/tcp").read_text().splitlines() + Path("/proc/net/tcp6").read_text().splitlines()
        listening = {line.split()[1] for line in lines if line.split()[3] == "0A"}
        assert {place for place in listening if place.endswith(f":{port:04X}")} == {f"0100007F:{port:04X}"}
        said = json.loads(connection.recv(timeout=PATIENCE))
        assert said["op"] == "serverInfo"
        assert {"clientPublish", "parameters", "services"} & set(said["capabilities"]) == set()


@pytest.mark.slow
@pytest.mark.parametrize(
    "said", ["", "{", "[" * 100_000, '{"op":"subscribe"}', b"", b"\x01", b"\xff" * 1000], ids=range(7)
)
def test_invalid_message_of_an_app_disturbs_no_other(said: str | bytes) -> None:
    with served("sim:scara") as (_, url), app(url) as (connection, _):
        with connect(url, subprotocols=[Subprotocol("foxglove.sdk.v1")], max_size=None, close_timeout=0) as wild:
            wild.send(said)
            for _ in range(20):
                next_message(connection)
        with socket.create_connection(("127.0.0.1", int(url.rpartition(":")[2]))) as caller:
            caller.sendall(said.encode() if isinstance(said, str) else said)
        next_message(connection)
