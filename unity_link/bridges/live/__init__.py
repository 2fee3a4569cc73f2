"""The live page: a web page on this machine with moving plots of a robot's signals, which can also write them.

    gateway -> Carrier (a thread makes tables) -> Outbox of each Viewer -> WebSocket -> page

- `page`: the page, its server and its viewers
- `description`: the description of the robot for the page; `words` makes a robot of bare addresses
- `outbox`: samples on their way to one browser, of limited size
- `viewer`: one browser
- `writing`: values that the page writes, if that is allowed
- `server`: the web server of the page, with limits for clients
- `doorkeeper`: access control: which requests are answered
- `round_trips`: the response time of the gateway
- `foxglove`: the same samples for the Foxglove app, on a WebSocket of its own
- `assets`: the files of the page, and uPlot, which draws the curves (its licence is beside it); the page loads no other
  files

Samples are sent to the browser in binary: a header (`outbox.HEAD`), then for each stream its number, the number of its
samples, and a table of doubles: instants, samples lost before each, and a row for each signal.
All other messages are JSON: ``about`` once, ``status`` five times a second, and answers to writes.
"""

from unity_link.bridges.live.page import LivePage, bind
from unity_link.bridges.live.words import robot_of_words

__all__ = ["LivePage", "bind", "robot_of_words"]
