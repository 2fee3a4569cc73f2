"""Sockets that other programs connect to: where they may be opened, by which users, and the errors where they can't.

A Unix socket belongs to this user alone, and one that a program left behind is replaced only if no process listens at
it. TCP is for this machine alone unless the caller names another address.
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
    """Server of an ``async with`` block; warns where that is never left.

    Args:
        what: how messages call it.
        block: serves.
    """

    def __init__(self, what: str, block: contextlib.AbstractAsyncContextManager[T_co]) -> None:
        self._what = what
        self._block = block
        self._is_open = False

    if not TYPE_CHECKING:  # A type checker refuses them by itself.
        __await__ = __enter__ = __exit__ = refusing("nothing is served yet: write `async with serve...(...) as url:`")

    def __del__(self) -> None:
        """Warn of what was not closed."""
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
    """Make of a generator what serves while an ``async with`` block runs, as `contextlib.asynccontextmanager` does."""

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
    """Listen at a TCP port until the end of the context; 0 chooses a free one. Returns the URL.

    Raises:
        ConnectError: where the port can't be opened.
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
    """Listen at a Unix socket that only this user may open, and that is removed at the end. Returns the URL.

    Raises:
        ConnectError: where something else is at the path, or it can't be used.
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
        # If ours was removed, another one may be in its place.
        with contextlib.suppress(FileNotFoundError):
            if place.stat().st_ino == mine:
                place.unlink()


def _bind(path: str | os.PathLike[str]) -> tuple[Path, socket.socket]:
    """Bind a socket; one that a program left behind without removing it is replaced."""
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
    """Remove a socket that a program left behind.

    Raises:
        ConnectError: where a program listens at it, or that cannot be found out.
    """
    with socket.socket(socket.AF_UNIX) as probe:
        # A program that stands still takes no more callers, and a caller must not wait for it.
        probe.settimeout(0)
        try:
            probe.connect(str(place))
        except (ConnectionRefusedError, FileNotFoundError):
            place.unlink(missing_ok=True)
        except BlockingIOError:
            raise ConnectError(
                f"{place} is served by another program, which answers nobody: end that, or choose another path"
            ) from None
        except OSError as error:
            raise ConnectError(f"{place} can't be served ({error.strerror}): choose another path") from error
        else:
            raise ConnectError(f"{place} is already served by another program: choose another path")


def checked_host(host: str) -> str:
    """Return an address to listen at.

    Raises:
        OSError: for an empty one, which asyncio takes for every address of the machine.
    """
    if not host:
        raise OSError(errno.EINVAL, "an address was expected")
    return host


def url_of(scheme: str, host: str, port: int) -> str:
    """Return the URL of a port."""
    return f"{scheme}://{f'[{host}]' if ':' in host else host}:{port}"


def port_error(kind: str, host: str, port: int, error: Exception) -> ConnectError:
    """Return the error for a port that can't be opened, with the reason."""
    host = host or repr(host)
    if isinstance(error, OSError) and error.errno == errno.EADDRINUSE:
        return ConnectError(f"{kind} port {port} of {host} is in use: choose another, or 0 for any free one")
    reason = getattr(error, "strerror", None) or error
    return ConnectError(f"{kind} port {port} of {host} can't be opened ({reason}): choose another port or address")
