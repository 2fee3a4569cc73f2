"""`unity-link terminal`: sends frames that the user types.

It uses only a driver and the wire format. After the opening handshake, which reads the gateway's widths, it sends
nothing but the typed lines, retransmits nothing, and shows every received frame.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import secrets
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from unity_link.cli.arguments import DEFAULT_TIMEOUT, Url
from unity_link.cli.output import out, print_note
from unity_link.cli.running import INTERRUPTED, run
from unity_link.errors import ConnectError, UnsupportedError
from unity_link.protocol.wire.crc import NO_SESSION, seed_of
from unity_link.protocol.wire.frames import LONGEST_FRAME
from unity_link.protocol.wire.numbers import MOST_SECONDS

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Coroutine

    from unity_link.protocol.host.host_codec import HostCodec
    from unity_link.transport import DriverUrl
    from unity_link.transport.stream import Stream

HANDSHAKE_PATIENCE = 1.5
"""Seconds to wait for the gateway's configuration; after that the widths of the default build are assumed."""
WS_PATIENCE = 0.1
"""Seconds to wait for an error of a stateless write, which has no other response."""
NEAR = 0.05
"""Seconds to wait before the next prompt, so that a quick answer is shown before it."""
_READ_SIZE = 65_536
_HELP = """\
Type a request; the CRC is added.
With ID: the command in lower case, and the ID after it; K0001234 begins session 1234, whose first ID is 000.
  R0A                   read the word at 0A
  RM0A04                read 4 words from 0A
  W0A2A                 write 2A to it; leading zeros are added
  WM0A...               write words from 0A on
  WK0Ammmmmmmmdddddddd  replace the bits of mask m by those of d
  GSgg01vvvvnnaa...     group gg: every vvvv ticks, nn addresses
  GNgg, GXgg, GPgg      start group gg, stop it, read it once
  Q                     widths, clock and features of the gateway
  H, Kiiissss, Imm      nothing; session ssss from ID iii on; send-immediate mode
  K                     the current session
!R0A00 sends the line unchanged, without adding a CRC.
Ctrl-D or quit ends."""


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(terminal)


def terminal(
    url: Url,
    *,
    plain: Annotated[
        bool, typer.Option("--plain", help="Send plain frames, which end with CR and have no CRC.")
    ] = False,
    timeout: Annotated[
        float,
        typer.Option("--timeout", metavar="SECONDS", min=0.001, max=MOST_SECONDS, help="How long an answer may take."),
    ] = 1.0,
) -> None:
    """Type frames by hand: the CRC is added, and answers are explained.

    Each line is a request, such as R0A; ? shows more. A line that begins with ! is sent unchanged. Works in a pipe
    as well: echo R0A | unity-link terminal sim:
    """
    run(_terminal(url, plain=plain, timeout=timeout))


async def _terminal(url: str, *, plain: bool, timeout: float) -> None:
    from unity_link.transport import parse_url
    from unity_link.transport.stream import Stream

    target = parse_url(url)
    stream = Stream()
    codec = await _connect(target, stream)
    session = _Session(stream, codec, plain=plain)
    try:
        if sys.stdin and sys.stdin.isatty() and sys.stdout.isatty():
            await _converse(url, session, timeout)
        elif not await _while_connected(session, _answer_lines(session, timeout)):
            raise typer.Exit(1)
    finally:
        stream.receiver = None
        await stream.close()


async def _connect(target: DriverUrl, stream: Stream) -> HostCodec:
    from unity_link.protocol.host.host_codec import HostCodec
    from unity_link.protocol.wire.configuration import GatewayInfo
    from unity_link.transport import open_medium

    try:
        async with asyncio.timeout(DEFAULT_TIMEOUT):
            await open_medium(target, stream)
    except TimeoutError:
        raise ConnectError(f"{target.text}: the connection was not accepted within {DEFAULT_TIMEOUT:g} s") from None
    except ConnectError as error:
        raise ConnectError(f"{target.text}: {error}") from error
    try:
        async with asyncio.timeout(HANDSHAKE_PATIENCE):
            codec = await _Greeting(stream, target.node).run()
    except (TimeoutError, ConnectError) as error:
        if stream.closed:
            raise ConnectError(f"{target.text}: the connection ended at once") from error
        print_note("The gateway does not identify itself; 32-bit words, 8-bit addresses and CRC-16 are assumed.")
        return HostCodec(GatewayInfo(), target.node)
    return codec


class _Receiver:
    """Collects bytes that arrive in pieces, and passes whole frames on."""

    def __init__(self) -> None:
        self._rest = b""

    def receive(self, data: bytes) -> None:
        """Handle received bytes: process whole frames, and keep an incomplete one."""
        data = self._rest + data
        rest = data[self.take(data) :]
        # Drop a long rest without a line end: it is noise, and must not fill the memory.
        self._rest = rest if len(rest) <= LONGEST_FRAME else b""

    def take(self, data: bytes) -> int:
        """Process the whole frames in `data`, and return the offset of the incomplete rest."""
        raise NotImplementedError


class _Greeting(_Receiver):
    """Opens the gateway for a person: reads its configuration, and begins a session with ID 0."""

    def __init__(self, stream: Stream, node: int | None) -> None:
        from unity_link.protocol.host.handshake import Handshake, SessionNumbers

        super().__init__()
        self._stream = stream
        self._loop = asyncio.get_running_loop()
        numbers = SessionNumbers(lambda: secrets.randbits(32))
        self._handshake = Handshake(node, numbers, self._loop.time(), person=True)
        self._over: asyncio.Future[None] = self._loop.create_future()
        stream.receiver = self

    async def run(self) -> HostCodec:
        """Return the codec of the opened session. The caller limits the time."""
        while not self._over.done():
            self._send()
            await asyncio.wait((self._over,), timeout=self._handshake.deadline - self._loop.time())
            self._handshake.expire(self._loop.time())
        self._over.result()
        self._handshake.codec.begin(self._handshake.session)
        return self._handshake.codec

    def _send(self) -> None:
        if data := self._handshake.take_output():
            self._stream.send(data)

    def take(self, data: bytes) -> int:
        """Process the answers of the handshake."""
        try:
            taken = self._handshake.receive(data, self._loop.time())
        except (ConnectError, UnsupportedError) as error:
            self._end(error)
            return len(data)
        self._send()
        if self._handshake.complete:
            self._end(None)
        return taken

    def disconnected(self, reason: Exception | None) -> None:
        """End the handshake with an error."""
        self._end(ConnectError(self._handshake.describe_end(reason)))

    def _end(self, error: Exception | None) -> None:
        if self._over.done():
            return
        if error is None:
            self._over.set_result(None)
        else:
            self._over.set_exception(error)


class _Session(_Receiver):
    """Sends typed lines and shows received frames."""

    def __init__(self, stream: Stream, codec: HostCodec, *, plain: bool) -> None:
        from unity_link.capture.decoder import Decoder

        super().__init__()
        self.codec = codec
        self.answered = asyncio.Event()
        self.ended = asyncio.Event()
        self.show: Callable[[Any], None] = out().print
        self._stream = stream
        self._plain = plain
        self._decoder = Decoder(codec)
        self._decoder.session.number = codec.session
        self._error: Exception | None = None
        self._patience: asyncio.TimerHandle | None = None
        stream.receiver = self

    def send(self, line: str) -> str | None:
        """Send a typed line; return its command, or None if it has none."""
        self.answered.clear()
        if self._patience is not None:
            self._patience.cancel()
        framing = self.codec.framing
        if line.startswith("!"):
            self._stream.send(_encoded(line[1:]) + b"\n")
            return None
        body = _encoded(line)
        request = self._decoder.listen(body)
        if request is not None and request.id is None and request.command in ("W", "WS"):
            # Add the zeros that only plain frames may leave out, because the user types without regard to the frame.
            body = request.command.encode() + self.codec.fields(request.command, *request.values)
        # Send K plain: a checked K would begin a program's session, which rejects plain frames.
        begins = request is not None and request.command == "K" and bool(request.values)
        session = NO_SESSION if request is None or request.id is None else self._decoder.session.number
        self._stream.send(
            framing.plain_request(body)
            if self._plain or begins
            else framing.checked(body, seed_of(session, from_gateway=False))
        )
        return None if request is None else request.command

    async def answer(self, seconds: float) -> bool:
        """Wait for the answer to the last line; return whether it arrived within `seconds`."""
        with contextlib.suppress(TimeoutError):
            async with asyncio.timeout(seconds):
                await self.answered.wait()
        return self.answered.is_set()

    def note_silence(self, line: str, seconds: float) -> None:
        """Print a note after `seconds` if the last line, `line`, has no answer by then."""

        def note() -> None:
            if not self.answered.is_set():
                print_note(_silence(line, seconds))

        self._patience = asyncio.get_running_loop().call_later(seconds, note)

    def take(self, data: bytes) -> int:
        """Show the whole frames."""
        *lines, rest = data.split(b"\n")
        for line in lines:
            if line.strip(b"\r"):
                self._show(line)
        return len(data) - len(rest)

    def _show(self, line: bytes) -> None:
        from rich.text import Text

        body = self._decoder.body(line)
        # Escape the frame: noise may contain control sequences of a terminal.
        visible = repr(bytes(body))[2:-1]
        try:
            self.show(Text.assemble((visible, "bold"), "  ", (self._decoder.explain(line).words, "cyan")))
        except OSError as error:
            self._end(error)
        if not body.startswith(b"P"):
            self.answered.set()

    def disconnected(self, reason: Exception | None) -> None:
        """Record the end of the connection."""
        self._end(ConnectError(f"the connection has ended ({reason or 'the other side closed it'})"))

    def _end(self, error: Exception) -> None:
        self._error = self._error or error
        self.ended.set()
        self.answered.set()

    def raise_error(self) -> None:
        """Raise the error that ended the session, if there is one."""
        if self._error is not None:
            raise self._error


def _encoded(line: str) -> bytes:
    """Return the typed bytes, even if they are not UTF-8."""
    return line.encode(errors="surrogateescape")


async def _while_connected(session: _Session, work: Coroutine[None, None, bool]) -> bool:
    """Run `work` while the connection exists, and return its result.

    Raises:
        ConnectError: if the connection ends first.
        OSError: if frames cannot be shown.
    """
    working = asyncio.ensure_future(work)
    ending = asyncio.ensure_future(session.ended.wait())
    try:
        await asyncio.wait([working, ending], return_when=asyncio.FIRST_COMPLETED)
    finally:
        working.cancel()
        ending.cancel()
        await asyncio.wait([working, ending])
    if working.cancelled():
        session.raise_error()
    return working.result()


def _silence(line: str, seconds: float) -> str:
    return f"no answer to {line} within {seconds:g} s"


async def _answer_lines(session: _Session, timeout: float) -> bool:
    """Send the lines of stdin, each after the answer to the previous one; return whether all were answered."""
    complete = True
    async for line in _stdin_lines():
        if not line or line.startswith("?"):
            continue
        silent = session.send(line) == "WS"
        if not await session.answer(WS_PATIENCE if silent else timeout) and not silent:
            print_note(_silence(line, timeout))
            complete = False
        session.raise_error()
    return complete


async def _stdin_lines() -> AsyncIterator[str]:
    """Yield the lines of stdin without blocking the event loop, so that samples are shown meanwhile."""
    from anyio import wait_readable

    if sys.stdin is None:
        return
    stdin = sys.stdin.fileno()
    rest = b""
    while True:
        # A file is always readable, but epoll refuses to watch one.
        with contextlib.suppress(PermissionError):
            await wait_readable(stdin)
        data = os.read(stdin, _READ_SIZE)
        *lines, rest = (rest + data).split(b"\n")
        for line in lines if data else [rest]:
            yield line.decode(errors="surrogateescape").strip()
        if not data:
            return


class _Interrupted(Exception):  # noqa: N818  (not an error)
    """Ctrl-C while a line is edited: in raw mode the terminal sends a key instead of a signal."""


async def _converse(url: str, session: _Session, timeout: float) -> None:
    """Prompt for lines until the user ends the command."""
    from prompt_toolkit import PromptSession
    from prompt_toolkit.auto_suggest import AutoSuggestFromHistory
    from prompt_toolkit.input import create_input
    from prompt_toolkit.patch_stdout import patch_stdout

    from unity_link.capture.decoder import summary

    keyboard = create_input()
    # Stay in raw mode while something is printed above the prompt: otherwise the terminal itself would handle keys.
    keyboard.cooked_mode = contextlib.nullcontext  # type: ignore[method-assign]
    prompt: PromptSession[str] = PromptSession(
        history=_history(),
        auto_suggest=AutoSuggestFromHistory(),
        interrupt_exception=_Interrupted,
        input=keyboard,
    )
    print_note(f"{url}: {summary(session.codec.info)}\n? shows what can be typed, Ctrl-D ends.")
    with keyboard.raw_mode(), patch_stdout(raw=True):
        await _while_connected(session, _converse_lines(prompt, session, timeout))


async def _converse_lines(prompt: Any, session: _Session, timeout: float) -> bool:
    while True:
        try:
            line = (await prompt.prompt_async("> ", handle_sigint=False)).strip()
        except EOFError:
            return True
        except _Interrupted:
            raise typer.Exit(INTERRUPTED) from None
        if line in ("quit", "exit"):
            return True
        if line.startswith("?"):
            session.show(_HELP)
        elif line:
            silent = session.send(line) == "WS"
            if not await session.answer(min(NEAR, timeout)) and not silent:
                session.note_silence(line, timeout)


def _history() -> Any:
    """Return the history of typed lines: in a file if it can be written, otherwise only in memory."""
    from prompt_toolkit.history import FileHistory, InMemoryHistory

    folder = Path(typer.get_app_dir("unity-link"))
    if not folder.is_absolute():
        # The user has no home directory, so the path begins with `~`.
        return InMemoryHistory()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with (folder / "history").open("a"):
            pass
    except OSError:
        return InMemoryHistory()
    return FileHistory(str(folder / "history"))
