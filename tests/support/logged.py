"""Errors that no call can raise, which the library logs instead."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pytest


def told(caplog: pytest.LogCaptureFixture) -> list[tuple[str, BaseException | None]]:
    """Return the messages and exceptions of all log records with a traceback."""
    return [(record.message, record.exc_info[1]) for record in caplog.records if record.exc_info]
