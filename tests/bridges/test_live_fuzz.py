"""Any input to the server of live pictures at most ends its own connection, and reads no other file."""

from __future__ import annotations

import json
import os
import socket
import struct
from contextlib import ExitStack, suppress
from typing import TYPE_CHECKING

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from websockets.exceptions import ConnectionClosed

from support.bridge_programs import wait_until
from support.live_page import (
    SPEC,
    TOKEN,
    Live,
    Sleeper,
    connections_of,
    handshake,
    hear,
    live,
    looking,
    memory_of,
    take,
    write,
)
from support.searching import examples

if TYPE_CHECKING:
    from collections.abc import Iterator

TEXT, BINARY, CLOSE, PING = 1, 2, 8, 9
DEEP = '{"type":"write","number":1,"signal":"j1.pos_sp","value":' + "[" * 4000


@pytest.fixture(scope="module")
def running() -> Iterator[Live]:
    """Run one program for all tests; it must outlive them, and print nothing."""
    with pytest.MonkeyPatch.context() as patch, ExitStack() as stack:
        patch.setenv("UNITY_LINK_TOKEN", TOKEN)
        at = stack.enter_context(live("sim:scara", SPEC, "--allow-writes"))
        yield at
        assert at.process.poll() is None


@pytest.fixture(autouse=True)
def goes_on(running: Live) -> Iterator[None]:
    """After the block, check that pages show samples and write values as before."""
    yield
    with looking(running, token=TOKEN) as page:
        about = hear(page, "about")
        assert write(page, "j1.pos_sp", 1)["type"] == "written"
        assert take(page, about).tables


def call(running: Live) -> socket.socket:
    host, _, port = running.host.partition(":")
    return socket.create_connection((host, int(port)), timeout=30)


def answer_to(running: Live, said: bytes, *, patience: float = 0.0) -> bytes:
    """Send bytes; return the response up to its end, or of `patience` seconds; with 0, end the connection at once."""
    heard = b""
    with call(running) as caller, suppress(ConnectionError, TimeoutError):
        caller.sendall(said)
        if patience:
            caller.settimeout(patience)
        else:
            caller.shutdown(socket.SHUT_WR)
        # Stop at the upgrade to a WebSocket: the server would send samples without end.
        while not heard.startswith(b"HTTP/1.1 101 ") and (data := caller.recv(65536)):
            heard += data
    return heard


# Messages of pages


@pytest.mark.parametrize(
    "said",
    [
        b"\xff\x00",
        b'{"type":"hello","token":"\xff"}',
        "",
        "{",
        "[]",
        "null",
        '{"type":"write"}',
        '{"type":"hello","token":5}',
        '{"type":"hello","token":"a","more":1}',
        '{"type":"write","number":1e30,"signal":"j1.pos_sp","value":1}',
        '{"type":"write","number":100000000000000000000000,"signal":"j1.pos_sp","value":1}',
        '{"type":"write","number":-1,"signal":"j1.pos_sp","value":1}',
        '{"type":"write","number":1,"signal":"j1.pos_sp","value":null}',
        '{"type":"write","number":1,"signal":"j1.pos_sp","value":{"a":1}}',
        DEEP[:4000],
        '{"x":' + "[" * 4000,
        '{"x":' * 800,
        "x" * 100_000,
        b"{" * 5000,
    ],
    ids=lambda said: str(said)[:60],
)
def test_invalid_bytes_end_only_their_own_connection(running: Live, said: str | bytes) -> None:
    with looking(running) as other, looking(running, token=TOKEN) as page:
        about = hear(other, "about")
        hear(page, "welcome")
        page.send(said)
        with pytest.raises(ConnectionClosed) as ended:
            hear(page, "nothing")
        assert ended.value.rcvd is not None
        assert ended.value.rcvd.code in (1007, 1008, 1009)
        assert take(other, about).tables


@pytest.mark.parametrize(
    "value", ["1e999", "-1e400", "9" * 4000, "1e-400", '"' + "\\u0000" * 500 + '"', '"\\ud800"', "true", '"NaN"']
)
def test_invalid_value_is_refused_or_ends_its_own_connection(running: Live, value: str) -> None:
    with looking(running, token=TOKEN) as page:
        hear(page, "welcome")
        page.send(f'{{"type":"write","number":7,"signal":"j1.pos_sp","value":{value}}}'[:4096])
        with suppress(ConnectionClosed):
            answer = write(page, "j9.nothing", 0)
            assert answer["type"] == ("written" if value == "1e-400" else "refused")


MESSAGES = (
    st.binary(max_size=200)
    | st.text(max_size=200)
    | st.recursive(
        st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=10),
        lambda inner: (
            st.lists(inner, max_size=4)
            | st.dictionaries(st.sampled_from(["type", "token", "number", "signal", "value", "x"]), inner)
        ),
    ).map(json.dumps)
)


@settings(max_examples=examples(60))
@given(messages=st.lists(MESSAGES, min_size=1, max_size=5))
def test_any_message_of_a_page_leaves_others_served(running: Live, messages: list[str | bytes]) -> None:
    with looking(running) as page, suppress(ConnectionClosed):
        for message in messages:
            page.send(message)
        hear(page, "status")


# Frames of WebSocket


FRAMES = st.tuples(
    st.sampled_from([0, TEXT, BINARY, 3, CLOSE, PING, 10, 15]), st.binary(max_size=125), st.booleans()
).map(lambda frame: bytes([frame[0] | 0x80 * frame[2], 0x80 | len(frame[1])]) + bytes(4) + frame[1])


@given(frames=st.lists(FRAMES | st.binary(max_size=40), max_size=6), ends=st.booleans())
def test_any_frames_of_a_page_leave_others_served(running: Live, frames: list[bytes], ends: bool) -> None:
    page = Sleeper(running)
    with page.socket, suppress(ConnectionError):
        for frame in frames:
            page.socket.sendall(frame)
        if not ends:
            page.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("kind", "data", "last"),
    [(PING, b"x" * 125, True), (0, b"", False), (TEXT, b'{"type":"hello","token":""}', True)],
    ids=["pings", "parts", "questions"],
)
def test_memory_for_a_flooding_page_that_does_not_read_is_bounded(
    running: Live, kind: int, data: bytes, last: bool
) -> None:
    page = Sleeper(running)
    before = memory_of(running.process.pid)
    with page.socket, suppress(ConnectionError, TimeoutError):
        page.socket.settimeout(2)
        if kind == 0:
            page.say(TEXT, b"", last=False)
        for _ in range(200_000):
            page.say(kind, data, last=last)
    assert memory_of(running.process.pid) - before < 16e6


def test_text_that_is_not_utf_8_ends_its_own_connection(running: Live) -> None:
    page = Sleeper(running)
    with page.socket, suppress(ConnectionError, AssertionError):
        page.say(TEXT, b"\xff\xfe")
        while True:
            page.next_dropped()


# HTTP


def test_only_files_of_the_page_are_served(running: Live) -> None:
    head = f"Host: {running.host}\r\nConnection: close\r\n\r\n"
    assert answer_to(running, f"GET /live.js HTTP/1.1\r\n{head}".encode(), patience=30).startswith(b"HTTP/1.1 200 ")
    for path in (
        "/../page.py",
        "/../../../../../../../../etc/passwd",
        "/%2e%2e/page.py",
        "/..%2fpage.py",
        "/..%5cpage.py",
        "/..\\page.py",
        "/uplot/../../page.py",
        "/uplot/%2e%2e/%2e%2e/page.py",
        "//etc/passwd",
        "/%2fetc/passwd",
        "/live.js%00.py",
        "/%00",
        "/" + "a" * 5000,
        "/" + "a/" * 3000,
        "/%ff%fe",
        "/page.py",
        "/uplot",
        "http://127.0.0.1/../page.py",
    ):
        heard = answer_to(running, f"GET {path} HTTP/1.1\r\n{head}".encode(), patience=30)
        assert heard.split(b" ", 2)[1] in (b"400", b"404", b"405", b"307"), (path, heard)
        assert b"import" not in heard
        assert b"root:" not in heard


@pytest.mark.parametrize(
    "said",
    [
        b"",
        b"\r\n" * 1000,
        b"\x00" * 1000,
        b"GET\r\n\r\n",
        b"GET / HTTP/9.9\r\nHost: HOST\r\n\r\n",
        b"GET / HTTP/1.0\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost: HOST\r\nHost: HOST\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost: HOST\r\n" + b"X: y\r\n" * 5000,
        b"GET / HTTP/1.1\r\nHost: HOST\r\nX: " + b"y" * 1_000_000,
        b"POST / HTTP/1.1\r\nHost: HOST\r\nContent-Length: 99999999999999999999\r\n\r\nx",
        b"POST / HTTP/1.1\r\nHost: HOST\r\nTransfer-Encoding: chunked\r\n\r\nffffffffffffffffffff\r\n",
        b"POST / HTTP/1.1\r\nHost: HOST\r\nContent-Length: 9\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost: \xff\xfe\r\n\r\n",
        b"OPTIONS * HTTP/1.1\r\nHost: HOST\r\n\r\n",
        b"CONNECT HOST HTTP/1.1\r\nHost: HOST\r\n\r\n",
        b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost: HOST\r\nUpgrade: h2c\r\nConnection: Upgrade\r\n\r\n",
        b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + bytes(500),
        b"GET / HTTP/1.1\r\nHost: HOST\r\n\r\n" * 500,
    ],
    ids=lambda said: str(said)[:60],
)
def test_garbage_of_http_is_answered_in_a_word_or_not_at_all(running: Live, said: bytes) -> None:
    heard = answer_to(running, said.replace(b"HOST", running.host.encode()), patience=0.3)
    assert heard == b"" or heard.split(b" ", 2)[1] in (b"200", b"400", b"403", b"404", b"405", b"431", b"413")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (b"GET /samples", b"POST /samples"),
        (b"GET /samples", b"GET /"),
        (b"GET /samples", b"GET /other"),
        (b"GET /samples", b"GET /" + b"s" * 10_000),
        (b"Version: 13", b"Version: 99"),
        (b"Key: AAAAAAAAAAAAAAAAAAAAAA==", b"Key: short"),
        (b"Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n", b""),
        (b"Upgrade: websocket", b"Upgrade: websocket\r\n" + b"X: y\r\n" * 200),
        (b"Upgrade: websocket", b"Upgrade: websocket\r\nX: " + b"y" * 9000),
        (b"Upgrade: websocket", b"Upgrade: websocket\r\nX: \xff\xfe"),
        (b"Upgrade: websocket", b"Upgrade: websocket\r\nContent-Length: 5"),
        (b"Upgrade: websocket", b"Upgrade: websocket\r\nTransfer-Encoding: chunked"),
        (b"Upgrade: websocket", b"Upgrade: websocket\r\nSec-WebSocket-Extensions: permessage-deflate; x=;;,,"),
        (b"Upgrade: websocket", b"Upgrade: websocket\r\nSec-WebSocket-Protocol: ,,,"),
    ],
)
def test_invalid_handshake_opens_no_page(running: Live, old: bytes, new: bytes) -> None:
    said = handshake(running.host).replace(old, new)
    assert new in said
    heard = answer_to(running, said, patience=0.3)
    assert heard == b"" or heard.startswith((b"HTTP/1.1 4", b"HTTP/1.1 101 ")), heard


@settings(max_examples=examples(150))
@given(data=st.data())
def test_requests_that_were_damaged_anywhere_stop_nothing(running: Live, data: st.DataObject) -> None:
    said = bytearray(data.draw(st.sampled_from([handshake(running.host), b"GET / HTTP/1.1\r\nHost: x\r\n\r\n"])))
    said += data.draw(st.binary(max_size=50))
    for _ in range(data.draw(st.integers(1, 8))):
        place = data.draw(st.integers(0, len(said) - 1))
        said[place : place + data.draw(st.integers(0, 3))] = data.draw(st.binary(max_size=3))
    answer_to(running, bytes(said))


@pytest.mark.slow
def test_silent_and_slow_callers_keep_no_page_out(running: Live) -> None:
    with looking(running) as page, ExitStack() as stack:
        about = hear(page, "about")
        before = connections_of(running.process.pid)
        slow = []
        for number in range(600):
            caller = stack.enter_context(call(running))
            with suppress(ConnectionError):
                caller.sendall((b"", b"G", b"GET / HTTP/1.1\r\nX", handshake(running.host)[:-2])[number % 4])
            slow.append(caller)
        with looking(running, token=TOKEN) as other:
            assert write(other, "j1.pos_sp", 2)["type"] == "written"
        assert connections_of(running.process.pid) - before < 200
        for caller in slow:
            with suppress(ConnectionError):
                caller.sendall(b"X")
        assert take(page, about).tables


def test_pages_without_end_at_once_keep_within_bounds(running: Live) -> None:
    with ExitStack() as stack:
        for _ in range(300):
            caller = stack.enter_context(call(running))
            with suppress(ConnectionError):
                caller.sendall(handshake(running.host))
        wait_until(lambda: connections_of(running.process.pid) < 200)
    wait_until(lambda: connections_of(running.process.pid) < 20)


def test_random_bytes_stop_nothing(running: Live) -> None:
    for _ in range(200):
        answer_to(running, os.urandom(300))
