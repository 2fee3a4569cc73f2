"""Notifications to the service manager that started a command, by sd_notify of systemd.

The protocol is datagrams of ``NAME=value`` lines to the socket that `NOTIFY_SOCKET` names (sd_notify(3)); where it
names none, nothing is said. `WATCHDOG_USEC` asks for a sign of life within so many microseconds
(sd_watchdog_enabled(3)).
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import socket
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

SLOWEST = 5.0
"""Seconds after which a status is told anew."""


class Service:
    """This process, as its service manager sees it."""

    def __init__(self) -> None:
        self._address = os.environ.get("NOTIFY_SOCKET", "")
        if self._address.startswith("@"):
            self._address = "\0" + self._address[1:]
        self._told = ""
        microseconds = os.environ.get("WATCHDOG_USEC", "")
        mine = os.environ.get("WATCHDOG_PID", str(os.getpid())) == str(os.getpid())
        self._watched = mine and microseconds.isdigit() and int(microseconds) > 0
        self._pause = min(SLOWEST, int(microseconds) / 2e6) if self._watched else SLOWEST

    def tell(self, *lines: str) -> bool:
        """Send lines such as ``READY=1``; return whether the manager takes them now, for it may be busy or gone."""
        if not self._address:
            return False
        with contextlib.suppress(OSError), socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as notify:
            notify.setblocking(False)
            notify.sendto("\n".join(lines).encode(), self._address)
            return True
        return False

    def status(self, text: str) -> None:
        """Send a status, if it differs from the last that was taken."""
        if text != self._told and self.tell(f"STATUS={text}"):
            self._told = text

    async def live(self, status: Callable[[], str]) -> None:
        """Send signs of life and the status until cancelled; the event loop that stands still gives none."""
        while self._address:
            self.status(status())
            if self._watched:
                self.tell("WATCHDOG=1")
            await asyncio.sleep(self._pause)
