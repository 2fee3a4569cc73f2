"""The same samples for the Foxglove app, by its WebSocket: the messages of recordings, as they come.

It is for looking alone: the server offers Foxglove no way to write. Foxglove's own server asks for no ``Origin``, since
the app on the web is a page of another site; it can be reached from this machine alone.
"""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Self

import msgspec
import numpy as np

from unity_link.bridges.messages import Encoder
from unity_link.errors import ConnectError
from unity_link.transport.listening import LOOPBACK

if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import TracebackType

    from numpy.typing import NDArray

    from unity_link.bridges.sampled import SampledGroup
    from unity_link.data import Batch, Robot

BACKLOG = 4096
"""Messages that wait for an app that does not read; then the oldest are dropped."""


class FoxgloveServer:
    """Foxglove's server at a port of this machine, until the end of its context.

    Args:
        robot: whose samples.
        groups: each is a channel.
        port: any free one for 0.

    Raises:
        ConnectError: where the port can't be opened, or foxglove-sdk is not installed.
    """

    def __init__(self, robot: Robot, groups: Sequence[SampledGroup], port: int) -> None:
        try:
            import foxglove
        except ImportError:
            raise ConnectError("Foxglove needs foxglove-sdk: pip install 'unity-link[foxglove]'") from None
        self._bits = robot.interface.data_bits
        self._encoders = [Encoder([proxy.signal for proxy in group.group.proxies]) for group in groups]
        # The server loses its channels with the context that they are of.
        self._context = context = foxglove.Context()
        self._channels = [
            foxglove.Channel(
                f"/{robot.interface.name}/{group.name}",
                message_encoding="json",
                schema=foxglove.Schema(
                    name=f"{robot.interface.name}.{group.name}",
                    encoding="jsonschema",
                    data=msgspec.json.encode(encoder.schema),
                ),
                context=context,
            )
            for group, encoder in zip(groups, self._encoders, strict=True)
        ]
        # What an app says wrong is no matter of the terminal.
        foxglove.set_log_level("CRITICAL")
        try:
            self._server = foxglove.start_server(
                name=f"unity-link {robot.interface.name}",
                host=LOOPBACK,
                port=port,
                context=context,
                message_backlog_size=BACKLOG,
            )
        except (OSError, RuntimeError) as error:
            raise ConnectError(
                f"Foxglove's port {port} of {LOOPBACK} can't be opened ({error}): choose another"
            ) from None

    def __str__(self) -> str:
        """Return the URL for the app."""
        return f"ws://{LOOPBACK}:{self._server.port}"

    def send(self, group: int, batch: Batch, instants: NDArray[np.float64]) -> None:
        """Send the samples of the group of that number; to be called in one thread."""
        channel = self._channels[group]
        if not channel.has_sinks():
            return
        at = np.rint(instants * 1e9).astype(np.int64).tolist()
        for instant, message in zip(at, self._encoders[group].encode(batch, self._bits), strict=True):
            channel.log(message, log_time=instant)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        with contextlib.suppress(RuntimeError):
            self._server.stop()
