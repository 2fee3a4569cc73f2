"""A medium on which only one may send at a time: what the host and the addressed node send, and when.

Sending takes time here: it has a beginning and an end, and if the other begins between them, both are damaged. Requests
stand for all of their kind: `r` has one answer, `g` publishes a sample beside its response, `p` is posted and ends in
an error, which is answered, and `b` is for all nodes, of which none answers.
"""

from collections.abc import Iterator
from typing import NamedTuple

from protocol_model.exploration import Exploration, Fault, explore

OWED = "rg"
"""The requests that have a response: a posted one is answered only where it fails."""


class Rules(NamedTuple):
    """Rules that keep both from sending at once; each is needed."""

    waits: bool = True
    """The host sends nothing while an answer is owed."""
    kinds: str = "rgb"
    """Messages of the host: nothing posted to one node."""
    response_last: bool = True
    """True if the node sends its response behind all else that a request causes."""
    patient: bool = True
    """An answer is given up only when it cannot come any more."""
    requests: int = 3


class State(NamedTuple):
    """The host, the node and the line between them."""

    begun: int = 0
    owed: bool = False
    host_sends: str = ""
    """The request that is on its way."""
    node_sends: str = ""
    """The frame that is on its way: `P` a sample, `x` an error, `a` a response."""
    pending: str = ""
    """Messages that the node is going to send."""


def explored(rules: Rules) -> Exploration:
    """Return what happens under the rules."""
    return explore(State(), lambda state: _moves(rules, state), lambda state: state.begun == rules.requests)


def _moves(rules: Rules, state: State) -> Iterator[tuple[str, State | Fault]]:
    if not state.host_sends and state.begun < rules.requests and not (rules.waits and state.owed):
        for kind in rules.kinds:
            begun = state._replace(begun=state.begun + 1, host_sends=kind, owed=state.owed or kind in OWED)
            yield f"the host begins to send {kind}", _alone(begun)
    if state.host_sends:
        kind, sent = state.host_sends, state._replace(host_sends="")
        yield f"{kind} is lost", sent
        for frames in _answers(rules, kind):
            yield (
                f"{kind} arrives, to be answered by {frames or 'nothing'}",
                sent._replace(pending=state.pending + frames),
            )
    if state.pending and not state.node_sends:
        begins = state._replace(node_sends=state.pending[0], pending=state.pending[1:])
        yield f"the node begins to send {begins.node_sends}", _alone(begins)
    if state.node_sends:
        yield f"{state.node_sends} is lost", state._replace(node_sends="")
        yield f"{state.node_sends} arrives", state._replace(node_sends="", owed=state.owed and state.node_sends != "a")
    if state.owed and not (rules.patient and (state.host_sends or state.node_sends or state.pending)):
        yield "the host gives the answer up", state._replace(owed=False)


def _answers(rules: Rules, kind: str) -> tuple[str, ...]:
    """Return the ways in which a node may answer."""
    if kind == "g":
        return ("Pa",) if rules.response_last else ("Pa", "aP")
    return ({"r": "a", "p": "x", "b": ""}[kind],)


def _alone(state: State) -> State | Fault:
    return Fault("both send at once") if state.host_sends and state.node_sends else state
