"""Recordings: samples of a robot in an MCAP file (https://mcap.dev), which Foxglove and PlotJuggler can open.

- `unity_link.bridges.messages`: the form of a sample in the file: JSON with a schema, readable without this package
- `files`: writing; if the program ends in any way, the file lacks at most the last second
- `chunks`: the records of MCAP that are written here instead of by the library `mcap`, and why
- `recorder`: records a robot into a file, and continues after interruptions
- `reader`: reads a file that is finished, cut or damaged
- `replay`: a gateway that answers as the recorded one did
- `tables`: export to Parquet and CSV; `Recording[...]` is a table in memory

::

    async with unity_link.connect("sim:scara") as link:
        async with Recorder(Scara(link), "run.mcap"):
            await asyncio.sleep(10)
    Recording("run.mcap")["state"].to_pandas()

A file contains all that is needed to interpret it: two attachments, ``interface.json`` (the checked spec) and
``gateway.json`` (`GatewayInfo`), and a channel for each group. Each message has the values of its signals, and the
words that they were decoded from, so that values that JSON cannot represent are not lost.
"""

from unity_link.bridges.recording.files import FORMATS, RecordingError
from unity_link.bridges.recording.reader import Recording
from unity_link.bridges.recording.recorder import Recorder
from unity_link.bridges.recording.replay import replay
from unity_link.bridges.recording.tables import export

__all__ = ["FORMATS", "Recorder", "Recording", "RecordingError", "export", "replay"]
