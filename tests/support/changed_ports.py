"""Settings that another program gives to a serial port while a link uses it."""

from __future__ import annotations

import subprocess

from unity_link.transport import parse_url


def make_sane(url: str) -> None:
    """Set the terminal of a URL to echo, wait for lines and translate their ends."""
    subprocess.run(["stty", "-F", parse_url(url).path, "sane"], check=True)
