"""`unity-link terminal`: frames by hand.

It stands on a driver and the wire alone: nothing is sent but what is typed (after the questions that tell the widths),
no request is repeated, and what the gateway answers is shown whatever it is.
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
"""Seconds that the gateway may take to say what it is; after that the default build's widths are assumed."""
WS_PATIENCE = 0.1
"""Seconds that an error of a stateless write, which has no other answer, is waited for."""
NEAR = 0.05
"""Seconds within which a near gateway answers: its answer then stands before the next prompt."""
_READ_SIZE = 65_536
_HELP = """\
Type a request; the CRC is added.
With ID: lower case, and the ID behind the command; K0001234 begins session 1234, in which 000 comes first.
  R0A                   read the word at 0A
  RM0A04                read 4 words from 0A
  W0A2A                 write 2A to it; leading zeros are added
  WM0A...               write words from 0A on
  WK0Ammmmmmmmdddddddd  replace the bits of mask m by those of d
  GSgg01vvvvnnaa...     group gg: every vvvv ticks, nn addresses
  GNgg, GXgg, GPgg      start group gg, stop it, ask it once
  Q                     what are you?
  H, Kiiissss, Imm      nothing; session ssss from ID iii on; send-immediate mode
  K                     which session is under way?
!R0A00 sends as it stands, without adding a CRC.
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

    Each line is a request, such as R0A; ? shows more. A line that begins with ! is sent as it stands. Works in a pipe
    as well: echo R0A | unity-link terminal sim:
    """
    run(_terminal(url, plain=plain, timeout=timeout))


async def _terminal(url: str, *, plain: bool, timeout: float) -> None:  # noqa: ASYNC109  (an option of the command)
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
        print_note("The gateway does not say what it is; 32-bit words, 8-bit addresses and CRC-16 are assumed.")
        return HostCodec(GatewayInfo(), target.node)
    return codec


class _Receiver:
    """Takes whole frames of what arrives cut anywhere."""

    def __init__(self) -> None:
        self._rest = b""

    def receive(self, data: bytes) -> None:
        """Take the frames that have arrived."""
        data = self._rest + data
        rest = data[self.take(data) :]
        # Noise without a line end is no frame; what is kept of it must not grow.
        self._rest = rest if len(rest) <= LONGEST_FRAME else b""

    def take(self, data: bytes) -> int:
        """Take whole frames, and return where the first that is not whole begins."""
        raise NotImplementedError


class _Greeting(_Receiver):
    """Asks what the gateway is, and has it begin a person's session with ID 0."""

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
        """Return the messages of the gateway, and the session in them; the caller's time out ends it."""
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
        """Look for answers."""
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
        """End without an answer."""
        self._end(ConnectError(self._handshake.describe_end(reason)))

    def _end(self, error: Exception | None) -> None:
        if self._over.done():
            return
        if error is None:
            self._over.set_result(None)
        else:
            self._over.set_exception(error)


class _Session(_Receiver):
    """Sends what is typed and shows what comes."""

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
        """Send a typed line; gives the command in it, if it is one."""
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
            # Only plain frames may leave zeros out; who types thinks of neither.
            body = request.command.encode() + self.codec.fields(request.command, *request.values)
        # A checked one would begin a program's session, which shuts out most of what is typed.
        begins = request is not None and request.command == "K" and bool(request.values)
        session = NO_SESSION if request is None or request.id is None else self._decoder.session.number
        self._stream.send(
            framing.plain_request(body)
            if self._plain or begins
            else framing.checked(body, seed_of(session, from_gateway=False))
        )
        return None if request is None else request.command

    async def answer(self, seconds: float) -> bool:
        """Wait for the answer to what was sent last; say whether it came."""
        with contextlib.suppress(TimeoutError):
            async with asyncio.timeout(seconds):
                await self.answered.wait()
        return self.answered.is_set()

    def tell_of_silence(self, line: str, seconds: float) -> None:
        """Print that no answer to `line`, which was sent last, came within `seconds`, where that is so."""

        def tell() -> None:
            if not self.answered.is_set():
                print_note(_silence(line, seconds))

        self._patience = asyncio.get_running_loop().call_later(seconds, tell)

    def take(self, data: bytes) -> int:
        """Show whole frames."""
        *lines, rest = data.split(b"\n")
        for line in lines:
            if line.strip(b"\r"):
                self._show(line)
        return len(data) - len(rest)

    def _show(self, line: bytes) -> None:
        from rich.text import Text

        body = self._decoder.body(line)
        # Noise may well be what tells a terminal to clear its screen.
        visible = repr(bytes(body))[2:-1]
        try:
            self.show(Text.assemble((visible, "bold"), "  ", (self._decoder.explain(line).words, "cyan")))
        except OSError as error:
            self._end(error)
        if not body.startswith(b"P"):
            self.answered.set()

    def disconnected(self, reason: Exception | None) -> None:
        """Record the end."""
        self._end(ConnectError(f"the connection has ended ({reason or 'the other side closed it'})"))

    def _end(self, error: Exception) -> None:
        self._error = self._error or error
        self.ended.set()
        self.answered.set()

    def raise_error(self) -> None:
        """Raise what ended the session, if something but the user did."""
        if self._error is not None:
            raise self._error


def _encoded(line: str) -> bytes:
    """Return the bytes that were typed, whatever they are."""
    return line.encode(errors="surrogateescape")


async def _while_connected(session: _Session, work: Coroutine[None, None, bool]) -> bool:
    """Do `work` and give its result.

    Raises:
        ConnectError: where the connection ends first.
        OSError: where answers cannot be shown.
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


async def _answer_lines(session: _Session, timeout: float) -> bool:  # noqa: ASYNC109
    """Send the lines of stdin, each when the one before is answered; say whether all were."""
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
    """Return the lines of a stdin that is read without blocking the loop, so that samples are shown meanwhile."""
    from anyio import wait_readable

    if sys.stdin is None:
        return
    stdin = sys.stdin.fileno()
    rest = b""
    while True:
        # A file is always readable, and epoll refuses to wait for one.
        with contextlib.suppress(PermissionError):
            await wait_readable(stdin)
        data = os.read(stdin, _READ_SIZE)
        *lines, rest = (rest + data).split(b"\n")
        for line in lines if data else [rest]:
            yield line.decode(errors="surrogateescape").strip()
        if not data:
            return


class _Interrupted(Exception):  # noqa: N818  (it is no error)
    """Ctrl-C, which is a key and no signal while a line is edited."""


async def _converse(url: str, session: _Session, timeout: float) -> None:  # noqa: ASYNC109
    """Prompt for lines until the user has enough."""
    from prompt_toolkit import PromptSession
    from prompt_toolkit.auto_suggest import AutoSuggestFromHistory
    from prompt_toolkit.input import create_input
    from prompt_toolkit.patch_stdout import patch_stdout

    from unity_link.capture.decoder import summary

    keyboard = create_input()
    # While something is printed above the prompt, the terminal would edit lines itself, and take keys such as Ctrl-D.
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


async def _converse_lines(prompt: Any, session: _Session, timeout: float) -> bool:  # noqa: ASYNC109
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
                session.tell_of_silence(line, timeout)


def _history() -> Any:
    """Return the lines of earlier times, and keep those of this one, where there is a place to."""
    from prompt_toolkit.history import FileHistory, InMemoryHistory

    folder = Path(typer.get_app_dir("unity-link"))
    if not folder.is_absolute():
        # Without a home, `~` stays in it.
        return InMemoryHistory()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with (folder / "history").open("a"):
            pass
    except OSError:
        return InMemoryHistory()
    return FileHistory(str(folder / "history"))
