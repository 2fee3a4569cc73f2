"""`unity-link explain` and `retrace`: print the recorded traffic of a connection, or play it into the gateware."""

from __future__ import annotations

import datetime as dt
import math
import statistics
import sys
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from unity_link.cli.arguments import Json, Overwrite
from unity_link.cli.output import may_overwrite, print_error, print_json, print_line, print_note
from unity_link.errors import ArgumentError
from unity_link.quoting import terminal

if TYPE_CHECKING:
    from unity_link.capture.transcript import TimedFrame, Transcript
    from unity_link.virtual.rtl.retrace import Report

SnoopPath = Annotated[
    Path,
    typer.Argument(metavar="FILE", help="A file that ?snoop=FILE or UNITY_LINK_SNOOP wrote.", show_default=False),
]
From = Annotated[
    float, typer.Option("--from", metavar="T", min=0.0, help="Seconds from the first record on, as explain shows them.")
]
To = Annotated[float | None, typer.Option("--to", metavar="T", min=0.0, help="End, in the same seconds.")]
FAILED = 1


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(explain)
    app.command()(retrace)


def explain(file: SnoopPath, *, begin: From = 0.0, end: To = None, json: Json = False) -> None:
    """Print the frames of a recorded connection, each with its time, direction and meaning.

    Times are seconds since the first record. > is sent by the host, < by the gateway. A summary comes last.
    """
    _check_times(begin, end)
    if not _SnoopPrinter(json=json, begin=begin, end=math.inf if end is None else end).read(file):
        raise typer.Exit(FAILED)


def retrace(
    file: SnoopPath,
    *,
    rtl: Annotated[  # noqa: ARG001  (the default and only mode)
        bool, typer.Option("--rtl", help="Play into the compiled gateware; this is the default.")
    ] = True,
    vcd: Annotated[
        Path | None, typer.Option("--vcd", metavar="OUT", help="Write its inner signals as a waveform.")
    ] = None,
    begin: From = 0.0,
    end: To = None,
    connection: Annotated[
        int | None, typer.Option(metavar="N", min=0, help="In a file of several gateways: the one to play.")
    ] = None,
    overwrite: Overwrite = False,
) -> None:
    """Play the host's bytes of a snoop into the gateware, and compare its answers and samples.

    Reads on the bus return the recorded values. --from and --to select the part that the waveform shows, in the times
    of explain; bytes after --to are not played. GTKWave and Surfer open the waveform.
    """
    _check_times(begin, end)
    from unity_link.transport.snoop import read
    from unity_link.virtual.rtl.retrace import Retrace, differing, fitting
    from unity_link.virtual.rtl.snooped import read_snooped

    damage: list[str] = []
    snooped = read_snooped(read(file, damage.append), connection, end)
    build = fitting(snooped)
    if fields := differing(build.info, snooped.info):
        print_note(f"played into {build.name!r}, which differs from the recorded gateway in {', '.join(fields)}")
    gateway = Retrace(snooped, build)
    if vcd is None:
        report = gateway.play()
    else:
        report = gateway.play_into(vcd, begin, math.inf if end is None else end, overwrite=may_overwrite(overwrite))
    print_line(_comparison(report, snooped.astray))
    for text in damage:
        print_error(text)
    if report.first is not None:
        print_error(_difference(report))
    if damage or report.first is not None:
        raise typer.Exit(FAILED)


def _comparison(report: Report, astray: int) -> str:
    text = (
        f"{report.seconds:.6f} s played: {report.answers:,} answers and {report.samples:,} samples compared, "
        f"{report.differences:,} of them differ"
    )
    if report.unknown:
        text += f"; {report.unknown:,} answers were not recorded"
    if report.triggered:
        text += f"; {report.triggered:,} samples by triggers are left out"
    if astray:
        text += f"; {astray:,} frames of the gateway answer nothing known"
    return text


def _difference(report: Report) -> str:
    from unity_link.transport.tap import as_text

    first = report.first
    assert first is not None
    recorded, retraced = (as_text(frame) or "nothing" for frame in (first.recorded, first.retraced))
    what = f"to {as_text(first.sent.lstrip())}" if first.sent else "a sample"
    return (
        f"first difference at {first.time:.6f} s, {what}: {recorded} was recorded, {retraced} comes from the gateware"
    )


def _check_times(begin: float, end: float | None) -> None:
    """Check the start and the end of a period.

    Raises:
        ArgumentError: if one is not a finite number, or the end is not after the start.
    """
    for name, value in (("--from", begin), ("--to", end)):
        if value is not None and not math.isfinite(value):
            raise ArgumentError(f"{name} {value:g}: a number of seconds was expected")
    if end is not None and end <= begin:
        raise ArgumentError(f"--to {end:g} is not after --from {begin:g}")


class _SnoopPrinter:
    """Prints the events of a snoop file, and collects the numbers for the summary."""

    def __init__(self, *, json: bool, begin: float, end: float) -> None:
        self._json = json
        self._begin, self._end = begin, end
        self._origin: int | None = None
        self._kinds: Counter[str] = Counter()
        self._again = 0
        self._round_trips: list[float] = []
        self._transcripts: dict[int, Transcript] = {}
        self._silent: dict[int, str] = {}
        """Names of connections on which no frame has passed yet."""
        self._sound = True
        self._trouble = ""

    def read(self, path: Path) -> bool:
        """Print a file; return whether it is undamaged."""
        from unity_link.capture.transcript import Transcript
        from unity_link.transport.snoop import Connected, Disconnected, Passed, read

        time = 0.0
        for event in read(path, self._damage):
            match event:
                case Connected(connection, name):
                    self._transcripts[connection] = Transcript()
                    self._silent[connection] = name
                case Passed(connection, time_ns, sent, data):
                    time = self._since(time_ns)
                    self._print_beginning(time, connection)
                    for timed in self._transcripts[connection].take(data, time, sent=sent):
                        self._print(connection, timed)
                case Disconnected(connection, time_ns, why):
                    time = self._since(time_ns)
                    self._print_beginning(time, connection)
                    for timed in self._transcripts[connection].end(time):
                        self._print(connection, timed)
                    self._print_life(time, connection, "ended", why)
        for connection in list(self._silent):
            self._print_beginning(time, connection)
        self._print_summary()
        return self._sound

    def _since(self, time_ns: int) -> float:
        if self._origin is None:
            self._origin = time_ns
            if not self._json:
                began = dt.datetime.fromtimestamp(time_ns / 1e9, dt.UTC).astimezone()
                print_note(f"0.000000 is {began.isoformat(timespec='microseconds')}")
        return (time_ns - self._origin) / 1e9

    def _print_beginning(self, time: float, connection: int) -> None:
        name = self._silent.pop(connection, None)
        if name is not None:
            self._print_life(time, connection, "connected", name)

    def _damage(self, text: str) -> None:
        self._sound = False
        self._trouble = text

    def _print_life(self, time: float, connection: int, what: str, words: str) -> None:
        if not self._begin <= time <= self._end:
            return
        if self._json:
            print_json({"time": time, "connection": connection, "kind": what, "words": words})
        else:
            _write(f"{time:12.6f} {connection} -  {what}: {words}")

    def _print(self, connection: int, timed: TimedFrame) -> None:
        from unity_link.transport.tap import as_text, in_words

        if not self._begin <= timed.time <= self._end:
            return
        meaning = timed.meaning
        self._kinds[meaning.kind] += 1
        self._again += timed.again
        if timed.round_trip is not None:
            self._round_trips.append(timed.round_trip)
        if not self._json:
            arrow = ">" if timed.sent else "<"
            _write(f"{timed.time:12.6f} {connection} {arrow}  {as_text(timed.frame)}  {in_words(timed)}")
            return
        fields = {
            "time": timed.time,
            "connection": connection,
            "direction": "sent" if timed.sent else "received",
            "frame": timed.frame.decode("latin-1"),
            "kind": meaning.kind,
            "again": timed.again,
            "command": meaning.command or None,
            "id": meaning.id,
            "group": meaning.group,
            "error": meaning.error,
            "round_trip": timed.round_trip,
            "words": meaning.words,
        }
        print_json(fields)

    def _print_summary(self) -> None:
        if self._json:
            print_json({"kind": "summary", **self._summary()})
        else:
            sys.stdout.flush()
            print_note(_in_a_line(self._summary()))
        if not self._sound:
            print_error(self._trouble)

    def _summary(self) -> dict[str, Any]:
        from unity_link.capture.decoder import FrameKind

        times = sorted(self._round_trips)
        found = {f"{kind}s" if kind in _COUNTED else str(kind): self._kinds[kind] for kind in FrameKind}
        return {
            "frames": self._kinds.total(),
            **found,
            "again": self._again,
            "round_trips": len(times),
            "median_round_trip": statistics.median(times) if times else None,
            "round_trip_of_99_percent": times[math.ceil(0.99 * len(times)) - 1] if times else None,
            "longest_round_trip": times[-1] if times else None,
        }


_COUNTED = frozenset({"request", "answer", "error", "sample"})


def _in_a_line(summary: dict[str, Any]) -> str:
    text = (
        f"{summary['frames']:,} frames: {summary['requests']:,} requests, {summary['again']:,} of them sent again; "
        f"{summary['answers']:,} answers, {summary['errors']:,} errors, {summary['samples']:,} samples; "
        f"{summary['damaged']:,} damaged, {summary['unknown']:,} not understood"
    )
    if summary["round_trips"]:
        median, most, longest = (
            f"{1e6 * summary[name]:,.0f} µs"
            for name in ("median_round_trip", "round_trip_of_99_percent", "longest_round_trip")
        )
        text += f"; round trip: median {median}, 99 % within {most}, longest {longest}"
    return text


def _write(line: str) -> None:
    """Print a line without flushing, because a file may have a million lines."""
    sys.stdout.write(terminal(line) + "\n")
