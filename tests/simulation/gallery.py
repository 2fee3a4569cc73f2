"""Known bugs, each put back into the living code, one at a time: the proof that the simulation can fail.

A bug that was found and mended is put back as it was. Some stand for a whole class: what the window, the sequence, the
groups, the server or the model would do if one line of theirs were forgotten. `make campaign` puts each back and
runs worlds until one of them breaks a rule.
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, NamedTuple

from unity_link.bridges.serve import client, shared
from unity_link.bridges.serve import groups as served_groups
from unity_link.bridges.serve import requests as served_requests
from unity_link.errors import Outcome
from unity_link.link import connection, flow, gateway_clock, link, publishing
from unity_link.protocol.gateway import datagrams as gateway_datagrams
from unity_link.protocol.gateway import reception
from unity_link.protocol.gateway import session as gateway_session
from unity_link.protocol.gateway.reception import SequencePlace
from unity_link.protocol.host import batches, group_table, host_codec, receiver, requests, session
from unity_link.protocol.host.events import SampledRows
from unity_link.protocol.window import retransmission, window
from unity_link.protocol.wire import arrays, datagrams
from unity_link.protocol.wire.frames import FrameError
from unity_link.protocol.wire.messages import COMMANDS, Repeat
from unity_link.transport import stream
from unity_link.virtual import bus, transport

if TYPE_CHECKING:
    from collections.abc import Callable

    import pytest


class Bug(NamedTuple):
    """One bug."""

    name: str
    put_back: Callable[[pytest.MonkeyPatch], None]


BUGS: list[Bug] = []
UNSEEN = frozenset(
    {
        "samples in bursts reach the subscriber of another group",
        "a reset is believed of a damaged request",
        "a datagram of a former session is executed",
        "a server leaves rows of requests unanswered while the gateway is away",
    }
)
"""Bugs that no world shows. Tests of their own find them, in this order:

- `test_samples_of_two_groups_in_bursts_reach_the_subscription_that_asked_for_them`: bursts in worlds are of one group;
- `test_a_gateway_without_a_session_that_refuses_a_damaged_request_says_nothing_of_the_one_it_names`: what a reset meets
  is seldom damaged;
- `test_datagrams_of_an_earlier_session_that_come_again_are_neither_executed_nor_taken`: the checks of their frames have
  that session in them as well;
- `test_batch_cut_by_a_reset_gets_one_true_outcome_for_each_request`: a client asks
  again, and is answered then.
"""


def bug(name: str) -> Callable[[Callable[[pytest.MonkeyPatch], None]], Callable[[pytest.MonkeyPatch], None]]:
    """Put a function that puts a bug back into the gallery."""

    def keep(put_back: Callable[[pytest.MonkeyPatch], None]) -> Callable[[pytest.MonkeyPatch], None]:
        BUGS.append(Bug(name, put_back))
        return put_back

    return keep


# Found by this simulation and otherwise, and put back as they were


@bug("a client that leaves while groups are restored costs the server its connection")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    async def start_again(self: Any, slot: Any) -> None:
        settings = slot.settings
        if settings is not None:
            await self._ask("GS", slot.text + settings.fields)
            self.slots.begin(slot, settings)
            if slot.running:
                await self._ask("GN", slot.text)

    monkeypatch.setattr(shared.SharedLink, "_start_again", start_again)


@bug("samples in bursts reach the subscriber of another group")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def receive_samples(self: Any, data: bytes, start: int, now: float, events: Any) -> int:
        framing = self.codec.framing
        after = len(framing.prefix) + 3
        group = self._groups.begun.get(data[start : start + after][-2:])
        size = 0 if group is None else group.length + framing.overhead
        while size > framing.overhead and (count := (len(data) - start) // size) >= receiver.FEWEST_SAMPLES:
            rows = arrays.rows_of(data, start, count, size)
            bodies = arrays.open_rows(framing, rows, data[start : start + after])
            if len(bodies) < receiver.FEWEST_SAMPLES:
                break
            events.append(SampledRows(group.owner, bodies, now))
            start += len(bodies) * size
        return start

    monkeypatch.setattr(receiver.ResponseReceiver, "_receive_samples", receive_samples)


@bug("a fence does not wait for batches")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(requests.Fence, "earlier", property(lambda self: [], lambda self, sources: None))


@bug("a fence that is cancelled leaves the posted writes unconfirmed at the exit")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    fence = link.Link.fence

    async def forgetting(self: Any) -> None:
        self._posted = False
        try:
            await fence(self)
        finally:
            self._posted = False

    monkeypatch.setattr(link.Link, "fence", forgetting)


@bug("the exit of a lost link says nothing of posted writes")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    async def leave(self: Any, kind: Any, error: Any, trace: Any) -> None:
        try:
            if error is None and self._posted and not self._closed:
                await self.fence()
        finally:
            await self.aclose()

    monkeypatch.setattr(link.Link, "__aexit__", leave)


@bug("what belongs to a session waits for the next one")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(session.Session, "_drop_of_session", lambda self, error, events: None)


@bug("a group that is set up again counts samples by its old number")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    restart = publishing.SampleReceiver.restart

    def going_on(self: Any) -> None:
        before = self._sequence
        restart(self)
        self._sequence = before

    monkeypatch.setattr(publishing.SampleReceiver, "restart", going_on)


@bug("the time of samples goes back where the gateway was reset")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    start = publishing.Publishing.start

    def anew(self: Any, codec: Any) -> None:
        start(self, codec)
        self._clock = gateway_clock.GatewayClock(codec.info.clock_hz)

    monkeypatch.setattr(publishing.Publishing, "start", anew)


@bug("a batch of reads ends at its first error")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    fail_part = batches.BatchRun.fail_part

    def ending(self: Any, offset: int, count: int, error: Any, events: Any) -> None:
        if self.posted:
            fail_part(self, offset, count, error, events)
        else:
            self._batch.fail(error, events)

    monkeypatch.setattr(batches.BatchRun, "fail_part", ending)


# Protocol 02: a gateway that was reset says so


@bug("a group's samples are taken before its settings are stored")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    set_up = group_table.GroupTable.set_up

    def at_once(self: Any, codec: Any, group: Any, events: Any) -> None:
        self.begun[group.text] = group
        set_up(self, codec, group, events)

    monkeypatch.setattr(group_table.GroupTable, "set_up", at_once)


@bug("all that was under way at a reset is said not to be executed")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    unanswered = window.Window.unanswered

    def never(self: Any, refused: int | None = None) -> Any:
        for part in unanswered(self, refused):
            yield part if refused is None else part._replace(outcome=Outcome.NOT_EXECUTED)

    monkeypatch.setattr(window.Window, "unanswered", never)


@bug("a request that was sent again before a reset is said not to be executed")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(retransmission.Retransmission, "never_arrived_from", lambda self, refused: refused)


@bug("a reset is told as an error of one request")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    receive_line = receiver.ResponseReceiver._receive_line

    def taking(self: Any, line: bytes, now: float, events: Any) -> int:
        try:
            body = self.codec.framing.open(line)
        except FrameError:
            body = b""
        after = 1 + self.codec.info.id_digits
        if body[:1] != b"x" or body[after : after + 2] != receiver._NO_SESSION:
            return receive_line(self, line, now, events)
        self._receive_answer(body[: after + 2], now, events)
        return len(line) + 1

    monkeypatch.setattr(receiver.ResponseReceiver, "_receive_line", taking)


@bug("groups are not set up again behind a reset")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    start = group_table.GroupTable.start

    def forgetting(self: Any, codec: Any, events: Any) -> None:
        held, self._held = self._held, {}
        start(self, codec, events)
        self._held = held

    monkeypatch.setattr(group_table.GroupTable, "start", forgetting)


@bug("a server does not end its clients' sessions at a reset")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shared.SharedLink, "_gateway_was_reset", connection.Connection._gateway_was_reset)


# Protocol 03: checks that have the session in them, fates, kept words


@bug("a check does not have the session in it")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (gateway_session, host_codec, reception):
        monkeypatch.setattr(module, "seed_of", lambda session, *, from_gateway: 0)


@bug("a host in doubt does not ask whose the session is")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(session.Session, "_ask_whose", lambda self: None)


@bug("a host takes the line back from another program")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def again(self: Any, lost: Any, now: float, events: Any) -> None:
        self._gateway_was_reset(now, events)

    monkeypatch.setattr(session.Session, "_session_is_over", again)


@bug("a program's session does not shut out what has no ID")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    begin = gateway_session.GatewaySession.begin

    def for_all(self: Any, number: int, first: int, *, for_program: bool = True) -> None:
        begin(self, number, first, for_program=False)

    monkeypatch.setattr(gateway_session.GatewaySession, "begin", for_all)


@bug("a reset is believed of a damaged request")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    has_no_session = receiver.ResponseReceiver._has_no_session

    def believing(self: Any, line: bytes, now: float) -> bool:
        found = has_no_session(self, line, now)
        if found and self.refused is None:
            codec = self.codec
            number = codec.id_number[codec.framing.open(line)[1 : 1 + codec.info.id_digits]]
            self.refused = number if self.window.find(number) is not None else None
        return found

    monkeypatch.setattr(receiver.ResponseReceiver, "_has_no_session", believing)


@bug("a reset while the line was away is not noticed")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(session.Session, "_interrupted", lambda self, error, events: None)


@bug("a request that failed is acknowledged where it is repeated")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reception.Sequence, "fate", lambda self, number: 0)


@bug("the fate of an earlier request is told")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    advance = reception.Sequence.advance

    def keeping(self: Any, count: int = 1) -> None:
        before = bytes(self.fates)
        advance(self, count)
        self.fates[:] = before

    monkeypatch.setattr(reception.Sequence, "advance", keeping)


@bug("posted writes that failed are not counted")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    fail = gateway_session.SessionState.fail

    def uncounted(self: Any, number: int, code: Any, *, posted: bool) -> None:
        fail(self, number, code, posted=False)

    monkeypatch.setattr(gateway_session.SessionState, "fail", uncounted)


@bug("posted writes are told as done whatever the count of those that failed")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    told = window.Window.told

    def believing(self: Any, number: int, failed: int, now: float) -> bool:
        return told(self, number, self.posted_writes.failed, now)

    monkeypatch.setattr(window.Window, "told", believing)


@bug("a gateway keeps fewer words of destructive reads than hosts count on")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gateway_session, "MOST_KEPT_WORDS", 4)


@bug("destructive reads do not wait for those whose words they would replace")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(session.Session, "_overlaps", lambda self, source: False)


# The window and the requests: what the host does


@bug("writes are sent again in a new session")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def again(self: Any, offset: int, count: int) -> Any:
        return None if self.of_session else self

    monkeypatch.setattr(requests.Request, "again", again)


@bug("a batch of reads goes on at another place in a new session")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def again(self: Any, offset: int, count: int) -> Any:
        return batches.BatchPart(self._batch, offset, count) if self.command == "R" else None

    monkeypatch.setattr(batches.BatchRun, "again", again)


@bug("what was not sent when the connection was lost is forgotten")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    end_session = session.Session._end_session

    def forgetting(self: Any, error: Any, events: Any) -> None:
        end_session(self, error, events)
        self._waiting.clear()

    monkeypatch.setattr(session.Session, "_end_session", forgetting)


@bug("requests that were under way are said not to be executed")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    known = SimpleNamespace(UNKNOWN=Outcome.NOT_EXECUTED, EXECUTED=Outcome.EXECUTED, NOT_EXECUTED=Outcome.NOT_EXECUTED)
    monkeypatch.setattr(window, "Outcome", known)


@bug("the window runs over the whole ring")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def room(self: Any, size: int, *, posted: bool = False) -> int:
        return (
            0
            if self.retransmission.is_due()
            else max(0, self.mask - self.in_flight - (posted or self.posted_writes.unfenced > 0))
        )

    monkeypatch.setattr(window.Window, "room", room)


@bug("a repetition leaves out what nobody waits for")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def repeat(self: Any) -> None:
        for _, run, offset, count in self.window.repeat():
            if not run.unwanted():
                self._send(run.frames_of(offset, count))

    monkeypatch.setattr(session.Session, "_repeat", repeat)


@bug("each answer to a repetition is taken for a sign of loss")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    answered = window.Window.answered

    def going_back(self: Any, number: int, count: int, now: float) -> None:
        again = self.retransmission.is_any()
        answered(self, number, count, now)
        if self.oldest != self.next and again:
            self._repeat_from_oldest(now)

    monkeypatch.setattr(window.Window, "answered", going_back)


@bug("errors of posted writes are told to nobody")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(link.Link, "_note_posted", lambda self, failure: None)


@bug("posted writes are not confirmed")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(self: Any, now: float) -> bool:
        self._fence_due = float("inf")
        return False

    monkeypatch.setattr(window.Window, "needs_fence", never)


@bug("a task goes on in the middle of what its link is told")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    tell = flow.Flow._tell

    def tell_and_wake(self: Any, events: Any) -> None:
        tell(self, events)
        self._runtime.wake()

    monkeypatch.setattr(flow.Flow, "_tell", tell_and_wake)


@bug("answers in order are taken without a look at their checks")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def take_frame(self: Any, offset: int, frame: bytes, events: Any) -> bool:
        covered = frame[: -self.codec.framing.ending_size]
        return covered.startswith(self.opening) and self.take_data(covered[len(self.opening) :], events)

    monkeypatch.setattr(requests.Request, "take_frame", take_frame)


@bug("what waits for room is forgotten where an answer comes alone")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    receive_alone = session.Session.receive_alone

    def with_nothing_waiting(self: Any, data: bytes, now: float) -> Any:
        waiting, self._waiting = self._waiting, ()
        try:
            return receive_alone(self, data, now)
        finally:
            self._waiting = waiting

    monkeypatch.setattr(session.Session, "receive_alone", with_nothing_waiting)


@bug("the timer is not set again after a repetition")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    tick = flow.Flow._tick

    def once(self: Any) -> None:
        tick(self)
        if self._timer is not None and self.session.is_open:
            self._timer.cancel()

    monkeypatch.setattr(flow.Flow, "_tick", once)


@bug("an answer confirms what comes behind it")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    out_of_sequence = window.Window.out_of_sequence
    monkeypatch.setattr(
        window.Window,
        "out_of_sequence",
        lambda self, expected, now: out_of_sequence(self, expected + 1 & self.mask, now),
    )


@bug("answers to a batch are put in the opposite order")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    put = batches.WordBatch.put

    def turned(self: Any, offset: int, count: int, words: Any, events: Any) -> None:
        put(self, offset, count, words if count == 1 else words[::-1], events)

    monkeypatch.setattr(batches.WordBatch, "put", turned)


@bug("what is sent while the transport is full is dropped")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    send = stream.Stream.send

    def drop(self: Any, data: bytes) -> None:
        send(self, data[: len(data) // 2] if self.paused else data)

    monkeypatch.setattr(stream.Stream, "send", drop)


@bug("the beginning of a frame is lost between two reads")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    receive = session.Session.receive

    def forgetting(self: Any, data: bytes, now: float) -> Any:
        events = receive(self, data, now)
        if self.is_open:
            self._rest = b""
        return events

    monkeypatch.setattr(session.Session, "receive", forgetting)


# Samples


@bug("lost samples are counted one too few where the number goes round")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    count_lost = publishing.SampleReceiver._count_lost

    def counted(self: Any, sequence: int, at: float | None, now: float) -> int:
        lost: int = count_lost(self, sequence, at, now)
        return max(0, lost - 1)

    monkeypatch.setattr(publishing.SampleReceiver, "_count_lost", counted)


@bug("samples that a full buffer drops are not counted")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def following(self: Any) -> Any:
        self._dropped = 0
        return self.buffer.popleft()

    monkeypatch.setattr(publishing.SampleReceiver, "next", following)


@bug("the newest sample is dropped instead of the oldest")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    keep = publishing.SampleReceiver.keep

    def kept(self: Any, sample: Any) -> None:
        if self._callback is None and len(self.buffer) == self._buffer_size:
            self.received += 1
            return
        keep(self, sample)

    monkeypatch.setattr(publishing.SampleReceiver, "keep", kept)


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
        if self.expected >= 0 and number == self.expected + 1 & self.mask:
            self.advance(2)
            return SequencePlace.NEXT
        return place(self, number)

    monkeypatch.setattr(reception.Sequence, "place", careless)


@bug("a queue is read again for a repetition")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(COMMANDS, "RQ", COMMANDS["RQ"]._replace(repetition=Repeat.READ_AGAIN))


@bug("a masked write is executed again for a repetition")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(COMMANDS, "WK", COMMANDS["WK"]._replace(repetition=Repeat.READ_AGAIN))


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


# Datagrams


@bug("a datagram is taken whether it is newer or not")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(datagrams.Counts, "takes", lambda self, count: True)


@bug("a datagram of a former session is executed")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    take = gateway_datagrams.GatewayDatagrams.take

    def careless(self: Any, datagram: bytes, source: Any) -> None:
        try:
            read = datagrams.read_header(datagram, self._framing)
        except FrameError:
            return
        if read is not None and read.session not in (self.session, self.offer, datagrams.NO_SESSION):
            self._execute(read.frames)
        else:
            take(self, datagram, source)

    monkeypatch.setattr(gateway_datagrams.GatewayDatagrams, "take", careless)


# The server


@bug("a server sends writes again to a gateway that comes back")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def again(self: Any, offset: int, count: int) -> Any:
        return self

    monkeypatch.setattr(served_requests.Relayed, "again", again)


@bug("a server leaves rows of requests unanswered while the gateway is away")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(served_requests.RelayedRows, "refuse", lambda self, unsent: None)


@bug("a server gives a slot away that still publishes for another client")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def deliver(self: Any, text: bytes, owner: Any) -> None:
        self.begun.setdefault(text, group_table.HeldGroup(int(text, 16), b"", 0, owner))

    monkeypatch.setattr(group_table.GroupTable, "deliver", deliver)
    monkeypatch.setattr(group_table.GroupTable, "drop", lambda self, text: None)


@bug("a server hands a client's requests on in turns of one too many")
def _(monkeypatch: pytest.MonkeyPatch) -> None:
    def take_frames(self: Any, offset: int, count: int, frames: bytes) -> None:
        self._early[self.answered] = (count, frames)
        self._asker.answer_rows(self)

    monkeypatch.setattr(served_requests.RelayedRows, "take_frames", take_frames)


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
