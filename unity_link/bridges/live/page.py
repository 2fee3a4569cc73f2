"""The page: its server, what it shows, and who looks at it."""

from __future__ import annotations

import asyncio
import contextlib
import socket
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
import uvicorn
from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.routing import Mount, WebSocketRoute
from starlette.staticfiles import StaticFiles

from unity_link.bridges.carrying import Carrier
from unity_link.bridges.live.clock import GatewayClock
from unity_link.bridges.live.description import WIDEST_EXACT, describe
from unity_link.bridges.live.doorkeeper import Doorkeeper
from unity_link.bridges.live.outbox import tabulate
from unity_link.bridges.live.round_trips import Histogram, RoundTrips
from unity_link.bridges.live.viewer import Viewer
from unity_link.bridges.live.writing import Writing
from unity_link.link import Statistics  # noqa: TC001  (msgspec reads the annotations)
from unity_link.listening import LOOPBACK, port_error

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from starlette.websockets import WebSocket

    from unity_link.bridges.live.foxglove import FoxgloveServer
    from unity_link.bridges.live.outbox import Chunk
    from unity_link.bridges.sampled import SampledGroup
    from unity_link.data import Batch, Robot

BUFFER = 1 << 16
"""Samples of each group that wait while they are encoded; after that the oldest are lost, and counted."""
MOST_VIEWERS = 32
STATUS_EVERY = 0.2
"""Seconds."""
_ASSETS = Path(__file__).parent / "assets"
_LARGEST_MESSAGE = 4096
"""Bytes of what a page says."""
_TRY_AGAIN_LATER = 1013


def bind(port: int) -> socket.socket:
    """Open a port of this machine alone; 0 for any free one.

    Raises:
        ConnectError: where it can't be opened.
    """
    try:
        return socket.create_server((LOOPBACK, port))
    except (OSError, OverflowError) as error:
        raise port_error("TCP", LOOPBACK, port, error) from error


class Status(msgspec.Struct, tag_field="type", tag="status"):
    """How the link is."""

    connected: bool
    samples: int
    lost: int
    """Samples that the gateway took and that did not come as far as here."""
    link: Statistics
    round_trips: Histogram
    exact: dict[str, str]
    """Values of whole numbers that are wider than a double, by the paths of their signals."""


class LivePage:
    """The page of a robot.

    Args:
        robot: behind an open link.
        groups: what is sampled.
        gateway: where the gateway is, for people.
        token: what a page must know to write; None: there are no writes.
        foxglove: where the samples go besides.
    """

    def __init__(
        self,
        robot: Robot,
        groups: Sequence[SampledGroup],
        *,
        gateway: str,
        token: str | None = None,
        foxglove: FoxgloveServer | None = None,
    ) -> None:
        self._link = robot.link
        self._groups = [group.group for group in groups]
        self._writing = None if token is None else Writing(robot, token)
        self._foxglove = foxglove
        self._carrier = Carrier(self._groups, self._tabulate, buffer=BUFFER)
        self._clocks = [GatewayClock() for _ in groups]
        self._round_trips = RoundTrips(robot.link, self._groups[0].proxies[0].signal.address)
        self._viewers: set[Viewer] = set()
        self._wide = [
            proxy
            for group in self._groups
            for proxy in group.proxies
            if proxy.signal.kind.width > WIDEST_EXACT and not proxy.signal.kind.is_float
        ]
        # A subscription that is not entered asks nothing of the gateway.
        rates = [group.subscribe().rate_hz for group in self._groups]
        about = describe(robot, groups, rates, gateway)
        self._about = msgspec.json.encode(msgspec.structs.replace(about, writes=self._writing is not None))
        self._loop = asyncio.get_running_loop()
        self._server = self._make_server()

    @property
    def samples(self) -> int:
        """Samples that came."""
        return self._carrier.carried

    @property
    def lost(self) -> int:
        """Samples that the gateway took and that did not come as far as here."""
        return self._carrier.lost

    @property
    def written(self) -> int:
        """Values that pages had written."""
        return 0 if self._writing is None else self._writing.written

    async def run(self, listener: socket.socket) -> None:
        """Show the page at a port until cancelled.

        Args:
            listener: of `bind`; it is closed at the end.

        Raises:
            LinkLostError: where the link ends.
        """
        encoder = ThreadPoolExecutor(1, "live")
        try:
            await self._carrier.run(encoder, self._serve(listener), self._tell(), self._round_trips.run())
        finally:
            encoder.shutdown(wait=False)

    # Samples, in the thread and back

    def _tabulate(self, stream: int, batch: Batch) -> None:
        instants = self._clocks[stream].place(batch)
        if self._foxglove is not None:
            self._foxglove.send(stream, batch, instants)
        chunk = tabulate(stream, batch, instants, self._groups[stream].proxies)
        self._loop.call_soon_threadsafe(self._deliver, chunk)

    def _deliver(self, chunk: Chunk) -> None:
        for viewer in self._viewers:
            viewer.outbox.put(chunk)

    async def _tell(self) -> None:
        while True:
            await asyncio.sleep(STATUS_EVERY)
            status = msgspec.json.encode(
                Status(
                    self._link.connected,
                    self.samples,
                    self.lost,
                    self._link.statistics,
                    self._round_trips.histogram(),
                    {proxy.path: str(proxy.value) for proxy in self._wide if proxy.value is not None},
                )
            )
            for viewer in self._viewers:
                viewer.status = status

    # The server

    def _make_server(self) -> _Server:
        routes = [
            WebSocketRoute("/samples", self._view),
            Mount("/", StaticFiles(directory=_ASSETS, html=True)),
        ]
        config = uvicorn.Config(
            Starlette(routes=routes, middleware=[Middleware(Doorkeeper)]),
            log_config=None,
            access_log=False,
            lifespan="off",
            server_header=False,
            ws="websockets-sansio",
            ws_max_size=_LARGEST_MESSAGE,
            timeout_graceful_shutdown=1,
        )
        # It imports for long, which would lose samples once they come.
        config.load()
        return _Server(config)

    async def _serve(self, listener: socket.socket) -> None:
        server = self._server
        serving = asyncio.create_task(server.serve([listener]))
        try:
            await asyncio.shield(serving)
        finally:
            server.should_exit = True
            await serving

    async def _view(self, websocket: WebSocket) -> None:
        await websocket.accept()
        if len(self._viewers) >= MOST_VIEWERS:
            await websocket.close(_TRY_AGAIN_LATER, f"{MOST_VIEWERS} pages are open already")
            return
        viewer = Viewer(websocket, self._about, self._writing)
        self._viewers.add(viewer)
        try:
            await viewer.run()
        finally:
            self._viewers.discard(viewer)


class _Server(uvicorn.Server):
    """A server in a program that looks after signals itself."""

    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        yield
