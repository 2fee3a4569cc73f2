"""`unity-link terminal` on a terminal, as a user sees it."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

from anyio.from_thread import start_blocking_portal

from support.terminal_window import GIVEN_BACK, Window, needs_tmux
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.transport.listening import listen_unix
from unity_link.virtual import VirtualGateway
from unity_link.virtual.serving import serve_unix

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = needs_tmux
PROMPT = "^> *$"


class Noise(asyncio.Protocol):
    """Peer that answers each line as a line with a wrong baud rate may: here with control sequences for a terminal."""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self._transport = transport

    def data_received(self, data: bytes) -> None:
        self._transport.write(b"\x1b[2J\x1b[31m[bold]\xff\r\n")


class Echo(Noise):
    """Peer that returns every byte, as joined wires do."""

    def data_received(self, data: bytes) -> None:
        self._transport.write(data)


def test_typed_requests_are_sent_and_answers_explained_until_ctrl_d(terminal: Window) -> None:
    terminal.enter("unity-link terminal sim:; echo code $?")
    terminal.wait_for(PROMPT, "^sim:: words of 32 bits", "Ctrl-D ends")
    terminal.enter("W0A0000002A")
    terminal.wait_for("^W0A +write to 0x0A done$", PROMPT)
    terminal.enter("R0A")
    terminal.wait_for(r"^R0A0000002A +read of 0x0A: 0x0000002A \(42\)$", PROMPT)
    terminal.enter("R0")
    terminal.wait_for("^X03 +error 03: malformed", PROMPT)
    terminal.enter("?")
    terminal.wait_for("^ +R0A +read the word at 0A$", PROMPT)
    terminal.press("C-d")
    terminal.wait_for("^code 0$", r"^\$ *$")
    assert terminal.state == GIVEN_BACK
    terminal.enter("echo typed $((6 * 7))")
    terminal.wait_for(r"^\$ echo typed", "^typed 42$")


def test_arriving_samples_do_not_disturb_the_line_being_typed(terminal: Window) -> None:
    terminal.enter("unity-link terminal sim:; echo code $?")
    terminal.wait_for(PROMPT)
    terminal.enter("GS00010BB8010A")
    terminal.wait_for("^GS00 +group 0 is set up$", PROMPT)
    terminal.enter("GN00")
    terminal.wait_for("^P0001")
    terminal.press("R", "0")
    terminal.wait_for("^P0006.*sample 6 of group 0: 0x0A = 0\n(.*\n)*> R0$")
    terminal.press("C-c")
    terminal.wait_for("^code 130$")
    assert terminal.state == GIVEN_BACK


def test_history_has_the_lines_of_earlier_sessions(terminal: Window) -> None:
    for keys in (["R", "0", "A", "Enter"], ["Up", "Enter"]):
        terminal.clear()
        terminal.enter("unity-link terminal sim:; echo code $?")
        terminal.wait_for(PROMPT)
        terminal.press(*keys)
        terminal.wait_for("^R0A00000000 +read of 0x0A", PROMPT)
        terminal.press("C-d")
        terminal.wait_for("^code 0$")


def test_input_that_is_no_request_is_sent_all_the_same_and_explained(terminal: Window) -> None:
    terminal.enter("unity-link terminal sim:; echo code $?")
    terminal.wait_for(PROMPT)
    terminal.enter("µ [bold] \\")
    terminal.wait_for("^X02 +error 02: unknown command$", PROMPT)
    terminal.enter("R0A" * 400)
    terminal.wait_for("^X03 +error 03: malformed", PROMPT)
    terminal.enter("!R0A00")
    terminal.wait_for("^X01 +error 01: the CRC was wrong$", PROMPT)
    # The gateway has sent its one error, and waits for a new session.
    terminal.enter("K0000001")
    terminal.wait_for(
        "^K0000001[0-9A-F]{4} +session 0001 has begun, the next ID expected is 000; session [0-9A-F]{4} ended$", PROMPT
    )
    terminal.enter("r0010A")
    terminal.wait_for("^n000 +out of sequence: the next ID expected is 000$", PROMPT)
    terminal.enter("r0020A")
    terminal.wait_for("^no answer to r0020A within 1 s$", PROMPT)


def test_request_with_an_id_after_a_reset_is_answered_with_how_to_begin(terminal: Window, tmp_path: Path) -> None:
    gateway = VirtualGateway(GatewayInfo())
    with (
        start_blocking_portal() as portal,
        portal.wrap_async_context_manager(serve_unix(gateway, tmp_path / "gateway")),
    ):
        terminal.enter("unity-link terminal unix:gateway; echo code $?")
        terminal.wait_for(PROMPT)
        portal.call(gateway.reset)
        terminal.enter("r0000A")
        terminal.wait_for(
            r"^x0000A[0-9A-F]{4} +error 0A: no session has begun .*: begin with K0000001 \(ID 000\)$", PROMPT
        )
        terminal.enter("K0000001")
        terminal.wait_for("^K00000010000 +session 0001 has begun", PROMPT)
        terminal.enter("r0000A")
        terminal.wait_for("^r00000000000 +read of 0x0A", PROMPT)


def test_a_session_of_the_terminal_takes_requests_with_and_without_ids(terminal: Window) -> None:
    terminal.enter("unity-link terminal sim:; echo code $?")
    terminal.wait_for(PROMPT)
    terminal.enter("w0000A0000002A")
    terminal.wait_for(r"^w000 +write to 0x0A done \(ID 000\)$", PROMPT)
    terminal.enter("W0B11")
    terminal.wait_for("^W0B +write to 0x0B done$", PROMPT)
    terminal.enter("r0010A")
    terminal.wait_for("^r0010000002A +read of 0x0A", PROMPT)


def test_window_of_any_size_accepts_typed_lines(terminal: Window) -> None:
    terminal.enter("unity-link terminal sim:; echo code $?")
    terminal.wait_for(PROMPT)
    for width, height, word in [(30, 6, "00000001"), (200, 40, "00000002"), (70, 20, "00000003")]:
        terminal.resize(width, height)
        terminal.enter(f"W0A{word}")
        # Repeat the read: text printed at the moment of a resize may be overwritten.
        terminal.enter_until("R0A", f"^R0A{word} ")


def test_a_gateway_that_goes_away_ends_the_terminal_in_one_sentence(terminal: Window, tmp_path: Path) -> None:
    with (
        start_blocking_portal() as portal,
        portal.wrap_async_context_manager(serve_unix(VirtualGateway(GatewayInfo()), tmp_path / "gateway")),
    ):
        terminal.enter("unity-link terminal unix:gateway; echo code $?")
        terminal.wait_for(PROMPT)
        terminal.press("R", "0")
        terminal.wait_for("^> R0$")
    screen = terminal.wait_for("^error: the connection has ended", "^code 1$")
    assert "Traceback" not in screen
    assert terminal.state == GIVEN_BACK


def test_noise_is_shown_without_control_sequences(terminal: Window, tmp_path: Path) -> None:
    with (
        start_blocking_portal() as portal,
        portal.wrap_async_context_manager(listen_unix(Noise, tmp_path / "gateway")),
    ):
        terminal.enter("unity-link terminal unix:gateway; echo code $?")
        terminal.wait_for("^The gateway does not identify itself", PROMPT)
        terminal.enter("R0A")
        terminal.wait_for("^The gateway", r"^\\x1b\[2J\\x1b\[31m\[bold\]\\xff +not a message", PROMPT)
        terminal.enter("quit")
        terminal.wait_for("^code 0$")


def test_echo_is_no_gateway_and_does_not_end_the_terminal(terminal: Window, tmp_path: Path) -> None:
    with (
        start_blocking_portal() as portal,
        portal.wrap_async_context_manager(listen_unix(Echo, tmp_path / "gateway")),
    ):
        terminal.enter("unity-link terminal unix:gateway; echo code $?")
        screen = terminal.wait_for("^The gateway does not identify itself", PROMPT)
        assert "Traceback" not in screen
        terminal.enter("quit")
        terminal.wait_for("^code 0$")
