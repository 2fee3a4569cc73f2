"""A model of two hosts on one line to one gateway: all interleavings of sending, loss, retransmission and resets.

The line is that of a device server, or of a port that two programs have opened. The frames of both hosts are merged;
the gateway's answers reach one host, both or none. Any frame may be lost, the gateway may be reset at any instant, and
either host may open a session at any instant. A stream keeps the order of frames; datagrams arrive in any order and any
number of times.

Each rule of `Rules` can be left out, which shows its purpose. Besides its ID each request has its host and a number
that no rule may read; the model uses them to find requests that were executed twice, out of order or never, and answers
that were matched to the wrong request. These letters represent requests in a host's window and on the line:

    w  writes        e  writes, and fails         q  reads destructively
    s  is posted     p  is posted, and fails      h  has no effect: the fence
    a  is ahead      of all requests in flight: a host sends it only to query the gateway's next ID

If session numbers can repeat, time matters: a host is *fresh* for a second after each answer. In that second the model
explores at most one reset or one opening by another host, and the same limit holds while a request is in flight: the
page states this limit. If another session by chance expects the ID that the host sends next, no exchange can reveal it:
the exploration ends there, and the page states how rare this case is.
"""

import contextlib
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import NamedTuple, TypeAlias, TypeVar

from protocol_model.exploration import Exploration, Fault, explore

T = TypeVar("T")

RING = 4
WINDOW = RING // 2
AHEAD = WINDOW - 1
"""Distance of the request that queries the next ID: the largest that the gateway takes for ahead."""
NOTHING = -1
"""Number of the query for the next ID, which belongs to no request."""
POSTED = "sp"
FAILING = "ep"
DONE = "."

Ghost: TypeAlias = tuple[int, int] | None
"""Host and number of a request; None for a frame that is about no request. Used for checks only."""


class Rules(NamedTuple):
    """Rules of the protocol, and limits of the exploration."""

    seed: bool = True
    """The CRC depends on the session's number: gateway and hosts drop frames of other sessions."""
    way: bool = True
    """The CRC depends on the direction: a host does not accept an echo as an answer."""
    refuse: bool = True
    """The gateway refuses a `K` with the number of the open session."""
    ask: bool = True
    """A host in doubt sends a session query, and ends if the open session is not its own."""
    proof: bool = True
    """The refusal of a gateway without a session shows which session's request it refused."""
    fate: bool = True
    """The gateway stores the outcome of each request, and answers its repetition accordingly."""
    counts: bool = True
    """The answer to `h` has the count of failed posted writes; the host queries each write if it missed an error."""
    kept: bool = True
    """The gateway stores the words of a destructive read, and answers its repetition with them."""
    spaced: bool = True
    """A host never has two unanswered destructive reads whose words are stored in the same place."""
    newer: bool = True
    """Datagrams have a count, by which late ones are dropped, and open only the offered session."""
    proves: bool = True
    """A host without an answer for a second sends no request before an `n` proves that the session is its own."""
    numbers: int = 0
    """Number of session numbers to choose from; 0: each session has a new number."""
    places: int = 2
    """Number of places for stored words."""
    requests: tuple[str, str] = ("www", "w")
    """Requests of each host, in order."""
    opens: tuple[int, int] = (1, 1)
    """Largest number of sessions that each host opens."""
    line: int = 2
    """Largest number of frames in each direction."""
    resets: int = 1
    echo: bool = False
    """The adapter echoes the host's frames."""
    datagrams: bool = False
    sendings: int = 4
    """Largest number of datagrams of each side in a session (with `datagrams`)."""


PROTOCOL_02 = Rules(seed=False, way=False, refuse=False, ask=False, proof=False, fate=False, counts=False, kept=False)
"""Rules of protocol version 02."""


class Frame(NamedTuple):
    """A frame; `kind` is the letter of a request, or a word for an answer."""

    kind: str
    session: int
    ident: int = 0
    extra: Ghost | int | str = 0
    """Count of failed posted writes, word of a destructive read, or the mark of an echo."""
    ghost: Ghost = None
    serial: int = 0
    """Count of its datagram."""


class Request(NamedTuple):
    """A request in a window."""

    kind: str
    again: bool = False
    """True if it was sent more than once."""


class Host(NamedTuple):
    """A host; requests from `first` on are in its window, and `base` is the ID of `first`."""

    phase: str = "away"
    """`away`, `opening` or `open`."""
    session: int = 0
    base: int = 0
    first: int = 0
    window: tuple[Request, ...] = ()
    opens: int = 0
    known: int = 0
    """All requests below this number were executed, as far as the host knows."""
    heard: int = 0
    """Number of the session's posted requests whose errors the host has received."""
    newest: int = 0
    sent: int = 0
    fresh: bool = True
    """Less than a second has passed since its last answer."""
    changed: bool = False
    """The open session was ended during this second."""


class Gateway(NamedTuple):
    """The gateway; session 0 means that no session is open."""

    session: int = 0
    opener: int = -1
    """Host that opened the session; used for checks only."""
    expected: int = 0
    failed_at: tuple[bool, ...] = (False,) * WINDOW
    """For each ID modulo the window, true if its last request failed."""
    failed: int = 0
    kept: tuple[Ghost, ...] = ()
    newest: int = 0
    sent: int = 0
    offer: int = 1


class State(NamedTuple):
    """State of hosts, gateway and line; `executed` and `never` (so reported) have a bit for each request of a host."""

    hosts: tuple[Host, Host] = (Host(), Host())
    gateway: Gateway = Gateway()
    out: tuple[Frame, ...] = ()
    back: tuple[Frame, ...] = ()
    resets: int = 0
    executed: tuple[int, int] = (0, 0)
    never: tuple[int, int] = (0, 0)


class _WrongError(Exception):
    """A forbidden state was reached."""


class _BoundError(Exception):
    """A step beyond the limits of the rules."""


def explored(rules: Rules, sought: str = "") -> Exploration:
    """Explore the rules; if `sought` is given, pass over all other faults."""
    start = State(gateway=Gateway(kept=(None,) * rules.places))
    # A limit may be reached before the end, so over datagrams not every state has a way to an end.
    return explore(
        start,
        lambda state: _moves(rules, state),
        lambda state: _all_reported(rules, state),
        always_ends=not rules.datagrams,
        sought=sought,
    )


def _all_reported(rules: Rules, state: State) -> bool:
    return all(
        host.phase == "away" or host.first == len(requests)
        for host, requests in zip(state.hosts, rules.requests, strict=True)
    )


def _moves(rules: Rules, state: State) -> Iterator[tuple[str, State | Fault]]:
    for who in (0, 1):
        for name, after in _host_moves(rules, state, who):
            yield f"{'AB'[who]}: {name}", after
    for place, frame in enumerate(state.out if rules.datagrams else state.out[:1]):
        rest = state._replace(out=state.out[:place] + state.out[place + 1 :])
        yield f"lost: {frame}", rest
        if len(state.back) < rules.line and (not rules.datagrams or state.gateway.sent < rules.sendings):
            # A datagram may arrive again.
            for before in (rest, state) if rules.datagrams else (rest,):
                yield from _tried(f"the gateway takes {frame}", partial(_taken, rules, before, frame))
    for place, frame in enumerate(state.back if rules.datagrams else state.back[:1]):
        rest = state._replace(back=state.back[:place] + state.back[place + 1 :])
        yield f"lost: {frame}", rest
        for hearing in ((0,), (1,), (0, 1)):
            names = " and ".join("AB"[who] for who in hearing)
            yield from _tried(f"{names} get {frame}", partial(_heard_by, rules, rest, frame, hearing))
    if state.resets < rules.resets:
        yield from _tried("the gateway is reset", partial(_reset, rules, state))


def _tried(name: str, step: Callable[[], State]) -> Iterator[tuple[str, State | Fault]]:
    with contextlib.suppress(_BoundError):
        try:
            yield name, step()
        except _WrongError as wrong:
            yield name, Fault(str(wrong))


def _reset(rules: Rules, state: State) -> State:
    gateway = Gateway(kept=(None,) * rules.places, offer=state.gateway.offer)
    return _changed(rules, state, -1)._replace(gateway=gateway, resets=state.resets + 1)


def _is_answered(state: State, who: int) -> bool:
    """Return true if an answer to the host's query for the next ID is on the line: it arrives within the second."""
    return any(frame.kind == "n" and frame.ghost == (who, NOTHING) for frame in state.back)


def _changed(rules: Rules, state: State, opener: int) -> State:
    """Return the state after the open session was ended by a reset, or by a host that opened another one."""
    if not rules.numbers:
        return state
    for who, host in enumerate(state.hosts):
        if host.changed and (host.fresh or _is_answered(state, who)) and who != opener:
            raise _BoundError
        changed = who == state.gateway.opener != opener
        state = _with(state, who, host._replace(changed=(changed or host.changed) and who != opener))
    return state


def _put(items: tuple[T, ...], place: int, item: T) -> tuple[T, ...]:
    return (*items[:place], item, *items[place + 1 :])


def _of_host(pair: tuple[T, T], who: int, item: T) -> tuple[T, T]:
    return (pair[0], item) if who else (item, pair[1])


# The gateway


def _taken(rules: Rules, state: State, frame: Frame) -> State:
    """Return the state after the gateway received a frame."""
    state, answer = _answered(rules, state, frame)
    if answer is None:
        return state
    gateway = state.gateway._replace(sent=state.gateway.sent + rules.datagrams)
    return state._replace(gateway=gateway, back=(*state.back, answer._replace(serial=gateway.sent)))


def _answered(rules: Rules, state: State, frame: Frame) -> tuple[State, Frame | None]:
    gateway = state.gateway
    if rules.datagrams and rules.newer and frame.kind not in "K?":
        if gateway.session and (frame.session != gateway.session or frame.serial <= gateway.newest):
            return state, None
        gateway = gateway._replace(newest=frame.serial)
    if frame.kind == "?":
        return state, Frame("state", gateway.session)
    if frame.kind == "K":
        return _opened(rules, state, frame)
    if not gateway.session:
        return state, Frame("0A", frame.session if rules.proof else 0, frame.ident, ghost=frame.ghost)
    if rules.seed and frame.session != gateway.session:
        return state, None
    return _in_order(rules, state._replace(gateway=gateway), frame)


def _opened(rules: Rules, state: State, frame: Frame) -> tuple[State, Frame | None]:
    before = state.gateway
    is_old = rules.datagrams and rules.newer and frame.session != before.offer
    if is_old or (rules.refuse and frame.session == before.session):
        return state, None
    assert frame.ghost is not None
    opener = frame.ghost[0]
    gateway = Gateway(
        frame.session,
        opener,
        frame.ident,
        kept=(None,) * rules.places,
        newest=frame.serial,
        offer=before.offer + (frame.session == before.offer),
    )
    return _changed(rules, state, opener)._replace(gateway=gateway), Frame("k", frame.session, frame.ident)


def _in_order(rules: Rules, state: State, frame: Frame) -> tuple[State, Frame | None]:
    """Return the state after a request of the session, and the gateway's answer."""
    gateway, ident = state.gateway, frame.ident
    ahead = (ident - gateway.expected) % RING
    assert frame.ghost is not None
    who, number = frame.ghost
    is_chance = rules.proves and who != gateway.opener
    if ahead >= RING // 2:
        return state, _repeated(rules, gateway, frame)
    if ahead:
        if is_chance and frame.kind == "a" and ahead == AHEAD:
            return _with(state, who, _ended(state.hosts[who])), None
        return state, Frame("n", gateway.session, gateway.expected, ghost=frame.ghost if rules.numbers else None)
    if is_chance:
        return _with(state, who, _ended(state.hosts[who])), None
    done = state.executed[who]
    if done >> number:
        raise _WrongError("executed twice" if done >> number & 1 else "executed out of order")
    if state.never[who] >> number & 1:
        raise _WrongError("executed, but reported as not executed")
    fails = frame.kind in FAILING
    gateway = gateway._replace(
        expected=(ident + 1) % RING,
        failed_at=_put(gateway.failed_at, ident % WINDOW, fails),
        failed=(gateway.failed + (frame.kind == "p")) % RING,
    )
    if frame.kind == "q":
        gateway = gateway._replace(kept=_put(gateway.kept, ident % rules.places, frame.ghost))
    state = state._replace(gateway=gateway, executed=_of_host(state.executed, who, done | 1 << number))
    if frame.kind == "s":
        return state, None
    extra = frame.ghost if frame.kind == "q" else gateway.failed
    return state, Frame("x" if fails else frame.kind, gateway.session, ident, extra, frame.ghost)


def _repeated(rules: Rules, gateway: Gateway, frame: Frame) -> Frame | None:
    """Return the answer to a repetition of an executed request."""
    about = gateway.session, frame.ident
    if rules.fate and gateway.failed_at[frame.ident % WINDOW]:
        return Frame("x", *about, ghost=frame.ghost)
    if frame.kind == "q":
        kept = gateway.kept[frame.ident % rules.places] if rules.kept else None
        return Frame("q", *about, kept, frame.ghost)
    if frame.kind in POSTED:
        return None
    return Frame(frame.kind if frame.kind in "ha" else "w", *about, gateway.failed, frame.ghost)


# The hosts


def _host_moves(rules: Rules, state: State, who: int) -> Iterator[tuple[str, State]]:
    host, requests = state.hosts[who], rules.requests[who]
    room = rules.line - max(len(state.out), len(state.back) if rules.echo else 0)
    if host.opens < rules.opens[who] and room and (host.first < len(requests) or host.window):
        for session in _numbers(rules, state, who):
            ident = (2 * who + host.opens) % RING
            begun = _ended(host)._replace(
                phase="opening",
                session=session,
                base=ident,
                opens=host.opens + 1,
                heard=0,
                newest=0,
                sent=0,
                fresh=True,
                changed=False,
            )
            opening = Frame("K", session, ident, ghost=(who, 0))
            yield f"begins session {session}", _sent(rules, state, who, begun, opening)
    elif host.phase == "opening" or (host.phase == "open" and not rules.ask):
        yield "gives up", state._replace(hosts=_of_host(state.hosts, who, _ended(host)))
    if host.phase != "open" or not room or (rules.datagrams and host.sent >= rules.sendings):
        return
    if rules.ask:
        yield "asks for the session", _sent(rules, state, who, host, Frame("?", host.session))
    if rules.numbers and host.fresh and not host.window and not _is_answered(state, who):
        yield "gets no answer for a second", _with(state, who, host._replace(fresh=False, changed=False))
    if host.fresh or not rules.proves:
        yield from _request_moves(rules, state, who, room)
    else:
        ahead = Frame("a", host.session, (host.base + AHEAD) % RING, ghost=(who, NOTHING))
        yield "asks for the next ID", _sent(rules, state, who, host, ahead)


def _numbers(rules: Rules, state: State, who: int) -> Iterable[int]:
    if rules.datagrams:
        return [state.gateway.offer]
    return range(1, rules.numbers + 1) if rules.numbers else [2 * state.hosts[who].opens + who + 1]


def _request_moves(rules: Rules, state: State, who: int, room: int) -> Iterator[tuple[str, State]]:
    host, requests = state.hosts[who], rules.requests[who]
    in_flight = len(host.window)
    if in_flight < WINDOW and host.first + in_flight < len(requests):
        kind = requests[host.first + in_flight]
        shares = any(
            request.kind == "q" and (place - in_flight) % rules.places == 0 for place, request in enumerate(host.window)
        )
        if not (kind == "q" and shares and rules.spaced):
            issued = host._replace(window=(*host.window, Request(kind)))
            yield f"sends {kind}", _sent(rules, state, who, issued, _frame(issued, who, in_flight))
    open_places = tuple(place for place, request in enumerate(host.window) if request.kind != DONE)
    for places in {open_places, *((place,) for place in open_places)}:
        if 0 < len(places) <= room:
            again = host
            for place in places:
                again = _marked(again, place)
            frames = (_frame(host, who, place) for place in places)
            yield f"sends {places} again", _sent(rules, state, who, again, *frames)
    for place in open_places:
        if rules.counts and host.window[place].kind in POSTED and host.first + place < host.known:
            question = _frame(host, who, place)._replace(kind="h")
            yield f"asks how {place} ended", _sent(rules, state, who, _marked(host, place), question)


def _marked(host: Host, place: int) -> Host:
    return host._replace(window=_put(host.window, place, host.window[place]._replace(again=True)))


def _frame(host: Host, who: int, place: int) -> Frame:
    ident = (host.base + place) % RING
    return Frame(host.window[place].kind, host.session, ident, ghost=(who, host.first + place))


def _sent(rules: Rules, state: State, who: int, host: Host, *frames: Frame) -> State:
    host = host._replace(sent=host.sent + rules.datagrams)
    out = (*state.out, *(frame._replace(serial=host.sent) for frame in frames))
    # Only for these frames a request and its answer have the same text, except for the CRC.
    echoes = tuple(frame._replace(extra="echo") for frame in frames if rules.echo and frame.kind in "Kh")
    return state._replace(hosts=_of_host(state.hosts, who, host), out=out, back=state.back + echoes)


def _ended(host: Host) -> Host:
    """Return a host without a session; it has reported the outcomes of the requests in flight as unknown."""
    return host._replace(phase="away", session=0, first=host.first + len(host.window), window=())


def _heard_by(rules: Rules, state: State, frame: Frame, hearing: tuple[int, ...]) -> State:
    for who in hearing:
        state = _heard(rules, state, frame, who)
    return state


def _heard(rules: Rules, state: State, frame: Frame, who: int) -> State:
    """Return the state after a host received a frame."""
    host, kind = state.hosts[who], frame.kind
    if frame.extra == "echo":
        if rules.way:
            return state
        kind = kind.lower()
    is_other = frame.session != host.session
    if host.phase != "open":
        is_own = host.phase == "opening" and kind == "k" and frame.ident == host.base and not (rules.seed and is_other)
        return _with(state, who, host._replace(phase="open", newest=frame.serial)) if is_own else state
    if kind == "state":
        return _with(state, who, _ended(host)) if is_other else state
    if rules.datagrams and rules.newer:
        if is_other or frame.serial <= host.newest:
            return state
        host = host._replace(newest=frame.serial)
    if kind == "0A":
        return _refused(rules, state, frame, who, host)
    return state if rules.seed and is_other else _heard_in_session(rules, state, frame._replace(kind=kind), who, host)


def _heard_in_session(rules: Rules, state: State, frame: Frame, who: int, host: Host) -> State:
    """Return the state after a host received a frame whose CRC is that of its session."""
    if frame.session == host.session:
        if _is_of_another(host, frame):
            return _with(state, who, _ended(host))
        if frame.kind == "n" and not host.fresh:
            if frame.ghost is None or frame.ghost[0] != who:
                raise _BoundError
            host = host._replace(fresh=True)
    return _told(rules, state, frame, who, host)


def _is_of_another(host: Host, frame: Frame) -> bool:
    """Return true if a frame proves that the open session, with the same number, belongs to another host."""
    if frame.kind == "n":
        return (frame.ident - host.base) % RING > len(host.window)
    return not host.fresh and frame.kind == "a" and frame.ident == (host.base + AHEAD) % RING


def _with(state: State, who: int, host: Host) -> State:
    return state._replace(hosts=_of_host(state.hosts, who, host))


def _refused(rules: Rules, state: State, frame: Frame, who: int, host: Host) -> State:
    """Return the state after an answer that the gateway had no session when it received a request.

    That request and later ones were not executed, if each was sent once. Datagrams may be late, so they prove nothing.
    """
    place = (frame.ident - host.base) % RING
    if (rules.proof and frame.session != host.session) or place >= len(host.window):
        return state
    never = sum(1 << host.first + at for at in range(place, len(host.window)) if host.window[at].kind != DONE)
    if rules.datagrams or any(request.again for request in host.window[place:]):
        never = 0
    if never & state.executed[who]:
        raise _WrongError("reported as not executed, but executed")
    return _with(state, who, _ended(host))._replace(never=_of_host(state.never, who, state.never[who] | never))


def _told(rules: Rules, state: State, frame: Frame, who: int, host: Host) -> State:
    """Return the state after an answer of the session, or a frame that the host accepts as one."""
    place = (frame.ident - host.base) % RING
    executed = state.executed[who]
    if frame.kind == "n":
        return _with(state, who, _confirmed(rules, host, place, executed)) if place <= len(host.window) else state
    if frame.kind in "ka" or place >= len(host.window) or host.window[place].kind == DONE:
        return _with(state, who, host)
    asked, number = host.window[place].kind, host.first + place
    if frame.ghost != (who, number):
        raise _WrongError("an answer is matched to the wrong request")
    is_fence = asked == "h"
    if frame.kind == "x":
        host = host._replace(heard=(host.heard + (asked in POSTED)) % RING)
    else:
        if is_fence and frame.extra != "echo" and rules.counts:
            host = _confirmed(rules, host, place + 1, executed)
            if frame.extra != host.heard:
                # The error of a posted request was lost: query each of them.
                return _with(state, who, host)
        _check(asked, frame, done=bool(executed >> number & 1))
    host = _confirmed(rules, host, place + 1, executed, fence=is_fence)
    window = _put(host.window, number - host.first, Request(DONE))
    return _with(state, who, _shrunk(host._replace(window=window)))


def _check(asked: str, frame: Frame, *, done: bool) -> None:
    if not done:
        raise _WrongError("reported as done, but not executed")
    if asked in FAILING:
        raise _WrongError("reported as done, but failed")
    if asked == "q" and frame.extra != frame.ghost:
        raise _WrongError("a word is lost")


def _confirmed(rules: Rules, host: Host, count: int, executed: int, *, fence: bool = False) -> Host:
    """Return a host after its first `count` requests were executed; a fence confirms the posted ones among them."""
    window = host.window
    for place in range(count):
        if window[place].kind in POSTED and (fence or not rules.counts):
            if not executed >> host.first + place & 1:
                raise _WrongError("a posted request is reported as done, but not executed")
            if window[place].kind == "p":
                raise _WrongError("a posted request is reported as done, but failed")
            window = _put(window, place, Request(DONE))
    return _shrunk(host._replace(window=window, known=max(host.known, host.first + count)))


def _shrunk(host: Host) -> Host:
    told = 0
    while told < len(host.window) and host.window[told].kind == DONE:
        told += 1
    return host._replace(first=host.first + told, window=host.window[told:], base=(host.base + told) % RING)
