"""Runs a recorded session on the compiled gateware, and compares the answers and samples with the recorded ones.

The bus returns the recorded words: for requests in the order of the answers, and for samples by group and number of the
sample. Time is that of the snoop: each frame is sent at its recorded time. Cycles are computed while bytes are pending
or groups are running; otherwise the clock is set forward. The ticks of the two gateways are at different times;
therefore samples are compared separately for each group. A command that divides samples is sent only after the samples
that were recorded before it, and groups run no further than in the recording.
"""

from __future__ import annotations

import os
from collections import deque
from typing import TYPE_CHECKING, NamedTuple

import msgspec

from unity_link.capture.observed_session import ObservedSession
from unity_link.capture.transcript import FrameCutter
from unity_link.errors import ArgumentError, ConnectError
from unity_link.files import Writing, head_of, is_device
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.crc import seed_of
from unity_link.protocol.wire.messages import Codec, ErrorCode, GroupFlag
from unity_link.virtual.bus import AccessError
from unity_link.virtual.rtl.configurations import configurations
from unity_link.virtual.rtl.gateway import MOST_WHILE_TICKING, RtlGateway
from unity_link.virtual.rtl.snooped import SnoopedFrame, number_after, sample_body

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from unity_link.files import Overwrite
    from unity_link.virtual.rtl.configurations import Configuration
    from unity_link.virtual.rtl.snooped import Snooped, SnoopedAccess, SnoopedGroup

_SHAPE = ("protocol_version", "data_bits", "address_bits", "id_digits", "crc_bits", "crc_polynomial")
"""Fields of `GatewayInfo` on which the form of frames depends."""
_MOST_CYCLES = 2_000_000
"""Number of cycles in which all pending requests are answered, even if each access of a block times out."""
_PIECE = 64
_WAVEFORM = b"$version unity-link retrace $end"
"""Beginning of a waveform file."""
_FARTHEST = 1024
"""Largest number of recorded accesses that are searched for a matching one."""


class Difference(NamedTuple):
    """An answer or a sample that differs from the recorded one."""

    time: float
    """Time in seconds, as in the output of `explain`."""
    sent: bytes
    """The request that is answered; empty for a sample."""
    recorded: bytes
    retraced: bytes
    """Bytes of the retraced gateway; empty if it sent none."""


class Report(msgspec.Struct):
    """Result of a comparison."""

    answers: int = 0
    """Number of compared answers."""
    unknown: int = 0
    """Number of answers that the snoop does not have, or has only damaged."""
    samples: int = 0
    """Number of compared samples."""
    triggered: int = 0
    """Number of samples by external triggers, which cannot be compared because a snoop does not record triggers."""
    seconds: float = 0.0
    """Length of the recording in seconds."""
    differences: int = 0
    first: Difference | None = None

    def differ(self, difference: Difference) -> None:
        """Count a difference."""
        self.differences += 1
        if self.first is None or difference.time < self.first.time:
            self.first = difference


def fitting(snooped: Snooped) -> Configuration:
    """Return the build of the gateware that is most similar to the recorded gateway.

    Raises:
        ArgumentError: if no build has the widths of the recorded gateway.
    """
    info = snooped.info
    fits = [
        build
        for build in configurations().values()
        if build.node == snooped.node and all(getattr(build.info, name) == getattr(info, name) for name in _SHAPE)
    ]
    if not fits:
        wanted = ", ".join(f"{name}={getattr(info, name)}" for name in _SHAPE[1:])
        node = "" if snooped.node is None else f", node={snooped.node}"
        raise ArgumentError(f"no gateware was compiled with the widths of the recorded gateway: {wanted}{node}")
    return min(fits, key=lambda build: (len(differing(build.info, info)), build.name))


def differing(one: GatewayInfo, other: GatewayInfo) -> list[str]:
    """Return the names of the fields in which two gateways differ."""
    return [name for name in GatewayInfo.__struct_fields__ if getattr(one, name) != getattr(other, name)]


class Retrace(RtlGateway):
    """Compiled gateware that replaces a recorded gateway.

    Args:
        snooped: the recorded gateway.
        build: a build with the widths of the recorded gateway.

    Raises:
        ConnectError: if no C++ compiler is installed.
    """

    _window: tuple[float, float] | None = None
    """Begin and end of the waveform in nanoseconds; None for no waveform."""

    def __init__(self, snooped: Snooped, build: Configuration) -> None:
        super().__init__(build.name)
        self.report = Report()
        self._library.ul_set_only_device(self._handle)
        self._snooped = snooped
        self._codec = Codec(self.info, build.node)
        self._overheard = ObservedSession(self._codec.framing)
        self._same = not differing(self.info, snooped.info)
        # Even if the clocks differ, a base tick must take the recorded time, so that groups keep their rates.
        self._cycle_ns = 1e12 / (snooped.info.base_frequency_millihertz or 1) / self._base_tick
        self._accesses: deque[SnoopedAccess] = deque()
        self._owed: deque[SnoopedFrame] = deque()
        self._words: dict[int, int] = {}
        """The last word that was read or written, by address."""
        self._cutter = FrameCutter(sent=False)
        self._cutter.use(self.info)
        self._settings: dict[int, SnoopedGroup] = {}
        self._place: dict[int, int] = dict.fromkeys(snooped.groups, -1)
        """Index of each group's current settings."""
        self._sampled: dict[int, int] = {}
        """Number of the last sample of each group."""
        self._silent_at = -1
        """Cycle in which an access last timed out."""
        self._given: dict[int, tuple[int, list[int]]] = {}
        """Number and words of the last sample that the bus provided, by group."""
        self._given_up: set[int] = set()
        """Groups that did not take all expected samples."""
        self._set_time(0.0)

    def play(self) -> Report:
        """Run the whole recording, and return the result of the comparison."""
        steps = self._snooped.steps
        bounds = self._bounds()
        for step, bound in zip(steps, bounds, strict=False):
            self._pass_until(step.time, bound)
            if step.divides_samples:
                self._divide(step)
            else:
                self._send(step)
        self._pass_until(self._snooped.last, bounds[-1])
        self._settle()
        self._await_samples(bounds[-1])
        self._compare_rest()
        self.report.seconds = self._now / 1e9
        return self.report

    def play_into(self, path: Path, begin: float, end: float, *, overwrite: Overwrite = False) -> Report:
        """Run the whole recording, and write a waveform of a part of it; return the result of the comparison.

        Args:
            path: path of the waveform.
            begin: begin of the waveform in seconds.
            end: end of the waveform in seconds.
            overwrite: True if a file that is no such waveform may be replaced.

        Raises:
            ArgumentError: if the file cannot be created, or exists and is not such a waveform.
            ConnectError: if writing fails.
        """
        self._window = begin * 1e9, end * 1e9
        if is_device(path):
            return self._play_into(path, path)
        try:
            with Writing(overwrite=overwrite, folders=False) as writing:
                writing.claim([path], lambda known: head_of(known).startswith(_WAVEFORM))
                return self._play_into(writing.part_of(path), path)
        except OSError as error:
            raise ArgumentError(f"{path} can't be made ({error.strerror or error})") from error

    def _play_into(self, part: Path, path: Path) -> Report:
        failure = int(self._library.ul_open_waveform(self._handle, os.fsencode(part)))
        if failure:
            raise ArgumentError(f"{path} can't be made ({os.strerror(failure)})")
        report = self.play()
        failure = int(self._library.ul_close_waveform(self._handle))
        if failure:
            raise ConnectError(f"{path} could not be written ({os.strerror(failure)})")
        return report

    def _bounds(self) -> list[dict[int, int]]:
        """Return the samples up to which each group may run, before each step and after the last step."""
        bound = {group: settings[-1].last for group, settings in self._snooped.groups.items()}
        bounds = [bound]
        for step in reversed(self._snooped.steps):
            if step.divides_samples:
                bound = step.samples_before
            bounds.append(bound)
        bounds.reverse()
        return bounds

    # Time

    @property
    def _now(self) -> float:
        """The time in the snoop, in nanoseconds."""
        return self._began + (self.cycles - self._began_at) * self._cycle_ns

    def _set_time(self, now: float) -> None:
        """Set the time in the snoop, in nanoseconds."""
        self._began, self._began_at = now, self.cycles
        self._library.ul_set_time(self._handle, now, self._cycle_ns)

    def _pass_until(self, time: float, bound: Mapping[int, int]) -> None:
        """Run cycles up to a time while groups are running, and set the clock forward otherwise."""
        self._settle()
        while self.ticking and self._now < time and not self._has_run(bound):
            self._pass_cycles(max(1, min(self._base_tick, round((time - self._now) / self._cycle_ns))))
        missing = time - self._now
        if missing > 0:
            if not self.ticking:
                cycles = round(missing / self._cycle_ns)
                self._library.ul_skip(self._handle, cycles - cycles % self._base_tick)
            self._set_time(time)

    def _run(self, cycles: int) -> None:
        self._show_in_window()
        super()._run(cycles)

    def _run_until_quiet(self, most_while_ticking: int = MOST_WHILE_TICKING) -> None:
        self._show_in_window()
        super()._run_until_quiet(most_while_ticking)

    def _show_in_window(self) -> None:
        if self._window is not None:
            begin, end = self._window
            self._library.ul_show(self._handle, begin <= self._now <= end)

    def _pass_cycles(self, count: int) -> None:
        self._run(count)
        self._collect()

    def _has_run(self, bound: Mapping[int, int]) -> bool:
        """Return True if all groups have reached their bounds."""
        return not self._behind(bound)

    def _behind(self, bound: Mapping[int, int]) -> set[int]:
        """Return the groups that have not reached their bounds."""
        return {
            group
            for group, last in bound.items()
            if group in self._settings
            and self._sampled[group] < last
            and group not in self._given_up
            and not self._is_triggered(group)
        }

    def _is_triggered(self, group: int) -> bool:
        flags = self._settings[group].flags
        return bool(flags & GroupFlag.TRIGGER) and not flags & GroupFlag.PERIODIC

    def _await_samples(self, bound: Mapping[int, int]) -> None:
        """Run until the groups have reached their bounds, or for a limited number of cycles."""
        slowest = max((settings.divisor for settings in self._settings.values()), default=0)
        for _ in range((_MOST_CYCLES + 2 * slowest * self._base_tick) // _PIECE):
            if not self.ticking or self._has_run(bound):
                return
            self._pass_cycles(_PIECE)
        self._given_up |= self._behind(bound)

    def _settle(self) -> None:
        """Run cycles until all sent frames are received and answered."""
        for _ in range(_MOST_CYCLES // _PIECE):
            if self.ticking and not (self._owed or self.waiting):
                break
            if self.ticking:
                self._pass_cycles(_PIECE)
            else:
                self._run_until_quiet()
                self._collect()
                # The last frame may have started a group.
                if not self.ticking:
                    break
        for step in self._owed:
            # This answer is missing; the next answer belongs to a later frame.
            if step.answer is not None:
                self.report.differ(Difference(step.time / 1e9, step.frame, step.answer, b""))
        self._owed.clear()

    # Frames

    def _send(self, step: SnoopedFrame) -> None:
        self._accesses.extend(step.accesses)
        if step.owes:
            self._owed.append(step)
        self._library.ul_push(self._handle, step.frame, len(step.frame))

    def _divide(self, step: SnoopedFrame) -> None:
        """Send a command that divides samples after the samples recorded before it, and wait for its answer."""
        self._await_samples(step.samples_before)
        self._send(step)
        self._settle()
        assert step.request is not None
        if step.request.command == "GS" and step.answer is not None and b"X" not in step.answer.upper()[:4]:
            self._set_up(step.request.values[0])

    def _set_up(self, group: int) -> None:
        """Select the next recorded settings of a group."""
        if group in self._settings:
            self._compare_missing(group)
        self._place[group] += 1
        self._settings[group] = self._snooped.groups[group][self._place[group]]
        self._sampled[group] = -1
        self._given.pop(group, None)
        self._given_up.discard(group)

    def _collect(self) -> None:
        for frame in self._cutter.cut(self._pull()):
            body = self._overheard.open(frame.removesuffix(b"\n"), from_gateway=True)
            if body.startswith(b"K"):
                self._overheard.hear(self._codec.decode_response(body))
            if body.startswith(b"P"):
                self._compare_sample(frame, body)
            else:
                self._compare_answer(frame)

    # Comparison

    def _compare_answer(self, frame: bytes) -> None:
        step = self._owed.popleft() if self._owed else SnoopedFrame(self._now, b"")
        if step.answer is None and step.frame:
            self.report.unknown += 1
            return
        recorded = step.answer or b""
        self.report.answers += 1
        is_question = step.request is not None and step.request.command == "Q"
        if frame != recorded and (self._same or not is_question):
            self.report.differ(Difference(step.time / 1e9, step.frame, recorded, frame))

    def _compare_sample(self, frame: bytes, body: bytes) -> None:
        group, sequence = int(body[1:3], 16), int(body[3:5], 16)
        settings = self._settings.get(group)
        if settings is None:
            return
        number = self._sampled[group] = number_after(self._sampled[group], sequence)
        recorded = settings.samples.get(number)
        # Samples after the last recorded one, and in gaps of the recording, cannot be compared.
        if recorded is None or self._is_triggered(group):
            return
        self.report.samples += 1
        seed = seed_of(self._overheard.number, from_gateway=True)
        if sample_body(self._codec, frame, settings.flags, seed) != recorded.body:
            self.report.differ(Difference(recorded.time / 1e9, b"", recorded.frame, frame))

    def _compare_missing(self, group: int) -> None:
        """Report the recorded samples of a group's settings that the gateware did not send."""
        settings = self._settings[group]
        if self._is_triggered(group):
            self.report.triggered += len(settings.samples)
            return
        for number, sample in settings.samples.items():
            if number > self._sampled[group]:
                self.report.differ(Difference(sample.time / 1e9, b"", sample.frame, b""))

    def _compare_rest(self) -> None:
        for group in self._settings:
            self._compare_missing(group)

    # The bus

    def _access(self, address: int, word: int | None) -> int:
        """Return the recorded result of an access."""
        place = int(self._library.ul_sample_word(self._handle))
        if place >= 0:
            return self._sampled_word(place >> 16, place >> 8 & 0xFF, place & 0xFF)
        outcome = self._recorded_outcome(word is not None, address)
        self._silent_at = self.cycles if outcome is ErrorCode.BUS_TIMEOUT else -1
        if isinstance(outcome, ErrorCode):
            raise AccessError(outcome)
        if word is not None:
            self._words[address] = word
            return 0
        if outcome is not None:
            self._words[address] = outcome
        return self._words.get(address, 0)

    def _recorded_outcome(self, write: bool, address: int) -> int | ErrorCode | None:  # noqa: FBT001
        """Return the recorded outcome of the next such access; skip others, because the gateways may differ."""
        if self.cycles == self._silent_at + 1:
            # This is still the same access: an access without an answer is passed on in each cycle.
            return ErrorCode.BUS_TIMEOUT
        accesses = self._accesses
        for place in range(min(len(accesses), _FARTHEST)):
            if accesses[place][:2] == (write, address):
                for _ in range(place):
                    accesses.popleft()
                return accesses.popleft().outcome
        return None

    def _sampled_word(self, group: int, sequence: int, index: int) -> int:
        """Return a word of a sample; a suitable word, if the sample was not recorded."""
        settings = self._settings.get(group)
        if settings is None:
            return 0
        if not index:
            self._decide(group, settings, number_after(self._sampled[group], sequence))
        words = self._given.get(group, (-1, []))[1]
        return words[index] if index < len(words) else 0

    def _decide(self, group: int, settings: SnoopedGroup, number: int) -> None:
        """Choose the words of a sample that is being read; with ON_CHANGE they decide whether it is sent."""
        last, before = self._given.get(group, (-1, []))
        sample = settings.samples.get(number)
        if number == last and settings.flags & GroupFlag.ON_CHANGE:
            return
        if not settings.flags & GroupFlag.ON_CHANGE or not before:
            words = before if sample is None else sample.words
        elif sample is not None:
            if sample.time > self._now:
                # The values change only at the recorded time of the sample.
                return
            words = sample.words
        elif number < settings.last:
            # A lost sample was sent because of a change; its words must also differ from those of the next sample.
            later = next(
                settings.samples[one] for one in range(number + 1, settings.last + 1) if one in settings.samples
            )
            changes = ([before[0] ^ change, *before[1:]] for change in (1, 2))
            words = next(changed for changed in changes if changed != later.words)
        else:
            return
        self._given[group] = number, words
