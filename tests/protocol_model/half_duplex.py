"""A model of a half-duplex line: the frames that the host and the addressed node send, and when.

A transmission has a beginning and an end; if the other side begins between them, both frames are damaged. The letters
represent kinds of requests: `r` has one answer, `g` publishes a sample and has a response, `p` is posted and fails,
which causes an error frame, and `b` is addressed to all nodes, so no node answers.
"""

from collections.abc import Iterator
from typing import NamedTuple

from protocol_model.exploration import Exploration, Fault, explore

OWED = "rg"
"""The requests that have a response; a posted request is answered only if it fails."""


class Rules(NamedTuple):
    """Rules that keep both sides from sending at once; each rule is necessary."""

    waits: bool = True
    """The host does not send while an answer is pending."""
    kinds: str = "rgb"
    """Requests of the host; by default none is posted to a single node."""
    response_last: bool = True
    """If true, the node sends the response after all other frames that a request causes."""
    patient: bool = True
    """The host gives up an answer only when it can no longer arrive."""
    requests: int = 3


class State(NamedTuple):
    """The host, the node and the line between them."""

    begun: int = 0
    owed: bool = False
    host_sends: str = ""
    """The request that the host is sending."""
    node_sends: str = ""
    """The frame that the node is sending: `P` a sample, `x` an error, `a` a response."""
    pending: str = ""
    """Frames that the node will send."""


def explored(rules: Rules) -> Exploration:
    """Explore the rules."""
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
    """Return the possible sequences of frames that a node answers with."""
    if kind == "g":
        return ("Pa",) if rules.response_last else ("Pa", "aP")
    return ({"r": "a", "p": "x", "b": ""}[kind],)


def _alone(state: State) -> State | Fault:
    return Fault("both send at once") if state.host_sends and state.node_sends else state
