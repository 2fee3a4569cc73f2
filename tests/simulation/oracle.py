"""The oracle compares the accesses and samples of each gateway with the calls of each program and their results.

Each written word is unique in a scenario and contains its address. Each word that is read contains its address, and
either the write that it comes from or the instant at which it was read. So the values alone reveal a wrong address, an
old value, a write that was executed twice or not at all, and a sample of another group.
"""

from __future__ import annotations

import asyncio
from collections import defaultdict
from typing import TYPE_CHECKING, Any

from simulation.plan import ADDRESS_SHIFT, BURST, BURSTS, FAILING, LIVE, QUEUE_OUT
from unity_link import BusError, BusTimeoutError
from unity_link.errors import Outcome, UnansweredError
from unity_link.protocol.wire.compact import text_of
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual.bus import AccessError
from unity_link.virtual.gateway import Gateway

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, MutableMapping, Sequence

    from unity_link import Link, Sample
    from unity_link.virtual.gateway import BareGateway

_COUNT = (1 << ADDRESS_SHIFT) - 1
_SLACK = 1e-6
"""Seconds by which equal instants may differ."""
_MOST_DOUBLED = 4
"""Largest number of samples in compact form within the bytes that a line duplicates at a time."""


MOST_WAITING = 131_072
"""Bytes that may wait at one end of a connection: the limit at which a transport pauses its writer, plus the bytes of
the last write."""


class RuleError(AssertionError):
    """A rule that the oracle found broken; `kind` names the rule."""

    def __init__(self, kind: str, text: str) -> None:
        super().__init__(f"{kind}: {text}")
        self.kind = kind


# Accesses and samples of the gateways


class Recorder:
    """The device at all addresses of a gateway: it records every access with its instant.

    Args:
        trace: receives the events.
        name: name of the gateway.
    """

    def __init__(self, trace: list[Any], name: str) -> None:
        self.name = name
        self.at: float | None = None
        """Instant of all following accesses; None: the instant that the gateway passes with each access."""
        self.reading = 0.0
        """Seconds in which the words of a sample are read."""
        self.writes: list[tuple[float, int, int]] = []
        """Instant, address and word of each write, including failed ones."""
        self.places: dict[int, list[int]] = defaultdict(list)
        """Indices in `writes` for each word."""
        self.history: dict[int, list[tuple[float, int]]] = {}
        """For each address the instants of its writes, with the words."""
        self.instants: list[float] = []
        """Instants of the reads of words that identify instants."""
        self.popped: dict[int, list[float]] = defaultdict(list)
        """For each queue the instants at which its words were taken."""
        self.reads: dict[int, list[float]] = defaultdict(list)
        """Instants at which each other address was read."""
        self._trace = trace
        self._words: dict[int, int] = {}
        self._numbers: dict[tuple[int, float], int] = {}

    def read(self, offset: int, now: float) -> int:
        """Return the word at an address."""
        now = now if self.at is None else self.at
        if offset in LIVE or offset in BURSTS:
            return offset << ADDRESS_SHIFT | self._number(offset, now)
        if offset in QUEUE_OUT:
            taken = self.popped[offset]
            taken.append(now)
            return offset << ADDRESS_SHIFT | len(taken)
        self.reads[offset].append(now)
        if offset in FAILING:
            raise AccessError(ErrorCode.BUS_ERROR)
        return self._words.get(offset, offset << ADDRESS_SHIFT)

    def _number(self, offset: int, now: float) -> int:
        """Return the number of an access to a word that contains it; no two accesses to a word have the same number."""
        if offset in BURSTS:
            if (turn := int(now / BURST)) + offset & 1:
                now = turn * BURST
            if (offset, now) in self._numbers:
                return self._numbers[offset, now]
            self._numbers[offset, now] = len(self.instants)
        self.instants.append(now)
        return len(self.instants) - 1

    def write(self, offset: int, value: int, now: float) -> None:
        """Store a word."""
        now = now if self.at is None else self.at
        self._trace.append((now, self.name, "write", offset, value))
        self.places[value].append(len(self.writes))
        self.writes.append((now, offset, value))
        if offset in FAILING:
            raise AccessError(ErrorCode.BUS_ERROR)
        self._words[offset] = value
        self.history.setdefault(offset, [(-1.0, offset << ADDRESS_SHIFT)]).append((now, value))

    def had(self, address: int, word: int, since: float, until: float) -> bool:
        """Return true if an address had a word at some instant from `since` to `until`."""
        history = self.history.get(address, ((-1.0, address << ADDRESS_SHIFT),))
        for place, (written, value) in enumerate(history):
            if value == word and written <= until + _SLACK:
                return place + 1 == len(history) or history[place + 1][0] >= since - _SLACK
        return False


class Published:
    """Samples of one gateway, as it sent them.

    The gateway numbers its samples with two digits; here they are numbered from each set-up of the group, its `life`.
    """

    def __init__(self) -> None:
        self.samples: dict[bytes, list[tuple[int, int]]] = defaultdict(list)
        """For each text of words: the life of the group and the number of the sample in it."""
        self.last: dict[int, int] = {}
        """For each life of a group: the number of its last sample."""
        self._lives = 0
        self._groups: dict[bytes, tuple[int, int]] = {}
        self._asked: set[bytes] = set()
        self._set_up: set[bytes] = set()

    def ask(self, group: bytes) -> None:
        """Record a request to set up a group."""
        self._asked.add(group)

    def answer(self) -> None:
        """Record that the requested groups were set up: their earlier samples belong to their former life."""
        self._set_up |= self._asked
        self._asked.clear()

    def publish(self, group: bytes, sequence: int, text: bytes) -> None:
        """Record a sample; its words may follow the 8 digits of a timestamp."""
        life, last = self._groups.get(group, (-1, -1))
        step = sequence - last & 0xFF or 0x100
        if life < 0 or (group in self._set_up and step != 1):
            life, last, step = self._lives, -1, sequence + 1
            self._lives += 1
        self._set_up.discard(group)
        self._groups[group] = place = life, last + step
        self.last[life] = last + step
        self.samples[text].append(place)
        self.samples[text[8:]].append(place)


class Tap:
    """Observes the requests to a gateway and its answers.

    Args:
        gateway: the gateway.
        trace: receives the events.
        name: name of the gateway.
        clock: clock of the programs, if that of the gateway is behind or ahead of it; None: both are the same.
        node: node number on a shared line.
    """

    open = Gateway.open

    def __init__(
        self,
        gateway: BareGateway,
        trace: list[Any],
        name: str,
        clock: Callable[[], float] | None = None,
        node: int | None = None,
    ) -> None:
        self.gateway = gateway
        self._clock = clock
        self.info = gateway.info
        self.wake: Callable[[], None] = lambda: None
        self.recorder = Recorder(trace, name)
        self.published = Published()
        gateway.wake = self._pass_on_wake
        gateway.attach(self.recorder, range(1 << self.info.address_bits))
        self._address = b"" if node is None else b"Z%02X" % node
        self._set_up = self._address + b"gs"
        self._after_id = len(self._set_up) + self.info.id_digits
        self._check = self.info.crc_bits // 4
        self._before = b""
        """The last received bytes, for a frame that arrives in several reads."""
        self._after = b""
        """The beginning of a frame that is being sent."""
        self.openings = 0
        """Number of opened sessions."""
        self._begin_forms()

    def _begin_forms(self) -> None:
        self._text_in, self._text_out = (text_of(self.info, from_gateway=side) for side in (False, True))

    @property
    def memory(self) -> MutableMapping[int, int]:
        return self.gateway.memory

    @property
    def waiting(self) -> int:
        return self.gateway.waiting

    @property
    def next_due(self) -> float | None:
        return self.gateway.next_due

    @property
    def leaves_time_out(self) -> bool:
        return self.gateway.leaves_time_out

    def _pass_on_wake(self) -> None:
        self.wake()

    def reset(self) -> None:
        """Reset the gateway."""
        self._before = self._after = b""
        self._begin_forms()
        self.gateway.reset()

    def overflow(self) -> None:
        self.gateway.overflow()

    def receive(self, data: bytes, now: float) -> bytes:
        before = len(self._before)
        seen = self._before + self._text_in(data)
        place = seen.find(self._set_up)
        while place >= 0:
            group = place + self._after_id
            if before < group + 2 <= len(seen):
                self.published.ask(seen[group : group + 2])
            place = seen.find(self._set_up, group)
        self._before = seen[-self._after_id - 1 :]
        self._look_at_clock()
        return self._note(self.gateway.receive(data, now))

    def advance(self, now: float, room: int | None = None) -> bytes:
        self._look_at_clock()
        return self._note(self.gateway.advance(now, room))

    def _look_at_clock(self) -> None:
        if self._clock is not None:
            self.recorder.at = self._clock()

    def _note(self, data: bytes) -> bytes:
        sent = self._after + self._text_out(data)
        end = sent.rfind(b"\n") + 1
        self._after = sent[end:]
        if b"P" in sent or b"gs" in sent or b"K" in sent:
            for whole in sent[:end].split(b"\n"):
                line = whole.removeprefix(self._address)
                if line[:2] == b"gs":
                    self.published.answer()
                elif line[:1] == b"K":
                    # The answer to a session query is shorter.
                    self.openings += len(line) > 1 + self.info.session_digits + self._check
                elif line[:1] == b"P":
                    self.published.publish(line[1:3], int(line[3:5], 16), line[5 : -self._check])
        return data


# Calls of the programs


class Ask:
    """One call of a program, from its beginning to its end."""

    __slots__ = (
        "after",
        "answer",
        "asked",
        "cancelled",
        "ended",
        "error",
        "kind",
        "link",
        "number",
        "task",
        "told",
        "words",
    )

    def __init__(self, link: LinkLog, number: int, kind: str, words: Sequence[tuple[int, int]], asked: float) -> None:
        self.link = link
        self.number = number
        self.kind = kind
        self.words = words
        """Address and word of each write, or address and count of the words to read."""
        self.asked = asked
        self.task = asyncio.current_task()
        self.told: float | None = None
        """Instant at which the call ended; None while it is pending."""
        self.error: BaseException | None = None
        self.answer: Any = None
        self.after: dict[int, int] | None = None
        """For a read, the values that the program itself had written last, by address."""
        self.cancelled = False
        self.ended = False
        """True if the link had ended when the call failed."""

    def __str__(self) -> str:
        words = ", ".join(f"{word:#x}" for _, word in self.words[:3])
        return f"{self.link.name} call {self.number}, {self.kind} {words} at {self.asked:.6f}"


class LinkLog:
    """All calls on one link, in order."""

    def __init__(self, name: str, recorder: Recorder, *, shared: bool, reconnect: bool, block_words: int) -> None:
        self.name = name
        self.recorder = recorder
        self.shared = shared
        """True if the link goes through a server."""
        self.reconnect = reconnect
        self.block_words = block_words
        self.refused = False
        """True if the link cannot return: a server had no free group, or another host took the line."""
        self.closed = False
        """True if the program has closed the link while its tasks ran."""
        self.opened = asyncio.get_running_loop().time()
        """Instant at which the link was open."""
        self.asks: list[Ask] = []
        self.listenings: list[Listening] = []
        self.post_failures: list[tuple[float, int, asyncio.Task[Any] | None]] = []
        """Instant of each report of errors of posted writes, their number, and the task that received it."""

    def ended(self, link: Link) -> bool:
        """Return true if the link can have no further session."""
        return self.refused or self.closed or link._closed or (not self.reconnect and not link.connected)

    def ask(self, kind: str, words: Sequence[tuple[int, int]], now: float) -> Ask:
        """Record a call."""
        ask = Ask(self, len(self.asks), kind, words, now)
        self.asks.append(ask)
        return ask


class Listening:
    """Samples that one subscription delivered."""

    def __init__(
        self, link: LinkLog, published: Published, addresses: tuple[int, ...], arguments: dict[str, Any]
    ) -> None:
        self.link = link
        self.published = published
        self.addresses = addresses
        self.arguments = arguments
        self.samples: list[Sample] = []
        self.lost: int | None = None
        """Losses that the subscription counted, if the program read it to its end."""
        self.rate: float | None = None


# The comparison

_WRITES = frozenset({"write", "write_masked", "write_block", "write_queue", "write_many", "post", "post_many"})
POSTED = frozenset({"post", "post_many"})
_SINGLE = frozenset({"write", "write_masked", "post"})
_BLOCKS = frozenset({"write_block", "write_queue"})


class Oracle:
    """Checks a scenario that has ended."""

    def judge(self, recorders: Sequence[Recorder], logs: Sequence[LinkLog]) -> None:
        """Raise `RuleError` if a rule was broken."""
        for log in logs:
            for ask in log.asks:
                self._judge_call(ask)
            self._judge_order(log)
            self._judge_posted(log)
            for listening in log.listenings:
                self._judge_listening(listening)
        self._judge_nothing_else(recorders, logs)
        self._judge_queues(recorders, logs)

    # Calls

    def _judge_call(self, ask: Ask) -> None:
        error = ask.error
        if error is not None and not self._expected(ask, error):
            raise RuleError("an unexpected error", f"{ask} raised {error!r}")
        if ask.kind in _WRITES:
            failing = ask.kind not in POSTED and any(address in FAILING for address, _ in ask.words)
            if failing and error is None and ask.told is not None:
                raise RuleError("a failed write reported as done", str(ask))
            if ask.kind not in POSTED:
                self._judge_write(ask)
            for address, word in ask.words:
                self._judge_once(ask, address, word)
        elif error is None and ask.answer is not None:
            self._judge_read(ask)
        if ask.kind == "read_many" and isinstance(error, BusError) and not ask.link.shared:
            self._judge_others(ask)
        if ask.kind == "write_masked":
            self._judge_old_word(ask)

    @staticmethod
    def _expected(ask: Ask, error: BaseException) -> bool:
        if isinstance(error, UnansweredError):
            return True
        if isinstance(error, BusError):
            return any(address in FAILING for address, _ in ask.words) or ask.kind in ("fence", "exit")
        return isinstance(error, BusTimeoutError) and ask.link.shared

    def _judge_once(self, ask: Ask, address: int, word: int) -> None:
        places = ask.link.recorder.places.get(word, ())
        if len(places) > 1:
            raise RuleError("a write executed more than once", f"{ask}: {word:#x} {len(places)} times")
        for place in places:
            if ask.link.recorder.writes[place][1] != address:
                raise RuleError("a write to another address", f"{ask}: {word:#x}")

    def _judge_write(self, ask: Ask) -> None:
        """Compare the result of a write with its execution."""
        recorder, error = ask.link.recorder, ask.error
        executed = [recorder.places.get(word) for _, word in ask.words]
        must, must_not = _known(ask, error)
        if must and not all(executed):
            missing = next(word for (_, word), places in zip(ask.words, executed, strict=True) if not places)
            raise RuleError("a write acknowledged but not executed", f"{ask}: {missing:#x} ({error!r})")
        if must_not and any(executed):
            raise RuleError("a write executed but reported as not executed", f"{ask} ({error!r})")
        if must and ask.told is not None:
            for places in executed:
                when = recorder.writes[places[0]][0] if places else ask.asked
                if not ask.asked - _SLACK <= when <= ask.told + _SLACK:
                    raise RuleError("a write executed outside its call", f"{ask}: at {when}, ended at {ask.told}")

    def _judge_read(self, ask: Ask) -> None:
        """Check that each returned word was at its address during the call."""
        assert ask.told is not None
        recorder = ask.link.recorder
        if len(ask.answer) != len(ask.words):
            raise RuleError("an answer of another length", f"{ask} gave {len(ask.answer)} words")
        for (address, _), answer in zip(ask.words, ask.answer, strict=True):
            word = int(answer)
            if word >> ADDRESS_SHIFT != address:
                raise RuleError("an answer of another address", f"{ask} of {address:#x} gave {word:#x}")
            number = word & _COUNT
            if address in QUEUE_OUT:
                taken = recorder.popped[address]
                good = number <= len(taken) and ask.asked - _SLACK <= taken[number - 1] <= ask.told + _SLACK
            elif address in LIVE:
                good = number < len(recorder.instants) and (
                    ask.asked - _SLACK <= recorder.instants[number] <= ask.told + _SLACK
                )
            else:
                good = recorder.had(address, word, ask.asked, ask.told)
            if not good:
                raise RuleError("an answer from another time", f"{ask} of {address:#x} gave {word:#x} at {ask.told}")
            if ask.after and (mine := ask.after.get(address)) is not None:
                self._judge_after(ask, address, word, mine)

    @staticmethod
    def _judge_others(ask: Ask) -> None:
        """Check that a batch of reads continues after a failed read, and raises when all reads are done."""
        assert ask.told is not None
        for address, _ in ask.words:
            reads = ask.link.recorder.reads[address]
            if address not in LIVE and not any(ask.asked - _SLACK <= when <= ask.told + _SLACK for when in reads):
                raise RuleError("a read of a batch left out", f"{ask}: {address:#x}")

    @staticmethod
    def _judge_after(ask: Ask, address: int, word: int, mine: int) -> None:
        """Check that a read does not return an older value than the one that its program wrote before it."""
        recorder = ask.link.recorder
        if mine in recorder.places and address in recorder.history:
            words = [value for _, value in recorder.history[address]]
            if mine in words and word in words and words.index(word) < words.index(mine):
                raise RuleError("a read that overtook a write", f"{ask} gave {word:#x}, {mine:#x} was written before")

    @staticmethod
    def _judge_old_word(ask: Ask) -> None:
        (address, word), recorder = ask.words[0], ask.link.recorder
        values = [value for _, value in recorder.history.get(address, ())]
        if ask.answer and word in values and values[values.index(word) - 1] != ask.answer[0]:
            raise RuleError("a masked write that returned a wrong old word", f"{ask}: {ask.answer[0]:#x}")

    # Order

    def _judge_order(self, log: LinkLog) -> None:
        """Check that writes were executed in the order of the calls, and the words of a call in order."""
        places, last, before = log.recorder.places, -1, None
        for ask in log.asks:
            if ask.kind not in _WRITES:
                continue
            executed = [places[word][0] for _, word in ask.words if places.get(word)]
            if executed != sorted(executed):
                raise RuleError("the writes of a call in another order", str(ask))
            single = ask.kind in _SINGLE or (ask.kind in _BLOCKS and len(ask.words) <= log.block_words)
            if single and executed:
                if executed[0] < last:
                    raise RuleError("writes in another order", f"{ask} was executed before {before}")
                last, before = executed[-1], ask

    def _judge_posted(self, log: LinkLog) -> None:
        """Check that a fence reports each failed write that its task has posted, and the exit those of all tasks."""
        posted = [ask for ask in log.asks if ask.kind in POSTED and ask.error is None and ask.told is not None]
        recorder = log.recorder
        for fence in log.asks:
            if fence.kind not in ("fence", "exit") or fence.told is None:
                continue
            if fence.ended or (fence.error is not None and str(fence.error).startswith("fence")):
                # The error of such a fence is not about posted writes.
                continue
            missing = 0
            for ask in posted:
                if ask.number > fence.number:
                    break
                if fence.kind == "fence" and ask.task is not fence.task:
                    continue
                when = [recorder.places.get(word) for _, word in ask.words]
                done = all(places and recorder.writes[places[0]][0] <= fence.told + _SLACK for places in when)
                missing += not done or any(address in FAILING for address, _ in ask.words)
            reported = sum(
                count
                for when, count, task in log.post_failures
                if when <= fence.told and (fence.kind == "exit" or task is fence.task)
            )
            if missing > reported:
                raise RuleError(
                    "a posted write lost",
                    f"{fence} ended at {fence.told}: {missing} calls are missing, {reported} were reported",
                )

    # Samples

    def _judge_listening(self, listening: Listening) -> None:
        recorder = listening.link.recorder
        digits = -(-recorder_digits(listening) // 1)
        last, time = -1.0, -1.0
        # Words that are constant for a while fit several samples.
        places = {(-1, -1)}
        lost_before = 0
        for position, sample in enumerate(listening.samples):
            words = [int(word) for word in sample.values]
            text = b"".join(b"%0*X" % (digits, word) for word in words)
            where = (
                f"{listening.link.name} subscription to {[f'{a:#x}' for a in listening.addresses]}, sample {position}"
            )
            if [word >> ADDRESS_SHIFT for word in words] != list(listening.addresses):
                raise RuleError("a sample of another group", f"{where}: {[f'{word:#x}' for word in words]}")
            before = min(places)
            earliest = before if listening.arguments["timestamps"] else (before[0], before[1] - _MOST_DOUBLED)
            published = {place for place in listening.published.samples.get(text, ()) if place >= earliest}
            if not published:
                raise RuleError("a sample that was not published", f"{where}: {text!r}")
            instant = recorder.instants[words[0] & _COUNT]
            if instant < last - _SLACK and min(published) >= before:
                raise RuleError("samples in another order", where)
            last = max(last, instant)
            self._judge_instant(listening, words, instant, where)
            time = self._judge_time(sample, time, where)
            reached = {new for old in places for new in _next_places(listening, old, published, sample.lost)}
            if not reached:
                raise RuleError(
                    "lost samples counted wrong",
                    f"{where}: lost {sample.lost}, from one of {sorted(places)} to one of {sorted(published)}",
                )
            places = reached
            lost_before += sample.lost
        if listening.lost is not None and listening.lost != lost_before:
            raise RuleError(
                "lost samples counted wrong",
                f"{listening.link.name}: lost is {listening.lost}, the sum over its samples is {lost_before}",
            )

    @staticmethod
    def _judge_time(sample: Sample, before: float, where: str) -> float:
        """Check that the time of samples does not go back."""
        if sample.time is None:
            return before
        if sample.time < before - _SLACK:
            raise RuleError("time that goes back", f"{where}: {sample.time}, and {before} before it")
        return sample.time

    @staticmethod
    def _judge_instant(listening: Listening, words: list[int], instant: float, where: str) -> None:
        recorder = listening.link.recorder
        first, last = instant - recorder.reading, instant + recorder.reading
        for address, word in zip(listening.addresses, words, strict=True):
            if address in LIVE or address in BURSTS:
                good = first <= recorder.instants[word & _COUNT] <= last
            elif listening.addresses[0] in LIVE:
                good = recorder.had(address, word, first, last)
            else:
                good = True
            if not good:
                raise RuleError("a sample of several instants", f"{where}: {word:#x}")

    # All calls together

    @staticmethod
    def _judge_nothing_else(recorders: Sequence[Recorder], logs: Sequence[LinkLog]) -> None:
        asked = {
            (id(log.recorder), word) for log in logs for ask in log.asks if ask.kind in _WRITES for _, word in ask.words
        }
        for recorder in recorders:
            for word in recorder.places:
                if (id(recorder), word) not in asked:
                    raise RuleError("a write without a call", f"{recorder.name}: {word:#x}")

    @staticmethod
    def _judge_queues(recorders: Sequence[Recorder], logs: Sequence[LinkLog]) -> None:
        for recorder in recorders:
            delivered: dict[int, int] = defaultdict(int)
            perhaps: dict[int, int] = defaultdict(int)
            for log in logs:
                if log.recorder is not recorder:
                    continue
                for ask in log.asks:
                    if ask.kind != "read_queue":
                        continue
                    address, count = ask.words[0][0], len(ask.words)
                    must, must_not = _known(ask, ask.error)
                    if must:
                        delivered[address] += count
                    elif not must_not:
                        perhaps[address] += count
            for address, taken in recorder.popped.items():
                if not delivered[address] <= len(taken) <= delivered[address] + perhaps[address]:
                    raise RuleError(
                        "queue reads executed more or less often than called",
                        f"{recorder.name} {address:#x}: {len(taken)} words taken, {delivered[address]} delivered and "
                        f"{perhaps[address]} perhaps",
                    )


def _next_places(
    listening: Listening, old: tuple[int, int], published: set[tuple[int, int]], lost: int
) -> Iterator[tuple[int, int]]:
    """Yield the samples with the same words that a sample may be, if `lost` samples are missing before it."""
    life, number = old
    for new in published:
        if new[0] == life:
            due = new[1] - number - 1
            # Two digits do not distinguish a sample that the line has duplicated from one a whole lap later; timestamps
            # do. One of both may be among those that a full buffer dropped.
            doubled = -_MOST_DOUBLED <= due < 0 and lost % 0x100 == due % 0x100
            doubled |= "buffer" in listening.arguments and lost == due + 0x100
            if (
                (doubled and not listening.arguments["timestamps"])
                or lost == due
                or (due >= 0x100 and _ambiguous(lost, due, listening))
            ):
                yield new
        elif new[0] > life and (
            listening.link.shared or _lost_over_lives(listening.published, listening.arguments, old, new, lost)
        ):
            yield new


def _lost_over_lives(
    published: Published, arguments: dict[str, Any], old: tuple[int, int], new: tuple[int, int], lost: int
) -> bool:
    """Return true if a count of losses is correct for a group that was set up again.

    It counts the missing samples of the new life, and those of earlier lives that a full buffer dropped.
    """
    due = new[1]
    dropped = 0
    if "buffer" in arguments and old[0] >= 0:
        dropped = published.last[old[0]] - old[1]
        dropped += sum(published.last[life] + 1 for life in range(old[0] + 1, new[0]))
    return (lost - due) % 0x100 == 0 or due <= lost <= due + dropped


def recorder_digits(listening: Listening) -> int:
    """Return the number of hex digits of a word."""
    digits: int = listening.arguments["digits"]
    return digits


def _ambiguous(lost: int, due: int, listening: Listening) -> bool:
    """Return true if a count is correct except for whole laps of a two-digit number that no clock can resolve."""
    counted = listening.rate is not None and not listening.arguments["on_change"] and listening.arguments["timestamps"]
    return not counted and (due - lost) % 0x100 == 0


def _known(ask: Ask, error: BaseException | None) -> tuple[bool, bool]:
    """Return whether a call reports its execution, complete, and whether it reports that it was not executed."""
    if ask.told is None:
        return False, False
    if error is None:
        return True, False
    if isinstance(error, UnansweredError):
        return error.outcome is Outcome.EXECUTED and not ask.link.shared, error.outcome is Outcome.NOT_EXECUTED
    if isinstance(error, BusError):
        return len(ask.words) == 1, False
    return False, False
