"""The sources of `watch`: the words at addresses, or the signals of a spec."""

from __future__ import annotations

from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, Any, Protocol

from unity_link.cli.signals import choose, plain, text
from unity_link.protocol.wire.numbers import Format, address_text, in_form, to_signed

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Sequence
    from contextlib import AbstractAsyncContextManager

    from unity_link.data.batch import GroupSample
    from unity_link.data.groups import Group
    from unity_link.data.loading import LoadedRobot
    from unity_link.data.sampling import GroupSubscription
    from unity_link.link.link import Link
    from unity_link.link.publishing import Sample
    from unity_link.link.subscription import Subscription

    Stream = Subscription | GroupSubscription
    Taken = Sample | GroupSample


class Watched(Protocol):
    """A source of samples and the texts for them. `names` is valid after `subscribe` was called."""

    heading: str
    """Heading of the column of names."""
    names: Sequence[str]

    def subscribe(self, link: Link, rate_hz: float) -> AbstractAsyncContextManager[Stream]:
        """Return the subscription to the samples, as a context manager."""

    def values(self, sample: Any) -> Sequence[Any]:
        """Return the values of a sample, one for each name."""

    def plain(self, value: Any) -> Any:
        """Return a value for JSON."""

    def number(self, value: Any) -> float:
        """Return the number that a curve shows for a value."""

    def text(self, value: Any) -> str:
        """Format a value, or a number in its unit, for display."""


class Words:
    """Words at addresses.

    Args:
        addresses: addresses of the words.
        form: format of the words.
    """

    heading = "address"

    def __init__(self, addresses: list[int], form: Format) -> None:
        self.names: Sequence[str] = ()
        self._addresses = addresses
        self._form = form
        self._bits = 0

    def subscribe(self, link: Link, rate_hz: float) -> Subscription:
        """Return the subscription to the words."""
        self._bits = link.gateway.data_bits
        samples = link.subscribe(self._addresses, rate_hz=rate_hz)
        self.names = [address_text(address, link.gateway) for address in samples.schedule.addresses]
        return samples

    def values(self, sample: Sample) -> list[int]:
        """Return the words of a sample as numbers, signed for the format `signed`."""
        words: list[int] = sample.values.tolist()
        return [to_signed(word, self._bits) for word in words] if self._form is Format.SIGNED else words

    def plain(self, value: int) -> int:
        """Return a number unchanged."""
        return value

    number = plain

    def text(self, value: float) -> str:
        """Format a number."""
        return in_form(int(value) & (1 << self._bits) - 1, self._bits, self._form)


class WatchedSignals:
    """Signals of a robot.

    Args:
        robot_type: class of the robot.
        chosen: paths, parts and patterns of signals.
    """

    heading = "signal"

    def __init__(self, robot_type: type[LoadedRobot], chosen: list[str]) -> None:
        self.names: Sequence[str] = choose(robot_type, chosen, "read")
        self._robot_type = robot_type
        self._group: Group

    @asynccontextmanager
    async def subscribe(self, link: Link, rate_hz: float) -> AsyncIterator[GroupSubscription]:
        """Yield the subscription to the signals.

        Raises:
            SpecMismatchError: if the gateway was generated from another spec.
        """
        from unity_link.data.describing import robot_behind
        from unity_link.data.groups import Group

        robot = await robot_behind(link, self._robot_type)
        self._group = Group(*(robot[path] for path in self.names))
        async with self._group.subscribe(rate_hz=rate_hz) as samples:
            yield samples

    def values(self, sample: GroupSample) -> list[Any]:
        """Return the values of a sample in their units."""
        return [sample.values[proxy] for proxy in self._group.proxies]

    def plain(self, value: Any) -> Any:
        """Return a value for JSON."""
        return plain(value)

    def number(self, value: Any) -> float:
        """Return a value as a number."""
        return value if isinstance(value, float) else int(value)

    def text(self, value: Any) -> str:
        """Format a value."""
        return text(value)
