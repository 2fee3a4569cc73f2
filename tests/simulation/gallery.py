"""Known bugs, each put back into the living code, one at a time: the proof that the simulation can fail.

A bug that was found and mended is put back as it was. Some stand for a whole class: what the window, the sequence, the
groups, the server or the model would do if one line of theirs were forgotten. `make campaign` puts each back and
runs worlds until one of them breaks a rule.
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from unity_link.link.exchange import FEWEST_PUBLISHES, PublishRows
from unity_link.link.requests import Request

from simulation.world import KNOWN
from unity_link.bridges.serve import client, shared
from unity_link.bridges.serve import groups as served_groups
from unity_link.bridges.serve import requests as served_requests
from unity_link.errors import LinkLostError, Outcome
from unity_link.link import exchange, link, requests, subscription
from unity_link.protocol import reception, window
from unity_link.protocol.messages import COMMANDS, Repetition
from unity_link.protocol.reception import SequencePlace
from unity_link.transport import stream
from unity_link.virtual import bus, transport

if TYPE_CHECKING:
    from collections.abc import Callable

    import pytest


class Bug(NamedTuple):
    """One bug."""

    name: str
    put_back: Callable[[pytest.MonkeyPatch], None]
    features: frozenset[str] = frozenset()
    """Features of worlds that `KNOWN` leaves out, and that this bug needs."""

    def without(self) -> frozenset[str]:
        """Return the features that are left out of the worlds."""
        return KNOWN - self.features


BUGS: list[Bug] = []
UNSEEN = frozenset(
    {
        "a restored group takes another's addresses",
        "a server gives a slot away that still publishes for another client",
        "samples in bursts reach the subscriber of another group",
    }
)
"""Bugs that 700 seeds did not show: the worlds have too few bursts, and too few groups that change hands, for them."""


def bug(
    name: str, *features: str
) -> Callable[[Callable[[pytest.MonkeyPatch], None]], Callable[[pytest.MonkeyPatch], None]]:
    """Put a function that puts a bug back into the gallery."""

    def keep(put_back: Callable[[pytest.MonkeyPatch], None]) -> Callable[[pytest.MonkeyPatch], None]:
        BUGS.append(Bug(name, put_back, frozenset(features)))
        return put_back

    return keep


# Found in reviews and by this simulation, and put back as they were


@bug("a restored group takes another's addresses")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    async def set_up(self: Any, group: int, held: Any) -> None:
        schedule = held.schedule
        addresses = np.array(schedule.addresses, np.uint64)
        settings = (int(schedule.flags), schedule.divisor, len(addresses), addresses)
        await self._submit("GS", group, *settings, kind=requests.OfSession)
        if self._held.get(group) is held:
            held.restart()
            self._exchange.publishes[b"%02X" % group] = held.receive
            self._exchange.publish_rows[b"P%02X" % group] = PublishRows(held.length, held.receive_rows)
            await self._submit("GN", group, kind=requests.OfSession)

    monkeypatch.setattr(subscription.HeldGroups, "_set_up", set_up)


@bug(
    "a client that leaves while groups are restored ends the server", "clients that leave while a server sets up groups"
)
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    async def restore(self: Any) -> None:
        for slot in list(self.slots.held):
            group = slot.group
            slot.stopping = False
            if slot.idle():
                self.slots.let_go(slot)
            elif group is not None:
                await self._ask("GS", slot.text + group.settings)
                group.begin_anew(self.loop.time() - self._lost_at)
                if group.running:
                    self.slots.listen(slot)
                    await self._ask("GN", slot.text)
        self.away = False
        self.turns.release()
        if self._patience is not None:
            self._patience.cancel()
            self._patience = None

    monkeypatch.setattr(shared.SharedLink, "_restore", restore)


@bug("samples in bursts reach the subscriber of another group")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def receive_publishes(self: Any, data: bytes, start: int, now: float) -> int:
        framing = self._codec.framing
        wanted = self.publish_rows.get(data[start : start + len(framing.prefix) + 3][-3:])
        if wanted is None:
            return start
        size = wanted.size + framing.overhead
        while (count := (len(data) - start) // size) >= FEWEST_PUBLISHES:
            head = data[start : start + len(framing.prefix) + 3]
            rows = np.frombuffer(data, np.uint8, count * size, start).reshape(count, size)
            bodies = framing.open_rows(rows, head)
            taken = wanted.take(bodies, now) if len(bodies) >= FEWEST_PUBLISHES else 0
            if not taken:
                break
            start += taken * size
        return start

    monkeypatch.setattr(exchange.Exchange, "_receive_publishes", receive_publishes)


@bug("a fence does not wait for batches", "fences behind batches")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    async def fence(self: Any) -> None:
        self._posted = False
        await self._ask("H")
        first, count = self._posted_error, self._posted_failures
        self._posted_error, self._posted_failures = None, 0
        if first is not None:
            if count > 1:
                first.add_note(f"{count - 1} more posted writes failed as well")
            raise first

    monkeypatch.setattr(link.Link, "fence", fence)


@bug("a fence that is cancelled leaves the posted writes unconfirmed at the exit", "fences that fail")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    fence = link.Link.fence

    async def forgetting(self: Any) -> None:
        self._posted = False
        try:
            await fence(self)
        finally:
            self._posted = False

    monkeypatch.setattr(link.Link, "fence", forgetting)


@bug("the exit of a lost link says nothing of posted writes", "exits of lost links")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    async def leave(self: Any, kind: Any, error: Any, trace: Any) -> None:
        try:
            if error is None and self._posted and not self._closed:
                await self.fence()
        finally:
            await self.aclose()

    monkeypatch.setattr(link.Link, "__aexit__", leave)


@bug("what sets a session up waits for the next one")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def suspend(self: Any, reason: str) -> None:
        self._stop()
        again = self._end_sent(LinkLostError(reason), keep=True)
        self._waiting.extendleft(reversed(again))

    monkeypatch.setattr(exchange.Exchange, "suspend", suspend)


@bug(
    "a group that is set up again counts samples by its old number",
    "counts of groups that are set up again",
)
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    set_up = subscription.HeldGroups._set_up

    async def twice(self: Any, group: int, held: Any) -> None:
        await set_up(self, group, held)

    monkeypatch.setattr(subscription.HeldGroups, "_set_up", twice)


def _nothing(_: pytest.MonkeyPatch) -> None:
    """Put nothing back: it is there."""


# These are of the protocol, version 01, or not mended yet: the worlds that show them are left out by `KNOWN`.
BUGS += [
    Bug("a reset behind an open line", _nothing, frozenset({"resets behind open lines"})),
]


@bug("the time of samples goes back where the gateway was reset", "time over a reset")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    start = subscription.HeldGroups.start

    def anew(self: Any, codec: Any) -> None:
        start(self, codec)
        self.clock = subscription.GatewayClock(codec.info.clock_hz)

    monkeypatch.setattr(subscription.HeldGroups, "start", anew)


@bug("a batch of reads ends at its first error", "reads behind an error")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(requests.BatchSource, "unwanted", lambda self: self._batch.future.done())
    monkeypatch.setattr(requests.BatchRun, "unwanted", lambda self: self.given_up or self._batch.future.done())
    monkeypatch.setattr(requests.Batch, "fail", _fail_at_once)


def _fail_at_once(self: Any, error: Any) -> None:
    if not self.future.done():
        self.future.set_exception(error)


# The window and the requests: what the host does


@bug("writes are sent again in a new session")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def again(self: Any, offset: int, count: int) -> Any:
        self.frame = b""
        return self

    monkeypatch.setattr(Request, "again", again)


@bug("a batch of reads goes on at another place in a new session")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def again(self: Any, offset: int, count: int) -> Any:
        if self.command != "R":
            return None
        return requests.BatchSource(self._batch, offset, offset + count)

    monkeypatch.setattr(requests.BatchRun, "again", again)


@bug("what was not sent when the connection was lost is forgotten")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def suspend(self: Any, reason: str) -> None:
        self._stop()
        self._end_sent(LinkLostError(reason), keep=False)
        self._waiting.clear()

    monkeypatch.setattr(exchange.Exchange, "suspend", suspend)


@bug("requests that were under way are said not to be executed")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    known = SimpleNamespace(UNKNOWN=Outcome.NOT_EXECUTED, EXECUTED=Outcome.EXECUTED, NOT_EXECUTED=Outcome.NOT_EXECUTED)
    monkeypatch.setattr(exchange, "Outcome", known)


@bug("the window runs over the whole ring")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    made = window.Window.__init__

    def make(self: Any, ring: int, *args: Any, **kwargs: Any) -> None:
        made(self, ring, *args, **kwargs)
        self._half = self._allowed = ring - 1

    monkeypatch.setattr(window.Window, "__init__", make)


@bug("a repetition leaves out what nobody waits for")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def repeat(self: Any) -> None:
        for _, run, offset, count in self._window.repetition():
            if self._stream is not None and not run.unwanted():
                self._stream.send_soon(run.encode(offset, count))

    monkeypatch.setattr(exchange.Exchange, "_repeat", repeat)


@bug("each answer to a repetition is taken for a sign of loss")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    answered = window.Window.answered

    def going_back(self: Any, number: int, count: int, now: float) -> None:
        answered(self, number, count, now)
        if self.oldest != self.next and self._gone_back:
            self._repeat_from_oldest(now)

    monkeypatch.setattr(window.Window, "answered", going_back)


@bug("errors of posted writes are told to nobody")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(requests.Posted, "fail", lambda self, error: None)


@bug("posted writes are not confirmed")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(window.Window, "needs_fence", lambda self, now: False)


@bug("the timer is not set again after a repetition")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    tick = exchange.Exchange._tick

    def once(self: Any) -> None:
        tick(self)
        if self._timer is not None:
            self._timer.cancel()

    monkeypatch.setattr(exchange.Exchange, "_tick", once)


@bug("an answer confirms what comes behind it")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    out_of_sequence = window.Window.out_of_sequence
    monkeypatch.setattr(
        window.Window,
        "out_of_sequence",
        lambda self, expected, now: out_of_sequence(self, expected + 1 & self._mask, now),
    )


@bug("answers to a batch are put in one place too far")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    put = requests.Batch.put

    def shifted(self: Any, offset: int, words: Any) -> None:
        put(self, offset, words[::-1])

    monkeypatch.setattr(requests.Batch, "put", shifted)


@bug("what is sent while the transport is full is dropped")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def receive_posted(self: Any, data: bytes) -> None:
        self._out.append(data[: len(data) // 2] if len(self._out) > 3 else data)
        if not self._flushing and not self._paused:
            self._flushing = True
            self._loop.call_soon(self._flush)

    monkeypatch.setattr(stream.Stream, "send_soon", receive_posted)


@bug("the beginning of a frame is lost between two reads")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    received = stream.Stream.data_received

    def forgetting(self: Any, data: bytes) -> None:
        received(self, data)
        if self.bytes_received > 2000:
            self._rest = b""

    monkeypatch.setattr(stream.Stream, "data_received", forgetting)


# Samples


@bug("lost samples are counted one too few where the number goes round")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    count_lost = subscription.Subscription._count_lost

    def counted(self: Any, sequence: int, at: float | None) -> int:
        lost: int = count_lost(self, sequence, at)
        return max(0, lost - 1)

    monkeypatch.setattr(subscription.Subscription, "_count_lost", counted)


@bug("samples that a full buffer drops are not counted")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def following(self: Any) -> Any:
        self._dropped = 0
        return self._buffer.popleft()

    monkeypatch.setattr(subscription.Subscription, "_next", following)


@bug("the newest sample is dropped instead of the oldest")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    keep = subscription.Subscription._keep

    def kept(self: Any, sample: Any) -> None:
        if self._callback is None and len(self._buffer) == self._buffer_size:
            self.received += 1
            return
        keep(self, sample)

    monkeypatch.setattr(subscription.Subscription, "_keep", kept)


# The gateway's side


@bug("a repetition is executed again")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    place = reception.Sequence.place

    def forgetting(self: Any, number: int) -> SequencePlace:
        found = place(self, number)
        return (
            SequencePlace.NEXT
            if found is SequencePlace.REPETITION and number + 1 & self.mask == self.expected
            else found
        )

    monkeypatch.setattr(reception.Sequence, "place", forgetting)


@bug("a request is executed though one before it was lost")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    place = reception.Sequence.place

    def careless(self: Any, number: int) -> SequencePlace:
        if number == self.expected + 1 & self.mask:
            self.advance(2)
            return SequencePlace.NEXT
        return place(self, number)

    monkeypatch.setattr(reception.Sequence, "place", careless)


@bug("a queue is read again for a repetition")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(COMMANDS, "RQ", COMMANDS["RQ"]._replace(repetition=Repetition.READ_AGAIN))


@bug("a masked write is executed again for a repetition")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(COMMANDS, "WK", COMMANDS["WK"]._replace(repetition=Repetition.READ_AGAIN))


@bug("the words of a sample are read one after the other")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def read_words(self: Any, addresses: Any, now: float) -> list[int]:
        return [self.read(address, now + 1e-4 * place) for place, address in enumerate(addresses)]

    monkeypatch.setattr(bus.ModelBus, "read_words", read_words)


@bug("the virtual gateway's transport drops what one turn cannot hold")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(transport, "MOST_DELIVERED", 64)
    collect = transport.GatewayTransport._collect

    def dropping(self: Any, data: bytes) -> None:
        collect(self, data)
        del self._to_protocol[64:]

    monkeypatch.setattr(transport.GatewayTransport, "_collect", dropping)


# The server


@bug("a server sends writes again to a gateway that comes back")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def again(self: Any, offset: int, count: int) -> Any:
        self._frame = b""
        return self

    monkeypatch.setattr(served_requests.Relayed, "again", again)


@bug("a server leaves rows of requests unanswered while the gateway is away")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(served_requests.RelayedRows, "refuse", lambda self: None)


@bug("a server gives a slot away that still publishes for another client")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def silence(self: Any, slot: Any) -> None:
        """Leave the publishes to whoever had them."""

    monkeypatch.setattr(served_groups.Slots, "silence", silence)
    monkeypatch.setattr(
        served_groups.Slots, "listen", lambda self, slot: self._publishes.setdefault(slot.text, slot.group.receive)
    )


@bug("a server hands a client's requests on in turns of one too many")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def answer(self: Any, offset: int, count: int, frames: bytes) -> None:
        self._early[self.answered] = (count, frames)
        self.asker.answer_rows(self)

    monkeypatch.setattr(served_requests.RelayedRows, "answer", answer)


@bug("a server answers what it refuses before what is under way")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(client.Client, "say", lambda self, frame: self.write(frame))


@bug("a server takes a client's numbers for its own")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    begin = served_groups.ClientGroup.begin

    def one_more(self: Any, settings: Any, seconds_missed: float) -> None:
        begin(self, settings, seconds_missed)
        self._offset = self._offset + 1 & 0xFF

    monkeypatch.setattr(served_groups.ClientGroup, "begin", one_more)
