"""Recordings: what a robot published, in an MCAP file (https://mcap.dev) that Foxglove and PlotJuggler open.

- `unity_link.bridges.messages`: what a sample is in the file: JSON with a schema, so that others read it without this
  package
- `files`: writing; a file is whole to within a second at every instant, whatever ends the program
- `chunks`: what of MCAP is written here, and why
- `recorder`: from a robot into a file, over interruptions
- `reader`: back, of a file that was finished, cut or damaged
- `replay`: a gateway that answers as the recorded one did
- `tables`: to Parquet and CSV; `Recording[...]` is a table in memory

::

    async with unity_link.connect("sim:scara") as link:
        async with Recorder(Scara(link), "run.mcap"):
            await asyncio.sleep(10)
    Recording("run.mcap")["state"].to_pandas()

A file has all that it takes to understand it: two attachments, ``interface.json`` (the checked spec) and
``gateway.json`` (`GatewayInfo`), and a channel for each group. Each message has the values of its signals, and the
words that they were made of, so that nothing is lost where JSON has no number for a value.
"""

from unity_link.bridges.recording.files import FORMATS, RecordingError
from unity_link.bridges.recording.reader import Recording
from unity_link.bridges.recording.recorder import Recorder
from unity_link.bridges.recording.replay import replay
from unity_link.bridges.recording.tables import export

__all__ = ["FORMATS", "Recorder", "Recording", "RecordingError", "export", "replay"]
