"""The durations and counts of a host's attempts: the constants of its side of protocol section 3, in one table.

`unity_link.protocol.window.window` uses them. Generated clients in other languages get the same values (`TABLE`). The
module imports nothing, so that it can be read without any package installed. Times are in seconds.
"""

LONGEST_SILENCE = 5.0
"""Without anything that can be about a request, and with one under way, after which the link is lost."""
KEEP_ALIVE = 1.0
"""Without a request, while groups are set up; then an ``h`` asks whether the gateway still hears, and was not reset."""
FEWEST_SILENT_TRIES = 3
"""Time outs in silence before the link is lost, however long one takes."""
MOST_SIGNS = 12
"""Number of times the window goes back for signs of loss of the same request; further ones count as time outs."""
MOST_TRIES = 32
"""Time outs of one request while something was heard; one more, and the request is given up."""
MOST_REFUSALS = 3
"""Errors 02 and 03 to one request until it is given up."""
FEWEST_IN_FLIGHT = 8
"""Requests in flight on a line that loses, at least."""
DONE_FOR_ONE_MORE = 4
"""Requests done, posted writes among them, that let one more be in flight, where a loss has made them few."""
FIRST_TIMEOUT = 0.25
"""The time out before the first round trip was measured."""
SHORTEST_TIMEOUT = 0.025
"""The shortest time out on media that do not say better: an answer may stay in a USB chip until its latency timer ends,
16 ms by default, whatever the last round trip was."""
QUICK_TIMEOUT = 0.003
"""The same for media that hand everything on at once: sockets, pseudo-terminals, gateways of this process."""
LONGEST_TIMEOUT = 2.0
FENCE_DELAY = 0.001
"""Posted writes are confirmed by an ``h`` after this time, if nothing else with an answer follows them."""
MEASUREMENT_PAUSE = 0.001
"""Between two measurements of the round trip: one a window is enough, and fast reads are left alone."""
ANSWER_PATIENCE = 0.1
"""On a half-duplex medium, and where nodes share a line: how long an answer can be on its way, beyond what its bytes
need. It is the shortest time out there, too, and what each try of a node that does not answer costs the others."""
FIRST_TRY = 0.1
"""Seconds until a question of the handshake is asked again, doubled each time."""
LONGEST_TRY = 1.0
CHECKED_TRIES = 4
"""Number of times the checked `Q` is asked before the plain answer is doubted."""
DAMAGE_PAUSE = 0.002
"""Seconds from a line that is no answer to the next question."""
DAMAGE_PATIENCE = 16
"""Factor by which the wait for the next answer exceeds the time that a line without an answer took."""
SHORTEST_TRY = 0.002
DAMAGE_COST = 1 / 16
"""Part of a try that a question counts that was answered by something else."""
TRIALS = 4
"""Number of times a request of the trial of the compact form is sent before the line is taken not to carry that."""
TRIAL_FACTOR = 5
"""Factor by which a trial takes longer than the opening of its session, at most: it has as many more bytes."""
SURE = 3
"""Number of times an impossible answer is heard before it is believed: a datagram that was damaged can come twice."""
ECHO_PATIENCE = 0.5
"""Seconds for which nothing but an echo is heard before it is believed: on a pair of wires an answer may follow."""
FLOOD_PATIENCE = 1.0
"""Seconds without an answer, in a flood of lines that are none; the next time out ends the session at the latest."""
FEWEST_OF_A_FLOOD = 64
"""Lines of a flood, at least, besides two for each request that is sent meanwhile: those may be its damaged answer."""
MOST_QUESTIONS = 8
"""Questions whose the session is, at most, whose answers are waited for."""
MOST_SENDINGS = 8
"""Sendings of a request behind the first of which the places are known: the last ones."""
MOST_KEPT_WORDS = 256
"""Words of destructive reads that a gateway keeps; those of a request begin at its ID modulo this."""

TABLE: dict[str, float] = {name: value for name, value in globals().items() if isinstance(value, int | float)}
"""All of them by name, for clients in other languages."""
