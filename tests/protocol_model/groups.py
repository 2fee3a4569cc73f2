"""A model of a group that one holder after another uses, while samples wait in the gateway's buffer.

Each holder sets up the group for its own addresses, starts it and stops it. A holder that sets the group up again after
a reset counts as the next holder. The line keeps the order of frames and may lose any of them. The gateway buffers
samples apart from responses and may send either first, except for the rule that is explored: the response to a group
command, or to K, follows every sample that was taken before it.

The host sends one request at a time and retransmits it until it is answered; `stream` proves that it is executed once.
"""

from collections.abc import Iterator
from typing import NamedTuple

from protocol_model.exploration import Exploration, Fault, explore

NOBODY = -1


class Rules(NamedTuple):
    """Rules of a version of the protocol, and limits of the exploration."""

    in_order: bool = True
    """The rule of the docstring above, which protocol 02 has and 01 has not."""
    stops: bool = True
    """A holder stops its group before it releases it; otherwise the next holder's settings stop it."""
    holders: int = 3
    buffered: int = 2
    """Largest number of samples in the gateway's buffer."""
    in_line: int = 2
    """Largest number of frames on the line to the host."""
    resets: int = 1


class Request(NamedTuple):
    """A group command, or K, of a holder."""

    command: str
    holder: int


class Gateway(NamedTuple):
    """The gateway, with the one group."""

    in_session: bool = False
    last: Request | None = None
    """The last executed request; a request equal to it is a repetition."""
    holder: int = NOBODY
    """Holder whose addresses the group has."""
    running: bool = False
    buffer: tuple[int, ...] = ()
    """The buffered samples, each as the holder whose addresses it was read from."""
    response: Request | None = None
    """Request whose response is pending: the gateway executes one request at a time."""
    ahead: int = 0
    """Number of buffered samples that are sent before the response."""


class Host(NamedTuple):
    """The host: the current holder, its command in flight, and the holder that receives samples."""

    holder: int = 0
    command: str = "K"
    listener: int = NOBODY


class State(NamedTuple):
    """State of host, gateway and line; the line to the gateway holds at most one request."""

    host: Host
    gateway: Gateway
    out: Request | None = None
    back: tuple[Request | int, ...] = ()
    """Answers and samples."""
    resets: int = 0


def explored(rules: Rules, sought: str = "") -> Exploration:
    """Explore the rules; if `sought` is given, pass over all other faults."""
    return explore(
        State(Host(), Gateway()),
        lambda state: _moves(rules, state),
        lambda state: state.host.holder >= rules.holders,
        sought=sought,
    )


def _moves(rules: Rules, state: State) -> Iterator[tuple[str, State | Fault]]:
    host, gateway = state.host, state.gateway
    if state.out is None and host.holder < rules.holders:
        request = Request(host.command, host.holder)
        yield f"the host sends {_show(request)}", state._replace(out=request)
    if state.out is not None:
        yield f"lost on the way out: {_show(state.out)}", state._replace(out=None)
        if gateway.response is None:
            after = _executed(gateway, state.out)
            yield f"the gateway executes {_show(state.out)}", state._replace(gateway=after, out=None)
    if gateway.running and len(gateway.buffer) < rules.buffered:
        after = gateway._replace(buffer=(*gateway.buffer, gateway.holder))
        yield f"the gateway takes {_show(gateway.holder)}", state._replace(gateway=after)
    yield from _sendings(rules, state)
    if state.back:
        first, rest = state.back[0], state.back[1:]
        yield f"lost on the way back: {_show(first)}", state._replace(back=rest)
        heard = _heard(rules, host, first)
        after_it = heard if isinstance(heard, Fault) else state._replace(host=heard, back=rest)
        yield f"the host hears {_show(first)}", after_it
    if state.resets < rules.resets:
        yield "the gateway is reset", state._replace(gateway=Gateway(), resets=state.resets + 1)


def _show(frame: Request | int) -> str:
    if isinstance(frame, int):
        return f"a sample for holder {frame}"
    return f"{frame.command} of holder {frame.holder}"


# The gateway


def _executed(gateway: Gateway, request: Request) -> Gateway:
    """Return the gateway after it executed a request; its response is then pending."""
    command, holder = request
    if command == "K":
        return gateway._replace(in_session=True, last=None, running=False, response=request, ahead=len(gateway.buffer))
    if not gateway.in_session:
        return gateway._replace(response=Request("no session", holder), ahead=0)
    if request == gateway.last:
        return gateway._replace(response=request, ahead=0)
    if command == "GS":
        gateway = gateway._replace(holder=holder)
    return gateway._replace(last=request, running=command == "GN", response=request, ahead=len(gateway.buffer))


def _sendings(rules: Rules, state: State) -> Iterator[tuple[str, State]]:
    gateway = state.gateway
    if len(state.back) == rules.in_line:
        return
    if gateway.buffer:
        sample, rest = gateway.buffer[0], gateway.buffer[1:]
        after = gateway._replace(buffer=rest, ahead=max(gateway.ahead - 1, 0))
        yield f"the gateway sends {_show(sample)}", state._replace(gateway=after, back=(*state.back, sample))
    if gateway.response is not None and not (rules.in_order and gateway.ahead):
        after = gateway._replace(response=None, ahead=0)
        answered = state._replace(gateway=after, back=(*state.back, gateway.response))
        yield f"the gateway answers {_show(gateway.response)}", answered


# The host


def _heard(rules: Rules, host: Host, frame: Request | int) -> Host | Fault:
    """Return the host after a frame of the gateway."""
    if isinstance(frame, int):
        if host.listener not in (NOBODY, frame):
            return Fault(f"a sample for holder {frame} reaches holder {host.listener}")
        return host
    if frame.command == "no session":
        return Host(host.holder + 1)
    if frame != Request(host.command, host.holder):
        return host
    following = {"K": "GS", "GS": "GN", "GN": "GX" if rules.stops else "", "GX": ""}[host.command]
    if not following:
        return Host(host.holder + 1, "GS", host.listener)
    return Host(host.holder, following, host.holder if host.command == "GS" else host.listener)
