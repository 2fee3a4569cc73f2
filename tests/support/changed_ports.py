"""Settings of a serial port that another program changes while a link uses the port."""

from __future__ import annotations

import subprocess

from unity_link.transport import parse_url


def make_sane(url: str) -> None:
    """Give the terminal of a URL the settings of a console: it echoes, waits for whole lines, translates line ends."""
    subprocess.run(["stty", "-F", parse_url(url).path, "sane"], check=True)
