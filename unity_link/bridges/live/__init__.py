"""Live pictures: a page on this machine on which a robot's signals scroll by, and by which they can be written.

    gateway -> Carrier (a thread tabulates) -> Outbox of each Viewer -> WebSocket -> page

- `page`: the page, its server, and who looks at it
- `description`: what the page is told of the robot; `words` makes a robot of bare addresses
- `outbox`: samples on their way to one browser, of bounded size
- `viewer`: one browser
- `writing`: values that come back, where that is allowed at all
- `server`: the web server under the page, bounded against any client
- `doorkeeper`: which requests are answered
- `round_trips`: how quickly the gateway answers
- `foxglove`: the same samples for the Foxglove app, by its own WebSocket
- `assets`: the page itself, and uPlot, which draws the curves (its licence is beside it); nothing is fetched elsewhere

Samples go to the browser in binary: a head (`outbox.HEAD`), then for each stream its number, how many samples follow,
and a table of doubles: instants, samples lost before each, and a row for each signal.
All else is JSON: ``about`` once, ``status`` five times a second, answers to writes.
"""

from unity_link.bridges.live.page import LivePage, bind
from unity_link.bridges.live.words import robot_of_words

__all__ = ["LivePage", "bind", "robot_of_words"]
