"""Durations and counts of a host (docs/reliability.md has the table). Durations are in seconds.

Generated clients in other languages get the same values (`TABLE`). The module imports nothing, so that it can be read
without any package installed.
"""

# Retransmission

LONGEST_SILENCE = 5.0
"""Time in which no bytes of an answer arrive while requests are in flight (samples do not count): the link is lost."""
KEEP_ALIVE = 1.0
"""Time since the last answer, after which a host proves that the session is its own: before the next request, and
while groups are set up."""
FEWEST_SILENT_TRIES = 3
"""Fewest timeouts in silence before the link is lost, even if each takes longer than `LONGEST_SILENCE`."""
MOST_SIGNS = 12
"""Times that the window goes back to the same request for signs of loss; then only timeouts count."""
MOST_TRIES = 32
"""Timeouts of one request while answers or damaged frames arrive; the next one gives the request up."""
MOST_REFUSALS = 3
"""Errors 02 and 03 to one request, after which it is given up."""
FEWEST_IN_FLIGHT = 8
"""Lower limit of the requests in flight on a line that loses frames."""
DONE_FOR_ONE_MORE = 4
"""Requests done, posted writes included, that raise the send limit by one after a loss."""
FIRST_TIMEOUT = 0.25
"""Timeout before the first measured round trip."""
SHORTEST_TIMEOUT = 0.025
"""Shortest timeout, unless the medium has its own: a USB chip may delay an answer by its latency timer, 16 ms by
default, even if earlier round trips were shorter."""
QUICK_TIMEOUT = 0.003
"""Shortest timeout of media without such a delay: sockets, pseudo-terminals, gateways in this process."""
LONGEST_TIMEOUT = 2.0
"""Upper limit of the timeout, which doubles with each timeout."""
FENCE_DELAY = 0.001
"""Time after which an ``h`` is sent after posted writes, unless a request with an answer follows them first."""
MEASUREMENT_PAUSE = 0.001
"""Time between two measurements of the round trip, so that fast reads are not slowed by measuring each."""
ANSWER_PATIENCE = 0.1
"""On a half-duplex or shared line: longest delay of an answer beyond the time of its bytes. It is the shortest timeout
there, and the time that each request to a missing node takes from the other nodes."""
MOST_QUESTIONS = 8
"""Most unanswered session queries whose transmission numbers are stored."""
MOST_SENDINGS = 8
"""Most retransmissions of one request whose transmission numbers are stored; older ones are dropped."""
MOST_KEPT_WORDS = 256
"""Words of destructive reads that a gateway stores; those of a request begin at its ID modulo this number."""

# Handshake

FIRST_TRY = 0.1
"""Time until a request of the handshake is sent again; it doubles each time, up to `LONGEST_TRY`."""
LONGEST_TRY = 1.0
CHECKED_TRIES = 4
"""Number of times that a checked `Q` is sent before the answer to the plain `Q` is suspected to be damaged."""
DAMAGE_PAUSE = 0.002
"""Time from a line that is no answer to the next request."""
DAMAGE_PATIENCE = 16
"""Factor by which the wait for the next answer exceeds the time that a line without an answer took."""
SHORTEST_TRY = 0.002
"""Lower limit of the wait for an answer."""
DAMAGE_COST = 1 / 16
"""Fraction of a try that a request counts whose answer is damaged."""
TRIALS = 4
"""Number of times that a request of the test of the compact form is sent before the test fails."""
TRIAL_FACTOR = 5
"""Upper limit of the duration of that test, in durations of opening the session: the test has as many more bytes."""
SURE = 3
"""Number of times that an impossible answer arrives before it is believed: a damaged datagram can arrive twice."""
ECHO_PATIENCE = 0.5
"""Time in which only an echo arrives before it is reported as one: on a pair of wires an answer may follow an echo."""

# Floods

FLOOD_PATIENCE = 1.0
"""Time without an answer after which a flood of other lines ends the session."""
FEWEST_OF_A_FLOOD = 64
"""Fewest lines of a flood, beyond two for each request sent in that time, which may be damaged answers."""

TABLE: dict[str, float] = {name: value for name, value in globals().items() if isinstance(value, int | float)}
"""All constants of this module by name, for clients in other languages."""
