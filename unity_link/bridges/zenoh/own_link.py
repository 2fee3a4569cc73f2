"""The bridge's own link: a client of the shared link in the same process."""

from __future__ import annotations

from typing import TYPE_CHECKING

import msgspec

from unity_link.bridges.serve.client import Client
from unity_link.link.link import Link
from unity_link.transport import DriverUrl
from unity_link.transport.pipe import PipeEnd, connect_pipe

if TYPE_CHECKING:
    from unity_link.bridges.serve.shared import SharedLink
    from unity_link.transport import Medium
    from unity_link.transport.stream import Stream


class OwnLink(Link):
    """A link to a gateway through a shared link.

    Args:
        shared: the shared link.
        target: target of the shared link, for messages.
    """

    def __init__(self, shared: SharedLink, target: DriverUrl | Medium) -> None:
        # Without options: the number of a node matters only between the shared link and its gateway.
        super().__init__(
            msgspec.structs.replace(target, options={}) if isinstance(target, DriverUrl) else target,
            reconnect=None,
            resumes=True,
        )
        self._shared = shared

    async def _connect_stream(self, stream: Stream) -> None:
        connect_pipe(PipeEnd(stream), PipeEnd(Client(self._shared)))
