"""The page: its server, its data and its viewers."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec
import numpy as np
from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.routing import Mount, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.websockets import WebSocketClose, WebSocketDisconnect

from unity_link.bridges.gateway_time import GatewayTime
from unity_link.bridges.live.description import WIDEST_EXACT, describe
from unity_link.bridges.live.doorkeeper import Doorkeeper
from unity_link.bridges.live.outbox import Chunk, Tabulator
from unity_link.bridges.live.round_trips import Histogram, RoundTrips
from unity_link.bridges.live.server import make_server
from unity_link.bridges.live.viewer import Viewer
from unity_link.bridges.live.writing import Stopping, Writing
from unity_link.bridges.thread_queue import Carrier
from unity_link.errors import GatewayError
from unity_link.link.link import Statistics  # noqa: TC001  (msgspec reads the annotations)
from unity_link.transport.listening import LOOPBACK, port_error

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Iterator, Sequence

    from starlette.websockets import WebSocket

    from unity_link.bridges.live.foxglove import FoxgloveServer
    from unity_link.bridges.sampled import SampledGroup
    from unity_link.data import Batch, Group, Robot

BUFFER = 1 << 16
"""Most samples of each group that wait to be encoded; with more, the oldest are dropped and counted."""
MOST_VIEWERS = 32
MOST_SLEW = 0.5
"""Seconds per second by which instants are corrected: high, so that a curve that began late does not stay late."""
STATUS_EVERY = 0.2
"""Seconds between two messages with the state of the link."""
READ_EVERY = 1.0
"""Seconds between reads of a group that is published on change, so that values that never change are shown, too."""
_ASSETS = Path(__file__).parent / "assets"
_TRY_AGAIN_LATER = 1013


def bind(port: int) -> socket.socket:
    """Open a port that only this machine can reach; 0 for any free port.

    Raises:
        ConnectError: if the port cannot be opened.
    """
    try:
        return socket.create_server((LOOPBACK, port))
    except (OSError, OverflowError) as error:
        raise port_error("TCP", LOOPBACK, port, error) from error


class PageStatus(msgspec.Struct, tag_field="type", tag="status"):
    """State of the link."""

    connected: bool
    refusal: str | None
    """Reason why the gateway does not answer reads, though the link is connected; None if it does."""
    samples: int
    lost: int
    """Number of samples that the gateway took and that did not arrive here."""
    link: Statistics
    round_trips: Histogram
    exact: dict[str, str]
    """Whole numbers that are too wide for a double, as texts, by the paths of their signals."""
    written: dict[str, object]
    """Values that pages have written to signals without samples, by path; unknown values are left out."""


class LivePage:
    """The page of a robot.

    Args:
        robot: robot on an open link.
        groups: groups to show.
        gateway: URL of the gateway, as shown on the page.
        token: token that a page must send before it may write; None if no page may write.
        foxglove: Foxglove server that gets the samples, too.
        report: called with a sentence about signals that cannot be read.
    """

    def __init__(
        self,
        robot: Robot,
        groups: Sequence[SampledGroup],
        *,
        gateway: str,
        token: str | None = None,
        foxglove: FoxgloveServer | None = None,
        report: Callable[[str], None] = lambda _: None,
    ) -> None:
        self._link = robot.link
        self._groups = [group.group for group in groups]
        sampled = {proxy for group in self._groups for proxy in group.proxies}
        self._writing = None if token is None else Writing(robot, token, sampled)
        self._stopping = Stopping(robot)
        self._foxglove = foxglove
        self._carrier = Carrier(self._groups, self._tabulate, report, buffer=BUFFER)
        self._time = GatewayTime(robot.link, most_slew=MOST_SLEW)
        self._round_trips = RoundTrips([proxy for group in self._groups for proxy in group.proxies])
        self._viewers: set[Viewer] = set()
        self._chunks = [0] * len(self._groups)
        """Number of chunks delivered, by group."""
        self._wide = [
            proxy
            for proxy in robot.signals
            if proxy.signal.kind.width > WIDEST_EXACT and not proxy.signal.kind.is_float
        ]
        # A subscription that is not entered sends no requests.
        rates = [group.subscribe().rate_hz for group in self._groups]
        about = describe(robot, groups, rates, gateway)
        self._tabulators = [
            Tabulator(stream, group, rate) for stream, (group, rate) in enumerate(zip(self._groups, rates, strict=True))
        ]
        self._about = msgspec.json.encode(msgspec.structs.replace(about, writes=self._writing is not None))
        self._loop = asyncio.get_running_loop()
        routes = [
            WebSocketRoute("/samples", self._view),
            WebSocketRoute("/{path:path}", WebSocketClose()),
            Mount("/", StaticFiles(directory=_ASSETS, html=True)),
        ]
        self._server = make_server(Starlette(routes=routes, middleware=[Middleware(Doorkeeper)]))

    @property
    def samples(self) -> int:
        """Number of samples received."""
        return self._carrier.carried

    @property
    def lost(self) -> int:
        """Number of samples that the gateway took and that did not arrive here."""
        return self._carrier.lost

    @property
    def written(self) -> int:
        """Number of values that pages have written."""
        return 0 if self._writing is None else self._writing.written

    async def run(self, listener: socket.socket) -> None:
        """Serve the page until this is cancelled.

        Args:
            listener: socket of `bind`; it is closed at the end.

        Raises:
            LinkLostError: if the link ends.
        """
        encoder = ThreadPoolExecutor(1, "live")
        try:
            await self._carrier.run(
                encoder, self._serve(listener), self._update_status(), self._round_trips.run(), *self._readings()
            )
        finally:
            encoder.shutdown(wait=False)

    # Samples, to the thread and back

    def _tabulate(self, stream: int, batch: Batch) -> None:
        instants = self._time.instants(stream, batch)
        if self._foxglove is not None:
            self._foxglove.send(stream, batch, instants)
        chunk = self._tabulators[stream].tabulate(batch, instants)
        self._loop.call_soon_threadsafe(self._deliver, chunk)

    def _deliver(self, chunk: Chunk) -> None:
        self._chunks[chunk.stream] += 1
        for viewer in self._viewers:
            viewer.outbox.put(chunk)

    def _readings(self) -> Iterator[Coroutine[Any, Any, None]]:
        """Yield coroutines that read groups published on change, except groups with queues, which a read empties."""
        for stream, group in enumerate(self._groups):
            on_change = group.model is not None and group.model.on_change
            if on_change and not any(proxy.signal.read_takes for proxy in group.proxies):
                yield self._read_again(stream, group)

    async def _read_again(self, stream: int, group: Group) -> None:
        """Deliver the values of a group every `READ_EVERY` seconds, as a sample.

        Raises:
            LinkLostError: if the link ends.
        """
        await self._carrier.begun.wait()
        was_away, session = False, self._link.statistics.reconnections
        while True:
            delivered = self._chunks[stream]
            try:
                values = await group.get()
            except GatewayError:
                # A server refuses reads while its gateway is away; the page shows the reason.
                was_away = True
            else:
                was_away |= session != self._link.statistics.reconnections
                # If a sample arrived in the meantime, it may be newer than the values read: do not deliver them.
                if delivered == self._chunks[stream]:
                    column = [time.time(), was_away, *(values[proxy] for proxy in group.proxies)]
                    self._deliver(Chunk(stream, np.array(column, "<f8")[:, np.newaxis]))
                was_away, session = False, self._link.statistics.reconnections
            await asyncio.sleep(READ_EVERY)

    async def _update_status(self) -> None:
        while True:
            await asyncio.sleep(STATUS_EVERY)
            status = msgspec.json.encode(
                PageStatus(
                    self._link.connected,
                    self._round_trips.refusal,
                    self.samples,
                    self.lost,
                    self._link.statistics,
                    self._round_trips.histogram(),
                    {proxy.path: str(proxy.value) for proxy in self._wide if proxy.value is not None},
                    {} if self._writing is None else self._writing.values,
                )
            )
            for viewer in self._viewers:
                viewer.status = status

    # The server

    async def _serve(self, listener: socket.socket) -> None:
        server = self._server
        serving = asyncio.create_task(server.serve([listener]))
        try:
            await asyncio.shield(serving)
        finally:
            for viewer in self._viewers:
                viewer.leave()
            server.should_exit = True
            await serving

    async def _view(self, websocket: WebSocket) -> None:
        await websocket.accept()
        if len(self._viewers) >= MOST_VIEWERS:
            with contextlib.suppress(WebSocketDisconnect):
                await websocket.close(_TRY_AGAIN_LATER, f"{MOST_VIEWERS} pages are open already")
            return
        viewer = Viewer(websocket, self._about, self._writing, self._stopping)
        self._viewers.add(viewer)
        try:
            await viewer.run()
        finally:
            self._viewers.discard(viewer)
