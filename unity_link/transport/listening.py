"""Opens the sockets that other programs connect to.

Only the user who runs this program can connect to a Unix socket. A socket that an earlier program left is replaced only
if no process listens on it. TCP ports are open to this machine only, unless the caller names another address.
"""

from __future__ import annotations

import asyncio
import contextlib
import errno
import functools
import os
import socket
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, ParamSpec, TypeVar

from unity_link.errors import ConnectError, refusing

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable
    from types import TracebackType

P = ParamSpec("P")
T = TypeVar("T")
T_co = TypeVar("T_co", covariant=True)
LOOPBACK = "127.0.0.1"
_OWNER_ONLY = 0o177


class Serving(contextlib.AbstractAsyncContextManager[T_co]):
    """A server that runs during an ``async with`` block; it warns if the block never ends.

    Args:
        what: name of the server in messages.
        block: context manager that runs the server.
    """

    def __init__(self, what: str, block: contextlib.AbstractAsyncContextManager[T_co]) -> None:
        self._what = what
        self._block = block
        self._is_open = False

    if not TYPE_CHECKING:  # A type checker reports wrong uses without these.
        __await__ = __enter__ = __exit__ = refusing("nothing is served yet: write `async with serve...(...) as url:`")

    def __del__(self) -> None:
        """Warn if the block was not left."""
        if self._is_open:
            warnings.warn(f"{self._what} is still served: use `async with`", ResourceWarning, stacklevel=1, source=self)

    async def __aenter__(self) -> T_co:
        served = await self._block.__aenter__()
        self._is_open = True
        return served

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> bool | None:
        self._is_open = False
        return await self._block.__aexit__(kind, error, trace)


def serving(what: str) -> Callable[[Callable[P, AsyncIterator[T]]], Callable[P, Serving[T]]]:
    """Return a decorator like `contextlib.asynccontextmanager`, whose functions return a `Serving`.

    Args:
        what: name of the server in messages.
    """

    def decorate(generate: Callable[P, AsyncIterator[T]]) -> Callable[P, Serving[T]]:
        make = contextlib.asynccontextmanager(generate)

        @functools.wraps(generate)
        def serve(*arguments: P.args, **options: P.kwargs) -> Serving[T]:
            return Serving(what, make(*arguments, **options))

        return serve

    return decorate


@contextlib.asynccontextmanager
async def listen_tcp(
    factory: Callable[[], asyncio.Protocol], port: int = 0, host: str = LOOPBACK
) -> AsyncIterator[str]:
    """Listen on a TCP port until the end of the context, and yield its URL; port 0 chooses a free port.

    Raises:
        ConnectError: if the port cannot be opened.
    """
    try:
        server = await asyncio.get_running_loop().create_server(factory, checked_host(host), port)
    except (OSError, OverflowError, UnicodeError) as error:
        raise port_error("TCP", host, port, error) from error
    try:
        yield url_of("tcp", host, server.sockets[0].getsockname()[1])
    finally:
        server.close()


@contextlib.asynccontextmanager
async def listen_unix(factory: Callable[[], asyncio.Protocol], path: str | os.PathLike[str]) -> AsyncIterator[str]:
    """Listen on a Unix socket that only this user can open, and yield its URL; remove the socket at the end.

    Raises:
        ConnectError: if the path belongs to another file or a running server, or cannot be used.
    """
    place, listener = _bind(path)
    mine = place.stat().st_ino
    try:
        server = await asyncio.get_running_loop().create_unix_server(factory, sock=listener)
        try:
            yield f"unix:{place}"
        finally:
            server.close()
    finally:
        listener.close()
        # Remove only our own socket: another program may have replaced it.
        with contextlib.suppress(FileNotFoundError):
            if place.stat().st_ino == mine:
                place.unlink()


def _bind(path: str | os.PathLike[str]) -> tuple[Path, socket.socket]:
    """Bind a socket to a path; replace a socket that no program listens on any more."""
    place = Path(path).absolute()
    if place.is_socket():
        _make_way(place)
    elif place.exists():
        raise ConnectError(f"{place} exists and is no socket: remove it, or choose another path")
    listener = socket.socket(socket.AF_UNIX)
    mask = os.umask(_OWNER_ONLY)
    try:
        listener.bind(str(place))
    except OSError as error:
        listener.close()
        raise ConnectError(
            f"no socket can be made at {place} ({error.strerror or error}): choose another path"
        ) from error
    finally:
        os.umask(mask)
    return place, listener


def _make_way(place: Path) -> None:
    """Remove a socket that an earlier program left.

    Raises:
        ConnectError: if a program listens on the socket, or it is unknown whether one does.
    """
    with socket.socket(socket.AF_UNIX) as probe:
        # Do not block: a stopped program may never accept the connection.
        probe.settimeout(0)
        try:
            probe.connect(str(place))
        except (ConnectionRefusedError, FileNotFoundError):
            place.unlink(missing_ok=True)
        except BlockingIOError:
            raise ConnectError(
                f"{place} is served by another program, which accepts no connections: end it, or choose another path"
            ) from None
        except OSError as error:
            raise ConnectError(f"{place} can't be served ({error.strerror}): choose another path") from error
        else:
            raise ConnectError(f"{place} is already served by another program: choose another path")


def checked_host(host: str) -> str:
    """Return an address to listen on.

    Raises:
        OSError: if the address is empty: asyncio would listen on all addresses of the machine.
    """
    if not host:
        raise OSError(errno.EINVAL, "an address was expected")
    return host


def url_of(scheme: str, host: str, port: int) -> str:
    """Return the URL of a port of a host."""
    return f"{scheme}://{f'[{host}]' if ':' in host else host}:{port}"


def port_error(kind: str, host: str, port: int, error: Exception) -> ConnectError:
    """Return a ConnectError with the reason why a port cannot be opened."""
    host = host or repr(host)
    if isinstance(error, OSError) and error.errno == errno.EADDRINUSE:
        return ConnectError(f"{kind} port {port} of {host} is in use: choose another, or 0 for any free one")
    reason = getattr(error, "strerror", None) or error
    return ConnectError(f"{kind} port {port} of {host} can't be opened ({reason}): choose another port or address")
