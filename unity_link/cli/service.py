"""Notifies the service manager that started a command, by the protocol sd_notify of systemd.

Notifications are datagrams of ``NAME=value`` lines to the socket in `NOTIFY_SOCKET` (sd_notify(3)); without that
variable no notification is sent. `WATCHDOG_USEC` is the longest time between two keep-alive notifications, in µs
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
"""Longest time in seconds between two status notifications."""


class Service:
    """The connection of this process to its service manager."""

    def __init__(self) -> None:
        self._address = os.environ.get("NOTIFY_SOCKET", "")
        if self._address.startswith("@"):
            self._address = "\0" + self._address[1:]
        self._last_status = ""
        microseconds = os.environ.get("WATCHDOG_USEC", "")
        mine = os.environ.get("WATCHDOG_PID", str(os.getpid())) == str(os.getpid())
        self._watched = mine and microseconds.isdigit() and int(microseconds) > 0
        self._pause = min(SLOWEST, int(microseconds) / 2e6) if self._watched else SLOWEST

    def tell(self, *lines: str) -> bool:
        """Send lines such as ``READY=1``; return whether they were sent: the manager may be busy or absent."""
        if not self._address:
            return False
        with contextlib.suppress(OSError), socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as notify:
            notify.setblocking(False)
            notify.sendto("\n".join(lines).encode(), self._address)
            return True
        return False

    def status(self, text: str) -> None:
        """Send a status if it differs from the last one that was sent."""
        if text != self._last_status and self.tell(f"STATUS={text}"):
            self._last_status = text

    async def live(self, status: Callable[[], str]) -> None:
        """Send keep-alive notifications and the status until cancelled; a blocked event loop sends none."""
        while self._address:
            self.status(status())
            if self._watched:
                self.tell("WATCHDOG=1")
            await asyncio.sleep(self._pause)
