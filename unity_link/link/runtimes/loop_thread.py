"""A medium in an event loop of asyncio in a thread of its own, for links of blocking code and of trio.

Media of other packages, simulated gateways, UDP, Zenoh and the FT232H have asyncio transports. `Relay` passes received
bytes from such a transport to the stream in the link's thread, and written bytes in the other direction.
"""

from __future__ import annotations

import asyncio
import threading
from typing import TYPE_CHECKING, Any, Protocol, TypeVar, cast

from unity_link.transport import open_medium

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine

    from unity_link.link.runtimes.runtime import Waiter
    from unity_link.transport import DriverUrl, Medium
    from unity_link.transport.stream import Stream

T = TypeVar("T")


class Home(Protocol):
    """The part of the link's `Runtime` that this module uses."""

    def create_future(self) -> Waiter:
        """Return a new future."""

    def call_soon_threadsafe(self, function: Callable[[], object], /) -> None:
        """Call a function in the thread of the link."""


def run_in_loop(function: Callable[[], Coroutine[Any, Any, T]]) -> T:
    """Run a coroutine in an event loop of another thread, and return its result. This thread may have a loop, too."""
    results: list[T] = []
    errors: list[BaseException] = []

    def run() -> None:
        try:
            results.append(asyncio.run(function()))
        except BaseException as error:  # noqa: BLE001  (it is raised below)
            errors.append(error)

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    thread.join()
    if errors:
        raise errors[0]
    return results[0]


def complete(waiter: Waiter, error: BaseException | None = None) -> None:
    """Set the result of a future to None, or its error, unless it is done already."""
    if waiter.done():
        return
    if error is None:
        waiter.set_result(None)
    else:
        waiter.set_exception(error)


class Relay(asyncio.Transport):
    """A transport for a stream of the link, whose medium runs in an event loop of another thread.

    Args:
        home: runtime of the link.
        target: the medium.
        stream: stream of the link.
    """

    def __init__(self, home: Home, target: DriverUrl | Medium, stream: Stream) -> None:
        super().__init__()
        self._home = home
        self._target = target
        self._stream = stream
        self._opened = home.create_future()
        self._loop = asyncio.new_event_loop()
        self._far: asyncio.Transport | None = None
        self._closing = False
        self._ended = asyncio.Event()
        self._task: asyncio.Task[None] | None = None
        self._thread = threading.Thread(target=self._run, name="unity_link.relay", daemon=True)

    async def open(self) -> None:
        """Open the medium; raise the errors of its driver."""
        self._thread.start()
        try:
            await self._opened
        except BaseException:
            self._post(self._give_up)
            raise

    def join(self, patience: float | None) -> None:
        """Wait until the thread has ended, at most `patience` seconds; None for no limit."""
        if self._thread.ident is not None:
            self._thread.join(patience)

    @property
    def has_ended(self) -> bool:
        """True if its thread has ended."""
        return self._thread.ident is not None and not self._thread.is_alive()

    # In the thread of the link

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Send bytes."""
        far = self._far
        if far is not None and not self._closing:
            self._post(lambda: far.write(data))

    def pause_reading(self) -> None:
        """Pause the medium; bytes that are already being passed to the stream still arrive."""
        if self._far is not None:
            self._post(self._far.pause_reading)

    def resume_reading(self) -> None:
        """Resume the medium."""
        if self._far is not None:
            self._post(self._far.resume_reading)

    def is_closing(self) -> bool:
        """Return whether `abort` was called."""
        return self._closing

    def abort(self) -> None:
        """End the connection at once."""
        self._closing = True
        if self._far is not None:
            self._post(self._far.abort)

    close = abort

    def get_extra_info(self, name: str, default: object = None) -> Any:
        """Return the extra information of the medium's own transport."""
        if self._far is None:
            return default
        info = self._far.get_extra_info(name, default)
        return self._choosing(info) if name == "send_immediate" and info is not None else info

    def _choosing(self, choose: Callable[[str], Coroutine[Any, Any, None]]) -> Callable[[str], Any]:
        """Return a coroutine function for the link's thread that runs `choose` in the medium's thread."""

        async def choose_there(mode: str) -> None:
            done = self._home.create_future()

            async def chosen() -> None:
                try:
                    await choose(mode)
                except Exception as error:  # noqa: BLE001  (the call raises it)
                    failure = error
                    self.call_in_link(lambda: complete(done, failure))
                else:
                    self.call_in_link(lambda: complete(done))

            self._post(lambda: self._loop.create_task(chosen()))
            await done

        return choose_there

    def _post(self, function: Callable[[], object]) -> None:
        # The loop is closed if the thread has ended by itself.
        if not self._loop.is_closed():
            self._loop.call_soon_threadsafe(function)

    # In the thread of the medium

    def _run(self) -> None:
        with asyncio.Runner(loop_factory=lambda: self._loop) as runner:
            try:
                runner.run(self._serve())
            except asyncio.CancelledError:
                return

    async def _serve(self) -> None:
        self._task = asyncio.current_task()
        try:
            await open_medium(self._target, FarProtocol(self))
        except BaseException as error:  # noqa: BLE001  (the link raises it)
            failure = error
            self.call_in_link(lambda: complete(self._opened, failure))
            return
        self.call_in_link(lambda: complete(self._opened))
        await self._ended.wait()

    def _give_up(self) -> None:
        if self._far is not None:
            self._far.abort()
        elif self._task is not None:
            self._task.cancel()

    def begin(self, far: asyncio.Transport) -> None:
        """Record that the medium is open."""
        self._far = far
        self.call_in_link(lambda: self._stream.connection_made(self))

    def end(self, reason: Exception | None) -> None:
        """Record that the medium has ended."""
        self._ended.set()
        self.call_in_link(lambda: self._stream.connection_lost(reason))

    def call_in_link(self, function: Callable[[], object]) -> None:
        """Call a function in the thread of the link."""
        self._home.call_soon_threadsafe(function)

    @property
    def stream(self) -> Stream:
        """Stream of the link."""
        return self._stream


class FarProtocol(asyncio.Protocol):
    """Protocol of the medium's own transport, which passes its calls to the stream in the link's thread."""

    def __init__(self, relay: Relay) -> None:
        self._relay = relay

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Pass the beginning of the connection to the stream."""
        self._relay.begin(cast("asyncio.Transport", transport))

    def data_received(self, data: bytes) -> None:
        """Pass received bytes to the stream."""
        stream = self._relay.stream
        self._relay.call_in_link(lambda: stream.data_received(data))

    def pause_writing(self) -> None:
        """Pause the writing of the stream."""
        self._relay.call_in_link(self._relay.stream.pause_writing)

    def resume_writing(self) -> None:
        """Resume the writing of the stream."""
        self._relay.call_in_link(self._relay.stream.resume_writing)

    def connection_lost(self, exc: Exception | None) -> None:
        """Pass the end of the connection to the stream."""
        self._relay.end(exc)
