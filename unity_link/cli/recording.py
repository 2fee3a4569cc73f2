"""`unity-link record`, `replay`, `export RECORDING`: recordings of the samples that a robot publishes."""

from __future__ import annotations

import asyncio
import sys
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from unity_link.cli.arguments import DEFAULT_TIMEOUT, Json, Overwrite, Timeout, Url, check_poll
from unity_link.cli.output import console_on, may_overwrite, print_json, print_note, print_result
from unity_link.cli.running import run
from unity_link.cli.spec import Given, Name, SpecOrBoard, compile_or_exit, spec_behind
from unity_link.errors import ArgumentError
from unity_link.protocol.wire.numbers import MOST_SECONDS

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from unity_link.bridges.recording import Recorder
    from unity_link.spec import Spec

RecordingPath = Annotated[
    Path, typer.Argument(metavar="RECORDING", help="A file of unity-link record.", show_default=False)
]
_PANEL = "Where it is served (one of them)"
REFRESHES_PER_SECOND = 4


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file; `unity_link.cli.export` adds `export`."""
    app.command()(record)
    app.command()(replay)


def record(
    url: Url,
    spec: SpecOrBoard = None,
    *,
    output: Annotated[
        Path,
        typer.Option("--output", "-o", metavar="FILE", help="The recording, such as run.mcap.", show_default=False),
    ],
    poll: Annotated[
        float | None,
        typer.Option(metavar="HZ", help="Also record signals that no group publishes, by reading them at this rate."),
    ] = None,
    duration: Annotated[
        float | None,
        typer.Option("--duration", metavar="SECONDS", min=0.0, max=MOST_SECONDS, help="End after so long."),
    ] = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace a file of that name.")] = False,
    interface: Name = None,
    given: Given = None,
    json: Json = False,
    timeout: Timeout = DEFAULT_TIMEOUT,
) -> None:
    """Record all signals that a robot publishes; Ctrl-C ends it.

    The recording is an MCAP file, which Foxglove and PlotJuggler open. Even if the program is killed, the file has all
    samples up to a second before. If the gateway disconnects, the command waits until it is back.
    """
    from unity_link.bridges.recording.files import check_name

    check_poll(poll)
    check_name(output)
    run(
        _record(
            url,
            compile_or_exit(spec_behind(url, spec), interface=interface, given=given),
            interface,
            output,
            poll,
            duration,
            overwrite=overwrite,
            json=json,
            timeout=timeout,
        )
    )


async def _record(
    url: str,
    spec: Spec,
    interface: str | None,
    output: Path,
    poll: float | None,
    duration: float | None,
    *,
    overwrite: bool,
    json: bool,
    timeout: float,
) -> None:
    from unity_link.bridges.recording import Recorder, RecordingError
    from unity_link.data import load
    from unity_link.data.describing import robot_behind
    from unity_link.link.connecting import connect

    robot_type = load(spec, interface)
    async with connect(url, timeout=timeout, reconnect=True) as link:
        robot = await robot_behind(link, robot_type)
        recorder = Recorder(robot, output, poll_hz=poll, overwrite=overwrite, report=print_note)
        began = time.monotonic()
        try:
            async with asyncio.timeout(duration):
                with _shown(lambda: _state(recorder, began)) as refresh:
                    showing = asyncio.create_task(refresh())
                    try:
                        await recorder.run()
                    finally:
                        showing.cancel()
        except TimeoutError:
            if duration is None:
                raise
            if not recorder.samples:
                raise RecordingError(f"not one sample has come in {duration:g} s: {output} was not written") from None
        finally:
            print_note(f"{output if recorder.samples else 'nothing written'}: {_state(recorder, began)}")
            if json:
                print_json(
                    {
                        "file": str(output) if recorder.samples else None,
                        "samples": recorder.samples,
                        "lost": recorder.lost,
                        "bytes": recorder.size if recorder.samples else 0,
                        "interruptions": recorder.interruptions,
                        "away_s": recorder.away,
                    }
                )


def _state(recorder: Recorder, began: float) -> str:
    seconds = max(time.monotonic() - began, 1e-9)
    rate = recorder.samples / seconds
    away, times = "", recorder.interruptions
    if times:
        away = f"; the gateway was away {times} time{'s' * (times > 1)}, for {recorder.away:.1f} s in all"
    return (
        f"{recorder.samples:,} samples in {seconds:.1f} s ({rate:,.0f} Hz), {recorder.lost:,} lost, "
        f"{_bytes(recorder.size)}{away}"
    )


def _bytes(size: int) -> str:
    return f"{size / 1e6:,.1f} MB" if size >= 1e6 else f"{size / 1e3:,.1f} kB"


@contextmanager
def _shown(text: Callable[[], str]) -> Iterator[Callable[[], Any]]:
    """Show a status line if stderr is a terminal; yield a coroutine function that refreshes it until cancelled."""
    console = console_on(sys.stderr)
    status = console.status(text()) if console.is_terminal else None

    async def refresh() -> None:
        while status is not None:
            status.update(text())
            await asyncio.sleep(1 / REFRESHES_PER_SECOND)

    if status is None:
        yield refresh
    else:
        with status:
            yield refresh


def replay(
    recording: RecordingPath,
    *,
    pty: Annotated[
        bool, typer.Option("--pty", help="A pseudo-terminal: looks like a serial port.", rich_help_panel=_PANEL)
    ] = False,
    tcp: Annotated[
        int | None,
        typer.Option(metavar="PORT", min=0, max=65535, help="A TCP port; 0 for any free one.", rich_help_panel=_PANEL),
    ] = None,
    unix: Annotated[
        Path | None, typer.Option(metavar="PATH", help="A Unix socket, removed at the end.", rich_help_panel=_PANEL)
    ] = None,
    speed: Annotated[
        float, typer.Option(metavar="FACTOR", help="Speed of playback; 1 is that of the recording.")
    ] = 1.0,
    loop: Annotated[bool, typer.Option("--loop", help="Begin again at the end.")] = False,
    json: Json = False,
) -> None:
    """Serve a gateway that answers as the recorded one did.

    Prints one line, its URL, when it is ready. Playback begins with the first access of a program; after the end of the
    recording all signals keep their last values. A write to a recorded signal is refused. Ctrl-C ends it.
    """
    if sum((pty, tcp is not None, unix is not None)) != 1:
        raise ArgumentError("one of --pty, --tcp and --unix was expected")
    run(_replay(recording, tcp, unix, speed, loop=loop, json=json))


async def _replay(path: Path, tcp: int | None, unix: Path | None, speed: float, *, loop: bool, json: bool) -> None:
    from unity_link.bridges.recording import Recording
    from unity_link.bridges.recording import replay as play
    from unity_link.virtual.serving import serve_pty, serve_tcp, serve_unix

    recording = Recording(path)
    gateway, player = play(recording, speed=speed, loop=loop)
    if tcp is not None:
        serving = serve_tcp(gateway, tcp)
    elif unix is not None:
        serving = serve_unix(gateway, unix)
    else:
        serving = serve_pty(gateway)

    def state() -> str:
        return f"{path}: {player.position:.1f} s played" + (", ended" if player.ended else "")

    async with serving as url:
        print_result("url", url, json=json)
        with _shown(state) as refresh:
            showing = asyncio.create_task(refresh())
            try:
                await asyncio.get_running_loop().create_future()
            finally:
                showing.cancel()


def export_recording(
    recording: RecordingPath,
    *,
    parquet: Annotated[bool, typer.Option("--parquet", help="Parquet, with units as metadata.")] = False,
    csv: Annotated[bool, typer.Option("--csv", help="CSV, for spreadsheets.")] = False,
    output: Annotated[
        Path, typer.Option("--output", "-o", metavar="DIR", help="Where to write; created if it does not exist.")
    ] = Path(),
    overwrite: Overwrite = False,
    json: Json = False,
) -> None:
    """Convert a recording to tables: a file for each group, a row for each sample, a column for each signal."""
    if parquet == csv:
        raise ArgumentError("one of --parquet and --csv was expected")
    from rich.markup import escape
    from rich.progress import Progress

    from unity_link.bridges.recording import Recording, export

    read = Recording(recording)
    console = console_on(sys.stderr)
    with Progress(console=console, transient=True, disable=not console.is_terminal) as bar:
        task = bar.add_task(escape(recording.name), total=read.size)
        paths = export(
            read,
            "parquet" if parquet else "csv",
            output,
            lambda done: bar.update(task, completed=done),
            overwrite=may_overwrite(overwrite),
        )
    if read.was_damaged:
        print_note(f"{recording} is damaged: its undamaged part was exported")
    elif read.was_cut:
        print_note(f"{recording} was not finished: the part that was written was exported")
    for path in paths:
        print_result("file", path, json=json)
