"""Many signals at once, of one gateway or several: read, written and published together."""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Protocol, Self

import msgspec
import numpy as np

from unity_link.data.batch import Values
from unity_link.data.callbacks import Callback, Registration
from unity_link.data.feed import Feed
from unity_link.data.layout import GroupLayout
from unity_link.data.proxies import BUFFER, Proxy, nothing_publishes, signals_table
from unity_link.data.sampling import GroupSubscription, Poll
from unity_link.data.writing import write_values
from unity_link.errors import ArgumentError, Sealed, UnsupportedError, shown
from unity_link.link.calls import returns_coroutine
from unity_link.link.runtimes.synchronisation import gather
from unity_link.link.subscription import LARGEST_DIVISOR, asked_rate, check_buffer
from unity_link.modules import caller_on
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.numbers import RATE, real_number

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Coroutine, Sequence

    from numpy.typing import NDArray

    from unity_link.data.batch import Batch, GroupSample
    from unity_link.data.sampling import SampleSource
    from unity_link.link.link import Link
    from unity_link.link.publishing import Overflow
    from unity_link.spec import model


class Plan(msgspec.Struct, frozen=True, kw_only=True):
    """Rate and form of sampling; the fields are those of the arguments of `unity_link.Link.subscribe`."""

    rate_hz: float | None = None
    divisor: int | None = None
    trigger: bool = False
    on_change: bool = False
    immediate: bool = False
    timestamps: bool | None = None
    group: int | None = None
    """Number of the group in the gateway, if the group has a trigger of its own."""
    polled: bool = False
    """True if the host reads the signals, even if the gateway has groups."""
    nearest: bool = False
    """True if `immediate` is ignored on a gateway that cannot send at once."""

    @classmethod
    def declared(cls, group: model.GroupSpec) -> Self:
        """Return the plan of a group that a spec declares."""
        return cls(
            rate_hz=group.rate_hz,
            divisor=group.divisor,
            trigger=group.trigger,
            on_change=group.on_change,
            immediate=group.immediate,
            timestamps=True if group.timestamps else None,
            group=group.number if group.trigger else None,
            nearest=True,
        )

    @classmethod
    def of(cls, proxy: Proxy[Any]) -> Plan | None:
        """Return the plan by which the spec samples a signal; None if the spec has none."""
        signal = proxy.signal
        if signal.group is not None:
            return cls.declared(next(one for one in proxy.robot.interface.groups if one.name == signal.group))
        return None if signal.poll_hz is None else cls(rate_hz=signal.poll_hz, polled=True)

    def is_known(self) -> bool:
        """Return whether the plan determines when samples are taken."""
        return self.rate_hz is not None or self.divisor is not None or self.trigger


class Part(Protocol):
    """The attribute of a robot's component that groups use."""

    @property
    def signals(self) -> tuple[Proxy[Any], ...]:
        """All signals of the component and of its parts."""


class Group(Sealed):
    """Signals that are read, written and published together.

    ::

        arm = Group(robot.j1.cpos, robot.j2.cpos, rate_hz=100)
        values = await arm.get()
        print(values[robot.j1.cpos])

    A spec can declare groups, too: they are in `Robot.groups`.
    """

    def __init__(self, *members: Proxy[Any] | Part, rate_hz: float | None = None, name: str = "a group") -> None:
        """Make a group.

        Args:
            members: signals of one or several robots, or components. A component adds all its signals; those that
                can only be written, and queues, are left out of reads and samples.
            rate_hz: sampling rate for iteration and callbacks, in Hz; None for the rate that the spec has.
            name: name of the group in messages.

        Raises:
            ArgumentError: if there are no members, or one appears twice.
        """
        wrong: list[object] = [
            member for member in members if not (isinstance(member, Proxy) or "signals" in dir(type(member)))
        ]
        for member in wrong:
            hint = ": write `Group(*signals)`" if isinstance(member, (list, tuple)) else ""
            raise ArgumentError(f"{name}: signals or parts of a robot were expected, not {member!r:.80}{hint}")
        rate = None if rate_hz is None else _host_rate(rate_hz, name)
        proxies = [
            proxy for member in members for proxy in ((member,) if isinstance(member, Proxy) else member.signals)
        ]
        self.name = name
        self.proxies: tuple[Proxy[Any], ...] = tuple(proxies)
        self._model: model.GroupSpec | None = None
        self._read = _readable(members)
        self._places = {proxy: place for place, proxy in enumerate(self._read)}
        self._members = frozenset(proxies)
        if not proxies or len(self._members) != len(proxies):
            twice = next((proxy.path for proxy in proxies if proxies.count(proxy) > 1), None)
            raise ArgumentError(f"{name}: {twice} is in it twice" if twice else f"{name}: it has no signals")
        self._plan = Plan(rate_hz=rate)
        self._layouts: list[GroupLayout] | None = None
        self._feed: Feed | None = None

    __slots__ = ("_feed", "_layouts", "_members", "_model", "_places", "_plan", "_read", "name", "proxies")

    @classmethod
    def declared(cls, group: model.GroupSpec, proxies: Sequence[Proxy[Any]]) -> Group:
        """Make a group that a spec declares."""
        made = cls(*proxies, name=group.name)
        made._model = group
        made._plan = Plan.declared(group)
        return made

    @classmethod
    def polled(cls, rate_hz: float, proxies: Sequence[Proxy[Any]]) -> Group:
        """Make a group whose signals the host reads by itself.

        Raises:
            ArgumentError: if `rate_hz` is out of range or no number.
        """
        rate = _host_rate(rate_hz, "polled signals")
        made = cls(*proxies, name=f"the signals polled at {rate:g} Hz")
        made._plan = Plan(rate_hz=rate, polled=True)
        return made

    @property
    def model(self) -> model.GroupSpec | None:
        """Declaration of the group in the spec; None for a group that a program made."""
        return self._model

    def _called(self) -> str:
        return f"the group {self.name}" if self.model else self.name

    def __repr__(self) -> str:
        """Return the name and the size."""
        return f"<group {self.name}: {len(self.proxies)} signals>"

    def _repr_html_(self) -> str:
        """Return the name, and the signals with their last values, as a table."""
        return signals_table(repr(self)[1:-1], self.proxies)

    def __len__(self) -> int:
        """Return the number of signals."""
        return len(self.proxies)

    # All at once

    async def get(self) -> Values:
        """Read all signals, in one pipelined batch for each gateway.

        Raises:
            ArgumentError: if a signal can only be written, or is a queue.
        """
        layouts = self._lay_out()
        if len(layouts) == 1:
            row = layouts[0].row(await layouts[0].read())
        else:
            row = [None] * len(self._read)
            words = await gather(*(layout.read() for layout in layouts))
            for layout, part in zip(layouts, words, strict=True):
                for proxy, value in zip(layout.proxies, layout.row(part), strict=True):
                    row[self._places[proxy]] = value
        now = time.monotonic()
        for proxy, value in zip(self._read, row, strict=True):
            proxy.see(value, now)
        return Values(self._places, row)

    async def set(self, values: Mapping[Proxy[Any], Any] | Sequence[Any] | NDArray[Any]) -> None:
        """Write many signals, in one pipelined batch for each gateway.

        Args:
            values: values by their proxies, for some or all signals; or a value for each, in the group's order.

        Raises:
            ArgumentError: for a value that its signal cannot have, or a signal of another group; nothing was sent.
            GatewayError: the first error. The other writes are executed all the same.
        """
        await write_values(self._by_proxy(values))

    @returns_coroutine
    def post(self, values: Mapping[Proxy[Any], Any] | Sequence[Any] | NDArray[Any]) -> Coroutine[Any, Any, None]:
        """Write many signals without waiting for the execution.

        Errors are raised by the next `fence` of the calling task, on the link of the signal.

        Fields and values of several words need an answer: they are written as by `set`.

        Raises:
            ArgumentError: as by `set`.
        """
        return self._post(caller_on(self.proxies[0].link), values)

    async def _post(self, poster: object, values: Mapping[Proxy[Any], Any] | Sequence[Any] | NDArray[Any]) -> None:
        await write_values(self._by_proxy(values), posted_by=poster)

    def _by_proxy(self, values: Mapping[Proxy[Any], Any] | Sequence[Any] | NDArray[Any]) -> Mapping[Proxy[Any], Any]:
        if not isinstance(values, Mapping):
            several: object = values.tolist() if isinstance(values, np.ndarray) else values
            if not isinstance(several, Iterable):
                raise ArgumentError(f"{self.name} takes values in order or by their signals, not {values!r:.80}")
            given = list(several)
            if len(given) != len(self.proxies):
                raise ArgumentError(f"{self.name} has {len(self.proxies)} signals, and {len(given)} values were given")
            return dict(zip(self.proxies, given, strict=True))
        for proxy in values:
            if proxy not in self._members:
                raise ArgumentError(f"{getattr(proxy, 'path', repr(proxy))} is not in {self.name}")
        return values

    # Samples

    def subscribe(  # noqa: PLR0913  (as those of a link)
        self,
        *,
        rate_hz: float | None = None,
        divisor: int | None = None,
        trigger: bool = False,
        on_change: bool = False,
        immediate: bool = False,
        timestamps: bool | None = None,
        buffer: int = BUFFER,
        latest: bool = False,
        overflow: Overflow = "drop_oldest",
    ) -> GroupSubscription:
        """Subscribe to all signals, sampled by the gateway if it has groups, otherwise by reads of the host.

        Without a rate, a divisor or a trigger, the spec's declaration of the group determines the sampling. The
        arguments are those of `unity_link.Link.subscribe`. A host that reads by itself reads when the next sample is
        requested; its samples are late if it is busy, and have no timestamps.

        Raises:
            ArgumentError: if no rate, divisor or trigger is known; and as `unity_link.Link.subscribe`.
            UnsupportedError: as `unity_link.Link.subscribe`.
        """
        given = Plan(
            rate_hz=rate_hz,
            divisor=divisor,
            trigger=trigger,
            on_change=on_change,
            immediate=immediate,
            timestamps=timestamps,
        )
        if not given.is_known():
            default = self._default_plan()
            given = msgspec.structs.replace(
                default,
                on_change=on_change or default.on_change,
                immediate=immediate or default.immediate,
                timestamps=default.timestamps if timestamps is None else timestamps,
            )
        size = check_buffer(1 if latest else buffer, overflow)
        sources = [(one, _source(one, given, size, overflow, self._called(), latest=latest)) for one in self._lay_out()]
        return GroupSubscription(sources)

    @property
    def feed(self) -> Feed:
        """The samples of the group, shared by all its loops and callbacks."""
        if self._feed is None:
            self._feed = Feed(self.name, self.subscribe)
        return self._feed

    def __aiter__(self) -> AsyncIterator[GroupSample]:
        """Iterate over the samples; see `samples`."""
        return self.samples()

    async def samples(self, *, buffer: int = BUFFER, overflow: Overflow = "fail") -> AsyncIterator[GroupSample]:
        """Iterate over the samples of the group. Several loops and callbacks share them.

        Args:
            buffer: most samples that wait for the loop's body.
            overflow: what to do with more samples: ``"fail"`` or ``"drop_oldest"``.

        Raises:
            ArgumentError: if no rate, divisor or trigger is known.
            SamplesLostError: if the loop's body is too slow.
            GatewayError: if a gateway refused a polled read, or one behind a server is away at the beginning. A new
                loop begins again.
            LinkLostError: if a link ends.
        """
        self._default_plan()
        with self.feed.listen(buffer=check_buffer(buffer, overflow), overflow=overflow) as listener:
            while True:
                for sample in await listener.next():
                    yield sample

    def on_sample(self, callback: Callable[[GroupSample], object]) -> Registration:
        """Call a function with each sample, until `Registration.cancel`. An event loop must be running.

        Exceptions of the callback are logged under ``unity_link.link``, the first one of each type. The loss of a
        link is logged, too. If a gateway refuses a read of a polled group, or one behind a server is away at the
        beginning, the error is logged and the group tries again.

        Raises:
            ArgumentError: for an asynchronous function.
        """
        made = Callback(callback, f"a callback for samples of {self.name}")

        def call_each(batch: Batch) -> None:
            for sample in batch:
                made(sample)

        return self._register(made, call_each)

    def on_batch(self, callback: Callable[[Batch], object]) -> Registration:
        """Call a function with all samples that arrived together: `on_sample` for many samples per second."""
        made = Callback(callback, f"a callback for batches of {self.name}")
        return self._register(made, made)

    # Internals

    def _register(self, made: Callback[Any], listen: Callable[[Batch], object]) -> Registration:
        self._default_plan()
        return Registration(made.cancel, self.feed.listen(listen).leave)

    def _lay_out(self) -> list[GroupLayout]:
        if self._layouts is None:
            by_link: dict[Link, list[Proxy[Any]]] = {}
            if not self._read:
                raise ArgumentError(f"{self.name}: it has no signals that can be read together")
            for proxy in self._read:
                by_link.setdefault(proxy.link, []).append(proxy)
            self._layouts = [GroupLayout(proxies) for proxies in by_link.values()]
        return self._layouts

    def _default_plan(self) -> Plan:
        if self._plan.is_known():
            return self._plan
        plans = {Plan.of(proxy) for proxy in self._read}
        if self.model is None and len(plans) == 1 and (plan := plans.pop()) is not None:
            return plan
        raise nothing_publishes(self._read or self.proxies)


def _host_rate(rate_hz: float, name: str) -> float:
    """Return a rate that a program asks for, in Hz, as a float.

    Raises:
        ArgumentError: if `rate_hz` is no number, or outside of `RATE`.
    """
    what = f"{name}: a rate is a number of Hz above 0"
    rate = real_number(rate_hz, what)
    if not RATE[0] <= rate <= RATE[1]:
        raise ArgumentError(f"{what}, {RATE[0]:g} to {RATE[1]:g}, not {shown(rate_hz)}")
    return rate


def _readable(members: Sequence[Proxy[Any] | Part]) -> tuple[Proxy[Any], ...]:
    """Return the signals named themselves, and those of components that can be read together."""
    return tuple(
        proxy
        for member in members
        for proxy in ((member,) if isinstance(member, Proxy) else member.signals)
        if proxy is member or (proxy.signal.access.reads and not proxy.signal.read_takes)
    )


def _source(
    layout: GroupLayout, plan: Plan, buffer: int, overflow: Overflow, name: str, *, latest: bool
) -> SampleSource:
    """Return the source of samples of one gateway: a subscription, or reads by the host."""
    info = layout.link.gateway
    layout.check_sampled()
    if not plan.trigger or plan.divisor is not None or plan.rate_hz is not None or plan.on_change:
        # A sample takes a word from each queue, and only a trigger of the queue ensures that one is available.
        layout.check_registers()
    if plan.polled or Feature.GROUPS not in info.features:
        if plan.trigger:
            raise UnsupportedError("the gateway was built without groups, and a host cannot see their triggers")
        turns = asked_rate(plan.rate_hz, plan.divisor, info.base_frequency_hz)
        return Poll(layout, turns, on_change=plan.on_change, overflow=overflow)
    if plan.nearest and plan.rate_hz is not None:
        _check_reach(plan.rate_hz, info.base_frequency_hz, name)
    immediate = plan.immediate and (not plan.nearest or Feature.SEND_IMMEDIATE in info.features)
    return layout.link.subscribe(
        layout.addresses,
        rate_hz=plan.rate_hz,
        divisor=plan.divisor,
        trigger=plan.trigger,
        on_change=plan.on_change,
        immediate=immediate,
        timestamps=plan.timestamps,
        group=plan.group,
        buffer=buffer,
        latest=latest,
        overflow=overflow,
    )


def _check_reach(rate_hz: float, base_hz: float, name: str) -> None:
    """Raise `ArgumentError` if a gateway has no rate near that of a group: its design may differ from the spec's."""
    lowest = base_hz / LARGEST_DIVISOR
    if not lowest <= rate_hz <= base_hz:
        expected = f"this gateway has {lowest:.3g} to {base_hz:g} Hz"
        raise ArgumentError(f"{name} has a rate of {rate_hz:g} Hz, and {expected}: subscribe with another rate_hz")
