"""Notifications to a service manager by a command that keeps running."""

from __future__ import annotations

import contextlib
import socket
from typing import TYPE_CHECKING

from unity_link.cli.service import Service

if TYPE_CHECKING:
    from pathlib import Path

    import pytest


def test_status_that_a_busy_manager_missed_is_sent_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NOTIFY_SOCKET", str(tmp_path / "notify"))
    service = Service()
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager:
        manager.bind(str(tmp_path / "notify"))
        manager.setblocking(False)
        while service.tell("WATCHDOG=1"):
            pass
        service.status("1 clients")
        with contextlib.suppress(BlockingIOError):
            while manager.recv(4096) == b"WATCHDOG=1":
                pass
        service.status("1 clients")
        assert manager.recv(4096) == b"STATUS=1 clients"
        service.status("1 clients")
        service.tell("STOPPING=1")
        assert manager.recv(4096) == b"STOPPING=1"


def test_no_notification_is_sent_without_a_service_manager(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NOTIFY_SOCKET", raising=False)
    assert not Service().tell("READY=1")
