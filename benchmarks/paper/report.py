"""The experiment as files: page, data and pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING

from benchmarks.paper.plots import AVERAGES, BURSTS, PUBLISHING, draw
from benchmarks.paper.tables import to_markdown
from unity_link.errors import UnsupportedError

if TYPE_CHECKING:
    from pathlib import Path

    from benchmarks.paper.results import Results

PAGE, DATA = "TABLE1.md", "table1.json"
_PICTURES = (
    ("The paper's figure 3 again: average latencies of reads and writes", AVERAGES),
    ("The paper's figure 4 again: the limit of publishing, by the length", PUBLISHING),
    ("Bursts of reads, by their length", BURSTS),
)


def write_report(results: Results, folder: Path) -> tuple[list[Path], str]:
    """Write all files into a folder, which is created if necessary; pictures only if matplotlib is installed.

    Returns:
        The files, and the reason if there are no pictures.

    Raises:
        OSError: if the folder cannot be written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    files, reason = [], ""
    try:
        files += draw(results, folder)
    except UnsupportedError as error:
        reason = str(error)
    page, data = folder / PAGE, folder / DATA
    page.write_text(to_markdown(results, _PICTURES if files else ()))
    data.write_bytes(results.to_json() + b"\n")
    return [page, data, *files], reason
