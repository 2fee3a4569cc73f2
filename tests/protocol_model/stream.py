"""A model of requests with IDs over a line that keeps the order: every interleaving of host, line and gateway.

Four IDs and a window of two are enough to show every fault of a larger sequence space: half of the IDs may be in
flight, and IDs repeat after a few requests. Besides its ID each request has a number that no rule may read; the model
uses it to find requests that were executed twice, out of order or never, and answers matched to the wrong request.

These letters represent requests in the host's window and on the line:

    w  is answered            e  is answered, and ends in an error
    s  is posted              p  is posted, and ends in an error
    q  reads destructively    h  has no effect: the fence, and the replacement of a request that was given up

One host opens one session after another; `sessions` models two hosts, failed posted writes and stored words.
"""

from collections.abc import Iterator
from typing import NamedTuple, TypeAlias

from protocol_model.exploration import Exploration, Fault, explore

RING = 4
WINDOW = RING // 2
POSTED = "sp"
FAILING = "ep"
DONE = "-"

Frame: TypeAlias = tuple[str, int, int, int]
"""Kind, ID, number of the request, session in the CRC. The gateway sends k, n, and the kinds of answers below."""
ANSWER, ERROR, NO_SESSION = "answer", "error", "no session"
DAMAGED: Frame = ("damaged", 0, -1, 0)
CRC_ERROR: Frame = ("X01", 0, -1, 0)


class Rules(NamedTuple):
    """Rules of a version of the protocol, and limits of the exploration."""

    needs_session: bool = True
    """Without a session no request is executed."""
    names_session: bool = True
    """The CRC of each frame depends on the session's number; frames of other sessions are ignored."""
    kinds: str = "w"
    requests: int = 5
    in_line: int = 3
    """Largest number of frames in each direction."""
    resets: int = 1
    """Largest number of resets of the gateway."""
    restarts: int = 0
    """Largest number of times that the host opens a session again while frames are on the line."""
    damages: bool = False
    """Frames may also arrive damaged: the gateway answers a damaged request, and a damaged answer is lost."""
    cancels: bool = False
    """Requests may be given up."""
    leaves_room: bool = True
    """A posted request is sent only if the window has space for the fence after it."""
    minds_repetitions: bool = True
    """After a reset, requests that were sent more than once are not reported as not executed."""
    minds_order: bool = True
    """Nor are requests that were first sent before the last retransmission of the refused request."""


class Host(NamedTuple):
    """The host; requests from `first` on are in the window."""

    session: int
    """Number of its session; each `K` has another one."""
    ready: bool
    """The session was confirmed."""
    offset: int
    """ID minus number, in this session."""
    first: int
    window: str
    """A letter for each request in flight; `DONE` for requests with a reported outcome."""
    confirmed: int
    """Number of requests in the window that were executed, as far as the host knows."""
    again: tuple[int, ...]
    """For each request in the window, the number of requests at its last retransmission; 0 if it was sent once."""


class Gateway(NamedTuple):
    """The gateway; `executed` and `never` have a bit for each number and are used for checks only."""

    session: int
    """Number of the open session, 0 for none."""
    expected: int
    gap_told: bool
    executed: int
    never: int
    """Requests reported as not executed."""


class State(NamedTuple):
    """State of host, gateway and line."""

    host: Host
    gateway: Gateway
    out: tuple[Frame, ...]
    back: tuple[Frame, ...]
    resets: int
    restarts: int


def explored(rules: Rules, sought: str = "") -> Exploration:
    """Explore the rules; if `sought` is given, pass over all other faults."""
    start = State(Host(1, False, 0, 0, "", 0, ()), Gateway(0, 0, False, 0, 0), (), (), 0, 0)
    return explore(start, lambda state: _moves(rules, state), lambda state: _all_reported(rules, state), sought=sought)


def _all_reported(rules: Rules, state: State) -> bool:
    return state.host.first >= rules.requests


def _moves(rules: Rules, state: State) -> Iterator[tuple[str, State | Fault]]:
    yield from _host_moves(rules, state)
    yield from _line_moves(rules, state)
    if state.resets < rules.resets:
        after_reset = state.gateway._replace(session=0, expected=0, gap_told=False)
        yield "the gateway is reset", state._replace(gateway=after_reset, resets=state.resets + 1)


# The line


def _line_moves(rules: Rules, state: State) -> Iterator[tuple[str, State | Fault]]:
    if state.out:
        frame, behind = state.out[0], state.out[1:]
        lost = state._replace(out=behind)
        yield f"lost on the way out: {_show(frame)}", lost
        if rules.damages and frame != DAMAGED:
            yield f"damaged: {_show(frame)}", state._replace(out=(DAMAGED, *behind))
        if len(state.back) < rules.in_line:
            gateway, answer = _take(rules, state.gateway, frame)
            if isinstance(gateway, Fault):
                yield f"the gateway takes {_show(frame)}", gateway
            elif answer is None:
                yield f"the gateway takes {_show(frame)}", lost._replace(gateway=gateway)
            else:
                after = lost._replace(gateway=gateway, back=(*state.back, answer))
                yield f"the gateway takes {_show(frame)} and answers {_show(answer)}", after
    if state.back:
        heard, rest = state.back[0], state._replace(back=state.back[1:])
        yield f"lost on the way back: {_show(heard)}", rest
        yield f"the host hears {_show(heard)}", _hear(rules, rest, heard)


def _show(frame: Frame) -> str:
    kind, ident, number, _ = frame
    if frame in (DAMAGED, CRC_ERROR):
        return kind
    return f"{kind} {ident}" if number < 0 else f"{kind} {ident} of request {number}"


# The gateway


def _take(rules: Rules, gateway: Gateway, frame: Frame) -> tuple[Gateway | Fault, Frame | None]:
    """Return the gateway after a frame, and its answer."""
    kind, ident, number, session = frame
    if frame == DAMAGED:
        return gateway, CRC_ERROR
    if kind == "K":
        return gateway._replace(session=session, expected=ident, gap_told=False), ("k", ident, -1, session)
    if rules.needs_session and not gateway.session:
        return gateway, (NO_SESSION, ident, number, session)
    if rules.names_session and session != gateway.session:
        return gateway, CRC_ERROR if rules.damages else None
    return _in_sequence(gateway, frame)


def _in_sequence(gateway: Gateway, frame: Frame) -> tuple[Gateway | Fault, Frame | None]:
    """Return the gateway after a request of the session, and its answer."""
    ident = frame[1]
    ahead = (ident - gateway.expected) % RING
    if ahead == 0:
        return _execute(gateway, frame)
    if ahead >= RING // 2:
        return gateway, _repeat(frame)
    if gateway.gap_told:
        return gateway, None
    return gateway._replace(gap_told=True), ("n", gateway.expected, -1, gateway.session)


def _execute(gateway: Gateway, frame: Frame) -> tuple[Gateway | Fault, Frame | None]:
    kind, ident, number, session = frame
    executed = gateway.executed
    if kind != "h":
        if executed >> number:
            how = "twice" if executed >> number & 1 else "out of order"
            return Fault(f"request {number} is executed {how}"), None
        if gateway.never >> number & 1:
            return Fault(f"request {number} is executed, but reported as not executed"), None
        executed |= 1 << number
    after = gateway._replace(expected=(ident + 1) % RING, gap_told=False, executed=executed)
    if kind in FAILING:
        return after, (ERROR, ident, number, session)
    return after, None if kind in POSTED else (ANSWER, ident, number, session)


def _repeat(frame: Frame) -> Frame | None:
    """Return the answer to a request that the gateway takes for a repetition."""
    kind, ident, number, session = frame
    if kind in FAILING:
        return ERROR, ident, number, session
    return None if kind in POSTED else (ANSWER, ident, number, session)


# The host


def _host_moves(rules: Rules, state: State) -> Iterator[tuple[str, State]]:
    host, room = state.host, rules.in_line - len(state.out)
    if state.restarts < rules.restarts:
        anew = state._replace(host=_new_session(host), restarts=state.restarts + 1)
        yield "the host begins anew on the same line", anew
    if not host.ready:
        if room:
            yield "the host sends K", state._replace(out=(*state.out, ("K", _id(host, host.first), -1, host.session)))
        return
    number = host.first + len(host.window)
    if room and len(host.window) < WINDOW:
        for kind in _kinds(rules, host, number):
            frame = (kind, _id(host, number), number, host.session)
            issued = host._replace(window=host.window + kind, again=(*host.again, 0))
            yield f"the host sends {_show(frame)}", state._replace(host=issued, out=(*state.out, frame))
    yield from _repetition_moves(state, room)
    if rules.cancels:
        for place in range(host.confirmed, len(host.window)):
            if host.window[place] not in ("h", DONE):
                window = _put(host.window, place, "h")
                yield (
                    f"the host gives request {host.first + place} up",
                    state._replace(host=host._replace(window=window)),
                )


def _repetition_moves(state: State, room: int) -> Iterator[tuple[str, State]]:
    host = state.host
    open_places = [place for place, kind in enumerate(host.window) if kind != DONE]
    if open_places and len(open_places) <= room:
        yield "the host goes back", _send_again(state, open_places)
    if len(open_places) > 1 and room:
        for place in open_places:
            yield f"the host sends request {host.first + place} again alone", _send_again(state, [place])


def _send_again(state: State, places: list[int]) -> State:
    host = state.host
    frames = tuple(
        (host.window[place], _id(host, host.first + place), host.first + place, host.session) for place in places
    )
    there_were = host.first + len(host.window)
    again = tuple(there_were if place in places else before for place, before in enumerate(host.again))
    return state._replace(host=host._replace(again=again), out=state.out + frames)


def _kinds(rules: Rules, host: Host, number: int) -> Iterator[str]:
    """Return the possible kinds of the next request; after posted requests one more may always be a fence."""
    if number < rules.requests:
        alone = len(host.window) + 1 < WINDOW
        yield from (kind for kind in rules.kinds if kind not in POSTED or alone or not rules.leaves_room)
    elif host.window and host.window[-1] in POSTED:
        yield "h"


def _id(host: Host, number: int) -> int:
    return (number + host.offset) % RING


def _put(window: str, place: int, letter: str) -> str:
    return window[:place] + letter + window[place + 1 :]


def _new_session(host: Host) -> Host:
    """Return the host with an empty window, after it has reported the outcome of each request."""
    first = host.first + len(host.window)
    return Host(host.session + 1, False, -first % RING, first, "", 0, ())


def _hear(rules: Rules, state: State, frame: Frame) -> State | Fault:
    """Return the state after the host received a frame of the gateway."""
    kind, ident, _, session = frame
    if rules.names_session and session != state.host.session:
        return state
    if state.host.ready and kind == NO_SESSION:
        return _lose_session(rules, state, ident)
    host = _heard(state.host, frame, state.gateway.executed)
    return host if isinstance(host, Fault) else state._replace(host=host)


def _lose_session(rules: Rules, state: State, ident: int) -> State | Fault:
    """Return the state after an answer that the gateway had no session when it received a request.

    That request and later ones were not executed, unless they were sent before; the outcomes of all others are unknown.
    """
    host, gateway = state.host, state.gateway
    place = (ident - _id(host, host.first)) % RING
    never = 0
    for number in range(_never_executed_from(rules, host, place), host.first + len(host.window)):
        never |= 1 << number
    if never & gateway.executed:
        return Fault("a request is reported as not executed, but was executed")
    after = gateway._replace(never=gateway.never | never)
    return state._replace(host=_new_session(host), gateway=after)


def _never_executed_from(rules: Rules, host: Host, place: int) -> int:
    """Return the first request that was not executed if the gateway refused the one at `place`."""
    refused, behind = host.first + place, host.first + len(host.window)
    if not rules.minds_repetitions:
        return refused
    if not rules.minds_order:
        return max(refused, *(host.first + at + 1 for at, before in enumerate(host.again) if before), 0)
    return max(refused, host.again[place] if refused < behind else behind)


def _heard(host: Host, frame: Frame, executed: int) -> Host | Fault:
    """Return the host after a frame of the gateway that does not change the session."""
    kind, ident = frame[:2]
    if not host.ready:
        return host._replace(ready=kind == "k" and ident == _id(host, host.first))
    place = (ident - _id(host, host.first)) % RING
    if kind == "n" and place <= len(host.window):
        return _confirm(host, place, executed)
    if kind in (ANSWER, ERROR) and place < len(host.window) and host.window[place] != DONE:
        return _answered(host, place, frame, executed)
    return host


def _answered(host: Host, place: int, frame: Frame, executed: int) -> Host | Fault:
    """Return the host after an answer that it matches to the request at `place`."""
    number = frame[2]
    if number != host.first + place:
        return Fault(f"the answer of request {number} is taken for that of {host.first + place}")
    if host.window[place] != "h" and not executed >> number & 1:
        return Fault(f"request {number} is reported as executed, but was not")
    answered = host._replace(window=_put(host.window, place, DONE))
    return _confirm(answered, place + 1, executed)


def _confirm(host: Host, count: int, executed: int) -> Host | Fault:
    """Return the host after its first `count` requests were executed."""
    window = host.window
    for place in range(count):
        if window[place] in POSTED:
            if not executed >> host.first + place & 1:
                return Fault(f"the posted request {host.first + place} is reported as executed, but was not")
            window = _put(window, place, DONE)
    confirmed = max(host.confirmed, count)
    told = len(window) - len(window.lstrip(DONE))
    again = host.again[told:]
    return Host(host.session, host.ready, host.offset, host.first + told, window[told:], confirmed - told, again)
