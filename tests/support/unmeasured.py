"""Processes of which coverage measures nothing: it would write files where none can be written, and take time."""

from __future__ import annotations

import os


def unmeasured_environment() -> dict[str, str]:
    """Return the environment of this process without what has coverage measure another."""
    return {name: value for name, value in os.environ.items() if not name.startswith("COV")}
