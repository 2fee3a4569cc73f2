"""The bridge's own link: one more client of the shared link, in the same process."""

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
    """A link to a gateway through what shares it.

    Args:
        shared: the link that is shared.
        target: what that is a link to: messages name it.
    """

    def __init__(self, shared: SharedLink, target: DriverUrl | Medium) -> None:
        # A node's number is between the shared link and its gateway alone.
        super().__init__(
            msgspec.structs.replace(target, options={}) if isinstance(target, DriverUrl) else target,
            reconnect=None,
            resumes=True,
        )
        self._shared = shared

    async def _connect_stream(self, stream: Stream) -> None:
        connect_pipe(PipeEnd(stream), PipeEnd(Client(self._shared)))
