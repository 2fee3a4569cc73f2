"""Links of other machines: each is a client of the shared link, with two keys for its bytes.

A client opens a link by a query at ``PREFIX/@link/open`` with a name that it has chosen. From then on the client
publishes at ``PREFIX/@link/NAME/up``, and the bridge at ``PREFIX/@link/NAME/down``. Each publication begins with its
number, in eight hexadecimal digits. The client declares a liveliness token at ``PREFIX/@link/NAME/client``, the bridge
at ``PREFIX/@link/NAME/bridge``. So each side learns when the other ends, for any reason, and the groups of a client end
with it.
"""

from __future__ import annotations

import functools
import re
from typing import TYPE_CHECKING

from unity_link.bridges.serve.client import Client
from unity_link.bridges.serve.door import MOST_CLIENTS
from unity_link.transport.inbox import Inbox
from unity_link.transport.zenoh_session import OPEN, Declaration, KeyTransport

if TYPE_CHECKING:
    import zenoh

    from unity_link.bridges.serve.shared import SharedLink

_NAME = re.compile(r"[0-9a-f]{16}")


class Streams:
    """The streams of one bridge.

    Args:
        session: an open session.
        prefix: prefix of all keys.
        shared: the shared link.
    """

    def __init__(self, session: zenoh.Session, prefix: str, shared: SharedLink) -> None:

        self._session = session
        self._place = f"{prefix}/@link"
        self._shared = shared
        self._there: set[str] = set()
        """Names of the clients whose token was seen."""
        self._open: dict[str, tuple[KeyTransport, Declaration]] = {}
        asked: Inbox[zenoh.Query] = Inbox(self._answer)
        seen: Inbox[zenoh.Sample] = Inbox(self._watch)

        self._declared: tuple[Declaration, ...] = (
            session.liveliness().declare_subscriber(f"{self._place}/*/client", seen.give, history=True),
            session.declare_queryable(f"{prefix}/{OPEN}", asked.give),
        )

    def _watch(self, samples: list[zenoh.Sample]) -> None:
        import zenoh

        for sample in samples:
            name = str(sample.key_expr).split("/")[-2]
            if sample.kind == zenoh.SampleKind.PUT:
                self._there.add(name)
            else:
                self._there.discard(name)
                self._end(name)

    def _answer(self, queries: list[zenoh.Query]) -> None:
        for query in queries:
            with query:
                payload = query.payload
                name = payload.to_bytes().decode(errors="replace") if payload is not None else ""
                if _NAME.fullmatch(name) and name not in self._there:
                    # Without the token, the client's end could not be detected: wait until it asks again.
                    continue
                refusal = self._serve(name)
                if refusal is None:
                    query.reply(query.key_expr, b"")
                else:
                    query.reply_err(refusal)

    def _serve(self, name: str) -> str | None:
        """Serve a client; return the reason for a refusal, or None."""
        if name in self._open:
            return None
        if not _NAME.fullmatch(name):
            return f"a name of 16 hex digits was expected, not {name[:40]!r}"
        if len(self._shared.clients) >= MOST_CLIENTS:
            return f"it has {MOST_CLIENTS} clients already"
        place = f"{self._place}/{name}"
        token: Declaration = self._session.liveliness().declare_token(f"{place}/bridge")
        client = Client(self._shared)
        over = functools.partial(self._over, name)
        transport = KeyTransport(self._session, f"{place}/down", f"{place}/up", client, over)
        self._open[name] = transport, token
        client.connection_made(transport)
        return None

    def _over(self, name: str) -> None:
        _, token = self._open.pop(name)
        token.undeclare()

    def _end(self, name: str) -> None:
        if name in self._open:
            self._open[name][0].abort()

    def close(self) -> None:
        """End all streams."""
        for declared in self._declared:
            declared.undeclare()
        for name in list(self._open):
            self._end(name)
