"""A model of requests with IDs over datagrams, which arrive late, in any order and any number of times.

No datagram ever leaves the network: a lost datagram is one that is never taken, and a late or duplicated datagram is
taken again. The number of datagrams and the number of opened sessions are limited instead. The host is that of
`stream` with answered writes only; it may retransmit any request in flight, which covers every way to go back.

A K opens a session in its datagram. The model explores four rules for the number of that session; three of them are
wrong. A host that begins again does so from another port, so datagrams of its earlier attempt also represent those of
another host.
"""

from collections.abc import Iterator
from enum import Enum, auto
from typing import NamedTuple, TypeAlias

from protocol_model.exploration import Exploration, Fault, explore

RING = 4
WINDOW = RING // 2
NO_SESSION = 0


class Naming(Enum):
    """How sessions are numbered."""

    NOT_AT_ALL = auto()
    """Datagrams have no header: protocol 01, in a session that is already open."""
    BY_HOST = auto()
    """The host draws a number that was never used; K opens the session that its datagram names."""
    COUNTED = auto()
    """K opens the session that the gateway offered last; it offers the number after that of its last session."""
    DRAWN = auto()
    """As COUNTED, but the gateway offers a number that it has never offered, not even before a reset: protocol 02."""


class Rules(NamedTuple):
    """Rules for the numbers of sessions, and limits of the exploration."""

    naming: Naming = Naming.DRAWN
    requests: int = 5
    datagrams: int = 4
    """Largest number of datagrams that the host sends in a session."""
    sessions: int = 2
    """Number of session numbers."""
    resets: int = 1
    counts: int = 1 << 32
    """Counts wrap around modulo this number, without 0."""
    first_count: int = 1
    beginnings: int = 3
    """Largest number of times that the host begins."""
    new_ports: bool = True
    """If true, the host begins from another port each time; a session belongs to the port that opened it."""


class Datagram(NamedTuple):
    """A frame after a header; a gateway's datagram with `serial` 0 has no count: it is an offer or a refusal."""

    session: int
    serial: int
    kind: str
    ident: int = 0
    number: int = -1
    port: int = 0
    """The host's port: the source of its own datagrams, the destination of the gateway's."""


class Host(NamedTuple):
    """The host: `sent` datagrams sent in this session; `heard` is the last count that it accepted, 0 for none."""

    session: int = NO_SESSION
    ready: bool = False
    sent: int = 0
    heard: int = 0
    offset: int = 0
    """ID minus number, in this session."""
    first: int = 0
    next: int = 0
    """Requests `first` to `next` - 1 are in flight."""
    port: int = 0
    beginnings: int = 1


class Gateway(NamedTuple):
    """The gateway, with its own `sent` and `heard`; `executed` has a bit for each request, for checks only."""

    session: int = NO_SESSION
    offer: int = NO_SESSION
    sent: int = 0
    heard: int = 0
    expected: int = 0
    executed: int = 0
    port: int = 0


Network: TypeAlias = frozenset[Datagram]


class State(NamedTuple):
    """State of host, gateway and network; `named` is the number of session numbers used so far."""

    host: Host
    gateway: Gateway
    out: Network = frozenset()
    back: Network = frozenset()
    named: int = 0
    resets: int = 0


def explored(rules: Rules, sought: str = "") -> Exploration:
    """Explore the rules; if `sought` is given, pass over all other faults."""
    start = State(Host(), Gateway())
    if rules.naming is Naming.NOT_AT_ALL:
        start = State(Host(session=1, ready=True), Gateway(session=1))
    # A limit may be reached before the end, so not every state has a way to an end.
    return explore(
        start,
        lambda state: _moves(rules, state),
        lambda state: _all_reported(rules, state),
        always_ends=False,
        sought=sought,
    )


def _all_reported(rules: Rules, state: State) -> bool:
    return state.host.first == rules.requests


def _moves(rules: Rules, state: State) -> Iterator[tuple[str, State | Fault]]:
    yield from _host_moves(rules, state)
    for datagram in sorted(state.out):
        taken = _take(rules, state, datagram)
        if taken is not state:
            yield f"the gateway takes {_show(datagram)}", taken
    for datagram in sorted(state.back):
        if datagram.port != state.host.port:
            continue
        heard = _hear(rules, state, datagram)
        if heard is not state:
            yield f"the host hears {_show(datagram)}", heard
    if state.resets < rules.resets:
        after_reset = Gateway(executed=state.gateway.executed)
        yield "the gateway is reset", state._replace(gateway=after_reset, resets=state.resets + 1)


def _show(datagram: Datagram) -> str:
    session, count, kind, ident, number, port = datagram
    request = f" {ident} of request {number}" if number >= 0 else f" {ident}" if kind in "Kkn" else ""
    return f"{kind}{request}, session {session}, count {count}, port {port}"


# Counts


def _count(rules: Rules, sent: int) -> int:
    """Return the count of the next datagram after `sent` others; 0 in protocol 01, which has no counts."""
    if rules.naming is Naming.NOT_AT_ALL:
        return 0
    return (rules.first_count - 1 + sent) % (rules.counts - 1) + 1


def _is_newer(rules: Rules, count: int, heard: int) -> bool:
    """Return true if a count is ahead of the last one by less than half of the counts."""
    if rules.naming is Naming.NOT_AT_ALL or heard == 0:
        return True
    return 0 < (count - heard) % rules.counts < rules.counts // 2


# The gateway


def _take(rules: Rules, state: State, datagram: Datagram) -> State | Fault:
    gateway = state.gateway
    if datagram.kind == "Q":
        return _offer(rules, state, datagram.port)
    if (datagram.session, datagram.port) == (gateway.session, gateway.port):
        if not _is_newer(rules, datagram.serial, gateway.heard):
            return state
        return _execute(rules, state, gateway._replace(heard=datagram.serial), datagram)
    if datagram.kind == "K" and (rules.naming is Naming.BY_HOST or datagram.session == gateway.offer):
        opened = Gateway(datagram.session, heard=datagram.serial, executed=gateway.executed, port=datagram.port)
        return _execute(rules, state, opened, datagram)
    return _answered(state, gateway, Datagram(datagram.session, 0, "no session", port=datagram.port))


def _offer(rules: Rules, state: State, port: int) -> State:
    """Return the state after a query, which belongs to no session; an offer stays valid until a host takes it."""
    gateway = state.gateway
    if gateway.offer != NO_SESSION:
        return _answered(state, gateway, Datagram(gateway.offer, 0, "offer", port=port))
    if state.named == rules.sessions:
        return state
    offer = gateway.session + 1 if rules.naming is Naming.COUNTED else state.named + 1
    named = state._replace(named=state.named + 1)
    return _answered(named, gateway._replace(offer=offer), Datagram(offer, 0, "offer", port=port))


def _execute(rules: Rules, state: State, gateway: Gateway, datagram: Datagram) -> State | Fault:
    ident, number = datagram.ident, datagram.number
    ahead = (ident - gateway.expected) % RING
    said = "answer", ident, number
    if datagram.kind == "K":
        gateway = gateway._replace(expected=ident)
        said = "k", ident, -1
    elif ahead == 0:
        if gateway.executed >> number:
            how = "twice" if gateway.executed >> number & 1 else "out of order"
            return Fault(f"request {number} is executed {how}")
        gateway = gateway._replace(expected=(ident + 1) % RING, executed=gateway.executed | 1 << number)
    elif ahead < RING // 2:
        said = "n", gateway.expected, -1
    answer = Datagram(gateway.session, _count(rules, gateway.sent), *said, gateway.port)
    return _answered(state, gateway._replace(sent=gateway.sent + 1), answer)


def _answered(state: State, gateway: Gateway, datagram: Datagram) -> State:
    return state._replace(gateway=gateway, back=state.back | {datagram})


# The host


def _host_moves(rules: Rules, state: State) -> Iterator[tuple[str, State]]:
    host = state.host
    if host.session == NO_SESSION:
        if rules.naming is not Naming.BY_HOST:
            question = Datagram(NO_SESSION, 0, "Q", port=host.port)
            yield "the host asks", state._replace(out=state.out | {question})
        elif state.named < rules.sessions:
            begun = _begin(host, state.named + 1)
            yield "the host names a session", state._replace(host=begun, named=state.named + 1)
        return
    if rules.naming is not Naming.NOT_AT_ALL and host.beginnings < rules.beginnings:
        yield "the host begins anew", state._replace(host=_begin_anew(rules, host))
    if host.sent == rules.datagrams:
        return
    if not host.ready:
        yield "the host sends K", _sent(rules, state, host, "K", -1)
        return
    for number in range(host.first, min(host.next + 1, host.first + WINDOW, rules.requests)):
        issued = host._replace(next=max(host.next, number + 1))
        yield f"the host sends request {number}", _sent(rules, state, issued, "w", number)


def _sent(rules: Rules, state: State, host: Host, kind: str, number: int) -> State:
    ident = 0 if kind == "K" else _id(host, number)
    datagram = Datagram(host.session, _count(rules, host.sent), kind, ident, number, host.port)
    return state._replace(host=host._replace(sent=host.sent + 1), out=state.out | {datagram})


def _id(host: Host, number: int) -> int:
    return (number + host.offset) % RING


def _begin(host: Host, session: int) -> Host:
    """Return the host in a session in which its next request has ID 0."""
    return host._replace(session=session, offset=-host.next % RING)


def _begin_anew(rules: Rules, host: Host) -> Host:
    """Return the host without a session; the outcomes of the requests in flight are unknown."""
    port = host.port + rules.new_ports
    return Host(first=host.next, next=host.next, port=port, beginnings=host.beginnings + 1)


def _hear(rules: Rules, state: State, datagram: Datagram) -> State | Fault:
    host = state.host
    session, count, kind = datagram[:3]
    if kind == "offer":
        return state._replace(host=_begin(host, session)) if host.session == NO_SESSION else state
    if session != host.session:
        return state
    if kind == "no session":
        return state._replace(host=_begin_anew(rules, host)) if host.beginnings < rules.beginnings else state
    if not _is_newer(rules, count, host.heard):
        return state
    after = _told(host._replace(heard=count), datagram, state.gateway.executed)
    return after if isinstance(after, Fault) else state._replace(host=after)


def _told(host: Host, datagram: Datagram, executed: int) -> Host | Fault:
    """Return the host after a frame of its session; an answer proves that all earlier requests were executed."""
    if not host.ready:
        return host._replace(ready=datagram.kind == "k")
    place = (datagram.ident - _id(host, host.first)) % RING
    in_flight = host.next - host.first
    if datagram.kind == "k" or place > in_flight or (datagram.kind == "answer" and place == in_flight):
        return host
    if datagram.kind == "answer":
        if datagram.number != host.first + place:
            return Fault(f"the answer of request {datagram.number} is taken for that of {host.first + place}")
        place += 1
    for number in range(host.first, host.first + place):
        if not executed >> number & 1:
            return Fault(f"request {number} is reported as executed, but was not")
    return host._replace(first=host.first + place)
