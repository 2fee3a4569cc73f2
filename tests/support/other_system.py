"""Import the whole package as if on Windows or macOS, read and write there: run by test_platforms.py.

Before the first import, this program removes the modules and functions that these systems lack. It shows that no module
needs them when it is imported, and which features do without them; it does not replace a test on Windows.
"""

import asyncio
import importlib
import json
import os
import pkgutil
import select
import selectors
import socket
import sys
import threading

OTHERS = ("anyio._backends._asyncio", "numpy", "serial", "serial_asyncio_fast", "trio", "typer")
"""Modules of other projects that inspect the system when they are imported."""
MODULES = {
    "win32": ("fcntl", "termios", "pty", "tty", "resource", "grp", "pwd", "syslog"),
    "darwin": (),
}
NAMES = {
    "win32": [
        *((os, name) for name in ("openpty", "fork", "O_NONBLOCK", "O_CLOEXEC", "ttyname", "getuid", "geteuid")),
        *((select, name) for name in ("poll", "epoll", "POLLIN", "POLLOUT")),
        (socket, "AF_UNIX"),
    ],
    "darwin": [(select, "epoll")],
}


def pair_by_tcp() -> tuple[socket.socket, socket.socket]:
    """Return two connected sockets, as ``socket.socketpair`` does on Windows."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        one = socket.create_connection(server.getsockname())
        return one, server.accept()[0]


async def answers(urls: list[str]) -> list[int]:
    import unity_link

    found: list[int] = []
    for url in urls:
        async with unity_link.connect(url) as link:
            await link.write(0x20, 7)
            found += (await link.read_many([0x20])).tolist()
    return found


def blocking_answers(urls: list[str]) -> list[int]:
    from unity_link import blocking

    found: list[int] = []
    for url in urls:
        with blocking.connect(url) as link:
            link.write(0x20, 8)
            found.append(link.read(0x20))
            with link.subscribe([0x20], rate_hz=1000) as samples:
                found.append(int(next(iter(samples)).values[0]))
    return found


def faults() -> dict[str, str]:
    """Return the modules that cannot be imported, with the reasons."""
    import unity_link

    found = {}
    for module in pkgutil.walk_packages(unity_link.__path__, "unity_link."):
        try:
            importlib.import_module(module.name)
        except Exception as error:  # noqa: BLE001  (any fault is reported)
            found[module.name] = f"{type(error).__name__}: {error}"
    return found


def main() -> None:
    """Print the results as JSON."""
    system, *urls = sys.argv[1:]
    for other in OTHERS:
        importlib.import_module(other)
    loop = asyncio.new_event_loop()
    sys.platform = system
    for module in MODULES[system]:
        sys.modules[module] = None  # type: ignore[assignment]
    for holder, name in NAMES[system]:
        if hasattr(holder, name):
            delattr(holder, name)
    if system == "win32":
        socket.socketpair = pair_by_tcp  # type: ignore[assignment]
        selectors.DefaultSelector = selectors.SelectSelector  # type: ignore[assignment, misc]
    result = {
        "asyncio": loop.run_until_complete(answers(urls)),
        "blocking": blocking_answers(urls),
        "faults": faults(),
        "threads": threading.active_count(),
    }
    sys.stdout.write(json.dumps(result))


if __name__ == "__main__":
    main()
