"""The exploration of `datagrams` with `HostDatagrams` and `GatewayDatagrams` in place of the model's headers.

The model decides how host and gateway react to frames; the real classes handle the datagrams. Each state stores the
fields of both sides. Each step restores them, lets the class put or take one datagram, and reads the fields again.
"""

import contextlib
import itertools
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import NamedTuple

from protocol_model import datagrams as model
from protocol_model.datagrams import NO_SESSION, RING, Rules
from protocol_model.exploration import Exploration, Fault, explore
from unity_link.errors import ConnectError
from unity_link.protocol.gateway.datagrams import GatewayDatagrams, Requester
from unity_link.protocol.host.datagrams import HostDatagrams
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.messages import Codec

CODEC = Codec(GatewayInfo())
QUESTION, OPENING = b"Q\r", b"K000\r"
ASKED, OPENING_TAKEN = b"Q\r\n", b"K000\r\n"
"""The same frames as the gateway executes them: with a line end that no cut can remove."""
OPENED = b"K000\n"
CONFIGURATION = CODEC.framing.plain_reply(b"Q" + GatewayInfo().to_hex())

Network = frozenset[tuple[bytes, int]]
"""Datagrams in the network, each with the host's port."""


class HostSide(NamedTuple):
    """The fields of `HostDatagrams`."""

    session: int = NO_SESSION
    offer: int = NO_SESSION
    sent: int = 0
    taken: int = 0


class GatewaySide(NamedTuple):
    """The fields of `GatewayDatagrams`."""

    session: int = NO_SESSION
    opener: int | None = None
    offer: int = NO_SESSION
    sent: int = 0
    taken: int = 0
    asker: Requester[int] | None = None


class State(NamedTuple):
    """State of both sides and the network; `frames` is the model's, whose headers and networks are not used."""

    frames: model.State
    host: HostSide = HostSide()
    gateway: GatewaySide = GatewaySide()
    out: Network = frozenset()
    back: Network = frozenset()


def explored(rules: Rules) -> Exploration:
    """Explore the rules; `Rules.naming` is ignored because the classes number the sessions."""
    start = State(model.State(model.Host(), model.Gateway()))
    return explore(
        start,
        lambda state: _moves(rules, state),
        lambda state: state.frames.host.first == rules.requests,
        always_ends=False,
    )


@contextlib.contextmanager
def nothing_remembered() -> Iterator[None]:
    """Clear the caches of the steps before and after a block in which the classes are changed."""
    remembered = _put_by_host, _taken_by_host, _taken_by_gateway, _put_by_gateway
    for step in remembered:
        step.cache_clear()
    yield
    for step in remembered:
        step.cache_clear()


def _moves(rules: Rules, state: State) -> Iterator[tuple[str, State | Fault]]:
    yield from _host_moves(rules, state)
    for datagram, port in sorted(state.out):
        taken = _take(rules, state, datagram, port)
        if taken is not None:
            yield f"the gateway takes {datagram!r} from port {port}", taken
    for datagram, port in sorted(state.back):
        if port == state.frames.host.port:
            yield f"the host hears {datagram!r}", _hear(rules, state, datagram)
    if state.frames.resets < rules.resets:
        frames = state.frames
        after_reset = frames._replace(gateway=model.Gateway(executed=frames.gateway.executed), resets=frames.resets + 1)
        yield "the gateway is reset", state._replace(frames=after_reset, gateway=GatewaySide())


# The host


def _host_moves(rules: Rules, state: State) -> Iterator[tuple[str, State]]:
    host = state.frames.host
    if host.beginnings < rules.beginnings and state.host != HostSide():
        yield "the host begins anew", _begin_anew(rules, state)
    if state.host.session == NO_SESSION:
        yield "the host asks", _sent(state, QUESTION)
        if state.host.offer == NO_SESSION:
            return
    if state.host.sent == rules.datagrams:
        return
    if not host.ready:
        begun = state._replace(frames=state.frames._replace(host=host._replace(offset=-host.next % RING)))
        yield "the host sends K", _sent(begun, OPENING)
        return
    for number in range(host.first, min(host.next + 1, host.first + model.WINDOW, rules.requests)):
        issued = host._replace(next=max(host.next, number + 1))
        request = b"w%d%d\n" % ((number + host.offset) % RING, number)
        yield (
            f"the host sends request {number}",
            _sent(state._replace(frames=state.frames._replace(host=issued)), request),
        )


def _begin_anew(rules: Rules, state: State) -> State:
    host = state.frames.host
    anew = model.Host(first=host.next, next=host.next, port=host.port + rules.new_ports, beginnings=host.beginnings + 1)
    return state._replace(frames=state.frames._replace(host=anew), host=HostSide())


def _sent(state: State, frames: bytes) -> State:
    side, datagrams = _put_by_host(state.host, frames)
    return state._replace(host=side, out=state.out | {(datagram, state.frames.host.port) for datagram in datagrams})


def _hear(rules: Rules, state: State, datagram: bytes) -> State | Fault:
    side, frames = _taken_by_host(state.host, datagram)
    if frames is None:
        return _begin_anew(rules, state) if state.frames.host.beginnings < rules.beginnings else state
    heard = state._replace(host=side)
    if not frames or frames == CONFIGURATION:
        return heard
    after = model._told(state.frames.host, _answer(frames), state.frames.gateway.executed)
    return after if isinstance(after, Fault) else heard._replace(frames=state.frames._replace(host=after))


def _answer(frames: bytes) -> model.Datagram:
    if frames == OPENED:
        return model.Datagram(0, 0, "k")
    kind = "n" if frames[:1] == b"n" else "answer"
    return model.Datagram(0, 0, kind, int(frames[1:2]), -1 if kind == "n" else int(frames[2:3]))


@lru_cache(None)
def _put_by_host(fields: HostSide, frames: bytes) -> tuple[HostSide, list[bytes]]:
    side = _host_side(fields)
    datagrams = side.put(frames)
    return _of_host(side), datagrams


@lru_cache(None)
def _taken_by_host(fields: HostSide, datagram: bytes) -> tuple[HostSide, bytes | None]:
    """Return the fields of the host and the frames of a datagram; None if the session has ended."""
    side = _host_side(fields)
    try:
        frames = side.take(datagram)
    except ConnectError:
        return fields, None
    return _of_host(side), frames


def _host_side(fields: HostSide) -> HostDatagrams:
    side = HostDatagrams()
    side.session, side.offer, side.counts.sent, side.counts.taken = fields
    return side


def _of_host(side: HostDatagrams) -> HostSide:
    return HostSide(side.session, side.offer, side.counts.sent, side.counts.taken)


# The gateway


def _take(rules: Rules, state: State, datagram: bytes, port: int) -> State | Fault | None:
    """Return the state after a datagram, or None if it needs more sessions than are explored."""
    frames = state.frames
    side, requests, sent, drawn = _taken_by_gateway(state.gateway, datagram, port, frames.named + 1)
    frames = frames._replace(named=frames.named + drawn)
    for request in requests:
        response = CONFIGURATION
        if request != ASKED:
            after = model._execute(rules, frames, frames.gateway, _request(request))
            if isinstance(after, Fault):
                return after
            (answer,) = after.back
            frames = after._replace(gateway=after.gateway._replace(sent=0), back=frozenset())
            response = _response(answer)
        side, answers, drawn = _put_by_gateway(side, response, frames.named + 1)
        sent |= answers
        frames = frames._replace(named=frames.named + drawn)
    if frames.named > rules.sessions:
        return None
    return state._replace(frames=frames, gateway=side, back=state.back | sent)


@lru_cache(None)
def _taken_by_gateway(
    fields: GatewaySide, datagram: bytes, port: int, next_named: int
) -> tuple[GatewaySide, list[bytes], Network, int]:
    """Return the gateway's fields, the requests to execute, the datagrams sent and the count of drawn numbers."""
    named = itertools.count(next_named)
    requests: list[bytes] = []
    side, sent = _gateway_side(fields, requests.append, named)
    side.take(datagram, port)
    return _of_gateway(side), requests, frozenset(sent), next(named) - next_named


@lru_cache(None)
def _put_by_gateway(fields: GatewaySide, frames: bytes, next_named: int) -> tuple[GatewaySide, Network, int]:
    named = itertools.count(next_named)
    side, sent = _gateway_side(fields, lambda _: None, named)
    side.put(frames)
    return _of_gateway(side), frozenset(sent), next(named) - next_named


def _gateway_side(
    fields: GatewaySide, execute: Callable[[bytes], None], named: Iterator[int]
) -> tuple[GatewayDatagrams[int], set[tuple[bytes, int]]]:
    sent: set[tuple[bytes, int]] = set()
    side: GatewayDatagrams[int] = GatewayDatagrams(
        CODEC, execute, lambda *answer: sent.add(answer), lambda: next(named)
    )
    side.session, side.opener, side.offer, side.counts.sent, side.counts.taken, side.requester = fields
    return side, sent


def _of_gateway(side: GatewayDatagrams[int]) -> GatewaySide:
    return GatewaySide(side.session, side.opener, side.offer, side.counts.sent, side.counts.taken, side.requester)


def _request(frames: bytes) -> model.Datagram:
    if frames == OPENING_TAKEN:
        return model.Datagram(0, 0, "K")
    return model.Datagram(0, 0, "w", int(frames[1:2]), int(frames[2:3]))


def _response(answer: model.Datagram) -> bytes:
    if answer.kind == "k":
        return OPENED
    return b"w%d%d\n" % (answer.ident, answer.number) if answer.kind == "answer" else b"n%d\n" % answer.ident
