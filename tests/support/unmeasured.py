"""Processes without coverage, which would take time, and write files into folders that refuse them."""

from __future__ import annotations

import os


def unmeasured_environment() -> dict[str, str]:
    """Return the environment of this process without the variables that start coverage in child processes."""
    return {name: value for name, value in os.environ.items() if not name.startswith("COV")}
