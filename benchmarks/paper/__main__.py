"""The paper's experiment as a command, `python -m benchmarks.paper`, which `make table1` runs."""

from __future__ import annotations

from pathlib import Path  # noqa: TC003  (typer reads it)
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from unity_link.cli import main
from unity_link.cli.arguments import Json  # noqa: TC001  (typer reads it)
from unity_link.cli.output import is_live, out, print_line, print_note
from unity_link.errors import ArgumentError, UnityLinkError

if TYPE_CHECKING:
    from collections.abc import Iterable

    from benchmarks.paper import Results

_FAILED = 1


app = typer.Typer(pretty_exceptions_enable=False, context_settings={"help_option_names": ["-h", "--help"]})


@app.command()
def paper(
    *,
    output: Annotated[
        Path | None, typer.Option("--output", metavar="FOLDER", help="Also write page, data and plots there.")
    ] = None,
    gateway: Annotated[
        Literal["rtl", "model"] | None,
        typer.Option(help="Behind the chip: the gateware itself, or its model. By default rtl, with a C++ compiler."),
    ] = None,
    quick: Annotated[bool, typer.Option("--quick", help="Half a minute instead of minutes; not to be quoted.")] = False,
    json: Json = False,
) -> None:
    """Run the paper's experiment on the virtual FT232H, and show its figures with the paper's.

    Exits with 1 if a figure that is the same in every run misses its limit, unless the run was quick.
    """
    from benchmarks.paper import run_experiment
    from benchmarks.paper.tables import to_markdown

    if output is not None:
        # Create the folder before minutes of measuring.
        try:
            output.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise ArgumentError(f"--output {output} is no folder that can be made: {error.strerror}") from None
    results = run_experiment(gateway=gateway, quick=quick, tell=lambda what: print_note(f"{what} ..."))
    if json:
        print_line(results.to_json(indent=-1).decode())
    elif is_live():
        _show(results)
    else:
        print_line(to_markdown(results))
    if output is not None:
        _write(results, output)
    if not quick and not all(check.met or check.measured for check in results.checks):
        raise typer.Exit(_FAILED)


def _write(results: Results, folder: Path) -> None:
    from benchmarks.paper.report import write_report

    try:
        files, reason = write_report(results, folder)
    except OSError as error:
        raise UnityLinkError(f"--output {folder} can't be written: {error.strerror}") from None
    if reason:
        print_note(reason)
    print_note("written: " + ", ".join(str(file) for file in files))


def _show(results: Results) -> None:
    from benchmarks.paper import tables
    from benchmarks.paper.table_1 import COLUMNS, HEADS, TITLES

    for operation, title in TITLES.items():
        for mode in ("off", "always"):
            first, second = (HEADS[each] for each in COLUMNS[mode])
            head: tuple[str, ...] = ("level", "figure", "paper", first, "measured", second, "measured")
            suffix = ", send-immediate" if mode == "always" else ""
            _table(f"{title}{suffix}", 2, head, tables.table_1_rows(results, operation, mode))
    head = ("stack", "accesses", "mode", "requests", "answers", "requests, measured", "answers, measured", "of 64")
    _table("Long bursts, Mb/s", 3, head, tables.throughput_rows(results.throughputs))
    head = ("words", "bytes", "gateware", "8 MB/s", "burst", "sustained", "low, burst", "low", "full, burst", "full")
    _table("The limit of publishing, kHz", 0, head, tables.publish_rows(results))
    head = ("medium", "FIFOs", "line", "read", "write", "answers", "posts", "samples", "repeated")
    _table("Other media, modelled", 1, head, tables.media_rows(results.media))
    head = ("medium", "gateway", "form", "time", "reads", "posts", "block words", "samples")
    _table("Text and compact frames, thousands a second", 4, head, tables.form_rows(results.forms))
    head = ("the 18-DOF walker, in lines", "here", "paper", "its other solution")
    _table("Complexity", 1, head, tables.line_rows(results.lines))
    _table("Limits", 5, ("what", "known", "found", "wanted", "met"), tables.check_rows(results.checks))


def _table(title: str, names: int, head: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> None:
    """Print a table whose first columns are names and whose other columns are numbers."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    shown = Table(title=title, title_justify="left", box=SIMPLE_HEAD)
    for index, name in enumerate(head):
        shown.add_column(name, justify="left" if index < names else "right")
    for row in rows:
        shown.add_row(*row)
    out().print(shown)


if __name__ == "__main__":
    main(app, "python -m benchmarks.paper")
