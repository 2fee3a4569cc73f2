"""Access control: only requests of this server's own pages are answered.

A page of another site in the same browser can send requests to any address, including this machine's. If its site has a
name that resolves to this machine (DNS rebinding), it could even read the answers. So the ``Host`` of a request must be
a name of this machine, and the ``Origin``, which browsers always send with a WebSocket, must be our own page.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import PlainTextResponse
from starlette.websockets import WebSocketClose

if TYPE_CHECKING:
    from starlette.types import ASGIApp, Message, Receive, Scope, Send

OWN_NAMES = ("127.0.0.1", "localhost")
_HEADERS = {
    "Content-Security-Policy": "default-src 'self'; img-src 'self' data:; frame-ancestors 'none'; base-uri 'none'; "
    "form-action 'none'; object-src 'none'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-cache",
}


class Doorkeeper:
    """Refuses requests for other names and of other pages; an ASGI application that wraps another one."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or refuse it."""
        headers = Headers(scope=scope)
        host, origin = headers.get("host", ""), headers.get("origin")
        if host.partition(":")[0] not in OWN_NAMES:
            reason = f"this page is for {' and '.join(OWN_NAMES)} alone"
        elif (origin is not None or scope["type"] == "websocket") and origin != f"http://{host}":
            reason = "this is for its own page alone"
        else:
            await self._app(scope, receive, lambda message: send(_hardened(message)))
            return
        refusal = WebSocketClose() if scope["type"] == "websocket" else PlainTextResponse(reason, 403)
        await refusal(scope, receive, send)


def _hardened(message: Message) -> Message:
    if message["type"] == "http.response.start":
        MutableHeaders(scope=message).update(_HEADERS)
    return message
