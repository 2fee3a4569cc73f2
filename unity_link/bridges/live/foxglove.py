"""The same samples for the Foxglove app, on a WebSocket: messages as in recordings.

Foxglove can only show values: this server offers no way to write. It does not check the ``Origin``, because the app on
the web is a page of another site; but only this machine can connect to it.
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
"""Most messages that wait for an app that does not read; with more, the oldest are dropped."""


class FoxgloveServer:
    """A Foxglove server at a port of this machine, until the end of its context.

    Args:
        robot: robot with the signals.
        groups: groups to show; each is a channel.
        port: port; 0 for any free port.

    Raises:
        ConnectError: if the port cannot be opened, or foxglove-sdk is not installed.
    """

    def __init__(self, robot: Robot, groups: Sequence[SampledGroup], port: int) -> None:
        try:
            import foxglove
        except ImportError:
            raise ConnectError("Foxglove needs foxglove-sdk: pip install 'unity-link[foxglove]'") from None
        self._bits = robot.interface.data_bits
        self._encoders = [Encoder([proxy.signal for proxy in group.group.proxies]) for group in groups]
        # Keep the context: if it is deleted, the server loses its channels.
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
        # Do not log errors of apps on the terminal.
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
        """Send samples of a group, by its number; only one thread may call this."""
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
